"""What an agent can see of a case tells nothing of how it was made: names, ids, outliner and order of its levels.

All of it is drawn from a secret, which is the digest of what the suite is built from: who has that has the truth too.
Every actor of every level goes the same way, whether it was there, was changed or was put there by a recipe.
"""

from __future__ import annotations

import hashlib
import hmac
import math
import random
import re
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence

from c4s.records.level import Level, LevelActor, Vector
from cases.corruption import SOURCE_TAG, STABLE_ID_TAG, id_of, meshes
from cases.recipe import Expected, Operation, SpawnActor

SPARE = 1.6
"""Numbers of one name are drawn from this many times as many as there are actors of it, so that gaps mean nothing."""
_NUMBERED = re.compile(r"(.*?)_?(\d+)")


class Veil:
    """Draws names and ids of a suite from its secret; the same secret, the same bytes."""

    def __init__(self, secret: str) -> None:
        self._secret = secret.encode()

    def drawn(self, *key: str) -> str:
        """64 hexadecimal digits."""
        return hmac.new(self._secret, "\x00".join(key).encode(), hashlib.sha256).hexdigest()

    def alias(self, case_id: str) -> str:
        """What a case is called where an agent can see it."""
        return f"case-{self.drawn('alias', case_id)[:10]}"

    def start_map(self, case_id: str) -> str:
        """Package of a case's start level."""
        return f"/Game/Levels/Level_{self.drawn('alias', case_id)[:10]}"

    def chance(self, scene_id: str) -> random.Random:
        """A source of chance for a scene."""
        return random.Random(self.drawn("chance", scene_id))

    def over(self, scene_id: str, original: Level) -> SceneVeil:
        """The veil of a scene's levels."""
        return SceneVeil(self, scene_id, original)

    def scene(self, scene_id: str, levels: Sequence[Level]) -> Iterator[Level]:
        """The levels of a scene under their veil, the original first."""
        over = self.over(scene_id, levels[0])
        yield from map(over.level, levels)

    def id_of(self, scene_id: str, stable_id: str) -> str:
        """The id under which an actor of a scene is shown."""
        return f"sca_source_{self.drawn('id', scene_id, stable_id)[:32]}"

    def operations(self, scene_id: str, operations: Sequence[Operation], level: Level) -> list[Operation]:
        """A recipe that speaks of the veiled levels; ``level`` is the corrupted one."""
        named = {id_of(actor): actor.name for actor in level.actors}
        told: list[Operation] = []
        for operation in operations:
            if isinstance(operation, SpawnActor):
                shown = self.id_of(scene_id, operation.stable_id)
                like = operation.like
                changes = {
                    "stable_id": shown,
                    "object_name": named[shown],
                    "label": named[shown],
                    "expect": Expected(like=self.id_of(scene_id, like)) if like else operation.expect,
                }
            else:
                changes = {"target": self.id_of(scene_id, operation.target)}
            told.append(operation.model_copy(update=changes))
        return told


class SceneVeil:
    """The veil over the levels of one scene: an actor has one name and one id in all of them."""

    def __init__(self, veil: Veil, scene_id: str, original: Level) -> None:
        self._veil, self._scene_id = veil, scene_id
        self._names = _Names(original, veil.chance(f"{scene_id}|names"))
        self._places = {id_of(actor): actor.transform.location_cm for actor in original.actors}

    def level(self, level: Level) -> Level:
        """A level of the scene under its veil."""
        scene_id, drawn = self._scene_id, self._veil.drawn
        named = {actor.name: self._names.of(actor) for actor in level.actors}
        folders = _Folders(self._places, level)
        veiled = [
            actor.model_copy(
                update={
                    "name": named[actor.name],
                    "label": named[actor.name],
                    "guid": drawn("guid", scene_id, key)[:32].upper(),
                    "tags": self._tags(actor, key),
                    "folder": folders.of(actor),
                    "parent": named.get(actor.parent, actor.parent) if actor.parent else None,
                }
            )
            for actor in level.actors
            for key in [id_of(actor) or actor.name]
        ]
        ranks = {actor.guid: drawn("order", scene_id, actor.guid) for actor in veiled}
        return level.model_copy(update={"actors": sorted(veiled, key=lambda actor: ranks[actor.guid])})

    def _tags(self, actor: LevelActor, key: str) -> list[str]:
        own = [tag for tag in actor.tags if not tag.startswith(STABLE_ID_TAG) and tag != SOURCE_TAG]
        return [*own, STABLE_ID_TAG + self._veil.id_of(self._scene_id, key), SOURCE_TAG]


