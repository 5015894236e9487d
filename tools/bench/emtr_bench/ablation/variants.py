"""The variants that are compared, and their settings."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # the command line is read before it is known that numpy is there
    from ..runner import Setting


@dataclass(frozen=True)
class Variant:
    """One row: the preset, but for these settings."""

    block: str
    part: str  # that is changed; "nothing" for the block's own reference
    settings: dict[str, Setting] = field(default_factory=dict)


WHOLE, SWARM = "whole", "without seeds"
_NO_SEEDS: dict[str, Setting] = {"seeds": 0, "injected_seeds": 0}
#: An fallback_search makes seeds of its own.
_SWARM: dict[str, Setting] = {**_NO_SEEDS, "fallback_search": "off"}
_ANGLES: dict[str, Setting] = {"rotation_vector_steps": "off", "arc_transfer": "off"}
#: Swarms with seeds go by Euler angles unless told otherwise.
_NO_ANGLES: dict[str, Setting] = {"rotation_vector_steps": "always", "arc_transfer": "always"}

VARIANTS = (
    Variant(WHOLE, "nothing"),
    Variant(WHOLE, "coarse search", {"coarse_points": 0}),
    Variant(WHOLE, "seeds", _NO_SEEDS),
    Variant(WHOLE, "injected seeds", {"injected_seeds": 0}),
    Variant(WHOLE, "transfer", {"transfer": 0}),
    Variant(WHOLE, "complement", {"complement": 0}),
    Variant(WHOLE, "sparse to dense", {"sparse_to_dense": 0}),
    Variant(WHOLE, "angles (vectors and arcs instead)", _NO_ANGLES),
    Variant(WHOLE, "evolution (1 iteration)", {"iterations": 1}),
    Variant(WHOLE, "candidates", {"candidates": 0}),
    Variant(WHOLE, "free space", {"free_space": 0}),
    Variant(WHOLE, "distinctiveness", {"distinctiveness": 0}),
    Variant(WHOLE, "rivals", {"rivals": 0}),
    Variant(WHOLE, "plane-aligned poses", {"plane_aligned_poses": 0}),
    Variant(WHOLE, "parts", {"parts": 0}),
    Variant(WHOLE, "fallback_search", {"fallback_search": "off"}),
    Variant(WHOLE, "refinement", {"refine": 0}),
    Variant(SWARM, "nothing", _SWARM),
    Variant(SWARM, "transfer", {**_SWARM, "transfer": 0}),
    Variant(SWARM, "complement", {**_SWARM, "complement": 0}),
    Variant(SWARM, "sparse to dense", {**_SWARM, "sparse_to_dense": 0}),
    Variant(SWARM, "rotation vectors", {**_SWARM, "rotation_vector_steps": "off"}),
    Variant(SWARM, "shortest arc", {**_SWARM, "arc_transfer": "off"}),
    Variant(SWARM, "both (angles instead)", {**_SWARM, **_ANGLES}),
    Variant(SWARM, "evolution (1 iteration)", {**_SWARM, "iterations": 1}),
    Variant(SWARM, "nothing, 100 iterations", {**_SWARM, "iterations": 100}),
)
