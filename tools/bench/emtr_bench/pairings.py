"""Scans that do not belong together, chosen and laid upon each other."""

from __future__ import annotations

import itertools
import re
import zlib
from dataclasses import dataclass

import numpy as np

from . import protocol
from .pairs import FILES, Array, Pair, read_ply


@dataclass(frozen=True)
class Pairing:
    """The source of one pair and the target of another, of another object; or a pair of which it is
    known that its scans do not belong together."""

    index: int
    source: Pair
    target: Pair

    @property
    def name(self) -> str:
        if self.source == self.target:
            return self.source.name
        return f"{self.source.name} + {self.target.name}"


def given(pairs: list[Pair]) -> list[Pairing]:
    """Those pairs whose scans do not belong together."""
    apart = [pair for pair in pairs if not pair.related]
    return [Pairing(index, pair, pair) for index, pair in enumerate(apart)]


def choose(pairs: list[Pair], count: int) -> list[Pairing]:
    """So many pairings, or all that there are, in an order that mixes the groups and is always the
    same for the same pairs. Pairs belong apart when their names share no word."""
    apart = [(a, b) for a, b in itertools.permutations(pairs, 2) if not _words(a) & _words(b)]
    apart.sort(key=lambda both: zlib.crc32(f"{both[0].name} {both[1].name}".encode()))
    return [Pairing(index, a, b) for index, (a, b) in enumerate(apart[:count])]


def clouds(pairing: Pairing) -> tuple[Array, Array]:
    """The source made as large as the target, for the unit alone would tell them apart, laid upon
    it and moved by one motion of the protocol."""
    source = read_ply(pairing.source.folder / FILES[0])
    target = read_ply(pairing.target.folder / FILES[1])
    source = source - source.mean(axis=0)
    center = target.mean(axis=0)
    radii = [float(np.linalg.norm(cloud, axis=1).max()) for cloud in (source, target - center)]
    aligned = source * (radii[1] / radii[0]) + center
    motion = protocol.motion(pairing.name, pairing.index, aligned)
    return protocol.apply(motion.matrix, aligned), target


def _words(pair: Pair) -> set[str]:
    """Those of the object among them; two letters and less are noise levels and the like."""
    return set(re.findall("[a-z]{3,}", pair.name))
