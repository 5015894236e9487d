"""The command line is read strictly, and --version tells the versions."""

from __future__ import annotations

import re

import cloud_files
import pytest
from conftest import QUICK, surface


def test_version(run):
    done = run("--version")
    assert done.returncode == 0
    assert re.fullmatch(
        r"pcl_emtr \d+\.\d+\.\d+ \(PCL \d+\.\d+\.\d+, Eigen \d+\.\d+\.\d+\)\n", done.stdout
    )


@pytest.mark.parametrize(
    ("arguments", "pattern"),
    [
        ([], "source is required"),
        (["a.pcd"], "target is required"),
        (["a.pcd", "b.pcd", "c.pcd"], "not expected: c.pcd"),
        (["a.pcd", "b.pcd", "--nonsense"], "--nonsense: there is no such option"),
        (["a.pcd", "b.pcd", "--iteration", "5"], "--iteration: there is no such option"),
        (["a.pcd", "b.pcd", "-o"], "--output"),
        (["a.pcd", "b.pcd", "-o", ""], "--output: expected a file name, got nothing"),
        (["a.pcd", "b.pcd", "-o", "--quiet"], "--output: expected a file name, got '--quiet'"),
        (
            ["a.pcd", "b.pcd", "--preset", "quick"],
            "--preset: 'quick' is not one of: default, fast, thorough or paper",
        ),
        (["a.pcd", "b.pcd", "--seed", "1", "--seed", "2"], "--seed"),
        (["a.pcd", "b.pcd", "--seed", "-1"], "--seed: '-1' is not a whole number from 0 to 1844"),
        (["a.pcd", "b.pcd", "--seed", "1.0"], "--seed: '1.0' is not a whole number"),
        (["a.pcd", "b.pcd", "--seed", "18446744073709551616"], "--seed: '18446744073709551616'"),
        (["a.pcd", "b.pcd", "--threads", "-2"], "--threads: '-2' is not a whole number from 0 to"),
        (["a.pcd", "b.pcd", "--iterations", "1.5x"], "--iterations: '1.5x' is not a whole number"),
        (["a.pcd", "b.pcd", "--iterations", "0"], "--iterations: '0' is not .* from 1 to 1000000"),
        (["a.pcd", "b.pcd", "--iterations", " 5"], "--iterations: ' 5'"),
        (
            ["a.pcd", "b.pcd", "--inertia-start", "nan"],
            "--inertia-start: 'nan' is not a number from",
        ),
        (
            ["a.pcd", "b.pcd", "--inertia-start", "3"],
            "--inertia-start: '3' is not a number from 0 to",
        ),
        (["a.pcd", "b.pcd", "--inertia-start", "0,5"], "--inertia-start: '0,5'"),
        (["a.pcd", "b.pcd", "--transfer", "2"], "--transfer: '2' is not on, off, 1 or 0"),
        (["a.pcd", "b.pcd", "--transfer"], "--transfer"),
        (
            ["a.pcd", "b.pcd", "--neighbors", "tree"],
            "--neighbors: 'tree' is not grid, kdtree or brute",
        ),
        (["a.pcd", "b.pcd", "--neighbors", "0"], "--neighbors: '0' is not grid, kdtree or brute"),
        (["a.pcd", "b.pcd", "--sparse-points", "9000"], "sparse_points.*dense_points"),
        (
            ["a.pcd", "b.pcd", "-o", "x", "--aligned", "m.pcd", "--report", "./x"],
            "--output and --report name the same file, './x'",
        ),
        (["a.pcd", "b.pcd", "-o", "a.pcd"], "--output would overwrite source, 'a.pcd'"),
        (["a.pcd", "b.pcd", "--aligned", "./b.pcd"], "--aligned would overwrite target, 'b.pcd'"),
        (["a.pcd", "b.pcd", "--guess", "g.txt", "-o", "g.txt"], "--output would overwrite --guess"),
        (
            ["a.pcd", "b.pcd", "-o", "moved.pcd"],
            "--output: 'moved.pcd' is named like a cloud.*--aligned",
        ),
        (["a.pcd", "b.pcd", "--report", "r.ply"], "--report: 'r.ply' is named like a cloud"),
    ],
)
def test_refused(refused, small, tmp_path, arguments, pattern):
    (tmp_path / "g.txt").write_text("1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n")
    message = refused(1, *arguments)
    assert re.search(pattern, message), message


def test_output_that_is_an_input_by_another_name(refused, small, tmp_path):
    (tmp_path / "link.txt").symlink_to("a.pcd")
    assert "--output would overwrite source" in refused(1, *small, "-o", "link.txt")


def test_options_may_come_first_and_with_an_equals_sign(run, small):
    plain = run(*small, *QUICK, "--seed", "7")
    assert run("--seed=7", *QUICK, *small).stdout == plain.stdout


def test_a_cloud_with_itself(run, tmp_path):
    cloud_files.write_pcd(tmp_path / "a.pcd", surface(240, 3))
    assert run("a.pcd", "a.pcd", *QUICK).returncode in (0, 3)
