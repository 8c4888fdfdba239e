"""Evidence bundles: a packed trial scores the same, and a changed or malformed bundle is refused."""

from __future__ import annotations

import gzip
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from bench.repair_scene import scenes
from c4s.bundle import pack_trial, read_bundle, score_bundle
from c4s.errors import BadInput
from c4s.files import digest_file, write_json
from c4s.protocol.detailed import detailed_score
from c4s.protocol.overview import overview_score
from c4s.records.attempt import AttemptOutcome
from c4s.records.folder import TrialFolder
from c4s.records.score import TrialScore
from c4s.records.verdict import Verdict
from c4s.score.case import case_score
from c4s.trees import read_listing
from c4s.verify.physics.verdict import verify_physics
from c4s.verify.repair import verify_repair

DIMENSIONS = {
    "global_prompt_alignment": 1.0,
    "composition_and_layout": 0.5,
    "style_atmosphere_coherence": 1.0,
    "completeness_and_polish": 0.25,
}
ROWS = [
    {
        "node_id": f"n{n}",
        "semantic_family": family,
        "clause_index": n,
        "included": True,
        "predicate_weight": 1.0,
        "evaluation_status": "MATCH",
        "score_known": True,
        "effective_score": value,
    }
    for n, (family, value) in enumerate(
        (("content_quantity", 1.0), ("spatial_composition", 0.25), ("attributes_materials", 0.3333))
    )
]
FIELDS = (
    "case_id",
    "setting",
    "configuration",
    "status",
    "score",
    "detailed",
    "known_coverage",
    "overview",
    "physics",
    "repair_precision",
    "repair_recall",
    "repair_f1",
)
VALID = Verdict(verifier="integrity", status="valid", policy="c4s.integrity.v1")


def store(root: Path, setting: Any, verdicts: dict[str, Verdict], *, submitted: bool = True) -> TrialFolder:
    folder = TrialFolder(root / "agent" / "case" / "r1")
    if folder.evidence.root.is_dir():
        write_json(folder.evidence.digests("export"), read_listing(folder.evidence.root))
    for name, verdict in verdicts.items():
        verdict.write(folder.verdict(name))
    kept = 1 if submitted and verdicts["integrity"].status == "valid" else None
    AttemptOutcome(attempt=1, ended_by="finished", submission="/Game/S", submission_sha256="ab").write(
        folder.attempt(1).outcome
    )
    case_score(
        case_id="case",
        setting=setting,
        configuration="agent",
        repeat=1,
        judge="rule",
        engine="headless",
        submitted=submitted,
        verdicts=verdicts,
        retained_attempt=kept,
    ).write(folder.score)
    return folder


@pytest.fixture
def repair_trial(tmp_path: Path) -> tuple[TrialFolder, Path]:
    made = scenes(40, 10)
    withheld, evidence = tmp_path / "withheld", tmp_path / "agent" / "case" / "r1" / "evidence"
    paths = {
        "input": withheld / "input.snapshot.json",
        "truth": withheld / "truth.snapshot.json",
        "candidate": evidence / "snapshot.json",
    }
    for name, path in paths.items():
        write_json(path, made[name])
    verdicts = {
        "integrity": VALID,
        "physics": verify_physics("image-to-scene/indoor", made["candidate"], made["input"]),
        "repair": verify_repair(paths["input"], paths["truth"], paths["candidate"]),
    }
    return store(tmp_path, "image-to-scene/indoor", verdicts), withheld


@pytest.fixture
def text_trial(tmp_path: Path) -> TrialFolder:
    snapshot = scenes(12, 0)["truth"]
    evidence = tmp_path / "agent" / "case" / "r1" / "evidence"
    write_json(evidence / "snapshot.json", snapshot)
    (evidence / "captures").mkdir()
    for n in range(1, 5):
        (evidence / "captures" / f"overview-{n}.png").write_bytes(b"picture %d" % n)
    made, total = detailed_score(ROWS), overview_score(DIMENSIONS, 0.5, False)
    verdicts = {
        "integrity": VALID,
        "physics": verify_physics("text-to-scene", snapshot),
        "detailed": Verdict(
            verifier="detailed",
            status="measured",
            score=made["score"],
            policy="p",
            measurements={"semantic_requirement_aggregation": ROWS, "known_coverage": made["known_coverage"]},
        ),
        "overview": Verdict(
            verifier="overview",
            status="measured",
            score=total["score"],
            policy="p",
            measurements={
                "dimensions": {name: {"score": value} for name, value in DIMENSIONS.items()},
                "structural_integrity_score": 0.5,
                "severe_structural_cap_eligible": False,
            },
        ),
    }
    return store(tmp_path, "text-to-scene", verdicts)


def same(folder: TrialFolder, bundle: Path) -> TrialScore:
    stored, again = TrialScore.read(folder.score), score_bundle(read_bundle(bundle)).score
    assert (again.status, again.score, again.components) == (stored.status, stored.score, stored.components)
    return again


def test_a_packed_repair_scores_the_same(repair_trial: tuple[TrialFolder, Path], tmp_path: Path) -> None:
    folder, withheld = repair_trial
    manifest = pack_trial(folder, tmp_path / "out", withheld=withheld)
    assert set(manifest.files) == {
        "scenes/candidate.scene.json",
        "scenes/input.scene.json",
        "scenes/ground_truth.scene.json",
        "physics/physical_safety.json",
    }
    score = same(folder, tmp_path / "out")
    assert score.components["repair_f1"] is not None and 0 < score.components["repair_f1"] < 1
    with pytest.raises(BadInput, match="no new or empty folder"):
        pack_trial(folder, tmp_path / "out", withheld=withheld)
    with pytest.raises(BadInput, match="needs the case's withheld folder"):
        pack_trial(folder, tmp_path / "other")


