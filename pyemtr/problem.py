"""A pair of clouds made ready, for those who go stage by stage."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _emtr
from .arrays import Floats, as_particles, as_transformation, as_vector
from .cloud import as_cloud
from .options import Value, make_settings, settings_used, take_correspondences
from .progress import Callback, as_raw_callback
from .result import Result, make_result
from .views import ProblemViews


class Problem(ProblemViews):
    """Two clouds normalized, thinned, described and matched.

    Particles of task alpha are (theta1, theta2, theta3, tx, ty, tz), of task beta (theta1,
    theta2, theta3): radians, R = Rz(theta1) Ry(theta2) Rx(theta3), any real angle; t in the
    normalized frame, p' = (p - center) / scale. All threads may share one Problem: they wait
    for each other.

    Args and errors are those of :func:`pyemtr.register`.
    """

    def __init__(
        self,
        source: Any,
        target: Any,
        *,
        seed: int = 0,
        threads: int = 0,
        preset: str = "default",
        guess: Any = None,
        source_viewpoint: Any = None,
        target_viewpoint: Any = None,
        axis: Any = None,
        translation_bounds: Any = None,
        source_normals: Any = None,
        target_normals: Any = None,
        source_features: Any = None,
        target_features: Any = None,
        correspondences: Any = None,
        **settings: Value,
    ) -> None:
        chosen = make_settings(
            seed,
            threads,
            preset,
            guess,
            settings,
            source_viewpoint,
            target_viewpoint,
            axis,
            translation_bounds,
        )
        self.settings: dict[str, Any] = settings_used(chosen)
        keep = take_correspondences(chosen, correspondences)
        self._raw = _emtr.Problem(
            as_cloud(source, "source", source_normals, source_features, keep),
            as_cloud(target, "target", target_normals, target_features, keep),
            chosen,
        )
        self._lock = threading.Lock()
        self._holder: int | None = None

    def solve(self, callback: Callback | None = None) -> Result:
        """From the evolution to the verdict; the same bits as :func:`pyemtr.register` gives."""
        raw_callback = as_raw_callback(callback)
        with self._alone():
            raw = self._raw.solve(raw_callback)
        return make_result(raw, dict(self.settings))

    def evaluate_alpha(self, particles: Any, stage: str = "dense") -> Floats:
        """Fitness of task alpha, lower is better: (P, 6) to float64 (P,).

        ``stage`` is "sparse" or "dense". Each look-up is counted in ``queries``.
        Raises TypeError or ValueError for other shapes, types, or numbers that are not finite.
        """
        if stage not in ("sparse", "dense"):
            raise ValueError(f'stage: expected "sparse" or "dense", got {stage!r}')
        genes = as_particles(particles, 6)
        fitness = np.empty(len(genes), dtype=np.float64)
        with self._alone():
            self._raw.evaluate_alpha(stage == "dense", genes, fitness)
        return fitness

    def evaluate_beta(self, particles: Any) -> Floats:
        """Fitness of task beta, lower is better: (P, 3) to float64 (P,); raises likewise."""
        genes = as_particles(particles, 3)
        fitness = np.empty(len(genes), dtype=np.float64)
        with self._alone():
            self._raw.evaluate_beta(genes, fitness)
        return fitness

    def complement(self, angles: Any) -> Floats:
        """Algorithm 2: angles (3,) to the translation (3,), normalized, that completes them.

        With priors it completes the nearest rotation that they admit, to a pose that they admit.
        """
        a, b, c = as_vector(angles, "angles", 3).tolist()
        with self._alone():
            return np.array(self._raw.complement(a, b, c), dtype=np.float64)

    def to_transformation(self, particle: Any) -> Floats:
        """A particle (6,) as a matrix (4, 4), source into target, in the clouds' unit."""
        values = self._raw.to_transformation(as_vector(particle, "particle", 6))
        return np.array(values, dtype=np.float64).reshape(4, 4)

    def to_particle(self, transformation: Any) -> Floats:
        """A rigid matrix (4, 4), source into target, as a particle (6,); raises ValueError."""
        matrix = as_transformation(transformation, "transformation")
        return np.array(self._raw.to_particle(matrix.reshape(16)), dtype=np.float64)

    @property
    def queries(self) -> int:
        """Look-ups of ``evaluate_alpha`` and ``complement`` on this problem so far."""
        if self._holder == threading.get_ident():  # asked from a callback, between iterations
            return self._raw.queries()
        with self._alone():
            return self._raw.queries()

    @contextmanager
    def _alone(self) -> Iterator[None]:
        # The C library wants one thread at a time on a problem. A callback that calls back
        # into its own problem would wait for itself for ever.
        if self._holder == threading.get_ident():
            raise RuntimeError("this Problem is being solved by the caller of this callback")
        with self._lock:
            self._holder = threading.get_ident()
            try:
                yield
            finally:
                self._holder = None

    def _array(self, name: str) -> NDArray[Any]:
        return np.asarray(self._raw.array(name))

    def _describe(self) -> dict[str, Any]:
        return self._raw.describe()
