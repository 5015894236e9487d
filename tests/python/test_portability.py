"""tools/portability: what it runs, what it reports, and what it refuses; no chroot is made here."""

from __future__ import annotations

import os
import shutil
import signal
import sys
from pathlib import Path

import pytest

TOOLS = Path(__file__).resolve().parents[2] / "tools"
sys.path.append(str(TOOLS))

from portability_chroots import chroot, program, syntax  # noqa: E402
from portability_chroots.arguments import parse  # noqa: E402
from portability_chroots.chroot import Chroot, ChrootFailure  # noqa: E402
from portability_chroots.steps import steps  # noqa: E402


@pytest.fixture
def fake(monkeypatch: pytest.MonkeyPatch, tmp_path: Path):
    """main() with chroots in which a script fails if it has `wrong` in it; lists the scripts."""

    def runs(wrong: str, *words: str) -> tuple[int, list[str]]:
        scripts: list[str] = []

        def run(self: Chroot, script: str, out) -> int:
            scripts.append(script)
            out.write("a.cpp:1:2: warning: x\n")
            out.flush()
            return int(wrong in script)

        monkeypatch.setattr(Chroot, "make", lambda self, mirror, reuse: None)
        monkeypatch.setattr(Chroot, "run", run)
        return program.main(["--folder", str(tmp_path), *words]), scripts

    return runs


def test_all_steps_run_with_each_compiler(fake, capsys) -> None:
    status, scripts = fake("no such word", "--suites", "trixie", "--tests", "^c_api")
    assert status == 0
    count = len(steps("gcc", parse([])))
    assert len(scripts) == 2 * count
    assert sum("CXX=g++" in script for script in scripts) == sum(
        "CXX=clang++" in script for script in scripts
    )
    assert sum("ctest" in script and "-R '^c_api'" in script for script in scripts) == 2
    said = capsys.readouterr().out.splitlines()[-2:]
    assert said == [
        f"trixie     gcc    passed, {count} warnings of the compiler",
        f"trixie     clang  passed, {count} warnings of the compiler",
    ]


def test_a_step_that_fails_is_named_and_the_others_go_on(fake, capsys, tmp_path) -> None:
    status, scripts = fake("ctest --test-dir /build/gcc", "--suites", "trixie", "testing")
    assert status == 1
    assert not any("cmake --install /build/gcc" in script for script in scripts)
    assert sum("cmake --install /build/clang" in script for script in scripts) == 2
    said = capsys.readouterr().out
    assert f"trixie     gcc    FAILED: ctest, see {tmp_path}/trixie-gcc.log" in said
    assert "testing    clang  passed" in said


def test_what_is_no_chroot_of_ours_is_not_removed(monkeypatch, tmp_path, capsys) -> None:
    monkeypatch.setattr(chroot.os, "geteuid", lambda: 0)
    monkeypatch.setattr(chroot.shutil, "which", lambda name: f"/usr/sbin/{name}")
    (tmp_path / "trixie").mkdir()
    (tmp_path / "trixie" / "thesis.txt").write_text("all there is of it")
    assert program.main(["--folder", str(tmp_path), "--suites", "trixie"]) == 2
    assert f"{tmp_path}/trixie: made by something else, and not removed" in capsys.readouterr().err
    assert (tmp_path / "trixie" / "thesis.txt").is_file()


@pytest.mark.parametrize(
    ("root", "missing", "named"), [(False, "", "needs root"), (True, "debootstrap", "apt-get")]
)
def test_what_a_chroot_needs_is_named(monkeypatch, tmp_path, root, missing, named) -> None:
    monkeypatch.setattr(chroot.os, "geteuid", lambda: 0 if root else 1000)
    monkeypatch.setattr(chroot.shutil, "which", lambda name: None if name == missing else name)
    with pytest.raises(ChrootFailure, match=named):
        Chroot(tmp_path, "trixie").make("http://localhost", reuse=False)


def test_sigterm_ends_it_by_an_exception(monkeypatch, tmp_path) -> None:
    """So that subprocess.run() ends what runs in the chroot."""
    before = signal.getsignal(signal.SIGTERM)

    def terminated(self: Chroot, mirror: str, reuse: bool) -> None:
        os.kill(os.getpid(), signal.SIGTERM)

    monkeypatch.setattr(Chroot, "make", terminated)
    try:
        with pytest.raises(SystemExit) as ended:
            program.main(["--folder", str(tmp_path), "--suites", "trixie"])
    finally:
        signal.signal(signal.SIGTERM, before)
    assert ended.value.code == 143


@pytest.mark.parametrize("words", [["--jobs", "0"], ["--compilers", "tcc"], ["--suites"]])
def test_wrong_usage_is_refused(words: list[str], capsys) -> None:
    with pytest.raises(SystemExit) as ended:
        parse(words)
    assert ended.value.code == 2
    assert words[0] in capsys.readouterr().err


@pytest.mark.skipif(shutil.which("c++") is None, reason="no compiler")
def test_the_check_of_the_syntax_finds_a_missing_include(tmp_path: Path) -> None:
    def check(text: str) -> int:
        (tmp_path / "a.cpp").write_text(text)
        words = syntax.only_checked("c++ -I. -o a.o -c a.cpp")
        return syntax.run(words, tmp_path).returncode

    assert check("std::int32_t x;") != 0
    assert check("#include <cstdint>\nstd::int32_t x;") == 0
    assert [path.name for path in tmp_path.iterdir()] == ["a.cpp"]


def test_smoke_reports_what_is_refused(monkeypatch, capsys) -> None:
    said = {"gcc": [], "clang": None}
    monkeypatch.setattr(syntax, "check", lambda compiler, folder, jobs: said[compiler])
    assert program.main(["--smoke"]) == 0
    assert "skipped: clang is not installed" in capsys.readouterr().out
    said["clang"] = ["a.h\nno such type"]
    assert program.main(["--smoke"]) == 1
    assert "no such type" in capsys.readouterr().out
    said.update(gcc=None, clang=None)
    assert program.main(["--smoke"]) == 1  # nothing was checked
