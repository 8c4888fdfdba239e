"""What the four overview views show: pixels an actor, from the captures' actor masks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

SEEN_SHARE = 5e-5
"""An actor is clearly visible in a view from this share of its pixels on (46 of 1280 x 720)."""


@dataclass(frozen=True)
class Views:
    """Visible pixels of the overview views."""

    count: int
    most_share: Mapping[str, float]
    """Actor's object name to its largest share of a view's pixels."""

    def sees(self, actor: str) -> bool:
        """Whether an actor is clearly visible in at least one view."""
        return self.most_share.get(actor, 0.0) >= SEEN_SHARE


def read_views(captures: Mapping[str, Any] | None) -> Views | None:
    """Read ``captures.json``; None when it has no view with an actor mask."""
    views = captures.get("views") if isinstance(captures, Mapping) else None
    shares: dict[str, float] = {}
    count = 0
    for view in views if isinstance(views, list) else []:
        visible = view.get("visible") if isinstance(view, Mapping) else None
        if not isinstance(visible, Mapping):
            continue
        count += 1
        camera = view.get("camera") or {}
        pixels = float(camera.get("width") or 1280) * float(camera.get("height") or 720)
        for actor, number in visible.items():
            shares[actor] = max(shares.get(actor, 0.0), float(number) / pixels)
    return Views(count, shares) if count else None
