"""What a build notes about itself beside a suite: of which definition, what its truth loses, what was refused."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from c4s.files import read_json
from cases.admissible import Refusal

STAMP = "build.json"
"""Beside ``suite.json``: the digest of the definition that the suite was built from, and what its truth loses."""


def refused_cases(root: Path) -> list[Refusal]:
    """The made cases that were refused when the suite at ``root`` was built."""
    return [Refusal(**row) for row in read_json(root / STAMP).get("refused", [])]


def losses_of_build(root: Path) -> dict[str, Any] | None:
    """What a built suite's truth loses to physics, as its build found it; None where its build did not look."""
    found: dict[str, Any] | None = read_json(root / STAMP).get("physics_of_truth") if (root / STAMP).is_file() else None
    return found
