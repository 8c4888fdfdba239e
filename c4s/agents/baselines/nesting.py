"""Who belongs to whom: what stands on or near what, as a forest of groups, and the links between groups."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from c4s.agents.baselines.english import INDOORS
from c4s.agents.baselines.naming import is_flat
from c4s.agents.baselines.palette import PaletteItem
from c4s.agents.baselines.reading import Link, Mention, Prose

SHELL_WORDS = frozenset({"wall", "window", "door", "doorway", "floor", "ceiling", "roof"})
"""What a room is made of."""
TALLEST_BASE_M = 1.6


@dataclass
class Forest:
    """Groups: each thing's own, and whether they stand ``on`` it or ``near`` it."""

    roots: list[Mention] = field(default_factory=list)
    kids: dict[Mention, list[tuple[str, Mention]]] = field(default_factory=dict)
    parent: dict[Mention, Mention] = field(default_factory=dict)
    between_groups: list[Link] = field(default_factory=list)
    shell: list[Mention] = field(default_factory=list)
    """What the rooms are made of."""
    indoors: bool = False

    def line(self, named: Mention) -> Iterator[Mention]:
        """The thing and all that it belongs to."""
        yield named
        while named in self.parent:
            named = self.parent[named]
            yield named

    def nest(self, kind: str, child: Mention, parent: Mention) -> bool:
        """Let a thing belong to another; False where it belongs somewhere already or the other belongs to it."""
        if child in self.parent or child in self.line(parent) or child not in self.roots:
            return False
        self.parent[child] = parent
        self.kids.setdefault(parent, []).append((kind, child))
        self.roots.remove(child)
        return True


def forest(reading: Prose, text: str) -> Forest:
    """The groups of a reading."""
    found = Forest(indoors=_is_indoors(text))
    for named in reading.named:
        shell = found.indoors and (
            named.noun in SHELL_WORDS or any(set(item.words) & SHELL_WORDS and is_flat(item) for item in named.items)
        )
        (found.shell if shell and not named.is_place else found.roots).append(named)
    links = [link for link in reading.links if link.thing not in found.shell and link.other not in found.shell]
    for link in sorted(links, key=lambda link: not link.thing.is_place):
        _take(found, link)
    for link in links:
        _take_back(found, link)
    _lift(found)
    return found


def stands_on(below: Sequence[PaletteItem], above: Sequence[PaletteItem]) -> bool:
    """Whether things have room on top of others, as on a table: on what is flat or high they stand otherwise."""
    if not above or not below or is_flat(above[0]) or is_flat(below[0]):
        return False
    base = min(below, key=lambda item: item.height)
    largest = max(above, key=lambda item: item.area)
    return largest.width <= base.width and largest.depth <= base.depth and base.height <= TALLEST_BASE_M


def _is_indoors(text: str) -> bool:
    words = text.lower().replace("-", " ").replace(",", " ").replace(".", " ").split()
    return sum(word in INDOORS for word in words) >= 2 and "street" not in words[:12]


def _take(found: Forest, link: Link) -> None:
    if link.thing.is_strip:
        found.between_groups.append(link)
    elif link.kind == "near" or _holds(link.other, link.thing):
        nested = found.nest(link.kind, link.thing, link.other)
        if not nested and link.thing in found.parent and link.other not in found.line(link.thing):
            found.between_groups.append(link)


def _holds(partner: Mention, thing: Mention) -> bool:
    """Whether something is large enough to hold another."""
    if partner.is_place or partner.is_strip or not partner.items or not thing.items:
        return True
    return max(item.area for item in partner.items) >= min(item.area for item in thing.items)


def _take_back(found: Forest, link: Link) -> None:
    """What nothing else is said of goes to what stands near it."""
    other = link.other
    if link.kind == "near" and other in found.roots and not other.is_place and not other.is_strip:
        found.nest("near", other, link.thing)


def _lift(found: Forest) -> None:
    """What belongs to a thing that stands on another belongs to the one below."""
    for parent in list(found.kids):
        for kind, kid in list(found.kids.get(parent, [])):
            if kind == "on" and stands_on(parent.items, kid.items):
                for other_kind, other in found.kids.pop(kid, []):
                    found.kids[parent].append((other_kind, other))
                    found.parent[other] = parent
