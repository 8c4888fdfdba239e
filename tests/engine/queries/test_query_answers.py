"""Traces, sweeps and overlaps as scripts call them: who is asked, what they answer, and what they refuse."""

from __future__ import annotations

import math
from typing import Any

import pytest
from query_scene import Scene, path_of, row

from c4s.engine.headless.unreal.hits.results import layout
from tests.work import calls_in


def test_channels_profiles_and_object_types_decide(scene: Scene) -> None:
    unreal, library = scene.unreal, scene.library
    glass, gate, wall = scene.put("Cube", (0, 0, 50)), scene.put("Cube", (300, 0, 50)), scene.put("Cube", (600, 0, 50))
    parts = [actor.static_mesh_component for actor in (glass, gate, wall)]
    assert str(parts[0].get_collision_profile_name()) == "BlockAll"
    assert parts[0].get_collision_object_type() == unreal.CollisionChannel.ECC_WORLD_STATIC
    parts[0].set_collision_profile_name("InvisibleWall")
    parts[1].set_collision_profile_name("OverlapAllDynamic")
    along = ((-500, 0, 50), (1000, 0, 50))
    assert scene.line(*along).to_tuple()[9] is wall
    assert scene.line(*along, channel=2).to_tuple()[9] is glass
    several = scene.line(*along, many=True)
    assert [(hit.to_tuple()[9], hit.to_tuple()[0]) for hit in several] == [(gate, False), (wall, True)]
    assert scene.line((200, 0, 50), (400, 0, 50), many=True) is None
    ends, tail = (scene.vector(along[0]), scene.vector(along[1])), (False, [], *scene.tail)
    every = library.line_trace_multi_for_objects(scene.world, *ends, scene.statics, *tail)
    assert [hit.to_tuple()[9] for hit in every] == [glass, wall] and all(hit.to_tuple()[0] for hit in every)
    dynamic = [unreal.ObjectTypeQuery.OBJECT_TYPE_QUERY2]
    assert library.sphere_trace_single_for_objects(scene.world, *ends, 5.0, dynamic, *tail).to_tuple()[9] is gate
    assert library.line_trace_single_for_objects(scene.world, *ends, [], *tail) is None
    assert library.line_trace_single_by_profile(scene.world, *ends, "Pawn", *tail).to_tuple()[9] is glass
    assert library.line_trace_single_by_profile(scene.world, *ends, "OverlapAll", *tail) is None
    parts[2].set_collision_response_to_channel(
        unreal.CollisionChannel.ECC_VISIBILITY, unreal.CollisionResponseType.ECR_IGNORE
    )
    assert scene.line(*along) is None and str(parts[2].get_collision_profile_name()) == "Custom"
    assert (
        parts[2].get_collision_response_to_channel(unreal.CollisionChannel.ECC_CAMERA)
        == unreal.CollisionResponseType.ECR_BLOCK
    )
    parts[2].set_collision_profile_name("BlockAll")
    assert scene.line(*along).to_tuple()[9] is wall
    parts[2].set_collision_enabled(unreal.CollisionEnabled.PHYSICS_ONLY)
    assert scene.line(*along) is None and not parts[2].is_query_collision_enabled()
    gate.set_actor_enable_collision(False)
    assert scene.line(*along, many=True) is None


def test_collision_settings_survive_saving(scene: Scene) -> None:
    unreal = scene.unreal
    part = scene.put("Cube").static_mesh_component
    part.set_collision_response_to_all_channels(unreal.CollisionResponseType.ECR_OVERLAP)
    part.set_collision_object_type(unreal.CollisionChannel.ECC_PAWN)
    unreal.EditorLoadingAndSavingUtils.save_map(scene.world, "/Game/Saved/Collision")
    unreal.EditorLoadingAndSavingUtils.load_map("/Game/Saved/Collision")
    again = unreal.EditorLevelLibrary.get_all_level_actors()[0].static_mesh_component
    assert again.get_collision_object_type() == unreal.CollisionChannel.ECC_PAWN
    assert str(again.get_collision_profile_name()) == "Custom"
    assert (
        again.get_collision_response_to_channel(unreal.CollisionChannel.ECC_VEHICLE)
        == unreal.CollisionResponseType.ECR_OVERLAP
    )


