"""What scripts do beyond placing actors: traces, added components, searches; and that annotations name types."""

from __future__ import annotations

import inspect
import re
from pathlib import Path
from types import ModuleType

import pytest

from c4s.engine.headless.process.boot import boot
from c4s.engine.headless.world import state


@pytest.fixture
def unreal(tmp_path: Path) -> ModuleType:
    return boot([], tmp_path)


@pytest.fixture
def cube(unreal):
    return unreal.EditorLevelLibrary.spawn_actor_from_object(
        unreal.load_asset("/Engine/BasicShapes/Cube"), unreal.Vector(0, 0, 50), unreal.Rotator(yaw=45)
    )


def trace(unreal, start, end, ignore=()):
    return unreal.SystemLibrary.line_trace_single(
        unreal.EditorLevelLibrary.get_editor_world(),
        unreal.Vector(*start),
        unreal.Vector(*end),
        unreal.TraceTypeQuery.TRACE_TYPE_QUERY1,
        False,
        list(ignore),
        unreal.DrawDebugTrace.NONE,
        True,
    )


def test_a_trace_hits_the_turned_cube(unreal, cube):
    hit = trace(unreal, (-200, 0, 50), (200, 0, 50))
    fields = hit.to_dict()
    assert fields["hit_actor"] is cube and fields["blocking_hit"]
    assert fields["distance"] == pytest.approx(200 - 50 * 2**0.5)
    assert trace(unreal, (0, 0, 500), (0, 0, -10)).to_tuple()[5].z == pytest.approx(100)
    assert trace(unreal, (-200, 80, 50), (200, 80, 50)) is None
    assert trace(unreal, (-200, 0, 50), (200, 0, 50), [cube]) is None
    with pytest.raises(AttributeError):
        _ = hit.distance


def test_a_component_can_be_added_and_survives_saving(unreal, cube, tmp_path):
    subsystem = unreal.get_engine_subsystem(unreal.SubobjectDataSubsystem)
    parent = subsystem.k2_gather_subobject_data_for_instance(cube)[0]
    handle, fault = subsystem.add_new_subobject(
        unreal.AddNewSubobjectParams(parent_handle=parent, new_class=unreal.InstancedStaticMeshComponent)
    )
    assert str(fault) == ""
    library = unreal.SubobjectDataBlueprintFunctionLibrary
    row = library.get_object(subsystem.k2_find_subobject_data_from_handle(handle))
    row.set_static_mesh(unreal.load_asset("/Engine/BasicShapes/Sphere"))
    for i in range(3):
        row.add_instance(unreal.Transform(unreal.Vector(0, 0, 200 + 100 * i)), True)
    assert [round(d.matrix[2, 3]) for d in state.world().drawables()] == [50, 200, 300, 400]
    assert cube.get_actor_bounds(False)[0].z == pytest.approx(225)
    unreal.EditorLoadingAndSavingUtils.save_map(unreal.EditorLevelLibrary.get_editor_world(), "/Game/S/A")
    unreal.EditorLoadingAndSavingUtils.load_map("/Game/S/A")
    actor = unreal.EditorLevelLibrary.get_all_level_actors()[0]
    again = actor.get_component_by_class(unreal.InstancedStaticMeshComponent)
    assert again.get_instance_count() == 3
    assert again.get_instance_transform(2, True).translation.is_near_equal(unreal.Vector(0, 0, 400), 1e-6)


def test_searches(unreal, cube):
    registry = unreal.AssetRegistryHelpers.get_asset_registry()
    wanted = unreal.ARFilter(
        class_paths=[unreal.TopLevelAssetPath("/Script/Engine", "StaticMesh")],
        package_paths=["/Engine/BasicShapes"],
        recursive_paths=True,
    )
    assert [str(d.asset_name) for d in registry.get_assets(wanted)] == ["Cone", "Cube", "Cylinder", "Plane", "Sphere"]
    stats = unreal.GameplayStatics
    assert list(stats.get_all_actors_of_class(None, unreal.StaticMeshActor)) == [cube]
    assert list(stats.get_all_actors_of_class(None, unreal.Light)) == []


def test_copies_are_independent(unreal, cube):
    subsystem = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
    copy = subsystem.duplicate_actor(cube, None, unreal.Vector(300, 0, 0))
    assert copy.get_actor_location() == unreal.Vector(300, 0, 50) and copy.get_name() != cube.get_name()
    assert copy.get_actor_label() == "Cube2"
    cube.destroy_actor()
    assert copy.static_mesh_component.static_mesh.get_name() == "Cube"


def test_what_is_not_offered_is_refused_with_a_reason(unreal, capsys):
    tools = unreal.AssetToolsHelpers.get_asset_tools()
    task = unreal.AssetImportTask()
    task.filename = "/tmp/x.fbx"
    tools.import_asset_tasks([task])
    assert tools.create_asset("BP_A", "/Game/B", None, unreal.BlueprintFactory()) is None
    assert capsys.readouterr().out.count("Error: ") == 2


def test_every_annotation_of_the_api_names_a_known_type(unreal):
    known = set(dir(unreal)) | {"float", "int", "bool", "str", "None", "Any", "type", "Class", "Sequence"}
    read = 0
    containers = (unreal.Array, unreal.FixedArray, unreal.Map, unreal.Set)
    for owner in [v for v in vars(unreal).values() if isinstance(v, type) and v not in containers]:
        for member in vars(owner).values():
            checked = getattr(member, "__func__", member)
            if not hasattr(checked, "__wrapped__"):
                continue
            function = inspect.unwrap(checked)
            for parameter in inspect.signature(function).parameters.values():
                if parameter.annotation is not parameter.empty:
                    unknown = set(re.findall(r"\w+", parameter.annotation)) - known
                    assert not unknown, (owner.__name__, function.__name__, parameter.name, unknown)
                    read += 1
    assert read > len(known)
