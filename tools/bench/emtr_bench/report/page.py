"""The page: what it was measured on, then each section with its command."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

from .ablation_section import ablation_section
from .accuracy_section import accuracy_section
from .calibration_section import calibration_section
from .cost_sections import neighbors_section, regress_section, scaling_section, stages_section
from .markdown import table
from .parts import NAMES, Part
from .peers_section import peers_section
from .running import Kept, kept

_TITLES = {
    "accuracy": "Accuracy",
    "ablation": "Each part off in turn",
    "calibration": "How far the confidence can be believed",
    "peers": "Beside other libraries",
    "stages": "Stages, and the candidate grid",
    "scaling": "Time and memory against the number of points",
    "neighbors": "Nearest-neighbor queries",
    "regress": "Instructions",
}
_EXPLANATIONS = {
    "accuracy": "Success: E_R < 5 degrees, as in the paper; joint: E_t < 0.06 of the larger "
    "cloud's radius too. Errors are over the successes, E_R in degrees; precision and recall are "
    "those of `registered` against joint success. Seconds: mean wall time.",
    "ablation": "Joint success in percent by tier (pairs), and the median of the wall seconds. "
    "Lost and won: runs that are right with nothing off and wrong here, and the other way round; "
    "all rows have the same pairs, motions and seeds. "
    "Without seeds there is no second search either, which would make some: the swarms search.",
    "calibration": "Of the runs above that were made on all pairs, and of scans that do not belong "
    "together, which have no right pose. Right: joint success. The calibration error is the mean "
    "distance of mean confidence and share right, bin by bin; the Brier score the mean square of "
    "confidence less 1 or 0; the AUC the chance that a right run has more confidence than a wrong "
    "one. Precision and recall are those of `registered`. Intervals are Wilson's, of 95 %, and "
    "count the motions of one pair as independent, which they are not quite.",
    "peers": "Each method has the same pairs, motions and threads, in turns, in a process of its "
    "own. The other libraries' global searches are finished by point-to-plane ICP (Open3D) or "
    "GICP (small_gicp), with their recommended settings. Success: E_R < 5 degrees and E_t < 0.06; "
    "a lost run (crash, time limit, no pose) is a failure. A ratio below 1: emtr is the faster.",
}
#: What differs from part to part without making them incomparable.
_OF_THE_MOMENT = ("date", "revision", "load average")


def page(parts: list[Part], pictures: Path, out: Path) -> str:
    """The whole text. Parts without figures say so."""
    found = {part.name: kept(part) for part in parts}
    lines = [
        "# Benchmarks",
        "",
        "Made by `tools/bench/report`, from the JSON in `build/bench`.",
        "",
    ]
    lines += [_machines([k for k in found.values() if k is not None]), ""]

    def picture(name: str) -> str:
        return os.path.relpath((pictures / name).absolute(), out.absolute().parent)

    renderers: dict[str, Callable[[dict[str, Any]], str]] = {
        "accuracy": accuracy_section,
        "ablation": ablation_section,
        "calibration": lambda value: calibration_section(value, picture("calibration.png")),
        "peers": lambda value: peers_section(value, picture("peers.png")),
        "stages": stages_section,
        "scaling": lambda value: scaling_section(value, picture("scaling.png")),
        "neighbors": neighbors_section,
        "regress": regress_section,
    }
    for section in NAMES:
        lines += [f"## {_TITLES[section]}", ""]
        if section in _EXPLANATIONS:
            lines += [_EXPLANATIONS[section], ""]
        for part in (p for p in parts if p.section == section):
            figures = found[part.name]
            lines += [_how(part, figures), ""]
            if figures is not None and figures.value.get("generated_pairs"):
                lines += ["On the generated pairs, which are easier than real scans.", ""]
            if figures is not None:
                lines += [renderers[section](figures.value), ""]
    return "\n".join(lines).rstrip() + "\n"


def _machines(all_kept: list[Kept]) -> str:
    """One table when all was measured on one machine with the same tools, else several."""
    differ = {_lasting(k.machine) for k in all_kept}
    if not differ:
        return "Nothing has been measured."
    parts = sorted(table(["", "measured on"], [list(e) for e in known]) for known in differ)
    if len(parts) > 1:
        parts.insert(0, "**The parts were not all measured with the same machine and tools:**")
    return "\n\n".join(parts)


def _lasting(machine: dict[str, str]) -> tuple[tuple[str, str], ...]:
    return tuple(entry for entry in machine.items() if entry[0] not in _OF_THE_MOMENT)


def _how(part: Part, figures: Kept | None) -> str:
    if figures is None:
        return f"```text\n{part.line}\n```\n\nNot measured."
    moment = ", ".join(f"{name} {figures.machine[name]}" for name in _OF_THE_MOMENT)
    ended = "" if figures.status == 0 else f" **It ended with status {figures.status}.**"
    return f"```text\n{figures.command}\n```\n\n{moment}; took {figures.seconds:.0f} s.{ended}"
