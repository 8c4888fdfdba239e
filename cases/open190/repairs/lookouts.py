"""Where reference views are taken from: places with free air, at the height of eyes or above, that see much."""

from __future__ import annotations

import math
import random
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Final

import numpy as np

from c4s.evidence import Tracer
from c4s.render import Picture
from c4s.render.masks import glimpse
from cases.admissible import FULL
from cases.generate import SoundThing
from cases.model import CaseView
from cases.open190.brought import AnyPlace, BroughtPlace
from cases.open190.eyes import block, views
from cases.open190.repairs.plan import Environment
from cases.views import camera

WIDTH, HEIGHT = 320, 180
"""Size of the pictures that are traced to choose: each pixel stands for 16."""
TRIED, KEPT = 110, 24
NEAR_SHARE, EMPTY_SHARE = 0.02, 0.34
SCREEN_SHARE, SCREEN_NEARER, SCREEN_RISE_CM = 1 / 3, 0.8, 80.0
"""A thing that takes so much of a picture, nearer than so much of the way to what is shown and so far above where that
stands, is a screen: a roof under the eye, the leg of a crane. A floor is not above it, a wall behind is not nearer."""
DISTANCE_CM: Final[Mapping[Environment, tuple[float, float]]] = {"indoor": (230.0, 620.0), "outdoor": (380.0, 1500.0)}
EYE_CM: Final[Mapping[Environment, tuple[float, float]]] = {"indoor": (140.0, 235.0), "outdoor": (165.0, 620.0)}
AIR_CM = 35.0
APART_DEG, APART_CM = 30.0, 160.0
"""Two reference views of a case, and the views of two cases, differ by one of these at least."""
SIDES = 3
"""The second view is one of so many."""
LEAST_SHOWN = 650
"""Of 1280 x 720: what shows less is not chosen as a target."""


@dataclass(frozen=True)
class Lookout:
    """A view, and what of it can be used: pixels (of 1280 x 720) of each thing that is wholly inside the picture."""

    view: CaseView
    pixels: Mapping[str, int]
    picture: Picture

    def apart(self, other: Lookout) -> bool:
        """Whether two views are of two places, or look two ways."""
        return _angle(self.view, other.view) >= APART_DEG or _distance(self.view, other.view) >= APART_CM


def lookouts(
    place: AnyPlace, environment: Environment, things: Mapping[str, SoundThing], tracer: Tracer, chance: random.Random
) -> list[Lookout]:
    """Views of a scene that show many of some things, the best first.

    Args:
        place: the scene as it was laid out.
        environment: decides how near and how high the eyes are.
        things: what may be changed, by name.
        tracer: of the scene as it is, with its actors by those names.
        chance: where places are drawn from.
    """
    found = []
    for view in [*_named(place), *_drawn(place, environment, things, chance)]:
        picture = tracer.picture(_small(view), samples=1)
        told = glimpse(picture, tracer.names)
        if told["near_share"] > NEAR_SHARE or told["empty_share"] > EMPTY_SHARE:
            continue
        shown = _usable(told, things)
        if shown and not screened(view, picture, [tracer.names.index(name) for name in shown]):
            found.append(Lookout(view, shown, picture))
    found.sort(key=lambda one: -_worth(one, things))
    kept: list[Lookout] = []
    for one in found:
        if len(kept) < KEPT and all(one.apart(other) for other in kept):
            kept.append(one)
    return kept


def traced(tracer: Tracer, view: CaseView) -> Picture:
    """A small picture of a view without light."""
    return tracer.picture(_small(view), samples=1)


