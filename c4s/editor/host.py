"""What the engine that hosts these scripts may offer beyond ``unreal``. Runs inside an engine.

A real editor offers nothing: the scripts then ask ``unreal`` alone. An engine that knows more registers it once, before
the first script runs.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, Protocol

from c4s.editor.facts import Reader

Camera = Mapping[str, Any]
Record = dict[str, Any]


class Pictures(Protocol):
    """Takes pictures of the open level by itself."""

    def take(self, cameras: Sequence[Camera], files: Sequence[str], mode: str, masks: bool) -> list[Record]:
        """Write a PNG a file, with ``masks`` also the file's ``.actors.npz``: ``{"visible": {actor name: pixels}}``."""
        ...

    def probe(self, cameras: Sequence[Camera]) -> list[Record]:
        """What each camera would see: ``visible``, ``edge``, ``near_share``, ``empty_share`` (``probe_views``)."""
        ...

    def keys(self, cameras: Sequence[Camera], mode: str) -> list[str]:
        """A digest a camera: pictures with masks of equal digests are the same bytes."""
        ...


class EngineHost(Protocol):
    """What an engine offers to the scripts that run in it."""

    @property
    def kind(self) -> str:
        """The kind of engine that this is."""
        ...

    @property
    def pictures(self) -> Pictures | None:
        """What takes pictures; None where a SceneCapture2D of the editor does."""
        ...

    @property
    def mesh_facts(self) -> Mapping[str, Record]:
        """What a snapshot keeps of meshes, by path, where it is known without asking the editor."""
        ...

    def reader(self) -> Reader:
        """What reads the level, for one export."""
        ...

    def revision(self) -> int | None:
        """Which state the level is in: a number that another state never has, or None where it cannot tell."""
        ...


class PlainEditor:
    """An editor that offers nothing."""

    kind = "unreal"
    pictures: Pictures | None = None
    mesh_facts: Mapping[str, Record] = MappingProxyType({})

    def reader(self) -> Reader:
        """Reads through ``unreal``."""
        return Reader()

    def revision(self) -> int | None:
        """Unknown."""
        return None


_host: EngineHost = PlainEditor()


def register(host: EngineHost) -> None:
    """Let the scripts of this process use what ``host`` offers. ``RuntimeError`` when another host has registered."""
    global _host
    if _host is not host and not isinstance(_host, PlainEditor):
        raise RuntimeError(f"{_host!r} is the host already")
    _host = host


def host() -> EngineHost:
    """What was registered, or a plain editor."""
    return _host
