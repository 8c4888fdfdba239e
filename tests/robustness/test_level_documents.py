"""Level documents that are wrong, huge or malicious: bad input in one line, or a level that can be exported."""

from __future__ import annotations

import json
import re
import tempfile
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from limited import cost
from odd import wrong

from c4s.bounds import BOUNDS
from c4s.engine.headless.process.boot import boot
from c4s.engine.headless.unreal.components import ABSTRACT_COMPONENTS
from c4s.engine.headless.unreal.subsystems.spawning import ABSTRACT
from c4s.errors import BadInput
from c4s.records.level import Level

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
    with pytest.raises(BadInput, match="200 MiB, more than 32 MiB"):
        Level.read(path)
    plain = '{"name":"A","label":"A","class_path":"C","guid":""},'
    for count, answer in (
        (500_000, "500,001 records, more than 400,000 records"),
        (30_001, "30,001 actors, more than 30,000 actors"),
    ):
        path.write_text(json.dumps(document([])).replace("[]", "[" + (plain * count)[:-1] + "]"))
        assert path.stat().st_size < BOUNDS["level_bytes"].most
        with pytest.raises(BadInput, match=answer):
            Level.read(path)


def part(kind: str, **changes: Any) -> dict[str, Any]:
    """A component of a class."""
    return {"name": "Part", "class_path": f"/Script/Engine.{kind}"} | changes


def light(number: int, **properties: Any) -> dict[str, Any]:
    return {
        "name": f"Light_{number}",
        "label": "Light",
        "class_path": "/Script/Engine.PointLight",
        "guid": "F" * 32,
        "components": [part("PointLightComponent", name="LightComponent0", properties=properties)],
    }


def dynamic(**material: Any) -> dict[str, Any]:
    return {"dynamic_materials": {"0": {"name": "M", "parent": ""} | material}}


ENGINE_COMPONENTS = sorted(ABSTRACT_COMPONENTS - {"SceneCaptureComponent"})


@pytest.mark.parametrize(
    ("actors", "answer"),
    [
        ([actor(1, label="x" * 1024)], "label: .* at most 1023"),
        ([actor(1, tags=["t"] * 1001)], "tags: .* at most 1000"),
        ([actor(1, folder="f" * 2000)], "folder: .* at most 1023"),
        ([light(1, intensity_units="x" * 70_000)], "70,0.. characters, more than 65,536"),
        ([light(1, **{f"p{n}": 1 for n in range(20_000)})], "characters, more than 65,536"),
        ([light(1, intensity=[[[[[[[[[[1]]]]]]]]]])], "levels of nesting"),
        ([light(1, attenuation_radius=1e308)], "at most 1e[+]15"),
        ([light(1, attenuation_radius=float("nan"))], "finite"),
        (
            [actor(1, components=[part("StaticMeshComponent", properties=dynamic(vectors={"C": [1e308] * 4}))])],
            "1e[+]15",
        ),
        ([actor(1, components=[part("StaticMeshComponent", materials=dict.fromkeys(range(1001), "/Game/M"))])], "1000"),
        ([actor(1, components=[part("SceneComponent")] * 10_001)], "components: .* at most 10000"),
        ([light(number) for number in range(1001)], "1,001 lights, more than 1,000"),
        (
            [actor(1, components=[part("InstancedStaticMeshComponent", instances=[{}] * 100_001)])],
            "100,001 mesh instances, more than 100,000",
        ),
        *(([actor(1, components=[part(kind)])], "abstract class") for kind in ENGINE_COMPONENTS),
        *(([actor(1, class_path=f"/Script/Engine.{kind}")], "abstract class") for kind in ABSTRACT[:3]),
    ],
)
def test_what_is_too_much_in_a_level_is_refused_in_one_short_line(actors: list[dict[str, Any]], answer: str) -> None:
    with pytest.raises(BadInput, match=answer) as refused:
        opened(json.dumps(document(actors)).encode())
    assert len(refused.value.line()) < 400 and "\n" not in refused.value.line()


def test_a_chain_of_material_parents_ends(tmp_path: Path) -> None:
    made = tmp_path / "Game"
    made.mkdir()
    kind = "/Script/Engine.MaterialInstanceConstant"
    for number in range(1500):
        asset = {
            "path": f"/Game/M{number}.M{number}",
            "class_path": kind,
            "parent": f"/Game/M{number + 1}.M{number + 1}",
        }
        (made / f"M{number}.asset.json").write_text(json.dumps(asset))
    worn = actor(1, components=[part("StaticMeshComponent", materials={"0": "/Game/M0.M0"})])
    (made / "Odd.level.json").write_text(json.dumps(document([worn], package="/Game/Odd")))
    with pytest.raises(BadInput, match="more than 32 parents"):
        boot([], tmp_path, [], "/Game/Odd")
    boot([], tmp_path, [], None).load_asset("/Game/M1480")
    (made / "M1499.asset.json").write_bytes(b" " * (300 << 10))
    with pytest.raises(BadInput, match="a saved asset has 300 KiB, more than 256 KiB"):
        boot([], tmp_path, [], None).load_asset("/Game/M1499")


HUGE = {
    "newlines": ("b'\\n' * (200 << 20)", "200 MiB, more than 32 MiB"),
    "empty lists": ("b'[' + b'[],' * (10 << 20) + b'0]'", "values, more than 2,000,000 values"),
    "lists in lists": ("b'[' * (1 << 20)", "level document is wrong at value"),
    "long text": ("b'{\"package\": \"' + b'x' * (31 << 20) + b'\"}'", "package: .* at most 1023"),
    "long number": ("b'{\"package\": ' + b'9' * (31 << 20) + b'}'", "a number has too many digits"),
    "many keys": ("b'{' + b','.join(b'\"%d\":1' % n for n in range(300_000)) + b'}'", "300,00. fields are wrong"),
}


@pytest.mark.parametrize("name", HUGE)
def test_a_huge_document_costs_little(name: str) -> None:
    made, answer = HUGE[name]
    script = f"from c4s.records.level import Level\ndata = {made}\ntold(lambda: Level.from_text(data, where='level'))"
    found = cost(script, memory_mib=2048, cpu_s=20)
    assert re.search(answer, found.answer) and len(found.answer) < 400
    assert found.memory_mib < 1024
