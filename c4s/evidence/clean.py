"""A clean engine on a submission: no agent code has run in it, and the submission is mounted read-only.

It may be kept between the two stages of evidence, since nothing that it does changes what it shows: exporting and
looking only read.
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
from c4s.evidence.folder import replace_captures, replace_exported
from c4s.evidence.pictures import take_pictures
from c4s.files import read_json, write_json
from c4s.records.folder import EvidenceFolder

Snapshot = dict[str, Any]
Cameras = Sequence[Mapping[str, Any]] | Callable[[Snapshot], Sequence[Mapping[str, Any]]]
"""Cameras as in ``c4s.editor.capture``, or a function of the snapshot that gives them."""

CAPTURES_VERSION = "c4s.captures.v1"
_EXPORT_TIMEOUT_S = 1800.0


class CleanEngine:
    """An engine with the submitted level open, and what it can say of it."""

    def __init__(self, engine: Engine, package: str, folder: Path) -> None:
        self._engine, self._package, self._folder = engine, package, folder
        self._looks = 0

    def export(self, out: Path) -> Snapshot:
        """Export the level into ``out``, which is replaced as a whole, and return its snapshot.

        Writes snapshot, dependencies and the list of their digests.
        """
        with tempfile.TemporaryDirectory(dir=self._folder) as folder:
            made = EvidenceFolder(Path(folder))
            snapshot = export_snapshot(self._engine, self._package)
            write_json(made.snapshot, snapshot)
            write_json(made.dependencies, _called(self._engine, "dependencies.export_dependencies", self._package))
            replace_exported(made, EvidenceFolder(out))
        return snapshot

    def look(self, out: Path, cameras: Cameras, *, keep_pictures: bool = False) -> None:
        """Take pictures into ``out/captures``, beside the snapshot that was exported; earlier ones are replaced.

        Writes ``<view>.png`` and ``<view>.actors.npz`` for each camera, their index and the list of their digests.
        Pictures that were kept of the same scene are not taken again; ``keep_pictures`` keeps these
        (``c4s.evidence.pictures``). Without a camera the index has no view.

        Raises:
            MachineryFault: another engine exported what is in ``out``.
        """
        snapshot: Snapshot = read_json(EvidenceFolder(out).snapshot, what="snapshot")
        _same_engine(self._engine, snapshot)
        self._looks += 1
        pictures = self._folder / "engine" / f"captures-{self._looks}"
        views = views_of(cameras, snapshot)
        records = take_pictures(self._engine, views, pictures, keep=keep_pictures)
        with tempfile.TemporaryDirectory(dir=self._folder) as folder:
            made = EvidenceFolder(Path(folder))
            if pictures.is_dir():
                shutil.copytree(pictures, made.captures)
            write_json(
                made.captures_index,
                {
                    "schema_version": CAPTURES_VERSION,
                    "engine": self._engine.kind,
                    "engine_version": self._engine.version,
                    "package": self._package,
                    "views": records,
                },
            )
            replace_captures(made, EvidenceFolder(out))


@contextmanager
def open_clean(*, engine: str, packs: Sequence[Path], submission_content: Path, package: str) -> Iterator[CleanEngine]:
    """A clean engine of a kind on the level ``package`` of a submission.

    Raises:
        BadInput: the submission holds what is no plain file, or the level cannot be loaded.
        MachineryFault: the engine failed.
    """
    _check(submission_content)
    with tempfile.TemporaryDirectory(prefix="c4s-evidence-") as name:
        folder = Path(name)
        with open_engine(
            engine,
            packs=packs,
            content=submission_content,
            scratch=folder / "engine",
            start_map=package,
            content_read_only=True,
        ) as session:
            yield CleanEngine(session, package, folder)


def views_of(cameras: Cameras, snapshot: Snapshot) -> Sequence[Mapping[str, Any]]:
    """The cameras for a scene."""
    return cameras(snapshot) if callable(cameras) else cameras


def export_snapshot(engine: Engine, package: str) -> Snapshot:
    """The snapshot of the open level. ``MachineryFault`` when it says that another engine made it."""
    snapshot: Snapshot = _called(engine, "snapshot.export_snapshot", package)
    _same_engine(engine, snapshot)
    return snapshot


def _called(engine: Engine, function: str, package: str) -> Any:
    try:
        return engine.call(function, timeout_s=_EXPORT_TIMEOUT_S)
    except EngineCallError as error:
        raise BadInput(f"the level cannot be exported: {error.what}", where=package) from error


def _same_engine(engine: Engine, snapshot: Snapshot) -> None:
    said = (snapshot["c4s"]["engine"], snapshot["c4s"]["engine_version"])
    if said != (engine.kind, engine.version):
        raise MachineryFault(
            f"the snapshot is of engine {' '.join(said)}, this one is {engine.kind} {engine.version}",
            where=str(snapshot.get("map_path")),
        )


def _check(folder: Path) -> None:
    """Refuse a submission with links, special files, or anything else that cannot be read as it is."""
    if not folder.is_dir():
        raise BadInput("no submission here", where=str(folder))
    fault = content_fault(folder)
    if fault is not None:
        raise BadInput(f"a submission may hold plain files only: {fault}", where=str(folder))
