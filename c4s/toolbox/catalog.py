"""The catalog of one case: its assets from the pack manifests, and the search over their words.

Search is offline and reproducible: each query word is matched against the words of an asset's name, id, tags, category
and description (equal stem, common prefix, or a known synonym), weighted by how rare the word is in this catalog
(inverse document frequency) and by the field it stands in.
"""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from c4s.case.package import AgentCase
from c4s.packs.manifest import Asset, Pack
from c4s.toolbox.tool import ToolRefused

FIELD_WEIGHTS = (("name", 4.0), ("id", 3.0), ("tags", 3.0), ("category", 2.0), ("description", 1.0))
SYNONYMS: tuple[frozenset[str], ...] = tuple(frozenset(group.split()) for group in (
    "sofa couch settee", "chair seat stool", "table desk", "lamp light lantern", "cabinet cupboard wardrobe closet",
    "shelf bookcase bookshelf rack", "rug carpet mat", "plant pot shrub bush", "tree conifer pine", "boat ship vessel",
    "box crate case", "trash bin waste garbage rubbish", "car vehicle auto", "truck lorry", "fence railing barrier",
    "house building cottage barn", "road street path", "monitor screen display", "computer pc laptop",
    "picture painting frame",
    "stone rock boulder", "ground floor terrain", "bed mattress", "wall partition", "dock pier quay jetty"))
_WORD = re.compile(r"[a-z0-9]+")


@dataclass(frozen=True)
class Entry:
    """An asset of the catalog with the pack folder that holds its files."""

    asset: Asset
    pack: Pack
    folder: Path

    @property
    def spawn_path(self) -> str:
        """Path to spawn by: a mesh's object path, a Blueprint's generated class."""
        return f"{self.asset.path}_C" if self.asset.kind == "blueprint" else self.asset.path

    def metadata(self) -> dict[str, Any]:
        """What an agent is told of the asset; sizes in metres (X, Y, Z), the pivot's place in the bounds in cm."""
        asset = self.asset
        return {"id": asset.id, "name": asset.name, "kind": asset.kind, "category": asset.category,
                "description": asset.description, "tags": list(asset.tags),
                "size_m": [round(side, 3) for side in asset.size_m],
                "bounds_min_cm": list(asset.bounds_min_cm), "bounds_max_cm": list(asset.bounds_max_cm),
                "spawn_path": self.spawn_path,
                "spawn_with": "spawn_blueprint_actor" if asset.kind == "blueprint" else "spawn_actor",
                "preview": asset.preview is not None}


class CaseCatalog:
    """The assets that a case offers."""

    def __init__(self, entries: Sequence[Entry]) -> None:
        self.entries = list(entries)
        self._words = [_field_words(entry.asset) for entry in self.entries]
        self._rarity = Counter(stem for fields in self._words for stem in {s for words in fields for s in words})

    @classmethod
    def load(cls, case: AgentCase, packs: Sequence[Path]) -> CaseCatalog:
        """Read the manifests of the packs and keep what the case's catalog names."""
        offered = set(case.catalog)
        entries = []
        for folder in packs:
            pack = Pack.read(folder / "pack.json")
            entries += [Entry(asset, pack, folder) for asset in pack.assets if asset.path in offered]
        return cls(entries)

    @property
    def assets(self) -> list[Asset]:
        """The assets, in the order of the packs."""
        return [entry.asset for entry in self.entries]

    def find(self, key: str) -> Entry:
        """An entry by id, or by package, object or class path. Refused when there is none, or more than one."""
        wanted = key.removesuffix("_C") if "." in key else key
        found = [entry for entry in self.entries
                 if wanted in (entry.asset.path, entry.asset.path.split(".")[0]) or key == entry.asset.id]
        if len(found) == 1:
            return found[0]
        if found:
            raise ToolRefused(f"{key!r} is the id of {len(found)} assets: use a path, "
                              + " or ".join(entry.asset.path for entry in found))
        near = [entry["id"] for entry in self.search(key, limit=3)]
        raise ToolRefused(f"no asset {key!r} in this case's catalog" + (f"; near: {', '.join(near)}" if near else ""))

    def categories(self) -> list[dict[str, Any]]:
        """Categories with their size and short text, by name."""
        counts = Counter(entry.asset.category for entry in self.entries)
        texts: dict[str, str] = {}
        for entry in self.entries:
            texts.setdefault(entry.asset.category, entry.pack.category_descriptions.get(entry.asset.category, ""))
        return [{"category": name, "count": counts[name], "description": texts[name]} for name in sorted(counts)]

    def search(self, query: str, *, category: str | None = None, limit: int = 10) -> list[dict[str, Any]]:
        """Metadata of the best matches with their ``score``, best first; ties by id."""
        wanted = [stem for stem in dict.fromkeys(map(stem_of, words_of(query))) if len(stem) > 1]
        scored = []
        for entry, fields in zip(self.entries, self._words, strict=True):
            if category is not None and entry.asset.category.casefold() != category.casefold():
                continue
            score = sum(self._score(stem, fields) for stem in wanted)
            if score > 0:
                scored.append((-score, entry.asset.id, entry))
        scored.sort(key=lambda item: item[:2])
        return [entry.metadata() | {"score": round(-score, 3)} for score, _, entry in scored[:limit]]

    def _score(self, wanted: str, fields: tuple[frozenset[str], ...]) -> float:
        """The best field match of one query stem."""
        best = 0.0
        for (_, weight), stems in zip(FIELD_WEIGHTS, fields, strict=True):
            for stem in stems:
                likeness = _likeness(wanted, stem)
                if likeness:
                    rarity = math.log(1 + len(self.entries) / self._rarity[stem])
                    best = max(best, weight * likeness * rarity)
        return best


def words_of(value: str) -> list[str]:
    """Lower-case words; camel case and underscores separate words."""
    return _WORD.findall(re.sub(r"(?<=[a-z])(?=[A-Z])", " ", value).lower())


def stem_of(word: str) -> str:
    """A word without its English plural."""
    if len(word) > 4 and word.endswith("ies"):
        return word[:-3] + "y"
    if len(word) > 4 and word.endswith(("ches", "shes", "xes", "sses")):
        return word[:-2]
    return word[:-1] if len(word) > 3 and word.endswith("s") and not word.endswith("ss") else word


def _likeness(wanted: str, stem: str) -> float:
    if wanted == stem:
        return 1.0
    if any(wanted in group and stem in group for group in SYNONYMS):
        return 0.6
    shorter, longer = sorted((wanted, stem), key=len)
    return 0.5 if len(shorter) >= 3 and (longer.startswith(shorter) or longer.endswith(shorter)) else 0.0


def _field_words(asset: Asset) -> tuple[frozenset[str], ...]:
    values = (asset.name, asset.id, " ".join(asset.tags), asset.category, asset.description)
    return tuple(frozenset(map(stem_of, words_of(value))) for value in values)
