"""Stand-ins for palettes whose content is not here: right sizes, right paths, and a picture of each."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from c4s.packs.store import PackStore
from catalog.proxy import PaletteEntry, build_proxy_pack

ENTRIES = [
    PaletteEntry("oak_tree", "Oak tree", "Trees", (4.0, 4.5, 9.0), "/Game/Town/SM_Oak.SM_Oak"),
    PaletteEntry("bp_lamp", "Street lamp", "Lights", (0.4, 0.4, 5.0), "/Game/Town/BP_Lamp.BP_Lamp_C"),
    PaletteEntry("decal", "Wall poster", "Decals", (1.0, 0.0, 1.5), "/Game/Town/SM_Poster.SM_Poster"),
]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))
    build_proxy_pack("proxy-town", "Town", ENTRIES, tmp_path, lambda told: None)
    return tmp_path / "proxy-town"


def test_every_stand_in_has_its_size_and_a_picture_of_itself(folder: Path) -> None:
    store = PackStore([folder])
    assets = {asset.id: asset for asset in store.packs[folder].assets}
    for entry in ENTRIES:
        asset = assets[entry.id]
        assert asset.size_m == pytest.approx(entry.size_m, abs=1e-4)
        assert asset.preview is not None
        picture = np.asarray(Image.open(folder / asset.preview).convert("RGB"), dtype=int)
        corners = picture[[0, 0, -1, -1], [0, -1, 0, -1]]
        middle = picture[120:200, 120:200].reshape(-1, 3)
        assert np.abs(middle - corners.mean(axis=0)).max() > 20, f"nothing to see of {entry.id}"
    assert assets["bp_lamp"].kind == "blueprint" and assets["bp_lamp"].path == "/Game/Town/BP_Lamp.BP_Lamp"


def test_the_same_palette_gives_the_same_pack(folder: Path, tmp_path: Path) -> None:
    again = build_proxy_pack("proxy-town", "Town", ENTRIES, tmp_path / "again", lambda told: None)
    first = PackStore([folder]).packs[folder]
    assert again.sha256() == first.sha256()
    assert [(tmp_path / "again" / "proxy-town" / str(asset.preview)).read_bytes() for asset in again.assets] == [
        (folder / str(asset.preview)).read_bytes() for asset in first.assets
    ]
