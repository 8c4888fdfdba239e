"""What the pictures show of an actor's colour: its pixels by the actor masks, in the views that show most of it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from c4s.errors import BadInput
from c4s.judge.paired.measures import mask_arrays, picture_of
from c4s.protocol.words import tokens
from c4s.records.evidence import Evidence
from c4s.semantics.inventory import Array
from c4s.semantics.shades import SHADES, shades_of, to_shades

Owners: TypeAlias = NDArray[np.int32]
VIEWS: Final = 3
"""Views of an actor that are looked at: those that show most of it."""
LEAST_PIXELS: Final = 60
"""With fewer pixels in a view an actor has no colour there."""
SURE_SHARE, NO_SHARE = 0.2, 0.03
"""Share of an actor's pixels that must be of a colour for a yes; share of possible ones under which it is a no."""


class ActorColors:
    """Colours of actors in the pictures of one submission; each picture is read once."""

    def __init__(self, evidence: Evidence) -> None:
        self._evidence = evidence
        captures = evidence.json("captures")
        self._views = [view for view in captures.get("views") or [] if _is_masked(view)]
        self._read: dict[str, tuple[Array, Owners, dict[str, int]]] = {}
        self._shades: dict[str, Array | None] = {}

    def shows(self, actor: str, words: str) -> bool | None:
        """Whether an actor shows the colour that the words name; None where no picture tells.

        A colour of which an actor has a part, and more of another, may be that of its windows or its roof: None.
        """
        asked = [found for word in tokens(words) if (found := shades_of(word)) is not None]
        shades = self._of(actor) if len(asked) == 1 else None
        if shades is None:
            return None
        possible = asked[0].hold(shades, slack=1.0)
        if possible.mean() < NO_SHARE:
            return False
        sure, others = asked[0].hold(shades).sum(), shades[~possible]
        if sure < SURE_SHARE * len(shades) or any(shade.hold(others).sum() > sure for shade in SHADES.values()):
            return None
        return True

    def _of(self, actor: str) -> Array | None:
        """Shades (n, 3) of the pixels of an actor in the views that show most of it."""
        if actor not in self._shades:
            ranked = sorted(self._views, key=lambda view: -int(view["visible"].get(actor, 0)))
            best = [view for view in ranked[:VIEWS] if int(view["visible"].get(actor, 0)) >= LEAST_PIXELS]
            found = [pixels for view in best if len(pixels := self._pixels(view, actor))]
            self._shades[actor] = to_shades(np.concatenate(found)) if found else None
        return self._shades[actor]

    def _pixels(self, view: Mapping[str, Any], actor: str) -> Array:
        """Colours (n, 3) of an actor's pixels in a view."""
        name = str(view["name"])
        if name not in self._read:
            png, npz = (self._evidence.beside_captures(str(view[part])) for part in ("file", "actors"))
            self._read[name] = picture_of(png, str(view["file"])), *_owners(npz, str(view["actors"]))
        picture, owners, rows = self._read[name]
        if picture.shape[:2] != owners.shape:
            raise BadInput("this picture and its actor mask are not of one size", where=str(view["file"]))
        if actor not in rows:
            return np.empty((0, 3))
        return np.asarray(picture[owners == rows[actor]])


def _owners(npz: bytes, where: str) -> tuple[Owners, dict[str, int]]:
    """The number of the actor at each pixel, and the numbers by object name."""
    actor, names = mask_arrays(npz, where, "actor", "names")
    return actor, {str(name): number for number, name in enumerate(names)}


def _is_masked(view: Any) -> bool:
    if not isinstance(view, Mapping) or not isinstance(view.get("visible"), Mapping):
        return False
    return isinstance(view.get("actors"), str) and isinstance(view.get("file"), str)
