"""Published image tasks: what they need, and content of one's own under the published paths."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from c4s.engine.headless.process.boot import boot
from c4s.engine.headless.world.state import world
from c4s.errors import BadInput
from c4s.packs.check import check_pack
from cases.code4scene.importer import import_code4scene
from cases.code4scene.needs import read_table
from catalog.ingest.folder import ingest
from tests.shared import SHARED

PUBLIC = SHARED / "upstream/benchmark/public"
FURNITURE = SHARED / "assets/packs/kaykit-furniture"
CHAIR = "/Game/ArchVizInteriorVol2/Meshes/SM_Chair.SM_Chair"
TASK = "image-to-scene/indoor/a20-s01-extra-chair-removal"
here = pytest.mark.skipif(not (PUBLIC.is_dir() and FURNITURE.is_dir()), reason="needs ../shared")


@pytest.fixture(scope="module")
def packs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A home's packs with four chairs and tables of a public pack."""
    folder, root = tmp_path_factory.mktemp("meshes"), tmp_path_factory.mktemp("packs")
    for file in FURNITURE.iterdir():
        if file.name.startswith(("chair_A", "LICENSE", "SOURCE")) or file.suffix == ".png":
            shutil.copy(file, folder / file.name)
    ingest(folder, "furniture", root)
    return root


def imported(tmp_path: Path, packs: Path, rows: list[str]) -> dict[str, Any]:
    tasks = tmp_path / "tasks"
    for name in (TASK, "text-to-scene/case_011", "image-to-scene/indoor/a20-s02-picture-rotation"):
        shutil.copytree(PUBLIC / name, tasks / name)
    shutil.copytree(PUBLIC / "scenes", tasks / "scenes")
    shutil.copy(PUBLIC.parent / "packs.yaml", tasks / "packs.yaml")
    table = tmp_path / "content.csv"
    table.write_text("\n".join(["published,pack,asset", *rows]) + "\n")
    home = tmp_path / "packs"
    shutil.copytree(packs, home)
    return import_code4scene(tasks, tmp_path / "suites" / "pub", home, lambda _: None, content=table)


@here
def test_needs_are_told_a_task_and_together_and_given_content_is_taken(tmp_path: Path, packs: Path) -> None:
    report = imported(tmp_path, packs, [f"{CHAIR},furniture,chair_a", "/Game/X/SM_Y.SM_Y,furniture,chair_a"])
    row = next(row for row in report["cases"] if row["case_id"] == "a20-s01-extra-chair-removal")
    assert row["needs"]["packs"] == ("ArchVizInteriorVol2",) and CHAIR in row["needs"]["assets"]
    assert "/Game/Code4SceneGT/archviz-apartment/GT" in row["needs"]["levels"] and not row["runnable"]
    needs = report["needs"]
    named = {pack["folder"]: pack for pack in needs["packs"]}
    assert set(named) == {"ArchVizInteriorVol2", "DetectiveOffice"} and named["ArchVizInteriorVol2"]["url"]
    assert needs["given"] == {CHAIR: "furniture:chair_a"} and needs["not_needed"] == ["/Game/X/SM_Y.SM_Y"]
    assert CHAIR not in needs["not_given"] and sum(needs["not_given"].values()) == 7
    assert "not published" in needs["levels_note"]
    made = tmp_path / "packs" / report["content_pack"]
    check_pack(made)
    unreal = boot([made], tmp_path / "content")
    operation = json.loads((PUBLIC / TASK / "recipe.json").read_text())["operations"][0]
    chair = unreal.load_asset(operation["from"]["static_mesh"].partition(".")[0])
    spawned = unreal.EditorLevelLibrary.spawn_actor_from_object(chair, unreal.Vector(*operation["location_cm"]))
    (shown,) = list(world().drawables())
    assert shown.mesh == CHAIR and len(world().store.mesh(CHAIR).faces) > 100
    assert spawned.static_mesh_component.get_material(0).get_path_name().startswith("/Game/")


@here
@pytest.mark.parametrize(
    ("table", "said"),
    [
        ("published,pack,asset,colour\n", "line 1: unknown column 'colour'"),
        ("published,pack\n", "line 1: each column once"),
        (f"published,pack,asset\n{CHAIR},furniture,chair_z\n", "line 2: the pack 'furniture' has no asset 'chair_z'"),
        (f"published,pack,asset\n\n{CHAIR},nothing,chair_a\n", "line 3: no pack 'nothing' is built"),
        (f"published,pack,asset\n{CHAIR},../furniture,chair_a\n", "line 2: pack: "),
        (f"published,pack,asset\n{CHAIR},furniture,chair_a\n{CHAIR},furniture,chair_a\n", "line 3: "),
        ("published,pack,asset\n/Game/A/BP_A.BP_A_C,furniture,chair_a\n", "line 2: /Game/A/BP_A.BP_A_C"),
        ("published,pack,asset\nSM_Chair,furniture,chair_a\n", "line 2: 'SM_Chair' is no path of an asset"),
        (f"published,pack,asset\n{CHAIR},furniture\n", "line 2: 2 values for 3 columns"),
        ("", "a table has 1 to"),
    ],
)
def test_a_wrong_table_is_refused_by_line(tmp_path: Path, packs: Path, table: str, said: str) -> None:
    file = tmp_path / "content.csv"
    file.write_text(table)
    with pytest.raises(BadInput) as caught:
        read_table(file, packs)
    assert said in str(caught.value) and str(file) in str(caught.value)
