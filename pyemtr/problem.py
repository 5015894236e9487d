"""A preprocessed pair of clouds, for callers who run the stages one by one."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _emtr
from .alternative import Alternative
from .arrays import Floats, as_particles, as_poses, as_transformation, as_vector
from .inputs import Inputs
from .mesh import MESH_POINTS
from .progress import Callback, as_raw_callback
from .result import Result, as_alternative, make_result
from .views import ProblemViews

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .setting_types import MethodSettings


class Problem(ProblemViews):
    """Two clouds normalized, downsampled, described by features and matched.

    A particle of task alpha is (theta1, theta2, theta3, tx, ty, tz), one of task beta (theta1,
    theta2, theta3). Angles are in radians, any real number, R = Rz(theta1) Ry(theta2) Rx(theta3).
    The translation is in the normalized frame, p' = (p - center) / normalization_scale.

    Threads may share one Problem; its methods run one at a time.

    Arguments and errors are those of :func:`pyemtr.register`.
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
        source_colors: Any = None,
        target_colors: Any = None,
        source_intensity: Any = None,
        target_intensity: Any = None,
        correspondences: Any = None,
        mesh_points: int = MESH_POINTS,
        **settings: Unpack[MethodSettings],
    ) -> None:
        inputs = Inputs.among(locals())
        chosen = inputs.settings(settings)
        self.settings: dict[str, Any] = inputs.used(chosen)
        self._raw = _emtr.Problem(*inputs.clouds(source, target), chosen)
        self._lock = threading.Lock()
        self._holder: int | None = None

    def solve(self, callback: Callback | None = None, *, poses: Any = None) -> Result:
        """Runs the stages from the evolution to the verdict.

        Args:
            callback: as in :func:`pyemtr.register`.
            poses: poses that another optimizer found, as :meth:`score` takes them; they take the
                place of the swarms, which then do not run. The best of them are candidates beside
                the guess and the seeds. A problem made with ``seeds=0, fallback_search="off"``
                judges them alone, but for their rivals by symmetry.

        Returns:
            A :class:`pyemtr.Result`; without ``poses`` it has the same bits as
            :func:`pyemtr.register` with ``coarse_points=0``. The errors are as there.
        """
        raw_callback = as_raw_callback(callback, self.settings)
        matrices = None if poses is None else as_poses(poses)[0]
        with self._alone():
            if matrices is None:
                raw = self._raw.solve(raw_callback)
            else:
                raw = self._raw.solve_from(matrices, raw_callback)
        return make_result(raw, dict(self.settings))

    def score(self, poses: Any) -> list[Alternative]:
        """Scores poses as candidates are scored, each where it is: nothing is refined.

        Args:
            poses: matrices (P, 4, 4) or one (4, 4), source into target, in the clouds' unit; or
                results or alternatives.

        Returns:
            A :class:`pyemtr.Alternative` for each, in their order.

        Raises:
            TypeError, ValueError: not such matrices, or not rigid; a problem without candidates.
        """
        with self._alone():
            return [as_alternative(values) for values in self._raw.score(as_poses(poses)[0])]

    def rank(self, poses: Any) -> list[Alternative]:
        """Returns what :meth:`score` does, the best first."""
        return sorted(self.score(poses), key=lambda pose: -pose.score)

    def refine(self, poses: Any) -> Floats:
        """Refines poses on the fine clouds, as the answer of a registration is refined.

        Takes what :meth:`score` takes, and raises as it does. Returns float64 (P, 4, 4), or (4, 4)
        for one pose. A pose that cannot be refined, because too few points are near, stays.
        """
        matrices, shape = as_poses(poses)
        refined = np.empty_like(matrices)
        with self._alone():
            self._raw.refine(matrices, refined)
        return refined.reshape(*shape, 4, 4)

    def evaluate_alpha(self, particles: Any, resolution: str = "dense") -> Floats:
        """Returns the fitness of task alpha for particles (P, 6): float64 (P,), lower is better.
        For one particle (6,) it is one float64.

        ``resolution`` is "sparse" or "dense". The nearest-neighbor queries are counted in
        ``queries``. Raises TypeError or ValueError for other shapes, types, or numbers that are
        not finite.
        """
        if resolution not in ("sparse", "dense"):
            raise ValueError(f'resolution: expected "sparse" or "dense", got {resolution!r}')
        genes, shape = as_particles(particles, 6)
        fitness = np.empty(len(genes), dtype=np.float64)
        with self._alone():
            self._raw.evaluate_alpha(resolution == "dense", genes, fitness)
        return fitness.reshape(shape)[()]

    def evaluate_beta(self, particles: Any) -> Floats:
        """Returns the fitness of task beta for particles (P, 3): float64 (P,), lower is better.
        For one particle (3,) it is one float64.

        Raises as :meth:`evaluate_alpha`.
        """
        genes, shape = as_particles(particles, 3)
        fitness = np.empty(len(genes), dtype=np.float64)
        with self._alone():
            self._raw.evaluate_beta(genes, fitness)
        return fitness.reshape(shape)[()]

    def complement(self, angles: Any) -> Floats:
        """Returns the translation (3,), normalized frame, that completes angles (3,): Algorithm 2.

        With priors it completes the nearest admissible rotation to an admissible pose. Raises
        TypeError or ValueError for another shape or type, or numbers that are not finite.
        """
        a, b, c = as_vector(angles, "angles", 3).tolist()
        with self._alone():
            return np.array(self._raw.complement(a, b, c), dtype=np.float64)

    def to_transformation(self, particle: Any) -> Floats:
        """Returns a particle (6,) as a float64 matrix (4, 4), source into target, clouds' unit.

        Raises TypeError or ValueError for another shape or type, or numbers that are not finite.
        """
        values = self._raw.to_transformation(as_vector(particle, "particle", 6))
        return np.array(values, dtype=np.float64).reshape(4, 4)

    def to_particle(self, transformation: Any) -> Floats:
        """Returns a rigid matrix (4, 4), source into target, as a particle (6,), float64.

        Raises TypeError or ValueError when the matrix is not (4, 4), finite and rigid.
        """
        matrix = as_transformation(transformation, "transformation")
        return np.array(self._raw.to_particle(matrix.reshape(16)), dtype=np.float64)

    @property
    def queries(self) -> int:
        """Nearest-neighbor queries of ``evaluate_alpha`` and ``complement`` so far."""
        if self._holder == threading.get_ident():  # called from a callback, between iterations
            return self._raw.queries()
        with self._alone():
            return self._raw.queries()

    @contextmanager
    def _alone(self) -> Iterator[None]:
        # The C library allows one thread at a time on a problem. A callback that calls its own
        # problem would wait for itself forever.
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
