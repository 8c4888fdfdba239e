"""Bundles as the published packer writes them: the shapes it allows, and what of them counts."""

from __future__ import annotations

import gzip
import json
import math
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest

from c4s.bundle import BundleScore, read_bundle, score_bundle
from c4s.errors import BadInput
from c4s.files import digest_file
from tests.verify_repair.repair_scenes import actor, moved, scene, with_actor, without

LEAVES = ("candidate_snapshot_integrity", "content_and_dependency_parity", "asset_library_manifest_parity")
REPORT = {
    "report_id": "physical_safety",
    "status": "measured",
    "metrics": {
        "leaf_results": [
            {
                "leaf_id": "floating",
                "report_id": "physical_safety.floating",
                "status": "measured",
                "score": 0.2,
                "metadata": {"score_direction": "lower_is_better"},
            },
            {
                "leaf_id": "solid_penetration",
                "status": "measured",
                "score": 0.9,
                "metadata": {"score_direction": "higher_is_better"},
            },
        ]
    },
}
JUDGEMENT = {
    "status": "measured",
    "dimension_scores": {
        "global_prompt_alignment": 1.0,
        "composition_and_layout": 0.5,
        "style_atmosphere_coherence": 1.0,
        "completeness_and_polish": 1.0,
    },
    "structural_integrity_score": 1.0,
    "severe_structural_cap_eligible": False,
    "recorded_score": 0.875,
}
DECISIONS = [
    {
        "node_id": name,
        "semantic_family": family,
        "clause_index": clause,
        "effective_score": value,
        "included": True,
        "evaluation_status": "MATCH",
        "predicate_weight": 1.0,
        "score_known": True,
        "resolved_by": stage,
    }
    for name, family, clause, value, stage in (
        ("a", "content_quantity", 0, 1.0, "stage1"),
        ("b", "content_quantity", 0, 0.5, "stage3"),
        ("c", "spatial_composition", 1, 0.0, "stage3"),
    )
]
TRUTH = scene(
    actor("wall", "Wall", (0, 0, 50)),
    actor("plant", "Plant", (-300, 0, 50)),
    actor("chair", "Chair", (100, 0, 50)),
    actor("globe", "Globe", (700, 0, 50)),
)
START = with_actor(moved(without(TRUTH, "globe"), "chair", 200), actor("box", "Box", (500, 0, 50)))
FOUND = moved(without(TRUTH, "plant"), "chair", 200)


class Packed:
    """A bundle folder in the making."""

    def __init__(self, root: Path, setting: str, **files: Any) -> None:
        self.root = root
        self.manifest: dict[str, Any] = {
            "schema_version": "code4scene.bundle.v1",
            "task": {"id": "case", "setting": setting},
            "files": {},
            "run": {
                "model": "model-a",
                "submission": "submitted",
                "candidate_sha256": None,
                "batch_status": "complete",
                "authoritative": True,
            },
            "candidate_integrity": {
                "status": "valid",
                "recorded_status": "valid",
                "failure_reason": None,
                "leaves": dict.fromkeys(LEAVES, "valid"),
            },
        }
        for path, value in files.items():
            self.add(path, value)

    def add(self, path: str, value: Any) -> str:
        target = self.root / path
        target.parent.mkdir(parents=True, exist_ok=True)
        data = value if isinstance(value, bytes) else json.dumps(value).encode()
        target.write_bytes(gzip.compress(data) if path.endswith(".gz") else data)
        self.manifest["files"][path] = digest_file(target)
        return path

    def score(self, **options: Any) -> BundleScore:
        (self.root / "bundle.json").write_text(json.dumps(self.manifest))
        return score_bundle(read_bundle(self.root), **options)

    def refused(self) -> str:
        with pytest.raises(BadInput) as caught:
            self.score()
        assert "\n" not in caught.value.line()
        return caught.value.line()


@pytest.fixture
def image(tmp_path: Path) -> Packed:
    packed = Packed(tmp_path, "image-to-scene/outdoor")
    packed.manifest["scenes"] = {
        name: packed.add(f"scenes/{name}.scene.json", value)
        for name, value in (("input", START), ("ground_truth", TRUTH), ("candidate", FOUND))
    }
    packed.manifest["physics"] = {"report": packed.add("physics/physical_safety.json", REPORT)}
    return packed


