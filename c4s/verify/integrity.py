"""Candidate integrity: the three checks that a saved scene must pass before anything is measured (paper, "Candidate
Integrity Checks").

1. *Snapshot*: the exported scene graph has the published schema and at least the case's minimum number of actors.
2. *Dependencies*: every package that the scene refers to resolves under the frozen dependency policy.
3. *Manifest*: submission, scorer and frozen content name the same packs with the same digests.

A failure that the submission caused is ``invalid`` (the case score is zero, with the reason); one that the evaluator
caused is ``error`` (never a score).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, Literal, TypeAlias

from c4s.model import Record
from c4s.verify.repair.actors import is_semantic, short_class
from c4s.verify.verdict import Verdict

INTEGRITY_POLICY = "c4s.integrity.v1"
ReasonCode: TypeAlias = Literal["unloadable", "snapshot_schema", "minimum_actors", "unresolved_dependencies",
                                "manifest_disagreement", "scorer_manifest", "evidence_missing",
                                "export_failed"]
_EVALUATOR_FAULTS = frozenset({"scorer_manifest", "evidence_missing", "export_failed"})
_ENGINE_OWNED = frozenset({"worldsettings", "brush", "defaultphysicsvolume", "levelbounds"})
_ALWAYS_RESOLVED = ("/Engine/", "/Script/", "/Temp/", "/Paper2D/")
"""Package roots that ship with the engine: they are not followed."""
_SCHEMA = "0.3."
_LISTED = 20


class ManifestDigests(Record):
    """Digests by pack id, from three sides."""

    frozen: dict[str, str]
    """What the suite froze for the case."""
    submission: dict[str, str]
    """What the agent's engine had mounted when it saved the scene."""
    scorer: dict[str, str]
    """What the evaluator's engine has mounted."""


def content_actors(snapshot: Mapping[str, Any]) -> int:
    """Actors that count towards the minimum.

    All actors of the snapshot but capture helpers (cameras, scene captures) and the few that a level always has
    (world settings, builder brush, default physics volume, level bounds). Lights, volumes and player starts count.
    """
    return sum(is_semantic(actor) and short_class(actor.get("class")).casefold() not in _ENGINE_OWNED
               for actor in snapshot["actors"])


def _schema_fault(snapshot: Any) -> str:
    """What is wrong with a snapshot's structure; empty when nothing is."""
    if not isinstance(snapshot, Mapping):
        return "the snapshot is not an object"
    version = snapshot.get("schema_version")
    if not isinstance(version, str) or not version.startswith(_SCHEMA):
        return f"schema_version is {version!r}, not {_SCHEMA}x"
    if snapshot.get("units") != "cm":
        return f"units are {snapshot.get('units')!r}, not 'cm'"
    actors = snapshot.get("actors")
    if not isinstance(actors, list):
        return "there is no list of actors"
    declared = snapshot.get("actor_count")
    if declared is not None and declared != len(actors):
        return f"actor_count is {declared!r} but there are {len(actors)} actors"
    for number, actor in enumerate(actors):
        if not isinstance(actor, Mapping):
            return f"actor {number} is not an object"
        if not isinstance(actor.get("class"), str) or not actor["class"].strip():
            return f"actor {number} has no class"
        if not isinstance(actor.get("transform"), Mapping):
            return f"actor {number} has no transform"
    return ""


def _package(entry: Any) -> str:
    name = entry.get("package") if isinstance(entry, Mapping) else entry
    return str(name or "").partition(".")[0]


def unresolved_packages(dependencies: Mapping[str, Any], tolerated: Iterable[str] = ()) -> list[str]:
    """Packages of a dependency report that do not resolve, without engine packages and those known and tolerated."""
    known = {_package(name) for name in tolerated}
    names = {_package(entry) for entry in dependencies.get("unresolved") or ()}
    return sorted(name for name in names if name and name not in known and not name.startswith(_ALWAYS_RESOLVED))


def _manifest_fault(manifest: ManifestDigests) -> tuple[ReasonCode, str] | None:
    sides: tuple[tuple[str, dict[str, str], ReasonCode], ...] = (
        ("scorer", manifest.scorer, "scorer_manifest"), ("submission", manifest.submission, "manifest_disagreement"))
    for side, digests, code in sides:
        for pack in sorted(manifest.frozen | digests):
            wanted, found = manifest.frozen.get(pack), digests.get(pack)
            if wanted == found:
                continue
            said = ("is missing" if found is None else "is not part of the case" if wanted is None
                    else f"has digest {found[:12]}, not {wanted[:12]}")
            return code, f"pack {pack} of the {side} {said}"
    return None


def _failed(code: ReasonCode, text: str, measurements: dict[str, Any], inputs: Mapping[str, str]) -> Verdict:
    return Verdict(verifier="integrity", status="error" if code in _EVALUATOR_FAULTS else "invalid",
                   policy=INTEGRITY_POLICY, measurements=measurements | {"reason_code": code}, inputs=dict(inputs),
                   reason=f"{code}: {text}")


def unloadable(reason: str, inputs: Mapping[str, str] | None = None) -> Verdict:
    """The verdict of a saved scene that a clean engine refuses to load."""
    return _failed("unloadable", reason, {}, inputs or {})


def verify_integrity(snapshot: Any, dependencies: Mapping[str, Any] | None, minimum_actors: int,
                     manifest: ManifestDigests, *, tolerated: Iterable[str] = (),
                     inputs: Mapping[str, str] | None = None) -> Verdict:
    """Run the three checks; the first that fails gives the reason.

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
    read = inputs or {}
    if snapshot is None:
        return _failed("evidence_missing", "no snapshot was exported", {}, read)
    metadata = snapshot.get("export_metadata") if isinstance(snapshot, Mapping) else None
    if isinstance(metadata, Mapping) and metadata.get("status", "success") != "success":
        return _failed("export_failed", f"the export ended with status {metadata['status']!r}", {}, read)
    fault = _schema_fault(snapshot)
    if fault:
        return _failed("snapshot_schema", fault, {}, read)
    found = content_actors(snapshot)
    measurements: dict[str, Any] = {"actors": len(snapshot["actors"]), "content_actors": found,
                                    "minimum_actors": minimum_actors}
    if found < minimum_actors:
        return _failed("minimum_actors", f"{found} of at least {minimum_actors} actors", measurements, read)
    if dependencies is None:
        return _failed("evidence_missing", "no dependency report was made", measurements, read)
    missing = unresolved_packages(dependencies, tolerated)
    measurements["packages"] = len(dependencies.get("packages") or ())
    if missing:
        more = "" if len(missing) <= _LISTED else f" and {len(missing) - _LISTED} more"
        return _failed("unresolved_dependencies", ", ".join(missing[:_LISTED]) + more,
                       measurements | {"unresolved": missing}, read)
    disagreement = _manifest_fault(manifest)
    if disagreement is not None:
        return _failed(*disagreement, measurements, read)
    return Verdict(verifier="integrity", status="valid", policy=INTEGRITY_POLICY, measurements=measurements,
                   population={"actors": len(snapshot["actors"]), "content_actors": found}, inputs=dict(read))
