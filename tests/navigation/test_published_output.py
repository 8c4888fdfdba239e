"""Measurements in the published probe's format, out and in."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import pytest

from c4s.errors import BadInput
from c4s.navigation import measure_snapshot, published_output, read_published
from c4s.records.navigation import NavigationEvidence
from c4s.verify.navigation.verdict import verify_navigation
from tests.hostile.called import call
from tests.navigation.published import faults_of
from tests.navigation.scenes import actor, crates, floor, scene

PEN = [
    actor(f"Pen wall {n}", low, high)
    for n, (low, high) in enumerate(
        [
            ((-400, -400, 0), (400, -380, 300)),
            ((-400, 380, 0), (400, 400, 300)),
            ((-400, -380, 0), (-380, 380, 300)),
            ((380, -380, 0), (400, 380, 300)),
        ]
    )
]
SCENE = scene(
    floor(6000, 6000),
    *crates(20, y=1500, start=-2000, step=200),
    *PEN,
    *crates(5, y=0, start=-200, step=90, size=40),
    actor("Lamp", (900, -900, 250), (940, -860, 290)),
    actor("Root", (900, -1500, -120), (960, -1440, -60)),
    actor("Ghost", (-900, -900, 0), (-860, -860, 40), collides=False),
)
MEASURED = measure_snapshot(SCENE)
OUTPUT = json.loads(json.dumps(published_output(MEASURED, SCENE)))


def foreign() -> dict[str, Any]:
    """The output without what the probe itself does not write."""
    return {key: copy.deepcopy(part) for key, part in OUTPUT.items() if key not in ("c4s", "walk_validation")}


def test_an_output_has_the_form_of_the_probes_own() -> None:
    assert faults_of(OUTPUT) == []
    counts, verdict = OUTPUT["diagnostics"], verify_navigation(MEASURED, SCENE)
    assert counts["status"] == "success" and OUTPUT["navmesh"]["settle"]["settled"]
    share = counts["connected_actor_count"] / counts["eligible_actor_count"]
    assert share == verdict.measurements["approachability"] < 1
    assert OUTPUT["walk_validation"]["completed_route_fraction"] == verdict.measurements["completion"]
    reasons = {row["label"]: row["ineligible_reason"] for row in OUTPUT["actors"].values() if not row["eligible"]}
    assert reasons == {"Floor": "surface", "Lamp": "raised", "Root": "buried", "Ghost": "collision_disabled"}


def test_ours_read_again_gives_the_same_verdict() -> None:
    again = verify_navigation(read_published(OUTPUT, SCENE), SCENE)
    assert again.plain() == verify_navigation(MEASURED, SCENE).plain()


def test_an_output_of_the_probe_tells_approachability_and_no_score() -> None:
    read = read_published(foreign(), SCENE)
    found = verify_navigation(read, SCENE)
    assert found.status == "not_evaluated" and found.score is None
    assert found.measurements["made_by"] == "published_probe" and found.measurements["reason_code"] == "not_certified"
    assert found.measurements["approachability"] == verify_navigation(MEASURED, SCENE).measurements["approachability"]
    moving = foreign()
    moving["navmesh"]["settle"] |= {"settled": False, "reason": "they never agreed"}
    found = verify_navigation(read_published(moving, SCENE), SCENE)
    assert found.measurements["reason_code"] == "not_settled" and "never agreed" in found.reason
    asked = foreign()
    row = next(row for row in asked["actors"].values() if row["connected"])
    row["connected"] = None
    assert read_published(asked, SCENE).fault == "not_settled"
    young = foreign()
    young["navmesh"]["parameters_after_rebuild"] = {"agent_radius": 50.0, "agent_height": 144.0}
    found = verify_navigation(read_published(young, SCENE), SCENE)
    assert found.measurements["reason_code"] == "settings_not_kept" and "height_cm" in found.reason


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"measurement_type": "ue_editor_actor_physics"}, "measurement_type"),
        ({"schema_version": "0.9.0"}, "0.9.0"),
        ({"schema_version": None}, "None"),
        ({"actors": []}, "no actors"),
        ({"diagnostics": {"status": "error", "error": "no world"}}, "no world"),
        ({"actors": {}}, "another scene"),
        ({"components": {"sizes": "many"}}, "component_cells"),
        ({"samples": {"accepted_count": "x"}}, "cells"),
    ],
)
def test_what_is_no_output_of_this_scene_is_refused(change: dict[str, Any], says: str) -> None:
    with pytest.raises(BadInput, match=says):
        read_published({**foreign(), **change}, SCENE)


def test_rows_that_were_edited_are_refused() -> None:
    edited = copy.deepcopy(OUTPUT)
    next(row for row in edited["actors"].values() if row["connected"] is False)["connected"] = True
    with pytest.raises(BadInput, match="c4s part"):
        read_published(edited, SCENE)
    pointless = foreign()
    next(row for row in pointless["actors"].values() if row["connected"])["projected_point_cm"] = ["a", 0, 0]
    with pytest.raises(BadInput, match="three numbers"):
        read_published(pointless, SCENE)
    with pytest.raises(BadInput, match="another scene"):
        published_output(MEASURED, scene(floor(100, 100)))
    older = NavigationEvidence.parse({**MEASURED.plain(), "places": []})
    with pytest.raises(BadInput, match="measure the scene anew"):
        published_output(older, SCENE)


def test_the_command_writes_and_reads_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    snapshot, out, own = tmp_path / "s.json", tmp_path / "o.json", tmp_path / "navigation.json"
    snapshot.write_text(json.dumps(SCENE))
    own.write_text(json.dumps(MEASURED.plain()))
    ask = ("verify", "navigation", "--snapshot", snapshot, "--json")
    given = (["--out", out], ["--evidence", out], ["--evidence", own])
    verdicts = [json.loads(call(capsys, *ask, *more).out) for more in given]
    assert verdicts[0] == verdicts[1] == verdicts[2] and verdicts[0]["status"] == "measured"
    assert json.loads(out.read_text()) == OUTPUT
