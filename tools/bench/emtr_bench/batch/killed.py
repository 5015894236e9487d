"""Runs that are killed and taken up again end as one that was left alone."""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import pyemtr

from .executors import cluster
from .speed import SETTINGS

_CALL = (
    "import sys; sys.path = [p for p in sys.path if p]; import pyemtr;"  # not that of the folder
    " pyemtr.register_many(sys.argv[1], out=sys.argv[2], workers=2, preset='fast')"
)


def kill_runs(path: Path, pairs: int, kills: int, seed: int, command: Path | None) -> bool:
    """Kills runs of Python and of the command; True when all is well."""
    ways = {"python": [sys.executable, "-c", _CALL, str(path)]}
    if command is not None:
        ways["command"] = [str(command), "-q", "--workers", "2", "--preset", "fast",
                           "--batch", str(path), "--out"]  # fmt: skip
    well = True
    for name, words in ways.items():
        folder = path.parent / f"killed_{name}"
        whole, out = folder / "whole", folder / "out"
        _run([*words, str(whole)])
        chance = random.Random(seed)
        least = sorted(chance.sample(range(1, pairs), kills))
        done = [_kill([*words, str(out)], out, count, chance) for count in least]
        torn = sum(1 for _, is_torn in done if is_torn)
        _run([*words, str(out)])
        well &= _report(
            f"{name}: {pairs} pairs, killed {kills} times with {done[0][0]} to {done[-1][0]}"
            f" records, {torn} of them torn" if done else name,
            records(whole), records(out), pairs)  # fmt: skip
    return well


def kill_workers(path: Path, pairs: int, kills: int, seed: int) -> bool:
    """Kills workers of a Dask cluster in the middle of a run; True when all is well."""
    folder = path.parent / "killed_workers"
    pyemtr.register_many(path, out=folder / "whole", **SETTINGS)
    chance = random.Random(seed)
    least = sorted(chance.sample(range(1, pairs), kills))
    file = folder / "out" / "results.jsonl"
    killed: list[int] = []
    with cluster(2) as client:

        def kill() -> None:
            for count in least:
                while _lines(file) < count:
                    time.sleep(0.002)
                workers = list(client.run(os.getpid).values()) or [0]
                victim = chance.choice(workers)
                if victim:
                    os.kill(victim, signal.SIGKILL)
                    killed.append(victim)

        killer = threading.Thread(target=kill, daemon=True)
        killer.start()
        pyemtr.register_many(path, client, out=folder / "out", **SETTINGS)
        killer.join(60)
    return _report(
        f"dask: {pairs} pairs on 2 workers, {len(killed)} workers killed",
        records(folder / "whole"),
        records(folder / "out"),
        pairs,
    )


def records(folder: Path) -> list[dict[str, Any]]:
    """All records of a folder by their index, without what two runs need not have in common."""
    found = [json.loads(line) for line in (folder / "results.jsonl").read_text().splitlines()]
    for record in found:
        record.pop("seconds", None)
    return sorted(found, key=lambda record: int(record["index"]))


def _report(what: str, whole: list[Any], found: list[Any], pairs: int) -> bool:
    twice = len(found) - len({record["index"] for record in found})
    different = sum(a != b for a, b in zip(whole, found))
    well = len(found) == len(whole) == pairs and not twice and not different
    print(f"{what}: {len(found)} records, {twice} twice, {different} unlike an undisturbed run")
    return well


def _run(words: list[str]) -> None:
    done = subprocess.run(words, check=False)
    if done.returncode not in (0, 3):  # 3: the command had a pair that is not registered
        raise AssertionError(f"{words}: ended with {done.returncode}")


def _kill(words: list[str], out: Path, least: int, chance: random.Random) -> tuple[int, bool]:
    """Starts a run and kills it a moment after it has so many records. Returns how many it had,
    and whether the last was torn."""
    file = out / "results.jsonl"
    process = subprocess.Popen(words)
    while _lines(file) < least:
        if process.poll() is not None:
            raise AssertionError(f"{words}: ended with {process.returncode} before it was killed")
        time.sleep(0.001)
    time.sleep(chance.uniform(0.0, 0.02))
    process.send_signal(signal.SIGKILL)
    process.wait()
    data = file.read_bytes()
    return data.count(b"\n"), not data.endswith(b"\n")


def _lines(file: Path) -> int:
    return file.read_bytes().count(b"\n") if file.is_file() else 0
