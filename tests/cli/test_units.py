"""Clouds in different units: a hint, and nothing else changes."""

from __future__ import annotations

import json

import cloud_files
import pytest


@pytest.fixture
def scaled(run, tmp_path, pair):
    """Registers the pair with the source scaled; what was said, and the report if there is one."""

    def call(factor: float, *options):
        cloud_files.write_pcd(tmp_path / "a.pcd", pair.source * factor)
        cloud_files.write_pcd(tmp_path / "b.pcd", pair.target)
        done = run(
            "a.pcd", "b.pcd", "--threads", "2", "-o", "T.txt", "--report", "r.json", *options
        )
        path = tmp_path / "r.json"
        return done, json.loads(path.read_text()) if path.exists() else None

    return call


@pytest.mark.parametrize(
    ("factor", "units"),
    [
        (10, "millimeters and centimeters"),
        (25.4, "millimeters and inches"),
        (100, "centimeters and meters"),
        (304.8, "millimeters and feet"),
        (1000, "millimeters and meters"),
    ],
)
@pytest.mark.parametrize("inverse", [False, True])
def test_suspected(scaled, factor, units, inverse):
    done, report = scaled(1 / factor if inverse else factor)
    larger, smaller = ("target", "source") if inverse else ("source", "target")
    assert f"the {larger} is about " in done.stderr
    assert f"times as large as the {smaller}: are they in different units, such as {units}?" in (
        done.stderr
    )
    if report:  # else too few points are left of the smaller cloud, which is an error
        hint = report["unit_hint"]
        assert hint["factor"] == pytest.approx(1 / factor if inverse else factor)
        assert hint["ratio"] == pytest.approx(hint["factor"], rel=0.3)
        assert units in hint["text"]
        assert done.returncode == 3
    else:
        assert done.returncode == 2 and "downsampled to " in done.stderr


def test_at_least_one_ends_with_a_report_and_one_with_an_error(scaled):
    assert scaled(10)[1] is not None
    _, report = scaled(1000)
    assert report is None or report["unit_hint"]


@pytest.mark.parametrize("factor", [1, 1.5, 5, 0.2, 1e5])
def test_not_suspected(scaled, factor):
    done, report = scaled(factor)
    assert "different units" not in done.stderr
    assert report is None or report["unit_hint"] is None
