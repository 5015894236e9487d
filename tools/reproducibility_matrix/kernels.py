"""The instruction sets of the inner loops that this machine can run."""

from __future__ import annotations

from pathlib import Path

NEEDED = {
    "generic": (),
    "avx2": ("avx2",),
    "avx512": ("avx512f", "avx512vl", "avx512bw", "avx512dq"),
}


def split() -> tuple[list[str], list[str]]:
    """Returns those that this machine can run, and those that it cannot."""
    flags: set[str] = set()
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("flags"):
            flags = set(line.split())
            break
    runs = [name for name, needed in NEEDED.items() if flags.issuperset(needed)]
    return runs, [name for name in NEEDED if name not in runs]
