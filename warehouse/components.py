"""What scores are made of, as rows: one a number."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from c4s.protocol.case import SEMANTIC
from c4s.records.score import TrialScore
from c4s.records.verdict import Verdict
from c4s.verify.registry import verifier_named
from warehouse.records import ComponentRow


def component_rows(verdicts: Iterable[Verdict], score: TrialScore, key: dict[str, Any]) -> Iterator[ComponentRow]:
    """The components of every verdict of a trial, and the semantic score of one that has its two halves."""
    for verdict in verdicts:
        for name, value in verifier_named(verdict.verifier).components(verdict).items():
            yield ComponentRow(**key, verifier=verdict.verifier, name=name, value=value)
    semantic = score.components.get(SEMANTIC)
    if semantic is not None:
        yield ComponentRow(**key, verifier=SEMANTIC, name="score", value=semantic)
