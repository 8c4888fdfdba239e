"""The catalog of one case: its assets from the pack manifests, and the search over them by meaning.

Search is offline and reproducible (``c4s.toolbox.search``): an asset is found by what it means to people, by its words,
by its kind, and by what it is for.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from c4s.records.pack import Asset, Pack
from c4s.records.suite import AgentCase
from c4s.toolbox.refusal import ToolRefused

if TYPE_CHECKING:
    from c4s.toolbox.search import Document, Index

TEXT_WEIGHTS = (2.0, 1.5, 1.0)
"""Weights of an asset's id, category and description beside its name and tags."""
NEAREST = 3


@dataclass(frozen=True)
class CatalogEntry:
    """An asset of the catalog with the pack folder that holds its files."""

    asset: Asset
    pack: Pack
    folder: Path

    def preview(self) -> bytes | None:
        """The asset's preview picture (PNG), where it has one."""
        return None if self.asset.preview is None else (self.folder / self.asset.preview).read_bytes()

    def metadata(self) -> dict[str, Any]:
        """What an agent is told of the asset; sizes in metres (X, Y, Z), the pivot's place in the bounds in cm."""
        asset = self.asset
        return {
            "id": asset.id,
            "name": asset.name,
            "kind": asset.kind,
            "category": asset.category,
            "description": asset.description,
            "tags": list(asset.tags),
            "size_m": [round(side, 3) for side in asset.size_m],
            "bounds_min_cm": list(asset.bounds_min_cm),
            "bounds_max_cm": list(asset.bounds_max_cm),
            "spawn_path": asset.spawn_path,
            "spawn_with": "spawn_blueprint_actor" if asset.kind == "blueprint" else "spawn_actor",
            "preview": asset.preview is not None,
        }


def document_of(asset: Asset) -> Document:
    """What the search reads of an asset."""
    from c4s.toolbox.search import Document

    texts = zip((asset.id, asset.category, asset.description), TEXT_WEIGHTS, strict=True)
    return Document(asset.name, tuple(asset.tags), tuple(texts))


class CaseCatalog:
    """The assets that a case offers."""

    def __init__(self, entries: Sequence[CatalogEntry]) -> None:
        self.entries = list(entries)
        self._by_key: dict[str, list[CatalogEntry]] = {}
        for entry in self.entries:
            asset = entry.asset
            for key in {asset.id, asset.path, asset.spawn_path, asset.path.split(".")[0]}:
                self._by_key.setdefault(key, []).append(entry)

    @cached_property
    def _index(self) -> Index:
        """The search index, made when it is first asked for."""
        from c4s.toolbox.search import Index

        families: dict[Path, list[Asset]] = {}
        for entry in self.entries:
            families.setdefault(entry.folder, list(entry.pack.assets)).append(entry.asset)
        return Index(
            [document_of(asset) for asset in self.assets],
            [[document_of(asset) for asset in family] for family in families.values()],
        )

    @classmethod
    def load(cls, case: AgentCase, packs: Sequence[Path]) -> CaseCatalog:
        """Read the manifests of the packs and keep what the case's catalog names (spawn paths: a Blueprint's class)."""
        offered = set(case.catalog)
        entries = []
        for folder in packs:
            pack = Pack.read(folder / "pack.json")
            entries += [CatalogEntry(asset, pack, folder) for asset in pack.assets]
        return cls([entry for entry in entries if entry.asset.spawn_path in offered])

    @property
    def assets(self) -> list[Asset]:
        """The assets, in the order of the packs."""
        return [entry.asset for entry in self.entries]

    def find(self, key: str) -> CatalogEntry:
        """An entry by id, or by package, object or class path. Refused when there is none, or more than one."""
        found = self._by_key.get(key, [])
        if len(found) == 1:
            return found[0]
        if found:
            raise ToolRefused(
                f"{key!r} is the id of {len(found)} assets: use a path, "
                + " or ".join(entry.asset.path for entry in found)
            )
        near = [entry["id"] for entry in self.search(key, limit=NEAREST)]
        raise ToolRefused(
            f"no asset {key!r} in this case's catalog",
            todo=(f"near: {', '.join(near)}; " if near else "") + "find ids with search_assets",
        )

    def categories(self) -> list[dict[str, Any]]:
        """Categories with their size and short text, by name."""
        counts = Counter(entry.asset.category for entry in self.entries)
        texts: dict[str, str] = {}
        for entry in self.entries:
            texts.setdefault(entry.asset.category, entry.pack.category_descriptions.get(entry.asset.category, ""))
        return [{"category": name, "count": counts[name], "description": texts[name]} for name in sorted(counts)]

    def ranked(self, query: str, *, category: str | None = None) -> list[tuple[CatalogEntry, float]]:
        """All entries that fit a query with their scores, best first; ties by id."""
        scores = self._index.scores(query)
        fitting = [(float(scores[number]), self.entries[number]) for number in np.flatnonzero(scores > 0).tolist()]
        fitting = [
            pair for pair in fitting if category is None or pair[1].asset.category.casefold() == category.casefold()
        ]
        fitting.sort(key=lambda pair: (-pair[0], pair[1].asset.id))
        return [(entry, score) for score, entry in fitting]

    def search(self, query: str, *, category: str | None = None, limit: int = 10) -> list[dict[str, Any]]:
        """Metadata of the best matches with their ``score``, best first; ties by id."""
        return [
            entry.metadata() | {"score": round(score, 3)}
            for entry, score in self.ranked(query, category=category)[:limit]
        ]