@pytest.fixture
def text(tmp_path: Path) -> Packed:
    packed = Packed(tmp_path, "text-to-scene")
    packed.manifest |= {
        "scenes": {"candidate": packed.add("scenes/candidate.scene.json", scene(actor("crate", "Crate", (0, 0, 10))))},
        "physics": {"report": packed.add("physics/physical_safety.json", REPORT)},
        "semantic": {
            "decisions": packed.add("semantic/decisions.json", {"report_status": "measured", "decisions": DECISIONS})
        },
        "overview": {"judgement": packed.add("overview/judgement.json", JUDGEMENT)},
    }
    return packed


DETAILED = round((0.4 * 0.75 + 0.2 * 0.0) / 0.6, 4)
PHYSICS = round(0.5 * 1.0 + 0.5 * 0.9, 4)


def test_an_image_bundle_scores_offline(image: Packed) -> None:
    found = image.score()
    physics = round(0.5 * 0.8 + 0.5 * 0.9, 4)
    assert found.score.score == round(math.fsum((0.8 * 4 / 7, 0.2 * physics)), 6)
    assert [found.verdicts["repair"].measurements[name] for name in ("tp", "fp", "fn")] == [2, 2, 1]
    assert (found.score.status, found.score.configuration, found.score.engine) == ("measured", "model-a", "unreal")


def test_a_text_bundle_scores_offline(text: Packed) -> None:
    found = text.score().score
    assert (found.components["detailed"], found.components["overview"], found.components["physics"]) == (
        DETAILED,
        0.875,
        PHYSICS,
    )
    assert found.score == round(0.2 * DETAILED + 0.2 * PHYSICS + 0.6 * 0.875, 4)


def test_decisions_may_be_a_bare_list(text: Packed) -> None:
    text.add("semantic/decisions.json", DECISIONS)
    assert text.score().score.components["detailed"] == DETAILED


@pytest.mark.parametrize(
    "change", [{"semantic": None, "overview": None}, {"semantic": {"decisions": None}, "overview": {"views": None}}]
)
def test_what_a_text_bundle_lacks_is_worth_zero(text: Packed, change: dict[str, Any]) -> None:
    text.manifest |= change
    found = text.score().score
    assert (found.status, found.components["detailed"], found.components["overview"]) == (
        "measured_with_missing_zero",
        0.0,
        0.0,
    )
    assert found.score == round(0.2 * PHYSICS, 4)


def test_decisions_of_a_report_that_failed_do_not_count(text: Packed) -> None:
    text.add("semantic/decisions.json", {"report_status": "error", "decisions": DECISIONS})
    assert text.score().score.components["detailed"] == 0.0
    text.add("semantic/decisions.json", {"report_status": "measured", "decisions": None})
    assert text.score().verdicts["detailed"].status == "not_evaluated"


def test_without_a_snapshot_or_a_tested_actor_support_is_as_recorded(text: Packed) -> None:
    recorded = round(0.5 * 0.8 + 0.5 * 0.9, 4)
    text.add("scenes/candidate.scene.json", scene(actor("Floor", "Floor", (0, 0, 0))))
    assert text.score().score.components["physics"] == recorded
    text.manifest["scenes"] = None
    assert text.score().score.components["physics"] == recorded
    text.add("physics/physical_safety.json", {"status": "measured", "score": 0.7})
    assert text.score().score.components["physics"] == 0.0


def test_an_older_image_report_without_leaves_keeps_its_number(image: Packed) -> None:
    image.add("physics/physical_safety.json", {"status": "measured", "score": 0.7})
    assert image.score().score.components["physics"] == 0.7


@pytest.mark.parametrize("leaf", LEAVES)
def test_a_recorded_check_that_did_not_pass_makes_it_invalid(image: Packed, leaf: str) -> None:
    image.manifest["candidate_integrity"]["leaves"][leaf] = "error"
    found = image.score().score
    assert (found.status, found.score, found.components["repair_f1"]) == ("zero_invalid_candidate", 0.0, 0.0)
    assert found.reason == f"{leaf} is recorded as 'error'"
    image.manifest["candidate_integrity"]["leaves"][leaf] = None
    assert image.score().score.status == "measured"


def test_the_snapshot_is_checked_again(image: Packed) -> None:
    assert image.score(minimum_actors=3).score.status == "measured"
    assert image.score(minimum_actors=4).score.reason == "minimum_actors: 3 of at least 4 actors"
    broken = deepcopy(FOUND)
    broken["actors"][1]["bounds"] = None
    image.add("scenes/candidate.scene.json", broken)
    assert image.score().score.reason == "snapshot_schema: actor 1 (chair) has no bounds"


