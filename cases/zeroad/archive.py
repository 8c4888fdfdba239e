"""The archive of a mod of 0 A.D. (``public.zip``): its files by name, each beside or instead of its cached form."""

from __future__ import annotations

import io
import zipfile
from functools import cached_property
from pathlib import Path
from types import TracebackType
from typing import Self
from xml.etree.ElementTree import Element, ParseError, fromstring

from PIL import Image, UnidentifiedImageError

from c4s.errors import BadInput

MOST_BYTES = 64_000_000
"""No file of a map, a mesh or a texture is larger."""


class Archive:
    """An open archive."""

    def __init__(self, path: Path) -> None:
        self.path = path
        try:
            self._zip = zipfile.ZipFile(path)
        except (zipfile.BadZipFile, OSError) as error:
            raise BadInput(f"this archive cannot be read: {error}", where=str(path)) from None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self._zip.close()

    @cached_property
    def names(self) -> frozenset[str]:
        """The files in it."""
        return frozenset(self._zip.namelist())

    @cached_property
    def terrains(self) -> list[str]:
        """The files that tell what terrains look like."""
        return sorted(name for name in self.names if name.startswith("art/terrains/") and name.endswith(".xml"))

    def data(self, name: str) -> bytes:
        """The bytes of a file; ``BadInput`` where there is none."""
        if name not in self.names:
            raise BadInput(f"no file {name!r} in the archive", where=str(self.path))
        if self._zip.getinfo(name).file_size > MOST_BYTES:
            raise BadInput(f"{name!r} is too large", where=str(self.path))
        try:
            return self._zip.read(name)
        except (zipfile.BadZipFile, OSError, EOFError) as error:
            raise BadInput(f"{name!r} cannot be read: {error}", where=str(self.path)) from None

    def xml(self, name: str) -> Element:
        """The root of an XML file; one with a document type is refused."""
        data = self.data(name)
        if b"<!DOCTYPE" in data or b"<!ENTITY" in data:
            raise BadInput("XML with a document type is not read", where=name)
        try:
            return fromstring(data)
        except ParseError as error:
            raise BadInput(f"this is no XML: {error}", where=name) from None

    def mesh(self, name: str) -> bytes:
        """The bytes of the PMD of a mesh that an actor names as it was before it was cached (``x.dae``)."""
        name = f"art/meshes/{name}"
        return self.data(f"{name}.cached.pmd" if f"{name}.cached.pmd" in self.names else name)

    def picture(self, name: str) -> Image.Image:
        """A texture under ``art/textures``, with its transparency."""
        name = f"art/textures/{name}"
        told = next((one for one in (f"{name}.cached.dds", name) if one in self.names), name)
        try:
            picture = Image.open(io.BytesIO(self.data(told)))
            picture.load()
        except (UnidentifiedImageError, OSError, ValueError, NotImplementedError) as error:
            raise BadInput(f"this texture cannot be read: {error}", where=told) from None
        return picture.convert("RGBA")
