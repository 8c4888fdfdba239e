"""The identity of the rule judge: a digest of everything that its decisions come from."""

from __future__ import annotations

import functools
from collections.abc import Iterable
from pathlib import Path

from c4s.files import digest, digest_file
from c4s.judge.rule import overview
from c4s.semantics import between, boxes, hull, inventory, kinds, looks, measures, quantities, views, words

RULES = (
    between,
    boxes,
    bundle_format,
    hull,
    inventory,
    kinds,
    looks,
    measures,
    overview,
    quantities,
    rule,
    views,
    words,
)
"""The modules that hold the judge's rules, word lists and thresholds, and its reader of bundles."""
_DIGITS = 12


def version_of(sources: Iterable[Path]) -> str:
    """``rule-`` and the first 12 hex digits of the digest over the names and bytes of the source files."""
    rows = sorted([path.name, digest_file(path)] for path in sources)
    return f"rule-{digest(rows)[:_DIGITS]}"


@functools.cache
def judge_version() -> str:
    """The version of this judge; another rule, word or threshold is another version."""
    return version_of(Path(str(module.__file__)) for module in RULES)
