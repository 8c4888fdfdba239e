"""A mountain of bodies at one place: within the bounds it is measured, beyond them worth zero."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from collision_scenes import actor, cube, scene

from c4s.bounds import BOUNDS
from c4s.collision import contacts
from c4s.errors import BadInput
from c4s.verify.physics.verdict import measure_contacts, verify_physics


def heap(count: int) -> dict[str, Any]:
    """Cubes a centimetre apart, each within its tolerance of any other: none is settled by its contacts."""
    box = {"bounds": {"origin_cm": [0, 0, 0], "extent_cm": [900, 900, 900]}, "collision": {"collision_enabled": True}}
    return scene({"m": cube(10)}, *(actor(f"A{n}", "m", (n / 1000, 0, 100), **box) for n in range(count)))


@pytest.mark.parametrize(("bound", "most"), [("bodies", 39), ("box_pairs", 700), ("measured_pairs", 700)])
def test_a_scene_beyond_a_bound_has_no_penetration_score(
    monkeypatch: pytest.MonkeyPatch, bound: str, most: int
) -> None:
    crowd = heap(40)
    before = verify_physics("text-to-scene", crowd).measurements["leaf_results"][1]
    assert (before["status"], before["score"]) == ("measured", 1.0)
    monkeypatch.setitem(BOUNDS, bound, replace(BOUNDS[bound], most=most))
    with pytest.raises(BadInput, match=f"more than {most}"):
        contacts(crowd)
    record = measure_contacts("text-to-scene", crowd)
    assert record["contacts"] == [] and str(most) in record["crowded"]
    found, again = (verify_physics("text-to-scene", crowd, contacts=given) for given in (None, record))
    leaf = found.measurements["leaf_results"][1]
    assert (leaf["status"], leaf["score"], found.score) == ("not_evaluated", None, 0.5)
    assert "too crowded" in leaf["reason"] and found.measurements == again.measurements


def test_the_bound_counts_pairs_whatever_the_order_of_the_actors(monkeypatch: pytest.MonkeyPatch) -> None:
    crowd = heap(40)
    pairs = 40 * 39 // 2
    for actors in (crowd["actors"], crowd["actors"][::-1]):
        for bound in ("box_pairs", "measured_pairs"):
            with monkeypatch.context() as small:
                small.setitem(BOUNDS, bound, replace(BOUNDS[bound], most=pairs + 20))
                assert len(contacts(crowd | {"actors": actors})) == pairs
                small.setitem(BOUNDS, bound, replace(BOUNDS[bound], most=pairs - 1))
                with pytest.raises(BadInput):
                    contacts(crowd | {"actors": actors})


def edited(count: int) -> tuple[dict[str, Any], dict[str, Any]]:
    """A heap, and the start in which all of it stood elsewhere."""
    start = heap(count)
    for one in start["actors"]:
        one["transform"] = {**one["transform"], "location_cm": [5000.0, 0.0, 100.0]}
    return heap(count), start


def test_edits_beyond_a_bound_have_no_support_score(monkeypatch: pytest.MonkeyPatch) -> None:
    crowd, start = edited(40)
    before = verify_physics("image-to-scene/indoor", crowd, start).measurements
    assert before["leaf_results"][0]["status"] == before["diagnostic_leaves"][0]["status"] == "measured"
    monkeypatch.setitem(BOUNDS, "line_pairs", replace(BOUNDS["line_pairs"], most=700))
    floating = verify_physics("image-to-scene/indoor", crowd, start).measurements["leaf_results"][0]
    assert (floating["status"], floating["score"], floating["unresolved"]) == ("not_evaluated", None, 40)
    assert "too crowded" in floating["actors"][0]["reason"] and "more than 700" in floating["actors"][0]["reason"]
    monkeypatch.setitem(BOUNDS, "measured_pairs", replace(BOUNDS["measured_pairs"], most=30))
    near = verify_physics("image-to-scene/indoor", crowd, start).measurements["diagnostic_leaves"][0]
    assert (near["status"], near["unresolved"]) == ("not_evaluated", 40)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("scale", [0.0, 1e-300, 1e-12, 1e9, 1e12])
def test_scales_beyond_measure_are_measured_without_a_word(scale: float) -> None:
    box = {"bounds": {"origin_cm": [0, 0, 0], "extent_cm": [900, 900, 900]}, "collision": {"collision_enabled": True}}
    for scales in ((scale,) * 3, (scale, 1, 1), (1, -scale, scale)):
        made = scene({"m": cube(10)}, *(actor(name, "m", (0, 0, 100), (0, 30, 0), scales, **box) for name in "AB"))
        assert verify_physics("text-to-scene", made).score is not None
