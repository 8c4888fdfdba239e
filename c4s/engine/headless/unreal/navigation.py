"""Navigation: the mesh of a level with a ``NavMeshBoundsVolume``.

As in an editor that updates navigation by itself, the first volume brings the level's ``RecastNavMesh`` with it, and
the mesh is there when a script first asks for it; it is built anew when a setting of the ``RecastNavMesh`` has changed
since, on ``RebuildNavigation`` and on ``on_navigation_bounds_updated``, and not by itself when actors move: an editor
does that between scripts. Without a volume no point can be projected or reached, every ray is blocked, and there is no
path.
"""

# ruff: noqa: B008  (signatures as in Unreal; no default is ever changed)
# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from enum import unique
from typing import TYPE_CHECKING, Any

import numpy as np

from c4s.engine.headless.editor import world
from c4s.engine.headless.pose import IDENTITY
from c4s.engine.headless.queries import walkable
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.actors.volumes import NAVIGATION_DATA, NavMeshBoundsVolume
from c4s.engine.headless.unreal.containers import Array
from c4s.engine.headless.unreal.core import Class, EnumBase, Object, Prop, api, public
from c4s.engine.headless.unreal.structs import Vector

if TYPE_CHECKING:
    from c4s.navigation import NavigationSettings

_EXTENT = np.array([50.0, 50.0, 250.0])
"""Where paths and rays look for the mesh around a place: the default extent of a query in Unreal."""


@public
@unique
class NavigationQueryResult(EnumBase):
    """How a path query ended."""

    INVALID = 0
    ERROR = 1
    FAIL = 2
    SUCCESS = 3


@public
class NavigationData(Actor):
    """A navigation mesh in a level."""

    _class_module = "NavigationSystem"


@public
class RecastNavMesh(NavigationData):
    """The navigation mesh of a level: who walks, and how fine it is."""

    _class_module = "NavigationSystem"
    _declares = {
        "agent_radius": Prop("float", 34.0, attribute=False),
        "agent_height": Prop("float", 144.0, attribute=False),
        "agent_max_slope": Prop("float", 44.0, attribute=False),
        "agent_max_step_height": Prop("float", 35.0),
        "cell_size": Prop("float", 19.0),
        "cell_height": Prop("float", 10.0),
        "tile_size_uu": Prop("float", 1000.0, attribute=False),
        "min_region_area": Prop("float", 0.0, attribute=False),
        "merge_region_size": Prop("float", 400.0, attribute=False),
        "max_simplification_error": Prop("float", 1.3, attribute=False),
    }


@public
class NavigationPath(Object):
    """A path that was found."""

    _class_module = "NavigationSystem"
    _declares = {"path_points": Prop("Sequence[Vector]", lambda: Array._of("Vector", []))}
    _complete = False
    _length = 0.0

    @classmethod
    def _found(cls, corners: Any, complete: bool) -> NavigationPath:
        made: NavigationPath = cls._make("NavigationPath_0", None)
        made._complete = complete
        made._length = float(np.linalg.norm(np.diff(corners, axis=0), axis=1).sum())
        made.set_editor_property("path_points", [_vector(point) for point in corners])
        return made

    @api
    def is_valid(self) -> bool:
        """Whether it leads anywhere."""
        return len(self.get_editor_property("path_points")) > 0

    @api
    def is_partial(self) -> bool:
        """Whether it ends before the goal."""
        return self.is_valid() and not self._complete

    @api
    def get_path_length(self) -> float:
        """Length in cm."""
        return self._length

    @api
    def get_path_cost(self) -> float:
        """Cost: the length, since all areas cost the same."""
        return self._length


def rebuild() -> None:
    """Build the mesh of the open level, as ``RebuildNavigation`` does; without a bounds volume nothing is built."""
    boxes = [_box(volume) for volume in _volumes()]
    if not boxes:
        world().log.warning("RebuildNavigation: the level has no NavMeshBoundsVolume, so there is nothing to build")
        return
    low, high = np.min([box[0] for box in boxes], axis=0), np.max([box[1] for box in boxes], axis=0)
    why = walkable.build(low, high, _settings(_data()))
    if why:
        world().log.warning(f"the navigation mesh is not built: {why}")


def _volumes() -> list[NavMeshBoundsVolume]:
    return [actor for actor in world().actor_list() if isinstance(actor, NavMeshBoundsVolume)]


_last: RecastNavMesh | None = None
"""The navigation data of the last question: thousands of questions look for it once."""


def _data() -> RecastNavMesh:
    """The level's navigation data; one whose volume brought none gets it now."""
    global _last
    if _last is None or _last._dead:
        found = next((actor for actor in world().actor_list() if isinstance(actor, RecastNavMesh)), None)
        _last = world().spawn(NAVIGATION_DATA, IDENTITY, "RecastNavMesh-Default") if found is None else found
    return _last


def _settings(data: RecastNavMesh) -> NavigationSettings:
    from c4s.navigation import NavigationSettings

    own = data.get_editor_property
    return NavigationSettings(
        radius_cm=own("agent_radius"),
        height_cm=own("agent_height"),
        slope_deg=own("agent_max_slope"),
        step_cm=own("agent_max_step_height"),
        min_region_area=own("min_region_area"),
        cell_cm=max(own("cell_size"), 1.0),
        cell_height_cm=max(own("cell_height"), 1.0),
    )


def _box(volume: NavMeshBoundsVolume) -> tuple[Any, Any]:
    origin, extent = volume.get_actor_bounds(False)
    return _array(origin) - _array(extent), _array(origin) + _array(extent)


def _array(vector: Vector) -> Any:
    return np.array([vector.x, vector.y, vector.z], dtype=float)


def _vector(point: Any) -> Vector:
    return Vector(*(float(part) for part in point))


