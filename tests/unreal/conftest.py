"""The stand-in editor, installed once for these tests; what asks for an engine of its kind gets one."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from c4s.engine.unreal.host.session import EditorSession
from tests.standin import stand_in


@pytest.fixture(scope="session")
def editor(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """The installation."""
    with stand_in(tmp_path_factory.mktemp("editor")) as root:
        yield root


@pytest.fixture
def session(editor: Path, tmp_path: Path) -> Iterator[EditorSession]:
    """An editor on an empty level."""
    content, scratch = tmp_path / "content", tmp_path / "scratch"
    with EditorSession.start("unreal-standin", packs=[], content=content, scratch=scratch) as opened:
        yield opened