def test_what_moves_appears_or_goes_is_seen_at_once(scene: Scene) -> None:
    down = ((0, 0, 500), (0, 0, -500))
    assert scene.line(*down) is None
    cube = scene.put("Cube", (0, 0, 50))
    child = scene.put("Cube", (0, 0, 250))
    assert scene.line(*down).to_tuple()[9] is child
    rule = scene.unreal.AttachmentRule.KEEP_WORLD
    child.attach_to_actor(cube, "", rule, rule, rule)
    cube.set_actor_location(scene.vector((1000, 0, 50)), False, False)
    assert scene.line(*down) is None and scene.line((1000, 0, 500), (1000, 0, 0)).to_tuple()[9] is child
    child.destroy_actor()
    assert scene.line((1000, 0, 500), (1000, 0, 0)).to_tuple()[9] is cube
    cube.static_mesh_component.set_static_mesh(scene.unreal.load_asset(path_of("bare")))
    assert scene.line((1000, 0, 500), (1000, 0, -5)) is None
    row_component = scene.unreal.get_engine_subsystem(scene.unreal.SubobjectDataSubsystem)
    parent = row_component.k2_gather_subobject_data_for_instance(cube)[0]
    handle, _ = row_component.add_new_subobject(
        scene.unreal.AddNewSubobjectParams(parent_handle=parent, new_class=scene.unreal.InstancedStaticMeshComponent)
    )
    library = scene.unreal.SubobjectDataBlueprintFunctionLibrary
    many = library.get_object(row_component.k2_find_subobject_data_from_handle(handle))
    many.set_static_mesh(scene.unreal.load_asset("/Engine/BasicShapes/Cube"))
    for i in range(3):
        many.add_instance(scene.unreal.Transform(scene.vector((300 * i, 2000, 0))), True)
    hit = scene.line((600, 2000, 500), (600, 2000, -500))
    assert hit.to_tuple()[13] == 2 and hit.to_tuple()[10] is many
    many.remove_instance(0)
    assert scene.line((600, 2000, 500), (600, 2000, -500)).to_tuple()[13] == 1
    assert scene.line((0, 2000, 500), (0, 2000, -500)) is None


def test_actors_and_oneself_can_be_ignored(scene: Scene) -> None:
    one, two = scene.put("Cube", (0, 0, 50)), scene.put("Cube", (0, 0, 250))
    down = ((0, 0, 500), (0, 0, 0))
    assert scene.line(*down, ignore=[two]).to_tuple()[9] is one
    assert scene.line(*down, context=two).to_tuple()[9] is one
    assert scene.line(*down, context=two.static_mesh_component).to_tuple()[9] is one
    assert scene.line(*down, ignore=[one, two]) is None
    with pytest.raises(TypeError):
        scene.library.line_trace_single(
            scene.world,
            (0, 0, 1),
            scene.vector((0, 0, 0)),
            scene.unreal.TraceTypeQuery.TRACE_TYPE_QUERY1,
            False,
            "all",
            *scene.tail,
        )


def test_overlaps_name_each_actor_and_component_once(scene: Scene) -> None:
    unreal, library = scene.unreal, scene.library
    table, cube = scene.put("table"), scene.put("Cube", (0, 0, 150))
    found = library.box_overlap_actors(
        scene.world, scene.vector((0, 0, 50)), scene.vector((200, 200, 60)), scene.statics, None, []
    )
    assert list(found) == [table, cube]
    assert (
        library.box_overlap_actors(
            scene.world, scene.vector((0, 0, 50)), scene.vector((80, 30, 30)), scene.statics, None, []
        )
        is None
    )
    assert list(
        library.sphere_overlap_components(
            scene.world, scene.vector((0, 0, 100)), 20.0, scene.statics, unreal.StaticMeshComponent, [table]
        )
    ) == [cube.root_component]
    assert (
        library.sphere_overlap_actors(scene.world, scene.vector((0, 0, 100)), 20.0, scene.statics, unreal.Light, [])
        is None
    )
    assert (
        library.capsule_overlap_actors_with_orientation(
            scene.world, scene.vector((0, 0, 260)), 10.0, 100.0, unreal.Rotator(roll=90), scene.statics, None, []
        )
        is None
    )
    part = cube.static_mesh_component
    assert library.component_overlap_components(part, part.get_world_transform(), scene.statics, None, []) is None
    lower = unreal.Transform(scene.vector((0, 0, 149)))
    assert list(library.component_overlap_actors(part, lower, scene.statics, None, [])) == [table]
    assert list(library.component_overlap_components(part, lower, scene.statics, unreal.PrimitiveComponent, [])) == [
        table.root_component
    ]
    assert list(part.get_overlapping_actors()) == []
    cube.set_actor_location(scene.vector((0, 0, 140)), False, False)
    part.set_collision_profile_name("OverlapAll")
    assert list(part.get_overlapping_actors()) == [table] and part.is_overlapping_actor(table)
    assert list(cube.get_overlapping_actors()) == [table] and table.is_overlapping_actor(cube)
    assert list(table.get_overlapping_components()) == [part]
    assert list(table.get_overlapping_actors(unreal.Light)) == []


