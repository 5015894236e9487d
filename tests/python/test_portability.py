"""tools/portability: what it runs, what it reports, and what it refuses; no chroot is made here."""

from __future__ import annotations

import hashlib
import os
import shutil
import signal
import sys
from pathlib import Path

import pytest

TOOLS = Path(__file__).resolve().parents[2] / "tools"
sys.path.append(str(TOOLS))

from portability_chroots import chroot, foreign, packages, pair, program, syntax  # noqa: E402
from portability_chroots.arguments import parse  # noqa: E402
from portability_chroots.chroot import Chroot, ChrootFailure  # noqa: E402
from portability_chroots.steps import PAIR_FOLDER, bits_path, steps  # noqa: E402


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
    said = capsys.readouterr().out.splitlines()[-3:]
    assert said == [
        f"trixie          gcc    passed, {count} warnings of the compiler",
        f"trixie          clang  passed, {count} warnings of the compiler",
        "generated pair: registered nowhere",  # no chroot was there to do it
    ]


def test_a_step_that_fails_is_named_and_the_others_go_on(fake, capsys, tmp_path) -> None:
    status, scripts = fake("ctest --test-dir /build/gcc", "--suites", "trixie", "testing")
    assert status == 1
    assert not any("cmake --install /build/gcc" in script for script in scripts)
    assert sum("cmake --install /build/clang" in script for script in scripts) == 2
    said = capsys.readouterr().out
    assert f"trixie          gcc    FAILED: ctest, see {tmp_path}/trixie-gcc.log" in said
    assert "testing         clang  passed" in said


def test_poses_of_other_bits_are_a_failure(monkeypatch, tmp_path, capsys) -> None:
    poses = {"trixie": "1 0 0 0\n", "testing": "1 0 0 0\n"}

    def run(self: Chroot, script: str, out) -> int:
        if f"{PAIR_FOLDER}\n" in script:
            assert (self.root / "build/pair/source.xyz").stat().st_size > 0
            (self.root / bits_path("gcc").lstrip("/")).write_text(poses[self.suite])
        return 0

    monkeypatch.setattr(Chroot, "make", lambda self, mirror, reuse: None)
    monkeypatch.setattr(Chroot, "run", run)
    words = ["--folder", str(tmp_path), "--suites", "trixie", "testing", "--compilers", "gcc"]
    assert program.main(words) == 0
    assert "generated pair: the same bits in all 2, " in capsys.readouterr().out
    poses["testing"] = "1 0 0 1e-17\n"
    assert program.main(words) == 1
    said = "FAILED: the generated pair has other bits by testing gcc than by trixie gcc"
    assert said in capsys.readouterr().out


def test_the_generated_pair_has_the_same_bytes_everywhere(tmp_path) -> None:
    pair.write(tmp_path)
    both = b"".join((tmp_path / name).read_bytes() for name in ("source.xyz", "target.xyz"))
    assert hashlib.sha256(both).hexdigest()[:16] == "453604f343db84e3"


def test_another_processor_is_built_for_by_this_ones_compiler(fake, capsys) -> None:
    status, scripts = fake("no such word", "--suites", "trixie", "--architecture", "arm64")
    assert status == 0
    assert all("CXX=g++" not in script for script in scripts)
    assert any("CXX=aarch64-linux-gnu-g++" in script for script in scripts)
    assert not any("cpack" in script for script in scripts)
    assert any("registered_pair.py" in script for script in scripts)
    assert any("GTEST_SHARD_INDEX=1 ./emtr_tests; wait $!" in script for script in scripts)
    assert "trixie-arm64    gcc    passed" in capsys.readouterr().out


def test_the_tools_of_a_foreign_chroot_are_not_emulated() -> None:
    assert {"g++-aarch64-linux-gnu", "cmake", "dash"} <= set(packages.native("arm64"))
    assert "libpcl-dev" in packages.foreign()
    assert not {"g++", "cmake", "clang", "dash"} & set(packages.foreign())


@pytest.mark.parametrize(
    ("absent", "named"), [("mmdebstrap", "mmdebstrap"), ("nothing", "qemu-user-static")]
)
def test_what_another_processors_chroot_needs_is_named(
    monkeypatch, tmp_path, absent, named
) -> None:
    monkeypatch.setattr(chroot.os, "geteuid", lambda: 0)
    monkeypatch.setattr(foreign.shutil, "which", lambda name: None if name == absent else name)
    monkeypatch.setattr(foreign, "BINFMT", tmp_path)
    with pytest.raises(ChrootFailure, match=f"apt-get install {named}"):
        Chroot(tmp_path, "trixie", "arm64").make("http://localhost", reuse=False)


