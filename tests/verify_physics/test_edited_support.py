"""Support of edited actors, case by case of the published probe: lines down through the vertices, groups, panels."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from c4s.packs.store import PackStore
from c4s.verify.physics.edited import edit_order
from c4s.verify.physics.edited_support import groups_of, spans_area
from c4s.verify.physics.verdict import measure_support, verify_physics

I2S = "image-to-scene/indoor"
CUBE = "/Engine/BasicShapes/Cube.Cube"
MESHES = PackStore([]).recorded_mesh
BODY = {"kind": "box", "center": [0, 0, 0], "half_extent": [50, 50, 50]}
FACTS = {"sha256": None, "bounds_min_cm": [-50, -50, -50], "bounds_max_cm": [50, 50, 50], "collision": [BODY]}


def box(name: str, centre: Any, half: Any = (50, 50, 50), rotation: Any = (0, 0, 0), **more: Any) -> dict[str, Any]:
    """An engine cube, scaled to half extents (cm); its box is that of the unturned one unless given."""
    transform = {
        "location_cm": [float(x) for x in centre],
        "rotation_deg": [float(x) for x in rotation],
        "scale": [h / 50 for h in half],
    }
    component = {
        "name": "Mesh",
        "class": "/Script/Engine.StaticMeshComponent",
        "mesh": CUBE,
        "transform": transform,
        "collision_enabled": True,
    }
    return {
        "stable_actor_id": name,
        "name": name,
        "label": name,
        "class": "/Script/Engine.StaticMeshActor",
        "asset_path": CUBE,
        "component_asset_paths": [CUBE],
        "actor_tags": [],
        "transform": transform,
        "bounds": {"origin_cm": transform["location_cm"], "extent_cm": [float(h) for h in half]},
        "c4s": {"components": [component]},
    } | more


def scene(*actors: dict[str, Any]) -> dict[str, Any]:
    return {"schema_version": "0.3.0", "actors": list(actors), "c4s": {"meshes": {CUBE: FACTS}}}


def footing(edits: Any, rest: Any = (), *, meshes: Any = MESHES, **more: Any) -> dict[str, dict[str, Any]]:
    """The support record's rows by name, of edited actors among others."""
    record = measure_support(I2S, scene(*rest, *edits), scene(*rest), meshes=meshes, **more)
    return {row["actor"]: row for row in record["rows"]}


SLAB = box("Slab", (0, 0, -10), (500, 500, 10))
BY_BOX_OR_VERTICES = pytest.mark.parametrize("meshes", [MESHES, None], ids=["vertices", "box"])


@BY_BOX_OR_VERTICES
@given(gap=st.floats(-30, 30))
@example(gap=5.0)
@example(gap=-5.0)
@example(gap=0.0)
def test_it_stands_up_to_five_above_and_five_into_its_support(meshes: Any, gap: float) -> None:
    assume(gap in (5.0, -5.0) or abs(abs(gap) - 5) > 1e-4)
    row = footing([box("Crate", (0, 0, 50 + gap))], [SLAB], meshes=meshes)["Crate"]
    assert row["method"] == ("box" if meshes is None else "vertices")
    assert row["gap_cm"] == pytest.approx(gap, abs=1e-6)
    held = abs(gap) <= 5
    assert (row["state"], row["mode"]) == (("supported", "ground") if held else ("floating", "none"))
    assert row["held_by"] == (["Slab"] if held else [])


def test_nothing_below_is_no_gap_and_no_support() -> None:
    row = footing([box("Crate", (9000, 0, 50))], [SLAB])["Crate"]
    assert (row["state"], row["gap_cm"]) == ("floating", None)
    far = footing([box("Crate", (0, 0, 5200))], [SLAB])["Crate"]
    assert (far["state"], far["gap_cm"]) == ("floating", None)


def test_roofs_above_and_bodies_around_hold_nothing() -> None:
    roof, hall = box("Roof", (0, 0, 310), (400, 400, 10)), box("Hall", (0, 0, 100), (300, 300, 150))
    assert footing([box("Lamp", (0, 0, 285), (10, 10, 10))], [roof])["Lamp"]["state"] == "floating"
    for meshes in (MESHES, None):
        assert footing([box("Crate", (0, 0, 100))], [hall], meshes=meshes)["Crate"]["state"] == "floating"


