"""Mesh files of a few hundred bytes that ask for gigabytes or hours, and files that are broken anywhere."""

from __future__ import annotations

import gzip
import json
import re
import struct
import zlib
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from limited import cost
from odd import wrong

from c4s.errors import BadInput
from c4s.packs.meshes import read_parts
from c4s.packs.pictures import open_picture
from catalog.ingest.folder import ingest
from catalog.ingest.source import read_source

TRIANGLE = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)


def glb(tree: dict[str, Any] | bytes, binary: bytes = TRIANGLE) -> bytes:
    """A GLB file of a tree and its data."""
    text = tree if isinstance(tree, bytes) else json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(binary), 0x004E4942) + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def plain(**changes: Any) -> dict[str, Any]:
    """One triangle."""
    return {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "thing", "translation": [0, 1, 0]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "byteOffset": 0}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36}],
    } | changes


def doubled(levels: int) -> list[dict[str, Any]]:
    """Nodes each of which has the next one twice."""
    return [{"children": [n + 1, n + 1]} for n in range(levels)] + [{"mesh": 0}]


EMPTY = {"componentType": 5126, "count": 50_000_000, "type": "MAT4"}
DRACO = "KHR_draco_mesh_compression"
PACKED = b"DRACO" + bytes([2, 2, 1, 0, 0, 0]) + b"\xff\xff\xff\x7f" * 2 + bytes(64)
BOMBS: dict[str, tuple[bytes, str]] = {
    "accessor without data": (glb(plain(accessors=[EMPTY])), "800,000,000 numbers, more than 1,000,000"),
    "many of them": (glb(plain(accessors=[EMPTY | {"count": 62_500}] * 100)), "more than 60,000,000 numbers"),
    "nodes twice below": (glb(plain(nodes=doubled(40))), "placed nodes, more than 50,000"),
    "a circle of nodes": (glb(plain(nodes=[{"children": [1]}, {"children": [0]}])), "below itself"),
    "one mesh very often": (
        glb(plain(scenes=[{"nodes": list(range(60_000))}], nodes=[{"mesh": 0}] * 60_000)),
        "placed nodes, more than 50,000",
    ),
    "a number of digits": (glb(b'{"asset": ' + b"9" * 5_000_000 + b"}"), "too many digits"),
    "lists in lists": (glb(b"[" * 3_000_000), "cannot read this mesh"),
    "data past its end": (glb(plain(accessors=[plain()["accessors"][0] | {"count": 1_000_000}])), "past the end"),
    "compressed faces": (
        glb(
            plain(
                meshes=[
                    {
                        "primitives": [
                            {
                                "attributes": {"POSITION": 0},
                                "extensions": {DRACO: {"bufferView": 0, "attributes": {"POSITION": 0}}},
                            }
                        ]
                    }
                ],
                bufferViews=[{"buffer": 0, "byteLength": len(PACKED)}],
                buffers=[{"byteLength": len(PACKED)}],
                extensionsRequired=[DRACO],
            ),
            PACKED,
        ),
        "vertices, more than 10,000,000",
    ),
}
ONLY_HERE = {"data past its end", "compressed faces"}
"""What a reader of packs has its own words for."""


@pytest.fixture(scope="module")
def bombs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("bombs")
    for name, (data, _) in BOMBS.items():
        (folder / f"{name}.glb").write_bytes(data)
    return folder


def test_small_files_that_ask_for_much_cost_little(bombs: Path) -> None:
    script = f"""
from pathlib import Path
from catalog.ingest.source import read_source
from c4s.packs.meshes import read_parts
from c4s.packs.pictures import open_picture
def work():
    said = {{}}
    for path in sorted(Path({str(bombs)!r}).glob("*.glb")):
        for read in (lambda path: read_source(path, path.parent), read_parts):
            try:
                read(path)
                said.setdefault(path.stem, []).append("read")
            except BadInput as error:
                said.setdefault(path.stem, []).append(error.line())
    return json.dumps(said)
told(work)
"""
    found = cost(script, memory_mib=3072, cpu_s=30)
    assert found.memory_mib < 700
    said = json.loads(found.answer)
    for name, (_, answer) in BOMBS.items():
        ingested, of_pack = said[name]
        assert re.search(answer, ingested), (name, ingested)
        assert re.search(answer, of_pack) or name in ONLY_HERE, (name, of_pack)


def test_a_bad_file_is_skipped_and_the_folder_goes_on(bombs: Path, tmp_path: Path) -> None:
    (bombs / "sound.glb").write_bytes(glb(plain()))
    report = ingest(bombs, "mixed", tmp_path, hulls="asset")
    assert report["assets"] == 1 and len(report["skipped"]) == len(BOMBS)
    assert all("\n" not in row["reason"] for row in report["skipped"])


@given(wrong(plain()))
@settings(max_examples=60, deadline=None)
def test_a_broken_file_is_bad_input_or_a_mesh(tmp_path_factory: pytest.TempPathFactory, text: bytes) -> None:
    path = tmp_path_factory.mktemp("broken") / "thing.glb"
    path.write_bytes(glb(text))
    for read in (lambda: read_source(path, path.parent), lambda: read_parts(path)):
        try:
            assert read()
        except BadInput as error:
            assert "\n" not in error.line() and len(error.line()) < 20_000


@given(st.binary(max_size=200), st.integers(0, 400))
@settings(max_examples=40, deadline=None)
def test_bytes_in_the_wrong_place_are_bad_input_or_a_mesh(
    tmp_path_factory: pytest.TempPathFactory, noise: bytes, place: int
) -> None:
    path = tmp_path_factory.mktemp("noise") / "thing.glb"
    whole = glb(plain())
    path.write_bytes(whole[:place] + noise + whole[place + len(noise) :])
    for read in (lambda: read_source(path, path.parent), lambda: read_parts(path)):
        try:
            assert read()
        except BadInput as error:
            assert "\n" not in error.line()


def test_a_bundle_that_unpacks_to_gigabytes_is_refused(tmp_path: Path) -> None:
    with gzip.open(tmp_path / "rows.json.gz", "wb", compresslevel=1) as packed:
        for _ in range(130):
            packed.write(b" " * (1 << 20))
    script = f"""
from pathlib import Path
from c4s.bundle.reading import EvidenceBundle
from c4s.cli.batches import read_rows
from dataclasses import replace
from c4s.bounds import BOUNDS
BOUNDS["unpacked_bytes"] = replace(BOUNDS["unpacked_bytes"], most=100 << 20)
folder = Path({str(tmp_path)!r})
def work():
    bundle = EvidenceBundle(folder, None)
    for read in (lambda: bundle.json("rows.json.gz"), lambda: list(read_rows(folder / "rows.json.gz"))):
        try:
            read()
            return "read"
        except BadInput as error:
            said = error.line()
            assert "more than" in said, said
    return said
told(work)
"""
    found = cost(script, memory_mib=2048, cpu_s=30)
    assert "more than 128 MiB" in found.answer and found.memory_mib < 800


def _png_chunk(name: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def test_a_picture_of_gigabytes_is_refused_by_its_head(tmp_path: Path) -> None:
    for side in (9_000, 60_000):
        size = struct.pack(">II5B", side, side, 8, 2, 0, 0, 0)
        path = tmp_path / f"{side}.png"
        path.write_bytes(b"\x89PNG\r\n\x1a\n" + _png_chunk(b"IHDR", size) + _png_chunk(b"IDAT", b""))
        with pytest.raises(BadInput, match=r"a picture has .*more than 67,108,864 pixels"):
            open_picture(path, where=str(path))
