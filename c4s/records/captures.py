"""Captures: what was photographed of one submission, from where, why, and which actor each picture shows.

``evidence/captures/captures.json``. A view's purpose says who reads it: the four ``overview`` views show the whole
scene, ``claim`` views what single claims need, ``target`` and ``truth`` views a repair beside its original from one
camera, ``reference`` views a repair from the cameras that its agent knew. A camera is no evidence: that a claim has
views says nothing about whether it holds.
"""

from __future__ import annotations

from typing import Final, Literal, Self

from pydantic import Field, model_validator

from c4s.records.base import Record

Purpose = Literal["overview", "claim", "target", "truth", "reference"]
OVERVIEW: Final = "overview"
Triple = tuple[float, float, float]


class ViewCamera(Record):
    """Where a picture was taken from."""

    location_cm: Triple
    rotation_deg: Triple
    """[pitch, yaw, roll]."""
    fov_deg: float
    """Horizontal field of view."""
    width: int
    height: int
    """Pixels."""


class View(Record):
    """One picture. Its files lie beside the index."""

    name: str
    file: str
    """The PNG."""
    purpose: Purpose = OVERVIEW
    mode: str = "lit"
    camera: ViewCamera
    actors: str | None = None
    """The actor mask (npz); null where nothing could make one."""
    visible: dict[str, int] | None = None
    """Pixels of each actor that it shows, by object name; null without a mask."""
    pair: str = ""
    """The same text for a target view and the view of the truth from its camera."""


class ViewCoverage(Record):
    """How much of what a claim needs its primary views show, by their actor masks."""

    targets: int = Field(default=0, ge=0)
    """Actors that the claim needs; more than are listed where the list is a sample."""
    sought: int = Field(default=0, ge=0)
    """How many of them the views were chosen for."""
    seen: int = Field(default=0, ge=0)
    """How many of those are clearly visible in a primary view."""
    cropped: int = Field(default=0, ge=0)
    """How many of those that are seen touch the edge of every primary view that shows them."""
    share_of_picture: float = Field(default=0.0, ge=0.0, le=1.0)
    """Share of the pixels of the best primary view that show them."""


class ClaimViews(Record):
    """The views of one claim. Claims with the same targets share views."""

    primary: list[str] = Field(default_factory=list)
    """Names of views; one, or several that show the targets together."""
    alternate: list[str] = Field(default_factory=list)
    """Other sides of the same targets, for one bounded second look."""
    targets: list[str] = Field(default_factory=list)
    """Object names of the actors that the claim needs; of a large collection a sample."""
    coverage: ViewCoverage = ViewCoverage()
    reason: str = ""
    """Why there is no view; empty where there is one."""


class Captures(Record):
    """The index of a submission's pictures."""

    schema_version: Literal["c4s.captures.v1"] = "c4s.captures.v1"
    engine: str
    engine_version: str = ""
    package: str | None = None
    """The submitted level."""
    views: list[View] = Field(default_factory=list)
    claims: dict[str, ClaimViews] = Field(default_factory=dict)
    """By the id of the claim's node; only claims that sight may be needed for."""
    not_taken: str = ""
    """Why no picture was taken."""

    @model_validator(mode="after")
    def _names_are_views(self) -> Self:
        names = [view.name for view in self.views]
        if len(set(names)) != len(names):
            raise ValueError("two views have one name")
        known = set(names)
        for claim, found in self.claims.items():
            missing = [name for name in (*found.primary, *found.alternate) if name not in known]
            if missing:
                raise ValueError(f"claim {claim!r} names the view {missing[0]!r}, which is not there")
        return self

    def of(self, purpose: Purpose) -> list[View]:
        """The views of a purpose, in their order."""
        return [view for view in self.views if view.purpose == purpose]
