"""The planner: what it refuses, what it drops, and that equal input gives equal, separate output."""

from __future__ import annotations

import io
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image

from c4s.agents.baselines.composing import compose
from c4s.agents.baselines.mending import mends
from c4s.agents.baselines.palette import asked_counts, palette
from c4s.planner import ground_tiles, render_plan, solve, tiers, validate
from c4s.planner import picture as picture_module
from c4s.records.pack import Asset


def _asset(name: str, width: float, depth: float, height: float) -> Asset:
    return Asset(
        id=name,
        name=name,
        path=f"/Game/T/SM_{name}.SM_{name}",
        category="things",
        bounds_min_cm=(-50 * width, -20 * depth, -10.0),
        bounds_max_cm=(50 * width, 80 * depth, 100 * height),
    )


CATALOG = [
    _asset("house", 8, 6, 7),
    _asset("table", 1.6, 0.8, 0.75),
    _asset("mug", 0.1, 0.1, 0.12),
    _asset("floor_tile", 4, 4, 0.05),
]
NODES = st.lists(
    st.fixed_dictionaries(
        {
            "asset": st.sampled_from(["house", "table", "mug"]),
            "count": st.integers(1, 12),
            "at": st.tuples(st.floats(-20, 20), st.floats(-20, 20)).map(list),
            "yaw_deg": st.sampled_from([0, 30, 90, 200]),
            "layout": st.fixed_dictionaries({"kind": st.sampled_from(["row", "grid", "ring", "scatter"])}),
        }
    ),
    max_size=6,
)


@settings(max_examples=40, deadline=None)
@given(NODES)
def test_solving_is_repeatable_and_counts_its_overlaps(nodes: list[dict[str, object]]) -> None:
    graph = {"nodes": [{**node, "id": f"n{i}"} for i, node in enumerate(nodes)]}
    solved = solve(graph, CATALOG)
    assert solved == solve(graph, CATALOG)
    assert len(solved["entries"]) + len(solved["dropped"]) == sum(int(str(node["count"])) for node in nodes)
    boxes = [entry["footprint_cm"] for entry in solved["entries"]]
    overlaps = sum(
        min(a[2], b[2]) - max(a[0], b[0]) > 2 and min(a[3], b[3]) - max(a[1], b[1]) > 2
        for i, a in enumerate(boxes)
        for b in boxes[:i]
    )
    assert overlaps <= solved["overlapping_pairs"]


def test_entries_stand_on_the_plane_and_on_each_other() -> None:
    solved = solve(
        {"nodes": [{"id": "t", "asset": "table", "at": [1, 2]}, {"id": "m", "asset": "mug", "on": "t"}]}, CATALOG
    )
    table, mug = solved["entries"]
    assert table["location"][2] == pytest.approx(10.0)
    assert mug["location"][2] == pytest.approx(10.0 + 85.0)
    assert tiers(solved)["tiers"]["details"] == ["m"]


def test_validate_names_what_will_be_dropped() -> None:
    report = validate(
        {
            "nodes": [
                {"id": "a", "asset": "castle"},
                {"id": "b", "asset": "mug", "on": "nowhere"},
                {"id": "c", "asset": "mug", "color": "red"},
            ]
        },
        CATALOG,
    )
    assert not report["valid"] and report["nodes"] == 1
    assert {(row["node"], row["dropped"]) for row in report["problems"]} == {("a", True), ("b", True), ("c", False)}
    assert not validate([], CATALOG)["valid"]


def test_the_ground_pass_carpets_the_plate_with_its_top_at_zero() -> None:
    tiles = ground_tiles(CATALOG[3], 20.0)
    assert len(tiles) == 100
    assert {tile["asset"] for tile in tiles} == {"/Game/T/SM_floor_tile.SM_floor_tile"}
    assert {tile["location"][2] for tile in tiles} == {-5.0}


@pytest.mark.parametrize("side_m", [130.0, 200.0])
def test_the_ground_covers_the_whole_plate_without_gaps(side_m: float) -> None:
    tile = CATALOG[3]
    tiles = ground_tiles(tile, side_m / 2)
    assert 0 < len(tiles) <= 700
    edges = {
        axis: sorted(
            {
                (
                    round(t["location"][axis] + t["scale"][axis] * tile.bounds_min_cm[axis], 1),
                    round(t["location"][axis] + t["scale"][axis] * tile.bounds_max_cm[axis], 1),
                )
                for t in tiles
            }
        )
        for axis in (0, 1)
    }
    for spans in edges.values():
        assert spans[0][0] <= -50 * side_m + 0.5 and spans[-1][1] >= 50 * side_m - 0.5
        assert all(abs(left[1] - right[0]) < 0.5 for left, right in pairwise(spans))
    assert len({t["name"] for t in tiles}) == len(edges[0]) * len(edges[1]) == len(tiles)


