"""The evidence folder on disk: replaced as a whole, and its ``digests.json``, which is never wrong."""

from __future__ import annotations

import shutil
import tempfile
from pathlib import Path

from c4s.files import digest_file, read_json, write_json

DIGESTS = "digests.json"
CAPTURES = "captures"


def write_digests(folder: Path) -> None:
    """Write ``digests.json``: the SHA-256 of every other file in the folder."""
    found = {
        path.relative_to(folder).as_posix(): digest_file(path)
        for path in sorted(folder.rglob("*"))
        if path.is_file() and path.name != DIGESTS
    }
    write_json(folder / DIGESTS, found)


def replace_folder(made: Path, out: Path) -> None:
    """Put the finished folder in place of the old one, so that a reader never sees a part of it."""
    fresh = _copied(made, out.parent, out.name)
    if out.exists():
        shutil.rmtree(out)
    fresh.rename(out)


def replace_captures(made: Path, out: Path) -> None:
    """Put finished captures into an evidence folder, and their digests behind them.

    While the pictures change, ``digests.json`` names none of them: whenever it names one, that one is there.
    """
    fresh = _copied(made, out.parent, CAPTURES)
    named = read_json(out / DIGESTS)
    write_json(out / DIGESTS, {name: value for name, value in named.items() if not name.startswith(f"{CAPTURES}/")})
    if (out / CAPTURES).exists():
        shutil.rmtree(out / CAPTURES)
    fresh.rename(out / CAPTURES)
    write_digests(out)


def _copied(made: Path, beside: Path, name: str) -> Path:
    """A copy in a hidden folder on the disk where it is going to be, outside of the evidence."""
    beside.mkdir(parents=True, exist_ok=True)
    fresh = Path(tempfile.mkdtemp(prefix=f".{name}.", dir=beside))
    shutil.copytree(made, fresh, dirs_exist_ok=True)
    fresh.chmod(0o755)
    return fresh
