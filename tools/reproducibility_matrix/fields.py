"""All that a registration gives but times and names, in one form for the four APIs."""

from __future__ import annotations

import math
import struct
from collections.abc import Mapping
from typing import Any

Fields = dict[str, str]

SCALARS = [
    *("registered", "reason", "fitness", "inlier_ratio_source", "inlier_ratio_target"),
    *("inlier_rmse", "fitness_gap", "points_source", "points_target", "dropped_source"),
    *("strays_source", "strays_target"),
    *("dropped_target", "sparse_source", "dense_source", "dense_target", "correspondences"),
    *("tims", "tims_pruned", "normalization_scale", "leaf_sparse", "leaf_dense", "iterations"),
    *(
        "confidence",
        "score",
        "surface_fit",
        "surface_near",
        "violation",
        "evidence",
        "scale_factor",
        "score_gap",
        "seeds",
        "candidates",
    ),
    *("used_fallback_search", "refined", "unconstrained_directions", "overlap_source"),
    *("overlap_target", "inlier_rmse_plane", "leaf_fine"),
]
LISTS = [
    *("transformation", "center_source", "center_target", "history_alpha", "history_beta"),
    *("alternatives", "information", "hessian_eigenvalues", "hessian_eigenvectors", "queries"),
    *("residuals", "residuals_single"),  # of the source; single: float32, as a file holds them
]


def of_result(result: Any, residuals: Any) -> Fields:
    """Returns the fields of a pyemtr.Result and the residuals of its source, float64 (n,)."""
    values = {name: getattr(result, name) for name in SCALARS}
    values |= {name: _flat(getattr(result, name)) for name in LISTS[:3]}
    values["history_alpha"] = _flat(result.history["alpha"])
    values["history_beta"] = _flat(result.history["beta"])
    values["alternatives"] = [v for T, *of in result.alternatives for v in [*_flat(T), *of]]
    values |= {name: _flat(getattr(result, name)) for name in LISTS[6:9]}
    queries = result.queries
    values["queries"] = [queries["evaluation"], queries["switch"], queries["complement"]]
    values["residuals"] = residuals.tolist()
    values["residuals_single"] = residuals.astype("float32").tolist()
    return _canonical(values)


def of_report(report: Mapping[str, Any], residuals: Any) -> Fields:
    """Returns the fields of pcl_emtr's JSON report and of its cloud's residuals, float32 (n,)."""
    whole = {**report, **report["quality"], **report["counts"], **report["normalization"]}
    refinement, queries = report["refinement"] or {}, report["queries"]  # none when not refined
    whole["unconstrained_directions"] = refinement.get("unconstrained_directions")
    values = {name: whole[name] for name in SCALARS}
    values |= {name: _flat(whole[name]) for name in LISTS[:3]}
    values["history_alpha"], values["history_beta"] = (
        report["history"]["alpha"],
        report["history"]["beta"],
    )
    parts = ("score", "surface_fit", "violation", "evidence")
    values["alternatives"] = [
        v
        for other in report["alternatives"]
        for v in [*_flat(other["transformation"]), *(other[part] for part in parts)]
    ]
    for name, length in (
        ("information", 36),
        ("hessian_eigenvalues", 6),
        ("hessian_eigenvectors", 36),
    ):
        given = refinement.get(name)
        values[name] = _flat(given) if given is not None else [math.nan] * length
    values["queries"] = [queries["evaluation"], queries["switch"], queries["complement"]]
    values["residuals_single"] = residuals.tolist()
    return _canonical(values)


def of_lines(text: str) -> list[Fields]:
    """Returns the results that the program `entries` prints, a line "name value ..." a field."""
    results: list[Fields] = []
    for line in text.splitlines():
        name, *words = line.split()
        if name == "result":
            results.append({})
        elif name == "reason":
            results[-1][name] = words[0]
        else:
            numbers = [_bits(float.fromhex(word)) for word in words]
            results[-1][name] = " ".join(numbers)
    return results


def differing(one: Fields, other: Fields) -> list[str]:
    """Returns the names of fields that differ; the shell has residuals in float32 only."""
    both = [name for name in SCALARS + LISTS if name in one and name in other]
    return [name for name in both if one[name] != other[name]]


def _canonical(values: dict[str, Any]) -> Fields:
    out: Fields = {}
    for name in SCALARS:
        value = values[name]
        if name == "reason":
            out[name] = value
        elif value is None:
            out[name] = _bits(-1.0 if name == "unconstrained_directions" else math.nan)
        else:
            out[name] = _bits(float(value))
    for name in LISTS:
        if name in values:
            out[name] = " ".join(_bits(float(math.nan if v is None else v)) for v in values[name])
    return out


def _flat(value: Any) -> list[Any]:
    rows = value.tolist() if hasattr(value, "tolist") else value
    if rows and isinstance(rows[0], list):
        return [v for row in rows for v in row]
    return list(rows)


def _bits(value: float) -> str:
    return "nan" if math.isnan(value) else struct.pack(">d", value).hex()
