"""Paints of the held-out scenes: what repeats, and the few things on it that do not."""

from __future__ import annotations

import numpy as np

from .paint import Array, Generator, Paint


def mosaic(side: float, extent: float, rng: Generator) -> Paint:
    """Small square stones of a few colors, laid by chance, with joints."""
    count = int(np.ceil(2 * extent / side))
    palette = rng.uniform(0.1, 0.9, (rng.integers(3, 6), 3))
    stones = rng.integers(0, len(palette), (count, count))
    joint = 0.8 * palette.min(axis=0)

    def paint(places: Array) -> Array:
        cells = np.floor(places / side + count / 2).astype(int) % count
        out = palette[stones[cells[:, 0], cells[:, 1]]]
        out[(np.abs(places / side - np.round(places / side)) < 0.06).any(axis=1)] = joint
        return np.asarray(out)

    return paint


def wallpaper(rng: Generator) -> Paint:
    """One motif over and over, on stripes."""
    across, up = rng.uniform(0.25, 0.5, 2)
    ground, stripe, motif = rng.uniform(0.2, 0.95, (3, 3))
    petals, radius = rng.integers(3, 7), rng.uniform(0.06, 0.11)

    def paint(places: Array) -> Array:
        out = np.tile(ground, (len(places), 1))
        out[np.mod(places[:, 0] / across, 1) < 0.3] = stripe
        x = (np.mod(places[:, 0] / across, 1) - 0.65) * across
        y = (np.mod(places[:, 1] / up, 1) - 0.5) * up
        edge = radius * (1 + 0.3 * np.cos(petals * np.arctan2(y, x)))
        out[np.hypot(x, y) < edge] = motif
        return out

    return paint


def lamps(extent: float, rng: Generator) -> Paint:
    """A ceiling of panels; some of them are lamps, so bright that a camera is blinded."""
    side = rng.uniform(0.5, 0.7)
    count = int(np.ceil(2 * extent / side))
    lit = rng.random((count, count)) < 0.12
    panel, frame = rng.uniform(0.55, 0.75) * np.array([1.0, 0.99, 0.96]), np.full(3, 0.4)

    def paint(places: Array) -> Array:
        cells = np.floor(places / side + count / 2).astype(int) % count
        out = np.tile(panel, (len(places), 1))
        out[lit[cells[:, 0], cells[:, 1]]] = 1.6
        out[(np.abs(places / side - np.round(places / side)) < 0.03).any(axis=1)] = frame
        return out

    return paint


def lanes(extent: float, rng: Generator) -> Paint:
    """A road along x: mottled asphalt, dashes between the lanes, edge lines, and what there is
    once: patches, covers, arrows."""
    asphalt = cloudy(0.15, rng.uniform(0.2, 0.3), 0.04, rng)
    dash, begin = rng.uniform(1.5, 2.5), rng.uniform(0, 4)
    things = [
        (rng.uniform(-extent / 2, extent / 2, 2) * [1.0, 0.35], rng.uniform(0.15, 0.7, 2),
         rng.choice([0.1, 0.16, 0.4, 0.85]), rng.random() < 0.4)
        for _ in range(rng.integers(8, 16))
    ]  # fmt: skip

    def paint(places: Array) -> Array:
        out = asphalt(places)
        x, y = places.T
        for lane in (-1.6, 1.6):
            dashed = np.mod(x + begin + lane, 2 * dash) < dash
            out[(np.abs(y - lane) < 0.08) & dashed] = 0.85
        out[np.abs(np.abs(y) - 3.2) < 0.1] = 0.8
        for center, half, shade, is_round in things:
            local = (places - center) / half
            inside = np.hypot(*local.T) < 0.7 if is_round else (np.abs(local) < 1).all(axis=1)
            out[inside] = shade
        return out

    return paint


