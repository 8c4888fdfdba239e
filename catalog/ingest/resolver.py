"""Finds the files that a mesh file refers to, inside one folder and nowhere else."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import unquote

from trimesh.resolvers import Resolver

from c4s.files import read_plain
from c4s.names import MOST_PATH


class FolderResolver(Resolver):
    """Resolves names next to a mesh file, else by their ending anywhere under ``root``, letter case aside.

    Authors' paths often fit their own disk only (``C:\\\\art\\\\wood.png``, ``model://desk/wood.png``), so the longest
    ending of a name that exists under ``root`` is taken.

    Args:
        source: the mesh file.
        root: the only folder whose files may be read.
    """

    def __init__(self, source: Path, root: Path) -> None:
        self.source, self.root = source, Path(os.path.realpath(root))
        self.file_name = source.name
        self.found: dict[str, Path] = {}
        self.missing: list[str] = []

    def get(self, key: str) -> bytes:
        """Content of the file called ``key``; ``FileNotFoundError`` (and a line in ``missing``) when there is none."""
        path = self.locate(key)
        if path is None:
            if key not in self.missing:
                self.missing.append(key)
            raise FileNotFoundError(key)
        self.found[key] = path
        return read_plain(path)

    def locate(self, name: str) -> Path | None:
        """The file called ``name``, or ``None``."""
        clean = unquote(str(name)).strip().replace("\\", "/").split("://", 1)[-1]
        if len(clean) > MOST_PATH or not clean.isprintable():
            return None
        beside = Path(os.path.realpath(self.source.parent / clean))
        if beside.is_file() and beside.is_relative_to(self.root):
            return beside
        parts = [part.lower() for part in clean.split("/") if part not in ("", ".", "..")]
        if not parts:
            return None
        named = [
            path
            for path in sorted(self.root.rglob("*"))
            if path.name.lower() == parts[-1]
            and path.is_file()
            and Path(os.path.realpath(path)).is_relative_to(self.root)
        ]

        def shared(path: Path) -> int:
            count = 0
            for ours, theirs in zip(reversed(path.parts), reversed(parts), strict=False):
                if ours.lower() != theirs:
                    break
                count += 1
            return count

        return max(named, key=shared, default=None)

    def keys(self) -> Iterator[str]:
        """Names of the files beside the mesh file."""
        return (path.name for path in self.source.parent.iterdir() if path.is_file())

    def namespaced(self, namespace: str) -> FolderResolver:
        """The resolver of a subfolder."""
        return FolderResolver(self.source.parent / namespace / self.source.name, self.root)

    def write(self, name: str, data: bytes) -> None:
        """Nothing is written into a source folder."""
        raise PermissionError(f"{name}: a source folder is read-only")