def test_a_packed_text_case_scores_the_same(text_trial: TrialFolder, tmp_path: Path) -> None:
    manifest = pack_trial(text_trial, tmp_path / "out")
    assert manifest.overview is not None and len(manifest.overview.views) == len(manifest.renders) == 4
    assert same(text_trial, tmp_path / "out").status == "measured"


def test_zeros_stay_apart(tmp_path: Path) -> None:
    broken = Verdict(
        verifier="integrity",
        status="invalid",
        policy="p",
        reason="unresolved_dependencies: /Game/M",
        measurements={"reason_code": "unresolved_dependencies"},
    )
    invalid = store(tmp_path / "a", "image-to-scene/outdoor", {"integrity": broken})
    manifest = pack_trial(invalid, tmp_path / "invalid")
    assert manifest.candidate_integrity is not None
    assert manifest.candidate_integrity.leaves["content_and_dependency_parity"] == "invalid"
    assert same(invalid, tmp_path / "invalid").status == "zero_invalid_candidate"
    missing = store(tmp_path / "b", "text-to-scene", {"integrity": broken}, submitted=False)
    pack_trial(missing, tmp_path / "missing")
    assert same(missing, tmp_path / "missing").status == "zero_missing_submission"


def test_compressed_files_and_fewer_actors_than_the_minimum(
    repair_trial: tuple[TrialFolder, Path], tmp_path: Path
) -> None:
    folder, withheld = repair_trial
    out = tmp_path / "out"
    pack_trial(folder, out, withheld=withheld)
    value = json.loads((out / "bundle.json").read_text())
    for name, path in value["scenes"].items():
        with (out / path).open("rb") as plain, gzip.open(out / f"{path}.gz", "wb") as packed:
            shutil.copyfileobj(plain, packed)
        (out / path).unlink()
        del value["files"][path]
        value["scenes"][name] = f"{path}.gz"
        value["files"][f"{path}.gz"] = digest_file(out / f"{path}.gz")
    write_json(out / "bundle.json", value)
    same(folder, out)
    few = score_bundle(read_bundle(out), minimum_actors=1000).score
    assert (few.status, few.score) == ("zero_invalid_candidate", 0.0) and few.reason.startswith("minimum_actors")


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"schema_version": "code4scene.bundle.v2"}, "schema_version"),
        ({"extra": 1}, "extra"),
        ({"scenes": {"candidate": "../candidate.json"}}, "relative to the bundle"),
        ({"scenes": {"candidate": "/etc/passwd"}}, "relative to the bundle"),
        ({"scenes": {"candidate": "C:/scene.json"}}, "relative to the bundle"),
        ({"scenes": {"candidate": "..\\candidate.json"}}, "relative to the bundle"),
        ({"scenes": {"candidate": "scenes/candidate.scene.json"}}, "needs scenes.input, scenes.ground_truth"),
        ({"physics": None}, "needs physics.report"),
        ({"candidate_integrity": None}, "needs candidate_integrity"),
        ({"files": {}}, "no digest"),
    ],
)
def test_malformed_manifests_are_one_line(
    repair_trial: tuple[TrialFolder, Path], tmp_path: Path, change: dict[str, Any], said: str
) -> None:
    folder, withheld = repair_trial
    pack_trial(folder, tmp_path / "out", withheld=withheld)
    path = tmp_path / "out" / "bundle.json"
    path.write_text(json.dumps(json.loads(path.read_text()) | change))
    with pytest.raises(BadInput) as caught:
        read_bundle(tmp_path / "out")
    assert said in caught.value.line() and "\n" not in caught.value.line()


def test_changed_and_missing_files_are_refused(repair_trial: tuple[TrialFolder, Path], tmp_path: Path) -> None:
    folder, withheld = repair_trial
    pack_trial(folder, tmp_path / "out", withheld=withheld)
    report = tmp_path / "out" / "physics" / "physical_safety.json"
    report.write_text(report.read_text().replace("measured", "measured "))
    with pytest.raises(BadInput, match="its digest differs"):
        read_bundle(tmp_path / "out")
    report.unlink()
    with pytest.raises(BadInput, match="is missing"):
        read_bundle(tmp_path / "out")


def test_the_command_scores_a_bundle(text_trial: TrialFolder, tmp_path: Path) -> None:
    pack_trial(text_trial, tmp_path / "out")
    done = subprocess.run(
        [sys.executable, "-m", "c4s.cli", "bundle", "score", str(tmp_path / "out"), "--json"],
        env=dict(os.environ),
        text=True,
        capture_output=True,
        timeout=60,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["score"]["score"] == TrialScore.read(text_trial.score).score
    bad = subprocess.run(
        [sys.executable, "-m", "c4s.cli", "bundle", "score", str(tmp_path)],
        env=dict(os.environ),
        text=True,
        capture_output=True,
        timeout=60,
        check=False,
    )
    assert bad.returncode == 2 and bad.stderr.count("\n") == 1


def test_the_command_scores_a_packed_repair(repair_trial: tuple[TrialFolder, Path], tmp_path: Path) -> None:
    folder, withheld = repair_trial
    pack_trial(folder, tmp_path / "out", withheld=withheld)

    def shown(*options: str) -> str:
        line = [sys.executable, "-m", "c4s.cli", "bundle", "score", str(tmp_path / "out"), *options]
        return subprocess.run(line, capture_output=True, text=True, check=True).stdout

    stored = TrialScore.read(folder.score)
    assert json.loads(shown("--json"))["score"]["components"] == stored.components
    assert f"{stored.components['repair_f1']:.3f}" in shown()
