"""The packs of the indoor scenes, built once."""

from __future__ import annotations

from pathlib import Path

import pytest

from catalog.build import build_starter


@pytest.fixture(scope="session")
def indoor_packs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    root = tmp_path_factory.mktemp("packs")
    build_starter(root, ["c4s-office", "c4s-home"])
    return root
