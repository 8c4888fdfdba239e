"""An object store, reached through fsspec: any URL that it knows, ``s3://`` first of all.

A folder is pushed as its files by digest (``blobs/<2 hex>/<sha256>``) and then one index (``<folder>.index.json``)
that names them: one object replaces another, so a reader sees the last whole push or the one before, and what two
folders share is sent and kept once. Warehouse parts, the plan and pages lie under their own names, for other readers.
What was fetched or sent is not fetched again while the store's tag of it is the same (``C4S_HOME/cache/store``).
"""

from __future__ import annotations

import json
import os
import stat
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, Final

import fsspec

from c4s import extras
from c4s.errors import BadInput, MachineryFault
from c4s.files import digest_bytes, digest_file, is_unfinished, parse_json, read_plain, write_bytes, write_json
from c4s.home import cache_root, home
from c4s.records.folder import AttemptFolder, TrialFolder
from c4s.run.store.base import STORE, Only
from c4s.run.store.leases import FolderLeases, LeasePlace
from c4s.run.store.object_leases import ObjectLeases
from c4s.run.store.reach import reached, without_password

AT_ONCE: Final = 16
"""Transfers at once."""
_LEASES: Final = TrialFolder(Path()).leases.name
"""The folder directly below a trial's that is no content: leases are objects of their own."""
_SUBMISSION: Final = AttemptFolder(Path()).submission.name


