"""A shared compiled-kernel cache for the tests of the engine process, and engines started from nothing but a folder."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from c4s.engine.confine.confinement import Backend
from c4s.engine.confine.sandbox import faults
from c4s.engine.headless.host.session import EngineSession
from c4s.files import write_json


def backends() -> list[object]:
    """Every sandbox; one that this machine lacks is skipped with the reason."""
    return [
        pytest.param(name, marks=pytest.mark.skipif(fault is not None, reason=f"{name}: {fault}"))
        for name, fault in faults().items()
    ]


@pytest.fixture(params=backends())
def backend(request: pytest.FixtureRequest) -> Backend:
    """A sandbox of this machine."""
    name: Backend = request.param
    return name


@pytest.fixture
def engine(tmp_path: Path) -> Iterator[EngineSession]:
    """An engine without packs on an empty level, for this test alone."""
    with EngineSession.start(packs=[], content=tmp_path / "content", scratch=tmp_path / "scratch") as session:
        yield session


@pytest.fixture(scope="module")
def shared_engine(tmp_path_factory: pytest.TempPathFactory) -> Iterator[EngineSession]:
    """An engine for all tests of a module that leave it alive."""
    root = tmp_path_factory.mktemp("shared")
    with EngineSession.start(packs=[], content=root / "content", scratch=root / "scratch") as session:
        yield session


@pytest.fixture
def level(tmp_path: Path) -> Path:
    """A level with a cube on a plane and a sphere that hangs."""
    path = tmp_path / "given" / "start.level.json"
    path.parent.mkdir()
    shapes = [
        ("Floor", "Plane", (0, 0, 0), (20, 20, 1)),
        ("Box", "Cube", (0, 0, 50), (1, 1, 1)),
        ("Ball", "Sphere", (0, 200, 300), (1, 1, 1)),
    ]
    write_json(
        path,
        {
            "schema_version": "c4s.level.v1",
            "package": "/Game/Start/Room",
            "actors": [
                {
                    "name": f"StaticMeshActor_{number}",
                    "label": label,
                    "class_path": "/Script/Engine.StaticMeshActor",
                    "guid": f"{number:032X}",
                    "transform": {"location_cm": place, "scale": scale},
                    "components": [
                        {
                            "name": "StaticMeshComponent0",
                            "class_path": "/Script/Engine.StaticMeshComponent",
                            "static_mesh": f"/Engine/BasicShapes/{mesh}.{mesh}",
                        }
                    ],
                }
                for number, (label, mesh, place, scale) in enumerate(shapes)
            ],
        },
    )
    return path