def test_what_touches_a_thick_ceiling_rests_on_its_underside() -> None:
    """Lines start 2 above the box, there inside the ceiling, whose triangles are met from both sides."""
    ceiling, lamp = box("Ceiling", (0, 0, 310), (400, 400, 10)), box("Lamp", (0, 0, 290), (10, 10, 10))
    assert footing([lamp], [ceiling])["Lamp"]["held_by"] == ["Ceiling"]
    assert footing([lamp], [ceiling], meshes=None)["Lamp"]["state"] == "floating"


@pytest.mark.parametrize(
    "cover",
    [
        {"label": "Water_1"},
        {"label": "garden_pool"},
        {"actor_tags": ["vfx"]},
        {"class": "/Game/P/BP_Mist.ExponentialHeightFog"},
    ],
)
def test_what_is_no_solid_hides_what_lies_behind_it(cover: dict[str, Any]) -> None:
    sheet = box("Sheet", (0, 0, 0.5), (100, 100, 0.5), **cover)
    crate = box("Crate", (0, 0, 51))
    assert footing([crate], [SLAB, sheet])["Crate"]["state"] == "floating"
    assert footing([crate], [SLAB, box("Sheet", (0, 0, 0.5), (100, 100, 0.5))])["Crate"]["held_by"] == ["Sheet"]


def test_a_word_inside_another_is_no_such_word() -> None:
    named = box("Seaside_Lighthouse_Carpool", (0, 0, -10), (500, 500, 10))
    assert footing([box("Crate", (0, 0, 50))], [named])["Crate"]["state"] == "supported"


def test_a_component_without_collision_stops_no_line() -> None:
    ghost = box("Ghost", (0, 0, 0.5), (100, 100, 0.5))
    ghost["c4s"]["components"][0]["collision_enabled"] = False
    assert footing([box("Crate", (0, 0, 51))], [SLAB, ghost])["Crate"]["held_by"] == ["Slab"]


def test_vertices_must_rest_on_an_area() -> None:
    """Two corners over a ledge rest on a line; in plan three make an area. Without vertices one place is enough."""
    ledge = box("Ledge", (-540, 0, -10), (500, 500, 10))
    crate = box("Crate", (0, 0, 50))
    row = footing([crate], [ledge])["Crate"]
    assert (row["state"], row["gap_cm"]) == ("floating", pytest.approx(0))
    assert footing([box("Crate", (10, 0, 50))], [ledge], meshes=None)["Crate"]["state"] == "floating"
    over = box("Ledge", (-520, 0, -10), (500, 500, 10))
    assert footing([crate], [over], meshes=None)["Crate"]["held_by"] == ["Ledge"]
    corner = box("Corner", (40, 40, -10), (20, 20, 10))
    assert footing([crate], [ledge, corner])["Crate"]["held_by"] == ["Ledge", "Corner"]


def test_points_on_a_line_span_no_area_unless_rounding_bends_it() -> None:
    assert not spans_area([(0.0, 0.0), (0.0, 5.0), (0.0, 9.0), (0.00001, 3.0)])
    assert spans_area([(0.0, 0.0), (0.0, 5.0), (0.01, 9.0)])
    assert spans_area([(t * math.cos(0.5), t * math.sin(0.5)) for t in (0.0, 3.3, 7.1, 9.9)])


def test_every_vertex_counts_whatever_its_height() -> None:
    """A beam through a deck rests with its top vertices, although it reaches far below."""
    deck = [box("Deck", (0, 0, 98), (80, 200, 1))]
    assert footing([box("Beam", (0, 0, 50))], deck)["Beam"]["state"] == "supported"
    assert footing([box("Beam", (0, 0, 50))], deck, meshes=None)["Beam"]["state"] == "floating"


def edits_in_a_row(count: int) -> list[dict[str, Any]]:
    return [box(f"E{n}", (1000.0 + 300 * n, 0, 50)) for n in range(count)]


def test_edits_of_one_group_do_not_hold_each_other_and_hide_the_floor() -> None:
    table, cup = box("Table", (0, 0, 50)), box("Cup", (0, 0, 110), (10, 10, 10))
    together = footing([table, cup], [SLAB])
    assert (together["Table"]["state"], together["Cup"]["state"]) == ("supported", "floating")
    assert together["Cup"]["gap_cm"] is None
    apart = footing([table, *edits_in_a_row(3), cup], [SLAB])
    assert apart["Cup"]["held_by"] == ["Table"]
    assert footing([table, cup], [SLAB], alone=True)["Cup"]["held_by"] == ["Table"]


