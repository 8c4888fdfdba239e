"""The pairs of views among the captures of a repair: the submission and the truth from one camera."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

TARGET, TRUTH = "target", "truth"


@dataclass(frozen=True)
class ViewPair:
    """The records of two views in ``captures.json``."""

    pair: str
    target: Mapping[str, Any]
    truth: Mapping[str, Any]


def view_pairs(captures: Mapping[str, Any]) -> tuple[list[ViewPair], str]:
    """The pairs in the order of their targets, and why there are none."""
    views = [view for view in captures.get("views") or [] if isinstance(view, Mapping)]
    truths = {str(view["pair"]): view for view in views if view.get("purpose") == TRUTH and view.get("pair")}
    targets = [view for view in views if view.get("purpose") == TARGET and view.get("pair")]
    found = [
        ViewPair(str(view["pair"]), view, truths[str(view["pair"])]) for view in targets if str(view["pair"]) in truths
    ]
    if found:
        return found, ""
    if not views:
        return [], str(captures.get("not_taken") or "no picture was taken")
    return [], "no picture of the truth was taken from the held-out cameras"
