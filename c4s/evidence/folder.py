"""The evidence folder on disk: replaced as a whole or by its captures, each with the list of its digests."""

from __future__ import annotations

import shutil
import tempfile
from pathlib import Path

from c4s.files import write_bytes
from c4s.folders import remove_tree
from c4s.records.evidence_digests import EXPORTED, SEEN, note_digests
from c4s.records.folder import EvidenceFolder


def replace_exported(made: EvidenceFolder, out: EvidenceFolder) -> None:
    """Put what was exported in place of the old folder, so that a reader never sees a part of it."""
    note_digests(made, EXPORTED, [made.snapshot, made.dependencies])
    fresh = _copied(made.root, out.root)
    remove_tree(out.root, inside=out.root.parent)
    fresh.rename(out.root)


def replace_captures(made: EvidenceFolder, out: EvidenceFolder) -> None:
    """Put finished captures into an evidence folder, their digests behind them.

    While the pictures change, no list names them: whenever one is named, it is there.
    """
    note_digests(made, SEEN, made.captures.iterdir())
    fresh = _copied(made.captures, out.root)
    out.digests(SEEN).unlink(missing_ok=True)
    remove_tree(out.captures, inside=out.root)
    fresh.rename(out.captures)
    write_bytes(out.digests(SEEN), made.digests(SEEN).read_bytes())


def _copied(made: Path, out: Path) -> Path:
    """A copy in a hidden folder on the disk where it is going to be, outside of the evidence."""
    out.parent.mkdir(parents=True, exist_ok=True)
    fresh = Path(tempfile.mkdtemp(prefix=f".{out.name}.", dir=out.parent))
    shutil.copytree(made, fresh, dirs_exist_ok=True)
    fresh.chmod(0o755)
    return fresh
