"""The small case of the toolbox tests."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "toolbox"))


@pytest.fixture(scope="session")
def pack(tmp_path_factory: pytest.TempPathFactory) -> Path:
    from made_case import make_pack

    return make_pack(tmp_path_factory.mktemp("packs"))
