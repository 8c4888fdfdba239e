"""What a pack says of its Unreal content: which engine saved it, and which files each asset needs."""

from __future__ import annotations

from pathlib import PurePosixPath
from typing import Literal

from pydantic import Field

from c4s.names import InnerPath, PackagePath
from c4s.records.base import Record

UNREAL_FOLDER = PurePosixPath("unreal")
"""In a pack: ``content.json`` and, below ``Content``, what lies in a project's ``Content`` folder."""
CONTENT_FILE, CONTENT_FOLDER = UNREAL_FOLDER / "content.json", UNREAL_FOLDER / "Content"


class UnrealContent(Record):
    """``unreal/content.json`` of a pack. It and all files below ``unreal/Content`` are in the pack's list of files."""

    schema_version: Literal["c4s.unreal-content.v1"] = "c4s.unreal-content.v1"
    engine: str = Field(pattern=r"^\d+\.\d+(-standin)?$")
    """The engine that saved the packages: ``5.6``; an older one's are opened by a newer, never the other way round."""
    needs: dict[PackagePath, list[InnerPath]]
    """Files below ``Content`` by the path of each asset of the pack: its own package and all that this refers to."""
