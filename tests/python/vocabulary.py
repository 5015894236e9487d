"""The words that the project does not use, and how to find them in names and prose.

Each rule has the old word, the field's word for it, and a pattern. Patterns are matched on lines
whose names are taken apart: `kModeGap` is `k_Mode_Gap`. Letters count as parts of a word there and
underscores do not, so `handed` is found in `handed_rows` and `HandedRows` too. Upper and lower case
are the same.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from fnmatch import fnmatch
from functools import cache, cached_property
from pathlib import Path


@dataclass(frozen=True)
class Rule:
    old: str
    new: str
    pattern: str
    where: str = "*"  # of the file's path from the root
    match_case: bool = False

    @cached_property
    def expression(self) -> re.Pattern[str]:
        flags = re.MULTILINE if self.match_case else re.MULTILINE | re.IGNORECASE
        return re.compile(rf"(?<![A-Za-z])(?:{self.pattern})(?![A-Za-z])", flags)

    def found(self, line: str) -> bool:
        return self.expression.search(line) is not None


@dataclass(frozen=True)
class Exception_:
    """Lines where a word of the left column has its ordinary sense, or is quoted for a reason."""

    path: str
    pattern: str
    reason: str

    def covers(self, path: str, line: str) -> bool:
        return fnmatch(path, self.path) and re.search(self.pattern, line) is not None


@dataclass(frozen=True)
class Finding:
    path: str
    number: int  # 0: the path itself
    rule: Rule
    line: str

    def __str__(self) -> str:
        return f"{self.path}:{self.number}: {self.rule.old} -> {self.rule.new}: {self.line.strip()}"


POSES = "poses?|seeds?|candidates?|hypothes[ie]s|particles?"
ENGINE = "libemtr/src/*"

RULES = [
    Rule("handed (in)", "user-provided, user",
         r"(?<!right-)(?<!left-)handed(?! (?:out|down|over|back|on|to))|hand(?:s|ing)?[ _]in"),
    Rule("make ready, prepare", "preprocess",
         r"(?:make|makes|making|made)(?: \w+){0,3} ready|prepar(?:e|es|ed|ing|ation|ations)"),
    Rule("frame (the step)", "normalization",
         r"""["'`.]frame["'`]?(?=[^\w ]|$)|frame/\w+|frame\.(?:h|cpp)|seconds_frame|make_frame|"""
         r"Framed?(?=[ &*>{;(]+(?:frame|make|const|\w+_? ?[;={(]))|struct Frame|class Frame"),
    Rule("densities", "downsampled clouds, downsampling", r"densit(?:y|ies)"),
    Rule("described points", "keypoints",
         r"described[ _]+points?|\.described|size_t described|def described"),
    Rule("look-up", "nearest-neighbor query", r"look(?:s|ed|ing)?[ _-]?ups?"),
    Rule("partner", "correspondence", r"partners?"),
    Rule("polish", "local refinement", r"polish(?:es|ed|ing)?"),
    Rule("standing, stand, doubted", "confidence, estimate_confidence, lower_confidence",
         r"standings?|stand(?=\()|doubted"),
    Rule("agreement", "overlap", r"agreements?"),
    Rule("crossing", "surface mismatch", r"crossings?"),
    Rule("hold, slides, free directions", "Hessian eigenvalues, unconstrained directions",
         r"hold_directions|free[ _]directions?|directions? (?:\w+ )?free|how firmly|"
         r"slid(?:e|es|ing)|(?:surfaces?|planes?)(?: \w+){0,2} holds?|"
         r"holds? (?:a |the )?(?:pose|motion)|"
         r"(?:test|emtr|refinement|struct|double|->|\.|`|\")[_ ]?hold(?:\[6\]|\"|`|\.)?(?![\w ])"),
    Rule("escalation", "fallback search", r"escalat\w*"),
    Rule("modes, distinct, copy", "pose clustering, non-maximum suppression, kDistinctPose, "
         "kDuplicatePose, is_same_pose",
         r"k_Mode|k_Copy|modes|mode[_ -]gap|distinct(?=\()|distinct[_ ](?:modes?|of)|is_copy|"
         rf"cop(?:y|ies) of (?:\w+ ){{0,2}}(?:{POSES})|(?:{POSES})(?:,| that are| are)? "
         r"(?:none of them )?copies|none of them copies"),
    Rule("pool", "candidate set", r"pools?"),
    Rule("chf", "surface-fit score", r"chf"),
    Rule("shift", "translation", r"shift(?:s|ed|ing)?"),
    Rule("turn", "rotation",
         r"(?<!in )(?<!by )(?:(?<!their )(?<!its )turn|turns|turned|turning)"
         r"(?! (?:out|on|off|over|down|away|back to)|(?: [\w']+){0,5} into)"),
    Rule("forces", "squared influence", r"forces(?! (?:the|a|an|it|its|that|gcc|every|all|one))"),
    Rule("company", "coexistence", r"compan(?:y|ies)"),
    Rule("bits (the programs)", "reproducibility",
         r"tools/bits|bits_(?:matrix|run|test)|(?:phase|step) [\"']bits[\"']"),
    Rule("kept (the functions)", "cached", r"register_kept|kept_(?:source|target)"),
    # The engine's own names.
    Rule("Team", "ThreadTeam", r"(?<!Thread_)Team(?=[ &*:(;{>])", ENGINE, match_case=True),
    Rule("in_parallel", "parallel_for", r"in_parallel(?=[(<])", ENGINE),
    Rule("Watch, Watched", "CancellationToken, CancellationScope", r"Watch(?:ed)?", ENGINE, True),
    Rule("Stopped", "Cancelled", r"Stopped(?=[ &(;{>)])", ENGINE, match_case=True),
    Rule("poll()", "check_cancelled()", r"poll(?=\()", ENGINE),
    # How a comment begins.
    Rule("a comment that begins with Of or What is", "a verb and its object",
         r"(?:^|[ \t])(?://+!?<?|/\*+!?<?|#|\*) (?:Of|What is)", match_case=True),
]  # fmt: skip

