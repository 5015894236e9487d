"""Two counts beside each other, and which functions made the difference."""

from __future__ import annotations

from dataclasses import dataclass

from .counting import Count

MOST_FUNCTIONS = 8  # named a program
LEAST_CHANGE = 0.001  # of the program, for a function to be named


@dataclass(frozen=True)
class Comparison:
    program: str
    before: Count
    after: Count

    @property
    def change(self) -> float:
        """0.02: 2 % more instructions than before."""
        return self.after.instructions / self.before.instructions - 1.0

    def functions(self) -> list[tuple[str, int, int]]:
        """Name, instructions before and after of those that changed most, the most first."""
        before, after = self.before.functions, self.after.functions
        changed = [(n, before.get(n, 0), after.get(n, 0)) for n in dict.fromkeys([*before, *after])]
        least = LEAST_CHANGE * self.before.instructions
        changed = [entry for entry in changed if abs(entry[2] - entry[1]) >= least]
        return sorted(changed, key=lambda e: -abs(e[2] - e[1]))[:MOST_FUNCTIONS]

    def text(self) -> str:
        lines = [
            f"{self.program}: {millions(self.before.instructions)} -> "
            f"{millions(self.after.instructions)} million instructions, {100 * self.change:+.2f} %"
        ]
        for name, before, after in self.functions():
            share = 100.0 * (after - before) / self.before.instructions
            lines.append(
                f"    {name:<60} {millions(before):>9} -> {millions(after):>9}  {share:+6.2f} % "
                "of the program"
            )
        return "\n".join(lines)


def millions(instructions: int) -> str:
    return f"{instructions / 1e6:.1f}"
