"""What a clean engine is asked to photograph: cameras that are given, or a plan that looks before it chooses."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeAlias

from c4s.records.captures import ClaimViews, View

Snapshot: TypeAlias = dict[str, Any]
Camera: TypeAlias = Mapping[str, Any]
"""As in ``c4s.editor.capture``, with a name of its own; ``purpose`` and ``pair`` are those of the view's record."""
Glimpse: TypeAlias = Mapping[str, Any]
"""What a camera would see: ``visible``, ``edge``, ``near_share``, ``empty_share`` (``c4s.render.masks.glimpse``)."""
Probe: TypeAlias = Callable[[Sequence[Camera]], Sequence[Glimpse]]
"""A glimpse a camera. They need ``rotation_deg``; nothing is written."""


@dataclass(frozen=True)
class Taken:
    """A picture that is there already, with its mask, in a folder."""

    view: View
    folder: Path


@dataclass(frozen=True)
class Shots:
    """The cameras that were chosen, and what they are for."""

    cameras: Sequence[Camera]
    claims: Mapping[str, ClaimViews] = field(default_factory=dict)
    """Views of each claim, by the names of these cameras."""
    taken: Sequence[Taken] = ()
    """Pictures that are put beside those of the cameras."""


Cameras: TypeAlias = Sequence[Camera] | Callable[[Snapshot, Probe], Shots]
"""Cameras, or a plan: a function of the snapshot and of a probe."""
