"""What scripts of these tests work on; they use the older static functions too, which warn their caller."""

from __future__ import annotations

from types import ModuleType

import pytest

from c4s.engine.headless.editor import world
from c4s.engine.headless.process.boot import boot


def pytest_configure(config):
    config.addinivalue_line("filterwarnings", "ignore:Function '.*' on '.*' is deprecated:DeprecationWarning")


@pytest.fixture(scope="module")
def unreal(tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    """The module, without packs."""
    return boot([], tmp_path_factory.mktemp("unreal"))


@pytest.fixture
def empty_level(unreal: ModuleType) -> None:
    world().new_map()


@pytest.fixture
def actors(unreal: ModuleType):
    return unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