class ObjectStore:
    """What lies under a URL.

    Args:
        url: of a bucket or a folder in it. Keys, region and endpoint come from the environment, as the store's own
            library reads them (``AWS_ACCESS_KEY_ID``, ``AWS_ENDPOINT_URL_S3``, ...).
    """

    apart = True

    def __init__(self, url: str) -> None:
        self.name = without_password(url)
        if url.startswith(("s3://", "s3a://")):
            extras.need("s3", f"{STORE}={self.name}")
        try:
            with reached(self.name, but=(ValueError, ImportError, TypeError)):
                self._fs, root = fsspec.core.url_to_fs(url, use_listings_cache=False)
        except (ValueError, ImportError, TypeError) as error:
            why = f": {error}" if self.name == url else ""
            raise BadInput(f"{self.name!r} is no store{why}", where=STORE, todo="name s3://bucket/prefix") from None
        self._root = str(root).rstrip("/")
        if not self._root:
            raise BadInput(f"{self.name!r} names no bucket", where=STORE, todo="name s3://bucket/prefix")
        with reached(self.name):
            self._fs.ls(self._root.split("/", 1)[0], detail=False)
        self._place = digest_bytes(url.encode())[:16]

    def leases(self, folder: Path) -> LeasePlace:
        if not folder.absolute().is_relative_to(home()):
            return FolderLeases(folder)
        return ObjectLeases(self._fs, self._key(folder), self.name)

    def pull(self, folder: Path, only: Only | None = None) -> bool:
        index = self._index(folder)
        if index is None:
            if only is None and folder.is_dir():
                _set_aside(folder, sorted(name for name, _ in _content(folder)))
            return False
        chosen = {name: sha for name, sha in index.items() if only is None or only(name)}
        here = {name: digest_file(path) for name, path in _content(folder) if name in chosen}
        if only is None:
            _set_aside(folder, sorted(name for name, _ in _content(folder) if name not in index))
        self._each([(folder / name, sha) for name, sha in chosen.items() if here.get(name) != sha], self._fetch)
        return True

    def push(self, folder: Path, check: Callable[[], None] | None = None) -> None:
        before = set((self._index(folder) or {}).values())
        made: dict[str, str] = {}

        def send(name: str, path: Path) -> None:
            data = path.read_bytes()
            made[name] = digest_bytes(data)
            if made[name] not in before:
                with reached(self.name):
                    if not self._fs.exists(self._blob(made[name])):
                        self._fs.pipe_file(self._blob(made[name]), data)

        self._each(list(_content(folder)), send)
        if check is not None:
            check()
        with reached(self.name):
            self._fs.pipe_file(self._index_key(folder), json.dumps(made, sort_keys=True).encode())

    def pull_files(self, place: Path, only: Only | None = None) -> list[Path]:
        with reached(self.name):
            found = self._fs.find(self._key(place), detail=True)
        known, below = self._known(place), f"{self._key(place)}/"
        tags = {
            str(key): _tag(info) for key, info in found.items() if only is None or only(str(key).removeprefix(below))
        }
        stale = [
            (self._path(key), key)
            for key, tag in tags.items()
            if known.get(key) != tag or not self._path(key).is_file()
        ]
        self._each(stale, lambda path, key: write_bytes(path, self._read(key)))
        if stale:
            self._know(place, known | tags)
        return [path for path, _ in stale]

    def push_files(self, place: Path) -> None:
        files = [(place, "")] if place.is_file() else [(path, "") for _, path in _content(place)]
        known = self._known(place)
        sums = {self._key(path): digest_file(path) for path, _ in files}

        def send(path: Path, key: str) -> None:
            with reached(self.name):
                self._fs.pipe_file(key, path.read_bytes())

        changed = [
            (path, self._key(path)) for path, _ in files if known.get("=" + self._key(path)) != sums[self._key(path)]
        ]
        self._each(changed, send)
        if changed and not place.is_file():
            self._know(place, known | {"=" + key: sums[key] for _, key in changed})

    def put(self, path: Path, place: Path) -> None:
        with reached(self.name):
            self._fs.pipe_file(self._key(place), path.read_bytes())

    def _fetch(self, path: Path, sha256: str) -> None:
        data = self._read(self._blob(sha256))
        if digest_bytes(data) != sha256:
            raise MachineryFault(
                "the store holds other bytes than were put there",
                where=without_password(self._blob(sha256)),
                todo="restore the object",
            )
        write_bytes(path, data)

    def _read(self, key: str) -> bytes:
        with reached(self.name):
            return bytes(self._fs.cat_file(key))

    def _index(self, folder: Path) -> dict[str, str] | None:
        """Names and digests of the last push; None where there was none."""
        key = self._index_key(folder)
        with reached(self.name):
            if not self._fs.exists(key):
                return None
        try:
            found = parse_json(self._read(key))
            return {str(name): str(sha256) for name, sha256 in found.items()}
        except (ValueError, AttributeError) as error:
            raise MachineryFault(
                f"the index of a folder is none: {error}", where=without_password(key), todo="restore it"
            ) from None

    def _each(self, jobs: list[tuple[Any, Any]], function: Any) -> None:
        """Do all of them, so many at once; the first error is raised."""
        if not jobs:
            return
        with ThreadPoolExecutor(min(AT_ONCE, len(jobs))) as threads:
            for _ in threads.map(lambda job: function(*job), jobs):
                pass

    def _key(self, path: Path) -> str:
        relative = path.absolute().relative_to(home())
        return f"{self._root}/{relative.as_posix()}"

    def _path(self, key: str) -> Path:
        name = key.removeprefix(f"{self._root}/")
        path = (home() / name).absolute()
        if ".." in name.split("/") or not path.is_relative_to(home()):
            raise MachineryFault("an object's name leads out of C4S_HOME", where=without_password(key))
        return path

    def _index_key(self, folder: Path) -> str:
        return f"{self._key(folder)}.index.json"

    def _blob(self, sha256: str) -> str:
        return f"{self._root}/blobs/{sha256[:2]}/{sha256}"

    def _kept(self, place: Path) -> Path:
        return cache_root() / "store" / f"{self._place}-{digest_bytes(self._key(place).encode())[:16]}.json"

    def _known(self, place: Path) -> dict[str, str]:
        """Tags of what was fetched, and digests of what was sent, by key."""
        try:
            known = parse_json(read_plain(self._kept(place)))
        except (BadInput, ValueError):
            return {}
        return known if isinstance(known, dict) else {}

    def _know(self, place: Path, known: Mapping[str, str]) -> None:
        write_json(self._kept(place), dict(known), indent=None)


def _content(folder: Path) -> Iterator[tuple[str, Path]]:
    """Names and paths of a folder's plain files: not its leases, not what is being written, no links or sockets.

    What an agent saved is its submission whatever it is called: all of that is content.
    """
    for place, folders, names in os.walk(folder):
        inside = Path(place).relative_to(folder)
        whole = _SUBMISSION in inside.parts
        folders[:] = sorted(
            name for name in folders if whole or not (is_unfinished(name) or inside / name == Path(_LEASES))
        )
        for name in sorted(names):
            path = Path(place, name)
            if (whole or not is_unfinished(name)) and stat.S_ISREG(path.lstat().st_mode):
                yield (inside / name).as_posix(), path


def _tag(info: Mapping[str, Any]) -> str:
    """What tells one content of an object from another."""
    return str(
        info.get("ETag") or f"{info.get('size')}-{info.get('LastModified') or info.get('created') or info.get('mtime')}"
    )


def _set_aside(folder: Path, names: list[str]) -> None:
    """Move files that were never pushed out of the way, and keep them: they are of a stage that was cut off."""
    if not names:
        return
    number = 1
    while (kept := folder.with_name(f"{folder.name}.unsent-{number}")).exists():
        number += 1
    for name in names:
        (kept / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).rename(kept / name)
