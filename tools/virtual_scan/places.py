"""Places to scan, in meters: two furnished rooms, a street, and a table with things on it."""

from __future__ import annotations

from .solids import Ball, Box, Cylinder, Solid


def living_room() -> list[Solid]:
    """5.4 x 4.2 x 2.6 m around the origin of the floor."""
    shelves: list[Solid] = [
        Box((-2.5, -0.9 + 0.55 * i, 0.0), (0.35, 0.5, 0.7 + 0.45 * i)) for i in range(4)
    ]
    return [
        Box((0.0, 0.0, 0.0), (5.4, 4.2, 2.6)),
        *shelves,
        Box((1.7, 1.6, 0.0), (1.9, 0.85, 0.42), 4.0),  # sofa: seat and back
        Box((1.68, 1.95, 0.42), (1.9, 0.22, 0.4), 4.0),
        Box((0.5, 0.2, 0.36), (1.1, 0.6, 0.06), 25.0),  # low table on two feet
        Box((0.2, 0.06, 0.0), (0.08, 0.5, 0.36), 25.0),
        Box((0.8, 0.34, 0.0), (0.08, 0.5, 0.36), 25.0),
        Ball((0.62, 0.3, 0.53), 0.11),
        Cylinder((-2.2, 1.6, 0.0), 0.04, 1.55),  # lamp
        Ball((-2.2, 1.6, 1.65), 0.2),
        Box((2.55, -1.2, 0.0), (0.28, 1.3, 1.1)),  # cupboard, and what is on it
        Cylinder((2.5, -1.5, 1.1), 0.09, 0.3),
        Box((2.5, -0.85, 1.1), (0.2, 0.35, 0.22), 15.0),
        Box((-0.9, -1.98, 0.0), (0.95, 0.24, 2.05)),  # door frame
        Box((1.1, -1.75, 0.0), (0.45, 0.45, 0.46), 30.0),  # chair
        Box((1.23, -1.93, 0.46), (0.42, 0.06, 0.45), 30.0),
        Box((0.4, 2.02, 0.95), (1.5, 0.16, 1.15)),  # window frame
        Box((-1.2, 1.75, 0.0), (0.5, 0.6, 0.75), -12.0),
    ]


def office() -> list[Solid]:
    """Another room of the same size with other things in it."""
    return [
        Box((0.0, 0.0, 0.0), (5.4, 4.2, 2.6)),
        Box((-1.4, 1.55, 0.70), (1.6, 0.8, 0.04)),  # two desks
        Box((-2.1, 1.55, 0.0), (0.06, 0.75, 0.70)),
        Box((-0.75, 1.55, 0.0), (0.4, 0.7, 0.70)),
        Box((-1.5, 1.75, 0.74), (0.55, 0.08, 0.42), 10.0),
        Box((1.9, -1.3, 0.70), (1.4, 0.75, 0.04), 90.0),
        Box((1.9, -1.85, 0.0), (0.7, 0.06, 0.70)),
        Box((2.1, -1.2, 0.74), (0.08, 0.5, 0.36), -15.0),
        Cylinder((-1.2, 0.75, 0.0), 0.25, 0.48),  # stools
        Cylinder((1.1, -1.0, 0.0), 0.22, 0.46),
        Cylinder((2.35, 1.75, 0.0), 0.18, 2.6),  # column
        Box((-2.45, -1.1, 0.0), (0.4, 1.2, 1.9)),
        Box((0.6, 1.95, 0.0), (0.9, 0.2, 1.3)),
        Ball((0.75, 1.9, 1.42), 0.12),
        Box((-0.3, -1.9, 0.8), (1.8, 0.1, 1.0)),
    ]


def street() -> list[Solid]:
    """A street along x, 120 m long: ground, kerbs, houses, cars, poles and trees."""
    solids: list[Solid] = [
        Box((0.0, 0.0, -1.0), (200.0, 80.0, 1.0)),
        Box((0.0, 5.6, 0.0), (120.0, 2.2, 0.15)),
        Box((0.0, -5.9, 0.0), (120.0, 2.8, 0.15)),
    ]
    for x, depth, width, height, yaw in (
        (-48, 9, 13, 7, 0), (-31, 8, 11, 9, 2), (-16, 11, 12, 6, 0), (3, 9.5, 14, 11, -1),
        (21, 8.5, 9, 5, 3), (38, 12, 12, 8, 0),
    ):  # fmt: skip
        solids.append(Box((x, 7.5 + depth / 2, 0.0), (width, depth, height), yaw))
        solids.append(Box((x - 0.3 * width, 7.2, 0.0), (1.6, 1.0, 2.4), yaw))
    for x, depth, width, height, yaw in (
        (-44, 10, 15, 8, 0), (-22, 9, 10, 12, -2), (-4, 12, 13, 6, 0), (15, 8, 12, 9, 4),
        (44, 9, 16, 7, 0),
    ):  # fmt: skip
        solids.append(Box((x, -8.2 - depth / 2, 0.0), (width, depth, height), yaw))
    for x, y, yaw in (
        (-33, 3.5, 2), (-21, -3.6, -1), (-12, 3.4, 1), (-3, -3.7, 3), (5, 3.6, -2), (17, 3.5, 0),
        (26, -3.5, 2), (41, 3.6, 1),
    ):  # fmt: skip
        solids.append(Box((x, y, 0.25), (4.3, 1.75, 0.65), yaw))
        solids.append(Box((x - 0.25, y, 0.9), (2.2, 1.6, 0.55), yaw))
    for x, y in ((-37, 5.2), (-8, 5.1), (12, 5.2), (33, 5.0), (-27, -5.2), (8, -5.3)):
        solids.append(Cylinder((x, y, 0.0), 0.09, 6.0))
    for x, y, crown in ((-40, -5.4, 1.6), (-14, -5.5, 2.0), (22, -5.4, 1.4), (28, 5.3, 1.8)):
        solids += [Cylinder((x, y, 0.0), 0.18, 3.0), Ball((x, y, 3.0 + 0.8 * crown), crown)]
    return solids


def table_top() -> list[Solid]:
    """Things on a table of 0.8 x 0.6 m whose top is at z = 0."""
    return [
        Box((0.04, 0.02, -0.03), (0.8, 0.6, 0.03), 8.0),
        Box((-0.18, 0.10, 0.0), (0.24, 0.16, 0.05), 20.0),
        Box((-0.17, 0.11, 0.05), (0.20, 0.13, 0.035), 34.0),
        Cylinder((0.12, 0.16, 0.0), 0.045, 0.19),
        Ball((0.12, 0.16, 0.21), 0.05),
        Box((0.19, -0.10, 0.0), (0.10, 0.22, 0.13), -28.0),
        Ball((-0.05, -0.16, 0.06), 0.06),
        Cylinder((-0.24, -0.14, 0.0), 0.06, 0.08),
        Box((0.03, 0.00, 0.0), (0.07, 0.07, 0.10), 40.0),
    ]
