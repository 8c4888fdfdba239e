"""The row of the integrity gate."""

from __future__ import annotations

from c4s.errors import MachineryFault
from c4s.protocol.rules import GATE
from c4s.protocol.settings import SETTINGS
from c4s.records.evidence import Evidence
from c4s.records.verdict import Verdict
from c4s.verify.integrity.components import integrity_components
from c4s.verify.integrity.verdict import verify_integrity
from c4s.verify.verifier import Verifier


def _verify(evidence: Evidence) -> Verdict:
    if evidence.manifest is None:
        raise MachineryFault("the integrity gate was given no manifest")
    return verify_integrity(
        evidence.json("candidate_snapshot"), evidence.json("dependencies"), evidence.minimum_actors, evidence.manifest
    )


INTEGRITY = Verifier(
    name=GATE,
    title="Integrity",
    settings=SETTINGS,
    needs=frozenset({"candidate_snapshot", "dependencies"}),
    verify=_verify,
    gate=True,
    parts=integrity_components,
)
