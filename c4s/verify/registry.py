"""The one table of verifiers. Stages, tasks, scores, re-scoring, bundles, findings, tables and pages read it.

A new verifier is one package under ``c4s/verify`` and one row here.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from c4s.errors import BadInput
from c4s.protocol.settings import Setting
from c4s.records.evidence import Evidence, EvidenceName
from c4s.records.verdict import Verdict
from c4s.records.version import code_version
from c4s.verify.integrity.verifier import INTEGRITY
from c4s.verify.navigation.verifier import NAVIGATION
from c4s.verify.paired.verifier import PAIRED
from c4s.verify.physics.verifier import PHYSICS
from c4s.verify.repair.verifier import REPAIR
from c4s.verify.semantic.verifier import DETAILED, OVERVIEW
from c4s.verify.verifier import Verifier

VERIFIERS: Final[dict[str, Verifier]] = {
    verifier.name: verifier for verifier in (INTEGRITY, REPAIR, DETAILED, OVERVIEW, PHYSICS, PAIRED, NAVIGATION)
}
"""By name, in the order in which tables and pages show them."""
DECIDE: Final = ("verify", "semantics", "protocol", "navigation", "collision", "geometry", "records")
"""Folders of ``c4s`` whose sources decide what a verdict says."""


def verifier_named(name: str) -> Verifier:
    """A row of the table; ``BadInput`` for a name that is not there."""
    if name not in VERIFIERS:
        raise BadInput(f"unknown verifier {name!r}", todo=f"use one of {', '.join(VERIFIERS)}")
    return VERIFIERS[name]


def verifiers_of(setting: Setting) -> list[Verifier]:
    """The verifiers of a setting, without the gate, in the table's order."""
    return [verifier for verifier in VERIFIERS.values() if setting in verifier.settings and not verifier.gate]


def weighed_of(setting: Setting) -> list[Verifier]:
    """The verifiers of a setting whose scores the trial's score is made of; the others are reported."""
    return [verifier for verifier in verifiers_of(setting) if verifier.weighed_as]


def is_judged(setting: Setting) -> bool:
    """Whether a verifier of the setting reads judgements."""
    return any("judgements" in verifier.needs for verifier in verifiers_of(setting))


def headlines_of(setting: Setting) -> list[str]:
    """Names of the numbers that a trial's score of this setting shows."""
    return [name for verifier in weighed_of(setting) for name in verifier.headlines]


def measure(name: str, evidence: Evidence) -> dict[EvidenceName, Mapping[str, Any]]:
    """The evidence that a verifier measures in the exported scene before it judges, by file; not what is there."""
    verifier = verifier_named(name)
    return {} if verifier.measure is None else verifier.measure(evidence.only(verifier.needs))


def make_verdict(name: str, evidence: Evidence) -> Verdict:
    """A verifier's verdict, with the digests of what it read and the version of the code that made it."""
    verifier = verifier_named(name)
    given = evidence.only(verifier.needs)
    verdict = verifier.verify(given)
    for read, sha256 in verdict.inputs.items():
        given.note(read, sha256)
    return verdict.model_copy(update={"inputs": dict(given.digests), "made_by": code_version(*DECIDE)})
