"""``python -m bench.dist [--out FOLDER]``: the wheel and the sdist of the last commit, built twice: the same bytes.

What is built is what git holds, so nothing that a build or a run left in the checkout gets in; times are those of the
commit. Prints each file with its size and digest; ends with 1 where the second build differs from the first.
"""

from __future__ import annotations

import argparse
import gzip
import io
import os
import shutil
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path
from typing import Final

from c4s.files import digest_file

ROOT: Final = Path(__file__).resolve().parents[1]
_BACKEND: Final = """
import sys
from setuptools import build_meta
out = sys.argv[1]
build_meta.build_sdist(out)
build_meta.build_wheel(out)
"""
"""It sets ``sys.argv`` itself."""


def exported(tree: Path) -> int:
    """Fill a folder with the last commit's files; its Unix time in seconds."""
    packed = subprocess.run(["git", "archive", "--format=tar", "HEAD"], cwd=ROOT, capture_output=True, check=True)
    with tarfile.open(fileobj=io.BytesIO(packed.stdout)) as archive:
        archive.extractall(tree, filter="data")
    told = subprocess.run(["git", "log", "-1", "--format=%ct"], cwd=ROOT, capture_output=True, text=True, check=True)
    return int(told.stdout)


def build(tree: Path, out: Path, at_s: int) -> tuple[Path, Path]:
    """The wheel and the sdist of a tree, in an empty folder, by the setuptools that is installed.

    ``at_s``: the Unix time in seconds that they tell of all that is in them.
    """
    out.mkdir(parents=True)
    environment = {**os.environ, "SOURCE_DATE_EPOCH": str(at_s), "LC_ALL": "C.UTF-8"}
    command = [sys.executable, "-c", _BACKEND, str(out.absolute())]
    subprocess.run(command, cwd=tree, env=environment, capture_output=True, umask=0o022, check=True)
    (source,), (wheel,) = out.glob("*.tar.gz"), out.glob("*.whl")
    source.write_bytes(_settled(source.read_bytes(), at_s))
    return wheel, source


def _settled(packed: bytes, at_s: int) -> bytes:
    """A tar.gz with its members in order, of nobody and of one time: setuptools tells the builder and the clock."""
    made, plain = io.BytesIO(), io.BytesIO()
    with tarfile.open(fileobj=io.BytesIO(packed)) as old, tarfile.open(fileobj=plain, mode="w") as new:
        for member in sorted(old.getmembers(), key=lambda one: one.name):
            content = old.extractfile(member) if member.isfile() else None
            member.mtime, member.uid, member.gid, member.uname, member.gname = at_s, 0, 0, "", ""
            member.pax_headers = {}
            new.addfile(member, content)
    with gzip.GzipFile(fileobj=made, mode="wb", filename="", mtime=at_s) as file:
        file.write(plain.getvalue())
    return made.getvalue()


def main() -> int:
    """Build twice, in folders of different names, and print; 0 when both are the same bytes."""
    parser = argparse.ArgumentParser(prog="python -m bench.dist", description=__doc__)
    parser.add_argument("--out", type=Path, default=ROOT / "dist", help="where both files are put (default: dist)")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="c4s-dist-") as scratch:
        places = [Path(scratch, name) for name in ("first", "a second place")]
        first, again = (build(place / "tree", place / "out", exported(place / "tree")) for place in places)
        same = [digest_file(one) == digest_file(other) for one, other in zip(first, again, strict=True)]
        given.out.mkdir(parents=True, exist_ok=True)
        for file, agrees in zip(first, same, strict=True):
            told = "the same bytes twice" if agrees else "THE SECOND BUILD DIFFERS"
            size = file.stat().st_size / 1e6
            print(f"{given.out / file.name}  {size:.2f} MB  sha256 {digest_file(file)}  {told}")
            shutil.copyfile(file, given.out / file.name)
    return int(not all(same))


if __name__ == "__main__":
    raise SystemExit(main())
