"""Scans that do not belong together, chosen and laid upon each other."""

from __future__ import annotations

import itertools
import re
import zlib
from dataclasses import dataclass

import numpy as np

from . import protocol
from .pairs import Array, DataError, Pair, load


@dataclass(frozen=True)
class Pairing:
    """The source of one pair and the target of another, of another object."""

    index: int
    source: Pair
    target: Pair

    @property
    def name(self) -> str:
        return f"{self.source.name} + {self.target.name}"


def choose(pairs: list[Pair], count: int) -> list[Pairing]:
    """So many pairings, always the same of the same pairs, in an order that mixes the groups.

    Pairs belong apart when their names share no word. Raises DataError for too few pairings.
    """
    apart = [(a, b) for a, b in itertools.permutations(pairs, 2) if not _words(a) & _words(b)]
    apart.sort(key=lambda both: zlib.crc32(f"{both[0].name} {both[1].name}".encode()))
    if len(apart) < count:
        raise DataError(
            f"--unrelated {count}: the chosen pairs make {len(apart)} pairings of scans that do "
            "not belong together; choose more by --tier"
        )
    return [Pairing(index, a, b) for index, (a, b) in enumerate(apart[:count])]


def clouds(pairing: Pairing) -> tuple[Array, Array]:
    """The source made as large as the target, for the unit alone would tell them apart, laid upon
    it and moved by one motion of the protocol."""
    source, target = load(pairing.source).source, load(pairing.target).target
    source = source - source.mean(axis=0)
    center = target.mean(axis=0)
    radii = [float(np.linalg.norm(cloud, axis=1).max()) for cloud in (source, target - center)]
    aligned = source * (radii[1] / radii[0]) + center
    motion = protocol.motion(pairing.name, pairing.index, aligned)
    return protocol.apply(motion.matrix, aligned), target


def _words(pair: Pair) -> set[str]:
    """Those of the object among them; two letters and less are noise levels and the like."""
    return set(re.findall("[a-z]{3,}", pair.name))
