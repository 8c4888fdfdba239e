"""Pack manifests that are wrong: bad input in one line, or a store that answers."""

from __future__ import annotations

import json
import tempfile
from pathlib import Path

from hypothesis import given, settings
from odd import wrong

from c4s.errors import BadInput
from c4s.packs.store import PackStore
from c4s.records.pack import Asset, BlueprintPart, BoxBody, Material, MaterialSlot, Pack

PACK = Pack(
    pack_id="odd",
    content_folder="Odd",
    title="Odd",
    license="CC0-1.0",
    assets=[
        Asset(
            id="box",
            name="Box",
            path="/Game/Odd/SM_box.SM_box",
            category="Boxes",
            description="A box",
            tags=["x"],
            bounds_min_cm=(-5, -5, 0),
            bounds_max_cm=(5, 5, 10),
            mesh="meshes/box.glb",
            mesh_sha256="0" * 64,
            slots=[MaterialSlot(name="S", material="/Game/Odd/M.M")],
            collision=[BoxBody(center=(0, 0, 5), half_extent=(5, 5, 5))],
        ),
        Asset(
            id="two",
            name="Two",
            kind="blueprint",
            path="/Game/Odd/BP_two.BP_two",
            category="Boxes",
            description="Two",
            bounds_min_cm=(-5, -5, 0),
            bounds_max_cm=(5, 5, 20),
            parts=[BlueprintPart(name="Box", asset="/Game/Odd/SM_box.SM_box")],
        ),
    ],
    materials=[Material(path="/Game/Odd/M.M")],
).plain()


@given(wrong(PACK))
@settings(max_examples=150, deadline=None)
def test_a_wrong_manifest_is_bad_input_or_a_store(data: bytes) -> None:
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "pack.json").write_bytes(data)
        try:
            store = PackStore([Path(folder)])
            for asset in store.assets():
                assert store.asset(asset.path) is not None
                store.mesh(asset.path)
        except BadInput as error:
            assert "\n" not in error.line()


def test_the_manifest_that_is_varied_is_sound() -> None:
    assert Pack.parse(json.loads(json.dumps(PACK))).pack_id == "odd"
