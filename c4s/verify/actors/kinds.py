"""What an actor is, apart from where it stands and how it is called: its structural descriptor, and who is semantic."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, TypeAlias

from c4s.verify.actors.entries import ActorEntry, Record

Descriptor: TypeAlias = tuple[str, str, str, tuple[str, ...]]
"""Class path, static mesh, Blueprint class, sorted component assets; all normalised."""

_HELPERS = frozenset({"cameraactor", "cinecameraactor", "scenecapture2d", "scenecapturecube"})


@lru_cache(maxsize=65536)
def _normalized_text(text: str) -> str:
    text = text.strip()
    if text.endswith("'"):
        text = text[text.index("'") + 1 : -1]
    return text.casefold()


def normalized_path(value: Any) -> str:
    """An asset or class path without export quotes, case-folded; empty for null and other empty values."""
    return _normalized_text(str(value or ""))


def short_class(value: Any) -> str:
    """Class name without its package: the part after the last ``.``, then after the last ``/``."""
    return str(value or "").strip().rpartition(".")[2].rpartition("/")[2]


@lru_cache(maxsize=65536)
def _descriptor(class_path: Any, asset: Any, components: tuple[Any, ...]) -> Descriptor:
    kind = normalized_path(class_path)
    blueprint = kind if kind.startswith("/game/") else ""
    mesh = "" if blueprint else normalized_path(asset)
    return kind, mesh, blueprint, tuple(sorted({path for part in components if (path := normalized_path(part))}))


def descriptor(record: Record) -> Descriptor:
    """The normalised structural descriptor (scorer fact 1): what the actor is, not where or how it is called."""
    parts = record.get("component_asset_paths")
    raw = record.get("class"), record.get("asset_path"), tuple(parts) if isinstance(parts, list) else ()
    try:
        return _descriptor(*raw)
    except TypeError:
        return _descriptor(str(raw[0] or ""), str(raw[1] or ""), tuple(map(str, raw[2])))


def _package_name(path: Any) -> str:
    """Name of the package of an asset path: up to the first ``.``, after the last ``/``."""
    return str(path or "").strip().partition(".")[0].rpartition("/")[2]


def is_semantic(record: Record) -> bool:
    """False for capture helpers (cameras, scene captures); everything else counts, lights and volumes included."""
    name = short_class(record.get("class")).casefold()
    return not (
        name in _HELPERS
        or name.endswith("cameraactor")
        or name.startswith("scenecapture")
        or _package_name(record.get("asset_path")).casefold() == "matineecam_sm"
    )


@dataclass(frozen=True, slots=True)
class ActorKind:
    """What an actor is: its descriptor, a number that stands for it within one case, and whether it is semantic."""

    descriptor: Descriptor
    number: int
    semantic: bool


class Kinds:
    """The kinds of a case's actors, worked out once for each combination of recorded text."""

    def __init__(self) -> None:
        self._known: dict[Hashable, ActorKind] = {}
        self._numbers: dict[Descriptor, int] = {}

    def of(self, entry: ActorEntry) -> ActorKind:
        """The kind of an actor."""
        text = entry.kind_text()
        known = None if text is None else self._known.get(text)
        if known is None:
            record = entry.record
            kind = descriptor(record)
            known = ActorKind(kind, self._numbers.setdefault(kind, len(self._numbers)), is_semantic(record))
            if text is not None:
                self._known[text] = known
        return known