def screened(view: CaseView, picture: Picture, shown: Collection[int]) -> bool:
    """Whether one thing takes a large part of a picture before the things of some numbers."""
    mask, depth = picture.actor, picture.depth_cm
    pitch = math.radians(float(camera(view)["rotation_deg"][0]))
    rows, columns = mask.shape
    up = (1 - (2 * np.arange(rows) + 1) / rows) * math.tan(math.radians(view.fov_deg) / 2) * rows / columns
    height = depth * (math.sin(pitch) + up[:, None] * math.cos(pitch))
    theirs = np.isin(mask, list(shown))
    far, foot = float(np.median(depth[theirs])), float(np.median(height[theirs]))
    for number, count in zip(*np.unique(mask[mask >= 0], return_counts=True), strict=True):
        if count < SCREEN_SHARE * mask.size or number in shown:
            continue
        own = mask == number
        if np.median(depth[own]) < SCREEN_NEARER * far and np.median(height[own]) > foot + SCREEN_RISE_CM:
            return True
    return False


def second(first: Lookout, pool: Sequence[Lookout], wanted: Collection[str], chance: random.Random) -> Lookout | None:
    """A view from another side: one of those that show most of the wanted things; None where none shows any."""
    sides = [
        (len(shown), number)
        for number, one in enumerate(pool)
        if _angle(first.view, one.view) >= APART_DEG and (shown := [name for name in wanted if name in one.pixels])
    ]
    best = sorted(sides, reverse=True)[:SIDES]
    return pool[chance.choice(best)[1]] if best else None


def _named(place: AnyPlace) -> list[CaseView]:
    """The cameras of whoever laid the scene out, without the one above all."""
    if isinstance(place, BroughtPlace):
        return []
    return [replace(view, width=1280, height=720) for view in views(place)[1:]]


def _drawn(
    place: AnyPlace, environment: Environment, things: Mapping[str, SoundThing], chance: random.Random
) -> list[CaseView]:
    names = sorted(things)
    found: list[CaseView] = []
    for number in range(4 * TRIED):
        if len(found) == TRIED or not names:
            break
        x, y, z = things[chance.choice(names)].origin
        turn, far = chance.uniform(0, 2 * math.pi), chance.uniform(*DISTANCE_CM[environment])
        low, high = EYE_CM[environment]
        eye = low + (high - low) * chance.random() ** 2
        spot = (round(x + far * math.cos(turn), 1), round(y + far * math.sin(turn), 1), round(max(eye, z + 40), 1))
        aim = (round(x, 1), round(y, 1), round(z, 1))
        seen_from = not isinstance(place, BroughtPlace) or place.may_look_from(spot[0], spot[1])
        if seen_from and place.space.free([block(*spot, AIR_CM)]):
            found.append(CaseView(f"drawn-{number:03d}", spot, aim, round(chance.uniform(56, 72), 1)))
    return found


def _small(view: CaseView) -> dict[str, Any]:
    return {**camera(view), "width": WIDTH, "height": HEIGHT}


def _usable(told: Mapping[str, Any], things: Mapping[str, SoundThing]) -> dict[str, int]:
    """Pixels of the things that a picture shows wholly and large enough."""
    each = FULL // (WIDTH * HEIGHT)
    edge = set(told["edge"])
    return {
        name: count * each
        for name, count in sorted(told["visible"].items())
        if name in things and name not in edge and count * each >= LEAST_SHOWN
    }


def _worth(one: Lookout, things: Mapping[str, SoundThing]) -> float:
    """How many things a view shows, and how many kinds of them."""
    kinds = len({things[name].mesh for name in one.pixels})
    return min(len(one.pixels), 30) + 1.5 * min(kinds, 14)


def _angle(one: CaseView, other: CaseView) -> float:
    """Between two ways of looking, degrees."""
    a, b = (np.subtract(view.target_cm, view.location_cm) for view in (one, other))
    cosine = float(a @ b / (np.linalg.norm(a) * np.linalg.norm(b)))
    return math.degrees(math.acos(max(-1.0, min(1.0, cosine))))


def _distance(one: CaseView, other: CaseView) -> float:
    return math.dist(one.location_cm, other.location_cm)
