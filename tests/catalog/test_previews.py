"""Previews show the asset, with the holes of its mask, are the same bytes each time, and come from the cache."""

import io
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from c4s.records.pack import Pack
from catalog.build import build_pack
from catalog.ingest.folder import ingest
from catalog.preview import SIZE, contact_sheet
from catalog.shapes import AssetSpec, BlueprintPartSpec, BlueprintSpec, Builder, MaterialSpec, PackSpec
from tests.catalog.gltf_maker import Gltf

SQUARE = [[-0.5, 0, 0], [0.5, 0, 0], [0.5, 1, 0], [-0.5, 1, 0]]


def _post(b: Builder) -> None:
    b.box("Red", (20, 20, 100), (0, 0, 0))


def _slab(b: Builder) -> None:
    b.box("Red", (3000, 3000, 1), (500, 0, 0))


def _spec(color: tuple[float, float, float] = (0.6, 0.02, 0.02)) -> PackSpec:
    return PackSpec(
        pack_id="c4s-test",
        content_folder="C4STest",
        title="Test",
        description="",
        materials=[MaterialSpec("Red", color)],
        assets=[AssetSpec("Post", "props", "A post.", (), _post), AssetSpec("Slab", "props", "A slab.", (), _slab)],
        blueprints=[
            BlueprintSpec(
                "Gate", "props", "Two posts.", (), (BlueprintPartSpec("Post"), BlueprintPartSpec("Post", (200, 0, 0)))
            )
        ],
        category_descriptions={"props": "Things"},
    )


def _red(path: Path) -> np.ndarray:
    with Image.open(path) as picture:
        pixels = np.asarray(picture.convert("RGB")).astype(int)
    assert pixels.shape == (SIZE, SIZE, 3)
    return pixels[..., 0] > 2 * pixels[..., 1]


def test_every_asset_has_a_preview_that_it_fills_whole(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))
    pack, folder = build_pack(_spec(), tmp_path), tmp_path / "c4s-test"
    assert Pack.read(folder / "pack.json") == pack
    assert [asset.preview for asset in pack.assets] == [f"previews/{name}.png" for name in ("post", "slab", "gate_bp")]
    for asset in pack.assets:
        rows, columns = np.nonzero(_red(folder / str(asset.preview)))
        low, high = min(rows.min(), columns.min()), max(rows.max(), columns.max())
        assert 2 <= low < SIZE // 8 and SIZE - SIZE // 8 < high <= SIZE - 3, asset.id
    assert contact_sheet(folder, tmp_path / "sheet.png", []) == 3


def test_the_same_bytes_each_time_and_the_cache_knows_a_new_colour(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn = []
    for number, color in enumerate(((0.6, 0.02, 0.02), (0.6, 0.02, 0.02), (0.02, 0.6, 0.02))):
        monkeypatch.setenv("C4S_HOME", str(tmp_path / ("one" if number == 1 else "other")))
        build_pack(_spec(color), tmp_path / str(number))
        drawn.append((tmp_path / str(number) / "c4s-test/previews/gate_bp.png").read_bytes())
    assert drawn[0] == drawn[1] != drawn[2]
    kept = sorted((tmp_path / "other/cache/previews").iterdir())
    assert len(kept) == 6
    for file in kept:
        file.write_bytes(b"kept")
    build_pack(_spec(), tmp_path / "again")
    assert (tmp_path / "again/c4s-test/previews/post.png").read_bytes() == b"kept"


def _leaves(folder: Path) -> Path:
    """A file of two squares: one whose texture is cut to its left half, one coloured by its vertices."""
    picture = np.zeros((16, 16, 4), np.uint8)
    picture[:, :8] = (220, 10, 10, 255)
    data = io.BytesIO()
    Image.fromarray(picture).save(data, format="PNG")
    folder.mkdir()
    for name in ("leaf", "whole", "painted"):
        made = Gltf()
        made.tree |= {
            "images": [{"bufferView": made.view(data.getvalue()), "mimeType": "image/png"}],
            "textures": [{"source": 0}],
            "materials": [
                {
                    "name": "leaf",
                    "alphaMode": "MASK" if name == "leaf" else "OPAQUE",
                    "pbrMetallicRoughness": {"metallicFactor": 0},
                }
            ],
        }
        attributes = {"POSITION": made.accessor(SQUARE), "TEXCOORD_0": made.accessor([[0, 1], [1, 1], [1, 0], [0, 0]])}
        if name == "painted":
            attributes["COLOR_0"] = made.accessor([[1, 0, 0]] * 4)
        else:
            made.tree["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
        made.mesh({"attributes": attributes, "mode": 6, "material": 0})
        made.write(folder / f"{name}.gltf")
    return folder


def test_foliage_has_holes_and_painted_vertices_their_colour(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))
    ingest(_leaves(tmp_path / "leaves"), "leaves", tmp_path / "packs")
    seen = {}
    for name in ("leaf", "whole", "painted"):
        with Image.open(tmp_path / f"packs/leaves/previews/{name}.png") as picture:
            pixels = np.asarray(picture.convert("RGB")).astype(int)
        seen[name] = (pixels[..., 0] > 2 * pixels[..., 1]).sum(), (pixels.max(axis=2) < 40).sum()
    assert seen["whole"][1] > SIZE * SIZE / 10, "the hidden half of the texture is black"
    assert seen["leaf"][1] < seen["whole"][1] / 4 and seen["leaf"][0] > seen["whole"][0] / 2
    assert seen["painted"][0] > 1.6 * seen["whole"][0]