def test_the_verdict_tells_whom_only_the_probe_finds_floating() -> None:
    rest = [SLAB]
    edits = [box("Table", (0, 0, 50)), box("Cup", (0, 0, 110), (10, 10, 10))]
    verdict = verify_physics(I2S, scene(*rest, *edits), scene(*rest), meshes=MESHES)
    floating = verdict.measurements["leaf_results"][0]
    near = verdict.measurements["diagnostic_leaves"][0]
    assert (floating["score"], floating["floating_actors"], floating["metric"]) == (
        0.5,
        ["Cup"],
        "ground_or_lateral_v1",
    )
    assert (near["score"], near["weight"], near["metric"]) == (0.0, None, "i2s-edited-support-5cm")
    assert verdict.score == 0.75
    notes = {note["code"]: note["actors"] for note in verdict.advisories}
    assert notes["floats_beside_a_body"] == ["Cup"]


@given(st.lists(st.integers(0, 5000), unique=True, max_size=60))
def test_groups_are_four_in_a_row(order: list[int]) -> None:
    groups = groups_of(order)
    assert list(groups) == order
    assert all(groups[actor] == frozenset(order[n - n % 4 : n - n % 4 + 4]) for n, actor in enumerate(order))


def test_a_thousand_edits_are_measured_one_by_one() -> None:
    assert {len(group) for group in groups_of(range(1000)).values()} == {1}
    assert {len(group) for group in groups_of(range(999)).values()} == {4, 3}


def test_edits_are_measured_added_first_then_moved_then_changed() -> None:
    start = scene(*(box(name, (0, 0, 0)) for name in "ABCD"))
    after = scene(
        box("New", (0, 0, 0)),
        box("D", (1, 0, 0)),
        box("C", (0, 0, 0), label="renamed"),
        box("B", (1, 0, 0), label="renamed"),
        box("A", (0, 0, 0), label="renamed"),
        box("Newer", (0, 0, 0)),
    )
    assert [after["actors"][index]["name"] for index in edit_order(after, start)] == [
        "New",
        "Newer",
        "B",
        "D",
        "A",
        "C",
    ]


WALL = box("Wall", (0, -20, 150), (200, 20, 150))


def picture(gap: float, half: Any = (20, 1, 30), **more: Any) -> dict[str, Any]:
    """A panel in front of the wall, its back ``gap`` cm from it."""
    return box("Picture", (0, gap + half[1], 150), half, **more)


@given(gap=st.floats(-0.49, 12))
@example(gap=5.0)
@example(gap=0.0)
def test_a_panel_hangs_up_to_five_from_what_it_lies_on(gap: float) -> None:
    assume(gap == 5.0 or abs(gap - 5) > 1e-4)
    row = footing([picture(gap)], [WALL])["Picture"]
    if gap <= 5:
        assert (row["state"], row["mode"], row["held_by"]) == ("supported", "lateral", ["Wall"])
        assert (row["lateral_share"], row["lateral_cm"]) == (1.0, pytest.approx(max(gap, 0.0), abs=1e-6))
    else:
        assert (row["state"], row["mode"], row["lateral_share"]) == ("floating", "none", 0.0)


def test_a_panel_deep_in_the_wall_sees_nothing_of_it() -> None:
    """Lines start 0.5 inside the face; triangles have no inside, bodies do."""
    assert footing([picture(-1.0)], [WALL])["Picture"]["state"] == "floating"
    assert footing([picture(-1.0)], [WALL], meshes=None)["Picture"]["mode"] == "lateral"


@given(ratio=st.floats(1, 9))
@example(ratio=4.0)
def test_what_holds_a_panel_has_a_face_four_times_as_large(ratio: float) -> None:
    assume(ratio == 4.0 or abs(ratio - 4) > 1e-6)
    board = box("Board", (0, -20, 150), (20, 20, 30 * ratio))
    assert (footing([picture(1.0)], [board])["Picture"]["state"] == "supported") is (ratio >= 4)


@given(thinness=st.floats(1.5, 9), side=st.sampled_from([0, 2]))
@example(thinness=4.0, side=0)
@example(thinness=4.0, side=2)
def test_a_panel_is_four_times_as_wide_and_high_as_thick(thinness: float, side: int) -> None:
    assume(thinness == 4.0 or abs(thinness - 4) > 1e-6)
    half = [30.0, 2.0, 30.0]
    half[side] = 2.0 * thinness
    assert (footing([picture(1.0, half)], [WALL])["Picture"]["state"] == "supported") is (thinness >= 4)


