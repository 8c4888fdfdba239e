"""What the host takes for an answer of an engine. After agent code ran in it, what it says is data like any other.

``SHAPES`` has a row for every function of ``c4s.editor`` that the host calls, and the bridge's own replies have a model
each. The host calls through ``ask``, ``ask_job`` and ``ask_picture`` alone.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, Final, Literal, TypeVar

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError

from c4s.engine.base import Calls
from c4s.engine.bridge import FAILED, BridgeFault

MOST_CHARACTERS = 1 << 20
"""Of one text in an answer to a tool."""
MOST_ROWS = 1000
"""Actors that one call may describe."""
MOST_IDS = 1 << 20

Text = Annotated[str, Field(max_length=MOST_CHARACTERS)]
Count = Annotated[int, Field(ge=0)]
Number = Annotated[float, Field(allow_inf_nan=False)]
Triple = Annotated[list[Number], Field(min_length=3, max_length=3)]
FileName = Annotated[str, Field(pattern=r"^[^/\x00]+$", max_length=200)]
Texts = Annotated[list[Text], Field(max_length=MOST_IDS)]


class WrongAnswer(BridgeFault):
    """An engine's answer is not what was asked for: the engine's fault, or that of the code which ran in it."""


class _Closed(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)


class _Open(BaseModel):
    """More keys are left to who reads them."""

    model_config = ConfigDict(extra="ignore", strict=True)


class _BuiltMesh(_Closed):
    settled: bool
    reason: Text
    kept: dict[str, Number]
    refused: Texts


class _Walk(_Closed):
    trace: list[Triple]
    left: list[Number]


class _Box(_Closed):
    origin_cm: Triple
    half_extent_cm: Triple


class _Actor(_Closed):
    label: Text
    name: Text
    class_path: Text = Field(alias="class")
    location: Triple
    rotation: Triple
    scale: Triple
    static_meshes: Texts
    bounds: _Box | None = None
    matched: list[Literal["label", "name"]] = []


class _Actors(_Closed):
    actors: Annotated[list[_Actor], Field(max_length=MOST_ROWS)]
    total: Count
    kinds: dict[Literal["classes", "meshes"], dict[Text, Count]] = {}


class _Spawned(_Closed):
    label: Text
    name: Text


class _Failed(_Closed):
    entry: Text
    error: Text


class _SpawnedMany(_Closed):
    spawned: Annotated[list[_Spawned], Field(max_length=MOST_ROWS)]
    failed: Annotated[list[_Failed], Field(max_length=MOST_ROWS)]


class _Environment(_Closed):
    added: Texts
    already_there: Texts
    turned: Texts = []


class _Standing(_Closed):
    stands: dict[Text, Texts]
    missing: Texts


class _Level(_Closed):
    package: Annotated[str, Field(pattern=r"^(/[A-Za-z0-9_-][A-Za-z0-9_.-]*)+$", max_length=1000)]
    """No segment begins with a dot: it is a place in a content folder."""
    actors: Count


class _Saved(_Level):
    doubles: Texts


class _Maker(_Open):
    engine: str
    engine_version: str


class _Snapshot(_Open):
    """As far as the host reads it before the gate does."""

    actors: list[dict[str, Any]]
    c4s: _Maker


class _IfChanged(_Closed):
    revision: int | None
    snapshot: _Snapshot | None


class _Dependencies(_Open):
    root: str
    packages: list[str]
    unresolved: list[str]


class _View(_Open):
    name: FileName
    file: FileName
    key: Annotated[str, Field(pattern="^[0-9a-f]+$", max_length=200)] | None = None
    actors: FileName | None = None
    visible: dict[str, Count] = {}


class _Glimpse(_Closed):
    visible: dict[Text, Count]
    edge: Texts
    near_share: Annotated[float, Field(ge=0, le=1)]
    empty_share: Annotated[float, Field(ge=0, le=1)]


SHAPES: Final[Mapping[str, TypeAdapter[Any]]] = {
    "scene_tools.actor_ids": TypeAdapter(Texts),
    "scene_tools.current_level": TypeAdapter(Text),
    "scene_tools.list_actors": TypeAdapter(_Actors),
    "scene_tools.find_actors": TypeAdapter(_Actors),
    "scene_tools.spawn_static_mesh": TypeAdapter(_Actor),
    "scene_tools.spawn_blueprint": TypeAdapter(_Actor),
    "scene_tools.spawn_many": TypeAdapter(_SpawnedMany),
    "scene_tools.set_transform": TypeAdapter(_Actor),
    "scene_tools.delete": TypeAdapter(_Actor),
    "scene_tools.delete_all_but": TypeAdapter(Texts),
    "scene_tools.setup_environment": TypeAdapter(_Environment),
    "scene_tools.inspect_environment": TypeAdapter(_Standing),
    "scene_tools.save_scene": TypeAdapter(_Saved),
    "scene_tools.open_level": TypeAdapter(_Level),
    "snapshot.export_if_changed": TypeAdapter(_IfChanged),
    "snapshot.export_snapshot": TypeAdapter(_Snapshot),
    "dependencies.export_dependencies": TypeAdapter(_Dependencies),
    "capture.plan_views": TypeAdapter(list[_View]),
    "capture.capture_views": TypeAdapter(list[_View]),
    "navigation.build_mesh": TypeAdapter(_BuiltMesh),
    "navigation.lattice": TypeAdapter(list[Number]),
    "navigation.components": TypeAdapter(list[int]),
    "navigation.distances": TypeAdapter(list[Number]),
    "navigation.route": TypeAdapter(list[Triple]),
    "navigation.walk": TypeAdapter(_Walk),
    "capture.probe_views": TypeAdapter(list[_Glimpse] | None),
}
M = TypeVar("M", bound=BaseModel)


class Page(_Open):
    """A part of a job's output; ``more`` of it lies behind ``next_offset`` (bytes)."""

    python_logs: list[str]
    next_offset: Count
    more: bool
    offset: Count = 0
    """Where it begins, where a part of a certain length was asked for; ``log_bytes`` is then the length of it all."""
    log_bytes: Count | None = None


