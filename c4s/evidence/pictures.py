"""Pictures of the level that a clean engine has open, each taken once.

Pictures of a suite's own scenes are kept in ``C4S_HOME/cache/pictures`` under their keys (``capture.plan_views``):
the PNG, the actor mask, and the counts of visible pixels. A submission that looks the same from the same camera takes
them from there. Only engines that never ran agent code fill the cache; it may be deleted at any time.
"""

from __future__ import annotations

import shutil
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from c4s.engine import Engine
from c4s.engine.answers import ask
from c4s.files import read_json, write_bytes, write_json
from c4s.home import cache_root

Record = dict[str, Any]
TIMEOUT_S = 1800.0


def take_pictures(
    engine: Engine, cameras: Sequence[Mapping[str, Any]], folder: Path, *, keep: bool = False
) -> list[Record]:
    """Write ``folder/<name>.png`` and ``<name>.actors.npz`` of each camera; the records of ``capture.capture_views``.

    Args:
        engine: an engine in which no agent code has run; ``folder`` must lie in its scratch folder.
        cameras: ``{"name", "location_cm", ...}`` as in ``c4s.editor.capture``, each with a name of its own.
        folder: where to.
        keep: keep what is rendered for later pictures of the same scene.
    """
    if not cameras:
        return []
    given = plain(cameras)
    planned: list[Record] = ask(engine, "capture.plan_views", cameras=given)
    keys: list[str | None] = [record.pop("key", None) for record in planned]
    missing = [camera for camera, key in zip(given, keys, strict=True) if key is None or not _is_kept(key)]
    made = (
        ask(engine, "capture.capture_views", cameras=missing, folder=str(folder), timeout_s=TIMEOUT_S)
        if missing
        else []
    )
    rendered: dict[str, Record] = {record["name"]: record for record in made}
    folder.mkdir(parents=True, exist_ok=True)
    records = []
    for record, key in zip(planned, keys, strict=True):
        new = rendered.get(record["name"])
        if new is None and key is not None:
            picture, mask, counts = _files(key)
            shutil.copyfile(picture, folder / record["file"])
            shutil.copyfile(mask, folder / record["actors"])
            shown = {"visible": read_json(counts), "actors": record.pop("actors")}
            records.append({**record, **shown})
        elif new is not None:
            records.append(new)
            if keep and key is not None:
                _keep(key, new, folder)
    return records


def glimpses(engine: Engine, cameras: Sequence[Mapping[str, Any]]) -> list[Record] | None:
    """What each camera would see of the level that an engine has open; None of an engine that has no masks."""
    told: list[Record] | None = ask(engine, "capture.probe_views", cameras=plain(cameras), timeout_s=TIMEOUT_S)
    return told


def plain(cameras: Sequence[Mapping[str, Any]]) -> list[Record]:
    """Cameras as an engine is told of them, without what they are for."""
    return [{key: value for key, value in camera.items() if key not in ("purpose", "pair")} for camera in cameras]


def _files(key: str) -> tuple[Path, Path, Path]:
    """Picture, mask and counts of a key; the counts are written last."""
    stem = cache_root() / "pictures" / key
    return stem.with_suffix(".png"), stem.with_suffix(".npz"), stem.with_suffix(".json")


def _is_kept(key: str) -> bool:
    return all(file.is_file() for file in _files(key))


def _keep(key: str, record: Record, folder: Path) -> None:
    picture, mask, counts = _files(key)
    write_bytes(picture, (folder / record["file"]).read_bytes())
    write_bytes(mask, (folder / record["actors"]).read_bytes())
    write_json(counts, record["visible"], indent=None)