@pytest.mark.parametrize(("tilt", "held"), [(0, True), (29.9, True), (30.1, False), (60, False)])
def test_a_panel_stands_upright(tilt: float, held: bool) -> None:
    leaning = box("Picture", (0, 2.5, 150), (8, 0.25, 4), (0, 0, tilt), bounds=WALL["bounds"])
    assert (footing([leaning], [WALL])["Picture"]["mode"] == "lateral") is held


def test_a_panel_turned_in_its_plane_needs_an_upright_side() -> None:
    """Turned by 45 degrees neither side rises by 0.75 of its length."""
    for turn, held in ((40, True), (45, False), (50, True)):
        turned = box("Picture", (0, 2, 150), (20, 1, 30), (turn, 0, 0))
        assert (footing([turned], [WALL])["Picture"]["mode"] == "lateral") is held


def test_shelves_and_blocks_are_not_held_sideways() -> None:
    shelf = box("Shelf", (0, 20, 150), (20, 20, 1))
    block = box("Block", (0, 20, 150), (20, 20, 20))
    assert footing([shelf], [WALL])["Shelf"]["state"] == footing([block], [WALL])["Block"]["state"] == "floating"


@pytest.mark.parametrize(("lowest", "lines"), [(168, 1), (156, 2)])
def test_two_of_the_25_lines_of_a_face_are_enough(lowest: float, lines: int) -> None:
    """The outermost column of lines lies at x = 16, its upper two lines at z = 162 and 174."""
    edge = box("Edge", (112, -20, lowest + 100), (100, 20, 100))
    row = footing([picture(1.0, (20, 1, 30))], [edge])["Picture"]
    assert row["lateral_share"] == pytest.approx(lines / 25)
    assert (row["state"] == "supported") is (lines > 1)


def test_what_is_no_solid_and_other_edits_hold_no_panel_and_hide_the_wall() -> None:
    sheet = {"centre": (0, 0.2, 150), "half": (200, 0.2, 150)}
    held = footing([picture(1.0)], [WALL, box("Sheet", **sheet)])["Picture"]
    hidden = footing([picture(1.0)], [WALL, box("Sheet", **sheet, label="Sky sheet")])["Picture"]
    edited = footing([box("Sheet", **sheet), picture(1.0)], [WALL])["Picture"]
    assert (held["held_by"], hidden["state"], edited["state"]) == (["Sheet"], "floating", "floating")


def test_a_slanting_surface_holds_no_panel() -> None:
    slanting = box("Slanting", (0, -25, 150), (300, 20, 300), (0, 40, 0), bounds=WALL["bounds"])
    assert footing([picture(1.0, (5, 0.5, 5))], [slanting])["Picture"]["state"] == "floating"


def test_ground_comes_before_the_wall() -> None:
    row = footing([box("Picture", (0, 2, 30), (20, 1, 30))], [WALL, SLAB])["Picture"]
    assert (row["mode"], row["lateral_share"]) == ("ground", None)


def test_missing_evidence_proves_nothing() -> None:
    unknown = box("Unknown", (0, 0, -30), (50, 50, 30))
    unknown["c4s"]["components"][0]["mesh"] = "/Game/P/SM_Lost.SM_Lost"
    rows = footing([box("Crate", (0, 0, 54)), box("Far", (900, 0, 50)), unknown], [])
    assert [rows[name]["state"] for name in ("Crate", "Far", "Unknown")] == ["unresolved", "floating", "unresolved"]
    assert "near an actor" in rows["Crate"]["reason"] and "SM_Lost" in rows["Unknown"]["reason"]
    assert footing([box("Crate", (0, 0, 50))], [SLAB, unknown])["Crate"]["state"] == "supported"
    shapeless = footing([box("Crate", (0, 0, 50), bounds=None)], [SLAB])["Crate"]
    assert (shapeless["state"], shapeless["reason"]) == ("unresolved", "no valid world box")


@BY_BOX_OR_VERTICES
def test_a_damaged_component_leaves_its_actor_open_whether_it_collides_or_not(meshes: Any) -> None:
    for collides in (True, False):
        broken = box("Broken", (0, 0, 50))
        part = broken["c4s"]["components"][0]
        part |= {"collision_enabled": collides, "transform": part["transform"] | {"location_cm": [0, "x", 0]}}
        row = footing([broken], [SLAB], meshes=meshes)["Broken"]
        assert row["state"] == "unresolved" and row["reason"]
