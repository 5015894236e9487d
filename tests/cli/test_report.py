"""The report tells everything about a run, as JSON."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest


@pytest.fixture
def report(run, clouds, tmp_path) -> dict:
    done = run(*clouds, "-o", "T.txt", "--report", "r.json", "--threads", "2", "--seed", "3")
    assert done.returncode == 0, done.stderr
    return json.loads((tmp_path / "r.json").read_text())


def test_says_what_was_run(report, run):
    assert report["files"] == {
        "source": "a.pcd",
        "target": "b.pcd",
        "transformation": "T.txt",
        "aligned": None,
        "report": "r.json",
        "html": None,
        "guess": None,
        "correspondences": None,
    }
    assert report["user_provided"] == {"normals": False, "features": None, "correspondences": 0}
    assert (report["preset"], report["seed"], report["threads"]) == ("default", 3, 2)
    versions = report["versions"]
    assert run("--version").stdout == (
        f"pcl_emtr {versions['emtr']} (PCL {versions['pcl']}, Eigen {versions['eigen']})\n"
    )


def test_says_what_came_out(report, tmp_path, pair):
    assert report["registered"] is True and report["reason"] == "registered"
    assert report["transformation"] == np.loadtxt(tmp_path / "T.txt").tolist()
    quality = report["quality"]
    assert set(quality) == {
        "fitness",
        "inlier_ratio_source",
        "inlier_ratio_target",
        "fitness_gap",
        "overlap_source",
        "overlap_target",
        "inlier_rmse",
        "inlier_rmse_plane",
        "score",
        "surface_fit",
        "surface_near",
        "violation",
        "evidence",
        "scale_factor",
        "score_gap",
    }
    assert all(0 <= quality[name] <= 1 for name in quality if "ratio" in name or "lap" in name)
    assert 0 < quality["inlier_rmse_plane"] < quality["inlier_rmse"]
    assert report["residuals"] is None
    counts = report["counts"]
    assert counts["read_source"] == counts["points_source"] == len(pair.source)
    assert counts["read_target"] == counts["points_target"] == len(pair.target)
    assert counts["dropped_source"] == counts["dropped_target"] == 0
    assert 0 < counts["sparse_source"] < counts["dense_source"] <= len(pair.source)
    assert counts["tims_pruned"] <= counts["tims"]
    assert counts["iterations"] == len(report["history"]["alpha"]) == 5  # in one place from then on
    assert counts["seeds"] > 0 and counts["candidates"] > 0


def test_says_how_far_to_trust_it(report, pair):
    assert 0.9 < report["confidence"] <= 1
    assert report["used_fallback_search"] in (True, False) and report["refined"] is True
    scores = [other["score"] for other in report["alternatives"]]
    assert scores == sorted(scores, reverse=True)
    assert all(score <= report["quality"]["score"] for score in scores)
    for other in report["alternatives"]:
        angle, distance = pair.error(np.array(other["transformation"]))
        assert angle > 5 or distance > 0.1
    refinement = report["refinement"]
    information = np.array(refinement["information"])
    assert information.shape == (6, 6) and np.allclose(information, information.T)
    assert np.linalg.eigvalsh(information).min() > 0
    directions = np.array(refinement["hessian_eigenvectors"])
    assert np.allclose(np.linalg.norm(directions, axis=1), 1)
    assert (
        refinement["hessian_eigenvalues"] == sorted(refinement["hessian_eigenvalues"])
        and refinement["unconstrained_directions"] == 0
    )


def test_paper_has_no_candidates(run, clouds, tmp_path):
    run(*clouds, "--preset", "paper", "--report", "r.json")
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["registered"] is True and report["preset"] == "paper"
    assert report["confidence"] is None and report["refinement"] is None
    assert (
        report["alternatives"] == []
        and report["refined"] is report["used_fallback_search"] is False
    )
    judged = ("score", "surface_fit", "violation", "score_gap")
    assert [report["quality"][name] for name in judged] == [None] * 4
    assert report["counts"]["iterations"] == 100 and report["counts"]["candidates"] == 0


STAGES = (
    "normalization",
    "downsampling",
    "features",
    "matching",
    "seeds",
    "evolution",
    "candidates",
    "fallback_search",
    "refinement",
    "verdict",
)


def test_times_and_costs_add_up(report):
    queries = report["queries"]
    assert queries["total"] == queries["evaluation"] + queries["switch"] + queries["complement"] > 0
    seconds = report["seconds"]
    stages = [seconds[name] for name in STAGES]
    assert min(stages) >= 0 and sum(stages) == pytest.approx(seconds["total"])
    assert (seconds["fallback_search"] > 0) == report["used_fallback_search"]
    assert seconds["load_source"] > 0 and seconds["load_target"] > 0
    normalization = report["normalization"]
    assert normalization["normalization_scale"] > 0 and len(normalization["center_source"]) == 3


def test_is_strict_json_when_a_value_is_unknown(run, small, tmp_path):
    """Without any inlier there is no rmse, which JSON has no number for."""
    run(
        *small,
        "--preset",
        "paper",
        "--iterations",
        "1",
        "--population",
        "2",
        "--refine-leaf",
        "0.001",
        "--report",
        "r.json",
    )

    def refuse(name):
        raise AssertionError(f"{name} is no JSON")

    values = json.loads((tmp_path / "r.json").read_text(), parse_constant=refuse)
    rmse = values["quality"]["inlier_rmse"]
    assert rmse is None or math.isfinite(rmse)


def test_file_names_that_are_not_utf8(run, small, tmp_path):
    odd = b"\xff.pcd"
    (tmp_path / "a.pcd").rename(tmp_path / odd.decode("utf-8", "surrogateescape"))
    done = run(
        odd.decode("utf-8", "surrogateescape"),
        "b.pcd",
        "--iterations",
        "1",
        "--quiet",
        "--report",
        "r.json",
    )
    assert done.returncode in (0, 3)
    assert json.loads((tmp_path / "r.json").read_text())["files"]["source"] == "\ufffd.pcd"
