"""Which runs the reproduction is made of: sections, and the methods of each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from evolving_methods.methods import CONTROLS, METHODS, Method

from ..pairs import Pair
from . import functions, modelnet, precision, public_methods

OURS = "EMTR-SSC"
DENSE_ONLY = "EMTR-SSC without sparse-to-dense"
NO_COMPLEMENT = "EMTR-SSC without complement"
NO_TRANSFER = "EMTR-SSC without transfer"
PYTHON, ADAPTIVE = "EMTR-SSC in Python", "EMTR-SSC in Python, adaptive"
DEFAULT, FAST = "emtr default", "emtr fast"

#: Methods of section `library`: preset and settings.
LIBRARY: dict[str, tuple[str, dict[str, Any]]] = {
    OURS: ("paper", {}),
    DENSE_ONLY: ("paper", {"sparse_to_dense": False}),
    NO_COMPLEMENT: ("paper", {"complement": False}),
    NO_TRANSFER: ("paper", {"transfer": False}),
    DEFAULT: ("default", {}),
    FAST: ("fast", {}),
}
RATES = tuple(round(0.1 * i, 1) for i in range(11))  # rmp
SWITCHES = tuple(round(0.1 * i, 1) for i in range(10))  # delta
#: Sections whose runs are long have the first motions of each pair only, one of each kind.
MOST_MOTIONS = {"precision": 5, "traditional": 5}
SWEEP_ROW = "Bunny"  # that the paper varies rmp and delta on


@dataclass(frozen=True)
class Work:
    """Runs on one pair and motion, which share what was computed of them."""

    pair: Pair
    index: int
    runs: tuple[tuple[str, str], ...]  # section and method

    def without(self, done: Sequence[tuple[str, str]]) -> Work:
        return Work(self.pair, self.index, tuple(run for run in self.runs if run not in done))


@dataclass(frozen=True)
class Context:
    """What all runs share; sent to the processes that run them."""

    seed: int = 0
    threads: int = 1
    user_methods: tuple[Method, ...] = ()

    @property
    def methods(self) -> dict[str, Method]:
        """Those that can be run here."""
        every = (*METHODS, *CONTROLS, *self.user_methods)
        return {method.name: method for method in every if not method.missing}


def rate_name(value: float) -> str:
    return f"rmp {value:.1f}"


def switch_name(value: float) -> str:
    return f"delta {value:.1f}"


def is_swept(pair: Pair, pairs: Sequence[Pair]) -> bool:
    """The pair of the paper's sweep, or the first where there is none."""
    rows = [p for p in pairs if p.paper_row == SWEEP_ROW]
    return pair == (rows or pairs)[0]


def runs_of(
    sections: Sequence[str], pair: Pair, index: int, pairs: Sequence[Pair], context: Context,
    names: dict[str, Sequence[str]],
) -> list[tuple[str, str]]:  # fmt: skip
    """The runs of one pair and motion. `names` are the methods of the sections that know theirs."""
    known: dict[str, Sequence[str]] = {
        "library": list(LIBRARY),
        "evolving": list(context.methods),
        "evaluations": [method.name for method in METHODS],
        "tasks": [PYTHON, ADAPTIVE],
        "precision": precision.METHODS,
        "sweep": [rate_name(v) for v in RATES] + [switch_name(v) for v in SWITCHES],
        **names,
    }
    found = []
    for section in sections:
        if section == "sweep" and not is_swept(pair, pairs):
            continue
        if index >= MOST_MOTIONS.get(section, index + 1):
            continue
        found += [(section, name) for name in known.get(section, ())]
    return found


def shape_works(folder: Path | None, most: int, presets: Sequence[str]) -> list[Work]:
    """The runs on shapes of ModelNet40, or on made ones. Raises DataError."""
    runs = tuple(("modelnet", f"{preset}, {kind}")
                 for preset in presets for kind in (modelnet.CLEAN, modelnet.NOISY))  # fmt: skip
    return [
        Work(Pair(Path(shape).stem, "modelnet", Path(shape)), 0, runs)
        for shape in modelnet.shapes(folder, most)
    ]


def function_works(context: Context, seeds: int) -> list[Work]:
    """The runs on functions with known optima; a pair of tasks is no pair of clouds, but has its
    place in the log."""
    users = {method.name for method in context.user_methods}
    ours = [name for name in context.methods if name not in users]
    public = list(public_methods.CLASSES) if public_methods.there() else []
    found = []
    for name in functions.NAMES:
        methods = ours + (public if name in public_methods.FUNCTIONS else [])
        runs = tuple(("functions", method) for method in methods)
        found += [Work(Pair(name, "functions", Path()), seed, runs) for seed in range(seeds)]
    return found
