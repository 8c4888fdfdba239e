"""Pictures of a repair's original from its held-out cameras: taken once, and kept by what they depend on.

They lie in ``C4S_HOME/cache/truths/<key>``: level, packs, cameras, engine, and the sources that draw. Only an engine
that never ran agent code fills it; it may be deleted at any time.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from c4s.evidence.clean import open_level
from c4s.evidence.shots import Camera, Taken
from c4s.files import digest, digest_file
from c4s.folders import beside, put_folder
from c4s.home import cache_root
from c4s.records.captures import Captures
from c4s.records.folder import EvidenceFolder
from c4s.records.version import code_version

_DRAW = ("editor", "engine", "evidence", "geometry", "packs", "render")


def truth_views(
    *, engine: str, engine_version: str, packs: Sequence[Path], level: Path, cameras: Sequence[Camera]
) -> list[Taken]:
    """The pictures of a level from cameras that say what they are for; taken where they are not kept.

    Args:
        engine: kind of the engine.
        engine_version: of the engine that took what they are compared with.
        packs: pack folders of the case.
        level: the level document.
        cameras: each with a name of its own.

    Raises:
        SceneUnreadable: the level cannot be loaded or drawn.
        MachineryFault: the engine failed.
    """
    made_of = [engine, engine_version, code_version(*_DRAW), digest_file(level), list(map(dict, cameras))]
    folder = cache_root() / "truths" / digest([made_of, [digest_file(pack / "pack.json") for pack in packs]])
    kept = EvidenceFolder(folder)
    if not kept.captures_index.is_file():
        with open_level(engine=engine, packs=packs, level=level) as clean, beside(folder) as scratch:
            made = scratch / "truth"
            clean.export(made)
            clean.look(made, cameras)
            put_folder(made, folder, marker=EvidenceFolder(folder).captures_index.relative_to(folder).as_posix())
    return [Taken(view, kept.captures) for view in Captures.read(kept.captures_index).views]
