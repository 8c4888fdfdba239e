"""Repairs beside their truth: pairs of views, measured and judged, reported and never scored."""

from __future__ import annotations

import io
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from c4s.errors import BadInput
from c4s.files import digest_file
from c4s.judge.desk import Desk
from c4s.judge.model.overview import ContractBroken
from c4s.judge.registry import make_judgements
from c4s.protocol.paired import PAIRED_BLEND, PAIRED_WEIGHTS, blended, paired_score
from c4s.records.evidence import Evidence
from c4s.records.judge import RULE_JUDGE
from c4s.records.judgement import Judgements
from c4s.score.case import case_score
from c4s.verify.paired.verifier import PAIRED, verify_paired
from c4s.verify.registry import weighed_of
from tests.judge.judge_endpoint import SAME, JudgeEndpoint, completion, parts_of
from tests.judge.model_evidence import QWEN, judged
from tests.score.test_case_score import I2S

SIZE = (36, 64)


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A cache of its own for each test."""
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))


def scene(shift: int, shade: int = 200) -> tuple[bytes, bytes]:
    """A picture and its mask: a box before the far plane, moved by some pixels."""
    pixels = np.full((*SIZE, 3), 40, dtype=np.uint8)
    actor, depth = np.full(SIZE, -1, dtype=np.int32), np.full(SIZE, np.inf, dtype=np.float32)
    box = slice(10, 26), slice(10 + shift, 30 + shift)
    pixels[box], actor[box], depth[box] = shade, 0, 500.0
    png, npz = io.BytesIO(), io.BytesIO()
    Image.fromarray(pixels).save(png, "PNG")
    np.savez_compressed(npz, actor=actor, depth_cm=depth, names=np.array(["Box"]), labels=np.array(["Box"]))
    return png.getvalue(), npz.getvalue()


def evidence(root: Path, *shifts: int, masks: bool = True, truth: bool = True) -> Evidence:
    """A repair with a pair of views a shift; with 0 both are equal."""
    folder = root / "captures"
    folder.mkdir(parents=True)
    views: list[dict[str, Any]] = [{"name": "view-01", "file": "view-01.png", "purpose": "reference"}]
    (folder / "view-01.png").write_bytes(scene(0)[0])
    for number, shift in enumerate(shifts, 1):
        for purpose, moved in (("target", shift), ("truth", 0)) if truth else (("target", shift),):
            name = f"{purpose}-{number}"
            png, npz = scene(moved)
            (folder / f"{name}.png").write_bytes(png)
            (folder / f"{name}.npz").write_bytes(npz)
            actors = {"actors": f"{name}.npz"} if masks else {}
            views.append({"name": name, "file": f"{name}.png", "purpose": purpose, "pair": str(number), **actors})
    (folder / "captures.json").write_text(json.dumps({"views": views}))
    return Evidence(setting="image-to-scene/indoor", prompt="Repair it.", files={"captures": folder / "captures.json"})


def test_equal_pictures_measure_one_and_a_shift_costs(tmp_path: Path) -> None:
    verdict = verify_paired(make_judgements(RULE_JUDGE, evidence(tmp_path, 0, 12)))
    assert (verdict.verifier, verdict.status, verdict.population) == ("paired", "measured", {"views": 2, "by_model": 0})
    same, moved = verdict.measurements["views"]
    assert set(same["measures"].values()) == {1.0} and set(same["dimensions"].values()) == {1.0}
    assert moved["measures"]["foreground_silhouette_iou"] == pytest.approx(8 / 32)
    assert all(0 < value < 1 for value in moved["measures"].values())
    assert verdict.score is not None and 0 < verdict.score < 1
    taken = verdict.measurements["taken"]
    assert taken["landmark_content"] == [] and taken["lighting_fidelity"] == ["rgb_perceptual_similarity"]
    assert "landmark_content" not in verdict.measurements["dimensions"]


def test_without_masks_what_pictures_alone_tell_is_left(tmp_path: Path) -> None:
    verdict = verify_paired(make_judgements(RULE_JUDGE, evidence(tmp_path, 3, masks=False)))
    assert set(verdict.measurements["dimensions"]) == {"lighting_fidelity"}


@pytest.mark.parametrize("case", ["no truth", "no views"])
def test_without_a_pair_nothing_is_evaluated_and_the_case_is_scored(case: str, tmp_path: Path) -> None:
    given = evidence(tmp_path, *((3,) if case == "no truth" else ()), truth=False)
    verdict = verify_paired(make_judgements(RULE_JUDGE, given))
    assert (verdict.status, verdict.score) == ("not_evaluated", None)
    assert verdict.reason == "no picture of the truth was taken from the held-out cameras"
    scored = {"setting": "image-to-scene/indoor", "submitted": True, "judge": "rule", "engine": "headless"}
    with_it, without = (
        case_score(case_id="c", configuration="a", repeat=1, verdicts=verdicts, **scored)  # type: ignore[arg-type]
        for verdicts in ({**I2S, "paired": verdict}, I2S)
    )
    assert with_it == without and with_it.status == "measured"


def test_it_has_no_weight_in_any_setting() -> None:
    for setting in PAIRED.settings:
        assert PAIRED not in weighed_of(setting)
        assert not any("judgements" in verifier.needs for verifier in weighed_of(setting))
    assert not PAIRED.headlines


def test_a_model_sees_the_truth_first_and_its_scores_are_blended(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    said = {**SAME, "landmark_content": 1, "lighting_fidelity": 2}
    with JudgeEndpoint(lambda body: completion(said)) as endpoint:
        monkeypatch.setenv("C4S_JUDGE_URL", endpoint.url)
        given = evidence(tmp_path, 0, 5)
        made = judged(given)
    assert made.paired is not None and len(endpoint.bodies) == len(made.schedule) == 2
    assert [row.views for row in made.schedule] == [["truth-1", "target-1"], ["truth-2", "target-2"]]
    assert made.pictures["truth-1"] == digest_file(tmp_path / "captures/truth-1.png")
    first = made.paired.views[0]
    assert first.dimensions == pytest.approx(
        {
            "composition_layout": 1.0,
            "silhouette_geometry": 1.0,
            "material_fidelity": 1.0,
            "landmark_content": 0.25,
            "lighting_fidelity": 0.75,
        }
    )
    texts = [part["text"] for part in parts_of(endpoint.bodies[0]) if part["type"] == "text"]
    assert texts == ["The scene as it should be, then as it is:", "view-1:", "view-2:"]
    verdict = verify_paired(made)
    assert verdict.population == {"views": 2, "by_model": 2}
    assert verdict.measurements["taken"]["material_fidelity"] == ["vlm"]
    assert PAIRED.components(verdict).keys() == {"score", *(f"dimensions.{name}" for name in PAIRED_WEIGHTS)}
    assert len([*PAIRED.findings(verdict)]) == 2


@pytest.mark.parametrize("said", [{**SAME, "material_fidelity": 4.5}, {**SAME, "material_fidelity": True}, {}, "4"])
def test_an_answer_off_the_scale_is_a_fault(said: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with JudgeEndpoint(lambda body: completion(said)) as endpoint:
        monkeypatch.setenv("C4S_JUDGE_URL", endpoint.url)
        given = evidence(tmp_path, 5)
        with pytest.raises(ContractBroken):
            judged(given)
        made = judged(given, Desk(accept_faults=True))
    assert made.paired is not None and made.paired.views[0].said == {}
    assert made.paired.views[0].reason.startswith("error: ")
    assert made.accepted_faults == ["paired: malformed"] * len(made.paired.views)
    assert verify_paired(made).advisories[0]["code"] == "accepted_faults"


def test_a_picture_that_is_not_the_one_that_was_taken_is_refused(tmp_path: Path) -> None:
    given = evidence(tmp_path, 5)
    noted = {path: digest_file(path) for path in (tmp_path / "captures").iterdir()}
    given.noted_files = noted
    before = make_judgements(RULE_JUDGE, given)
    assert before.inputs["captures/truth-1.png"] == noted[tmp_path / "captures/truth-1.png"]
    (tmp_path / "captures/truth-1.png").write_bytes(scene(5)[0])
    with pytest.raises(BadInput, match="has changed"):
        make_judgements(RULE_JUDGE, given)


def test_the_blend_is_the_published_one_and_what_is_missing_gives_its_share_to_the_rest() -> None:
    assert sum(PAIRED_WEIGHTS.values()) == pytest.approx(1.0)
    assert all(sum(parts.values()) == pytest.approx(1.0) for parts in PAIRED_BLEND.values())
    measures = {"foreground_silhouette_iou": 0.5, "depth_edge_similarity": 1.0}
    assert blended({"composition_layout": 0.0}, measures)["composition_layout"] == pytest.approx(0.3)
    assert blended({}, measures) == pytest.approx({"composition_layout": 0.75, "silhouette_geometry": 0.75})
    assert paired_score({}) is None and paired_score({"landmark_content": 0.5}) == pytest.approx(0.5)
    assert blended({"landmark_content": 1.0}, {}) == {"landmark_content": 1.0}


def test_the_judge_of_a_repair_is_told_in_its_judgements(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with JudgeEndpoint(lambda body: completion(SAME)) as endpoint:
        monkeypatch.setenv("C4S_JUDGE_URL", endpoint.url)
        made = judged(evidence(tmp_path, 0))
    made.write(tmp_path / "judgements.json")
    read = Judgements.read(tmp_path / "judgements.json")
    assert read == made and (read.judge, read.kind, read.claims) == (QWEN.name, "model", [])
