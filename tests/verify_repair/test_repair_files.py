"""Scoring snapshot files, whose actors stay text, gives what scoring their plain data gives, whatever they hold."""

from __future__ import annotations

import json
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from hypothesis import given
from hypothesis import strategies as st

from c4s.errors import BadInput
from c4s.verify.repair import repair_verdict, verify_repair
from tests.verify_repair.repair_scenes import Scene, actor, scene

ODD = st.sampled_from(
    [
        None,
        True,
        0,
        -0.0,
        "",
        "1.5",
        [],
        {},
        [1, 2],
        [1, 2, 3],
        [True, 0, 0],
        [0.0, 0.0, 1e308],
        float("nan"),
        [float("inf"), 0, 0],
        {"location_cm": [1, 2, 3]},
        "/Game/A.A",
        'ü\\"\n',
    ]
)
FIELDS = st.sampled_from(
    [
        "class",
        "asset_path",
        "component_asset_paths",
        "transform",
        "material_paths",
        "properties",
        "component_material_slots",
        "bounds",
        "label",
        "stable_actor_id",
        "text",
        "parsed",
    ]
)
PLACES = st.sampled_from([0.0, 0.05, 0.1, 0.15, 49.95, 50.0, 400.0, -1e9])


@st.composite
def _scene(draw: st.DrawFn) -> Scene:
    actors = []
    for n in range(draw(st.integers(0, 5))):
        one = actor(
            f"{n}",
            draw(st.sampled_from(["Chair", "Table"])),
            (draw(PLACES), 0.0, 0.0),
            yaw=draw(st.sampled_from([0.0, 180.0, -180.0])),
        )
        for field, value in draw(st.dictionaries(FIELDS, ODD, max_size=2)).items():
            one[field] = value
        actors.append(one)
    return scene(*actors)


def _outcome(score: Any) -> Any:
    try:
        verdict = score()
    except BadInput as error:
        return error.line()
    return verdict.reason or verdict.model_dump(exclude={"inputs"})


@given(_scene(), _scene(), _scene())
def test_text_and_plain_data_agree(start: Scene, truth: Scene, candidate: Scene) -> None:
    with TemporaryDirectory() as folder:
        paths = []
        for name, value in (("input", start), ("truth", truth), ("candidate", candidate)):
            paths.append(Path(folder) / f"{name}.json")
            paths[-1].write_text(json.dumps(value))
        from_files = _outcome(lambda: verify_repair(*paths))
        plain = _outcome(lambda: repair_verdict(*(json.loads(path.read_text()) for path in paths)))
    assert json.dumps(from_files) == json.dumps(plain)
