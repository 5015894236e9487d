"""Bad and odd pairs of clouds, each with what is to come of it."""

from __future__ import annotations

import types
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import shapes

RNG = np.random.default_rng(0)
PAIR = shapes.make_pair(seed=1, count=4000)
S, T = PAIR.source, PAIR.target
COUNT = 2000

#: What a pose that cannot be told from others may be called; never `registered`.
DOUBT = frozenset({"low_overlap", "ambiguous", "few_matches", "degenerate"})
ANY = DOUBT | {"registered"}
GOOD = frozenset({"registered"})


@dataclass(frozen=True)
class Refused:
    """A typed error; its message has this pattern."""

    type: str
    pattern: str


@dataclass(frozen=True)
class Row:
    make: Callable[[], tuple[object, object]]
    expected: frozenset[str] | Refused
    pose: np.ndarray | None = None  # (4, 4), expected within 1 % of the scale
    scale: float = 1.0


def plane() -> np.ndarray:
    return np.column_stack([RNG.uniform(-1, 1, (COUNT, 2)), np.zeros(COUNT)])


def sphere() -> np.ndarray:
    return shapes.directions(RNG, COUNT)


def cylinder() -> np.ndarray:
    angle = RNG.uniform(0, 2 * np.pi, COUNT)
    return np.column_stack([np.cos(angle), np.sin(angle), RNG.uniform(-2, 2, COUNT)])


def cube() -> np.ndarray:
    points = RNG.uniform(-1, 1, (COUNT, 3))
    points[np.arange(COUNT), RNG.integers(0, 3, COUNT)] = RNG.choice([-1, 1], COUNT)
    return points


def rotated(points: np.ndarray) -> np.ndarray:
    return shapes.apply(shapes.random_transformation(np.random.default_rng(5)), points)


def twice(make: Callable[[], np.ndarray]) -> Callable[[], tuple[object, object]]:
    """Two samplings of one shape, one of them rotated."""
    return lambda: (make(), rotated(make()))


def same(make: Callable[[], np.ndarray]) -> Callable[[], tuple[object, object]]:
    def pair() -> tuple[object, object]:
        points = make()
        return points, points.copy()

    return pair


def gaps(share: float, value: float = np.nan) -> np.ndarray:
    """The source, `share` of its points without a place."""
    points = S.copy()
    points[RNG.permutation(len(S))[: round(share * len(S))], RNG.integers(0, 3)] = value
    return points


def of(source: object, target: object = T) -> Callable[[], tuple[object, object]]:
    return lambda: (source, target)


def zero_stride() -> np.ndarray:
    return np.lib.stride_tricks.as_strided(S, (100, 3), (0, 8))


def read_only() -> np.ndarray:
    frozen = S.copy()
    frozen.flags.writeable = False
    return frozen


FEW = Refused("ValueError", r"source cloud: \d+ finite points of \d+, expected at least 10")
THIN = Refused(
    "ValueError", r"(source|target) cloud: downsampled to \d+ points .*expected at least 10"
)
NUMBERS = Refused("TypeError", "source: expected an array of real numbers, got dtype")
SHAPE = Refused("ValueError", r"source: expected .*\(N, 3\), got \(")
EQUAL = Refused("ValueError", "source cloud: all points are equal")
LINE = Refused("ValueError", "source cloud: all points lie on one line")
TRUTH = PAIR.truth


def scaled(factor: float) -> np.ndarray:
    truth = TRUTH.copy()
    truth[:3, 3] *= factor
    return truth


