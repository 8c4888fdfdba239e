"""Out and in again: a level that is exported as GLB and imported is the same scene to a tenth of a millimetre."""

from __future__ import annotations

from collections import defaultdict
from pathlib import Path

import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree

from c4s.engine.headless.glb.export import export
from c4s.engine.headless.process.boot import boot
from c4s.engine.headless.world.state import world
from c4s.engine.headless.world.world import Drawable
from c4s.records.level import Level, LevelActor, LevelComponent, Transform
from cases.corruption import STATIC_MESH_ACTOR, STATIC_MESH_COMPONENT, guid_of
from cases.importers.importing import import_scene
from cases.starter.farm_scene import build as farm_scene
from tests.built import built_packs

LOOKS = ("base_color", "roughness", "metallic", "emissive", "opacity", "alpha")
MOST_CM = 0.01
"""A tenth of a millimetre."""


def drawn(level: Path, packs: list[Path], content: Path) -> list[Drawable]:
    content.mkdir(parents=True, exist_ok=True)
    boot(packs, content, levels=[level], start_map=Level.read(level).package)
    return list(world().drawables())


def corners(shown: list[Drawable]) -> np.ndarray:
    """Corners of all triangles in the world (cm), sorted by place."""
    found = []
    for one in shown:
        mesh = world().store.mesh(one.mesh)
        points = np.c_[mesh.vertices.astype(float), np.ones(len(mesh.vertices))] @ one.matrix.T
        found.append(points[np.unique(mesh.faces), :3])
    every = np.concatenate(found)
    return every[np.lexsort(np.round(every, 1).T)]


def looks(shown: list[Drawable]) -> dict[str, list[tuple[object, ...]]]:
    """By label: the materials of each slot, by name (an import puts ``M_`` before it) and values."""
    found = defaultdict(list)
    for one in shown:
        found[one.actor.get_actor_label()] += [
            (m.path.rsplit(".", 1)[-1].removeprefix("M_"), *(getattr(m, name) for name in LOOKS)) for m in one.materials
        ]
    return {label: sorted(slots, key=repr) for label, slots in found.items()}


def away_cm(one: np.ndarray, other: np.ndarray) -> float:
    """How far the farthest corner of either has to the other's nearest."""
    return float(max(cKDTree(one).query(other)[0].max(), cKDTree(other).query(one)[0].max()))


def there_and_back(level: Level, packs: list[Path], folder: Path) -> tuple[set[str], set[str], Level]:
    """Export and import: the labels and the meshes that the level shows, and the level that it comes back as."""
    folder.mkdir(parents=True, exist_ok=True)
    file, glb = folder / "there.level.json", folder / "there.glb"
    level.write(file)
    export(file, packs, glb)
    report = import_scene(glb, "back", suites=folder / "suites", packs=folder / "packs", replace=True)
    back = Path(report["level"])
    assert report["skipped"] == []
    before = drawn(file, packs, folder / "one")
    points = corners(before)
    told, meshes = looks(before), {one.mesh for one in before}
    after = drawn(back, [folder / "packs" / "back"], folder / "two")
    assert away_cm(points, corners(after)) < MOST_CM
    found = looks(after)
    assert {label: told[label] for label in set(told) & set(found)} == {k: found[k] for k in set(told) & set(found)}
    assert len(before) == len(after) and len({one.mesh for one in after}) == len(meshes)
    return set(told), meshes, Level.read(back)


def shape(number: int, kind: str, place: Transform, parent: str | None) -> LevelActor:
    mesh = f"/Engine/BasicShapes/{kind}.{kind}"
    component = LevelComponent(name="StaticMeshComponent0", class_path=STATIC_MESH_COMPONENT, static_mesh=mesh)
    return LevelActor(
        name=f"Thing_{number}",
        label=f"Thing_{number}",
        class_path=STATIC_MESH_ACTOR,
        guid=guid_of(str(number)),
        transform=place,
        components=[component],
        parent=parent,
    )


def numbers(low: float, high: float) -> st.SearchStrategy[float]:
    return st.floats(low, high, allow_subnormal=False)


factors = st.one_of(numbers(0.0625, 10), numbers(-10, -0.0625))
places = st.builds(
    Transform,
    location_cm=st.tuples(*[numbers(-50_000, 50_000)] * 3),
    rotation_deg=st.tuples(numbers(-89, 89), numbers(-180, 180), numbers(-180, 180)),
    scale=st.tuples(factors, factors, factors),
)
shapes = st.tuples(st.sampled_from(["Cube", "Cone", "Cylinder"]), places, st.booleans())


@settings(max_examples=10, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.lists(shapes, min_size=1, max_size=4))
def test_turned_mirrored_and_attached_things_come_back(tmp_path: Path, things: list[tuple[str, Transform, bool]]):
    actors = [
        shape(n, kind, place, f"Thing_{n - 1}" if attached and n else None)
        for n, (kind, place, attached) in enumerate(things)
    ]
    _, _, level = there_and_back(Level(package="/Game/Maps/Yard", actors=actors), [], tmp_path)
    # An actor that holds others is a node of its own, and its component one below it.
    names = [actor.label for actor in level.actors]
    assert all(any(f"Thing_{n}" in name for name in names) for n in range(len(things)))


def test_a_starter_scene_comes_back(tmp_path_factory, tmp_path: Path):
    packs = [built_packs(tmp_path_factory, "c4s-farm") / "c4s-farm"]
    labels, _, level = there_and_back(farm_scene().level, packs, tmp_path)
    assert len(labels & {actor.label for actor in level.actors}) > 100
    suns = [a for a in level.actors if a.class_path.endswith("DirectionalLight")]
    authored = [a for a in farm_scene().level.actors if a.class_path.endswith("DirectionalLight")]
    assert [a.components[0].properties["intensity"] for a in suns] == [
        a.components[0].properties["intensity"] for a in authored
    ]
