"""The published figures of EMTR-SSC that ours are put beside.

Wu et al., "Evolutionary Multitasking with Solution Space Cutting for Point Cloud
Registration", IEEE TETCI 2023. Errors are means and standard deviations over successes.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

MEAN_SUCCESS = 87.7  # percent, over all rows
LOWEST_SUCCESS = 75.0  # percent, of any row
MEAN_SECONDS = 7.39  # a registration, 15.58 without sparse-to-dense
RATIO_RANGE = (0.47, 0.52)  # queries with sparse-to-dense / without: 48.4 to 51.5 % published


class Spread(NamedTuple):
    mean: float
    std: float


@dataclass(frozen=True)
class PaperRow:
    rotation: Spread  # E_R, degrees
    translation: Spread  # E_t x 100, normalized frame
    queries: float  # millions
    queries_dense: float  # millions, without sparse-to-dense


def _row(
    rotation: tuple[float, float],
    translation: tuple[float, float],
    queries: float,
    queries_dense: float,
) -> PaperRow:
    return PaperRow(Spread(*rotation), Spread(*translation), queries, queries_dense)


ROWS = {
    "Armadillo": _row((0.161, 0.073), (0.084, 0.034), 9.86, 20.04),
    "Bunny": _row((0.233, 0.120), (0.175, 0.085), 8.42, 17.29),
    "Dragon": _row((0.190, 0.074), (0.168, 0.074), 8.75, 17.64),
    "Happy": _row((0.369, 0.195), (0.220, 0.087), 8.00, 16.32),
    "Chef": _row((0.379, 0.208), (0.197, 0.137), 8.70, 17.90),
    "Chicken": _row((0.262, 0.181), (0.266, 0.120), 7.83, 16.18),
    "P": _row((0.335, 0.186), (0.299, 0.148), 7.22, 14.82),
    "T-rex": _row((0.296, 0.165), (0.366, 0.176), 9.06, 18.26),
    "Angel": _row((0.178, 0.076), (0.277, 0.182), 11.41, 23.52),
    "Bimba": _row((0.417, 0.237), (0.419, 0.146), 9.57, 19.51),
    "CD": _row((0.258, 0.123), (0.251, 0.149), 8.41, 17.36),
    "DC": _row((0.199, 0.108), (0.265, 0.267), 8.26, 16.69),
    "7a": _row((0.147, 0.063), (0.051, 0.029), 11.30, 22.11),
}  # fmt: skip


def row_of(manifest_name: str) -> PaperRow | None:
    """The row for a manifest's ``paper_row``; a stand-in ("7a (stand-in)") has its model's."""
    if not manifest_name:
        return None
    name = short_name(manifest_name)
    if name not in ROWS:
        raise KeyError(f"the paper has no row {name!r}; it has {', '.join(ROWS)}")
    return ROWS[name]


def short_name(manifest_name: str) -> str:
    return manifest_name.partition(" (")[0]