def test_a_component_can_be_asked_alone(scene: Scene) -> None:
    front, back = scene.put("Cube", (0, 0, 50)), scene.put("Cube", (300, 0, 50))
    part = back.static_mesh_component
    location, normal, _, hit = part.line_trace_component(scene.vector((-500, 0, 50)), scene.vector((500, 0, 50)))
    assert row(location) == pytest.approx((250, 0, 50)) and row(normal) == (-1, 0, 0) and hit.to_tuple()[9] is back
    assert part.line_trace_component(scene.vector((-500, 0, 500)), scene.vector((500, 0, 500))) is None
    assert part.sphere_trace_component(scene.vector((-500, 0, 50)), scene.vector((500, 0, 50)), 50.0, False)[
        3
    ].to_tuple()[3] == pytest.approx(700)
    assert part.sphere_overlap_component(scene.vector((240, 0, 50)), 20.0, False) is not None
    box = scene.unreal.Box(scene.vector((-5, -5, -5)), scene.vector((5, 5, 5)))
    assert part.box_overlap_component(scene.vector((200, 0, 50)), box, False) is None
    distance, nearest = front.static_mesh_component.get_closest_point_on_collision(scene.vector((0, 200, 50)))
    assert distance == pytest.approx(150, abs=1e-3) and row(nearest) == pytest.approx((0, 50, 50), abs=1e-3)
    assert part.get_closest_point_on_collision(scene.vector((300, 0, 50)))[0] == 0
    assert scene.put("bare").static_mesh_component.get_closest_point_on_collision(scene.vector((0, 0, 0)))[0] < 0


def test_both_layouts_of_results(scene: Scene) -> None:
    scene.put("Cube", (0, 0, 50))
    down, aside = ((0, 0, 500), (0, 0, 0)), ((500, 0, 500), (500, 0, 0))
    hit = scene.line(*down)
    assert len(hit.to_tuple()) == len(hit.to_dict()) == 18
    with layout("pair"):
        found, hit = scene.line(*down)
        assert found is True and hit.to_tuple()[3] == pytest.approx(400)
        found, hit = scene.line(*aside)
        assert found is False and not hit.to_tuple()[0]
        found, hits = scene.line(*aside, many=True)
        assert found is False and len(hits) == 0
        assert (
            scene.library.sphere_overlap_actors(scene.world, scene.vector((0, 0, 0)), 10.0, scene.statics, None, [])[0]
            is True
        )
    assert scene.line(*aside) is None
    assert not hasattr(scene.unreal.GameplayStatics, "break_hit_result")
    assert not hasattr(hit, "location")


def test_bounds_of_components_and_actors_hold_the_hits(scene: Scene) -> None:
    cube = scene.put("Cube", (100, 200, 300), (10, 20, 30), (1, -2, 3))
    origin, extent = cube.get_actor_bounds(True)
    same = scene.library.get_component_bounds(cube.static_mesh_component)
    assert row(same[0]) == pytest.approx(row(origin)) and row(same[1]) == pytest.approx(row(extent))
    hit = scene.line((100, 200, 2000), (100, 200, -2000)).to_dict()["impact_point"]
    assert abs(hit.z - origin.z) <= extent.z + 1e-9
    cube.set_actor_enable_collision(False)
    assert row(cube.get_actor_bounds(True)[1]) == (0, 0, 0) and row(cube.get_actor_bounds(False)[1]) == row(extent)


