"""Coverage: which content words of a prompt its requirements speak of."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from c4s.protocol.graph.report import GraphFinding, WordCoverage
from c4s.protocol.graph.view import BundleView, ends
from c4s.protocol.rules import COMPOSITE_TYPES
from c4s.protocol.words import word_set

LEAST = 0.9
"""A bundle that speaks of a smaller share of its prompt's content words is not written."""
NO_CONTENT = word_set("""
    a an the of with or and by me it its as but to that which this these those their they them is are be been being was
    were has have for in on at from into plus while where so then there each other itself please build make create add
    use place put design include give let set should must would could can will if""")
"""Words that ask for nothing themselves: articles, conjunctions, the commonest prepositions and verbs of asking."""
_WORD = re.compile(r"[^\W_]+(?:[-'’][^\W_]+)*")


def content_words(prompt: str, view: tuple[int, int]) -> Iterator[tuple[str, int, int]]:
    """(word, start, end) of the content words in a span of a prompt."""
    for match in _WORD.finditer(prompt, *view):
        if match.group().lower() not in NO_CONTENT:
            yield match.group(), match.start(), match.end()


def covered_by(prompt: str, view: tuple[int, int], spans: Iterable[tuple[int, int]]) -> WordCoverage:
    """Coverage of a span of a prompt by spans: a word counts when all of it lies in one or more of them."""
    marks = bytearray(len(prompt) + 1)
    for start, end in spans:
        marks[start:end] = b"\1" * (min(end, len(prompt)) - start)
    terms = covered = 0
    missing: list[str] = []
    for word, start, end in content_words(prompt, view):
        terms += 1
        if marks.find(0, start, end) < 0:
            covered += 1
        else:
            missing.append(word)
    return WordCoverage(terms, covered, tuple(missing))


def coverage(view: BundleView) -> WordCoverage:
    """What the predicates cover; a composite gives way to predicates inside its span, here as in the score."""
    spans = {identity: ends(node["source_span"]) for identity, node in view.predicates.items()}
    outer = _with_inner(set(spans.values()))
    kept = [
        span
        for identity, span in spans.items()
        if span not in outer or view.predicates[identity]["predicate_type"] not in COMPOSITE_TYPES
    ]
    return covered_by(view.prompt, view.view, kept)


def _with_inner(spans: set[tuple[int, int]]) -> set[tuple[int, int]]:
    """The spans that hold another."""
    found: set[tuple[int, int]] = set()
    least = float("inf")
    for start, end in sorted(spans, key=lambda span: (span[0], -span[1]), reverse=True):
        if least <= end:
            found.add((start, end))
        least = min(least, end)
    return found


def coverage_faults(found: WordCoverage, *, making: bool) -> Iterator[GraphFinding]:
    """Words that no requirement speaks of; an error where they are many and the bundle is still in the making."""
    if not found.uncovered:
        return
    shown = ", ".join(found.uncovered[:12]) + (" ..." if len(found.uncovered) > 12 else "")
    told = f"no requirement speaks of: {shown} ({found.covered} of {found.terms} content words are covered)"
    if found.ratio < LEAST and making:
        yield GraphFinding("coverage.ratio", "error", "prompt", f"{told}; at least {LEAST:.0%} must be")
    else:
        yield GraphFinding("coverage.words", "warning", "prompt", told)
