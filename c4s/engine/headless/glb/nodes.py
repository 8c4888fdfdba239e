"""The nodes of a level as glTF has them: an actor, below it its components and the actors that are attached to it.

Unreal's (x, y, z) cm is glTF's (x, z, y) / 100. Every node is written as translation, rotation and scale. An actor that
is one visible thing and holds nothing else is one node. Any other is a node of its place and rotation alone, and the
scales stand at the components below: so no node is sheared, whatever is attached to what is scaled.
"""

from __future__ import annotations

from collections import Counter, deque
from typing import TYPE_CHECKING, Any

from c4s.engine.headless.pose import Pose, conjugate, rotate
from c4s.geometry.transform import quat_multiply

if TYPE_CHECKING:
    from c4s.engine.headless.unreal.actors import Actor

_METRE_CM = 100.0
_WHOLE = (1.0, 1.0, 1.0)
Json = dict[str, Any]


class Leaf:
    """Something that an actor shows: its component's name, its world pose and what its node holds.

    ``turn`` is a rotation in glTF's axes that comes first (lights and cameras look another way there).
    """

    def __init__(self, name: str, pose: Pose, holds: Json, turn: tuple[float, float, float, float] | None = None):
        self.name, self.pose, self.holds, self.turn = name, pose, holds, turn


class NodeTree:
    """Collects what actors show and writes the nodes of it."""

    def __init__(self) -> None:
        self._shown: dict[Actor, list[Leaf]] = {}

    def add(self, actor: Actor, leaf: Leaf) -> None:
        """Something that an actor shows."""
        self._shown.setdefault(actor, []).append(leaf)

    def write(self, order: list[Actor]) -> tuple[list[Json], list[int]]:
        """The nodes, and the numbers of those that stand below the scene; actors in the given order."""
        rank = {actor: number for number, actor in enumerate(order)}
        wanted = set(self._shown)
        below: dict[Actor | None, list[Actor]] = {}
        for actor in self._shown:
            above: Actor | None = actor
            while above is not None:
                wanted.add(above)
                above = _parent_of(above)
        for actor in sorted(wanted, key=lambda actor: rank[actor]):
            below.setdefault(_parent_of(actor), []).append(actor)
        nodes: list[Json] = []
        tops: list[int] = []
        waiting: deque[tuple[Actor, Pose | None, list[int]]]
        waiting = deque((actor, None, tops) for actor in below.get(None, ()))
        while waiting:
            actor, base, owner = waiting.popleft()
            owner.append(len(nodes))
            leaves, attached = self._shown.get(actor, []), below.get(actor, [])
            if len(leaves) == 1 and not attached and leaves[0].pose.location == actor._pose().location:
                nodes.append(_node(actor.get_actor_label(), leaves[0], base))
                continue
            place = Pose(actor._pose().location, actor._pose().quat, _WHOLE)
            children: list[int] = []
            nodes.append(_node(actor.get_actor_label(), Leaf("", place, {"children": children}), base))
            same, seen = Counter(leaf.name for leaf in leaves), Counter[str]()
            for leaf in leaves:
                seen[leaf.name] += 1
                children.append(len(nodes))
                name = leaf.name if same[leaf.name] == 1 else f"{leaf.name}_{seen[leaf.name] - 1}"
                nodes.append(_node(name, leaf, place))
            waiting.extendleft((child, place, children) for child in reversed(attached))
        return nodes, tops


def _parent_of(actor: Actor) -> Actor | None:
    found: Actor | None = actor.get_attach_parent_actor()
    return found


def _node(name: str, leaf: Leaf, base: Pose | None) -> Json:
    """A node relative to an unscaled one."""
    pose = leaf.pose
    location, quat = pose.location, pose.quat
    if base is not None:
        back = conjugate(base.quat)
        away = [a - b for a, b in zip(location, base.location, strict=True)]
        location, quat = rotate(back, (away[0], away[1], away[2])), quat_multiply(back, quat)
    turned = (-quat[0], -quat[2], -quat[1], quat[3])
    if leaf.turn is not None:
        turned = quat_multiply(turned, leaf.turn)
    length = sum(part * part for part in turned) ** 0.5
    record: Json = {
        "name": name,
        "translation": [location[0] / _METRE_CM, location[2] / _METRE_CM, location[1] / _METRE_CM],
        "rotation": [part / length for part in turned],
        **leaf.holds,
    }
    if "mesh" in leaf.holds:
        record["scale"] = [pose.scale[0], pose.scale[2], pose.scale[1]]
    return record
