"""Which views a claim is shown in, from the captures; and the pictures themselves, by digest.

Views have names of their own here (``view-1`` ...): what an agent called something never reaches a model.
"""

from __future__ import annotations

import base64
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Final

from c4s.files import digest_bytes
from c4s.judge.paired.judging import readable
from c4s.records.evidence import Evidence

WHOLE_SCENE: Final = "overview"
"""Purpose of the four views of the whole scene, and of a view that names none."""


@dataclass(frozen=True)
class ClaimSight:
    """Names of the views that a claim is judged by, and what it is about."""

    primary: tuple[str, ...]
    alternate: tuple[str, ...] = ()
    targets: tuple[str, ...] = ()
    """Object names of actors; for choosing among views, never told."""
    reason: str = ""
    """Why there is no view."""


@dataclass(frozen=True)
class ShownPicture:
    """A picture as it is sent."""

    sha256: str
    url: str
    """A data URL."""


@dataclass
class Sights:
    """The captures of one submission as a judge looks at them."""

    evidence: Evidence
    captures: Mapping[str, Any]
    _pictures: dict[str, ShownPicture | None] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Index the views and claims."""
        views = [view for view in self.captures.get("views") or [] if isinstance(view, Mapping) and view.get("file")]
        self.views = {str(view["name"]): view for view in views}
        claims = self.captures.get("claims")
        self._claims: Mapping[str, Any] = claims if isinstance(claims, Mapping) else {}

    @property
    def overview(self) -> tuple[str, ...]:
        """The overview views, in their order."""
        return tuple(name for name, view in self.views.items() if view.get("purpose", WHOLE_SCENE) == WHOLE_SCENE)

    def of(self, claim: str) -> ClaimSight:
        """The views of a claim; one that nothing was photographed for is looked for in the overview."""
        row = self._claims.get(claim)
        if not isinstance(row, Mapping):
            return ClaimSight(self._seen(self.overview), reason=self._why_none())
        primary, alternate = (self._seen(row.get(name) or ()) for name in ("primary", "alternate"))
        return ClaimSight(
            primary,
            tuple(name for name in alternate if name not in primary),
            tuple(str(target) for target in row.get("targets") or ()),
            str(row.get("reason") or self._why_none()),
        )

    def best(self, sight: ClaimSight, most: int) -> tuple[str, ...]:
        """Of all views of a claim, those that show the most of what it is about, in the captures' order."""
        names = [*sight.primary, *sight.alternate]
        kept = set(sorted(names, key=lambda name: (-self._pixels(name, sight.targets), names.index(name)))[:most])
        return tuple(name for name in names if name in kept)

    def picture(self, name: str) -> ShownPicture | None:
        """The picture of a view; None for a file that is no picture."""
        if name not in self._pictures:
            png = readable(self.evidence, str(self.views[name]["file"]))
            self._pictures[name] = None if png is None else picture_of_bytes(png)
        return self._pictures[name]

    def digests(self, names: Collection[str]) -> dict[str, str]:
        """SHA-256 of the pictures of some views."""
        return {name: picture.sha256 for name in sorted(names) if (picture := self.picture(name)) is not None}

    def _seen(self, names: Sequence[Any]) -> tuple[str, ...]:
        return tuple(str(name) for name in names if str(name) in self.views and self.picture(str(name)) is not None)

    def _pixels(self, name: str, targets: Sequence[str]) -> int:
        visible = self.views[name].get("visible")
        return sum(int(visible.get(target, 0)) for target in targets) if isinstance(visible, Mapping) else 0

    def _why_none(self) -> str:
        return str(self.captures.get("not_taken") or "there is no picture to look at")


def picture_of_bytes(png: bytes) -> ShownPicture:
    """A PNG as it is sent."""
    return ShownPicture(digest_bytes(png), f"data:image/png;base64,{base64.b64encode(png).decode()}")
