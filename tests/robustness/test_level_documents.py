"""Level documents that are wrong, huge or malicious: bad input in one line, or a level that can be exported."""

from __future__ import annotations

import json
import tempfile
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from odd import wrong

from c4s.engine.headless.process.boot import boot
from c4s.engine.headless.world import documents
from c4s.errors import BadInput

PACKAGE = "/Game/Start/Odd"


def actor(number: int, **changes: Any) -> dict[str, Any]:
    """A cube."""
    return {
        "name": f"A_{number}",
        "label": f"L{number}",
        "class_path": "/Script/Engine.StaticMeshActor",
        "guid": f"{number:032X}",
        "components": [
            {
                "name": "StaticMeshComponent0",
                "class_path": "/Script/Engine.StaticMeshComponent",
                "static_mesh": "/Engine/BasicShapes/Cube.Cube",
            }
        ],
    } | changes


def document(actors: list[dict[str, Any]], **changes: Any) -> dict[str, Any]:
    return {"schema_version": "c4s.level.v1", "package": PACKAGE, "actors": actors} | changes


RICH = document(
    [
        actor(
            1,
            transform={"location_cm": [1, 2, 3], "rotation_deg": [10, 20, 30], "scale": [1, -1, 2]},
            tags=["a", "b"],
            folder="F",
            hidden=True,
        ),
        actor(
            2,
            parent="A_1",
            components=[
                {
                    "name": "I",
                    "class_path": "/Script/Engine.InstancedStaticMeshComponent",
                    "materials": {"0": "/Game/M.M"},
                    "static_mesh": "/Engine/BasicShapes/Cube.Cube",
                    "collision_enabled": False,
                    "relative": {"location_cm": [0, 0, 1]},
                    "instances": [{"location_cm": [5, 0, 0]}, {"scale": [2, 2, 2]}],
                }
            ],
        ),
        {
            "name": "Sun",
            "label": "Sun",
            "class_path": "/Script/Engine.DirectionalLight",
            "guid": "F" * 32,
            "components": [
                {
                    "name": "LightComponent0",
                    "class_path": "/Script/Engine.DirectionalLightComponent",
                    "properties": {"intensity": 3.0, "light_color": [255, 200, 100, 255]},
                }
            ],
        },
    ]
)


def opened(data: bytes) -> dict[str, Any]:
    """The snapshot of a level document that an engine opens, through JSON that has no NaN."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "odd.level.json"
        path.write_bytes(data)
        boot([], Path(folder) / "content", [path], PACKAGE)
        from c4s.editor import snapshot

        told: dict[str, Any] = json.loads(json.dumps(snapshot.export_snapshot(), allow_nan=False))
        return told


def test_the_document_that_is_varied_is_sound() -> None:
    assert opened(json.dumps(RICH).encode())["actor_count"] == 3


@given(wrong(RICH))
@settings(max_examples=150, deadline=None)
def test_a_wrong_document_is_bad_input_or_a_level(data: bytes) -> None:
    try:
        snapshot = opened(data)
    except BadInput as error:
        assert "\n" not in error.line() and len(error.line()) < 20_000
    else:
        assert snapshot["actor_count"] <= 3


@given(
    st.dictionaries(
        st.sampled_from(["A_0", "A_1", "A_2", "A_3"]), st.sampled_from(["A_0", "A_1", "A_2", "A_3", "A_9", None])
    )
)
@settings(max_examples=40, deadline=None)
def test_attachment_is_a_forest_or_bad_input(parents: dict[str, str | None]) -> None:
    data = json.dumps(document([actor(n, parent=parents.get(f"A_{n}")) for n in range(4)])).encode()

    def leads_up(name: str | None) -> bool:
        for _ in range(5):
            if name is None:
                return True
            name = parents.get(name) if name != "A_9" else "A_9"
        return False

    if all(leads_up(name) for name in parents):
        assert opened(data)["actor_count"] == 4
    else:
        with pytest.raises(BadInput, match=r"parent|attached"):
            opened(data)


@pytest.mark.parametrize("order", [1, -1])
def test_a_chain_without_end_is_refused(order: int) -> None:
    chain = [actor(n, parent=f"A_{n - 1}" if n else None) for n in range(3000)][::order]
    with pytest.raises(BadInput, match="more than 100 deep"):
        opened(json.dumps(document(chain)).encode())


@pytest.mark.parametrize(
    ("numbers", "answer"),
    [("NaN", "finite"), ("Infinity", "finite"), ("1e308", "finite"), ("1e400", "JSON|finite"), ("1e-320", None)],
)
def test_numbers_at_the_edge(numbers: str, answer: str | None) -> None:
    text = json.dumps(document([actor(1, transform={"location_cm": [77, 0, 0], "scale": [77, 1, 1]})]))
    data = text.replace("77", numbers).encode()
    if answer is None:
        assert opened(data)["actor_count"] == 1
    else:
        with pytest.raises(BadInput, match=answer):
            opened(data)


def test_labels_may_repeat_and_names_may_not() -> None:
    assert opened(json.dumps(document([actor(1, label="x"), actor(2, label="x")])).encode())["actor_count"] == 2
    with pytest.raises(BadInput, match="two actors have this object name"):
        opened(json.dumps(document([actor(1), actor(1)])).encode())


def test_nesting_without_end_is_refused() -> None:
    for inner in ("[" * 100_000 + "]" * 100_000, '{"a":' * 100_000 + "1" + "}" * 100_000):
        with pytest.raises(BadInput):
            opened(json.dumps(document([actor(1, properties="INNER")])).replace('"INNER"', inner).encode())


def test_a_million_actors_get_a_clear_answer_within_bounds(tmp_path: Path) -> None:
    path = tmp_path / "many.level.json"
    with path.open("wb") as file:
        file.truncate(200 << 20)
    with pytest.raises(BadInput, match="200 MiB, more than 64"):
        documents.read(path)
    plain = '{"name":"A","label":"A","class_path":"C","guid":""},'
    for count, answer in (
        (1_000_000, "1000001 records, more than 600000"),
        (100_001, "100001 actors, more than 100000"),
    ):
        path.write_text(json.dumps(document([])).replace("[]", "[" + (plain * count)[:-1] + "]"))
        assert path.stat().st_size < documents.MOST_BYTES
        with pytest.raises(BadInput, match=answer):
            documents.read(path)