ROWS: dict[str, Row] = {
    # shape
    "transposed": Row(of(S.T), SHAPE),
    "two columns": Row(of(S[:, :2]), SHAPE),
    "four columns": Row(of(np.zeros((200, 4))), SHAPE),
    "one dimension": Row(of(S.ravel()), SHAPE),
    "three dimensions": Row(of(S[None]), SHAPE),
    "a number": Row(of(np.float64(3)), SHAPE),
    "empty": Row(of(np.empty((0, 3))), FEW),
    "ragged lists": Row(of([[1, 2, 3], [4, 5]]), Refused("ValueError", "source: .*array of numb")),
    "None": Row(of(None), Refused("TypeError", "source: .*NoneType")),
    "text": Row(of("cloud.pcd"), Refused("FileNotFoundError", "cloud.pcd")),
    "points is None": Row(
        of(types.SimpleNamespace(points=None)), Refused("TypeError", "source: .*NoneType")
    ),
    # dtype
    "complex": Row(of(S.astype(complex)), NUMBERS),
    "object": Row(of(S.astype(object)), NUMBERS),
    "bool": Row(of(S > 0), NUMBERS),
    "strings": Row(of(S.astype(str)), NUMBERS),
    "dates": Row(of(np.zeros((100, 3), "M8[s]")), NUMBERS),
    "structured": Row(of(np.zeros(200, "f4,f4,f4")), Refused("TypeError", "columns x, y and z")),
    "float16": Row(of(S.astype("f2"), T.astype("f2")), GOOD, TRUTH),
    "longdouble": Row(of(S.astype("g"), T.astype("g")), GOOD, TRUTH),
    "float32": Row(of(S.astype("f4"), T.astype("f4")), GOOD, TRUTH),
    "big-endian": Row(of(S.astype(">f8"), T.astype(">f4")), GOOD, TRUTH),
    "int8 of thousandths": Row(of((S * 80).astype("i1"), (S * 80).astype("i1")), ANY),
    # strides
    "zero stride": Row(lambda: (zero_stride(), T), EQUAL),
    "rows backward": Row(of(S[::-1], T[::-1]), GOOD, TRUTH),
    "columns backward": Row(of(S[:, ::-1], T[:, ::-1]), GOOD),
    "Fortran order": Row(of(np.asfortranarray(S), np.asfortranarray(T)), GOOD, TRUTH),
    "every other row": Row(of(np.repeat(S, 2, axis=0)[::2]), GOOD, TRUTH),
    "read-only": Row(lambda: (read_only(), T), GOOD, TRUTH),
    # numbers
    "NaN, none": Row(lambda: (gaps(0), T), GOOD, TRUTH),
    "NaN, a quarter": Row(lambda: (gaps(0.25), T), GOOD, TRUTH),
    "NaN, half": Row(lambda: (gaps(0.5), T), GOOD, TRUTH),
    "NaN, 99 of 100": Row(lambda: (gaps(0.99), T), ANY),
    "NaN, all but nine": Row(lambda: (gaps(1 - 9 / len(S)), T), FEW),
    "NaN, all": Row(lambda: (gaps(1), T), FEW),
    "infinity, half": Row(lambda: (gaps(0.5, np.inf), T), GOOD, TRUTH),
    "minus infinity, all": Row(lambda: (gaps(1, -np.inf), T), FEW),
    "denormal doubles": Row(of(S * 1e-310, T * 1e-310), EQUAL),
    "denormal floats": Row(of((S * 1e-40).astype("f4"), (T * 1e-40).astype("f4")), ANY),
    "1e30": Row(of(S * 1e30, T * 1e30), GOOD, scaled(1e30), 1e30),
    "1e30 floats": Row(
        of((S * 1e30).astype("f4"), (T * 1e30).astype("f4")), GOOD, scaled(1e30), 1e30
    ),
    "1e-30": Row(of(S * 1e-30, T * 1e-30), GOOD, scaled(1e-30), 1e-30),
    "1e308": Row(
        of(S * 5e307, T * 5e307), Refused("ValueError", "source cloud: coordinates too large")
    ),
    "one coordinate 1e308": Row(
        lambda: (np.vstack([S, [[1e308, 0, 0]]]), T),
        GOOD,
        TRUTH,
    ),
    "1e30 against 1e-30": Row(of(S * 1e30, T * 1e-30), THIN),
    "far from the origin": Row(of(S, T + 1e9), ANY),
    # shapes that hold no pose, or several
    "a plane": Row(twice(plane), DOUBT),
    "a plane and itself": Row(same(plane), DOUBT),
    "a line": Row(
        of(np.outer(np.arange(500.0), [1, 2, 3])),
        LINE,
    ),
    "nearly a line": Row(lambda: (RNG.normal(size=(500, 3)) * [1, 1e-7, 1e-7], T), LINE),
    "a sphere": Row(twice(sphere), DOUBT),
    "a sphere and itself": Row(same(sphere), DOUBT),
    "a cylinder": Row(twice(cylinder), DOUBT),
    "a cylinder and itself": Row(same(cylinder), DOUBT),
    "a cube": Row(twice(cube), DOUBT),
    "a cube and itself": Row(same(cube), DOUBT),
    "a lattice": Row(same(lambda: np.indices((9, 9, 9)).reshape(3, -1).T * 1.0), ANY),
    "noise": Row(lambda: (RNG.normal(size=(900, 3)), RNG.normal(size=(900, 3))), DOUBT),
    # clouds that do not belong together, or only too well
    "identical": Row(same(lambda: S), GOOD, np.eye(4)),
    "mirrored": Row(of(S, S * [-1, 1, 1]), DOUBT),
    "disjoint objects": Row(lambda: (S, cube()), DOUBT),
    "plane against solid": Row(lambda: (plane(), S), DOUBT),
    "a far outlier": Row(lambda: (np.vstack([S, [[1e6, 0, 0]]]), T), GOOD, TRUTH),
    "two far clusters": Row(lambda: (np.vstack([S * 1e-6, S * 1e-6 + 1e6]), T), LINE),
    "every point twice": Row(of(np.vstack([S, S]), np.vstack([T, T])), GOOD, TRUTH),
    "one point a thousand times": Row(of(np.full((1000, 3), 2.5)), EQUAL),
    # counts
    "one point": Row(of(S[:1]), FEW),
    "three points": Row(of(S[:3], T[:3]), FEW),
    "nine points": Row(of(S[:9], T[:9]), FEW),
    "ten points": Row(of(S[:10], T[:10]), THIN),
    "twenty points": Row(of(S[:20], T[:20]), DOUBT | {"downsampled"}),
    "fifty points": Row(of(S[:50], T[:50]), DOUBT),
    "one against a million": Row(lambda: (S[:1], RNG.normal(size=(1000000, 3))), FEW),
    "fifty against a million": Row(lambda: (S[:50], RNG.normal(size=(1000000, 3))), DOUBT),
    "thousands against a million": Row(
        lambda: (S, np.vstack([T] * 300)), GOOD, TRUTH
    ),
}  # fmt: skip
