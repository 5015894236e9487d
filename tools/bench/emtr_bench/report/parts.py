"""The parts of the page: each is a command that writes one JSON."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

THREADS = "2"
UNRELATED = "200"  # pairings of scans that do not belong together
NAMES = (
    "accuracy", "calibration", "ablation", "peers", "stages", "scaling", "neighbors", "regress",
)  # fmt: skip


@dataclass(frozen=True)
class Part:
    """A run of one benchmark. Paths are relative to the repository wherever they lie in it."""

    name: str  # of the JSON
    section: str  # one of NAMES
    command: tuple[str, ...]
    json: Path

    @property
    def program(self) -> str:
        return self.command[0]

    @property
    def line(self) -> str:
        """As one types it, in the repository."""
        return " ".join(self.command)


def _accuracy(preset: str) -> dict[str, tuple[str, ...]]:
    """Returns the parts that measure a preset, by name."""
    if preset == "thorough":  # which searches twice on every pair
        return {"all": ("--tier", "all", "--transforms", "1")}
    many = "20" if preset == "default" else "4"  # motions; the paper has 20
    runs = {
        "paper": ("--tier", "paper", "--transforms", "20"),
        # Scans that do not belong together say how far the confidence can be believed.
        "all": ("--tier", "all", "--transforms", many, "--unrelated", UNRELATED),
    }
    if preset == "default":
        hard = ("--tier", "low-overlap", "extreme", "--transforms", "4")
        runs["viewpoints"] = (*hard, "--viewpoints")
    return runs


def all_parts(
    folder: Path, pictures: Path, presets: list[str], smoke: bool, sweep: bool = False
) -> list[Part]:
    """`folder` takes the JSON, `pictures` the pictures; `sweep` is that of the other libraries."""

    def part(section: str, *options: str, name: str = "", output: str = "--json={}") -> Part:
        path = folder / f"{name or section}.json"
        command = [f"tools/bench/{section}", *options, *output.format(path).split()]
        return Part(name or section, section, tuple(command), path)

    def pick(full: tuple[str, ...], short: tuple[str, ...]) -> tuple[str, ...]:
        return short if smoke else full

    parts = []
    for preset in presets:
        for name, chosen in _accuracy(preset).items():
            options = (*chosen, "--threads", THREADS)
            parts.append(part("accuracy", "--preset", preset, *pick(options, ("--smoke",)),
                              name=f"accuracy-{preset}-{name}"))  # fmt: skip
        if smoke:
            del parts[1:]
            break
    peers = ("--tier", "all", "--transforms", "1", "--threads", THREADS)
    swept = ("--sweep", f"--plot={pictures / 'peers.png'}")
    counted = "--benchmark_out={} --benchmark_out_format=json"
    judged = [str(p.json) for p in parts if smoke or p.name.endswith("-all")]
    return [
        *parts,
        part("calibration", *judged, f"--plot={pictures / 'calibration.png'}"),
        part("ablation", "--threads", THREADS, *pick((), ("--smoke",))),
        part("peers", *pick(peers, ("--smoke",)), *(swept if sweep else ())),
        part("stages", *pick((), ("--smoke",))),
        part("scaling", *pick((), ("--smoke",)), f"--plot={pictures / 'scaling.png'}"),
        part("neighbors", *pick((), ("--smoke",)), output=counted),
        part("regress", *pick((), ("--only", "register-generic"))),
    ]