def _mesh() -> walkable.LevelMesh | None:
    """The mesh with the settings that the level has now; None without a volume, or where it cannot be built."""
    known = _last is not None and not _last._dead
    if (known or _volumes()) and not walkable.is_of(_settings(_data())) and _volumes():
        rebuild()
    return walkable.mesh()


def _route(start: Vector, end: Vector) -> tuple[Any, bool] | None:
    found = _mesh()
    return None if found is None else found.route(_array(start), _array(end), _EXTENT)


def _length(start: Vector, end: Vector) -> tuple[NavigationQueryResult, float]:
    found = _route(start, end)
    if found is None:
        return NavigationQueryResult.INVALID, 0.0
    result = NavigationQueryResult.SUCCESS if found[1] else NavigationQueryResult.FAIL
    return result, NavigationPath._found(*found).get_path_length()


@public
class NavigationSystemV1(Object):
    """Navigation of the open level."""

    _class_module = "NavigationSystem"

    @classmethod
    @api
    def get_navigation_system(cls, world_context_object: Object | None) -> NavigationSystemV1 | None:
        """The navigation system of the world."""
        return _SYSTEM if world_context_object is not None else None

    @classmethod
    @api
    def is_navigation_being_built(cls, world_context_object: Object | None) -> bool:
        """Nothing is ever being built."""
        return False

    @classmethod
    @api
    def is_navigation_being_built_or_locked(cls, world_context_object: Object | None) -> bool:
        """Nothing is ever being built."""
        return False

    @api
    def on_navigation_bounds_updated(self, nav_volume: NavMeshBoundsVolume | None) -> None:
        """Take notice of a changed volume: the mesh is built."""
        rebuild()

    @classmethod
    @api
    def project_point_to_navigation(
        cls,
        world_context_object: Object | None,
        point: Vector,
        nav_data: NavigationData | None,
        filter_class: Class | type | None,
        query_extent: Vector = Vector(),
    ) -> Vector | None:
        """The nearest point that can be walked on, or None."""
        found = _mesh()
        extent = _array(query_extent)
        there = None if found is None else found.project(_array(point), extent if extent.any() else _EXTENT)
        return None if there is None else _vector(there)

    @classmethod
    @api
    def get_random_reachable_point_in_radius(
        cls,
        world_context_object: Object | None,
        origin: Vector,
        radius: float,
        nav_data: NavigationData | None = None,
        filter_class: Class | type | None = None,
    ) -> Vector | None:
        """A point that can be walked to, or None."""
        found = _mesh()
        there = None if found is None else found.random_near(_array(origin), float(radius), reachable=True)
        return None if there is None else _vector(there)

    @classmethod
    @api
    def get_random_location_in_navigable_radius(
        cls,
        world_context_object: Object | None,
        origin: Vector,
        radius: float,
        nav_data: NavigationData | None = None,
        filter_class: Class | type | None = None,
    ) -> Vector | None:
        """A point that can be walked on, or None."""
        found = _mesh()
        there = None if found is None else found.random_near(_array(origin), float(radius), reachable=False)
        return None if there is None else _vector(there)

    @classmethod
    @api
    def get_random_point_in_navigable_radius(
        cls,
        world_context_object: Object | None,
        origin: Vector,
        radius: float,
        nav_data: NavigationData | None = None,
        filter_class: Class | type | None = None,
    ) -> Vector | None:
        """A point that can be walked on, or None (deprecated twin)."""
        return cls.get_random_location_in_navigable_radius(world_context_object, origin, radius)

    @classmethod
    @api
    def navigation_raycast(
        cls,
        world_context_object: Object | None,
        ray_start: Vector,
        ray_end: Vector,
        filter_class: Class | type | None = None,
        querier: Object | None = None,
    ) -> Vector | None:
        """Where a straight walk is stopped: at its start where there is no mesh."""
        found = _mesh()
        if found is None:
            return ray_start.copy()  # type: ignore[no-any-return]
        return _vector(found.straight(_array(ray_start), _array(ray_end), _EXTENT))

    @classmethod
    @api
    def get_path_length(
        cls,
        world_context_object: Object | None,
        path_start: Vector,
        path_end: Vector,
        nav_data: NavigationData | None = None,
        filter_class: Class | type | None = None,
    ) -> tuple[NavigationQueryResult, float]:
        """Result and length (cm) of a path."""
        return _length(path_start, path_end)

    @classmethod
    @api
    def get_path_cost(
        cls,
        world_context_object: Object | None,
        path_start: Vector,
        path_end: Vector,
        nav_data: NavigationData | None = None,
        filter_class: Class | type | None = None,
    ) -> tuple[NavigationQueryResult, float]:
        """Result and cost of a path."""
        return _length(path_start, path_end)

    @classmethod
    @api
    def find_path_to_location_synchronously(
        cls,
        world_context_object: Object | None,
        path_start: Vector,
        path_end: Vector,
        pathfinding_context: Actor | None = None,
        filter_class: Class | type | None = None,
    ) -> NavigationPath | None:
        """A path, or None."""
        found = _route(path_start, path_end)
        return None if found is None else NavigationPath._found(*found)

    @classmethod
    @api
    def find_path_to_actor_synchronously(
        cls,
        world_context_object: Object | None,
        path_start: Vector,
        goal_actor: Actor | None,
        tether_distance: float = 50.0,
        pathfinding_context: Actor | None = None,
        filter_class: Class | type | None = None,
    ) -> NavigationPath | None:
        """A path to an actor, or None."""
        if goal_actor is None:
            return None
        found = _route(path_start, goal_actor.get_actor_location())
        return None if found is None else NavigationPath._found(*found)


_SYSTEM: NavigationSystemV1 = NavigationSystemV1._make("NavigationSystemV1_0", None)
