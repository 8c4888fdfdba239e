"""The surfaces that a snapshot tells of are those that the engine's own line traces meet."""

from __future__ import annotations

import numpy as np
import pytest
from query_scene import BODIES, Scene, row

from c4s.collision import scene_bodies
from c4s.engine.headless.world.state import world
from c4s.verify.physics.surfaces import Surfaces

KINDS = [*BODIES, "Cube", "Sphere", "Cone", "Plane"]


@pytest.mark.parametrize("triangles", [True, False], ids=["triangles", "bodies"])
@pytest.mark.parametrize("seed", range(6))
def test_many_lines_meet_what_single_traces_meet(scene: Scene, seed: int, triangles: bool) -> None:
    from c4s.editor.snapshot import export_snapshot  # runs inside the engine that the fixture made

    rng = np.random.default_rng(seed)
    actors = [
        scene.put(
            str(rng.choice(KINDS)),
            rng.uniform(-200, 200, 3),
            rng.uniform(-180, 180, 3).tolist() if seed % 2 else (0, float(rng.uniform(-180, 180)), 0),
            rng.choice([-1.5, 0.3, 1.0, 2.0], 3) * (rng.random(3) > 0.03),
        )
        for _ in range(25)
    ]
    actors[3].static_mesh_component.set_collision_enabled(scene.unreal.CollisionEnabled.NO_COLLISION)
    snapshot = export_snapshot()
    surfaces = Surfaces(snapshot, scene_bodies(snapshot), world().store.recorded_mesh if triangles else None)
    assert surfaces.unknown == {}
    start = rng.uniform(-300, 300, (120, 3))
    step = rng.uniform(-400, 400, (120, 3))
    step[:60], start[:60, 2] = (0.0, 0.0, -2000.0), 400.0
    own = rng.integers(0, len(actors), 120)
    found = surfaces.first(start, step, own)
    place = {actor["name"]: index for index, actor in enumerate(snapshot["actors"])}
    for k in range(len(start)):
        ignored = next(actor for actor in actors if place[actor.get_name()] == own[k])
        hit = scene.line(start[k], start[k] + step[k], triangles=triangles, ignore=[ignored])
        if hit is None:
            assert found.actor[k] == -1
            continue
        values = hit.to_dict()
        assert found.point[k] == pytest.approx(row(values["impact_point"]), abs=1e-5)
        assert bool(found.inside[k]) == values["initial_overlap"]
        if not found.inside[k]:
            assert found.actor[k] == place[values["hit_actor"].get_name()]
            assert found.normal[k] == pytest.approx(row(values["impact_normal"]), abs=1e-5)
    assert (found.actor >= 0).sum() > 20
