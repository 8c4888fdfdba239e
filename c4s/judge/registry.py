"""The judges by name. A plan names one of them; every other name is refused before anything runs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from c4s.errors import BadInput
from c4s.judge.names import RULE
from c4s.judge.rule.judging import judge_by_rule, rule_version
from c4s.records.evidence import Evidence, EvidenceName
from c4s.records.judgement import Judgements


@dataclass(frozen=True)
class Judge:
    """A judge: it answers the claims of a case's requirement bundle from evidence."""

    name: str
    judge: Callable[[Evidence], Judgements]
    version: Callable[[], str]
    """Changes with anything that can change an answer."""
    online: bool = False
    """Whether it asks a model over a network."""


def _rule(evidence: Evidence) -> Judgements:
    return judge_by_rule(
        evidence.json("requirements") if evidence.has("requirements") else None,
        evidence.prompt,
        evidence.json("candidate_snapshot"),
        evidence.catalog(),
        evidence.json("captures"),
    )


JUDGES = {judge.name: judge for judge in (Judge(RULE, _rule, rule_version),)}


def judge_named(name: str) -> Judge:
    """A judge by its name; ``BadInput`` for one that is not there."""
    if name not in JUDGES:
        raise BadInput(f"unknown judge {name!r}", todo=f"use one of {', '.join(JUDGES)}")
    return JUDGES[name]


READS: Final[frozenset[EvidenceName]] = frozenset({"candidate_snapshot", "captures", "requirements"})
"""All that a judge is given: of what is withheld, the requirement bundle alone."""


def make_judgements(name: str, evidence: Evidence) -> Judgements:
    """What a judge says of a submission, with the digests of what it read."""
    given = evidence.only(READS)
    made = judge_named(name).judge(given)
    return made.model_copy(update={"inputs": dict(given.digests)})