def test_validate_tells_what_solving_drops() -> None:
    graph = {
        "nodes": [
            {"id": "far", "asset": "house", "at": [500, 0]},
            {"id": "roof", "asset": "mug", "on": "far"},
            {"id": "ghost", "asset": "castle"},
            {"id": "hat", "asset": "mug", "on": "ghost"},
            {"id": "huge", "asset": "mug", "at": [1e300, 0]},
            {"id": "x" * 500, "asset": "mug"},
            {"id": "odd", "asset": "mug", "on": ["far"]},
        ]
    }
    report = validate(graph, CATALOG, 50)
    solved = solve(graph, CATALOG, half_extent_m=50)
    assert report["dropped"] == [item["node"] for item in solved["dropped"]] and not report["valid"]
    assert {"ghost", "hat", "huge", "odd", "far", "roof"} <= set(report["dropped"])
    exact = solve(graph, CATALOG, mode="exact", half_extent_m=50)
    assert exact["dropped"] == solved["dropped"] and exact["entries"] == [] == solved["entries"]


def test_what_starts_inside_is_pushed_no_further_than_the_edge_and_what_is_outside_does_not_come_in() -> None:
    crowd = [{"id": f"h{i}", "asset": "house", "at": [46, 46]} for i in range(6)]
    solved = solve({"nodes": [*crowd, {"id": "far", "asset": "mug", "at": [60, 0]}]}, CATALOG, half_extent_m=50)
    assert [item["node"] for item in solved["dropped"]] == ["far"] and len(solved["entries"]) == 6
    assert all(abs(side) <= 5001 for entry in solved["entries"] for side in entry["footprint_cm"])


def test_a_graph_of_too_many_copies_loses_its_last_nodes() -> None:
    graph = {"nodes": [{"id": f"n{i}", "asset": "mug", "count": 2000, "layout": {"kind": "grid"}} for i in range(3)]}
    report = validate(graph, CATALOG)
    assert report["copies"] == 4000 and report["dropped"] == ["n2"]


def test_the_plan_picture_shows_footprints() -> None:
    solved = solve({"nodes": [{"id": "h", "asset": "house", "at": [0, 0]}]}, CATALOG)
    image = Image.open(io.BytesIO(render_plan(solved)))
    assert image.size == (900, 900) and len(image.convert("RGB").getcolors(100000) or []) > 3


def test_the_plan_picture_names_what_has_room_and_draws_the_facing() -> None:
    def picture(nodes: list[dict[str, object]]) -> Image.Image:
        return Image.open(io.BytesIO(render_plan(solve({"nodes": nodes}, CATALOG)))).convert("RGB")

    def pixels(image: Image.Image) -> set[tuple[int, int]]:
        data = image.load()
        return {(x, y) for x in range(image.width) for y in range(image.height) if data[x, y] == picture_module.ARROW}

    east, south = (pixels(picture([{"id": "h", "asset": "house", "at": [0, 0], "yaw_deg": yaw}])) for yaw in (0, 90))
    (east_x, east_y), (south_x, south_y) = (tuple(map(max, zip(*found, strict=True))) for found in (east, south))
    assert east_x > south_x and south_y > east_y
    crowd = [{"id": f"mug-{i}-of-a-long-row", "asset": "mug", "at": [0.3 * i, 0]} for i in range(300)]
    solved = solve({"nodes": crowd}, CATALOG)
    assert Image.open(io.BytesIO(render_plan(solved))).size == (900, 900)
    assert render_plan({"entries": [{**entry, "name": "two\nlines" * 999} for entry in solved["entries"]]})
    for far in (1e300, float("nan"), float("inf")):
        with pytest.raises(ValueError, match="too large"):
            render_plan({"entries": [{**solved["entries"][0], "footprint_cm": [far, far, far, far]}]})


def test_a_palette_and_its_counts_are_read() -> None:
    prompt = (
        "Place twelve houses around one long table.\n\n=== ASSET PALETTE ===\n"
        "- house | House | things | 8.0x6.0x7.0 m | /Game/T/SM_house.SM_house\n"
        "- table | Table | things | 1.6x0.8x0.75 m | /Game/T/SM_table.SM_table\n"
        "- crane | Crane | things | 3.0x3.0x9.0 m | /Game/T/SM_crane.SM_crane\n\n=== THE TASK ===\nBuild.\n"
    )
    assert [item.id for item in palette(prompt)] == ["house", "table", "crane"]
    assert asked_counts("Place twelve houses around one long table.")["house"] == 12
    graph = compose(prompt, 130.0)
    used = [node["asset"] for node in graph["nodes"]]
    assert used.count("/Game/T/SM_house.SM_house") == 12 and used.count("/Game/T/SM_table.SM_table") == 1
    assert "/Game/T/SM_crane.SM_crane" not in used


def _actor(name: str, x: float, scale: float = 1.0) -> dict[str, object]:
    return {
        "name": name,
        "label": name,
        "static_meshes": ["/Game/T/SM_mug.SM_mug"],
        "location": [x, 0.0, 0.0],
        "scale": [scale, scale, scale],
    }


def test_mending_finds_a_copy_and_an_odd_scale_and_leaves_the_rest() -> None:
    sound = [_actor(f"m{i}", 300.0 * i) for i in range(6)]
    assert mends(sound) == []
    assert [(m.actor, m.scale) for m in mends([*sound, _actor("copy", 20.0)])] == [("copy", None)]
    assert [(m.actor, m.scale) for m in mends([*sound, _actor("big", 5000.0, 1.5)])] == [("big", (1.0, 1.0, 1.0))]
