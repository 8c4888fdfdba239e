"""Navigation queries. The headless engine builds no navigation mesh, so they answer as Unreal does in a level that has
none: no point can be projected or reached, every ray is blocked, and there is no path.
"""

# ruff: noqa: B008  (signatures as in Unreal; no default is ever changed)
# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from enum import unique

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.actors.volumes import NavMeshBoundsVolume
from c4s.engine.headless.unreal.containers import Array
from c4s.engine.headless.unreal.core import Class, EnumBase, Object, Prop, api, public
from c4s.engine.headless.unreal.structs import Vector


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
    """A navigation mesh in a level; there is none here."""

    _class_module = "NavigationSystem"


@public
class NavigationPath(Object):
    """A path that was found; there is none here."""

    _class_module = "NavigationSystem"
    _declares = {"path_points": Prop("Sequence[Vector]", lambda: Array._of("Vector", []))}

    @api
    def is_valid(self) -> bool:
        """Whether it leads anywhere."""
        return False

    @api
    def is_partial(self) -> bool:
        """Whether it ends before the goal."""
        return False

    @api
    def get_path_length(self) -> float:
        """Length in cm."""
        return 0.0

    @api
    def get_path_cost(self) -> float:
        """Cost."""
        return 0.0


def _tell(what: str) -> None:
    """Say why a level with a navigation volume has no navigation either."""
    if any(isinstance(actor, NavMeshBoundsVolume) for actor in world().actor_list()):
        world().log.warning(
            f"{what}: the headless engine builds no navigation mesh, so nothing is reachable; "
            "the NavMeshBoundsVolume is kept for other engines"
        )


@public
class NavigationSystemV1(Object):
    """Navigation of a level without a navigation mesh."""

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
        """Take notice of a changed volume."""
        _tell("on_navigation_bounds_updated")

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
        _tell("project_point_to_navigation")
        return None

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
        _tell("get_random_reachable_point_in_radius")
        return None

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
        _tell("get_random_location_in_navigable_radius")
        return None

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
        """Where a straight walk is stopped: at its start, for want of a navigation mesh."""
        _tell("navigation_raycast")
        return ray_start.copy()  # type: ignore[no-any-return]

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
        _tell("get_path_length")
        return NavigationQueryResult.INVALID, 0.0

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
        _tell("get_path_cost")
        return NavigationQueryResult.INVALID, 0.0

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
        _tell("find_path_to_location_synchronously")
        return None

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
        _tell("find_path_to_actor_synchronously")
        return None


_SYSTEM: NavigationSystemV1 = NavigationSystemV1._make("NavigationSystemV1_0", None)
