"""What files beside a mesh say about it: JSON, YAML, and text of ``name: value`` lines."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import yaml

from c4s.errors import BadInput
from c4s.files import read_plain_text
from c4s.names import file_in, shown
from catalog.ingest.listing import ListingRow

KINDS = (".json", ".yaml", ".yml", ".txt")
OF_A_FOLDER = {"metadata", "meta", "info", "model", "asset", "data", "description", "about", "manifest", "details"}
"""Names of files that describe the one thing of their folder; the folder's own name is another."""
KEYS: dict[str, tuple[str, ...]] = {
    "name": ("name", "title", "label", "displayname", "display_name"),
    "category": ("category", "categories", "type", "class", "kind"),
    "description": ("description", "caption", "summary", "text"),
    "tags": ("tags", "keywords", "labels", "tag"),
    "licence": ("license", "licence", "license_url", "rights"),
}
MOST_BYTES = 1 << 20
MOST_TEXT = 2000
MOST_TAGS = 50


def sidecar(path: Path, folder: Path, files: Sequence[Path]) -> tuple[ListingRow, list[str]]:
    """What is said of a mesh file, and notes on files that cannot be read.

    ``<name>.json`` (or ``.yaml``, ``.yml``, ``.txt``) and ``<name>.glb.json`` count, and for the only mesh of its
    folder a file of the folder's name or of one in ``OF_A_FOLDER``. Of several the first with an answer counts, key by
    key.
    """
    alone = path.parent != folder and sum(other.parent == path.parent for other in files) == 1
    stems = [path.stem.lower(), path.name.lower()]
    if alone:
        stems += [path.parent.name.lower(), *sorted(OF_A_FOLDER)]
    try:
        beside = [one for one in path.parent.iterdir() if one.suffix.lower() in KINDS and one.stem.lower() in stems]
    except OSError:
        return ListingRow(), []
    said: dict[str, Any] = {}
    notes = []
    for one in sorted(beside, key=lambda one: (stems.index(one.stem.lower()), KINDS.index(one.suffix.lower()))):
        try:
            record = _read(file_in(folder, one.relative_to(folder).as_posix()))
        except BadInput as error:
            notes.append(f"{shown(one.name)} cannot be read and is left out: {error.what}")
            continue
        for key, values in _told(record).items():
            said.setdefault(key, values)
    return ListingRow(
        said.get("name", ""),
        said.get("category", ""),
        said.get("description", ""),
        said.get("tags", ()),
        said.get("licence", ""),
    ), notes


def _read(path: Path) -> dict[str, Any]:
    if path.stat().st_size > MOST_BYTES:
        return {}
    text = read_plain_text(path)
    try:
        if path.suffix.lower() == ".json":
            found = json.loads(text)
        elif path.suffix.lower() == ".txt":
            found = _lines(text)
        else:
            found = yaml.safe_load(text)
    except (ValueError, RecursionError, yaml.YAMLError) as error:
        raise BadInput(f"{str(error).splitlines()[0]:.100}", where=str(path)) from None
    return found if isinstance(found, dict) else {}


def _lines(text: str) -> dict[str, Any]:
    """``name: value`` lines; a text without any is a description when it is short."""
    pairs = dict(re.findall(r"(?m)^[ \t]*([A-Za-z_ ]{2,20}?)[ \t]*[:=][ \t]*(\S.*?)[ \t]*$", text))
    if pairs:
        return {key.lower(): value for key, value in pairs.items()}
    said = " ".join(text.split())
    return {"description": said} if 3 < len(said) <= 300 else {}


def _told(record: dict[str, Any]) -> dict[str, Any]:
    lower = {str(key).lower(): value for key, value in record.items()}
    found: dict[str, Any] = {}
    for key, names in KEYS.items():
        for name in names:
            texts = _texts(lower.get(name), split=key == "tags")
            if texts:
                found[key] = tuple(texts[:MOST_TAGS]) if key == "tags" else texts[0]
                break
    return found


def _texts(value: Any, *, split: bool) -> list[str]:
    """Texts of a value: of a list each, of a record its name; ``split`` takes a line apart."""
    if isinstance(value, str):
        parts = re.split(r"[;,|]", value) if split else [value]
        texts = [" ".join("".join(c if c.isprintable() else " " for c in part).split())[:MOST_TEXT] for part in parts]
        return [text for text in texts if text]
    if isinstance(value, dict):
        inner = {str(key).lower(): one for key, one in value.items()}
        return next(
            (
                found
                for key in ("name", "label", "title", "slug", "id", "url")
                if (found := _texts(inner.get(key), split=False))
            ),
            [],
        )
    if isinstance(value, list):
        return [text for one in value[:MOST_TAGS] for text in _texts(one, split=False)]
    return []
