"""The snapshot read from the engine's own state is the one read through ``unreal``, whatever scripts did."""

from __future__ import annotations

import importlib
import json
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.engine.headless.process.boot import boot

SHAPES = ("Cube", "Sphere", "Cylinder")
CLASSES = (
    "PointLight",
    "SpotLight",
    "DirectionalLight",
    "ExponentialHeightFog",
    "PostProcessVolume",
    "CameraActor",
    "StaticMeshActor",
    "TextRenderActor",
    "DecalActor",
    "SkyLight",
)
NUMBERS = st.integers(-4000, 4000).map(lambda whole: whole / 8)
SCALES = st.sampled_from([-2.0, -1.0, 0.0, 0.5, 1.0, 3.0])
PICK = st.integers(0, 30)
EDITS = st.lists(
    st.one_of(
        st.tuples(st.just("mesh"), st.sampled_from(SHAPES), NUMBERS, NUMBERS),
        st.tuples(st.just("class"), st.sampled_from(CLASSES), NUMBERS, NUMBERS),
        st.tuples(st.just("move"), PICK, NUMBERS, NUMBERS),
        st.tuples(st.just("turn"), PICK, NUMBERS, NUMBERS, NUMBERS),
        st.tuples(st.just("scale"), PICK, SCALES, SCALES, SCALES),
        st.tuples(st.just("attach"), PICK, PICK, st.booleans()),
        st.tuples(
            st.sampled_from(["detach", "delete", "copy", "swap", "dynamic", "quiet", "hide", "bare", "lone"]), PICK
        ),
        st.tuples(st.just("label"), PICK, st.sampled_from(["Door", "Tür", " a b "])),
        st.tuples(
            st.just("tags"), PICK, st.sampled_from([["simcodearena.stable_actor_id=x1"], ["a", "A", ""], ["k = v"], []])
        ),
        st.tuples(st.just("folder"), PICK, st.sampled_from(["A/B", "None", ""])),
        st.tuples(st.sampled_from(["unseen", "conceal", "obscure"]), PICK),
        st.tuples(st.just("collide"), PICK, st.sampled_from(["QUERY_ONLY", "PHYSICS_ONLY", "QUERY_AND_PHYSICS"])),
        st.tuples(st.just("rename"), PICK, st.sampled_from(["Named_1", "Named_2"])),
        st.tuples(st.just("instances"), PICK, st.lists(st.tuples(NUMBERS, NUMBERS, SCALES), max_size=3)),
    ),
    max_size=25,
)


