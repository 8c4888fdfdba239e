"""What an answer has to keep to be used. What breaks it is told by class and is never guessed at.

``truncated`` (cut at the output limit), ``withheld`` (by a content filter), ``malformed`` (no JSON of the schema),
``missing`` (a claim without an answer), ``repeated`` (a claim answered twice), ``unknown_claim``, ``unknown_view``,
``uncited`` (a definite answer that names no view), ``contradictory`` (parts that exclude each other).
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final, Literal

from c4s.chat.client import Reply
from c4s.files import whole_characters
from c4s.judge.model.schemas import DEFECTS, NO, OPEN, PROMPT_ANCHORS, STRUCTURE_ANCHORS, YES
from c4s.protocol.numbers import unit_number
from c4s.protocol.paired import PAIRED_SCALE, PAIRED_WEIGHTS
from c4s.protocol.rules import OVERVIEW_WEIGHTS
from c4s.records.judgement import SevereDefect

BrokenKind = Literal[
    "truncated",
    "withheld",
    "malformed",
    "missing",
    "repeated",
    "unknown_claim",
    "unknown_view",
    "uncited",
    "contradictory",
]
SaidAnswer = Literal["MATCH", "MISMATCH", "UNKNOWN"]
WHOLE = ""
"""Stands for the answer as a whole where a claim's name would."""
MOST_CHARACTERS = 1 << 20
MOST_TOLD = 500
"""Characters of a sentence of the model that are kept."""
_ANSWERS: Final[dict[Any, SaidAnswer]] = {YES: "MATCH", NO: "MISMATCH", OPEN: "UNKNOWN"}
_NEAR = 0.25
"""A score and its anchor differ by less."""


class Broken(Exception):
    """An answer that cannot be used."""

    def __init__(self, kind: BrokenKind) -> None:
        super().__init__(kind)
        self.kind: BrokenKind = kind


@dataclass(frozen=True)
class SaidClaim:
    """What a model says of one claim."""

    answer: SaidAnswer
    confidence: float
    saw: str
    views: tuple[str, ...]
    """As the request names them."""


@dataclass(frozen=True)
class Rated:
    """A score in [0, 1] with the model's reason."""

    score: float
    reason: str


def value_of(reply: Reply) -> Mapping[str, Any]:
    """The object that a reply holds."""
    if reply.finish == "length":
        raise Broken("truncated")
    text = reply.message.get("content")
    if reply.finish == "content_filter" or reply.message.get("refusal"):
        raise Broken("withheld")
    if not isinstance(text, str) or not text.strip() or len(text) > MOST_CHARACTERS:
        raise Broken("malformed")
    try:
        value = whole_characters(json.loads(text, object_pairs_hook=_once, parse_constant=_no_number))
    except (ValueError, RecursionError):
        raise Broken("malformed") from None
    if not isinstance(value, dict):
        raise Broken("malformed")
    return value


def claims_of(
    value: Mapping[str, Any], claims: Sequence[str], views: Sequence[str], *, binary: bool
) -> tuple[dict[str, SaidClaim], dict[str, str]]:
    """The answers that keep the contract, by claim, and how the others break it. ``Broken`` for an answer that does as
    a whole."""
    rows = value.get("answers")
    if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
        raise Broken("malformed")
    named = Counter(str(row.get("claim")) for row in rows)
    if named.keys() - set(claims):
        raise Broken("unknown_claim")
    said: dict[str, SaidClaim] = {}
    broken: dict[str, str] = {claim: "missing" for claim in claims if claim not in named}
    for row in rows:
        claim = str(row["claim"])
        try:
            if named[claim] > 1:
                raise Broken("repeated")
            said[claim] = _claim(row, views, binary)
        except Broken as fault:
            broken[claim] = fault.kind
    return said, broken


def _claim(row: Mapping[str, Any], views: Sequence[str], binary: bool) -> SaidClaim:
    given, cited = row.get("answer"), _views(row.get("views"), views)
    answer = _ANSWERS.get(given) if isinstance(given, str) else None
    confidence, visible = unit_number(row.get("confidence")), row.get("visible")
    if answer is None or confidence is None or not (binary or isinstance(visible, bool)):
        raise Broken("malformed")
    if binary and answer == "UNKNOWN":
        raise Broken("malformed")
    if answer != "UNKNOWN" and not cited:
        raise Broken("uncited")
    if answer == "MATCH" and visible is False:
        raise Broken("contradictory")
    return SaidClaim(answer, confidence, _words(row.get("saw")), cited)


def dimensions_of(value: Mapping[str, Any]) -> tuple[dict[str, Rated], str]:
    """The four dimensions and the summary of the prompt-aware call."""
    rated = {name: _rated(value.get(name), PROMPT_ANCHORS) for name in OVERVIEW_WEIGHTS}
    return rated, _words(value.get("summary"))


def structure_of(value: Mapping[str, Any], views: Sequence[str]) -> tuple[Rated, SevereDefect | None]:
    """Structural integrity and the severe defect of the prompt-free call; its views are as the request names them."""
    rated, row = _rated(value, STRUCTURE_ANCHORS), value.get("severe")
    if not isinstance(row, dict) or not isinstance(row.get("found"), bool):
        raise Broken("malformed")
    confidence, cited = unit_number(row.get("confidence")), _views(row.get("views"), views)
    categories, issues = _texts(row.get("categories")), _texts(row.get("issues"))
    if confidence is None or set(categories) - set(DEFECTS):
        raise Broken("malformed")
    if not row["found"]:
        return rated, None
    if rated.score > STRUCTURE_ANCHORS["minor"]:
        raise Broken("contradictory")
    if not cited:
        raise Broken("uncited")
    return rated, SevereDefect(confidence=confidence, views=list(cited), categories=categories, issues=issues)


def paired_of_value(value: Mapping[str, Any]) -> tuple[dict[str, float], str]:
    """The five dimensions in [0, 1], and the difference in the model's words."""
    said = {}
    for name in PAIRED_WEIGHTS:
        score = value.get(name)
        if isinstance(score, bool) or not isinstance(score, int | float) or not 0 <= score <= PAIRED_SCALE:
            raise Broken("malformed")
        said[name] = score / PAIRED_SCALE
    return said, _words(value.get("difference"))


def _rated(row: Any, anchors: Mapping[str, float]) -> Rated:
    if not isinstance(row, Mapping):
        raise Broken("malformed")
    score, anchor = unit_number(row.get("score")), row.get("anchor")
    if score is None or not isinstance(anchor, str) or anchor not in anchors:
        raise Broken("malformed")
    if abs(score - anchors[anchor]) >= _NEAR:
        raise Broken("contradictory")
    return Rated(score, _words(row.get("reason")))


def _views(given: Any, views: Sequence[str]) -> tuple[str, ...]:
    if not isinstance(given, list) or not all(isinstance(name, str) for name in given):
        raise Broken("malformed")
    if set(given) - set(views):
        raise Broken("unknown_view")
    return tuple(name for name in views if name in given)


def _texts(given: Any) -> list[str]:
    if not isinstance(given, list) or not all(isinstance(text, str) for text in given):
        raise Broken("malformed")
    return [text[:MOST_TOLD] for text in given[:20]]


def _words(given: Any) -> str:
    if not isinstance(given, str):
        raise Broken("malformed")
    return " ".join(given.split())[:MOST_TOLD]


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """An object of which no key is there twice."""
    made = dict(pairs)
    if len(made) < len(pairs):
        raise Broken("contradictory")
    return made


def _no_number(token: str) -> Any:
    raise ValueError(token)
