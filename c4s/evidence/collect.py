"""Evidence: what a clean engine process exports from a saved scene. Verifiers read nothing else.

It comes in two stages: ``export_evidence`` (what integrity reads) and ``look`` (the pictures that the semantic evidence
is judged by). Each opens an engine of its own; ``export_and_look`` does both in one, and so may whoever holds a
``CleanEngine`` (``open_clean``) from one stage to the next.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from c4s.errors import BadInput
from c4s.evidence.clean import open_clean, open_level
from c4s.evidence.shots import Cameras, Snapshot
from c4s.files import write_json


def export_evidence(
    *, engine: str, packs: Sequence[Path], submission_content: Path, package: str, out: Path
) -> Snapshot:
    """Export the submitted level ``package`` from ``submission_content`` into ``out``, and return its snapshot.

    Args:
        engine: kind of the engine.
        packs: pack folders of the case.
        submission_content: the folder that the attempt's engine saved into.
        package: the submitted level.
        out: the evidence folder; replaced as a whole (``CleanEngine.export``).

    Raises:
        BadInput: the level cannot be loaded.
        MachineryFault: the engine failed, or is not what it was called.
    """
    with open_clean(engine=engine, packs=packs, submission_content=submission_content, package=package) as clean:
        return clean.export(out)


def look(
    *,
    engine: str,
    packs: Sequence[Path],
    submission_content: Path,
    package: str,
    out: Path,
    cameras: Cameras,
    offered: Sequence[str] | None = None,
) -> None:
    """Take pictures of the submitted level into ``out/captures``, where ``export_evidence`` has put its snapshot.

    See ``CleanEngine.look``. ``BadInput`` without a camera: no engine is started for nothing.
    """
    if not cameras:
        raise BadInput("no camera to look from", where=str(out))
    with open_clean(
        engine=engine, packs=packs, submission_content=submission_content, package=package, offered=offered
    ) as clean:
        clean.walk(out)
        clean.look(out, cameras)


def export_and_look(
    *, engine: str, packs: Sequence[Path], submission_content: Path, package: str, out: Path, cameras: Cameras = ()
) -> None:
    """Both stages in one engine. Without a camera the index of captures has no view."""
    with open_clean(engine=engine, packs=packs, submission_content=submission_content, package=package) as clean:
        clean.export(out)
        clean.walk(out)
        clean.look(out, cameras)


def export_level(*, engine: str, packs: Sequence[Path], level: Path, out: Path) -> None:
    """Export the snapshot of one level document (a start level or a truth) to the file ``out``."""
    with open_level(engine=engine, packs=packs, level=level) as clean:
        write_json(out, clean.snapshot())
