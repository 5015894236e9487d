"""Where the time goes: stages, number of points, queries, instructions."""

from __future__ import annotations

from typing import Any

from ..peers.summary import quartiles as quartiles_of
from .markdown import number, quartiles, table

_LIMITS = (
    "The physical limits, one thread: work that can be counted, the least milliseconds that this "
    "machine could need for it, and those of the stage that does it, with all else that it does. "
    "Least: reading the bytes once; the products of all pairs of descriptors by numpy's BLAS in "
    "single precision; one read at a random place of a table of 1 MB for each nearest neighbor."
)
_LIMIT_HEADS = ("preset", "work", "amount", "stage", "least, ms", "reached, ms",
                "reached / least")  # fmt: skip


def stages_section(value: dict[str, Any]) -> str:
    source, target = value["points"]
    names = list(value["profiles"][0]["seconds"])
    rows = [
        [f"`{p['preset']}`", str(p["threads"])]
        + [number(1e3 * p["seconds"][name]["median"], 1) for name in names]
        for p in value["profiles"]
    ]
    parts = [
        f"The generated pair, {source} and {target} points, kernel {value['kernel']}; milliseconds "
        f"of wall time, medians of {value['repetitions']}.",
        table(["preset", "threads", *names], rows),
        "The evolution by the candidate grid (`neighbors=grid`) and by pcl::KdTreeFLANN "
        f"(`neighbors=kdtree`), {value['slow_repetitions']} repetitions; seconds.",
        table(
            ["preset", "threads", "grid", "kdtree", "ratio", "result"],
            [
                [f"`{row['preset']}`", str(row["threads"]), quartiles(row["evolution"]["grid"]),
                 quartiles(row["evolution"]["kdtree"]), number(row["ratio"], 1),
                 "the same bits" if row["same_bits"] else "**not the same bits**"]
                for row in value["structures"]
            ],
        ),
        _LIMITS,
        table(_LIMIT_HEADS, [row for found in value["limits"] for row in _limits(found)]),
    ]  # fmt: skip
    return "\n\n".join(parts)


def _limits(found: dict[str, Any]) -> list[list[str]]:
    rows = [
        [f"`{found['preset']}`", row["kind"], f"{row['amount']:,}", row["stage"],
         number(1e3 * row["least"], 2), number(1e3 * row["reached"], 2),
         number(row["reached"] / row["least"], 1)]
        for row in found["rows"]
    ]  # fmt: skip
    least, total = sum(row["least"] for row in found["rows"]), found["total"]
    rows.append([f"`{found['preset']}`", "all of these", "", "the whole", number(1e3 * least, 2),
                 number(1e3 * total, 2), number(total / least, 1)])  # fmt: skip
    return rows


def scaling_section(value: dict[str, Any], plot: str) -> str:
    sizes = value["sizes"]
    names = list(sizes[0]["stages"])
    rows = [
        [f"{size['points']:,}"]
        + [number(1e3 * size["stages"][name], 1) for name in names]
        + [number(size["seconds"], 3), number(size["peak_bytes"] / 1e6, 0),
           number(size["memory_over_input"], 2), number(size["E_R"], 2)]
        for size in sizes
    ]  # fmt: skip
    heads = ["points a cloud", *(f"{name}, ms" for name in names), "seconds", "peak, MB",
             "peak / input", "E_R"]  # fmt: skip
    slope = value["slope"]
    text = (
        ""
        if slope is None
        else (
            f"\n\nFrom {value['slope_from']:,} points on the time grows as their power {slope:.2f}."
        )
    )
    return (
        f"![time and memory against the number of points]({plot})\n\n" + table(heads, rows) + text
    )


def neighbors_section(value: dict[str, Any]) -> str:
    """Names are structure/poses/points, or structure/make/points; more than one repetition
    becomes its median."""
    parts = []
    for text, counter in (
        ("Nanoseconds for a nearest-neighbor query, one thread.", "query"),
        ("Nanoseconds a point to make the structure, one thread.", "a_point"),
    ):
        chosen = [b for b in value["benchmarks"] if b["run_type"] == "iteration" and counter in b]
        if chosen:
            parts.append(text + "\n\n" + _by_structure(chosen, counter))
    return "\n\n".join(parts)


def _by_structure(benchmarks: list[dict[str, Any]], counter: str) -> str:
    found: dict[str, dict[str, list[float]]] = {}
    for benchmark in benchmarks:
        structure, case = benchmark["run_name"].split("/", 1)
        seconds = found.setdefault(case, {}).setdefault(structure, [])
        seconds.append(1e9 * benchmark[counter])
    structures = list(dict.fromkeys(name for case in found.values() for name in case))
    rows = []
    for case, by_structure in found.items():
        poses, points = case.split("/")
        cells = [number(quartiles_of(by_structure[name]).median, 1) if name in by_structure else ""
                 for name in structures]  # fmt: skip
        rows.append([points, poses, *cells])
    return table(["points", "poses", *structures], rows)


def regress_section(value: dict[str, Any]) -> str:
    made = ", ".join(f"{name} {version}" for name, version in value["toolchain"].items())
    rows = []
    for program, count in value["programs"].items():
        rows.append([f"**{program}**", number(count["instructions"] / 1e6, 1)])
        rows += [[f"`{name}`", number(instructions / 1e6, 1)]
                 for name, instructions in list(count["functions"].items())[:12]]  # fmt: skip
    return (
        f"Millions of instructions, one thread; functions with what they call. Made with {made}."
        "\n\n" + table(["program", "instructions"], rows)
    )
