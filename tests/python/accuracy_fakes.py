"""Fakes for the tests of the accuracy benchmark: a small data folder, and an engine that is exact.

Source and target of each pair hold the same points in the same order, so that the engine can
solve for the pose by least squares; a run whose seed is in `spoiled` is turned off the truth.
"""

import sys
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

sys.path.insert(0, str(Path(__file__).parents[2] / "tools" / "bench"))

from emtr_bench import accuracy, arguments
from emtr_bench.layout import write_ply
from emtr_bench.locations import REPOSITORY
from emtr_bench.runner import Options, Outcome

from pyemtr.alternative import Alternative

COLUMNS = "group,name,tier,paper_row,n_source,n_target"
ROWS = (
    ("objects", "duck", "standard", "", 60),
    ("objects", "hare", "paper", "Bunny", 50),
    ("rooms", "hall", "paper", "7a (stand-in)", 40),
)
SPARSE, DENSE = 12, (30, 50)


def write_data(folder):
    """A manifest of three pairs and their files, float32 like the real ones."""
    lines = [COLUMNS]
    for number, (group, name, tier, row, count) in enumerate(ROWS):
        lines.append(f"{group},{name},{tier},{row},{count},{count}")
        place = folder / "pairs" / group / name
        place.mkdir(parents=True)
        rng = np.random.default_rng(number)
        source = rng.normal(size=(count, 3)) * [3.0, 2.0, 1.0] + [100.0, -50.0, 10.0]
        T_gt = np.eye(4)
        T_gt[:3, :3] = Rotation.random(random_state=number).as_matrix()
        T_gt[:3, 3] = [5.0, 6.0, 7.0]
        write_ply(place / "source.ply", source)
        write_ply(place / "target.ply", source @ T_gt[:3, :3].T + T_gt[:3, 3])
        np.savetxt(place / "T_gt.txt", T_gt, fmt="%.10g")
    (folder / "MANIFEST.csv").write_text("\n".join(lines) + "\n")
    return folder


def run_accuracy(words, engine):
    """The benchmark as its command runs it; the exit code."""
    return accuracy.accuracy(arguments.parser().parse_args(words), engine)


def least_squares_pose(source, target):
    """The rigid transformation (4, 4) of corresponding points."""
    a, b = source.mean(axis=0), target.mean(axis=0)
    rotation, _ = Rotation.align_vectors(target - b, source - a)
    T = np.eye(4)
    T[:3, :3] = rotation.as_matrix()
    T[:3, 3] = b - T[:3, :3] @ a
    return T


def spoil(T, center, degrees, translation):
    """T followed by a rotation about the moved center and a translation."""
    rotation = np.eye(4)
    rotation[:3, :3] = Rotation.from_euler("Y", degrees, degrees=True).as_matrix()
    moved = T[:3, :3] @ center + T[:3, 3]
    rotation[:3, 3] = moved - rotation[:3, :3] @ moved + [0.0, 0.0, translation]
    return rotation @ T


@dataclass(frozen=True)
class FakeEngine:
    """Knows two presets and the settings of the budget."""

    version: str = "0.0.fake"
    spoiled: dict = field(default_factory=dict)  # seed: (degrees, translation in the cloud's unit)
    sure: tuple = ()  # seeds of spoiled runs that it calls registered all the same
    aware: tuple = ()  # seeds of spoiled runs that have the truth as second alternative
    crashing: tuple = ()  # seeds
    miscounts: int = 0  # queries too many

    def check(self, options: Options):
        if options.preset not in ("default", "paper"):
            raise ValueError(f"there is no preset {options.preset!r}")

    def register(self, source, target, options: Options, sensors=None) -> Outcome:
        if options.seed in self.crashing:
            raise RuntimeError(f"seed {options.seed} is not to my taste")
        shared = min(len(source), len(target))  # unrelated clouds have not as many points
        T = truth = least_squares_pose(source[:shared], target[:shared])
        registered = True
        if options.seed in self.spoiled:
            T = spoil(T, source.mean(axis=0), *self.spoiled[options.seed])
            registered = options.seed in self.sure
        settings = {"population": 50, "iterations": 100, "switch_fraction": 0.6,
                    "sparse_to_dense": True, **options.settings}  # fmt: skip
        first = 60 if settings["sparse_to_dense"] else 0
        evaluation = 50 * (first * SPARSE + (100 - first) * sum(DENSE)) + self.miscounts
        return Outcome(
            T,
            registered,
            "registered" if registered else "ambiguous",
            {"fitness": 0.25, "inlier_ratio_source": 0.9, "inlier_ratio_target": 0.8,
             "inlier_rmse": float("nan"), "fitness_gap": 0.125, "score": 0.75,
             "surface_fit": 0.8, "violation": 0.002, "evidence": 300.0, "score_gap": 0.25,
             "confidence": float("nan") if options.preset == "paper" else
             0.75 if registered else 0.25},
            {"sparse_source": SPARSE, "dense_source": DENSE[0], "dense_target": DENSE[1]},
            {"evaluation": evaluation, "switch": 7, "complement": 9},
            {"total": 0.5},
            settings,
            [
                Alternative(pose, 0.5, 0.6, 0.01, 200.0)
                for pose in [spoil(truth, source.mean(axis=0), 120.0, 0.0)]
                + [truth] * (options.seed in self.aware)
            ],
        )  # fmt: skip

    def fitness(self, run, options: Options):
        return (0.1, 0.3) if run.index % 2 == 0 else (0.3, 0.1)


__all__ = ["DENSE", "REPOSITORY", "ROWS", "SPARSE", "FakeEngine", "Options", "write_data"]
