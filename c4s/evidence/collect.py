"""Evidence: what a clean engine process exports from a saved scene. Verifiers read nothing else.

No agent code runs in these engines, and the submission is mounted read-only.
"""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from c4s.engine.content import content_fault
from c4s.engine.headless.host.session import EngineCallError, EngineSession
from c4s.errors import BadInput
from c4s.evidence.pictures import take_pictures
from c4s.files import write_json
from c4s.records.evidence_digests import EXPORTED, SEEN, note_digests
from c4s.records.folder import EvidenceFolder

Cameras = Sequence[Mapping[str, Any]] | Callable[[dict[str, Any]], Sequence[Mapping[str, Any]]]

CAPTURES_VERSION = "c4s.captures.v1"
_EXPORT_TIMEOUT_S = 1800.0


def collect(
    *,
    packs: Sequence[Path],
    submission_content: Path,
    package: str,
    out: Path,
    cameras: Cameras | None = None,
    keep_pictures: bool = False,
) -> None:
    """Export the submitted level ``package`` from ``submission_content`` into ``out``.

    Writes ``snapshot.json``, ``dependencies.json``, ``captures/<view>.png`` and ``.actors.npz`` for each camera,
    ``captures/captures.json``, and ``digests/`` (SHA-256 of each). ``cameras`` may be a function of the snapshot.
    Pictures that were kept of the same scene are not taken again; ``keep_pictures`` keeps these
    (``c4s.evidence.pictures``).
    What was in ``out`` is replaced as a whole. Raises ``BadInput`` when the level cannot be loaded, ``MachineryFault``
    when an engine fails.
    """
    _check(submission_content)
    with tempfile.TemporaryDirectory(prefix="c4s-evidence-") as folder:
        scratch, made = Path(folder) / "engine", Path(folder) / "evidence"
        made.mkdir()
        with EngineSession.start(
            packs=packs, content=submission_content, scratch=scratch, start_map=package, content_read_only=True
        ) as engine:
            snapshot, dependencies = _export(engine, package)
            write_json(made / "snapshot.json", snapshot)
            write_json(made / "dependencies.json", dependencies)
            if cameras is not None:
                views = cameras(snapshot) if callable(cameras) else cameras
                pictures = scratch / "captures"
                records = take_pictures(engine, views, pictures, keep=keep_pictures)
                pictures.mkdir(exist_ok=True)
                shutil.copytree(pictures, made / "captures")
                write_json(
                    made / "captures" / "captures.json",
                    {"schema_version": CAPTURES_VERSION, "engine": "headless", "package": package, "views": records},
                )
                note_digests(EvidenceFolder(made), SEEN, (made / "captures").iterdir())
        note_digests(EvidenceFolder(made), EXPORTED, [made / "snapshot.json", made / "dependencies.json"])
        _replace(made, out)


def look_at(
    *, packs: Sequence[Path], submission_content: Path, package: str, out: Path, cameras: Sequence[Mapping[str, Any]]
) -> None:
    """Take the pictures of the submitted level into ``<out>/captures``, beside the evidence that is there."""
    _check(submission_content)
    with tempfile.TemporaryDirectory(prefix="c4s-look-") as folder:
        scratch = Path(folder) / "engine"
        with EngineSession.start(
            packs=packs, content=submission_content, scratch=scratch, start_map=package, content_read_only=True
        ) as engine:
            pictures = scratch / "captures"
            records = take_pictures(engine, cameras, pictures)
        pictures.mkdir(exist_ok=True)
        shutil.copytree(pictures, out / "captures", dirs_exist_ok=True)
    write_json(
        out / "captures" / "captures.json",
        {"schema_version": CAPTURES_VERSION, "engine": "headless", "package": package, "views": records},
    )
    note_digests(EvidenceFolder(out), SEEN, (out / "captures").iterdir())


def export_level(*, packs: Sequence[Path], level: Path, out: Path) -> None:
    """Export the snapshot of one level document (a start level or a truth) to the file ``out``.

    The engine sees a copy of the document alone, whatever folder it lies in.
    """
    from c4s.records.level import Level

    package = Level.read(level).package
    with tempfile.TemporaryDirectory(prefix="c4s-export-") as folder:
        copy = Path(folder) / "given.level.json"
        shutil.copyfile(level, copy)
        with EngineSession.start(
            packs=packs,
            content=Path(folder) / "content",
            scratch=Path(folder) / "engine",
            levels=[copy],
            start_map=package,
        ) as engine:
            write_json(out, _export(engine, package)[0])


def _export(engine: EngineSession, package: str) -> tuple[dict[str, Any], dict[str, Any]]:
    try:
        return (
            engine.call("snapshot.export_snapshot", timeout_s=_EXPORT_TIMEOUT_S),
            engine.call("dependencies.export_dependencies", timeout_s=_EXPORT_TIMEOUT_S),
        )
    except EngineCallError as error:
        raise BadInput(f"the level cannot be exported: {error.what}", where=package) from error


def _check(folder: Path) -> None:
    """Refuse a submission with links, special files, or anything else that cannot be read as it is."""
    if not folder.is_dir():
        raise BadInput("no submission here", where=str(folder))
    fault = content_fault(folder)
    if fault is not None:
        raise BadInput(f"a submission may hold plain files only: {fault}", where=str(folder))


def _replace(made: Path, out: Path) -> None:
    """Put the finished folder in place of the old one, so that a reader never sees a part of it."""
    out.parent.mkdir(parents=True, exist_ok=True)
    fresh = Path(tempfile.mkdtemp(prefix=f".{out.name}.", dir=out.parent))
    shutil.copytree(made, fresh, dirs_exist_ok=True)
    fresh.chmod(0o755)
    if out.exists():
        shutil.rmtree(out)
    fresh.rename(out)
