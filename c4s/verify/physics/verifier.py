"""The row of the physics verifier."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from c4s.packs.store import PackStore
from c4s.protocol.physics import physics_from_report
from c4s.protocol.settings import SETTINGS, Setting, is_construction
from c4s.records.evidence import Evidence, EvidenceName
from c4s.records.policy import ScorePolicy
from c4s.records.verdict import Verdict
from c4s.verify.physics.components import physics_components
from c4s.verify.physics.evidence import contacts_of, support_of
from c4s.verify.physics.findings import physics_findings
from c4s.verify.physics.scene import PhysicsScene
from c4s.verify.physics.verdict import verify_physics
from c4s.verify.verifier import Verifier


def _start(evidence: Evidence) -> Any:
    return None if is_construction(evidence.setting) else evidence.json("input_snapshot")


def _measure(evidence: Evidence) -> dict[EvidenceName, Mapping[str, Any]]:
    if evidence.has("contacts") and evidence.has("support"):
        return {}
    scene = PhysicsScene(evidence.setting, evidence.json("candidate_snapshot"), _start(evidence))
    if scene.fault:
        return {}
    meshes = PackStore(evidence.packs).recorded_mesh
    return {"contacts": contacts_of(scene), "support": support_of(scene, meshes)}


def _verify(evidence: Evidence) -> Verdict:
    return verify_physics(
        evidence.setting,
        evidence.json("candidate_snapshot"),
        _start(evidence),
        contacts=evidence.json("contacts") if evidence.has("contacts") else None,
        support=evidence.json("support") if evidence.has("support") else None,
    )


def _score_under(verdict: Verdict, policy: ScorePolicy, setting: Setting) -> tuple[float | None, dict[str, Any]]:
    metrics = {key: verdict.measurements[key] for key in ("leaf_results", "leaf_score_directions")}
    made = physics_from_report({"status": "measured", "metrics": metrics}, weights=policy.leaves(setting))
    return made["score"], {}


PHYSICS = Verifier(
    name="physics",
    title="Physics",
    settings=SETTINGS,
    needs=frozenset({"candidate_snapshot", "input_snapshot", "contacts", "support"}),
    measure=_measure,
    verify=_verify,
    weighed_as="physics",
    parts=physics_components,
    headlines={"physics": "score"},
    score_under=_score_under,
    findings=physics_findings,
)
