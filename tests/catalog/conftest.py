"""The packs of the indoor scenes, built once."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.built import built_once, built_packs


@pytest.fixture(scope="session")
def indoor_packs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    def gather(root: Path) -> None:
        for pack_id in ("c4s-office", "c4s-home"):
            shutil.copytree(built_packs(tmp_path_factory, pack_id) / pack_id, root / pack_id)

    return built_once(tmp_path_factory, "indoor-packs", gather)
