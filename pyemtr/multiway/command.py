"""The command pyemtr-align: a folder of scans in, a folder of poses out."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from .._emtr import version
from ..cloud_files import FORMATS
from ..options import presets
from .align import align_all
from .output import require_plyfile
from .result import MultiwayResult

_EPILOG = """Files of --out:
  poses/NAME.txt          the matrix of each scan that was placed, scan -> model, q = R p + t
  graph.g2o               the pose graph as g2o's text
  posegraph.json          the pose graph as Open3D's JSON
  fused.ply               the average of all points in each voxel, with normals and colors if given
  model.png               each scan in a color of its own (where matplotlib is installed)
  report.json             the verdict of each scan, and each edge with why it was taken or not
A second model has graph_1.g2o and so on. --html writes index.html, a page with each scan in a color
of its own and why each pair was taken or not, and pairs/, a page of each pair.

exit code: 0 when all scans are placed in one model; 3 when scans are left out or there are several
models; 2 for wrong usage or input, and nothing is written then; 130 on Ctrl-C."""


def main(words: Sequence[str] | None = None) -> int:
    """Does what the command line says; returns the exit code."""
    arguments = parser().parse_args(words)
    shown = _Progress(arguments.quiet)
    try:
        require_plyfile()
        out = Path(arguments.out)
        if out.exists() and (not out.is_dir() or any(out.iterdir())) and not arguments.force:
            raise ValueError(f"--out: {out}: it exists and is not empty; --force writes into it")
        given = arguments.scans
        result = align_all(
            given[0] if len(given) == 1 else given,
            seed=arguments.seed,
            threads=arguments.threads,
            preset=arguments.preset,
            joint_refinement=not arguments.no_joint_refinement,
            callback=shown,
        )
        shown.done()
        result.save(out, arguments.voxel)
        if arguments.html is not None:
            result.to_html(arguments.html, threads=arguments.threads)
    except KeyboardInterrupt:
        shown.done()
        return 130
    except (ImportError, OSError, TypeError, ValueError) as error:
        shown.done()
        print(f"pyemtr-align: {error}", file=sys.stderr)
        return 2
    print(summary(result))
    return 0 if len(result.models) == 1 and not result.left_out else 3


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="pyemtr-align",
        description="Aligns many scans of one thing, in any order and from any pose.",
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = made.add_argument
    add("scans", nargs="+", metavar="SCAN",
        help=f"a folder of scans ({' '.join(FORMATS)}), or two or more files")  # fmt: skip
    add("--out", required=True, metavar="DIR", help="folder to write to; it is made")
    add("--html", metavar="DIR", help="folder to write pages for a browser to; it is made")
    add("--force", action="store_true", help="write into a folder that is not empty")
    add("--preset", choices=[name for name in presets() if name != "paper"], default="default",
        help="of the registration of pairs (default: default)")  # fmt: skip
    add("--no-joint-refinement", action="store_true", help="leave the poses as the graph has them")
    add("--voxel", type=float, metavar="LENGTH",
        help="of the fused cloud, in the scans' unit (default: 0.005 radii)")  # fmt: skip
    add("--seed", type=int, default=0, metavar="N", help="(default: 0)")
    add("--threads", type=int, default=0, metavar="N",
        help="pairs at a time; 0: one for each processor (default: 0)")  # fmt: skip
    add("--quiet", action="store_true", help="show no progress")
    add("--version", action="version", version=f"pyemtr-align {version()}")
    return made


def summary(result: MultiwayResult) -> str:
    """Returns the lines that the command prints."""
    width = max(len(scan.name) for scan in result.scans)
    lines = []
    for scan in result.scans:
        where = f"model {scan.model}" if scan.placed else "left out"
        lines.append(f"{scan.name:<{width}}  {where}  {scan.text}")
    taken = sum(edge.taken for edge in result.edges)
    lines.append(
        f"{len(result.placed)} of {len(result.scans)} scans placed in {len(result.models)}"
        f" model{'' if len(result.models) == 1 else 's'}, {taken} of {len(result.edges)} pairs"
        f" taken, {result.seconds:.1f} s"
    )
    return "\n".join(lines)


class _Progress:
    """One line on the terminal that is written over."""

    def __init__(self, quiet: bool) -> None:
        self._shown = not quiet and sys.stderr.isatty()
        self._width = 0

    def __call__(self, stage: str, done: int, count: int) -> Any:
        if self._shown:
            text = f"{stage}: {done} of {count}"
            print(f"\r{text:<{self._width}}", end="", file=sys.stderr, flush=True)
            self._width = len(text)

    def done(self) -> None:
        if self._shown and self._width:
            print(f"\r{'':<{self._width}}\r", end="", file=sys.stderr, flush=True)
            self._width = 0
