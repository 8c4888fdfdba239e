"""Which edited bodies others hold from below or the side (the diagnostic leaf), against dense sampling of the exact
signed distance."""

from __future__ import annotations

import math

import numpy as np
from collision_scenes import actor, scene
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle import exact_depth

from c4s.verify.physics.verdict import verify_physics

WAYS = [(0.0, 0.0, -1.0), *((math.cos(k * math.pi / 4), math.sin(k * math.pi / 4), 0.0) for k in range(8))]
STEPS = np.linspace(0.0, 5.0, 11)
FAR = 1000.0


def deepest(mine: np.ndarray, other: np.ndarray) -> float:
    """The largest depth in cm (negative: the least distance) over all sampled places on all nine ways."""
    return max(exact_depth(mine + step * np.array(way), other, FAR) - FAR for way in WAYS for step in STEPS)


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 2**32 - 1), st.booleans(), st.booleans())
def test_hulls_are_held_exactly_when_they_meet_on_a_way(seed, thin, far):
    rng = np.random.default_rng(seed)
    cores = [rng.normal(size=(5, 3)) * rng.uniform(0.01 if thin else 1, 30, 3) for _ in range(2)]
    cores[0] += rng.normal(size=3) * 25
    place = np.array([1e5, -1e5, 0.0]) if far else np.zeros(3)
    meshes = {str(k): [{"kind": "hull", "vertices": core.tolist()}] for k, core in enumerate(cores)}
    bounds = {"origin_cm": [0.0, 0.0, 0.0], "extent_cm": [1.0, 1.0, 1.0]}
    edited, base = (actor(name, name, place, stable_actor_id=name, bounds=bounds) for name in "01")
    found = verify_physics("image-to-scene/indoor", scene(meshes, edited, base), scene(meshes, base))
    floats = found.measurements["diagnostic_leaves"][0]["score"] == 1.0
    depth = deepest(*cores)
    if depth > 0.01:
        assert not floats
    elif depth < -(STEPS[1] / 2 + 0.01):
        assert floats
