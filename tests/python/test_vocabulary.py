"""Names, comments and pages use the words of the field; the search for others finds them."""

from __future__ import annotations

from pathlib import Path

import pytest
import vocabulary

ROOT = Path(__file__).resolve().parents[2]


def rules_that_find(line: str, path: str = "libemtr/src/x.cpp") -> set[str]:
    return {
        finding.rule.old
        for finding in vocabulary.findings_in(path, line)
        if vocabulary.excused(finding) is None
    }


def test_no_old_word_is_left() -> None:
    left = [str(f) for f in vocabulary.all_findings(ROOT) if vocabulary.excused(f) is None]
    assert left == [], "\n".join([f"{len(left)} old words", *left])


def test_every_exception_is_needed() -> None:
    used = {vocabulary.excused(finding) for finding in vocabulary.all_findings(ROOT)}
    idle = [exception for exception in vocabulary.EXCEPTIONS if exception not in used]
    assert idle == []


def test_the_search_reads_all_folders() -> None:
    names = {path.relative_to(ROOT).as_posix() for path in vocabulary.files(ROOT)}
    assert {"README.md", "docs/METHOD.md", "tools/check", "libemtr/CMakeLists.txt"} <= names
    assert {"libemtr/include/emtr/emtr.h", "pyemtr/result.py", "tests/conftest.py"} <= names
    assert not any(name.startswith(("build", ".")) for name in names)


@pytest.mark.parametrize(
    ("line", "old"),
    [
        ("std::unique_ptr<FeatureClouds> handed;", "handed (in)"),
        ("struct HandedRows {", "handed (in)"),
        ("what the caller hands in", "handed (in)"),
        ("emtr_prepare(cloud)", "make ready, prepare"),
        ("PreparedCloud cloud;", "make ready, prepare"),
        ("a cloud is made ready", "make ready, prepare"),
        ("struct Frame {", "frame (the step)"),
        ('tell({"frame", 0});', "frame (the step)"),
        ("r.seconds_frame = 0;", "frame (the step)"),
        ("Densities densities;", "densities"),
        ("described_points(cloud)", "described points"),
        ("a nearest neighbor look-up", "look-up"),
        ("constexpr double kGridLookUp = 5;", "look-up"),
        ("uint64_t lookups_switch;", "look-up"),
        ("points that have a partner", "partner"),
        ("struct LocalPolish {", "polish"),
        ("Standing standing;", "standing, stand, doubted"),
        ("confidence = stand(ranked);", "standing, stand, doubted"),
        ("surfaces are doubted", "standing, stand, doubted"),
        ("double agreement = 0;", "agreement"),
        ("double kOfCrossing = 20;", "crossing"),
        ("double hold_directions[36];", "hold, slides, free directions"),
        ("double hold[6];", "hold, slides, free directions"),
        ("how firmly the surfaces hold the pose", "hold, slides, free directions"),
        ("a plane slides along itself", "hold, slides, free directions"),
        ("int free_directions;", "hold, slides, free directions"),
        ("settings.escalation_points", "escalation"),
        ("settings.minimum_mode_gap", "modes, distinct, copy"),
        ("if (within(a, b, kMode))", "modes, distinct, copy"),
        ("none of them copies of a pose", "modes, distinct, copy"),
        ("class Pool {", "pool"),
        ("double chf = 0;", "chf"),
        ("a rotation and a shift", "shift"),
        ("turned by 120 degrees", "turn"),
        ("double turn = 0;", "turn"),
        ("double forces = 0;", "forces"),
        ("tests/python/test_company.py", "company"),
        ("see tools/bits", "bits (the programs)"),
        ("emtr_register_kept(", "kept (the functions)"),
        ("void solve(Team& team);", "Team"),
        ("in_parallel(n, threads, job);", "in_parallel"),
        ("const Watched scope(&watch);", "Watch, Watched"),
        ("catch (const Stopped&) {", "Stopped"),
        ("poll();", "poll()"),
        ("/// Of this version's size.", "a comment that begins with Of or What is"),
    ],
)
def test_an_old_word_is_found(line: str, old: str) -> None:
    assert old in rules_that_find(line)


@pytest.mark.parametrize(
    "line",
    [
        "in the target's coordinate frame, the normalized frame",
        "return the result in turn, and return it",
        "turns exceptions into status codes",
        "as it turns out, the switch is turned on",
        "the same bits, a row of bits",
        "the mode of the file; the modality",
        "copies the points once",
        "holds the points of a cloud; a threshold",
        "distinct points; is_same_pose(a, b, kDistinctPose)",
        "OpenMP's pool of threads",
        "a right-handed coordinate frame",
        "hand out the memory; passed by hand",
        "return value >> shift;",
        "the compiler forces the alignment",
        "outstanding; a surface; an understanding",
        "ThreadTeam& team; class ThreadTeam {",
        "// of the sorted points",
        "const Solution solution;",
    ],
)
def test_an_ordinary_word_is_not_found(line: str) -> None:
    assert rules_that_find(line) == set()


def test_a_path_is_searched_too() -> None:
    found = list(vocabulary.findings_in("tests/python/test_hold.py", ""))
    assert [(finding.number, finding.rule.old) for finding in found] == [
        (0, "hold, slides, free directions")
    ]


def test_a_finding_says_where() -> None:
    (found,) = vocabulary.findings_in("tools/x.py", "\npolished = 1\n")
    assert str(found) == "tools/x.py:2: polish -> local refinement: polished = 1"
