"""Colours and materials of things, from what their assets and materials say. None: not decidable."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from c4s.protocol.words import tokens, word_set
from c4s.semantics.inventory import Array, Thing, trusted
from c4s.semantics.kinds import Facts, Phrase, leaf
from c4s.semantics.shades import shades_of, to_shades

MATERIAL_WORDS: dict[str, frozenset[str]] = {
    "wood": word_set("wood wooden timber oak pine plank walnut birch bamboo log"),
    "metal": word_set("metal metallic steel iron aluminium aluminum chrome brass copper bronze tin zinc"),
    "stone": word_set("stone rock granite marble slate sandstone limestone cobble cobblestone flagstone"),
    "brick": word_set("brick masonry"),
    "concrete": word_set("concrete cement"),
    "glass": word_set("glass pane"),
    "plastic": word_set("plastic rubber"),
    "fabric": word_set("fabric cloth canvas textile cotton linen wool upholstery carpet"),
    "leather": frozenset({"leather"}),
    "paper": word_set("paper cardboard"),
    "plaster": word_set("plaster stucco"),
    "ceramic": word_set("ceramic porcelain terracotta clay"),
}
GENERIC = frozenset(MATERIAL_WORDS) | {"wooden", "timber", "metallic", "rock", "cloth", "textile"}
"""Words that any member of their family satisfies; other words (oak, sandstone) must be named themselves."""
COLORS = word_set("red orange yellow green blue purple violet pink brown black white grey gray beige")


def material_families(words: Iterable[str]) -> set[str]:
    """Material families that words name."""
    present = set(words)
    return {family for family, names in MATERIAL_WORDS.items() if present & names}


def _shown_materials(thing: Thing, catalog_materials: Mapping[str, Facts]) -> list[Facts]:
    """Records of the materials that the actor shows, the asset's own where its snapshot names none; empty where it
    shows one that the catalog does not hold, such as one that the agent made."""
    if not thing.materials:
        return list((thing.kind.facts or {}).get("materials") or [])
    if not all(path in catalog_materials for path in thing.materials):
        return []
    return [catalog_materials[path] for path in thing.materials]


def material_index(catalog: Mapping[str, Facts]) -> dict[str, Facts]:
    """Every material record of the catalog, by path."""
    return {
        str(material["path"]): material
        for facts in catalog.values()
        for material in facts.get("materials") or []
        if isinstance(material, Mapping) and "path" in material
    }


def is_repainted(thing: Thing) -> bool:
    """Whether the thing lacks a material of its asset: then the asset's words do not tell what it looks like."""
    own = {material.get("path") for material in (thing.kind.facts or {}).get("materials") or []}
    return bool(thing.materials) and not own <= set(thing.materials)


def _says(thing: Thing, phrase: Phrase) -> bool:
    return not is_repainted(thing) and thing.kind.says(phrase)


def is_made_of(thing: Thing, wanted: str, materials: Mapping[str, Facts]) -> bool | None:
    """Whether a thing is of a material, by its asset's words or material names; False when they name another only."""
    phrase = tokens(wanted)
    told = [leaf(path) for path in thing.materials if trusted(path, materials)]
    if _says(thing, phrase) or any(word in tokens(name) for name in told for word in phrase):
        return True
    asked = material_families(phrase)
    names = told if thing.materials else [leaf(str(m.get("path") or "")) for m in _shown_materials(thing, materials)]
    own = material_families(word for name in names for word in tokens(name))
    specific = set(phrase) & {word for names in MATERIAL_WORDS.values() for word in names} - GENERIC
    if asked and own & asked and not specific:
        return True
    every = len(told) == len(thing.materials)
    return False if every and asked and own and not own & asked else None


def _shades(base_color: Sequence[float]) -> Array:
    """Lightness, chroma and hue (1, 3) of a linear RGB colour."""
    linear = np.clip(np.array([list(base_color)[:3]], dtype=float), 0.0, 1.0)
    return to_shades(np.where(linear <= 0.0031308, linear * 12.92, 1.055 * linear ** (1 / 2.4) - 0.055))


def has_color(thing: Thing, wanted: str, materials: Mapping[str, Facts], *, in_part: bool = False) -> bool | None:
    """Whether a thing shows a colour: by its asset's words, or by untextured base colours; None when neither says.

    A colour that only some of its materials have may be that of a window or a hub, and one that only passes for it is
    a matter of light: both have to be seen. ``in_part``: that a part has it is enough, as where a thing is to be red
    and white.
    """
    phrase = tokens(wanted)
    if _says(thing, phrase) and (in_part or thing.kind.says_of_all(phrase)):
        return True
    asked = [found for word in phrase if (found := shades_of(word)) is not None]
    if len(asked) != 1:
        return None
    shown: list[Any] = _shown_materials(thing, materials)
    if not shown or any(material.get("texture") or not material.get("base_color") for material in shown):
        return None
    shades = np.concatenate([_shades(material["base_color"]) for material in shown])
    if asked[0].hold(shades).all():
        return True
    return None if asked[0].hold(shades, slack=1.0).any() else False
