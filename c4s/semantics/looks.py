"""Colours and materials of things, from what their assets and materials say. None: not decidable."""

from __future__ import annotations

import colorsys
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from c4s.protocol.words import tokens, word_set
from c4s.semantics.inventory import Thing, trusted
from c4s.semantics.kinds import Facts, leaf

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
_SAME_COLOR = {"gray": "grey", "violet": "purple", "beige": "brown"}


def material_families(words: Iterable[str]) -> set[str]:
    """Material families that words name."""
    present = set(words)
    return {family for family, names in MATERIAL_WORDS.items() if present & names}


def _shown_materials(thing: Thing, catalog_materials: Mapping[str, Facts]) -> list[Facts]:
    """Records of the materials that the actor shows, else the asset's own."""
    shown = [catalog_materials[path] for path in thing.materials if path in catalog_materials]
    return shown or list((thing.kind.facts or {}).get("materials") or [])


def material_index(catalog: Mapping[str, Facts]) -> dict[str, Facts]:
    """Every material record of the catalog, by path."""
    return {
        str(material["path"]): material
        for facts in catalog.values()
        for material in facts.get("materials") or []
        if isinstance(material, Mapping) and "path" in material
    }


def is_made_of(thing: Thing, wanted: str, materials: Mapping[str, Facts]) -> bool | None:
    """Whether a thing is of a material, by its asset's words or material names; False when they name another only."""
    phrase = tokens(wanted)
    told = [leaf(path) for path in thing.materials if trusted(path, materials)]
    if thing.kind.says(phrase) or any(word in tokens(name) for name in told for word in phrase):
        return True
    asked = material_families(phrase)
    shown = _shown_materials(thing, materials)
    names = told or [leaf(str(m.get("path") or "")) for m in shown]
    own = material_families(word for name in names for word in tokens(name))
    specific = set(phrase) & {word for names in MATERIAL_WORDS.values() for word in names} - GENERIC
    if asked and own & asked and not specific:
        return True
    return False if asked and own and not own & asked else None


def color_name(base_color: Sequence[float]) -> str:
    """The everyday name of a linear RGB colour."""
    red, green, blue = (min(max(float(c), 0.0), 1.0) ** (1 / 2.2) for c in base_color)
    hue, light, saturation = colorsys.rgb_to_hls(red, green, blue)
    if light < 0.12:
        return "black"
    if light > 0.88 and saturation < 0.6:
        return "white"
    if saturation < 0.12 or max(red, green, blue) - min(red, green, blue) < 0.06:
        return "grey"
    degrees = hue * 360
    if degrees < 15 or degrees >= 345:
        return "pink" if light > 0.7 else "red"
    if degrees < 45:
        return "brown" if light < 0.45 or saturation < 0.5 else "orange"
    for limit, name in ((70, "yellow"), (170, "green"), (260, "blue"), (310, "purple")):
        if degrees < limit:
            return name
    return "pink"


def has_color(thing: Thing, wanted: str, materials: Mapping[str, Facts]) -> bool | None:
    """Whether a thing shows a colour: by its asset's words, or by untextured base colours; None when neither says."""
    phrase = tokens(wanted)
    if thing.kind.says(phrase):
        return True
    asked = [_SAME_COLOR.get(word, word) for word in phrase if word in COLORS]
    if len(asked) != 1:
        return None
    shown: list[Any] = _shown_materials(thing, materials)
    if not shown or any(material.get("texture") or not material.get("base_color") for material in shown):
        return None
    return asked[0] in {color_name(material["base_color"]) for material in shown}
