"""Levels as GLB: instances as nodes below their actor, and levels with nothing to show."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh

from c4s.engine.headless.boot import boot
from c4s.engine.headless.glb import write_glb
from c4s.engine.headless.state import world
from c4s.errors import BadInput


def test_instances_share_one_mesh_below_their_actor(tmp_path: Path):
    unreal = boot([], tmp_path / "content")
    row = unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.Actor, unreal.Vector())
    subsystem = unreal.get_engine_subsystem(unreal.SubobjectDataSubsystem)
    parent = subsystem.k2_gather_subobject_data_for_instance(row)[0]
    kind = unreal.InstancedStaticMeshComponent.static_class()
    subsystem.add_new_subobject(unreal.AddNewSubobjectParams(parent, kind))
    component = row.get_component_by_class(unreal.InstancedStaticMeshComponent)
    component.set_static_mesh(unreal.load_asset("/Engine/BasicShapes/Cube"))
    for x, scale in ((0, 1), (500, -2)):
        component.add_instance(unreal.Transform(unreal.Vector(x, 0, 0), unreal.Rotator(), unreal.Vector(scale, 1, 1)))
    report = write_glb(world(), tmp_path / "row.glb")
    assert (report["actors"], report["meshes"], report["nodes"]) == (1, 1, 3)
    loaded = trimesh.load_scene(tmp_path / "row.glb")
    assert np.allclose(loaded.bounds * 100, [[-50, -50, -50], [600, 50, 50]], atol=0.01)
    assert all(mesh.volume > 0 for mesh in loaded.dump())


def test_an_empty_level_is_refused(tmp_path: Path):
    boot([], tmp_path / "content")
    with pytest.raises(BadInput, match="shows no mesh"):
        write_glb(world(), tmp_path / "none.glb")
    assert not (tmp_path / "none.glb").exists()
