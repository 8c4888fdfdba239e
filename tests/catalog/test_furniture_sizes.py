"""A furniture catalogue that any user can install, whose entries state true sizes."""

from __future__ import annotations

import zipfile
from pathlib import Path

import pytest

from bench.content import content

LIBRARY = Path("/usr/share/sweethome3d/furniture/Reallusion.sh3f")


@pytest.mark.skipif(not LIBRARY.is_file(), reason="Debian's sweethome3d-furniture is not installed")
def test_furniture_is_as_large_as_its_catalogue_says(tmp_path: Path) -> None:
    with zipfile.ZipFile(LIBRARY) as packed:
        packed.extractall(tmp_path)
    row = content(tmp_path, scale=0.01)
    assert row.assets == row.files
    assert row.near >= 0.98 * row.sized > 0
