"""Where a session's files lie, and that an engine may see them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from c4s.engine.inputs import EngineInputs
from c4s.errors import BadInput, MachineryFault

_WITHHELD = "withheld"


@dataclass(frozen=True)
class SessionPlaces:
    """What an engine is opened with, and where its logs go: paths that are real, and may be shown to it."""

    packs: list[Path]
    content: Path
    scratch: Path
    levels: list[Path]
    logs: Path
    start_map: str | None
    content_read_only: bool
    offered: Sequence[str] | None


def session_places(given: EngineInputs) -> SessionPlaces:
    """The places of a session. ``BadInput`` for what is not there, ``MachineryFault`` for logs within the engine's
    reach and for withheld files."""
    scratch = given["scratch"].resolve()
    made = SessionPlaces(
        packs=[path.resolve() for path in given["packs"]],
        content=given["content"].resolve(),
        scratch=scratch,
        levels=[path.resolve() for path in given.get("levels", ())],
        logs=scratch.with_name(f"{scratch.name}.logs"),
        start_map=given.get("start_map"),
        content_read_only=given.get("content_read_only", False),
        offered=given.get("offered"),
    )
    _check_places(made.packs, made.levels, made.content, made.scratch, made.logs)
    return made


def _check_places(packs: Sequence[Path], levels: Sequence[Path], content: Path, scratch: Path, logs: Path) -> None:
    for pack in packs:
        if not (pack / "pack.json").is_file():
            raise BadInput("no asset pack here", where=str(pack), todo="build it with `c4s catalog build`")
    for level in levels:
        if not level.is_file():
            raise BadInput("no such level file", where=str(level))
    if logs.is_relative_to(content):
        raise MachineryFault("the engine's logs would lie in its content, where it could change them", where=str(logs))
    for path in (*packs, *levels, content, scratch):
        if _WITHHELD in path.parts:
            raise MachineryFault("withheld files are never shown to an engine that may run agent code", where=str(path))
