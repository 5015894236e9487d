"""The arguments that :func:`pyemtr.register` and :class:`pyemtr.Problem` share."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

from . import _emtr
from .arrays import as_bounds, as_correspondences, as_transformation, as_vector
from .cloud import Beside, as_cloud
from .mesh import MESH_POINTS, as_mesh_points
from .options import make_settings, settings_used


@dataclass(frozen=True)
class Inputs:
    """Keyword arguments as the user wrote them; :func:`pyemtr.register` says what each means.

    The signatures of both callables repeat these names and defaults, for ``help()`` and type
    checkers; a test compares them.
    """

    seed: int = 0
    threads: int = 0
    preset: str = "default"
    guess: Any = None
    source_viewpoint: Any = None
    target_viewpoint: Any = None
    axis: Any = None
    translation_bounds: Any = None
    source_normals: Any = None
    target_normals: Any = None
    source_features: Any = None
    target_features: Any = None
    source_colors: Any = None
    target_colors: Any = None
    source_intensity: Any = None
    target_intensity: Any = None
    correspondences: Any = None
    mesh_points: int = MESH_POINTS

    @classmethod
    def among(cls, arguments: Mapping[str, Any]) -> Inputs:
        """Returns the inputs among a callable's arguments, which are its ``locals()`` at first."""
        return cls(**{field.name: arguments[field.name] for field in fields(cls)})

    def settings(self, changes: Mapping[str, Any]) -> _emtr.Settings:
        """Returns the preset with the changes, the priors and the correspondences.

        Raises:
            TypeError: an unknown setting (close names are listed), or a value of a wrong type.
            ValueError: a value out of range, an unknown preset, or an argument of a wrong shape or
                with a NaN or an infinity.
        """
        names = [field.name for field in fields(self)]
        chosen = make_settings(
            self.preset, changes, seed=self.seed, threads=self.threads, arguments=names
        )
        if self.guess is not None:
            chosen.guess = as_transformation(self.guess, "guess").reshape(16)
        if self.source_viewpoint is not None:
            chosen.viewpoint_source = as_vector(self.source_viewpoint, "source_viewpoint", 3)
        if self.target_viewpoint is not None:
            chosen.viewpoint_target = as_vector(self.target_viewpoint, "target_viewpoint", 3)
        if self.axis is not None:
            chosen.axis = as_vector(self.axis, "axis", 3)
        if self.translation_bounds is not None:
            chosen.translation_bounds = as_bounds(self.translation_bounds, "translation_bounds")
        if self.correspondences is not None:
            chosen.correspondences = as_correspondences(self.correspondences)
        return chosen

    def clouds(
        self, source: Any, target: Any
    ) -> tuple[_emtr.CloudBuffer | _emtr.Preprocessed, _emtr.CloudBuffer | _emtr.Preprocessed]:
        """Returns both clouds with what the user provided beside them, as the C library reads them.

        Correspondences refer to rows of all points, so all points are kept when there are any.
        Raises as :class:`pyemtr.Cloud`.
        """
        keep = self.correspondences is not None
        count = as_mesh_points(self.mesh_points)
        beside_source = Beside(
            self.source_normals, self.source_features, self.source_colors, self.source_intensity
        )
        beside_target = Beside(
            self.target_normals, self.target_features, self.target_colors, self.target_intensity
        )
        return (
            as_cloud(source, "source", beside_source, keep, count),
            as_cloud(target, "target", beside_target, keep, count),
        )

    def used(self, chosen: _emtr.Settings) -> dict[str, Any]:
        """Returns all that repeats the run on the same clouds, as keyword arguments."""
        return {**settings_used(chosen), "mesh_points": as_mesh_points(self.mesh_points)}
