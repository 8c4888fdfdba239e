"""What the four overview views show: pixels an actor, from the captures' actor masks."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from c4s.records.captures import OVERVIEW
from c4s.semantics.inventory import Thing

SEEN_SHARE = 5e-5
"""A thing is clearly visible in a view from this share of its pixels on (47 of 1280 x 720)."""


@dataclass(frozen=True)
class Views:
    """Visible pixels of the overview views."""

    count: int
    room: Mapping[str, int]
    """Actor's object name to how many things its pixels have room for: in each view one a clearly visible share."""

    def sees(self, actor: str) -> bool:
        """Whether an actor is clearly visible in at least one view."""
        return self.room.get(actor, 0) > 0

    def seen(self, things: Sequence[Thing]) -> list[Thing]:
        """The things that count as clearly visible, in their order.

        Masks tell actors apart, not the components and instances of one. So of an actor's things no more count than its
        pixels have room for; those with the largest boxes do.
        """
        shown = [place for place, thing in enumerate(things) if self.sees(thing.actor)]
        sizes = [float(np.prod(things[place].high - things[place].low)) for place in shown]
        taken: Counter[str] = Counter()
        kept = set()
        for _, place in sorted(zip(sizes, shown, strict=True), key=lambda row: (-row[0], row[1])):
            actor = things[place].actor
            if taken[actor] < self.room[actor]:
                taken[actor] += 1
                kept.add(place)
        return [things[place] for place in shown if place in kept]


def read_views(captures: Mapping[str, Any] | None) -> Views | None:
    """Read ``captures.json``; None when it has no view with an actor mask."""
    views = captures.get("views") if isinstance(captures, Mapping) else None
    room: Counter[str] = Counter()
    count = 0
    for view in views if isinstance(views, list) else []:
        visible = view.get("visible") if isinstance(view, Mapping) else None
        if not isinstance(visible, Mapping) or view.get("purpose", OVERVIEW) != OVERVIEW:
            continue
        count += 1
        camera = view.get("camera") or {}
        pixels = float(camera.get("width") or 1280) * float(camera.get("height") or 720)
        for actor, number in visible.items():
            room[actor] += int(float(number) / pixels / SEEN_SHARE)
    return Views(count, room) if count else None
