"""What an engine is opened with."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Required, TypedDict


class EngineInputs(TypedDict, total=False):
    """Keyword arguments of ``open_engine`` and of every backend; what each means stands there."""

    packs: Required[Sequence[Path]]
    content: Required[Path]
    scratch: Required[Path]
    levels: Sequence[Path]
    start_map: str | None
    content_read_only: bool
    offered: Sequence[str] | None
