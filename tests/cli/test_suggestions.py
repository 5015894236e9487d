"""A mistyped option, preset or choice is refused, and the message names what was meant."""

from __future__ import annotations

import pytest


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("--popultion", "--population"),  # a letter is missing
        ("--populationn", "--population"),  # a letter too many
        ("--populatoin", "--population"),  # two letters are swapped
        ("--popularion", "--population"),  # a wrong letter
        ("--Population", "--population"),
        ("-population", "--population"),
        ("--dense_points", "--dense-points"),
        ("--usenormals", "--use-normals"),
        ("--iter", "--iterations"),  # its beginning
        ("--viewpont-source", "--viewpoint-source"),
        ("--ouput", "--output"),
        ("--hepl", "--help"),
        ("--help-al", "--help-all"),
        ("--versoin", "--version"),
    ],
)
def test_mistyped_option(refused, small, typed, meant):
    expected = f"pcl_emtr: error: {typed}: there is no such option; did you mean {meant}?"
    assert refused(1, *small, typed, "30") == expected
    assert refused(1, typed, "30", *small) == expected
    assert refused(1, f"{typed}=30", "a.pcd") == expected  # rather than the missing target


@pytest.mark.parametrize("typed", ["--nonsense", "--voxel-size", "-x", "-5", "--a", "---"])
def test_option_that_is_near_no_other(refused, small, typed):
    assert refused(1, *small, typed) == (
        f"pcl_emtr: error: {typed}: there is no such option; see pcl_emtr --help-all"
    )


@pytest.mark.parametrize(
    ("option", "typed", "meant"),
    [
        ("--preset", "fats", "fast"),
        ("--preset", "Paper", "paper"),
        ("--preset", "thoroug", "thorough"),
        ("--neighbors", "kdtre", "kdtree"),
        ("--features", "smid", "simd"),
        ("--arc-transfer", "allways", "always"),
        ("--arc-transfer", "of", "off"),
        ("--transfer", "onn", "on"),
        ("--viewpoint", "fiel", "file"),
    ],
)
def test_mistyped_choice(refused, small, option, typed, meant):
    message = refused(1, *small, option, typed)
    assert message.startswith(f"pcl_emtr: error: {option}: '{typed}' is not ")
    assert message.endswith(f"; did you mean {meant}?")


@pytest.mark.parametrize(
    ("option", "typed"),
    [
        ("--preset", "quick"),
        ("--neighbors", "lattice"),
        ("--neighbors", "0"),
        ("--transfer", "2"),
        ("--iterations", "abc"),
        ("--viewpoint", "1"),
    ],
)
def test_choice_that_is_near_no_other(refused, small, option, typed):
    message = refused(1, *small, option, typed)
    assert f"{option}: '{typed}' is not " in message and "did you mean" not in message
