"""Small clouds of one bumpy surface, as arrays and files, and runs over them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

import pyemtr

SETTINGS: dict[str, Any] = {"preset": "fast", "iterations": 2, "population": 4}
CHANGING = ("seconds",)  # what two runs need not have in common


def surface(seed: int, count: int = 300) -> np.ndarray:
    """Points (count, 3) float64 of a part of the surface, in axes of their own."""
    rng = np.random.default_rng(seed)
    x, y = rng.uniform(-1, 1, (2, count))
    z = 0.35 * np.sin(3 * x + 1) * np.cos(2.5 * y) + 0.25 * np.exp(-8 * ((x - 0.4) ** 2 + y**2))
    rotation = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    return np.column_stack([x, y, z]) @ rotation


def write_clouds(folder: Path, count: int) -> list[str]:
    names = [f"c{i}.npy" for i in range(count)]
    for i, name in enumerate(names):
        np.save(folder / name, surface(i))
    return names


def write_table(folder: Path, rows: list[str], header: str = "source,target") -> Path:
    path = folder / "pairs.csv"
    path.write_text("\n".join([header, *rows]) + "\n")
    return path


def comparable(records: Any) -> dict[int, dict[str, Any]]:
    """Records by index, without what may differ; of a file or of a run."""
    if isinstance(records, Path):
        values = [json.loads(line) for line in records.read_text().splitlines()]
    else:
        values = [record.values for record in records]
    found = {one["index"]: {k: v for k, v in one.items() if k not in CHANGING} for one in values}
    assert len(found) == len(values), "two records of one pair"
    return found


def run(pairs: Any, executor: Any = None, **more: Any) -> pyemtr.PairRecords:
    return pyemtr.register_many(pairs, executor, **{**SETTINGS, **more})
