"""What scores are made of, as rows: one a number."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from c4s.records.score import TrialScore
from c4s.records.verdict import Verdict
from c4s.score.case import semantic_score
from c4s.verify.components import components
from warehouse.records import ComponentRow

SEMANTIC = "semantic"


def component_rows(verdicts: Iterable[Verdict], score: TrialScore, key: dict[str, Any]) -> Iterator[ComponentRow]:
    """The components of every verdict of a trial, and the semantic score of one that has its two halves."""
    for verdict in verdicts:
        for name, value in components(verdict).items():
            yield ComponentRow(**key, verifier=verdict.verifier, name=name, value=value)
    if score.detailed is not None and score.overview is not None:
        semantic = semantic_score(detailed=score.detailed, overview=score.overview)
        yield ComponentRow(**key, verifier=SEMANTIC, name="score", value=semantic)
