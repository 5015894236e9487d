"""The sweep for people: each method twice, and the frontier."""

from __future__ import annotations

from collections.abc import Sequence

from .runs import PeerRun
from .settings import Setting
from .summary import names
from .sweep import Point, at_their_fastest, fastest, frontier, points
from .tables import number, tier_tables

_LINE = "{:<30}{:>16}{:>10}{:>9}{:>18}{:>10}{:>9}{:>9}"
FOOTER = (
    "Settings: points that voxels leave in both clouds together, for the search / the refinement; "
    "own: as its\nlibrary does by itself. The fastest setting is that of the least median time "
    "among those with no less success\nthan the recommended one has, tier by tier. It is chosen "
    "on these same runs, which favors the other libraries."
)


def sweep_tables(title: str, runs: Sequence[PeerRun], recommended: Setting) -> str:
    """Each method at both settings, the frontier, and the usual tables at the fastest ones."""
    found = points(runs)
    lines = [f"{title}: recommended settings, and the fastest that lose nothing",
             _LINE.format("method", "recommended", "success%", "seconds", "fastest", "success%",
                          "seconds", "ratio")]  # fmt: skip
    for method in names(runs):
        mine = [point for point in found if point.method == method]
        lines.append(_line(mine[0], fastest(mine, recommended)))
    lines += ["", "frontier, the fastest first: no other has more success in as little time"]
    lines += [f"  {point.label:<48}{point.success:>8.1f} %{number(point.seconds):>9} s"
              for point in frontier(found)]  # fmt: skip
    others = tier_tables(
        f"{title}, the others at their fastest", at_their_fastest(runs, recommended)
    )
    return "\n".join([*lines, "", others])


def _line(own: Point, best: Point) -> str:
    if own.setting is None:
        return _LINE.format(own.method, "", number(own.success, 1), number(own.seconds),
                            "", "", "", "").rstrip()  # fmt: skip
    assert best.setting is not None
    return _LINE.format(
        own.method, own.setting.name, number(own.success, 1), number(own.seconds),
        best.setting.name, number(best.success, 1), number(best.seconds),
        number(best.seconds / own.seconds, 2),
    )  # fmt: skip
