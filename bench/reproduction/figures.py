"""Every check of the reference, in its order: what our code says, and how it stands to what is published."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Final

from bench.reproduction import others, repairs, scores, sets, utility
from bench.reproduction.book import Book
from bench.reproduction.figure import Draft, Figure, judged

BLOCKS: Final[tuple[Callable[[Book], Iterator[Draft]], ...]] = (
    scores.public_table,
    scores.private_table,
    scores.shading,
    scores.public_order,
    scores.paired,
    scores.full_suite,
    scores.difficulty,
    sets.validation,
    sets.domains,
    repairs.by_domain,
    repairs.robustness,
    repairs.spatial,
    repairs.weights,
    utility.panel_a,
    utility.panel_b,
    utility.example,
    utility.aligned,
    sets.counts,
    sets.sizes,
    others.human_design,
    others.human_fit,
    others.weight_sums,
    others.repeatability,
    others.running_cases,
    others.anchors,
    others.cost,
    others.behaviour,
    others.restated,
    others.side_conditions,
)
"""In the order of the checks' numbers."""


def figures(book: Book) -> list[Figure]:
    """A row a check. ``ValueError`` where there are more or fewer checks than rows."""
    drafts = [draft for block in BLOCKS for draft in block(book)]
    found = []
    for (check, row), draft in zip(book.checks.iterrows(), drafts, strict=True):
        decimals = int(row["decimals"]) if row["decimals"] else None
        found.append(judged(str(check), draft, str(row["published"]), decimals))
    return found
