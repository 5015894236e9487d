"""The picture of a registration: pyemtr.plot."""

from __future__ import annotations

import io
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("matplotlib")
pytest.importorskip("scipy")

from matplotlib import image

import pyemtr
from pyemtr import plot
from pyemtr.camera import Camera, best_view
from pyemtr.plot import plot_alignment

UP = np.array([0.0, 0.0, 1.0])


def shell(count: int = 4000, seed: int = 0) -> np.ndarray:
    """A bumpy half ball that bulges towards -y, (count, 3)."""
    rng = np.random.default_rng(seed)
    points = rng.normal(size=(count, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    points[:, 1] = -np.abs(points[:, 1])
    return 10 * points * (1 + 0.1 * np.sin(5 * points[:, :1]) * np.cos(4 * points[:, 2:]))


def pose() -> np.ndarray:
    """Source into target: a rotation by 90 degrees about x, and a translation."""
    matrix = np.eye(4)
    matrix[:3, :3] = [[1, 0, 0], [0, 0, -1], [0, 1, 0]]
    matrix[:3, 3] = [4, 5, 6]
    return matrix


def pair() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    target, matrix = shell(), pose()
    return (target - matrix[:3, 3]) @ matrix[:3, :3], target, matrix


def texts(figure) -> str:
    return "\n".join(text.get_text() for ax in figure.axes for text in ax.texts)


def near(pixels: np.ndarray, color: np.ndarray) -> np.ndarray:
    """Pixels (H, W) of this hue: the shading changes brightness only."""
    chroma = pixels - pixels.mean(axis=2, keepdims=True)
    wanted = color - color.mean()
    scale = np.linalg.norm(chroma, axis=2) * np.linalg.norm(wanted)
    alike = chroma @ wanted / np.maximum(scale, 1e-9)
    return (alike > 0.95) & (np.linalg.norm(chroma, axis=2) > 0.1)


def test_png_shows_both_clouds_in_each_panel(tmp_path: Path) -> None:
    source, target, matrix = pair()
    path = tmp_path / "out.png"
    # the source without its left half and the target without its lower one: both are seen
    plot_alignment(source[target[:, 0] > -2], target[target[:, 2] > -2], matrix, path, dpi=60)
    pixels = image.imread(path)[:, :, :3]
    assert pixels.shape == (684, 780, 3)
    height, width = pixels.shape[:2]
    after = pixels[: height // 2, width // 2 :]
    assert near(after, plot.SOURCE_COLOR).mean() > 0.01
    assert near(after, plot.TARGET_COLOR).mean() > 0.01
    for rows in (slice(0, height // 2), slice(height // 2, height)):
        for columns in (slice(0, width // 2), slice(width // 2, width)):
            panel = pixels[rows, columns]
            assert (panel.min(axis=2) < 0.9).mean() > 0.05
    assert sorted(p.name for p in tmp_path.iterdir()) == ["out.png"]


def test_registered_clouds_lie_on_each_other_and_others_do_not(tmp_path: Path) -> None:
    source, target, matrix = pair()
    right = texts(plot_alignment(source, target, matrix, tmp_path / "a.png", unit="mm", dpi=30))
    assert "100% within" in right and "mm" in right
    off = matrix.copy()
    off[2, 3] += 100
    wrong = texts(plot_alignment(source, target, off, tmp_path / "b.png", unit="mm", dpi=30))
    assert "0% within" in wrong and "100%" not in wrong


def test_error_map_tells_the_distance(tmp_path: Path) -> None:
    grid = np.stack(np.meshgrid(np.arange(40.0), np.arange(40.0), [0.0]), axis=-1).reshape(-1, 3)
    lift = np.eye(4)
    lift[2, 3] = 1.5  # above points one apart: each is 1.5 from its nearest
    figure = plot_alignment(grid, grid, lift, tmp_path / "a.png", unit="m", dpi=30)
    assert "100% within 4 m, rms 1.5 m" in texts(figure)


def test_clouds_and_results_are_drawn_as_arrays_are(tmp_path: Path) -> None:
    source, target, _ = pair()
    result = pyemtr.register(source, target, preset="fast", iterations=3, threads=2)
    plain = plot_alignment(source, target, result.transformation, tmp_path / "a.png", dpi=30)
    clouds = pyemtr.Cloud(source), pyemtr.Cloud(target)
    found = plot_alignment(*clouds, result, tmp_path / "b.png", dpi=30)
    assert texts(found) == texts(plain)
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()


def test_equal_scales_in_every_panel(tmp_path: Path) -> None:
    source, target, matrix = pair()
    figure = plot_alignment(source * [1, 1, 9], target, matrix, tmp_path / "a.png", dpi=40)
    for ax in figure.axes[:4]:
        (left, right), (low, high) = ax.get_xlim(), ax.get_ylim()
        assert ax.bbox.width / (right - left) == pytest.approx(ax.bbox.height / (high - low))
        offsets = ax.collections[0].get_offsets()
        assert (offsets.min(axis=0) > (left, low)).all()
        assert (offsets.max(axis=0) < (right, high)).all()


def test_points_that_are_not_finite_are_left_out(tmp_path: Path) -> None:
    source, target, matrix = pair()
    holes = source.astype(np.float32)
    holes[::7] = np.nan
    holes[3] = np.inf
    figure = plot_alignment(holes, target, matrix, tmp_path / "a.png", dpi=30)
    assert len(figure.axes[3].collections[0].get_offsets()) == np.isfinite(holes).all(axis=1).sum()


def test_max_points_bounds_what_is_drawn(tmp_path: Path) -> None:
    source, target, matrix = pair()
    figure = plot_alignment(source, target, matrix, tmp_path / "a.png", max_points=500, dpi=30)
    assert [len(ax.collections[0].get_offsets()) for ax in figure.axes[:4]] == [1000] * 3 + [500]
    assert "100% within" in texts(figure)


@pytest.mark.parametrize("count", [1, 2, 3])
def test_tiny_clouds_are_drawn(tmp_path: Path, count: int) -> None:
    points = np.arange(3.0 * count).reshape(count, 3)
    plot_alignment(points, points, np.eye(4), tmp_path / "a.png", dpi=30)
    assert image.imread(tmp_path / "a.png").min() < 0.9


@pytest.mark.parametrize(
    "suffix, head", [(".png", b"\x89PNG"), (".pdf", b"%PDF"), ("", b"\x89PNG")]
)
def test_the_suffix_chooses_the_format(tmp_path: Path, suffix: str, head: bytes) -> None:
    path = tmp_path / f"picture{suffix}"
    plot_alignment(shell(50), shell(60), np.eye(4), path, dpi=30)
    assert path.read_bytes().startswith(head)


@pytest.mark.parametrize(
    "change, message",
    [
        ({"source": np.zeros((3, 50))}, "source"),
        ({"target": np.full((5, 3), np.nan)}, "target"),
        ({"transformation": np.eye(3)}, "transformation"),
        ({"transformation": np.full((4, 4), np.nan)}, "transformation"),
        ({"up": (0, 0, 0)}, "up"),
        ({"view": (1, 2)}, "view"),
        ({"max_points": 0}, "max_points"),
        ({"dpi": 0}, "dpi"),
        ({"path": "picture.nonsense"}, "nonsense"),
    ],
)
def test_bad_arguments_are_named_and_leave_no_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, change: dict, message: str
) -> None:
    monkeypatch.chdir(tmp_path)
    arguments = {
        "source": shell(50),
        "target": shell(60),
        "transformation": np.eye(4),
        "path": "a.png",
    } | change
    with pytest.raises(ValueError, match=message):
        plot_alignment(**arguments)
    assert not list(tmp_path.iterdir())


def test_a_file_that_cannot_be_written_is_an_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with pytest.raises(OSError):
        plot_alignment(shell(50), shell(60), np.eye(4), tmp_path / "none" / "a.png", dpi=30)
    old = tmp_path / "a.png"
    old.write_bytes(b"before")

    def broken(*_: object) -> None:
        raise OSError("no space left")

    monkeypatch.setattr(plot.os, "replace", broken)
    with pytest.raises(OSError, match="no space"):
        plot_alignment(shell(50), shell(60), np.eye(4), old, dpi=30)
    assert old.read_bytes() == b"before"
    assert list(tmp_path.iterdir()) == [old]


def test_missing_matplotlib_names_the_extra(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(ImportError, match=r"pyemtr\[plot\]"):
        plot_alignment(shell(50), shell(60), np.eye(4), io.BytesIO())


def test_saving_leaves_matplotlib_as_it_was(tmp_path: Path) -> None:
    """In a process of its own: importing costs nothing, saving does not touch pyplot."""
    script = """
import sys, numpy as np, pyemtr.plot
assert "matplotlib" not in sys.modules and "scipy" not in sys.modules
import matplotlib
def state():  # reading "backend" would choose one, and that imports pyplot
    return {key: matplotlib.rcParams[key] for key in matplotlib.rcParams if key != "backend"}
before = state()
points = np.random.default_rng(0).normal(size=(100, 3))
pyemtr.plot.plot_alignment(points, points, np.eye(4), sys.argv[1], dpi=30)
assert "matplotlib.pyplot" not in sys.modules
assert state() == before
figure = pyemtr.plot.plot_alignment(points, points, np.eye(4), dpi=30)
from matplotlib import pyplot
assert pyplot.get_fignums() == [figure.number]
"""
    done = subprocess.run(
        [sys.executable, "-c", script, str(tmp_path / "a.png")],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stderr


def test_a_camera_is_a_rotation_and_keeps_up_upright() -> None:
    for direction in ([1, 2, 0.5], [0, 0, 1], [0, 0, -3], [-5, 0, 0]):
        axes = Camera.towards(np.array(direction, dtype=float), UP).axes
        assert np.allclose(axes @ axes.T, np.eye(3)) and np.linalg.det(axes) == pytest.approx(1)
        assert axes[0] @ UP == pytest.approx(0, abs=1e-12) or not np.any(direction[:2])
        assert axes[2] @ direction > 0


@pytest.mark.parametrize("degrees", [0, 75, 160, 290])
def test_a_shell_is_looked_at_from_outside(degrees: float) -> None:
    angle = np.radians(degrees)
    rotation = np.array(
        [[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]]
    )
    camera = best_view(shell() @ rotation.T, UP, gap=0.2)
    outside = rotation @ [0, -1, 0]
    assert camera.axes[2] @ outside > 0.6