class _Names:
    """Names of a scene's actors: what they are called after, and a number that tells nothing."""

    def __init__(self, original: Level, chance: random.Random) -> None:
        self._chance = chance
        stems: dict[str, Counter[str]] = defaultdict(Counter)
        for actor in original.actors:
            for mesh in meshes(actor)[:1]:
                stems[mesh][_stem(actor)] += 1
        self._after_mesh = {mesh: found.most_common(1)[0][0] for mesh, found in stems.items()}
        self._shown = {id_of(actor): meshes(actor)[:1] for actor in original.actors}
        self._plain = bool(stems) and not any(actor.label.startswith(("SM_", "BP_")) for actor in original.actors)
        self._padded = any(re.search(r"_0\d", actor.name) for actor in original.actors)
        self._count = Counter(_stem(actor) for actor in original.actors)
        self._free: dict[str, list[int]] = {}
        self._given: dict[tuple[str | None, str], str] = {}

    def of(self, actor: LevelActor) -> str:
        """The actor's name: that of its like where it shows another mesh than in the original."""
        shown = meshes(actor)[:1]
        known = self._shown.get(id_of(actor))
        stem = _stem(actor) if known == shown or not shown else self._stem_of(shown[0])
        key = (id_of(actor), stem)
        if key not in self._given:
            number = self._numbers(stem).pop()
            self._given[key] = f"{stem}_{number:0{2 if self._padded else 1}d}"
        return self._given[key]

    def _stem_of(self, mesh: str) -> str:
        if mesh in self._after_mesh:
            return self._after_mesh[mesh]
        stem = mesh.rsplit(".", 1)[-1].removesuffix("_C")
        return stem.removeprefix("SM_").removeprefix("BP_") if self._plain else stem

    def _numbers(self, stem: str) -> list[int]:
        """The numbers that are still to be given, in the order in which they are."""
        if not self._free.get(stem):
            taken = sum(key[1] == stem for key in self._given)
            count = math.ceil(SPARE * (self._count[stem] + 4))
            self._free[stem] = self._chance.sample(range(taken * 2 + 1, taken * 2 + 1 + count), count)
        return self._free[stem]


def _stem(actor: LevelActor) -> str:
    """What an actor is called after, without its number."""
    numbered = _NUMBERED.fullmatch(actor.label)
    return re.sub(r"[^A-Za-z0-9_-]", "_", numbered[1] if numbered and numbered[1] else actor.label)


class _Folders:
    """The outliner folder of what stands nearest, for an actor that is new or stands elsewhere than in the original."""

    def __init__(self, places: Mapping[str | None, Vector], level: Level) -> None:
        self._places = places
        """Of the original's actors by stable id."""
        self._stayed = [one for one in level.actors if self._in_place(one) and meshes(one)]

    def of(self, actor: LevelActor) -> str:
        """The folder of an actor of the level."""
        if self._in_place(actor):
            return actor.folder
        place = actor.transform.location_cm
        near = [one for one in self._stayed if one.name != actor.name]
        return min(near, key=lambda one: math.dist(one.transform.location_cm, place)).folder if near else ""

    def _in_place(self, actor: LevelActor) -> bool:
        return self._places.get(id_of(actor)) == actor.transform.location_cm
