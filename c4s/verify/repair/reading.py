"""Loading scene snapshots fast: actors stay text until they are needed (``entries``).

Files that hold the NaN and Infinity tokens that exporters write, or anything else beyond strict JSON, are parsed whole.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import msgspec

from c4s.errors import BadInput
from c4s.files import digest_bytes, parse_json, read_plain
from c4s.verify.actors.entries import read_texts
from c4s.verify.repair.actors import RepairScene


class _Document(msgspec.Struct):
    actors: list[msgspec.Raw]
    export_metadata: Any = None


_DOCUMENT = msgspec.json.Decoder(_Document)


def _as_text(data: bytes, known: dict[bytes, bytes]) -> RepairScene | None:
    """The scene with its actors as text, or None when the file must be parsed whole."""
    try:
        data.decode()
        document = _DOCUMENT.decode(data)
        return RepairScene(read_texts(document.actors, known), document.export_metadata)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError):
        return None


def _parse(data: bytes, path: Path, known: dict[bytes, bytes]) -> Any:
    scene = _as_text(data, known)
    if scene is not None:
        return scene
    try:
        return parse_json(data)
    except (ValueError, RecursionError) as error:
        raise BadInput(f"this snapshot is not valid JSON: {error}", where=str(path), todo="is it complete?") from None


def read_snapshots(paths: dict[str, Path]) -> tuple[dict[str, Any], dict[str, str]]:
    """Named snapshots, and the SHA-256 of each file as ``<name>_snapshot``.

    A snapshot is a ``Scene``, or the plain JSON value of a file that is no scene or no strict JSON. Digests are made in
    a second thread while the first one parses. Raises ``BadInput`` with one clear line.
    """
    with ThreadPoolExecutor(max_workers=1) as hashing:
        data = {name: read_plain(path, "snapshot") for name, path in paths.items()}
        digests = {name: hashing.submit(digest_bytes, content) for name, content in data.items()}
        known: dict[bytes, bytes] = {}
        values = {name: _parse(content, paths[name], known) for name, content in data.items()}
        return values, {f"{name}_snapshot": digest.result() for name, digest in digests.items()}
