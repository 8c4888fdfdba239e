"""How well cameras show what needs ask for, measured on actor masks, and which few of them serve all needs.

A camera shows a need as well as it shows its actors: each by its share of the picture, less where the edge cuts it, and
for a relation both sides alike. What is hidden has no pixels, so occlusion is measured by the mask itself: against the
largest area (pixels times squared distance) that any camera sees of the same actor.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from c4s.evidence.shots import Glimpse
from c4s.semantics.inventory import Array, Thing
from c4s.semantics.sight.candidates import Eye
from c4s.semantics.sight.needs import Kind, Need

CLEAR_SHARE: dict[Kind, tuple[float, float, float]] = {
    "close": (0.08, 0.02, 0.05),
    "sides": (0.06, 0.002, 0.02),
    "all": (0.02, 0.0004, 0.01),
}
"""Share of the picture from which on all actors of a need are shown wholly, and the least and the most for one of them:
a thing alone on 5 %, one of a crowd on 0.04 % (92 pixels of 640 x 360)."""
WHOLE = 0.5
"""An actor of which a camera sees at least this share of the area that the best one sees counts as not hidden."""
CUT = 0.6
"""What an actor that the edge cuts counts."""
LEAST = 0.05
"""A camera that shows a need less well than this does not show it."""
LIKE_BEST = 0.8
"""A camera serves a need that it shows at least this well, measured by the best camera for it."""
APART_DEG = 30.0
"""An alternate looks at what is needed from a direction at least this far from the primary's."""
_WEIGHT = (2.0, 1.0, 0.0)
"""Of a need by the urgency of its claims: for one that state has decided no picture is taken."""


@dataclass(frozen=True)
class Sighting:
    """A camera with what it would see."""

    eye: Eye
    pixels: int
    glimpse: Glimpse
    name: str = ""
    """Of a view that is there whatever the claims need."""

    def share(self, actor: str) -> float:
        """Share of the picture that shows an actor."""
        return float(self.glimpse["visible"].get(actor, 0)) / self.pixels


def qualities(looks: Sequence[Sighting], needs: Sequence[Need], things: Sequence[Thing]) -> Array:
    """How well each camera shows each need (cameras, needs), 0 to 1."""
    sides = [[sorted({things[n].actor for n in side}) for side in (need.subjects, need.references)] for need in needs]
    actors = {actor: place for place, actor in enumerate(sorted({a for pair in sides for side in pair for a in side}))}
    centres = _centres(needs, things, actors)
    shares = np.zeros((len(looks), len(actors)))
    uncut = np.ones((len(looks), len(actors)))
    for row, look in enumerate(looks):
        for actor, pixels in look.glimpse["visible"].items():
            if actor in actors:
                shares[row, actors[actor]] = pixels / look.pixels
        uncut[row, [actors[actor] for actor in look.glimpse["edge"] if actor in actors]] = CUT
    eyes = np.array([look.eye.place for look in looks]).reshape(-1, 1, 3)
    wide = np.array([math.tan(math.radians(look.eye.fov_deg) / 2) for look in looks])
    area = shares * ((eyes - centres) ** 2).sum(axis=2) * (wide**2)[:, None]
    whole = np.minimum(area / np.maximum(WHOLE * area.max(axis=0, initial=0.0), 1e-12), 1.0)
    open_ = np.array([1.0 - min(1.0, 2.0 * look.glimpse["near_share"]) for look in looks])
    found = np.zeros((len(looks), len(needs)))
    for column, (need, (subjects, references)) in enumerate(zip(needs, sides, strict=True)):
        together, least, most = CLEAR_SHARE[need.kind]
        clear = min(max(together / len({*subjects, *references}), least), most)
        large = whole * np.sqrt(np.minimum(shares / clear, 1.0))
        shown = [
            (large[:, rows] * (uncut[:, rows] if cut else 1.0)).mean(axis=1)
            for side, cut in ((subjects, True), (references, False))
            if (rows := [actors[actor] for actor in side])
        ]
        found[:, column] = open_ * np.sqrt(np.prod(shown, axis=0)) if len(shown) > 1 else open_ * shown[0]
    return np.round(found, 6)


def _centres(needs: Sequence[Need], things: Sequence[Thing], actors: Mapping[str, int]) -> Array:
    """The middle (actors, 3) of the things of each actor that needs name."""
    sums, number = np.zeros((len(actors), 3)), np.zeros(len(actors))
    for thing in {n for need in needs for n in need.things}:
        row = actors[things[thing].actor]
        sums[row] += things[thing].centre
        number[row] += 1
    return np.asarray(sums / np.maximum(number, 1.0)[:, None])


@dataclass
class Choice:
    """Cameras that were chosen, by number, and those of each need."""

    taken: list[int]
    """In the order of their choice, without those that are there anyway."""
    primary: list[int | None]
    alternate: list[int | None]


def choose(looks: Sequence[Sighting], quality: Array, centres: Array, urgency: Sequence[int], most: int) -> Choice:
    """A primary camera for each need and then an alternate, as few in all as serve the needs, at most ``most`` new.

    Cameras with a name are there anyway. Each choice is the camera that serves most needs which have none yet, by their
    urgency; ties go to the one that shows them better, then to the first.

    Args:
        looks: the cameras.
        quality: (cameras, needs) as ``qualities``.
        centres: (needs, 3) the middle of what each needs.
        urgency: of each need, 0 (most) to 2.
        most: how many cameras without a name may be chosen.
    """
    weight = np.array([_WEIGHT[grade] for grade in urgency])
    given = [number for number, look in enumerate(looks) if look.name]
    taken: list[int] = []
    primary = _served(quality, quality, given, taken, weight, most)
    eyes = np.array([look.eye.place for look in looks]).reshape(-1, 3)
    apart = np.zeros_like(quality)
    for need, first in enumerate(primary):
        if first is not None:
            ways = centres[need] - eyes
            ways /= np.maximum(np.linalg.norm(ways, axis=1, keepdims=True), 1e-9)
            apart[:, need] = np.degrees(np.arccos(np.clip(ways @ ways[first], -1.0, 1.0))) >= APART_DEG
    alternate = _served(quality * apart, quality, given, taken, weight, most)
    return Choice(taken, primary, alternate)


def _served(
    quality: Array, whole: Array, given: Sequence[int], taken: list[int], weight: Array, most: int
) -> list[int | None]:
    """A camera for each need; new ones are added to ``taken`` as long as there is room."""
    best = quality.max(axis=0, initial=0.0)
    serves = (quality >= LIKE_BEST * best) & (quality >= LEAST)
    here = [*given, *taken]
    missing = (best >= LEAST) & ~serves[here].any(axis=0) & (weight > 0)
    while missing.any() and len(taken) < most:
        gain = serves[:, missing] @ weight[missing] + 1e-3 * (whole @ weight) / max(float(weight.sum()), 1e-9)
        gain[here] = -1.0
        number = int(np.argmax(np.round(gain, 9)))
        taken.append(number)
        here.append(number)
        missing &= ~serves[number]
    found: list[int | None] = []
    for need in range(quality.shape[1]):
        shown = [(float(quality[number, need]), -place, number) for place, number in enumerate(here)]
        top = max(shown, default=(0.0, 0, -1))
        found.append(top[2] if top[0] >= LEAST else None)
    return found
