"""Runs what was asked for."""

from __future__ import annotations

import argparse
import json
import tempfile
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pyemtr

from ..locations import REPOSITORY
from ..whole_file import write_whole
from .clouds import write_pairs
from .killed import kill_runs, kill_workers
from .speed import compare, overhead


def measure(arguments: argparse.Namespace) -> int:
    found: dict[str, Any] = {}
    well = True
    pairs = arguments.pairs
    kinds = [kind for kind in arguments.kinds if kind != "dask" or _has_dask()]
    with tempfile.TemporaryDirectory(prefix="emtr_batch_") as name:
        path = write_pairs(Path(name), pairs, arguments.points)
        print(
            f"{pairs} pairs of {arguments.points} points, preset fast, {pyemtr.kernel_name()},"
            " one thread a registration\n"
        )
        if not arguments.kill and not arguments.kill_workers:
            found["pairs_per_second"] = compare(
                path, pairs, kinds, arguments.workers, arguments.rounds
            )
            found["overhead"] = overhead(path, pairs, kinds, arguments.rounds)
        kills = arguments.kill or int(arguments.smoke)
        if kills:
            well &= kill_runs(path, pairs, kills, arguments.seed, _command(arguments.command))
        if arguments.kill_workers and _has_dask():
            well &= kill_workers(path, pairs, arguments.kill_workers, arguments.seed)
    if arguments.json:
        write_whole(arguments.json, json.dumps({"well": well, **found}, indent=2) + "\n")
    return 0 if well else 1


def _command(given: Path | None) -> Path | None:
    if given is not None:
        return given
    built = REPOSITORY / "build" / "tools" / "pcl_emtr"
    if built.is_file():
        return built
    print(f"no {built}: only Python's runs are killed")
    return None


def _has_dask() -> bool:
    if find_spec("distributed") is not None:
        return True
    print("no Dask: pip install 'pyemtr[dask]' adds its rows")
    return False
