"""Scenes as pages show them in three dimensions: where each actor stands, what it looks like, and each shape once."""

from __future__ import annotations

from warehouse.scenes.content import Content, content_of
from warehouse.scenes.document import document_of, packed, unpacked
from warehouse.scenes.rows import SHAPE_PARTITION, case_scenes, keep_shapes, trial_scene

__all__ = [
    "SHAPE_PARTITION",
    "Content",
    "case_scenes",
    "content_of",
    "document_of",
    "keep_shapes",
    "packed",
    "trial_scene",
    "unpacked",
]
