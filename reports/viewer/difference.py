"""How two scene documents differ, actor by actor."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import dist
from typing import Any, Final, Literal

from c4s.geometry.transform import quat_angle_deg
from c4s.protocol.repair import SAME_SCALE

Actor = Mapping[str, Any]
Kind = Literal["missing", "extra", "moved", "changed"]
KINDS: Final[dict[Kind, str]] = {
    "missing": "in the truth, and not in the submission",
    "extra": "in the submission, and not in the truth",
    "moved": "at another place, turned or scaled otherwise",
    "changed": "of another mesh, material or visibility",
}
SEEN_CM, SEEN_DEG, SEEN_PCT = 1.0, 1.0, 1.0
"""Smaller differences of place, rotation and scale are not told: scripts round what they place."""
NEAR_CM: Final = 200.0
"""An actor of the same asset that is this near to one that is gone is taken for it."""


@dataclass(frozen=True)
class Difference:
    """One actor that differs from the truth."""

    kind: Kind
    name: str
    """Object name in the submission; empty where it is missing."""
    truth: str
    """Object name in the truth; empty where it is extra."""
    label: str
    asset: str
    off_cm: float = 0.0
    turned_deg: float = 0.0
    scaled_pct: float = 0.0
    """The largest of the three axes."""
    other: str = ""
    """What else is not the same, in words."""

    @property
    def told(self) -> str:
        """By how much, in words."""
        parts = [
            f"{value:.{digits}f} {unit}"
            for value, digits, unit in (
                (self.off_cm, 1, "cm off"),
                (self.turned_deg, 1, "° turned"),
                (self.scaled_pct, 1, "% scaled"),
            )
            if value >= 0.05
        ]
        return ", ".join([*parts, *([self.other] if self.other else [])])


def differences(truth: Mapping[str, Any], found: Mapping[str, Any], pairs: Mapping[str, str]) -> list[Difference]:
    """Every actor that differs, missing ones first.

    Args:
        truth: a scene document (``warehouse.scenes``).
        found: the document of the submission.
        pairs: names in the truth to names in the submission that a verdict took for them.
    """
    matched, missing, extra = _matched(truth["actors"], found["actors"], pairs)
    made = [_lone("missing", actor) for actor in missing] + [_lone("extra", actor) for actor in extra]
    made += [one for a, b in matched if (one := _compared(a, b, truth, found)) is not None]
    order = list(KINDS)
    return sorted(made, key=lambda one: (order.index(one.kind), one.label, one.name))


def _lone(kind: Literal["missing", "extra"], actor: Actor) -> Difference:
    name, truth = ("", actor["name"]) if kind == "missing" else (actor["name"], "")
    return Difference(kind, name, truth, actor["label"], actor["asset"])


def _matched(
    truth: Sequence[Actor], found: Sequence[Actor], pairs: Mapping[str, str]
) -> tuple[list[tuple[Actor, Actor]], list[Actor], list[Actor]]:
    """Pairs by what a verdict says, by identity, then the nearest of the same asset; and what is left of both."""
    by_name = {actor["name"]: actor for actor in found}
    by_id = {actor["id"]: actor for actor in found if actor["id"]}
    taken: set[str] = set()
    matched: list[tuple[Actor, Actor]] = []

    def take(actor: Actor, partner: Actor | None) -> bool:
        if partner is None or partner["name"] in taken:
            return False
        taken.add(partner["name"])
        matched.append((actor, partner))
        return True

    rest = [a for a in truth if a["name"] not in pairs or not take(a, by_name.get(pairs[a["name"]]))]
    alone = [actor for actor in rest if not take(actor, by_id.get(actor["id"]))]
    left = defaultdict(list)
    for actor in found:
        if actor["name"] not in taken:
            left[actor["class"], actor["asset"]].append(actor)
    near = sorted(
        (dist(actor["pose"][:3], other["pose"][:3]), place, other["name"])
        for place, actor in enumerate(alone)
        for other in left[actor["class"], actor["asset"]]
    )
    placed: set[int] = set()
    for apart, place, name in near:
        if apart <= NEAR_CM and place not in placed and take(alone[place], by_name[name]):
            placed.add(place)
    missing = [actor for place, actor in enumerate(alone) if place not in placed]
    return matched, missing, [actor for actor in found if actor["name"] not in taken]


def _compared(a: Actor, b: Actor, truth: Mapping[str, Any], found: Mapping[str, Any]) -> Difference | None:
    p, q = a["pose"], b["pose"]
    scales = list(zip(p[7:], q[7:], strict=True))
    mirrored = any(x * y < 0 for x, y in scales)
    off = dist(p[:3], q[:3])
    turned = quat_angle_deg(p[3:7], q[3:7])
    scaled = max(100 * abs(abs(y) - abs(x)) / max(abs(x), SAME_SCALE) for x, y in scales)
    other = ", ".join([*(["mirrored"] if mirrored else []), *_others(a, b, truth, found)])
    moved = off > SEEN_CM or turned > SEEN_DEG or scaled > SEEN_PCT or mirrored
    if not (moved or other):
        return None
    kind: Kind = "changed" if other and other != "mirrored" else "moved"
    return Difference(kind, b["name"], a["name"], b["label"], b["asset"], off, turned, scaled, other)


def _others(a: Actor, b: Actor, truth: Mapping[str, Any], found: Mapping[str, Any]) -> Iterator[str]:
    if a["asset"] != b["asset"] or _shown(a, truth, 0) != _shown(b, found, 0):
        yield "another mesh"
    elif _shown(a, truth, 1) != _shown(b, found, 1):
        yield "another material"
    if a.get("hidden") != b.get("hidden"):
        yield "hidden" if b.get("hidden") else "not hidden"
    if a["state"] != b["state"]:
        names = sorted(name for name in {*a["state"], *b["state"]} if a["state"].get(name) != b["state"].get(name))
        yield f"another {', '.join(names)}"


def _shown(actor: Actor, scene: Mapping[str, Any], what: Literal[0, 1]) -> list[Any]:
    """The meshes of an actor (0), or the looks of their materials (1)."""
    if what == 0:
        return [scene["meshes"][part[0]][0] for part in actor["parts"]]
    return [[scene["materials"][at] if at >= 0 else None for at in part[1]] for part in actor["parts"]]
