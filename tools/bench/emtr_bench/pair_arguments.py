"""The options that say which pairs of clouds; every benchmark that registers pairs has them."""

from __future__ import annotations

import argparse

#: What the help of each of these programs ends with.
WHERE = """The pairs are those of --data, else of the environment variable EMTR_DATA, else ten
generated ones, made once in build/virtual_pairs. docs/BENCHMARKING.md says how to lay out pairs of
your own."""


#: The same of a program that runs on something of its own unless it is told of pairs.
WHERE_ELSE = """With --data, --tier or --pair it runs on pairs of clouds: those of --data, else of
the environment variable EMTR_DATA, else ten generated ones. docs/BENCHMARKING.md says how to lay
out your own."""


def add_pair_options(parser: argparse.ArgumentParser, tier: str) -> None:
    """Adds --data, --tier and --pair; `tier` is the one by default, where there is such a tier."""
    default = "all" if tier == "all" else f"{tier}, or all where there is no such tier"
    parser.set_defaults(default_tier=tier)
    add = parser.add_argument
    add("--data", metavar="DIR", help="folder of pairs (default: EMTR_DATA, else generated pairs)")
    add("--tier", action="append", nargs="+", metavar="TIER",
        help=f"tiers, or all (default: {default})")  # fmt: skip
    add("--pair", action="append", nargs="+", metavar="NAME", help="these pairs, whatever tier")


def asks_for_pairs(arguments: argparse.Namespace) -> bool:
    """Tells whether one of the options was given."""
    return bool(arguments.data or arguments.tier or arguments.pair)


def pair_words(arguments: argparse.Namespace) -> list[str]:
    """The same options as words, for a program that another one runs."""
    words = ["--data", arguments.data] if arguments.data else []
    for option in ("tier", "pair"):
        for group in getattr(arguments, option) or []:
            words += [f"--{option}", *group]
    return words