class Editor:
    """Edits a level as scripts do. Edits of an actor are skipped while there is none."""

    def __init__(self, unreal: Any) -> None:
        self.unreal = unreal
        self.actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)

    def __call__(self, kind: str, *given: Any) -> None:
        if kind in ("mesh", "class"):
            what = (
                self.unreal.load_asset(f"/Engine/BasicShapes/{given[0]}")
                if kind == "mesh"
                else getattr(self.unreal, given[0])
            )
            spawn = self.actors.spawn_actor_from_object if kind == "mesh" else self.actors.spawn_actor_from_class
            spawn(what, self.unreal.Vector(given[1], given[2], 10))
            return
        there = list(self.actors.get_all_level_actors())
        if there:
            getattr(self, kind)(there[given[0] % len(there)], *given[1:])

    def move(self, actor, x, y):
        actor.set_actor_location(self.unreal.Vector(x, y, 0), False, True)

    def turn(self, actor, *angles):
        actor.set_actor_rotation(self.unreal.Rotator(*angles), True)

    def scale(self, actor, *scale):
        actor.set_actor_scale3d(self.unreal.Vector(*scale))

    def attach(self, actor, number, keep):
        there = self.actors.get_all_level_actors()
        rule = self.unreal.AttachmentRule.KEEP_WORLD if keep else self.unreal.AttachmentRule.SNAP_TO_TARGET
        actor.attach_to_actor(there[number % len(there)], "", rule, rule, rule)

    def detach(self, actor):
        actor.detach_from_actor()

    def delete(self, actor):
        self.actors.destroy_actor(actor)

    def copy(self, actor):
        self.actors.duplicate_actor(actor, None, self.unreal.Vector(5, 0, 0))

    def label(self, actor, text):
        actor.set_actor_label(text)

    def tags(self, actor, texts):
        actor.set_editor_property("tags", texts)

    def rename(self, actor, name):
        actor.rename(name)

    def hide(self, actor):
        actor.set_actor_hidden_in_game(True)

    def conceal(self, actor):
        actor.set_is_temporarily_hidden_in_editor(True)

    def unseen(self, actor):
        for part in actor.get_components_by_class(self.unreal.SceneComponent):
            part.set_visibility(False)

    def obscure(self, actor):
        actor.root_component.set_hidden_in_game(True)

    def folder(self, actor, path):
        actor.set_folder_path(path)

    def collide(self, actor, name):
        for part in actor.get_components_by_class(self.unreal.PrimitiveComponent):
            part.set_collision_enabled(getattr(self.unreal.CollisionEnabled, name))

    def quiet(self, actor):
        actor.set_actor_enable_collision(False)

    def lone(self, actor):
        for part in actor.get_components_by_class(self.unreal.PrimitiveComponent):
            part.set_collision_enabled(self.unreal.CollisionEnabled.NO_COLLISION)

    def _meshes(self, actor):
        return actor.get_components_by_class(self.unreal.StaticMeshComponent)

    def swap(self, actor):
        for part in self._meshes(actor):
            part.set_static_mesh(self.unreal.load_asset("/Engine/BasicShapes/Cone"))

    def bare(self, actor):
        for part in self._meshes(actor):
            part.set_static_mesh(None)

    def dynamic(self, actor):
        for part in self._meshes(actor):
            part.create_dynamic_material_instance(0)

    def instances(self, actor, rows):
        subsystem = self.unreal.get_engine_subsystem(self.unreal.SubobjectDataSubsystem)
        handles = subsystem.k2_gather_subobject_data_for_instance(actor)
        handle, _ = subsystem.add_new_subobject(
            self.unreal.AddNewSubobjectParams(
                parent_handle=handles[0], new_class=self.unreal.InstancedStaticMeshComponent
            )
        )
        library = self.unreal.SubobjectDataBlueprintFunctionLibrary
        made = library.get_object(library.get_data(handle))
        made.set_static_mesh(self.unreal.load_asset("/Engine/BasicShapes/Cube"))
        for x, yaw, scale in rows:
            made.add_instance(self.unreal.Transform((x, 0, 0), (0, 0, yaw), (scale, 1, 1)))


@pytest.fixture(scope="module")
def content(tmp_path_factory):
    return tmp_path_factory.mktemp("content")


@settings(max_examples=40, deadline=None)
@given(edits=EDITS)
def test_both_readers_give_the_same_snapshot(content, edits):
    unreal = boot([], content)
    from c4s.editor import snapshot
    from c4s.editor.facts import Reader
    from c4s.engine.headless.process.facts import DirectReader

    edit = Editor(unreal)
    for number, each in enumerate([*edits, ("mesh", "Cube", 0.0, 0.0)]):
        edit(*each)
        if number % 5 == 0 or number == len(edits):
            readers = Reader(), DirectReader()
            texts = [
                [json.dumps(snapshot.export_actor(actor, {}, reader)) for actor in edit.actors.get_all_level_actors()]
                for reader in readers
            ]
            assert texts[0] == texts[1]
            assert readers[0].materials == readers[1].materials


def test_an_engine_reads_its_own_state(content, monkeypatch):
    boot([], content)
    snapshot, host, offers = (
        importlib.import_module(name)
        for name in ("c4s.editor.snapshot", "c4s.editor.host", "c4s.engine.headless.process.offers")
    )
    monkeypatch.setattr(host, "_host", host.PlainEditor())
    host.register(offers.HOST)
    host.register(offers.HOST)
    assert isinstance(host.host().reader(), offers.DirectReader)
    assert snapshot.export_snapshot()["actors"] == []
    with pytest.raises(RuntimeError, match="is the host already"):
        host.register(host.PlainEditor())
