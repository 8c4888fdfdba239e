"""A clean engine on a submission: no agent code has run in it, and the submission is mounted read-only.

It may be kept between the two stages of evidence, since nothing that it does changes what it shows: exporting and
looking only read.
"""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Final

from c4s.engine import Engine, EngineCallError, open_engine
from c4s.engine.answers import ask
from c4s.engine.content import content_fault
from c4s.errors import BadInput, MachineryFault, ReasonCode
from c4s.evidence.folder import replace_captures, replace_exported
from c4s.evidence.masks import Tracer, with_masks
from c4s.evidence.pictures import glimpses, take_pictures
from c4s.evidence.shots import Camera, Cameras, Glimpse, Shots, Snapshot
from c4s.files import read_json, write_json
from c4s.records.captures import Captures, View
from c4s.records.evidence_digests import WALKED, note_digests
from c4s.records.folder import EvidenceFolder
from c4s.records.level import Level

OWN_MESH: Final = frozenset({"unreal"})
"""Kinds of engines that make navigation meshes of their own."""
_EXPORT_TIMEOUT_S = 1800.0
_TOLD = ("purpose", "pair")


class SceneUnreadable(BadInput):
    """A clean engine does not load, export or draw a scene. Whether the scene is why is decided elsewhere."""

    def __init__(self, what: str, *, code: ReasonCode, where: str = "", todo: str = "") -> None:
        self.code: ReasonCode = code
        super().__init__(what, where=where, todo=todo)


class CleanEngine:
    """An engine with the submitted level open, and what it can say of it."""

    def __init__(self, engine: Engine, package: str, folder: Path, packs: Sequence[Path]) -> None:
        self._engine, self._package, self._folder, self._packs = engine, package, folder, packs
        self._looks = 0
        self._tracer: Tracer | None = None

    def snapshot(self) -> Snapshot:
        """The snapshot of the level. ``MachineryFault`` when it says that another engine made it."""
        with _refusals("cannot_be_exported", "the level cannot be exported", self._package):
            snapshot: Snapshot = ask(self._engine, "snapshot.export_snapshot", timeout_s=_EXPORT_TIMEOUT_S)
        _same_engine(self._engine, snapshot)
        return snapshot

    def export(self, out: Path) -> Snapshot:
        """Export the level into ``out``, which is replaced as a whole, and return its snapshot.

        Writes snapshot, dependencies and the list of their digests.
        """
        with tempfile.TemporaryDirectory(dir=self._folder) as folder:
            made = EvidenceFolder(Path(folder))
            snapshot = self.snapshot()
            write_json(made.snapshot, snapshot)
            with _refusals("cannot_be_exported", "the level cannot be exported", self._package):
                told = ask(self._engine, "dependencies.export_dependencies", timeout_s=_EXPORT_TIMEOUT_S)
            write_json(made.dependencies, told)
            replace_exported(made, EvidenceFolder(out))
        return snapshot

    def walk(self, out: Path) -> None:
        """Measure how a body can use the level into ``out``, where this engine has a navigation mesh of its own."""
        folder = EvidenceFolder(out)
        if self._engine.kind not in OWN_MESH or folder.digests(WALKED).is_file():
            return
        from c4s.evidence.walk import probe_navigation

        snapshot: Snapshot = read_json(folder.snapshot, what="snapshot")
        _same_engine(self._engine, snapshot)
        with _refusals("cannot_be_exported", "the level cannot be walked", self._package):
            probe_navigation(self._engine, snapshot).write(folder.navigation)
        note_digests(folder, WALKED, [folder.navigation])

    def look(self, out: Path, cameras: Cameras) -> None:
        """Take pictures into ``out/captures``, beside the snapshot that was exported; earlier ones are replaced.

        Writes ``<view>.png`` and ``<view>.actors.npz`` for each camera, their index and the list of their digests. An
        engine that has no masks gets them by ``c4s.evidence.masks``.
        Pictures that are kept of the same scene are not taken again (``c4s.evidence.pictures``). Without a camera the
        index has no view.

        Raises:
            SceneUnreadable: the engine cannot draw it.
            MachineryFault: another engine exported what is in ``out``.
        """
        snapshot: Snapshot = read_json(EvidenceFolder(out).snapshot, what="snapshot")
        _same_engine(self._engine, snapshot)
        self._looks += 1
        pictures = self._folder / "engine" / f"captures-{self._looks}"
        shots = cameras(snapshot, self.probe) if callable(cameras) else Shots(cameras)
        with _refusals("cannot_be_drawn", "the level cannot be drawn", self._package):
            records = take_pictures(self._engine, shots.cameras, pictures)
        if not all("actors" in record for record in records):
            records = with_masks(records, pictures, self._traced(snapshot))
        with tempfile.TemporaryDirectory(dir=self._folder) as folder:
            made = EvidenceFolder(Path(folder))
            if pictures.is_dir():
                shutil.copytree(pictures, made.captures)
            views = [
                View.parse({**record, **{key: camera[key] for key in _TOLD if key in camera}})
                for record, camera in zip(records, shots.cameras, strict=True)
            ]
            for taken in shots.taken:
                for name in filter(None, (taken.view.file, taken.view.actors)):
                    made.captures.mkdir(exist_ok=True)
                    shutil.copyfile(taken.folder / name, made.captures / name)
            Captures(
                engine=self._engine.kind,
                engine_version=self._engine.version,
                package=self._package,
                views=[*views, *(taken.view for taken in shots.taken)],
                claims=dict(shots.claims),
            ).write(made.captures_index)
            replace_captures(made, EvidenceFolder(out))

    def probe(self, cameras: Sequence[Camera]) -> Sequence[Glimpse]:
        """What each camera would see of the level, from its actor mask; nothing is written.

        An engine that has no masks is not asked: its snapshot is traced (``c4s.evidence.masks``).
        """
        if not cameras:
            return []
        with _refusals("cannot_be_drawn", "the level cannot be drawn", self._package):
            told = glimpses(self._engine, cameras)
        return self._traced(None).glimpses(cameras) if told is None else told

    def _traced(self, snapshot: Snapshot | None) -> Tracer:
        """What traces the open level in the engine's place; its snapshot is exported where none is given."""
        if self._tracer is None:
            self._tracer = Tracer(self.snapshot() if snapshot is None else snapshot, self._packs)
        return self._tracer


