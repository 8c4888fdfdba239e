"""Pictures of the level that a clean engine has open, each taken once.

They are kept under their keys (``capture.plan_views``, ``c4s.evidence.kept``): a submission that looks the same from
the same camera takes them from there. Only engines that never ran agent code take what is kept.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from c4s.engine import Engine
from c4s.engine.answers import ask
from c4s.evidence.kept import KeptPicture, drop_oldest, keep_picture, kept_picture

Record = dict[str, Any]
TIMEOUT_S = 1800.0


def take_pictures(engine: Engine, cameras: Sequence[Mapping[str, Any]], folder: Path) -> list[Record]:
    """Write ``folder/<name>.png`` and ``<name>.actors.npz`` of each camera; the records of ``capture.capture_views``.

    Args:
        engine: an engine in which no agent code has run; ``folder`` must lie in its scratch folder.
        cameras: ``{"name", "location_cm", ...}`` as in ``c4s.editor.capture``, each with a name of its own.
        folder: where to.
    """
    if not cameras:
        return []
    given = plain(cameras)
    planned: list[Record] = ask(engine, "capture.plan_views", cameras=given)
    keys: list[str | None] = [record.pop("key", None) for record in planned]
    kept = [None if key is None else kept_picture(key) for key in keys]
    missing = [camera for camera, found in zip(given, kept, strict=True) if found is None]
    made = (
        ask(engine, "capture.capture_views", cameras=missing, folder=str(folder), timeout_s=TIMEOUT_S)
        if missing
        else []
    )
    rendered: dict[str, Record] = {record["name"]: record for record in made}
    folder.mkdir(parents=True, exist_ok=True)
    records = []
    for record, key, found in zip(planned, keys, kept, strict=True):
        new = rendered.get(record["name"])
        if found is not None:
            (folder / record["file"]).write_bytes(found.picture)
            (folder / record["actors"]).write_bytes(found.mask)
            shown = {"visible": found.visible, "actors": record.pop("actors")}
            records.append({**record, **shown})
        elif new is not None:
            records.append(new)
            if key is not None:
                picture, mask = (folder / new[file] for file in ("file", "actors"))
                keep_picture(key, KeptPicture(picture.read_bytes(), mask.read_bytes(), new["visible"]))
    if missing:
        drop_oldest()
    return records


def glimpses(engine: Engine, cameras: Sequence[Mapping[str, Any]]) -> list[Record] | None:
    """What each camera would see of the level that an engine has open; None of an engine that has no masks."""
    told: list[Record] | None = ask(engine, "capture.probe_views", cameras=plain(cameras), timeout_s=TIMEOUT_S)
    return told


def plain(cameras: Sequence[Mapping[str, Any]]) -> list[Record]:
    """Cameras as an engine is told of them, without what they are for."""
    return [{key: value for key, value in camera.items() if key not in ("purpose", "pair")} for camera in cameras]