EXCEPTIONS = [
    Exception_("CHANGELOG.md", "", "lists the old names beside the new ones"),
    Exception_("tests/python/*vocabulary.py", "", "lists the words"),
    Exception_("*", r"(?i)\bpools?\b.*(?:thread|OpenMP|fork|region|runtime)|"
               r"(?:thread|OpenMP|fork|runtime).*\bpools?\b|(?i:openmp_?pool)",
               "OpenMP's pool of threads"),
    Exception_("*.py", r"(?i)pool", "a pool of processes, or the allocator's"),
    Exception_("*", r"^\s*shift( \d+)?$", "the command of bash"),
    Exception_("*", r"\bshift\b.*(?:<<|>>)|(?:<<|>>).*\bshift\b|2\^shift|\[shift\]|int shift\)",
               "a shift of binary digits"),
    Exception_("*", r"Keys\.SHIFT|shift and arrow keys", "a key of the keyboard"),
    Exception_("docs/MANY_PAIRS.md", r"ProcessPoolExecutor|\bpool,", "Python's executors"),
    Exception_("tools/bench/emtr_bench/*", r"\bturns?\b", "methods are measured in turns"),
    Exception_("examples/python/own_optimizer.py", r"polish=False", "an argument of SciPy's"),
    Exception_("tools/virtual_scan/shape.py", r"\bstanding\b", "an arm of the dragon"),
]  # fmt: skip

SUFFIXES = {".c", ".cpp", ".h", ".hpp", ".inl", ".in", ".py", ".pyi", ".pyx", ".pxd", ".pxi",
            ".md", ".cmake", ".sh", ".txt", ".toml", ".json", ".map", ".supp", ""}  # fmt: skip
FOLDERS = ("libemtr", "pyemtr", "tools", "tests", "docs", "examples")


def files(root: Path) -> Iterator[Path]:
    """The project's own text files."""
    yield from sorted(path for path in root.glob("*") if path.is_file() and own(path))
    for folder in FOLDERS:
        yield from sorted(p for p in (root / folder).rglob("*") if p.is_file() and own(p))


def own(path: Path) -> bool:
    hidden = any(part.startswith((".", "__pycache__", "build")) for part in path.parts[-4:])
    return path.suffix in SUFFIXES and not hidden


def taken_apart(line: str) -> str:
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", line)


def findings_in(path: str, text: str) -> Iterator[Finding]:
    """What the rules find in a path and in the text of its file, exceptions included."""
    rules = [rule for rule in RULES if fnmatch(path, rule.where)]
    lines = [path, *text.splitlines()]
    apart = taken_apart("\n".join(lines))  # most rules find nothing in most files
    present = [rule for rule in rules if rule.found(apart)]
    for number, (line, words) in enumerate(zip(lines, apart.split("\n"))):
        for rule in present:
            if rule.found(words):
                yield Finding(path, number, rule, line)


@cache
def all_findings(root: Path) -> list[Finding]:
    return [
        finding
        for path in files(root)
        for finding in findings_in(path.relative_to(root).as_posix(), path.read_text())
    ]


def excused(finding: Finding) -> Exception_ | None:
    for exception in EXCEPTIONS:
        if exception.covers(finding.path, finding.line):
            return exception
    return None