@contextmanager
def open_clean(
    *, engine: str, packs: Sequence[Path], submission_content: Path, package: str, offered: Sequence[str] | None = None
) -> Iterator[CleanEngine]:
    """A clean engine of a kind on the level ``package`` of a submission.

    ``offered``: the meshes and Blueprints of the packs that are there, as in the agent's engine; null for all.

    Raises:
        SceneUnreadable: the submission holds what is no plain file, or the level cannot be loaded.
        BadInput: there is no submission.
        MachineryFault: the engine failed.
    """
    _check(submission_content)
    with _opened(
        engine, package, packs=packs, content=submission_content, content_read_only=True, offered=offered
    ) as clean:
        yield clean


@contextmanager
def open_level(*, engine: str, packs: Sequence[Path], level: Path) -> Iterator[CleanEngine]:
    """A clean engine of a kind on one level document. It sees a copy of the document, whatever folder that lies in.

    Raises:
        SceneUnreadable: the level cannot be loaded.
        BadInput: this is no level document.
        MachineryFault: the engine failed.
    """
    package = Level.read(level).package
    with tempfile.TemporaryDirectory(prefix="c4s-level-") as name:
        copy = Path(name) / "given.level.json"
        shutil.copyfile(level, copy)
        with _opened(engine, package, packs=packs, content=Path(name) / "content", levels=[copy]) as clean:
            yield clean


@contextmanager
def _opened(
    engine: str,
    package: str,
    *,
    packs: Sequence[Path],
    content: Path,
    levels: Sequence[Path] = (),
    content_read_only: bool = False,
    offered: Sequence[str] | None = None,
) -> Iterator[CleanEngine]:
    with tempfile.TemporaryDirectory(prefix="c4s-evidence-") as name, ExitStack() as running:
        try:
            session = running.enter_context(
                open_engine(
                    engine,
                    packs=packs,
                    content=content,
                    scratch=Path(name) / "engine",
                    levels=levels,
                    start_map=package,
                    content_read_only=content_read_only,
                    offered=offered,
                )
            )
        except BadInput as error:
            raise SceneUnreadable(error.what, code="unloadable", where=error.where, todo=error.todo) from error
        yield CleanEngine(session, package, Path(name), packs)


@contextmanager
def _refusals(code: ReasonCode, what: str, package: str) -> Iterator[None]:
    """Functions of a clean engine that raise in the block did so on what they were given, the scene."""
    try:
        yield
    except EngineCallError as error:
        raise SceneUnreadable(f"{what}: {error.what}", code=code, where=package) from error


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
        raise SceneUnreadable(f"a submission may hold plain files only: {fault}", code="unloadable", where=str(folder))