def test_an_extracted_root_is_finished_without_the_packages_scripts(monkeypatch, tmp_path) -> None:
    """The programs are stand-ins; the script runs as it is."""
    programs, root = tmp_path / "bin", tmp_path / "root"
    programs.mkdir()
    noted = f'echo "$(basename "$0") $*" >> {tmp_path}/said'
    for name in ("mmdebstrap", "tar", "rm", "chroot", "dpkg"):
        (programs / name).write_text(f"#!/bin/sh\n{noted}\n")
        (programs / name).chmod(0o755)
    for folder in ("usr/share/base-passwd", "usr/bin", "usr/lib/x/blas", "etc/ld.so.conf.d"):
        (root / folder).mkdir(parents=True)
    for name in ("passwd", "group"):
        (root / f"usr/share/base-passwd/{name}.master").write_text("root:x:0:0\n")
    monkeypatch.setenv("PATH", f"{programs}:{os.environ['PATH']}")
    with (tmp_path / "log").open("w") as log:
        assert foreign.extract(root, "trixie", "arm64", "http://localhost", log)
    said = (tmp_path / "said").read_text()
    assert "--architectures=arm64" in said and "libpcl-dev" in said
    assert f"chroot {root} /sbin/ldconfig" in said
    assert (root / "etc/ld.so.conf.d/extracted.conf").read_text() == "/usr/lib/x/blas\n"
    assert (root / "etc/passwd").is_file() and (root / "usr/bin/awk").is_symlink()
    (programs / "mmdebstrap").write_text("#!/bin/sh\nexit 1\n")
    with (tmp_path / "log").open("w") as log:
        assert not foreign.extract(root, "trixie", "arm64", "http://localhost", log)


def test_the_readmes_commands_run_in_a_clone(fake, capsys) -> None:
    status, scripts = fake("no such word", "--suites", "trixie", "--readme")
    assert status == 0
    assert "clone -q /source" in scripts[0]
    assert [script.split()[-1] for script in scripts[1:]] == ["tools/quickstart", "tools/check"]
    assert "trixie-readme   cc     passed" in capsys.readouterr().out
    assert fake("tools/check", "--suites", "trixie", "--readme")[0] == 1
    with pytest.raises(SystemExit):
        parse(["--readme", "--architecture", "arm64"])


def test_a_chroot_for_the_readme_is_one_of_its_own(tmp_path) -> None:
    bare = Chroot(tmp_path, "trixie", bare=True)
    assert bare.root == tmp_path / "trixie-readme"
    assert bare.packages() == ["git", "ca-certificates"]


def test_what_is_no_chroot_of_ours_is_not_removed(monkeypatch, tmp_path, capsys) -> None:
    monkeypatch.setattr(chroot.os, "geteuid", lambda: 0)
    monkeypatch.setattr(chroot.shutil, "which", lambda name: f"/usr/sbin/{name}")
    (tmp_path / "trixie").mkdir()
    (tmp_path / "trixie" / "thesis.txt").write_text("all there is of it")
    assert program.main(["--folder", str(tmp_path), "--suites", "trixie"]) == 2
    assert f"{tmp_path}/trixie: made by something else, and not removed" in capsys.readouterr().err
    assert (tmp_path / "trixie" / "thesis.txt").is_file()


def test_a_chroot_that_was_not_finished_is_made_anew(monkeypatch, tmp_path) -> None:
    chroot = Chroot(tmp_path, "trixie")
    monkeypatch.setattr(Chroot, "_require_means", lambda self: None)

    def install(self, wanted, mirror, out) -> None:
        self.root.mkdir()
        (self.root / "part").touch()
        raise KeyboardInterrupt

    monkeypatch.setattr(Chroot, "_install", install)
    for _ in range(2):  # the second finds what the first has left
        with pytest.raises(KeyboardInterrupt):
            chroot.make("mirror", reuse=False)
    monkeypatch.setattr(Chroot, "_install", lambda self, *_: self.root.mkdir())
    chroot.make("mirror", reuse=False)
    assert [path.name for path in chroot.root.iterdir()] == ["made-by-tools-portability"]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["trixie", "trixie.log"]


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
