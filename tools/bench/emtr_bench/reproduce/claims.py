"""The paper's claims as tests over the runs."""

from __future__ import annotations

from collections.abc import Sequence

from evolving_methods.methods import METHODS

from . import plan
from .figures_of_runs import chosen, percent, success
from .run_log import Record
from .significance import Claim, Test, tested
from .table import Cell, Table
from .tables import TRADITIONAL

Records = Sequence[Record]


def by_pair(first: Records, second: Records) -> tuple[list[float], list[float]]:
    """Success in percent of both on each pair that both have."""
    names = [n for n in dict.fromkeys(r["pair"] for r in first)
             if any(r["pair"] == n for r in second)]  # fmt: skip
    ours, theirs = (
        [percent([r for r in runs if r["pair"] == name]) for name in names]
        for runs in (first, second)
    )
    return ours, theirs


def by_run(first: Records, second: Records, a: str = "E_R", b: str = "E_R"
           ) -> tuple[list[float], list[float]]:  # fmt: skip
    """A column of both on each run of which both succeed."""
    others = {(r["pair"], r["index"]): r for r in second if success(r)}
    both = [(r, others[r["pair"], r["index"]]) for r in first
            if success(r) and (r["pair"], r["index"]) in others]  # fmt: skip
    return [one[a] for one, _ in both], [other[b] for _, other in both]


def families(records: Records) -> dict[str, list[Test]]:
    """The tests of each table; Holm's correction is for one table at a time."""
    ours = chosen(records, "library", plan.OURS)
    alpha = chosen(records, "tasks", plan.PYTHON)
    families = {
        "success_ratio": [
            Claim(f"higher success than {m.name}, by pair",
                  *by_pair(ours, chosen(records, "evolving", m.name)), "greater")
            for m in METHODS
        ] + [
            Claim(f"higher success than {m.name}, which has as many evaluations, by pair",
                  *by_pair(ours, chosen(records, "evaluations", m.name)), "greater")
            for m in METHODS
        ],
        "errors_alpha_beta": [
            Claim("alpha's E_R is below beta's", *by_run(alpha, alpha, "E_R", "E_R_beta"), "less"),
            Claim("alpha's E_t is below beta's", *by_run(alpha, alpha, "E_t", "E_t_beta"), "less"),
        ],
        "errors_vs_traditional": [
            Claim(f"{column} below that of {name}, where both succeed",
                  *by_run(ours, chosen(records, "traditional", name), column, column), "less")
            for name in TRADITIONAL for column in ("E_R", "E_t")
        ],
        "sparse_to_dense": [
            Claim("E_R differs with and without sparse-to-dense",
                  *by_run(ours, chosen(records, "library", plan.DENSE_ONLY)), "two-sided"),
            Claim("success differs, by pair",
                  *by_pair(ours, chosen(records, "library", plan.DENSE_ONLY)), "two-sided"),
        ],
        "parts": [
            Claim(f"higher success than {name}, by pair",
                  *by_pair(ours, chosen(records, "library", name)), "greater")
            for name in (plan.NO_COMPLEMENT, plan.NO_TRANSFER)
        ],
        "presets": [
            Claim(f"E_R of {name} is below that of EMTR-SSC as published",
                  *by_run(chosen(records, "library", name), ours), "less")
            for name in (plan.DEFAULT, plan.FAST)
        ],
    }  # fmt: skip
    return {name: tests for name, claims in families.items() if (tests := tested(claims))}


def significance(records: Records) -> Table | None:
    found = families(records)
    if not found:
        return None
    table = Table(
        "significance", "Significance of the claims",
        ["table", "claim", "pairs of values", "median difference", "p (Holm)", "verdict"],
        notes=["Wilcoxon signed-rank tests of paired values, p corrected by Holm within a table; "
               "significant: p below 0.05."],
    )  # fmt: skip
    for family, tests in found.items():
        for test in tests:
            table.rows.append((family, [
                Cell(test.claim), Cell(str(test.count)), Cell(test.median_difference),
                Cell(f"{test.p:.2g}"), Cell(test.verdict)]))  # fmt: skip
    return table
