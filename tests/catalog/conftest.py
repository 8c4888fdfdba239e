"""The packs of the indoor scenes, built once."""

from __future__ import annotations

from pathlib import Path

import pytest

from catalog.build import build_starter
from tests.built import built_once


@pytest.fixture(scope="session")
def indoor_packs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built_once(tmp_path_factory, "indoor-packs", lambda root: build_starter(root, ["c4s-office", "c4s-home"]))
