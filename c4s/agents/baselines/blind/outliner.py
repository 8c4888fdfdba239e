"""Tricks by what the editor notes of an actor: ids, names, numbers, folders, tags, order, components."""

from __future__ import annotations

import hashlib
import re
import uuid
from collections import Counter
from collections.abc import Callable, Hashable, Iterator
from itertools import pairwise

from c4s.agents.baselines.blind.guess import Guess
from c4s.agents.baselines.blind.scene import SeenActor, SeenLevel

NAMESPACE = uuid.uuid5(uuid.NAMESPACE_URL, "https://simworld.ai/SimCodeArena/stable-actor-id/v1")
RARE = 0.04
"""What at most this share of a scene's things have is odd."""
FEW = 3


def _odd(
    scene: SeenLevel, trick: str, of: Callable[[SeenActor], Hashable], chance: float = 0.9, *, rare: float = RARE
) -> Iterator[Guess]:
    """Delete the few things of which something is told that is told of hardly any other."""
    counts = Counter(map(of, scene.things))
    odd = [thing for thing in scene.things if counts[of(thing)] <= max(1, rare * len(scene.things))]
    if 0 < len(odd) <= FEW and len(counts) <= FEW + 1:
        for thing in odd:
            yield Guess(thing.name, "delete", trick, chance / len(odd))


def recomputed_ids(scene: SeenLevel) -> Iterator[Guess]:
    """Ids of the published scheme can be worked out; an actor whose id does not follow from its name was put there."""
    words = {word for word in re.split(r"[/_.]", scene.package) if word} | {scene.package, *scene.package.split("/")}
    for word in sorted(words):
        wrong = []
        for thing in scene.things:
            text = f"v1|source|{word}|{thing.name}|{thing.class_path}"
            if not thing.stable_id.endswith(uuid.uuid5(NAMESPACE, text).hex):
                wrong.append(thing)
        if len(wrong) < len(scene.things) / 2:
            for thing in wrong:
                yield Guess(thing.name, "delete", "recomputed ids", 0.95)


def recomputed_guids(scene: SeenLevel) -> Iterator[Guess]:
    """A guid that is the digest of its actor's id, where others are not."""
    same = [
        thing
        for thing in scene.things
        if hashlib.md5(thing.stable_id.encode(), usedforsecurity=False).hexdigest().upper() == thing.guid
    ]
    if 0 < len(same) < len(scene.things) / 2:
        for thing in same:
            yield Guess(thing.name, "delete", "recomputed guids", 0.9)


def other_ids(scene: SeenLevel) -> Iterator[Guess]:
    """An id of another form, or none."""
    yield from _odd(scene, "another form of id", lambda t: (len(t.stable_id), re.sub("[0-9a-f]{8,}", "", t.stable_id)))
    yield from _odd(scene, "another form of guid", lambda t: (len(t.guid), t.guid.isupper()))


def folders(scene: SeenLevel) -> Iterator[Guess]:
    """No folder where others have one; a folder unlike that of all that is near; one thing of a mesh elsewhere."""
    yield from _odd(scene, "another folder", lambda t: bool(t.folder))
    foreign = [t for row, t in enumerate(scene.things) if all(o.folder != t.folder for o in scene.nearest(row, 5))]
    if len({t.folder for t in scene.things}) > 1:
        for thing in foreign:
            yield Guess(thing.name, "delete", "a folder unlike its neighbours'", 0.6 / (1 + len(foreign)))


def tags_and_components(scene: SeenLevel) -> Iterator[Guess]:
    """Tags, component names, flags that hardly any other actor has."""
    yield from _odd(scene, "other tags", lambda t: t.tags)
    yield from _odd(scene, "another component", lambda t: t.component)
    yield from _odd(scene, "a label that is not the name", lambda t: t.label == t.name)


def names(scene: SeenLevel) -> Iterator[Guess]:
    """The form of names, their numbers, and names after another mesh than the one that is shown."""
    yield from _odd(scene, "another form of name", lambda t: (t.name.startswith(("SM_", "BP_")), t.number is None))
    yield from _odd(scene, "another width of number", lambda t: bool(re.search(r"_\d$", t.name)))
    loose = [t for of in scene.of_stem.values() if len(of) > 2 for t in [_last_after_gap(of)] if t is not None]
    for thing in loose:
        yield Guess(thing.name, "delete", "a number that does not follow", 0.5 / (1 + len(loose)))
    called = {mesh: Counter(t.stem for t in of).most_common(1)[0][0] for mesh, of in scene.of_mesh.items()}
    after = {stem: Counter(t.mesh for t in of).most_common(1)[0] for stem, of in scene.of_stem.items()}
    wrong = [t for t in scene.things if called[t.mesh] != t.stem or after[t.stem][0] != t.mesh]
    for thing in wrong:
        yield Guess(thing.name, "mesh", "a name after another mesh", 0.8 / len(wrong), mesh=after[thing.stem][0])
    plain = {re.sub(r"^(SM|BP)_", "", mesh.rpartition(".")[2]): mesh for mesh in scene.of_mesh}
    for thing in scene.things:
        own = re.sub(r"^(SM|BP)_", "", thing.stem)
        if own in plain and plain[own] != thing.mesh:
            yield Guess(thing.name, "mesh", "a name after another mesh", 0.9, mesh=plain[own])


def _last_after_gap(things: list[SeenActor]) -> SeenActor | None:
    numbered = sorted((t.number, t) for t in things if t.number is not None)
    if len(numbered) < 3 or any(b[0] - a[0] != 1 for a, b in pairwise(numbered[:-1])):
        return None
    return numbered[-1][1] if numbered[-1][0] - numbered[-2][0] != 1 else None


def order(scene: SeenLevel) -> Iterator[Guess]:
    """In a list that is sorted by what things are, one that stands apart from its like, or at the very end."""
    things = scene.things
    alone = [
        t
        for before, t, behind in zip(things, things[1:], things[2:], strict=False)
        if len(scene.of_mesh[t.mesh]) > 1 and t.mesh not in (before.mesh, behind.mesh) and before.mesh == behind.mesh
    ]
    runs = sum(a.mesh != b.mesh for a, b in pairwise(things))
    if things and runs < len(things) / 2:
        for thing in alone:
            yield Guess(thing.name, "delete", "out of order", 0.7 / len(alone))
        yield Guess(things[-1].name, "delete", "last in the list", 0.15)


def paint(scene: SeenLevel) -> Iterator[Guess]:
    """One thing of a mesh without the materials that all its like have, or with some that none of them has."""
    for things in scene.of_mesh.values():
        counts = Counter(t.materials for t in things)
        odd = [t for t in things if counts[t.materials] == 1]
        if len(things) > 2 and len(odd) == 1:
            yield Guess(odd[0].name, "delete", "other materials than its like", 0.5)
