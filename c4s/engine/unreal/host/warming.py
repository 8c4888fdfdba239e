"""Filling the cache that all editors of a version read: derived data and shaders of packs."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Sequence
from pathlib import Path

from c4s.engine.bridge import FAILED
from c4s.engine.unreal.host.session import EditorSession, derived_data
from c4s.errors import MachineryFault
from c4s.records.pack import Pack

START_S, LOAD_S = 7200.0, 7200.0
"""The first start of an engine compiles its own shaders, which takes many minutes; so does loading a large pack."""
_LOAD = """
import json, unreal
actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
for path in json.loads({paths!r}):
    asset = unreal.EditorAssetLibrary.load_asset(path)
    if asset is None:
        raise RuntimeError("the editor does not load " + path)
    if not isinstance(asset, unreal.MaterialInterface):
        actors.spawn_actor_from_object(asset, unreal.Vector(0, 0, 0))
finish = getattr(unreal.AutomationLibrary, "finish_loading_before_screenshot", None)
if finish is not None:
    finish()
"""


def warm(kind: str, packs: Sequence[Path]) -> Path:
    """Start an editor that may write the cache, load and show all that the packs hold; the cache's folder."""
    manifests = [Pack.read(pack / "pack.json") for pack in packs]
    paths = [asset.path for manifest in manifests for asset in manifest.assets]
    paths += [material.path for manifest in manifests for material in manifest.materials]
    with tempfile.TemporaryDirectory(prefix="c4s-warm-") as name:
        folder = Path(name)
        with EditorSession.start(
            kind, packs=packs, content=folder / "content", scratch=folder / "scratch", warming=True, start_s=START_S
        ) as session:
            reply = session.execute(_LOAD.format(paths=json.dumps(paths)), LOAD_S)
            if reply["status"] in FAILED:
                raise MachineryFault(f"the packs cannot be loaded: {reply.get('error')}", where=str(session.logs))
            session.call("capture.frame_level")
            session.request("take_screenshot", {"width": 640, "height": 360, "filepath": "warm.png"}, LOAD_S)
        return derived_data(kind)
