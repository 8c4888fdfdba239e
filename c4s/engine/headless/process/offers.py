"""What this engine offers to the editor's scripts: its own reading of actors, pictures, and a number for the state."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any

from c4s.editor.facts import Reader
from c4s.engine.headless.pictures.keys import picture_keys
from c4s.engine.headless.pictures.take import probe, take
from c4s.engine.headless.process.facts import DirectReader
from c4s.engine.headless.process.revision import revision


class HeadlessPictures:
    """Pictures by ray tracing, with masks, and keys of what they depend on."""

    def take(
        self, cameras: Sequence[Mapping[str, Any]], files: Sequence[str], mode: str, masks: bool
    ) -> list[dict[str, Any]]:
        """Render the open level from ``cameras`` into PNG files."""
        return take(cameras, files, mode, masks)

    def probe(self, cameras: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
        """What each camera would see of the open level."""
        return probe(cameras)

    def keys(self, cameras: Sequence[Mapping[str, Any]], mode: str) -> list[str]:
        """A digest of all that the picture of each camera depends on."""
        return picture_keys(cameras, mode)


class HeadlessHost:
    """The offer of this process: of whatever world it has at the time."""

    kind = "headless"
    pictures = HeadlessPictures()
    mesh_facts: Mapping[str, Any] = MappingProxyType({})
    """None: its ``unreal`` tells them of every mesh."""

    def reader(self) -> Reader:
        """Reads the engine's own state."""
        return DirectReader()

    def revision(self) -> int | None:
        """The number of the level's state, if nothing can change it unseen."""
        return revision()


HOST = HeadlessHost()
