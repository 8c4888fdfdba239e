"""What a source folder holds: other formats, links, archives, odd names, tables that describe, second builds."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from c4s.errors import BadInput
from c4s.files import read_json
from c4s.packs.store import PackStore
from c4s.trees import digest_tree
from catalog.ingest.colours import colours_of
from catalog.ingest.folder import ingest
from catalog.ingest.source import read_source
from catalog.ingest.vocabulary import kind_of, readable, search_words
from catalog.ingest.writer import identifier
from tests.catalog.gltf_maker import Gltf


def box(path: Path, size: tuple[float, float, float] = (1, 2, 3), color: tuple[float, ...] = (1, 1, 1, 1)) -> Path:
    """A box in a file."""
    path.parent.mkdir(parents=True, exist_ok=True)
    made = Gltf()
    made.tree["materials"] = [{"name": "paint", "pbrMetallicRoughness": {"baseColorFactor": list(color)}}]
    made.mesh(made.box(size, material=0))
    return made.write(path)


def skipped(report: dict[str, Any]) -> dict[str, str]:
    """Reasons by file."""
    return {row["file"]: row["reason"] for row in report["skipped"]}


def assets(report: dict[str, Any]) -> dict[str, Any]:
    """Assets by id."""
    return {asset["id"]: asset for asset in read_json(Path(report["folder"]) / "pack.json")["assets"]}


def test_other_formats_archives_and_links_are_named_and_not_read(tmp_path: Path) -> None:
    source, outside = tmp_path / "source", box(tmp_path / "outside" / "secret.glb")
    box(source / "GLB format" / "chair.glb")
    (source / "OBJ format").mkdir()
    (source / "OBJ format" / "chair.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    for name in ("chair.fbx", "lamp.fbx", "scene.blend", "room.usdz", "more.zip"):
        (source / name).write_bytes(b"x")
    (source / "stolen.glb").symlink_to(outside)
    (source / "gone.glb").symlink_to(tmp_path / "nothing")
    (source / "folder").symlink_to(outside.parent)
    (source / "loop").symlink_to(source)
    report = ingest(source, "mixed", tmp_path / "packs")
    assert list(assets(report)) == ["chair"]
    why = skipped(report)
    assert why["OBJ format/chair.obj"] == why["chair.fbx"] == "the same thing in another format is read"
    assert "FBX files are not read" in why["lamp.fbx"] and "Blender" in why["scene.blend"] and "USD" in why["room.usdz"]
    assert "unpack it" in why["more.zip"] and "out of the folder" in why["stolen.glb"] and "nothing" in why["gone.glb"]
    assert "out of the folder" in why["folder"] and "link to a folder" in why["loop"]


def test_an_archive_or_a_file_in_place_of_a_folder_says_what_to_do(tmp_path: Path) -> None:
    (tmp_path / "kit.zip").write_bytes(b"PK")
    with pytest.raises(BadInput, match=r"archive.*unzip kit\.zip"):
        ingest(tmp_path / "kit.zip", "kit", tmp_path)
    with pytest.raises(BadInput, match="a file, not a folder"):
        ingest(box(tmp_path / "a.glb"), "kit", tmp_path)
    (tmp_path / "blends").mkdir()
    (tmp_path / "blends" / "a.blend").write_bytes(b"x")
    with pytest.raises(BadInput, match=r"no mesh files here.*a\.blend: Blender files are not read"):
        ingest(tmp_path / "blends", "kit", tmp_path)
    with pytest.raises(BadInput, match="a shipped pack has this id"):
        ingest(tmp_path / "blends", "c4s-office", tmp_path)


def test_names_of_every_kind_become_distinct_paths(tmp_path: Path) -> None:
    names = ["стул", "стол", "椅子", "Café Tisch", "a.b c+d#1", "CON", "chair_C", "x" * 180, "Chair", "-"]
    for name in names:
        box(tmp_path / "source" / f"{name}.glb")
    box(tmp_path / "source" / "sub" / "chair.glb")
    report = ingest(tmp_path / "source", "names", tmp_path / "packs")
    store = PackStore([Path(report["folder"])])
    found = store.packs[Path(report["folder"])].assets
    assert len(found) == len(names) + 1 and report["skipped"] == []
    assert len({asset.path.lower() for asset in found}) == len(found)
    for asset in found:
        stem = asset.path.rsplit(".", 1)[-1]
        assert stem.isascii() and stem.replace("_", "").isalnum() and len(stem) < 110 and not stem.endswith("_C")
        assert store.mesh(asset.path).vertices.shape == (len(store.mesh(asset.path).vertices), 3)
    assert "Стул" in {asset.name for asset in found} and identifier("Café Tisch") == "Cafe_Tisch"


def test_a_table_of_the_folder_describes_and_wins(tmp_path: Path) -> None:
    source = tmp_path / "source"
    box(source / "a1.glb")
    box(source / "b2.glb")
    (source / "list.csv").write_text(
        "file,name,category,description,tags\na1.glb,Reading chair,seating,A chair for one.,soft; green\nnone.glb,,,,\n"
    )
    found = assets(ingest(source, "told", tmp_path / "packs"))
    assert (found["a1"]["name"], found["a1"]["category"]) == ("Reading chair", "seating")
    assert found["a1"]["description"] == "A chair for one." and found["a1"]["tags"][:2] == ["soft", "green"]
    assert found["b2"]["category"] == "props"


def test_an_unchanged_folder_is_not_built_again_and_a_changed_one_is(tmp_path: Path) -> None:
    source, packs = tmp_path / "source", tmp_path / "packs"
    box(source / "a.glb")
    (source / "broken.glb").write_bytes(b"glTF")
    first = ingest(source, "p", packs)
    os.utime(source / "a.glb", (1, 1))
    before = (packs / "p" / "pack.json").stat().st_mtime_ns
    again = ingest(source, "p", packs)
    assert again == {**first, "cached": True} and (packs / "p" / "pack.json").stat().st_mtime_ns == before
    assert digest_tree(packs / "p") and skipped(again) == skipped(first) != {}
    with pytest.raises(BadInput, match=r"another pack of this name.*--replace"):
        ingest(source, "p", packs, scale=2.0)
    assert ingest(source, "p", packs) == again, "what is there was left alone"
    assert not ingest(source, "p", packs, scale=2.0, replace=True)["cached"]
    box(source / "a.glb", (4, 4, 4))
    changed = ingest(source, "p", packs, scale=2.0, replace=True)
    assert not changed["cached"] and assets(changed)["a"]["bounds_max_cm"] == [400, 400, 400]
    (packs / "p" / "pack.json").write_text((packs / "p" / "pack.json").read_text().replace('"a"', '"b"'))
    with pytest.raises(BadInput, match=r"pack\.json: .*--replace"):
        ingest(source, "p", packs, scale=2.0)
    assert not ingest(source, "p", packs, scale=2.0, replace=True)["cached"], "a manifest that was changed is made anew"


@pytest.mark.parametrize(
    ("name", "spoken", "kind"),
    [
        ("kitchencounter_straight_A", "Kitchen counter straight A", "furniture"),
        ("table_lamp", "Table lamp", "lighting"),
        ("trafficlight_B", "Traffic light B", "sign"),
        ("TrafficLight_2", "Traffic light 2", "sign"),
        ("crate_tomatoes", "Crate tomatoes", "container"),
        ("bookcase", "Bookcase", "furniture"),
        ("building_A_withoutBase", "Building A without base", "building"),
        ("Street_3Way", "Street 3 way", "road"),
        ("xyzzy", "Xyzzy", None),
        ("", "", None),
    ],
)
def test_names_are_read_as_people_read_them(name: str, spoken: str, kind: str | None) -> None:
    assert readable(name) == spoken and kind_of(name) == kind
    if kind:
        assert kind in search_words(name)


def test_colours_are_told_by_area(tmp_path: Path) -> None:
    red = read_source(box(tmp_path / "red.glb", color=(0.6, 0.02, 0.02, 1)), tmp_path).parts
    blue = read_source(box(tmp_path / "blue.glb", (9, 9, 9), (0.02, 0.1, 0.5, 1)), tmp_path).parts
    assert colours_of(red) == ["red"] and colours_of([*red, *blue]) == ["blue"]
    assert np.isfinite(red[0].vertices).all()
