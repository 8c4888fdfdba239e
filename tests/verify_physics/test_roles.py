"""Which names, classes and sizes give which physics role, at the edges of each rule."""

from __future__ import annotations

from typing import Any

import pytest

from c4s.verify.actors.roles import needs_no_support, roles

PLATE = (200, 200, 50)


def thing(
    label: str = "Thing", half: Any = (50, 50, 50), mesh: str = "/Game/P/SM_A.SM_A", **more: Any
) -> dict[str, Any]:
    return {
        "label": label,
        "class": "/Script/Engine.StaticMeshActor",
        "asset_path": mesh,
        "component_asset_paths": [mesh],
        "bounds": {"origin_cm": [0, 0, 0], "extent_cm": list(half)},
    } | more


def role(**given: Any) -> str:
    return roles([thing(**given)])[0]


@pytest.mark.parametrize(
    "given",
    [
        {"label": "BP_Lighthouse", "class": "/Game/Lighthouse/BP_Lighthouse.BP_Lighthouse_C"},
        {"label": "Firewood"},
        {"label": "Waterfall"},
        {"label": "Seat"},
        {"label": "Underwater_Rock"},
        {"material_paths": ["/Game/P/M_River.M_River"], "half": (50, 50, 101)},
        {"collision": {"collision_enabled": None}},
    ],
)
def test_solids(given: dict[str, Any]) -> None:
    assert role(**given) == "scored_solid"


@pytest.mark.parametrize(
    "given",
    [
        {"collision": {"collision_enabled": False}},
        {"has_collision": False},
        {"collidable": False},
        {"label": "CampFire"},
        {"mesh": "/Game/FX_Fire/SM_Log.SM_Log"},
        {"material_paths": ["/Game/P/M_Flame.M_Flame"]},
        {"actor_tags": ["vfx"]},
        {"class": "/Script/Engine.PointLight"},
        {"class": "/Script/Engine.PostProcessVolume"},
        {"class": "/Game/Sky/BP_Stone.BP_Stone_C"},
        {"class": "/Script/Engine.GroupActor"},
        {"label": "Group Actor 3"},
        {"export_diagnostics": {"component_classes": ["/Script/Engine.SpotLightComponent"]}},
        {"label": "SM_Pond_01"},
        {"label": "WaterPlane2"},
        {"mesh": "/Game/Lake/SM_A.SM_A"},
        {"material_paths": ["/Game/P/M_River.M_River"], "half": (50, 50, 100)},
    ],
)
def test_non_solids(given: dict[str, Any]) -> None:
    assert role(**given) == "non_solid"


@pytest.mark.parametrize(
    ("given", "ground"),
    [
        ({"label": "Road_01", "half": (100, 100, 100)}, True),
        ({"label": "Road_01", "half": (99, 500, 10)}, False),
        ({"label": "Road_01", "half": (100, 100, 100.1)}, False),
        ({"label": "SM_Floor01b", "half": PLATE}, True),
        ({"label": "GroundedCrate", "half": PLATE}, False),
        ({"label": "Grass_Tile", "half": PLATE}, False),
        ({"mesh": "/Game/Street/SM_A.SM_A", "half": PLATE}, False),
        ({"mesh": "/Game/P/SM_Street.SM_Street", "half": PLATE}, True),
        ({"material_paths": ["/Game/P/M_Cobblestone.M_Cobblestone"], "half": PLATE}, True),
        ({"material_paths": ["/Game/P/M_Floor01.M_Floor01"], "half": PLATE}, True),
        ({"material_paths": ["/Game/P/M_Floor01b.M_Floor01b"], "half": PLATE}, False),
        ({"actor_role": "floor", "half": PLATE}, True),
        ({"actor_role": "floor01", "half": PLATE}, False),
        ({"label": "Cliff_A", "half": (50, 50, 900)}, True),
        ({"label": "Cliffside", "half": (50, 50, 900)}, False),
        ({"label": "Landscape1", "half": (9, 9, 900)}, True),
    ],
)
def test_ground_needs_a_name_and_a_size(given: dict[str, Any], ground: bool) -> None:
    assert role(**given) == ("support_surface" if ground else "scored_solid")


def test_only_what_the_published_exporter_writes_tells_a_role() -> None:
    assert role(c4s={"components": [{"class": "/Script/Niagara.NiagaraComponent"}]}) == "scored_solid"


def test_an_actor_without_bounds_is_unresolved_and_negative_extents_are_sizes() -> None:
    assert role(bounds=None) == role(bounds={"origin_cm": [0, 0, 0]}) == "unresolved"
    assert role(label="Road", half=(-200, 200, -10)) == "support_surface"


@pytest.mark.parametrize(
    ("shell", "others", "proxy"),
    [
        ({"label": "Hill", "half": (1600, 1600, 1600)}, 3, True),
        ({"label": "Hill", "half": (1500, 1500, 1500)}, 3, False),
        ({"label": "Hill", "half": (1600, 1600, 1600)}, 2, False),
        ({"label": "Hall", "half": (1600, 1600, 1600)}, 3, False),
        ({"label": "Hall", "half": (1600, 1600, 1600), "mesh": "/Engine/BasicShapes/Sphere.Sphere"}, 3, True),
        ({"label": "Hall", "half": (1600, 1600, 1600), "mesh": "\\Engine\\BasicShapes\\Cube.Cube"}, 3, True),
        ({"label": "Hill", "half": (15000, 15000, 15000)}, 3, True),
        ({"label": "Hill", "half": (1600, 1600, 9)}, 3, True),
    ],
)
def test_a_backdrop_is_far_larger_than_the_rest_and_around_it(shell: dict[str, Any], others: int, proxy: bool) -> None:
    scene = [thing(**shell), *(thing(f"Thing {n}") for n in range(others))]
    assert roles(scene)[0] == ("environment_proxy" if proxy else "scored_solid")


def test_size_counts_against_the_median_unless_it_is_huge() -> None:
    giants = [thing(f"Giant {n}", (5000, 5000, 5000)) for n in range(3)]
    assert roles([thing("Hill", (8000, 8000, 8000)), *giants])[0] == "scored_solid"
    assert roles([thing("Hill", (15000, 15000, 15000)), *giants])[0] == "environment_proxy"


@pytest.mark.parametrize(
    ("given", "left_out"),
    [
        ({"label": "Road", "half": PLATE}, True),
        ({"label": "Road", "half": (99, 200, 10)}, False),
        ({"label": "Cliff", "half": (50, 50, 900)}, False),
        ({"label": "River_Door", "half": (50, 10, 120)}, False),
        ({"label": "River", "half": (100, 100, 100)}, True),
        ({"label": "River", "half": (99, 100, 10)}, False),
        ({"class": "/Game/Street/BP_Car.BP_Car_C", "half": PLATE}, False),
        ({"class": "/Script/Engine.PointLight"}, True),
        ({"material_paths": ["/Game/P/M_Floor.M_Floor"], "half": PLATE}, False),
        (
            {"material_paths": ["/Game/P/M_Floor.M_Floor"], "half": PLATE, "mesh": "/Engine/BasicShapes/Plane.Plane"},
            True,
        ),
        ({"collision": {"collision_enabled": False}}, True),
        ({"bounds": None}, False),
    ],
)
def test_what_image_to_scene_leaves_out_of_the_support_test(given: dict[str, Any], left_out: bool) -> None:
    assert needs_no_support(thing(**given)) is left_out