def facade(rng: Generator) -> Paint:
    """Windows in rows, each like the next, with curtains of a few kinds."""
    across, up = rng.uniform(0.9, 1.3), rng.uniform(0.9, 1.2)
    plaster, frame = rng.uniform(0.5, 0.9, 3), rng.uniform(0.2, 0.9, 3)
    kinds = rng.uniform(0.05, 0.6, (3, 3))
    curtains = rng.integers(0, 3, (32, 32))

    def paint(places: Array) -> Array:
        column, row = np.floor(places / [across, up]).astype(int).T
        u, v = (np.mod(places / [across, up], 1) - 0.5).T
        out = np.tile(plaster, (len(places), 1))
        out[(np.abs(u) < 0.32) & (np.abs(v) < 0.36)] = frame
        glass = (np.abs(u) < 0.27) & (np.abs(v) < 0.31)
        out[glass] = kinds[curtains[column % 32, row % 32]][glass]
        return out

    return paint


def cloudy(wave: float, shade: float, deviation: float, rng: Generator) -> Paint:
    """A gray or colored surface without edges: a sum of waves of any direction."""
    count = 40
    angles, phases = rng.uniform(0, 2 * np.pi, (2, count))
    lengths = wave * np.exp(rng.uniform(0, 2.5, count))
    ways = np.column_stack([np.cos(angles), np.sin(angles)]) * 2 * np.pi / lengths[:, None]
    tints = rng.normal(size=(count, 1)) + 0.3 * rng.normal(size=(count, 3))
    tints *= deviation * np.sqrt(2 / count)

    def paint(places: Array) -> Array:
        return np.asarray(shade + np.sin(places @ ways.T + phases) @ tints)

    return paint


def with_pictures(ground: Paint, width: float, height: float, count: int, rng: Generator) -> Paint:
    """Framed pictures on it, each a few waves of color of its own."""
    pictures = []
    for _ in range(count):
        half = rng.uniform(0.2, 0.5, 2)
        center = rng.uniform([-width / 2, -height / 2], [width / 2, height / 2])
        inside = cloudy(rng.uniform(0.08, 0.2), rng.uniform(0.3, 0.7), 0.25, rng)
        pictures.append((center, half, rng.uniform(0, 1, 3), inside))

    def paint(places: Array) -> Array:
        out = ground(places)
        for center, half, frame, inside in pictures:
            reach = np.abs(places - center) / half
            out[(reach < 1).all(axis=1)] = frame
            within = (reach < 0.85).all(axis=1)
            out[within] = inside(places[within])
        return out

    return paint


def label(half: Array, rng: Generator) -> Paint:
    """Cardboard with a label: a logo, lines of text and a bar code."""
    cardboard = rng.uniform(0.5, 0.7) * np.array([1.0, 0.8, 0.6])
    center, size = rng.uniform(-0.35, 0.35, 2) * half, rng.uniform(0.35, 0.6, 2) * half
    paper, ink, logo = rng.uniform(0.8, 1.0, 3), rng.uniform(0, 0.25, 3), rng.uniform(0, 1, 3)
    lines = rng.uniform(0.3, 0.95, 6)
    bars = rng.random(24) < 0.5

    def paint(places: Array) -> Array:
        u, v = ((places - center) / size).T
        out = np.tile(cardboard, (len(places), 1))
        on = (np.abs(u) < 1) & (np.abs(v) < 1)
        out[on] = paper
        row = np.clip(((v + 1) * 4).astype(int), 0, 7)
        text = on & (row < 6) & (np.mod((v + 1) * 4, 1) < 0.5)
        out[text & (u < -0.9 + 1.8 * lines[np.minimum(row, 5)])] = ink
        code = on & (row >= 6) & (u < 0.5)
        out[code & bars[np.clip(((u + 1) * 16).astype(int), 0, 23)]] = ink
        out[on & (np.hypot(u - 0.6, v - 0.6) < 0.3)] = logo
        return out

    return paint
