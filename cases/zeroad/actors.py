"""Actors of 0 A.D.: XML that says, in groups of variants, which mesh, texture and props a thing is made of."""

from __future__ import annotations

import random
from dataclasses import dataclass, field
from xml.etree.ElementTree import Element

from c4s.errors import BadInput
from cases.zeroad.archive import Archive

NEVER = ("destruction", "death", "damage", "garrison", "scaffold", "foundation", "particle")
"""Variants for what happens in the game have such words in their names or files."""
WHOLE = ("alive", "idle", "base")


@dataclass
class ActorLook:
    """What one choice of variants makes of an actor: names as its file has them; props are (point, actor)."""

    mesh: str | None = None
    texture: str | None = None
    material: str = ""
    color: tuple[float, float, float] | None = None
    props: dict[str, list[str]] = field(default_factory=dict)

    def take(self, variant: Element) -> None:
        """Let a variant decide what it names."""
        self.mesh = (variant.findtext("mesh") or "").strip() or self.mesh
        for texture in variant.iterfind("textures/texture"):
            if texture.get("name") == "baseTex":
                self.texture = texture.get("file") or self.texture
        told = (variant.findtext("color") or "").split()
        if len(told) == 3 and all(value.isdigit() for value in told):
            r, g, b = (int(value) / 255 for value in told)
            self.color = (r, g, b)
        named: dict[str, list[str]] = {}
        for prop in variant.iterfind("props/prop"):
            named.setdefault(prop.get("attachpoint", "root"), []).append((prop.get("actor") or "").strip())
        self.props |= {point: [actor for actor in actors if actor] for point, actors in named.items()}


def look_of(archive: Archive, actor: str, chance: random.Random) -> ActorLook:
    """A look of an actor; each variant is as likely as its file says. ``BadInput`` where it cannot be read."""
    root = archive.xml(f"art/actors/{actor}")
    if root.tag == "qualitylevels":
        best = list(root)[-1]
        if best.get("file"):
            return look_of(archive, str(best.get("file")), chance)
        inline = best.find("actor")
        root = best if inline is None else inline
    if root.tag not in ("actor", "inline"):
        raise BadInput(f"a {root.tag} and no actor with a mesh", where=actor)
    look = ActorLook(material=(root.findtext("material") or "").strip())
    for group in root.iterfind("group"):
        variant = _chosen(group.findall("variant"), chance)
        if variant is None:
            continue
        if variant.get("file"):
            look.take(archive.xml(f"art/variants/{variant.get('file')}"))
        look.take(variant)
    return look


def _chosen(variants: list[Element], chance: random.Random) -> Element | None:
    good = [one for one in variants if not any(word in _named(one) for word in NEVER)]
    whole = [one for one in good if one.get("name", "").lower() in WHOLE]
    good = whole[:1] or good
    if not good:
        return None
    weights = [float(one.get("frequency") or 0) for one in good]
    return chance.choices(good, weights if sum(weights) > 0 else None)[0]


def _named(variant: Element) -> str:
    return f"{variant.get('name', '')} {variant.get('file', '')}".lower()


@dataclass(frozen=True)
class EntityTemplate:
    """What a template says of how a thing is shown: its actor, and whether it floats on water."""

    actor: str
    floats: bool


def template_of(archive: Archive, name: str) -> EntityTemplate:
    """What a template of entities, or an ``actor|path``, is shown as; ``BadInput`` where that is nothing."""
    kind, bar, rest = name.partition("|")
    if kind == "actor" and bar:
        return EntityTemplate(rest, False)
    actor, floats = _told(archive, rest or name, 0)
    if not actor:
        raise BadInput("a template without an actor", where=name)
    return EntityTemplate(actor, bool(floats))


def _told(archive: Archive, name: str, depth: int) -> tuple[str | None, bool | None]:
    if depth > 16:
        raise BadInput("templates whose parents never end", where=name)
    folder = "simulation/templates"
    mixed = [f"{folder}/{kind}/{name}.xml" for kind in ("special/filter", "mixins")]
    path = next((one for one in (f"{folder}/{name}.xml", *mixed) if one in archive.names), f"{folder}/{name}.xml")
    root = archive.xml(path)
    actor = (root.findtext("VisualActor/Actor") or "").strip() or None
    told = root.findtext("Position/Floating")
    floats = None if told is None else told.strip() == "true"
    for parent in reversed((root.get("parent") or "").split("|")):
        if parent and (actor is None or floats is None):
            theirs, also = _told(archive, parent, depth + 1)
            actor, floats = actor or theirs, also if floats is None else floats
    civ = (root.findtext("Identity/Civ") or "").strip()
    return actor.replace("{civ}", civ) if actor and civ else actor, floats