def test_an_invalid_or_missing_submission_needs_no_evidence(tmp_path: Path) -> None:
    packed = Packed(tmp_path, "image-to-scene/indoor")
    packed.manifest["candidate_integrity"] |= {"status": "invalid", "failure_reason": "packages are missing"}
    found = packed.score().score
    assert (found.status, found.reason) == ("zero_invalid_candidate", "packages are missing")
    packed.manifest |= {"run": {"submission": "missing"}, "candidate_integrity": None}
    assert packed.score().score.status == "zero_missing_submission"


def test_sections_may_be_null_and_unknown_keys_inside_them_are_kept(image: Packed) -> None:
    image.manifest |= {"run": None, "semantic": None, "overview": None, "renders": None, "notes": ["x"]}
    image.manifest["task"]["sha256"] = None
    image.manifest["physics"]["probe"] = "0.5.0"
    assert image.score().score.configuration == "unnamed"


@pytest.mark.parametrize("path", ["../x.json", "/x.json", "~/x.json", "a/../../x.json", ""])
def test_paths_stay_inside(image: Packed, path: str) -> None:
    image.manifest["physics"]["report"] = path
    image.manifest["files"][path] = "0" * 64
    assert "bundle" in image.refused()


def test_digests_are_digests(image: Packed) -> None:
    path = image.manifest["physics"]["report"]
    image.manifest["files"][path] = image.manifest["files"][path][:63]
    assert "files" in image.refused()
    image.manifest["files"][path] = "0" * 64
    assert "its digest differs" in image.refused()


def test_a_text_bundle_needs_its_physics_report(text: Packed) -> None:
    text.manifest["physics"] = None
    assert "needs physics.report" in text.refused()


def test_pictures_of_a_recorded_schedule_are_digested_too(text: Packed) -> None:
    plan = {"frames": {"f1": {"path": "renders/stage3/f1.png"}}, "claims": []}
    text.manifest["semantic"]["stage3_plan"] = text.add("semantic/stage3_plan.json", plan)
    assert "has no digest" in text.refused()
    text.add("renders/stage3/f1.png", b"picture")
    assert text.score().score.components["detailed"] == DETAILED
    text.add("semantic/stage3_plan.json", {"frames": {"f1": {}}})
    assert "have no paths" in text.refused()


@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("physics/physical_safety.json", [1]),
        ("semantic/decisions.json", "x"),
        ("overview/judgement.json", [1]),
        ("semantic/decisions.json", {"decisions": {"a": 1}}),
        ("overview/judgement.json", {"dimension_scores": {}}),
        ("overview/judgement.json", {"structural_integrity_score": 1}),
        ("semantic/decisions.json", b"{"),
    ],
)
def test_evidence_of_another_shape_is_refused(text: Packed, path: str, value: Any) -> None:
    text.add(path, value)
    text.refused()


def test_any_json_file_may_be_packed(image: Packed) -> None:
    plain = image.score().score
    for section in (image.manifest["scenes"], image.manifest["physics"]):
        for name, path in section.items():
            data = (image.root / path).read_bytes()
            del image.manifest["files"][path]
            section[name] = image.add(f"{path}.gz", data)
    assert image.score().score == plain


def test_labels_may_be_numbers_and_empty_sections_of_any_kind(image: Packed) -> None:
    plain = image.score().score.score
    image.manifest |= {"semantic": [], "overview": "", "renders": [{"path": "scenes/candidate.scene.json"}]}
    image.manifest["task"]["id"], image.manifest["run"] = 7, {"model": 5.5, "batch_status": ["complete"]}
    found = image.score().score
    assert (found.case_id, found.configuration, found.score) == ("7", "5.5", plain)
    image.manifest["candidate_integrity"] |= {"status": "invalid", "failure_reason": ["packages"]}
    assert image.score().score.reason == "['packages']"


@pytest.mark.parametrize("written", ["./{}", "{}/", "scenes\\{name}", "scenes//{name}"])
def test_paths_are_read_in_their_plain_form(image: Packed, written: str) -> None:
    plain = image.score().score.score
    image.manifest["scenes"] = {
        role: written.format(path, name=path.partition("/")[2]) for role, path in image.manifest["scenes"].items()
    }
    assert image.score().score.score == plain


def test_digests_are_compared_as_written(image: Packed) -> None:
    image.manifest["files"] = {path: digest.upper() for path, digest in image.manifest["files"].items()}
    assert "its digest differs" in image.refused()
