"""How fine the other libraries' clouds are: what they recommend, or another setting."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True)
class Setting:
    """How many points voxels leave in both clouds together: for the search, and for the refinement,
    where None is what its library does by itself (the full clouds, or a voxel of its own)."""

    search_points: int
    refine_points: int | None = None

    @property
    def name(self) -> str:
        """``6000 / own``, or ``6000 / 12000``."""
        return f"{self.search_points} / {self.refine_points or 'own'}"


def grid(
    recommended: Setting, search_points: Iterable[int], refine_points: Iterable[int]
) -> list[Setting]:
    """The recommended setting, and each of the others once; 0 points are None."""
    crossed = [Setting(s, r or None) for s in search_points for r in refine_points]
    return list(dict.fromkeys([recommended, *crossed]))
