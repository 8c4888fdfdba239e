"""Packing a trial of a run as a published evidence bundle, so that the published scorer can score it."""

from __future__ import annotations

import json
import os
import shutil
from pathlib import Path
from typing import Any

from c4s.bundle.manifest import INTEGRITY_LEAVES, MANIFEST, Manifest
from c4s.errors import BadInput
from c4s.files import digest_file, write_json
from c4s.folders import beside, check_new, put_folder
from c4s.protocol.rules import GATE, OVERVIEW_VIEWS
from c4s.protocol.settings import is_construction
from c4s.records.attempt import AttemptOutcome
from c4s.records.folder import TrialFolder
from c4s.records.score import TrialScore
from c4s.records.verdict import Verdict
from c4s.run.check import check_evidence
from c4s.verify.physics.verifier import PHYSICS
from c4s.verify.semantic.verifier import DETAILED, OVERVIEW

_LEAF_OF_REASON = {
    "unresolved_dependencies": "content_and_dependency_parity",
    "manifest_disagreement": "asset_library_manifest_parity",
}


class _Writer:
    """Puts files into the bundle and remembers their digests."""

    def __init__(self, out: Path) -> None:
        self.out = out
        self.files: dict[str, str] = {}

    def json(self, path: str, value: Any) -> str:
        """Write JSON; the path."""
        target = self._target(path)
        target.write_text(json.dumps(value, allow_nan=False) + "\n", encoding="utf-8")
        return self._listed(path)

    def copy(self, path: str, source: Path) -> str:
        """Copy a file; the path."""
        if not source.is_file():
            raise BadInput("evidence is missing", where=str(source), todo="run the trial again")
        shutil.copyfile(source, self._target(path))
        return self._listed(path)

    def _target(self, path: str) -> Path:
        target = self.out / path
        target.parent.mkdir(parents=True, exist_ok=True)
        return target

    def _listed(self, path: str) -> str:
        self.files[path] = digest_file(self.out / path)
        return path


def pack_trial(folder: TrialFolder, out: Path, *, withheld: Path | None = None) -> Manifest:
    """Pack a scored trial into the new folder ``out`` and return its manifest.

    Args:
        folder: a trial with its score.
        out: must not exist or be empty; it is there when the bundle is whole.
        withheld: the case's withheld folder; a repair needs its input and truth snapshots.

    Raises ``BadInput`` for a trial without a score or with evidence missing.
    """
    score = TrialScore.read(folder.score)
    check_new(out)
    out = Path(os.path.realpath(out))
    with beside(out) as scratch:
        made = scratch / out.name
        manifest = _packed(folder, score, _Writer(made), withheld, str(out))
        write_json(made / MANIFEST, manifest.model_dump(mode="json", exclude_none=True))
        put_folder(made, out, marker=MANIFEST)
    return manifest


def _packed(folder: TrialFolder, score: TrialScore, writer: _Writer, withheld: Path | None, where: str) -> Manifest:
    """Write the files of a bundle; its manifest, which is not written yet."""
    value: dict[str, Any] = {
        "schema_version": "code4scene.bundle.v1",
        "task": {"id": score.case_id, "setting": score.setting},
        "run": {"model": score.configuration, "submission": "submitted"},
        "notes": f"made by c4s; engine {score.engine}, judge {score.judge}, policy {score.policy}",
    }
    if score.retained_attempt is not None:
        kept = AttemptOutcome.read(folder.attempt(score.retained_attempt).outcome)
        value["run"]["candidate_sha256"] = kept.submission_sha256
    if score.status in ("zero_missing_submission", "zero_missing_result"):
        value["run"]["submission"] = "missing"
    else:
        integrity = Verdict.read(folder.verdict(GATE))
        if score.status == "pending" or integrity.status not in ("valid", "invalid"):
            raise BadInput(
                f"the trial has no score yet: {score.reason or integrity.reason}",
                where=str(folder.root),
                todo="finish the run first",
            )
        value["candidate_integrity"] = _integrity(integrity)
        if integrity.status == "valid":
            value |= _evidence(writer, folder, score, withheld)
    return Manifest.parse(value | {"files": writer.files}, where=where)


def _integrity(verdict: Verdict) -> dict[str, Any]:
    leaves = dict.fromkeys(INTEGRITY_LEAVES, "valid")
    if verdict.status != "valid":
        code = str(verdict.measurements.get("reason_code"))
        leaves[_LEAF_OF_REASON.get(code, "candidate_snapshot_integrity")] = "invalid"
    return {
        "status": "valid" if verdict.status == "valid" else "invalid",
        "leaves": leaves,
        "failure_reason": verdict.reason or None,
    }


def _evidence(writer: _Writer, folder: TrialFolder, score: TrialScore, withheld: Path | None) -> dict[str, Any]:
    check_evidence(folder)
    physics = Verdict.read(folder.verdict(PHYSICS.name))
    report = {
        "report_id": "physical_safety",
        "status": physics.status,
        "score": physics.score,
        "metrics": {
            key: physics.measurements[key]
            for key in ("leaf_results", "leaf_score_directions")
            if key in physics.measurements
        },
    }
    scenes = {"candidate": writer.copy("scenes/candidate.scene.json", folder.evidence.snapshot)}
    value: dict[str, Any] = {
        "scenes": scenes,
        "physics": {"report": writer.json("physics/physical_safety.json", report)},
    }
    if not is_construction(score.setting):
        if withheld is None:
            raise BadInput("the bundle of a repair needs the case's withheld folder", where=score.case_id)
        scenes["input"] = writer.copy("scenes/input.scene.json", withheld / "input.snapshot.json")
        scenes["ground_truth"] = writer.copy("scenes/ground_truth.scene.json", withheld / "truth.snapshot.json")
        return value
    detailed = Verdict.read(folder.verdict(DETAILED.name))
    rows = detailed.measurements.get("semantic_requirement_aggregation", [])
    by_state = {found["node_id"] for found in detailed.measurements.get("decisions", []) if found["stage"] == "state"}
    rows = [{**row, "resolved_by": "structured"} if row["node_id"] in by_state else row for row in rows]
    value["semantic"] = {
        "decisions": writer.json("semantic/decisions.json", {"report_status": detailed.status, "decisions": rows})
    }
    views = [
        writer.copy(f"renders/overview/view_{n}.png", folder.evidence.captures / f"overview-{n}.png")
        for n in range(1, OVERVIEW_VIEWS + 1)
    ]
    value["overview"] = {"views": views}
    overview = Verdict.read(folder.verdict(OVERVIEW.name))
    if overview.status == "measured":
        value["overview"]["judgement"] = writer.json(
            "overview/judgement.json",
            {
                "status": "measured",
                "recorded_score": overview.score,
                "dimension_scores": {name: row["score"] for name, row in overview.measurements["dimensions"].items()},
                "structural_integrity_score": overview.measurements["structural_integrity_score"],
                "severe_structural_cap_eligible": overview.measurements["severe_structural_cap_eligible"],
            },
        )
    value["renders"] = [
        {"role": "overview", "view": f"view_{n}", "channel": "rgb", "path": path}
        for n, path in enumerate(views, start=1)
    ]
    return value
