"""Evidence: what a clean engine process exports from a saved scene. Verifiers read nothing else.

It comes in two stages, each by an engine of its own: ``export_evidence`` (what integrity reads) and ``look`` (the
pictures that the semantic evidence is judged by). ``export_and_look`` does both in one engine. No agent code runs in
these engines, the submission is mounted read-only, and every file says which engine made it.
"""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from c4s.engine import Engine, EngineCallError, open_engine
from c4s.engine.content import content_fault
from c4s.errors import BadInput, MachineryFault
from c4s.evidence.folder import CAPTURES, replace_captures, replace_folder, write_digests
from c4s.evidence.pictures import take_pictures
from c4s.files import read_json, write_json
from c4s.records.level import Level

Snapshot = dict[str, Any]
Cameras = Sequence[Mapping[str, Any]] | Callable[[Snapshot], Sequence[Mapping[str, Any]]]
"""Cameras as in ``c4s.editor.capture``, or a function of the snapshot that gives them."""

CAPTURES_VERSION = "c4s.captures.v1"
_EXPORT_TIMEOUT_S = 1800.0


def export_evidence(
    *, engine: str, packs: Sequence[Path], submission_content: Path, package: str, out: Path
) -> Snapshot:
    """Export the submitted level ``package`` from ``submission_content`` into ``out``, and return its snapshot.

    Writes ``snapshot.json``, ``dependencies.json`` and ``digests.json`` (SHA-256 of each). What was in ``out`` is
    replaced as a whole.

    Args:
        engine: kind of the engine.
        packs: pack folders of the case.
        submission_content: the folder that the attempt's engine saved into.
        package: the submitted level.
        out: the evidence folder.

    Raises:
        BadInput: the level cannot be loaded.
        MachineryFault: the engine failed, or is not what it was called.
    """
    with _opened(engine, packs, submission_content, package) as (session, _, made):
        snapshot = _export(session, package, made)
        write_digests(made)
        replace_folder(made, out)
    return snapshot


def look(
    *,
    engine: str,
    packs: Sequence[Path],
    submission_content: Path,
    package: str,
    out: Path,
    cameras: Cameras,
    keep_pictures: bool = False,
) -> None:
    """Take pictures of the submitted level into ``out/captures``, where ``export_evidence`` has put its snapshot.

    Writes ``<view>.png`` and ``<view>.actors.npz`` for each camera and ``captures.json``, and brings ``digests.json``
    up to date. Earlier captures are replaced. Pictures that were kept of the same scene are not taken again;
    ``keep_pictures`` keeps these (``c4s.evidence.pictures``). ``BadInput`` without a camera.
    """
    snapshot: Snapshot = read_json(out / "snapshot.json", what="snapshot")
    views = cameras(snapshot) if callable(cameras) else cameras
    if not views:
        raise BadInput("no camera to look from", where=str(out))
    with _opened(engine, packs, submission_content, package) as (session, scratch, made):
        _same_engine(session, snapshot)
        _capture(session, views, scratch, made, package, keep_pictures)
        replace_captures(made / CAPTURES, out)


def export_and_look(
    *,
    engine: str,
    packs: Sequence[Path],
    submission_content: Path,
    package: str,
    out: Path,
    cameras: Cameras = (),
    keep_pictures: bool = False,
) -> None:
    """Both stages in one engine. Without a camera ``captures.json`` has no view."""
    with _opened(engine, packs, submission_content, package) as (session, scratch, made):
        snapshot = _export(session, package, made)
        views = cameras(snapshot) if callable(cameras) else cameras
        _capture(session, views, scratch, made, package, keep_pictures)
        write_digests(made)
        replace_folder(made, out)


def export_level(*, engine: str, packs: Sequence[Path], level: Path, out: Path) -> None:
    """Export the snapshot of one level document (a start level or a truth) to the file ``out``.

    The engine sees a copy of the document alone, whatever folder it lies in.
    """
    package = Level.read(level).package
    with tempfile.TemporaryDirectory(prefix="c4s-export-") as folder:
        copy = Path(folder) / "given.level.json"
        shutil.copyfile(level, copy)
        with open_engine(
            engine,
            packs=packs,
            content=Path(folder) / "content",
            scratch=Path(folder) / "engine",
            levels=[copy],
            start_map=package,
        ) as session:
            write_json(out, _snapshot(session, package))


@contextmanager
def _opened(kind: str, packs: Sequence[Path], content: Path, package: str) -> Iterator[tuple[Engine, Path, Path]]:
    """A clean engine on the submission, its scratch folder, and a folder for what it makes."""
    _check(content)
    with tempfile.TemporaryDirectory(prefix="c4s-evidence-") as folder:
        scratch, made = Path(folder) / "engine", Path(folder) / "evidence"
        made.mkdir()
        with open_engine(
            kind, packs=packs, content=content, scratch=scratch, start_map=package, content_read_only=True
        ) as session:
            yield session, scratch, made


def _export(engine: Engine, package: str, made: Path) -> Snapshot:
    snapshot = _snapshot(engine, package)
    write_json(made / "snapshot.json", snapshot)
    write_json(made / "dependencies.json", _called(engine, "dependencies.export_dependencies", package))
    return snapshot


def _snapshot(engine: Engine, package: str) -> Snapshot:
    snapshot: Snapshot = _called(engine, "snapshot.export_snapshot", package)
    _same_engine(engine, snapshot)
    return snapshot


def _called(engine: Engine, function: str, package: str) -> Any:
    try:
        return engine.call(function, timeout_s=_EXPORT_TIMEOUT_S)
    except EngineCallError as error:
        raise BadInput(f"the level cannot be exported: {error.what}", where=package) from error


def _same_engine(engine: Engine, snapshot: Snapshot) -> None:
    """Refuse a snapshot that says that another engine made it."""
    said = (snapshot["c4s"]["engine"], snapshot["export_metadata"]["engine_version"])
    if said != (engine.kind, engine.version):
        raise MachineryFault(
            f"the snapshot is of engine {' '.join(said)}, this one is {engine.kind} {engine.version}",
            where=str(snapshot.get("map_path")),
        )


def _capture(
    engine: Engine, views: Sequence[Mapping[str, Any]], scratch: Path, made: Path, package: str, keep: bool
) -> None:
    pictures = scratch / CAPTURES
    records = take_pictures(engine, views, pictures, keep=keep)
    pictures.mkdir(exist_ok=True)
    shutil.copytree(pictures, made / CAPTURES)
    write_json(
        made / CAPTURES / "captures.json",
        {
            "schema_version": CAPTURES_VERSION,
            "engine": engine.kind,
            "engine_version": engine.version,
            "package": package,
            "views": records,
        },
    )


def _check(folder: Path) -> None:
    """Refuse a submission with links, special files, or anything else that cannot be read as it is."""
    if not folder.is_dir():
        raise BadInput("no submission here", where=str(folder))
    fault = content_fault(folder)
    if fault is not None:
        raise BadInput(f"a submission may hold plain files only: {fault}", where=str(folder))