def test_a_trace_looks_at_few_of_many_actors(scene: Scene) -> None:
    """Function calls of one trace at the median: in a town of 6,700 actors about those in one of 60."""

    def median(number: int) -> int:
        scene.unreal.EditorLoadingAndSavingUtils.new_blank_map(False)
        scene.world = scene.unreal.EditorLevelLibrary.get_editor_world()
        side = round(number**0.5)
        actors = [scene.put("Cube", (300 * (i % side), 300 * (i // side), 50)) for i in range(number)]
        spent = []
        for i in range(60):
            actor = actors[i * number // 60]
            actor.set_actor_location(actor.get_actor_location() + scene.vector((1, 0, 0)), False, False)
            x, y, _ = row(actor.get_actor_location())
            hits: list[Any] = []
            spent.append(calls_in(lambda x=x, y=y, hits=hits: hits.append(scene.line((x, y, 1000), (x, y, -1000)))))
            assert hits[0].to_tuple()[9] is actor
        assert all(calls["_ray_bodies"] <= 1 for calls in spent)
        return sorted(calls.total() for calls in spent)[30]

    few, many = median(60), median(6700)
    assert many < 1.2 * few


def test_a_swept_move_stops_at_what_blocks_and_tells_how_deep_it_starts(scene: Scene) -> None:
    mover, wall = scene.put("Cube", (0, 0, 50)), scene.put("Cube", (500, 0, 50))
    part = mover.static_mesh_component
    hit = part.set_world_location(scene.vector((800, 0, 50)), True, False)
    fields = hit.to_dict()
    assert fields["hit_actor"] is wall and fields["distance"] == pytest.approx(400, abs=1e-6)
    assert 397 < mover.get_actor_location().x < 400 and row(fields["impact_normal"]) == (-1, 0, 0)
    part.ignore_component_when_moving(wall.static_mesh_component, True)
    assert list(part.copy_array_of_move_ignore_components()) == [wall.static_mesh_component]
    assert not part.set_world_location(scene.vector((800, 0, 50)), True, False).to_tuple()[0]
    assert mover.get_actor_location().x == 800
    part.clear_move_ignore_components()
    part.set_world_location(scene.vector((480, 0, 130)), False, True)
    deep = part.set_world_location(scene.vector((480, 0, 129.9)), True, False)
    assert deep.to_tuple()[1] and deep.to_tuple()[10] is wall.static_mesh_component
    assert "PenetrationDepth=20.0000" in deep.export_text() and row(deep.to_tuple()[6]) == pytest.approx((0, 0, 1))
    assert row(mover.get_actor_location()) == (480, 0, 130)
    assert not part.set_world_location(scene.vector((480, 0, 130.1)), True, False).to_tuple()[0]
    wall.static_mesh_component.set_collision_profile_name("OverlapAll")
    assert not part.set_world_location(scene.vector((480, 0, 60)), True, False).to_tuple()[0]
    mover.set_actor_location(scene.vector((math.pi, 0, 0)), False, False)
    assert mover.get_actor_location().x == math.pi


def test_navigation_answers_as_in_a_level_without_a_mesh(scene: Scene, capsys: Any) -> None:
    navigation, here = scene.unreal.NavigationSystemV1, scene.vector((1, 2, 3))
    assert navigation.get_navigation_system(scene.world) is not None
    assert navigation.project_point_to_navigation(scene.world, here, None, None, here) is None
    assert navigation.get_random_reachable_point_in_radius(scene.world, here, 500.0) is None
    assert navigation.find_path_to_location_synchronously(scene.world, here, here) is None
    assert row(navigation.navigation_raycast(scene.world, here, scene.vector((9, 9, 9)))) == (1, 2, 3)
    assert navigation.get_path_length(scene.world, here, here)[0] == scene.unreal.NavigationQueryResult.INVALID
    assert not navigation.is_navigation_being_built(scene.world) and not capsys.readouterr().out
    volume = scene.unreal.EditorLevelLibrary.spawn_actor_from_class(scene.unreal.NavMeshBoundsVolume, here)
    assert list(scene.unreal.EditorLevelLibrary.get_selected_level_actors()) == [volume]
    assert navigation.project_point_to_navigation(scene.world, here, None, None) is None
    navigation.get_navigation_system(scene.world).on_navigation_bounds_updated(volume)
    meshes = [
        a for a in scene.unreal.EditorLevelLibrary.get_all_level_actors() if isinstance(a, scene.unreal.RecastNavMesh)
    ]
    assert [mesh.get_actor_label() for mesh in meshes] == ["RecastNavMesh-Default"]
    assert meshes[0].get_editor_property("agent_radius") == 34.0
    with pytest.raises(TypeError):
        navigation.project_point_to_navigation(scene.world, here)


@pytest.mark.parametrize("scale", [(1e30, 1e30, 1e30), (1e300, 1.0, 1.0), (1e-30, 1.0, 1.0), (1.0, 0.0, 0.0)])
@pytest.mark.parametrize("x", [0.0, 1e6, 1e12, 1e30, 1e300])
@pytest.mark.filterwarnings("error::RuntimeWarning")
def test_actors_of_absurd_size_or_place_do_no_harm(scene: Scene, x: float, scale: Any) -> None:
    for shape in ("Cube", "Sphere", "Cylinder"):
        scene.put(shape, (x, 0, 0), (0, 0, 0), scale)
    near = scene.put("Cube", (0, 0, -500))
    for triangles in (False, True):
        hit = scene.line((30, 30, -300), (30, 30, -900), triangles=triangles)
        assert hit.to_tuple()[9] is near or max(scale) > 1 or x == 0
        assert scene.ball((0, 900, 100), (0, 900, -1000), 10, triangles=triangles) is None
    assert (
        scene.library.sphere_overlap_actors(scene.world, scene.vector((0, 0, -500)), 10.0, scene.statics, None, [])
        is not None
    )