class JobReply(_Open):
    """The state of a job: ``running``, done, or failed with an error."""

    status: Literal["running", "ok", "success", "partial", "error", "failed", "failure"]
    job_id: Annotated[str, Field(min_length=1, max_length=200)]
    result: Page
    error: str | None = None
    queued: bool = False
    """Whether it has not begun: another job is running."""

    @property
    def running(self) -> bool:
        """Whether it goes on."""
        return self.status == "running"

    @property
    def failed(self) -> bool:
        """Whether it ended with an error."""
        return self.status in FAILED


class _Refusal(_Open):
    status: Literal["error", "failed", "failure"]
    error: str = ""


class PictureReply(_Open):
    """Where the picture lies, or why there is none."""

    status: Literal["ok", "success", "partial", "error", "failed", "failure"]
    filepath: Annotated[str, Field(max_length=4096)] = ""
    error: str | None = None
    missing: list[str] = Field(default_factory=list)


def ask(engine: Calls, function: str, /, *, timeout_s: float = 600.0, **params: Any) -> Any:
    """Call a function of ``c4s.editor``: its value, which has the shape that ``SHAPES`` gives it, or ``WrongAnswer``.

    Else as ``Calls.call``.
    """
    value = engine.call(function, timeout_s=timeout_s, **params)
    try:
        SHAPES[function].validate_python(value)
    except ValidationError as error:
        raise WrongAnswer(_told(error), where=function) from None
    return value


def ask_job(engine: Calls, kind: str, params: Mapping[str, Any], *, timeout_s: float) -> JobReply | str:
    """A request that a job answers: the job's state, or why the engine took none."""
    reply = engine.request(kind, params, timeout_s=timeout_s)
    if "job_id" not in reply:
        return _read(_Refusal, reply, kind).error or "the editor did not take the script"
    state = _read(JobReply, reply, kind)
    if params.get("job_id", state.job_id) != state.job_id:
        raise WrongAnswer("it is of another job", where=kind)
    if state.result.more and state.result.next_offset <= params.get("offset", 0):
        raise WrongAnswer("there is more, and it lies nowhere", where=kind)
    return state


def ask_picture(engine: Calls, params: Mapping[str, Any], *, timeout_s: float) -> PictureReply:
    """A screenshot: where the engine says that it lies."""
    reply = engine.request("take_screenshot", params, timeout_s=timeout_s)
    return _read(PictureReply, reply, "take_screenshot")


def _read(model: type[M], reply: Mapping[str, Any], kind: str) -> M:
    try:
        return model.model_validate(dict(reply))
    except ValidationError as error:
        raise WrongAnswer(_told(error), where=kind) from None


def _told(error: ValidationError) -> str:
    """The first thing that is wrong, without the value: it may be anything, of any length."""
    first = error.errors(include_input=False, include_url=False, include_context=False)[0]
    place = ".".join(str(part)[:60] for part in first["loc"][:6])
    return f"not an answer: {place + ': ' if place else ''}{first['msg'][:200]}"
