"""How a body can use a scene, by an engine's own navigation mesh; the editor side is ``c4s.editor.navigation``.

Only an engine that makes navigation meshes of its own is probed. The headless engine is not: the navigation verifier
measures the walkable space of what was exported, which is the same space.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from c4s.collision import scene_bodies
from c4s.engine import Engine
from c4s.engine.answers import ask
from c4s.navigation import NavigationSettings, NotBuilt, measure, settings_told
from c4s.navigation.solids import navigation_bounds
from c4s.protocol.navigation import PHASE_CM, SETTLE_LIMIT_S, SPEED_CM_S, STALL_S, STALLS
from c4s.records.navigation import NavigationEvidence

_TIMEOUT_S = 1800.0
_PATIENCE = 3.0
Array = NDArray[np.float64]


class EditorMesh:
    """The navigation mesh that an engine has built, asked over its bridge. See ``c4s.navigation.NavigationMesh``."""

    def __init__(self, engine: Engine, low: Array, high: Array) -> None:
        self._engine, self._low, self._high = engine, low, high
        self._lattices: dict[tuple[float, float], Array] = {}

    def bounds_cm(self) -> tuple[Array, Array] | None:
        """The box of all lattice points that were asked for so far; None where there is none."""
        found = [points for points in self._lattices.values() if len(points)]
        if not found:
            return None
        return np.min([points.min(axis=0) for points in found], axis=0), np.max(
            [points.max(axis=0) for points in found], axis=0
        )

    def lattice(self, pitch_cm: float, stratum_cm: float) -> Array:
        """Points of the mesh on a lattice."""
        if (pitch_cm, stratum_cm) not in self._lattices:
            told = self._ask(
                "lattice",
                low=_row(self._low),
                high=_row(self._high),
                pitch_cm=pitch_cm,
                stratum_cm=stratum_cm,
                phase_cm=PHASE_CM,
            )
            self._lattices[pitch_cm, stratum_cm] = np.array(told, dtype=float).reshape(-1, 3)
        return self._lattices[pitch_cm, stratum_cm]

    def components(self, points: Array) -> NDArray[np.int64]:
        """Which points complete paths join."""
        return np.array(self._ask("components", points=points.tolist()) if len(points) else [], dtype=np.int64)

    def distances(self, start: Array, points: Array) -> Array:
        """Lengths of paths."""
        told = np.array(self._ask("distances", start=_row(start), points=points.tolist()) if len(points) else [])
        return np.where(told < 0, np.inf, told)

    def route(self, start: Array, goal: Array) -> Array | None:
        """Corners of a path."""
        told = self._ask("route", start=_row(start), goal=_row(goal))
        return np.array(told, dtype=float) if told else None

    def _ask(self, function: str, **parameters: Any) -> Any:
        return ask(self._engine, f"navigation.{function}", timeout_s=_TIMEOUT_S, **parameters)


class EditorNavigation:
    """An engine that builds its own meshes. See ``c4s.navigation.NavigationEngine``."""

    def __init__(self, engine: Engine, bounds: tuple[Array, Array] | None, settings: NavigationSettings) -> None:
        self._engine, self._bounds, self._settings = engine, bounds, settings
        self._kept: dict[str, float] = {}

    def build(self, number: int) -> EditorMesh:
        """Write the settings, build, wait, read the settings back."""
        low, high = self._bounds or (np.zeros(3), np.zeros(3))
        high = high + np.array([0.0, 0.0, self._settings.height_cm])
        told = ask(
            self._engine,
            "navigation.build_mesh",
            timeout_s=_TIMEOUT_S,
            settings=self._settings.properties(),
            low=_row(low),
            high=_row(high),
            settle_s=SETTLE_LIMIT_S,
        )
        self._kept = settings_told(told["kept"])
        if not told["settled"]:
            raise NotBuilt("not_settled", str(told["reason"]))
        return EditorMesh(self._engine, low, high)

    def kept(self) -> dict[str, float]:
        """The settings as they were read back."""
        return self._kept

    def walk(self, route: Array) -> tuple[Array, Array]:
        """Let a capsule follow a route in the engine."""
        length = float(np.linalg.norm(np.diff(route, axis=0), axis=1).sum())
        told = ask(
            self._engine,
            "navigation.walk",
            timeout_s=_TIMEOUT_S,
            corners=route.tolist(),
            settings=self._settings.plain(),
            speed_cm_s=SPEED_CM_S,
            most_s=_PATIENCE * length / SPEED_CM_S + (STALLS + 2) * STALL_S,
        )
        return np.array(told["trace"], dtype=float), np.array(told["left"], dtype=float)


def probe_navigation(
    engine: Engine, snapshot: Mapping[str, Any], settings: NavigationSettings | None = None
) -> NavigationEvidence:
    """The measurement of the open level with the engine's own mesh; bounds and targets are of its snapshot."""
    settings = settings or NavigationSettings()
    scene = scene_bodies(snapshot)
    own = EditorNavigation(engine, navigation_bounds(scene), settings)
    return measure(snapshot, scene, own, settings, made_by="engine_mesh")


def _row(point: Sequence[float] | Array) -> list[float]:
    return [float(part) for part in point]
