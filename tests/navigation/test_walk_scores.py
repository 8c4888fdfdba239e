"""The Embodied Utility Score of scenes of known answer: rules, readings, withholding, cheats."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from c4s.navigation import NavigationSettings, judge_walk, measure_snapshot
from c4s.protocol.navigation import arrival_radius_cm
from c4s.protocol.settings import SETTINGS
from c4s.records.navigation import LETTERS, NavigationEvidence
from c4s.records.verdict import Verdict
from c4s.verify.navigation.verdict import verify_navigation
from c4s.verify.navigation.verifier import NAVIGATION
from c4s.verify.registry import weighed_of
from tests.navigation.scenes import RAMP, actor, crates, floor, scene

WIDE = floor(6000, 6000)


def measured(*actors: dict[str, Any]) -> NavigationEvidence:
    return measure_snapshot(scene(*actors))


def verdict(*actors: dict[str, Any]) -> Verdict:
    """The verdict over evidence that went through its file."""
    plain = json.loads(json.dumps(measured(*actors).plain()))
    return verify_navigation(NavigationEvidence.parse(plain), scene(*actors))


def notes(found: Verdict) -> dict[str, dict[str, Any]]:
    return {note["code"]: note for note in found.advisories}


def falls(evidence: NavigationEvidence) -> dict[str, str]:
    pool = [target.label for target in evidence.targets if not target.left]
    return dict(zip(pool, (LETTERS[letter] for letter in evidence.builds[-1].falls), strict=True))


def spread(count: int = 20) -> list[dict[str, Any]]:
    """Crates all over the wide plate."""
    places = [(x, y) for x in range(-2500, 2501, 1000) for y in range(-2500, 2501, 1200)]
    return [actor(f"Crate {n}", (x, y, 0), (x + 60, y + 60, 60)) for n, (x, y) in enumerate(places[:count])]


def pen(label: str = "Pen") -> list[dict[str, Any]]:
    """Four walls without a door, around the origin."""
    return [
        actor(f"{label} wall {n}", low, high)
        for n, (low, high) in enumerate(
            [
                ((-400, -400, 0), (400, -380, 300)),
                ((-400, 380, 0), (400, 400, 300)),
                ((-400, -380, 0), (-380, 380, 300)),
                ((380, -380, 0), (400, 380, 300)),
            ]
        )
    ]


def test_all_of_an_open_place_is_approached_and_walked() -> None:
    found = verdict(WIDE, *spread())
    assert (found.status, found.score) == ("measured", 1.0)
    assert NAVIGATION.components(found) == {"score": 1.0, "approachability": 1.0, "completion": 1.0}
    assert found.population == {"actors": 21, "pool": 20, "floor_level": 20, "walks": 3, "arrived": 3}
    assert found.measurements["arrival_radius_cm"] == 300.0
    assert not found.advisories


def test_what_a_pen_without_a_door_holds_is_not_approached_and_stays_in_the_pool() -> None:
    inside = [actor(f"Prisoner {n}", (-200 + n * 90, 0, 0), (-160 + n * 90, 40, 40)) for n in range(5)]
    evidence = measured(WIDE, *spread(), *pen(), *inside)
    fallen = falls(evidence)
    assert {fallen[f"Prisoner {n}"] for n in range(5)} == {"unconnected"}
    found = verdict(WIDE, *spread(), *pen(), *inside)
    reached = sum(fall == "connected" for fall in fallen.values())
    assert found.population["floor_level"] == 29 and 20 <= reached <= 24
    assert found.measurements["approachability"] == pytest.approx(reached / 29)


def test_fewer_than_fifteen_targets_are_a_zero_that_is_measured() -> None:
    found = verdict(WIDE, *spread(14))
    assert (found.status, found.score, found.measurements["zero_rule"]) == ("measured", 0.0, "small_pool")
    assert verdict(WIDE, *spread(15)).score == 1.0


def test_targets_that_no_way_leads_to_are_a_certified_zero() -> None:
    found = verdict(*crates(16, y=0.0))
    assert (found.status, found.score, found.measurements["zero_rule"]) == ("measured", 0.0, "nothing_approachable")
    assert "completion" not in NAVIGATION.components(found)


def test_an_empty_scene_is_a_zero() -> None:
    assert verify_navigation(measure_snapshot(scene()), scene()).measurements["zero_rule"] == "small_pool"


def test_a_scene_without_a_route_is_withheld_and_no_zero() -> None:
    found = verdict(floor(420, 420), *crates(16, y=190.0, start=-200, step=25, size=10))
    assert (found.status, found.score) == ("not_evaluated", None)
    assert found.measurements["reason_code"] == "no_route" and not found.measurements["excluded"]
    assert found.measurements["approachability"] > 0 and NAVIGATION.components(found) == {}


def test_what_was_not_probed_or_is_not_known_is_excluded() -> None:
    assert verify_navigation(None, scene()).measurements == {"reason_code": "not_probed", "excluded": True}
    published = {"actors": [{**one, "c4s": None} for one in spread()]}
    found = verify_navigation(measure_snapshot(published), published)
    assert found.measurements["reason_code"] == "content_failure" and found.measurements["excluded"]


def test_a_scene_that_is_too_large_is_withheld() -> None:
    far = [actor(f"Far {n}", (n * 9e5, n * 9e5, 0), (n * 9e5 + 50, n * 9e5 + 50, 50)) for n in (0, 1)]
    found = verdict(WIDE, *spread(), *far)
    assert found.measurements["reason_code"] == "navigation_too_large"


def test_builds_that_do_not_agree_are_not_certified() -> None:
    evidence = measured(WIDE, *spread())
    one = evidence.builds[0]
    assert len(evidence.builds) == 2

    def reason(*builds: Any) -> Any:
        given = evidence.model_copy(update={"builds": list(builds)})
        return verify_navigation(given, scene()).measurements.get("reason_code")

    fewer = one.model_copy(update={"cells": int(one.cells * 0.994)})
    nearly = one.model_copy(update={"cells": int(one.cells * 0.996)})
    other = one.model_copy(update={"falls": "uu" + one.falls[2:]})
    close = one.model_copy(update={"falls": "u" + one.falls[1:]})
    assert reason(one) == reason(one, fewer) == reason(one, other) == "not_certified"
    assert reason(one, nearly) is None and reason(one, close) is None
    assert reason(one, other, other) is None
    assert (
        verify_navigation(evidence.model_copy(update={"kept": {"radius_cm": 34.0}}), scene()).measurements[
            "reason_code"
        ]
        == "settings_not_kept"
    )


def test_scenery_is_left_out_of_both_parts() -> None:
    lamps = [actor(f"Lamp {n}", (n * 300, 300, 250), (n * 300 + 40, 340, 290)) for n in range(4)]
    sunk = [actor(f"Root {n}", (n * 300, 600, -120), (n * 300 + 60, 660, -60)) for n in range(4)]
    fallen = falls(measured(WIDE, *spread(), *lamps, *sunk))
    assert [fallen[f"Lamp {n}"] for n in range(4)] == ["raised"] * 4
    assert [fallen[f"Root {n}"] for n in range(4)] == ["buried"] * 4
    found = verdict(WIDE, *spread(), *lamps, *sunk)
    assert found.population["floor_level"] == 20 and found.score == 1.0


@pytest.mark.parametrize(("base", "fall"), [(150, "connected"), (151, "raised"), (-50, "connected"), (-51, "buried")])
def test_the_floor_level_band(base: float, fall: str) -> None:
    assert falls(measured(WIDE, actor("Thing", (0, 0, base), (40, 40, base + 10))))["Thing"] == fall


def test_the_own_storey_is_preferred_to_a_nearer_cell() -> None:
    upper = actor("Upper floor", (-1000, -1000, 280), (1000, 1000, 300))
    things = [actor("Below", (0, 0, 0), (40, 40, 40)), actor("Above", (0, 300, 300), (40, 340, 340))]
    fallen = falls(measured(WIDE, upper, *things))
    assert fallen == {"Below": "connected", "Above": "unconnected"}


@pytest.mark.parametrize(
    ("label", "size", "own", "left"),
    [
        ("Kitchen Floor", (400, 400, 10), {}, "surface"),
        ("Road_03", (2000, 600, 20), {}, "surface"),
        ("SM_CobbleTile_12", (200, 200, 10), {}, "surface"),
        ("Tiled Table", (200, 200, 80), {}, ""),
        ("Floor Lamp", (40, 40, 160), {}, ""),
        ("Street Bench", (180, 60, 80), {}, ""),
        ("Pathfinder", (60, 60, 60), {}, ""),
        ("Plate", (400, 400, 10), {"semantic_category": "ground"}, "surface"),
        ("Statue", (80, 80, 200), {"semantic_category": "ground"}, ""),
        ("Skyline Tower", (800, 800, 900), {}, ""),
        ("Sky", (800, 800, 900), {}, "effect"),
        ("Sun", (50, 50, 50), {"class_path": "/Script/Engine.DirectionalLight"}, "kind"),
        ("Lamp post", (50, 50, 300), {"class_path": "/Script/Engine.StaticMeshActor"}, ""),
        ("Ghost", (50, 50, 50), {"collides": False}, "no_collision"),
    ],
)
def test_who_is_a_target(label: str, size: tuple[float, float, float], own: dict[str, Any], left: str) -> None:
    (one,) = measured(actor(label, (0, 0, 0), size, **own)).targets
    assert one.left == left


def test_a_small_room_is_walked_from_object_to_object() -> None:
    room = floor(1600, 1600)
    evidence = measured(room, *[row for y in (-600, 0, 600) for row in crates(6, y=y, start=-700, step=260)])
    found = verify_navigation(evidence, scene())
    assert evidence.small and len(evidence.walks) == 6 and found.score == 1.0
    radius = found.measurements["arrival_radius_cm"]
    assert all(walk.start and walk.length_cm >= 4 * radius for walk in evidence.walks)


@pytest.mark.parametrize(("half", "radius"), [(0, 120), (480, 120), (800, 200), (1200, 300), (9000, 300)])
def test_the_arrival_radius(half: float, radius: float) -> None:
    assert arrival_radius_cm(half) == radius


def test_a_walk_that_stalls_ends_after_two_windows_and_counts_by_where_it_ended() -> None:
    goal = np.array([1000.0, 0, 0])

    def walk(places: list[float]) -> Any:
        trace = np.array([[x, 0.0, 0.0] for x in places])
        return judge_walk(trace, 1000 - trace[:, 0], goal, 120.0)

    going = [min(100.0 * n, 1000.0) for n in range(11)]
    assert walk(going).arrived and not walk(going).stalled
    stuck = walk([100.0 * min(n, 5) for n in range(60)])
    assert stuck.stalled and not stuck.arrived and stuck.seconds == 15.0
    assert not walk([100.0 * min(n, 5) for n in range(11)]).stalled
    away_again = walk([*going, *(1000 - 100.0 * n for n in range(1, 6))])
    assert not away_again.arrived and away_again.short_cm == 500
    assert walk([*(100.0 * min(n, 9) for n in range(60))]).arrived


@given(st.lists(st.floats(-300, 300), min_size=1, max_size=80))
def test_a_walk_arrives_exactly_when_it_ends_in_the_radius(steps: list[float]) -> None:
    places = np.cumsum(steps)
    trace = np.column_stack([places, np.zeros(len(places)), np.zeros(len(places))])
    found = judge_walk(trace, np.abs(1000 - places), np.array([1000.0, 0, 0]), 200.0)
    assert found.arrived == (abs(found.trace[-1, 0] - 1000) <= 200)
    assert found.stalled or len(found.trace) == len(trace)


def test_it_has_no_weight_and_the_same_scene_gives_the_same_bytes() -> None:
    assert all(NAVIGATION not in weighed_of(setting) for setting in SETTINGS) and not NAVIGATION.headlines
    assert measured(WIDE, *spread(), *pen()).sha256() == measured(WIDE, *spread(), *pen()).sha256()


def test_all_settings_are_on_record() -> None:
    evidence = measured(WIDE)
    assert evidence.asked == evidence.kept == NavigationSettings().plain()
    assert {"cell_cm", "cell_height_cm", "step_cm"} < evidence.kept.keys()


def stuck_behind() -> list[dict[str, Any]]:
    """Half of the scene behind walls: an honest A of a half or so."""
    places = [(-250 + n % 5 * 100, n // 5 * 100) for n in range(15)]
    return [*pen(), *[actor(f"Far {n}", (x, y, 0), (x + 40, y + 40, 40)) for n, (x, y) in enumerate(places)]]


def terrace() -> list[dict[str, Any]]:
    """A block of 4 m with fifteen things on it, and twenty crates on the ground."""
    places = [(700 + n % 5 * 300, -1000 + n // 5 * 300) for n in range(15)]
    things = [actor(f"Up {n}", (x, y, 400), (x + 40, y + 40, 440)) for n, (x, y) in enumerate(places)]
    return [
        WIDE,
        actor("Block", (500, -1500, 0), (2500, 1500, 400)),
        *crates(20, y=2000, start=-2000, step=200),
        *things,
    ]


def slope(degrees: float, **own: Any) -> dict[str, Any]:
    """A slope that ends on the terrace."""
    run = 400 / np.tan(np.radians(degrees))
    return actor("Slope", (500 - run, -200, 0), (500, 200, 400), mesh=RAMP, **own)


def sawtooth(rise: float, tread: float) -> list[dict[str, Any]]:
    """A slope of steps that a body climbs one by one."""
    count = int(400 / rise)
    ahead = [500 - (count - 1 - n) * tread for n in range(count)]
    return [actor(f"Tooth {n}", (x - tread, -200, 0), (500, 200, rise * (n + 1))) for n, x in enumerate(ahead)]


@pytest.mark.parametrize(
    ("way", "leads"),
    [
        ([slope(34)], True),
        ([slope(36)], False),
        ([slope(60)], False),
        (sawtooth(33.3, 40), True),
        (sawtooth(33.3, 10), False),
        (sawtooth(10, 7), False),
    ],
)
def test_a_slope_that_no_body_climbs_leads_nowhere(way: list[dict[str, Any]], leads: bool) -> None:
    fallen = falls(measured(*terrace(), *way))
    assert {fallen[f"Up {n}"] for n in range(15)} == {"connected" if leads else "unconnected"}


def test_a_slope_that_no_picture_shows_is_told() -> None:
    found = verdict(*terrace(), slope(30, hidden=True))
    assert found.measurements["approachability"] == 1.0
    assert notes(found)["hidden_solids"]["actors"] == ["Slope"] and "hidden_targets" in notes(found)
    assert "hidden_solids" not in notes(verdict(*terrace(), slope(30)))


CHEATS: dict[str, tuple[list[dict[str, Any]], str]] = {
    "a floor over what cannot be reached": (
        [WIDE, *spread(), *stuck_behind(), actor("Cover floor", (-390, -390, 60), (390, 390, 80))],
        "buried_targets",
    ),
    "a floor under the floor": (
        [
            floor(2400, 2400),
            *crates(20, y=1000, start=-1000, step=100, size=60),
            *[
                actor(
                    f"Jam {n}", (n % 10 * 80 - 400, n // 10 * 80 - 400, 0), (n % 10 * 80 - 360, n // 10 * 80 - 360, 60)
                )
                for n in range(100)
            ],
            actor("Cellar slab", (-500, -500, -280), (500, 500, -260)),
        ],
        "raised_targets",
    ),
    "collision off for the walls": (
        [WIDE, *spread(), *stuck_behind()[4:]]
        + [actor(f"Pen wall {n}", (-400, -400 + n, 0), (400, -380 + n, 300), collides=False) for n in range(4)],
        "collision_switched_off",
    ),
    "dust beside the anchor": (
        [WIDE, *spread(), *stuck_behind(), *crates(60, y=900, start=-900, step=30, size=5)],
        "tiny_targets",
    ),
    "hidden crates": (
        [WIDE, *spread(), *stuck_behind()]
        + [actor(f"Unseen {n}", (-2800 + n * 90, 1800, 0), (-2760 + n * 90, 1840, 40), hidden=True) for n in range(40)],
        "hidden_targets",
    ),
    "one target forty times": (
        [WIDE, *stuck_behind(), *[actor(f"Same {n}", (1500, 1500, 0), (1540, 1540, 40)) for n in range(60)]],
        "crowded_targets",
    ),
    "a hidden ramp into the pen": (
        [WIDE, *spread(), *stuck_behind(), actor("Ramp path", (-900, -60, 0), (900, 60, 1), hidden=True)],
        "hidden_solids",
    ),
    "names of effects for what cannot be reached": (
        [WIDE, *spread(), *pen(), *({**one, "label": f"Sky {one['label']}"} for one in stuck_behind()[4:])],
        "named_out",
    ),
    "a wall as long as a street": (
        [WIDE, *spread(), *stuck_behind(), actor("Endless wall", (-2900, 2700, 0), (2900, 2720, 100))],
        "giant_targets",
    ),
}


@pytest.mark.parametrize("cheat", CHEATS)
def test_no_cheat_raises_the_score_unseen(cheat: str) -> None:
    actors, code = CHEATS[cheat]
    found = verdict(*actors)
    assert code in notes(found), (found.score, [*notes(found)])
    told = notes(found)[code]
    assert told["actors"]
    if "approachability_with" in told:
        assert told["approachability_with"] < found.measurements["approachability"]
    if "approachability_without" in told and code != "giant_targets":
        assert told["approachability_without"] < found.measurements["approachability"]


def test_a_plate_too_large_for_the_bounds_and_bodies_that_are_not_known_are_named() -> None:
    plate = actor("Endless floor", (-15000, -15000, -20), (15000, 15000, 0))
    found = notes(verdict(plate, *spread()))
    assert found["left_out_of_bounds"]["actors"] == ["Endlessfloor"]
    foreign = {**actor("Foreign", (0, 0, 0), (60, 60, 60)), "c4s": None}
    told = notes(verdict(WIDE, *spread(), foreign))
    assert told["collision_unknown"]["actors"] == ["Foreign"] and "left_out_of_bounds" not in told


def test_a_clock_on_a_wall_and_a_vase_on_a_cupboard_are_scenery_and_no_cheat() -> None:
    wall = actor("Long wall", (-500, 800, 0), (500, 820, 300))
    clock = actor("Clock", (0, 790, 200), (30, 800, 230))
    cupboard, vase = actor("Cupboard", (600, 600, 0), (700, 660, 220)), actor("Vase", (640, 620, 220), (660, 640, 250))
    found = verdict(WIDE, *spread(), wall, clock, cupboard, vase)
    assert found.measurements["targets"]["raised"] == 2 and "raised_targets" not in notes(found)
