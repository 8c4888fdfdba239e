"""The gap below an actor, against a closed form."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.collision import gaps_below, scene_bodies

AT = st.floats(-300, 300)


def scene(*placed: tuple[str, tuple[float, float, float]]) -> dict[str, Any]:
    bodies = {
        "box": {"kind": "box", "center": [0, 0, 0], "half_extent": [50, 50, 50]},
        "ball": {"kind": "sphere", "center": [0, 0, 0], "radius": 50},
    }
    return {
        "actors": [
            {
                "name": f"A{i}",
                "label": f"A{i}",
                "c4s": {
                    "components": [
                        {
                            "name": "Mesh",
                            "mesh": kind,
                            "collision_enabled": True,
                            "transform": {
                                "location_cm": list(place),
                                "rotation_deg": [0, 0, 0],
                                "quaternion_xyzw": [0, 0, 0, 1],
                                "scale": [1, 1, 1],
                            },
                        }
                    ]
                },
            }
            for i, (kind, place) in enumerate(placed)
        ],
        "c4s": {
            "engine": "headless",
            "meshes": {
                kind: {"bounds_min_cm": [-50] * 3, "bounds_max_cm": [50] * 3, "collision": [body]}
                for kind, body in bodies.items()
            },
        },
    }


def gap(snapshot: dict[str, Any], *, ground_plane: bool = False) -> float | None:
    return gaps_below(snapshot, scene_bodies(snapshot), {0}, ground_plane=ground_plane)[0]


@settings(max_examples=60, deadline=None)
@given(AT, AT, st.floats(0, 500))
def test_a_ball_above_a_ball(x: float, y: float, up: float) -> None:
    apart = (x * x + y * y) ** 0.5
    found = gap(scene(("ball", (x, y, 100 + up)), ("ball", (0, 0, 0))))
    if apart > 100.5:
        assert found is None
    elif apart < 99:
        assert found == pytest.approx(100 + up - (100**2 - apart**2) ** 0.5, abs=0.05)


@settings(max_examples=60, deadline=None)
@given(AT, AT, st.floats(0, 500))
def test_a_box_above_a_box(x: float, y: float, up: float) -> None:
    found = gap(scene(("box", (x, y, 100 + up)), ("box", (0, 0, 0))))
    if max(abs(x), abs(y)) > 100.1:
        assert found is None
    elif max(abs(x), abs(y)) < 99.9:
        assert found == pytest.approx(up, abs=0.01)


def test_a_wall_beside_holds_nothing_and_the_ground_plane_is_a_choice() -> None:
    beside = scene(("box", (0, 0, 250)), ("box", (100.5, 0, 250)))
    assert gap(beside) is None
    assert gap(beside, ground_plane=True) == pytest.approx(200)
