"""The judges by their kind. A plan holds the configuration of one; every other name is refused before anything runs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from c4s.errors import BadInput
from c4s.judge.desk import Desk
from c4s.judge.model.version import model_version
from c4s.judge.rule.version import rule_version
from c4s.records.evidence import Evidence, EvidenceName
from c4s.records.judge import JudgeConfiguration, JudgeKind
from c4s.records.judgement import Judgements


@dataclass(frozen=True)
class Judge:
    """A kind of judge: it answers the claims of a case's requirement bundle from evidence."""

    judge: Callable[[JudgeConfiguration, Evidence, Desk], Judgements]
    version: Callable[[JudgeConfiguration], str]
    """Changes with anything that can change an answer."""
    online: bool = False
    """Whether it asks a model over a network."""


def _judge_by_rule(_: JudgeConfiguration, evidence: Evidence, __: Desk) -> Judgements:
    from c4s.judge.rule.judging import judge_evidence

    return judge_evidence(evidence)


def _judge_by_model(configuration: JudgeConfiguration, evidence: Evidence, desk: Desk) -> Judgements:
    from c4s.judge.model.judging import judge_by_model

    return judge_by_model(configuration, evidence, desk)


JUDGES: Final[dict[JudgeKind, Judge]] = {
    "rule": Judge(_judge_by_rule, lambda _: rule_version()),
    "model": Judge(_judge_by_model, model_version, online=True),
}
READS: Final[frozenset[EvidenceName]] = frozenset({"candidate_snapshot", "captures", "requirements", "binding"})
"""All that a judge is given: of what is withheld, the requirement bundle and what it is bound to, and a repair's
pictures of the truth."""


def judge_version(configuration: JudgeConfiguration) -> str:
    """``<release>+<12 hex>``: of the configuration, its prompts, and the code that judges by it."""
    return JUDGES[configuration.kind].version(configuration)


def is_online(configuration: JudgeConfiguration) -> bool:
    """Whether the judge asks a model over a network."""
    return JUDGES[configuration.kind].online


def make_judgements(configuration: JudgeConfiguration, evidence: Evidence, desk: Desk | None = None) -> Judgements:
    """What a judge says of a submission, with the digests of what it read."""
    given = evidence.only(READS)
    made = JUDGES[configuration.kind].judge(configuration, given, desk or Desk())
    return made.model_copy(update={"inputs": dict(given.digests)})


def repeat_judgements(
    configuration: JudgeConfiguration, stored: Judgements, evidence: Evidence, exchanges: Path, desk: Desk
) -> Judgements:
    """Stored judgements with fresh answers to the stored requests of Detailed Alignment (``judge.model.repeating``).

    ``BadInput`` for a judge that asks nothing: it says the same every time.
    """
    if not is_online(configuration):
        raise BadInput(
            f"judge {configuration.name!r} asks no model, so there is nothing to repeat",
            todo="repeat a run that a model judged",
        )
    from c4s.judge.model.repeating import repeat_by_model

    given = evidence.only(READS)
    made = repeat_by_model(configuration, stored, given, exchanges, desk)
    return made.model_copy(update={"inputs": dict(given.digests)})
