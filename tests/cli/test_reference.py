"""The path through PCL's own kd-tree and features, to the same answer."""

from __future__ import annotations

import json

import pytest


def outcome(run, tmp_path, *arguments) -> dict:
    """The part of the report that must not depend on who answers the queries."""
    done = run("a.pcd", "b.pcd", *arguments, "--report", "r.json")
    assert done.returncode in (0, 3), done.stderr
    report = json.loads((tmp_path / "r.json").read_text())
    settings = report["settings"]
    return {
        "printed": done.stdout,
        "paths": (settings["neighbors"], settings["features"]),
        **{
            name: report[name]
            for name in ("transformation", "history", "queries", "quality", "confidence", "counts")
        },
    }


def test_the_same_bits_by_every_path_of_the_paper(run, clouds, tmp_path):
    paper = ["--preset", "paper", "--dense-points", "1500", "--iterations", "20"]
    plain = outcome(run, tmp_path, *paper)
    assert plain.pop("paths") == ("grid", "pcl")
    assert plain["queries"]["evaluation"] > 0 and plain["queries"]["complement"] > 0
    for arguments, paths in (
        (["--reference"], ("kdtree", "pcl")),
        (["--neighbors", "brute"], ("brute", "pcl")),
    ):
        other = outcome(run, tmp_path, *paper, *arguments)
        assert other.pop("paths") == paths
        assert other == plain


def test_of_the_default_preset_the_features_are_pcls_too(run, clouds, tmp_path):
    """The vectorized definition may differ in a bin, so this is compared with PCL's features."""
    quick = ["--iterations", "6", "--threads", "2"]
    plain = outcome(run, tmp_path, *quick, "--features", "pcl")
    reference = outcome(run, tmp_path, *quick, "--reference")
    assert reference.pop("paths") == ("kdtree", "pcl") != plain.pop("paths")
    assert reference == plain


@pytest.mark.parametrize(("option", "value"), [("--neighbors", "grid"), ("--features", "simd")])
def test_a_choice_against_it_is_refused(refused, small, option, value):
    assert f"--reference and {option} {value} contradict each other" in refused(
        1, *small, "--reference", option, value
    )


def test_the_same_choice_beside_it_is_allowed(run, small):
    done = run(
        *small, "--reference", "--neighbors", "kdtree", "--features", "pcl", "--iterations", "1"
    )
    assert done.returncode in (0, 3), done.stderr
