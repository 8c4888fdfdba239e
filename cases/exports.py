"""What the engine exports for a suite: snapshots of original and corrupted levels, and reference pictures.

All of it comes from clean engine processes, by the very code that exports a submission's evidence.
"""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from string import Template
from typing import Any

from c4s.engine import DEFAULT_ENGINE, Engine, open_engine
from c4s.engine.answers import ask
from c4s.engine.bridge import FAILED
from c4s.errors import MachineryFault
from c4s.evidence import Shots, export_and_look, glimpses, take_pictures
from c4s.evidence.shots import Glimpse, Probe, Snapshot
from c4s.files import write_json
from c4s.protocol.rules import OVERVIEW_VIEWS
from c4s.records.folder import EvidenceFolder
from c4s.records.level import Level
from c4s.semantics.inventory import inventory
from c4s.semantics.sight import Target, overview_plan, target_cameras
from c4s.semantics.sight.overviews import SIZE_PX
from cases.model import CaseView
from cases.views import camera

_OPEN = Template("""import unreal
if not unreal.get_editor_subsystem(unreal.LevelEditorSubsystem).load_level("$package"):
    raise RuntimeError("the level does not load")
""")


@dataclass(frozen=True)
class Exported:
    """Files of a scene: the original's snapshot, each case's input snapshot, and each case's pictures in order."""

    truth: Path
    inputs: dict[str, Path]
    views: dict[str, list[Path]]
    start_views: dict[str, list[Path]]
    """The corrupted level from the same cameras."""
    overview: list[Path]
    """The original from the four overview cameras of the evaluator."""
    targets: dict[str, list[dict[str, Any]]]
    """The held-out cameras of each repair."""


def scene(
    packs: Sequence[Path],
    truth: Level,
    corrupted: Mapping[str, Level],
    views: Mapping[str, Sequence[CaseView]],
    changed: Mapping[str, Sequence[Target]],
    out: Path,
    progress: Callable[[str], None],
) -> Exported:
    """Export a scene into ``out``: one engine for the original and its pictures, one for all other levels.

    ``changed``: what each corrupted level changes; held-out cameras are planned to see it in the original.
    """
    content = out / "content"
    truth.write(content / f"{truth.package.lstrip('/')}.level.json")
    cameras = [
        {**camera(view), "name": f"{case_id}--{view.name}"} for case_id, wanted in views.items() for view in wanted
    ]
    progress(f"  {truth.package}: snapshot and {len(cameras)} pictures of the original")
    targets: dict[str, list[dict[str, Any]]] = {}

    def plan(snapshot: Snapshot, probe: Probe) -> Shots:
        things = inventory(snapshot, {})
        for case_id, wanted in views.items():
            known = [camera(view) for view in wanted]
            targets[case_id] = target_cameras(things, changed[case_id], known, probe)
        return Shots([*cameras, *overview_plan(snapshot, probe).cameras])

    export_and_look(
        engine=DEFAULT_ENGINE,
        packs=packs,
        submission_content=content,
        package=truth.package,
        out=out / "truth",
        cameras=plan,
    )
    inputs, starts = _inputs(packs, corrupted, views, out / "inputs", progress) if corrupted else ({}, {})
    captures = EvidenceFolder(out / "truth").captures
    pictures = {
        case_id: [captures / f"{case_id}--{view.name}.png" for view in wanted] for case_id, wanted in views.items()
    }
    return Exported(
        EvidenceFolder(out / "truth").snapshot,
        inputs,
        pictures,
        starts,
        [captures / f"overview-{number}.png" for number in range(1, OVERVIEW_VIEWS + 1)],
        targets,
    )


class Bench:
    """A clean engine that opens one level after the other; none holds anything of another."""

    def __init__(self, engine: Engine, out: Path) -> None:
        self._engine, self._out, self._taken = engine, out, 0

    def snapshot(self, level: Level) -> dict[str, Any]:
        """Open a level, and export its snapshot."""
        level.write(self._out / "content" / f"{level.package.lstrip('/')}.level.json")
        _open(self._engine, level, level.package)
        told: dict[str, Any] = ask(self._engine, "snapshot.export_snapshot")
        return told

    def probe(self, cameras: Sequence[Mapping[str, Any]]) -> Sequence[Glimpse]:
        """What cameras would see of the level that is open."""
        told = glimpses(self._engine, cameras)
        assert told is not None
        return told

    def pictures(self, cameras: Sequence[Mapping[str, Any]]) -> list[Path]:
        """Pictures of the level that is open, with their masks beside them, in the order of the cameras."""
        self._taken += 1
        folder = self._out / "engine" / f"views-{self._taken}"
        records = take_pictures(self._engine, cameras, folder)
        return [folder / record["file"] for record in records]


@contextmanager
def bench(packs: Sequence[Path]) -> Iterator[Bench]:
    """Open a bench; what it takes is there until it is closed."""
    with tempfile.TemporaryDirectory(prefix="c4s-bench-") as scratch:
        out = Path(scratch)
        with open_engine(DEFAULT_ENGINE, packs=packs, content=out / "content", scratch=out / "engine") as engine:
            yield Bench(engine, out)


def snapshots(packs: Sequence[Path], levels: Mapping[str, Level]) -> Generator[tuple[str, dict[str, Any]]]:
    """Snapshots of levels by name, each when it is asked for, of one clean engine."""
    with bench(packs) as opened:
        for name, level in levels.items():
            yield name, opened.snapshot(level)


def _open(engine: Engine, level: Level, name: str) -> None:
    reply = engine.execute(_OPEN.substitute(package=level.package))
    if reply["status"] in FAILED:
        raise MachineryFault(f"the engine cannot open the level: {reply.get('error')}", where=name)


def _inputs(
    packs: Sequence[Path],
    levels: Mapping[str, Level],
    views: Mapping[str, Sequence[CaseView]],
    out: Path,
    progress: Callable[[str], None],
) -> tuple[dict[str, Path], dict[str, list[Path]]]:
    """Snapshot and pictures of each corrupted level; opened one after the other, none holds anything of another."""
    for case_id, level in levels.items():
        level.write(out / "levels" / f"{case_id}.level.json")
    files = {case_id: out / f"{case_id}.scene.json" for case_id in levels}
    pictures: dict[str, list[Path]] = {}
    with open_engine(
        DEFAULT_ENGINE,
        packs=packs,
        content=out / "content",
        scratch=out / "engine",
        levels=[out / "levels" / f"{case_id}.level.json" for case_id in levels],
    ) as engine:
        for case_id, level in levels.items():
            progress(f"  {case_id}: snapshot and pictures of the corrupted level")
            _open(engine, level, case_id)
            write_json(files[case_id], ask(engine, "snapshot.export_snapshot"))
            folder = out / "engine" / f"views-{case_id}"
            take_pictures(engine, [reduced(view) for view in views[case_id]], folder)
            pictures[case_id] = [out / "pictures" / case_id / f"{view.name}.png" for view in views[case_id]]
            shutil.copytree(folder, out / "pictures" / case_id)
    return files, pictures


def reduced(view: CaseView) -> dict[str, Any]:
    """The camera of a view with a picture of its shape that is as wide as an overview's."""
    width = min(view.width, SIZE_PX[0])
    return {**camera(view), "width": width, "height": round(width * view.height / view.width)}
