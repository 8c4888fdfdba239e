"""Tables of what pages show besides numbers: calls, claims, pictures, scenes. Models are their columns."""

from __future__ import annotations

from typing import Literal

from c4s.records.base import Record
from warehouse.trial_key import TrialKey


class CallRow(TrialKey):
    """Table ``calls``: one row a tool call of an attempt at a public case, as the agent sent it and was answered.

    Long texts are cut (``warehouse.calls``); their whole lengths stand beside them. What looks like a key is left out.
    """

    attempt: int
    """1 or 2."""
    recorded: bool
    """Whether the attempt is the trial's recorded run."""
    call: int
    """Number of the tool call in the attempt, from 1."""
    tool: str
    """Name of the tool, as it was called."""
    polling: bool
    """Whether it asked for the state of a job."""
    outcome: str
    """``ok``, ``error``, ``ended``, ``fault``; ``unfinished`` where its process ended first."""
    error: str
    """What the agent was told of a call that gave nothing."""
    start_s: float | None
    """Since the attempt began."""
    duration_s: float | None
    """From its start to its answer."""
    arguments: str
    """As JSON, without the script."""
    arguments_characters: int
    """Before it was cut."""
    script: str
    """The Python that it sent; empty for other tools."""
    script_characters: int
    """Before it was cut."""
    answer: str
    """The text that the agent received."""
    answer_characters: int
    """Before it was cut."""
    screenshots: str
    """Views of the pictures that it was answered with (``pictures``, role ``screenshot``), separated by blanks."""
    calls_left: int | None
    """Of the budget, after it."""
    seconds_left: float | None
    """Of the budget, after it."""


class ClaimRow(TrialKey):
    """Table ``claims``: what the judge said of one requirement of a public case, and what it was shown."""

    claim: str
    """Id of its node in the requirement bundle."""
    text: str
    """The words of the prompt that it stands for."""
    kind: str
    """Type of the predicate."""
    scored: bool
    """False for one that scored claims are made of."""
    answer: str
    """``MATCH``, ``MISMATCH``, ``UNKNOWN``, ``NOT_EVALUATED``, ``ERROR``."""
    score: float
    """Share of it that holds; 0 where it is not decided."""
    confidence: float | None
    """As the model told; null for a rule."""
    reason: str
    """In the judge's words."""
    stage: str
    """How it was settled: by ``state``, ``sight``, ``alternate`` views, ``arbitration``, or ``combined`` of others."""
    fallback: bool
    """Whether it is unknown because a model broke the contract of its answer twice."""
    asked: str
    """Purposes of the requests to a model that it was part of, in their order, separated by blanks."""
    shown: str
    """Views that the judge was shown (``pictures``), separated by blanks."""
    cited: str
    """Those of them that it says it saw it in."""
    primary: str
    """Views that were taken for it."""
    alternate: str
    """Views of other sides, for one second look."""
    targets: int
    """Actors that it needs."""
    seen: int | None
    """How many of those that it rests on are clearly visible in a view."""


class PictureRow(TrialKey):
    """Table ``pictures``: what the case pages show, as JPEG.

    Of private cases only start, truth and submission. ``claim`` pictures show what single requirements need, ``target``
    and ``target_truth`` a repair and its truth from the same held-out cameras, ``screenshot`` what an agent was shown.
    """

    role: Literal["start", "truth", "submission", "claim", "target", "target_truth", "screenshot"]
    """``start`` and ``truth`` are of the case, the others of the trial."""
    view: str
    """Name of the camera."""
    width: int
    """At most what pages show."""
    height: int
    """In the proportion of the picture that was taken."""
    jpeg: bytes
    """The file."""
    brightness: float | None = None
    """Mean of its grey values, in [0, 1]."""


class SceneRow(TrialKey):
    """Table ``scenes``: scenes of public cases as the pages draw them."""

    role: Literal["start", "truth", "submission"]
    """``start`` and ``truth`` are of the case, ``submission`` of the trial."""
    actors: int
    """How many there are."""
    views: str
    """Cameras of the evidence as JSON: name, purpose, place (cm), rotation (pitch, yaw, roll, degrees), angle of view
    (degrees), size (pixels)."""
    document: bytes
    """Raw deflate of JSON: actors with their poses, meshes and materials (``warehouse/scenes/document.py``)."""
    snapshot_sha256: str
    """Of the snapshot that it was made of."""


class ShapeRow(Record):
    """Table ``shapes``: the meshes and textures that ``scenes`` name, each once a suite."""

    suite: str
    """Name of the suite."""
    configuration: str
    """``_shapes``: they belong to packs."""
    shape_sha256: str
    """Of the file in its pack."""
    kind: Literal["mesh", "texture"]
    """What it is."""
    path: str
    """An asset, or a material, that shows it."""
    triangles: int
    """0 for a texture."""
    data: bytes
    """A mesh as ``warehouse/scenes/shapes.py`` says; a texture as JPEG or PNG of at most 256 pixels a side."""
