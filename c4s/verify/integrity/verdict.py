"""Candidate integrity: the three checks that a saved scene must pass before anything is measured (paper, "Candidate
Integrity Checks").

1. *Snapshot*: the exported scene graph has the published schema and at least the case's minimum number of actors.
2. *Dependencies*: every package that the scene refers to resolves under the frozen dependency policy.
3. *Manifest*: submission, scorer and frozen content name the same packs with the same digests.

A failure that the submission caused is ``invalid`` (the case score is zero, with the reason); one that the evaluator
caused is ``error`` (never a score). So the scorer's own content is compared first: a package that is missing because
the scorer mounted other content says nothing about the submission.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, Literal, TypeAlias

from c4s import errors
from c4s.protocol.content import is_the_engines, package_of
from c4s.protocol.rules import INTEGRITY_POLICY
from c4s.records.evidence import ManifestDigests
from c4s.records.snapshot_faults import snapshot_fault
from c4s.records.verdict import Verdict
from c4s.verify.actors.kinds import is_semantic, short_class

ReasonCode: TypeAlias = (
    errors.ReasonCode
    | Literal[
        "snapshot_schema",
        "minimum_actors",
        "unresolved_dependencies",
        "manifest_disagreement",
        "scorer_manifest",
        "evidence_missing",
        "export_failed",
    ]
)
_EVALUATOR_FAULTS = frozenset({"scorer_manifest", "evidence_missing", "export_failed"})
_ENGINE_OWNED = frozenset({"worldsettings", "brush", "defaultphysicsvolume", "levelbounds"})
_LISTED = 20


def content_actors(snapshot: Mapping[str, Any]) -> int:
    """Actors that count towards the minimum.

    All actors of the snapshot but capture helpers (cameras, scene captures) and the few that a level always has
    (world settings, builder brush, default physics volume, level bounds). Lights, volumes and player starts count.
    """
    return sum(
        is_semantic(actor) and short_class(actor.get("class")).casefold() not in _ENGINE_OWNED
        for actor in snapshot["actors"]
    )


def _package(entry: Any) -> str:
    """Package name of a dependency entry, object and export quotes cut off."""
    name = entry.get("package") if isinstance(entry, Mapping) else entry
    return package_of(str(name or ""))


def unresolved_packages(dependencies: Mapping[str, Any], tolerated: Iterable[str] = ()) -> list[str]:
    """Packages of a dependency report that do not resolve, without engine packages and those known and tolerated.

    Package names are compared as the engine does, without regard to case.
    """
    known = {_package(name).casefold() for name in tolerated}
    names = {_package(entry) for entry in dependencies.get("unresolved") or ()}
    return sorted(name for name in names if name and name.casefold() not in known and not is_the_engines(name))


def _disagreement(side: str, digests: Mapping[str, str], frozen: Mapping[str, str]) -> str:
    """The first pack that a side has otherwise than the frozen content; empty when they agree."""
    for pack in sorted({**frozen, **digests}):
        wanted, found = frozen.get(pack), digests.get(pack)
        if wanted is None or found is None or wanted.lower() != found.lower():
            said = (
                "is missing"
                if found is None
                else "is not part of the case"
                if wanted is None
                else f"has digest {found[:12]}, not {wanted[:12]}"
            )
            return f"pack {pack} of the {side} {said}"
    return ""


def _failed(code: ReasonCode, text: str, measurements: dict[str, Any], inputs: Mapping[str, str]) -> Verdict:
    return Verdict(
        verifier="integrity",
        status="error" if code in _EVALUATOR_FAULTS else "invalid",
        policy=INTEGRITY_POLICY,
        measurements=measurements | {"reason_code": code},
        inputs=dict(inputs),
        reason=f"{code}: {text}",
    )


def refused(code: errors.ReasonCode, reason: str) -> Verdict:
    """The verdict of a saved scene that no clean engine loads, exports or draws, or the gate itself cannot handle."""
    return _failed(code, reason, {}, {})


def verify_integrity(
    snapshot: Any,
    dependencies: Mapping[str, Any] | None,
    minimum_actors: int,
    manifest: ManifestDigests,
    *,
    tolerated: Iterable[str] = (),
    inputs: Mapping[str, str] | None = None,
) -> Verdict:
    """Run the three checks, the scorer's own content first; the first that fails gives the reason.

    Args:
        snapshot: the exported scene; null when the evaluator made none.
        dependencies: ``{"packages": [...], "unresolved": [...]}``; null when the evaluator made none.
        minimum_actors: of the case; counted as ``content_actors`` tells.
        manifest: pack digests of submission, scorer and frozen content.
        tolerated: packages that the frozen policy knows to be unresolved in the source content itself.
        inputs: SHA-256 of the files that were read.

    Returns:
        Status ``valid``, ``invalid`` or ``error``; ``measurements["reason_code"]`` names the failed check.
    """
    read, tolerated = inputs or {}, list(tolerated)
    drift = _disagreement("scorer", manifest.scorer, manifest.frozen)
    if drift:
        return _failed("scorer_manifest", drift, {}, read)
    if snapshot is None:
        return _failed("evidence_missing", "no snapshot was exported", {}, read)
    metadata = snapshot.get("export_metadata") if isinstance(snapshot, Mapping) else None
    if isinstance(metadata, Mapping) and metadata.get("status", "success") != "success":
        return _failed("export_failed", f"the export ended with status {metadata['status']!r}", {}, read)
    fault = snapshot_fault(snapshot)
    if fault:
        return _failed("snapshot_schema", fault, {}, read)
    found = content_actors(snapshot)
    measurements: dict[str, Any] = {
        "actors": len(snapshot["actors"]),
        "content_actors": found,
        "minimum_actors": minimum_actors,
    }
    if found < minimum_actors:
        return _failed("minimum_actors", f"{found} of at least {minimum_actors} actors", measurements, read)
    if dependencies is None:
        return _failed("evidence_missing", "no dependency report was made", measurements, read)
    missing = unresolved_packages(dependencies, tolerated)
    measurements |= {"packages": len(dependencies.get("packages") or ()), "tolerated": sorted(tolerated)}
    if missing:
        more = "" if len(missing) <= _LISTED else f" and {len(missing) - _LISTED} more"
        return _failed(
            "unresolved_dependencies", ", ".join(missing[:_LISTED]) + more, measurements | {"unresolved": missing}, read
        )
    disagreement = _disagreement("submission", manifest.submission, manifest.frozen)
    if disagreement:
        return _failed("manifest_disagreement", disagreement, measurements, read)
    return Verdict(
        verifier="integrity",
        status="valid",
        policy=INTEGRITY_POLICY,
        measurements=measurements,
        population={"actors": len(snapshot["actors"]), "content_actors": found},
        inputs=dict(read),
    )
