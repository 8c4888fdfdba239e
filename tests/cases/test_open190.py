"""The places of open-190: the same bytes from one seed, what stands and fits, what makes them different."""

from __future__ import annotations

import inspect
from collections import Counter
from functools import cache
from pathlib import Path

import pytest

from c4s.records.pack import Pack
from c4s.verify.physics.verdict import verify_physics
from cases.open190.build import laid_out_by
from cases.open190.layout import SEABED_CM, StagedPlace
from cases.open190.library import SCENES
from cases.open190.parts.streets import street
from cases.open190.scenes import REGISTERED
from cases.open190.space import Solid, Space
from cases.standing import snapshot_of, unsound
from catalog.build import build_pack
from catalog.kits.maker import FAMILIES, Assortment
from catalog.kits.styles import HISTORICAL, URBAN

SMALL_TEXT, SMALL_ROOM = "viking-harbour", "loft"
BOXES = {"indoor": (95, 3168), "outdoor": (260, 6700), "text": (20, 6700)}


@cache
def laid(scene_id: str) -> StagedPlace:
    """A scene, laid out once."""
    return SCENES[scene_id].place()


def test_there_are_ten_indoor_ten_outdoor_and_thirty_text_scenes() -> None:
    kinds = Counter(spec.kind for spec in SCENES.values())
    assert kinds == {"indoor": 10, "outdoor": 10, "text": 30}
    assert sum(spec.slot for spec in SCENES.values()) >= 5
    assert {spec.plate_m for spec in SCENES.values() if spec.kind == "text"} == {130.0, 200.0}


def test_every_scene_has_a_place_in_the_order() -> None:
    assert set(SCENES) == set(REGISTERED)


def test_the_digest_of_sources_is_over_every_file_that_lays_a_scene_out() -> None:
    rules = (street, Space, *StagedPlace.__mro__[:-2])
    files = {Path(inspect.getfile(one)) for one in (*(spec.build for spec in SCENES.values()), *rules)}
    assert len(files) > 60
    assert files <= set(laid_out_by())


@pytest.mark.parametrize("scene_id", [SMALL_TEXT, SMALL_ROOM])
def test_a_scene_is_the_same_twice(scene_id: str) -> None:
    again = SCENES[scene_id].place()
    assert again.level() == laid(scene_id).level()
    assert list(again.assortment.things) == list(laid(scene_id).assortment.things)


@pytest.mark.parametrize("scene_id", [SMALL_TEXT, "business-park"])
def test_water_lies_above_the_plate(scene_id: str) -> None:
    place = laid(scene_id)
    heights = {item.z for item in place.items.values() if "Water" in item.label}
    plate = {item.z for item in place.items.values() if item.thing.flat and "Water" not in item.label}
    assert min(heights) >= SEABED_CM and 0.0 in plate


def test_another_seed_makes_other_things() -> None:
    one, same, other = (Assortment(HISTORICAL, seed) for seed in ("a", "a", "b"))
    names = [assortment.kit("house", 6) for assortment in (one, same, other)]
    meshes = [
        [a.things[n].shape.mesh.vertices.tobytes() for n in ns] for a, ns in zip((one, same, other), names, strict=True)
    ]
    assert names[0] == names[1] and meshes[0] == meshes[1]
    assert meshes[0] != meshes[2]


@pytest.mark.parametrize("style", [HISTORICAL, URBAN], ids=lambda style: style.name)
def test_every_family_makes_named_things_with_bodies(style: object) -> None:
    assortment = Assortment(style, "t")  # type: ignore[arg-type]
    for family in FAMILIES:
        for name in assortment.kit(family, 2):
            thing = assortment.things[name]
            spec = next(spec for spec in assortment.specs if spec.name == name)
            assert spec.description.endswith(".") and spec.tags and spec.category
            assert thing.flat or thing.shape.collision, f"{family}: {name} has no body"
            assert all(top.z <= thing.high[2] + 0.01 for top in thing.surfaces), name
    names = [name.lower() for name in assortment.things]
    assert len(names) == len(set(names))


def test_a_pack_is_the_same_bytes_twice(tmp_path_factory: pytest.TempPathFactory) -> None:
    digests = set()
    for number in range(2):
        place = SCENES[SMALL_ROOM].place()
        pack = build_pack(
            place.assortment.pack(place.pack_id, "Loft"), tmp_path_factory.mktemp(f"packs{number}"), previews=False
        )
        digests.add(pack.sha256())
        assert isinstance(pack, Pack)
    assert len(digests) == 1


def test_what_is_placed_in_the_loft_stands_and_fits(tmp_path_factory: pytest.TempPathFactory) -> None:
    root = tmp_path_factory.mktemp("packs")
    place = laid(SMALL_ROOM)
    build_pack(place.assortment.pack(place.pack_id, "Loft"), root, previews=False)
    assert unsound(snapshot_of(place.level(), [root / place.pack_id])) == set()


def test_the_truth_of_a_text_has_full_physics(tmp_path_factory: pytest.TempPathFactory) -> None:
    root = tmp_path_factory.mktemp("packs")
    place = laid(SMALL_TEXT)
    build_pack(place.assortment.pack(place.pack_id, "Harbour"), root, previews=False)
    assert verify_physics("text-to-scene", snapshot_of(place.level(), [root / place.pack_id])).score == 1.0


def test_things_on_others_are_related_and_inside_their_surface() -> None:
    place = laid(SMALL_ROOM)
    on = [relation for relation in place.relations if relation.kind == "on"]
    assert len(on) > 20
    for relation in on:
        upper, lower = place.items[relation.subject], place.items[relation.reference]
        assert upper.z >= lower.z
        assert abs(upper.x - lower.x) <= max(lower.thing.width, lower.thing.depth)


def test_taken_room_is_not_given_twice() -> None:
    def block(x: float, low: float = 0.0) -> Solid:
        return Solid(((x, 0.0), (x + 100, 0.0), (x + 100, 100.0), (x, 100.0)), low, low + 50)

    space = Space()
    space.take([block(0)])
    assert not space.free([block(50)])
    assert space.free([block(100)]) and space.free([block(50, low=50)])
    assert not space.free([block(130)], margin=60)
    assert space.free([block(170)], margin=60)


def test_small_scenes_have_as_many_actors_and_assets_as_their_kind_wants() -> None:
    for scene_id in (SMALL_TEXT, SMALL_ROOM, "forest-ruins", "tavern"):
        low, high = BOXES[SCENES[scene_id].kind]
        place = laid(scene_id)
        assert low <= len(place.actors) <= high
        if SCENES[scene_id].kind == "text":
            assert 45 <= len(place.assortment.things) <= 215


def test_no_two_scenes_are_made_of_the_same_things() -> None:
    made = [
        frozenset(laid(scene_id).assortment.things) for scene_id in (SMALL_TEXT, SMALL_ROOM, "forest-ruins", "tavern")
    ]
    for number, one in enumerate(made):
        for other in made[number + 1 :]:
            assert len(one & other) < 0.5 * min(len(one), len(other))
