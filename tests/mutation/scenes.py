"""Exported scenes, changed as a cheat would change them. Everything returns a new scene; lengths are in cm."""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterable, Sequence
from typing import Any

Scene = dict[str, Any]
Actor = dict[str, Any]
Choice = Callable[[Actor], bool]
FLAT_CM, GAP_CM = 5.0, 60.0


def scene(actors: Iterable[Actor], like: Scene) -> Scene:
    """A scene of these actors; what else a snapshot holds is that of ``like``."""
    found = [copy.deepcopy(actor) for actor in actors]
    return {**like, "actors": found, "actor_count": len(found)}


def actor_of(given: Scene, name: str) -> Actor:
    """An actor by its label."""
    return next(actor for actor in given["actors"] if actor["label"] == name)


def is_mesh(actor: Actor) -> bool:
    """Whether it shows a mesh."""
    return bool(actor["asset_path"])


def _place(actor: Actor) -> list[list[float]]:
    rows = [actor["transform"]["location_cm"], actor["bounds"]["origin_cm"]]
    return rows + [part["transform"]["location_cm"] for part in actor["c4s"]["components"] if part.get("transform")]


def shifted(actor: Actor, by: Sequence[float]) -> Actor:
    """The actor elsewhere."""
    made = copy.deepcopy(actor)
    for row in _place(made):
        row[:] = [a + b for a, b in zip(row, by, strict=True)]
    return made


def sized(actor: Actor, factor: float) -> Actor:
    """The actor of another size, its pivot where it was."""
    made = copy.deepcopy(actor)
    pivot = made["transform"]["location_cm"]
    made["transform"]["scale"] = [factor * one for one in made["transform"]["scale"]]
    box = made["bounds"]
    box["origin_cm"] = [p + factor * (o - p) for p, o in zip(pivot, box["origin_cm"], strict=True)]
    box["extent_cm"] = [factor * one for one in box["extent_cm"]]
    for part in made["c4s"]["components"]:
        if part.get("transform"):
            part["transform"]["scale"] = [factor * one for one in part["transform"]["scale"]]
    return made


def bodiless(actor: Actor) -> Actor:
    """The actor with its collision switched off."""
    made = copy.deepcopy(actor)
    made["collision"] |= {"collision_enabled": False, "collision_enabled_component_count": 0}
    made["collision"]["collision_enabled_components"] = []
    for part in made["c4s"]["components"]:
        part["collision_enabled"] = False
    return made


def unseen(actor: Actor) -> Actor:
    """The actor, hidden."""
    made = copy.deepcopy(actor)
    made["c4s"]["hidden"] = True
    made["export_diagnostics"]["hidden_in_editor"] = True
    return made


def fresh(actor: Actor, number: int, label: str = "Extra") -> Actor:
    """The actor as another one, with an identity of its own, as one that was spawned has it."""
    made = copy.deepcopy(actor)
    name = f"{label}_{number}"
    made |= {"stable_actor_id": f"sca_made_{number:032x}", "actor_guid": f"{number:032X}", "label": name, "name": name}
    made |= {"actor_path": f"{made['actor_path'].rsplit('.', 1)[0]}.{name}", "actor_origin": "generated"}
    made["actor_tags"] = [f"simcodearena.stable_actor_id={made['stable_actor_id']}"]
    return made


def made_of(actor: Actor, mesh: str, like: Actor) -> Actor:
    """The actor with the mesh of another, in the box that it had."""
    made = copy.deepcopy(like)
    for key in ("stable_actor_id", "actor_guid", "label", "name", "actor_path", "actor_origin", "actor_tags"):
        made[key] = copy.deepcopy(actor[key])
    made["asset_path"], made["component_asset_paths"] = mesh, [mesh]
    shift = [a - b for a, b in zip(actor["bounds"]["origin_cm"], made["bounds"]["origin_cm"], strict=True)]
    return shifted(made, shift)


def changed(given: Scene, choice: Choice, change: Callable[[Actor], Actor]) -> Scene:
    """The scene with a change to the actors of a choice."""
    return scene((change(one) if choice(one) else one for one in given["actors"]), given)


def without(given: Scene, choice: Choice) -> Scene:
    """The scene without the actors of a choice."""
    return scene((one for one in given["actors"] if not choice(one)), given)


def added(given: Scene, actors: Iterable[Actor]) -> Scene:
    """The scene with more actors."""
    return scene([*given["actors"], *actors], given)


def is_solid(actor: Actor) -> bool:
    """Whether it shows a mesh that is no floor."""
    return is_mesh(actor) and bool(actor["bounds"]["extent_cm"][2] > FLAT_CM)


def bottom(actor: Actor) -> float:
    """Height of its underside."""
    return float(actor["bounds"]["origin_cm"][2] - actor["bounds"]["extent_cm"][2])


def kinds(given: Scene) -> list[Actor]:
    """One actor of each asset that is no floor."""
    return list({one["asset_path"]: one for one in given["actors"] if is_solid(one)}.values())


def smallest(given: Scene) -> Actor:
    """The actor of the smallest box that is no floor."""
    return min(kinds(given), key=lambda one: (max(one["bounds"]["extent_cm"]), one["label"]))


def copies(actor: Actor, count: int, place: Sequence[float], first: int = 0) -> list[Actor]:
    """Copies of an actor on the ground, side by side along X from a place (x, y), each an actor of its own."""
    x, y, _ = actor["bounds"]["origin_cm"]
    step = 2 * max(actor["bounds"]["extent_cm"][:2]) + GAP_CM
    return [
        fresh(shifted(actor, (place[0] + step * n - x, place[1] - y, -bottom(actor))), 1000 * (first + 1) + n)
        for n in range(count)
    ]
