"""The row of the navigation verifier: the Embodied Utility Score. It has no weight and no column of the leaderboard."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from c4s.protocol.settings import SETTINGS
from c4s.records.evidence import Evidence, EvidenceName
from c4s.records.evidence_digests import WALKED
from c4s.records.navigation import NavigationEvidence
from c4s.records.verdict import Verdict
from c4s.verify.verifier import Components, Finding, Verifier, shares

_FALLS = {
    "unconnected": "no way leads here from the largest walkable area",
    "unreached": "nowhere within a metre can a body stand",
    "raised": "scenery: it stands more than 150 cm over what one walks on",
    "buried": "scenery: it lies more than 50 cm under what one walks on",
}


def _measure(evidence: Evidence) -> dict[EvidenceName, Mapping[str, Any]]:
    """The walkable space of the exported bodies. An engine that knows its own mesh has been probed before."""
    if evidence.has("navigation"):
        return {}
    from c4s.navigation import measure_snapshot

    snapshot = evidence.json("candidate_snapshot")
    return {} if _has_own_mesh(snapshot) else {"navigation": measure_snapshot(snapshot).plain()}


def _has_own_mesh(snapshot: Mapping[str, Any]) -> bool:
    told = snapshot.get("c4s")
    return isinstance(told, Mapping) and told.get("engine") == "unreal"


def _verify(evidence: Evidence) -> Verdict:
    from c4s.verify.navigation.verdict import verify_navigation

    given = None
    if evidence.has("navigation"):
        given = NavigationEvidence.parse(evidence.json("navigation"), where=str(evidence.path("navigation")))
    return verify_navigation(given, evidence.json("candidate_snapshot"))


def _components(verdict: Verdict) -> Components:
    """A and W. A scene without a walk has no W; one that is withheld has neither."""
    if verdict.status != "measured":
        return {}
    return shares(verdict.measurements, ("approachability", "completion"))


def _findings(verdict: Verdict) -> Iterator[Finding]:
    for label, fall, *_ in verdict.measurements.get("picture", {}).get("targets", []):
        if fall in _FALLS:
            yield Finding(str(label), str(fall), _FALLS[fall])
    for walk in verdict.measurements.get("walks", []):
        start = f"from {walk['start']} " if walk["start"] else ""
        told = f"{start}{walk['length_cm'] / 100:.1f} m in {walk['seconds']:.1f} s"
        end = "arrived" if walk["arrived"] else "stalled" if walk["stalled"] else "not_arrived"
        yield Finding(str(walk["goal"]), end, f"{told}, {walk['short_cm'] / 100:.1f} m from its goal at the end")


NAVIGATION = Verifier(
    name="navigation",
    title="Embodied utility",
    settings=SETTINGS,
    needs=frozenset({"candidate_snapshot", "navigation"}),
    measure=_measure,
    maker=WALKED,
    verify=_verify,
    parts=_components,
    findings=_findings,
)
