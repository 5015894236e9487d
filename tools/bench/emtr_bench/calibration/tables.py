"""The figures as text for the screen."""

from __future__ import annotations

import math

from .figures import Calibration, Share


def text(title: str, found: Calibration) -> str:
    lines = [
        f"{title}: {found.runs} runs, {found.unrelated} of them of scans that do not "
        f"belong together; {found.right} right",
        f"{'confidence':>14}{'runs':>7}{'mean':>8}{'right':>8}{'95 % interval':>17}",
    ]
    for row in found.bins:
        lines.append(
            f"{f'{row.low:.2f} to {row.high:.2f}':>14}{row.count:>7}{number(row.confidence):>8}"
            f"{number(row.right.value):>8}{interval(row.right):>17}"
        )
    lines += [
        f"expected calibration error {number(found.error)}, Brier score {number(found.brier, 4)}, "
        f"AUC {number(found.auc, 4)}",
        f"registered: precision {number(found.precision.value)} ({interval(found.precision)}), "
        f"recall {number(found.recall.value)} ({interval(found.recall)})",
    ]
    return "\n".join(lines)


def number(value: float, digits: int = 3) -> str:
    return "-" if math.isnan(value) else f"{value:.{digits}f}"


def interval(found: Share) -> str:
    return "-" if math.isnan(found.value) else f"{found.low:.3f} to {found.high:.3f}"
