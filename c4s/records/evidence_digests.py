"""The digests of evidence files: one list a stage that made some of them, so that no two stages write the same file."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Final, Literal

from c4s.files import digest_file, write_json
from c4s.records.folder import EvidenceFolder

Maker = Literal["export", "look", "measure", "walk"]
EXPORTED: Final = "export"
SEEN: Final = "look"
MEASURED: Final = "measure"
WALKED: Final = "walk"


def note_digests(folder: EvidenceFolder, maker: Maker, files: Iterable[Path]) -> None:
    """Note the SHA-256 of the files that a stage made, by their names relative to the evidence folder."""
    listed = {path.relative_to(folder.root).as_posix(): digest_file(path) for path in sorted(files)}
    write_json(folder.digests(maker), listed)
