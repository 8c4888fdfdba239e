"""Reading an evidence bundle: nothing is believed before its digest is checked."""

from __future__ import annotations

import gzip
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from c4s.bounds import BOUNDS
from c4s.bundle.manifest import MANIFEST, Manifest
from c4s.errors import BadInput
from c4s.files import digest_file, no_place, open_plain, parse_bounded, read_plain
from c4s.names import file_in


@dataclass(frozen=True, slots=True)
class EvidenceBundle:
    """A bundle whose manifest and digests are in order."""

    root: Path
    manifest: Manifest

    def json(self, path: str) -> Any:
        """A JSON file of the bundle, gzip or not. Raises ``BadInput``."""
        where = str(self.root / path)
        try:
            if path.endswith(".gz"):
                with open_plain(self.root / path) as file, gzip.open(file) as packed:
                    data = packed.read(BOUNDS["unpacked_bytes"].most + 1)
                BOUNDS["unpacked_bytes"].hold(len(data), where=where)
            else:
                data = read_plain(self.root / path, bound=BOUNDS["unpacked_bytes"])
            return parse_bounded(data, BOUNDS["unpacked_bytes"], BOUNDS["unpacked_values"])
        except (ValueError, EOFError, OSError, zlib.error) as error:
            told = no_place(error) if isinstance(error, OSError) else str(error)
            raise BadInput(f"cannot read this file of the bundle: {told}", where=where) from None


def read_bundle(root: Path) -> EvidenceBundle:
    """Open a bundle folder and check its manifest, paths and digests. Raises ``BadInput`` with one line."""
    manifest = Manifest.read(root / MANIFEST)
    where = str(root / MANIFEST)
    lacking = manifest.lacks()
    if lacking:
        raise BadInput(f"a bundle of {manifest.task.setting} needs {', '.join(lacking)}", where=where)
    unlisted = sorted(manifest.referenced() - set(manifest.files))
    if unlisted:
        raise BadInput(f"{unlisted[0]!r} has no digest under 'files'", where=where)
    for path, expected in manifest.files.items():
        if not file_in(root, path).is_file():
            raise BadInput("a file of the bundle is missing", where=str(root / path), todo="copy the whole folder")
        if digest_file(root / path) != expected:
            raise BadInput(
                "a file of the bundle is not the one that was packed: its digest differs", where=str(root / path)
            )
    bundle = EvidenceBundle(root, manifest)
    for path in _replayed_frames(bundle):
        if path not in manifest.files:
            raise BadInput(f"{path!r} of the stage 3 plan has no digest under 'files'", where=where)
    return bundle


def _replayed_frames(bundle: EvidenceBundle) -> list[str]:
    """Pictures that a recorded request schedule would send to a judge again."""
    plan_path = bundle.manifest.semantic.stage3_plan if bundle.manifest.semantic else None
    plan = bundle.json(plan_path) if plan_path else None
    frames = plan.get("frames") if isinstance(plan, Mapping) else None
    if frames is not None and not (
        isinstance(frames, Mapping)
        and all(isinstance(frame, Mapping) and isinstance(frame.get("path"), str) for frame in frames.values())
    ):
        raise BadInput("the frames of the stage 3 plan have no paths", where=str(bundle.root / str(plan_path)))
    return [frame["path"] for frame in (frames or {}).values()]
