"""Two scans of a bumpy ball from different sides, of any size, with the true pose."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

BUMPS = 18
NOISE = 0.002  # standard deviation of each coordinate, radii of the ball
BLOCK = 100_000  # points made at a time, so that little more memory is touched than they need
VIEWS = ((0.35, 0.0, 0.94), (-0.35, 0.0, 0.94))
HIDDEN = -0.1  # least cosine to the view that is seen: about 80 % of a scan is in the other


@dataclass(frozen=True)
class BallPair:
    source: NDArray[np.float32]  # (n, 3)
    target: NDArray[np.float32]  # (n, 3)
    T_true: NDArray[np.float64]  # (4, 4), source into target

    @property
    def bytes(self) -> int:
        return self.source.nbytes + self.target.nbytes


def ball_pair(points: int, seed: int) -> BallPair:
    """Scans of `points` points each; the same seed gives one surface whatever their number."""
    rng = np.random.default_rng(seed)
    bumps = _directions(rng, BUMPS)
    heights = rng.uniform(0.1, 0.3, BUMPS) * rng.choice([-1, 1], BUMPS)
    sharpness = rng.uniform(6.0, 30.0, BUMPS)
    T_true = np.eye(4)
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    rotation = q * np.sign(np.diag(r))
    T_true[:3, :3] = rotation if np.linalg.det(rotation) > 0 else -rotation
    T_true[:3, 3] = rng.uniform(-2.0, 2.0, 3)

    def scan(view: tuple[float, ...], inverse: bool) -> NDArray[np.float32]:
        cloud = np.empty((points, 3), np.float32)
        made = 0
        while made < points:
            at = _directions(rng, BLOCK)
            at = at[at @ np.array(view, np.float32) > HIDDEN][: points - made]
            relief = (at @ bumps.T - 1.0) * sharpness.astype(np.float32)
            radius = 1.0 + np.exp(relief) @ heights.astype(np.float32)
            block = at * radius[:, None] + NOISE * rng.standard_normal(at.shape, np.float32)
            if inverse:
                block = (block - T_true[:3, 3]) @ T_true[:3, :3]
            cloud[made : made + len(block)] = block
            made += len(block)
        return cloud

    return BallPair(scan(VIEWS[0], True), scan(VIEWS[1], False), T_true)


def _directions(rng: np.random.Generator, count: int) -> NDArray[np.float32]:
    vectors = rng.standard_normal((count, 3), np.float32)
    return np.asarray(vectors / np.linalg.norm(vectors, axis=1, keepdims=True))
