"""The environment of the other libraries: what is installed anew, and when."""

import sys
from pathlib import Path

import pytest
from emtr_bench.peers import environment


@pytest.fixture
def repository(tmp_path, monkeypatch):
    folder = tmp_path / "repository"
    (folder / "libemtr" / "__pycache__").mkdir(parents=True)
    (folder / "pyemtr").mkdir()
    for name in (*environment.SOURCES[:3], "libemtr/a.cpp", "pyemtr/b.pyx", "requirements.txt"):
        (folder / name).write_text(name)
    monkeypatch.setattr(environment, "REPOSITORY", folder)
    monkeypatch.setattr(environment, "REQUIREMENTS", folder / "requirements.txt")
    return folder


@pytest.fixture
def ran(monkeypatch):
    """Records the commands in place of running them, by the word that tells them apart."""
    steps = []

    def run(command):
        steps.append(
            next(w for w in ("venv", "--requirement", "--force-reinstall") if w in command)
        )
        if steps[-1] == "venv":
            python = Path(command[-1]) / "bin" / "python"
            python.parent.mkdir(parents=True)
            python.touch()

    monkeypatch.setattr(environment, "_run", run)
    return steps


def test_all_at_first_and_then_what_has_changed(repository, ran, tmp_path):
    folder = tmp_path / "venv"
    assert environment.make_environment(folder) == folder / "bin" / "python"
    assert ran == ["venv", "--requirement", "--force-reinstall"]
    (repository / "libemtr" / "__pycache__" / "c.pyc").touch()
    environment.make_environment(folder)
    assert len(ran) == 3
    (repository / "build" / "lib.linux").mkdir(parents=True)
    (repository / "libemtr" / "a.cpp").write_text("changed")
    environment.make_environment(folder)
    assert ran[3:] == ["--force-reinstall"] and not (repository / "build" / "lib.linux").exists()
    (repository / "requirements.txt").write_text("another library")
    environment.make_environment(folder)
    assert ran[4:] == ["--requirement", "--force-reinstall"]


def test_half_an_installation_is_none(repository, ran, tmp_path, monkeypatch):
    environment.make_environment(tmp_path / "venv")
    (repository / "setup.py").write_text("changed")
    with monkeypatch.context() as broken, pytest.raises(environment.EnvironmentFailure):
        broken.setattr(environment, "_run", fails)
        environment.make_environment(tmp_path / "venv")
    environment.make_environment(tmp_path / "other")
    assert ran[3:] == ["venv", "--requirement", "--force-reinstall"]
    assert not (tmp_path / "venv" / "peers.stamp").exists()


def fails(command):
    raise environment.EnvironmentFailure(command)


def test_a_command_that_fails_is_told_with_its_words():
    with pytest.raises(environment.EnvironmentFailure, match=r"failed with status 3:\nwhy$"):
        environment._run([sys.executable, "-c", "print('why'); raise SystemExit(3)"])
