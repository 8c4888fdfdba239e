"""Static function libraries and module functions: system, gameplay, mathematics, paths, logging, loading."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence
from types import TracebackType
from typing import Any

from c4s.engine.headless.pose import rotate
from c4s.engine.headless.state import world
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.asset_tools import load
from c4s.engine.headless.unreal.assets import MaterialInstanceDynamic, MaterialInterface
from c4s.engine.headless.unreal.components import SceneComponent
from c4s.engine.headless.unreal.containers import Array, Name, Text
from c4s.engine.headless.unreal.core import Class, Object, api, as_class, public, subclass_of
from c4s.engine.headless.unreal.enums import DrawDebugTrace, MIDCreationFlags, TraceTypeQuery
from c4s.engine.headless.unreal.paths import Paths
from c4s.engine.headless.unreal.structs import LinearColor, Rotator, Transform, Vector
from c4s.engine.headless.unreal.subobjects import SubobjectDataSubsystem
from c4s.engine.headless.unreal.subsystems import SUBSYSTEMS, EditorSubsystem
from c4s.engine.headless.unreal.traces import HitResult, line_hits
from c4s.scene.transform import look_at, quat_from_rotator

ENGINE_VERSION = "5.6.0-c4s.headless"


@public
class SystemLibrary(Object):
    """System functions."""

    @classmethod
    @api
    def get_engine_version(cls) -> str:
        """Version of the API that this engine follows."""
        return ENGINE_VERSION

    @classmethod
    @api
    def execute_console_command(cls, world_context_object: Object | None, command: str,
                                specific_player: Object | None = None) -> None:
        """Console commands are logged and have no effect here."""
        world().log.display(f"Cmd: {command} (console commands have no effect in the headless engine)")

    @classmethod
    @api
    def collect_garbage(cls) -> None:
        """Memory is freed by itself."""

    @classmethod
    @api
    def get_object_name(cls, object: Object | None) -> str:
        """Object name."""
        return object.get_name() if object is not None else ""

    @classmethod
    @api
    def get_display_name(cls, object: Object | None) -> str:
        """Label of an actor, name of anything else."""
        if isinstance(object, Actor):
            return object.get_actor_label()
        return object.get_name() if object is not None else ""

    @classmethod
    @api
    def get_path_name(cls, object: Object | None) -> str:  # type: ignore[override]
        """Object path."""
        return object.get_path_name() if object is not None else ""

    @classmethod
    @api
    def is_valid(cls, object: Any) -> bool:
        """Whether an object exists and was not destroyed."""
        return isinstance(object, Object) and not object._dead

    @classmethod
    @api
    def get_component_bounds(cls, component: SceneComponent) -> tuple[Vector, Vector, float]:
        """World AABB of a component (centre, half extent) and its sphere's radius, in cm."""
        local = component._local_bounds()
        if local is None:
            return component.get_world_location(), Vector(), 0.0
        origin, extent = component._world_pose().box(*local)
        return Vector(*origin), Vector(*extent), math.hypot(*extent)

    @classmethod
    @api
    def line_trace_single(cls, world_context_object: Object | None, start: Vector, end: Vector,
                          trace_channel: TraceTypeQuery, trace_complex: bool, actors_to_ignore: Sequence[Actor],
                          draw_debug_type: DrawDebugTrace, ignore_self: bool = True,
                          trace_color: LinearColor = LinearColor(1, 0, 0, 1),  # noqa: B008
                          trace_hit_color: LinearColor = LinearColor(0, 1, 0, 1),  # noqa: B008
                          draw_time: float = 5.0) -> HitResult | None:
        """First hit along a line on the triangles of meshes with collision, or None. Nothing is drawn."""
        hits = line_hits(start, end, list(actors_to_ignore))
        return hits[0] if hits else None

    @classmethod
    @api
    def line_trace_multi(cls, world_context_object: Object | None, start: Vector, end: Vector,
                         trace_channel: TraceTypeQuery, trace_complex: bool, actors_to_ignore: Sequence[Actor],
                         draw_debug_type: DrawDebugTrace, ignore_self: bool = True,
                         trace_color: LinearColor = LinearColor(1, 0, 0, 1),  # noqa: B008
                         trace_hit_color: LinearColor = LinearColor(0, 1, 0, 1),  # noqa: B008
                         draw_time: float = 5.0) -> Array | None:
        """Hits along a line up to the first that blocks (every mesh blocks), or None."""
        hits = line_hits(start, end, list(actors_to_ignore))
        return Array._of("HitResult", hits[:1]) if hits else None

    @classmethod
    @api
    def quit_editor(cls) -> None:
        """Refused: the engine is ended by whoever started it."""
        world().log.error("QuitEditor: the headless engine is ended by the harness, not by a script")

    @classmethod
    @api
    def get_project_directory(cls) -> str:
        """Folder of the project."""
        return Paths.project_dir()

    @classmethod
    @api
    def get_project_content_directory(cls) -> str:
        """Folder of the content."""
        return Paths.project_content_dir()


@public
class GameplayStatics(Object):
    """Searches in the level."""

    @classmethod
    @api
    def get_all_actors_of_class(cls, world_context_object: Object | None, actor_class: Class | type) -> Array:
        """Actors of a class."""
        wanted = as_class(actor_class)
        found = [a for a in world().actor_list()
                 if (a._class() is wanted if wanted._blueprint else isinstance(a, wanted._python_type))]
        return Array._of("Actor", found)

    @classmethod
    @api
    def get_actor_of_class(cls, world_context_object: Object | None, actor_class: Class | type) -> Actor | None:
        """The first actor of a class, or None."""
        found = cls.get_all_actors_of_class(world_context_object, actor_class)
        return found[0] if len(found) else None

    @classmethod
    @api
    def get_all_actors_with_tag(cls, world_context_object: Object | None, tag: Name | str) -> Array:
        """Actors with a tag."""
        return Array._of("Actor", [a for a in world().actor_list() if a.actor_has_tag(tag)])


@public
class MathLibrary(Object):
    """Mathematics."""

    @classmethod
    @api
    def find_look_at_rotation(cls, start: Vector, target: Vector) -> Rotator:
        """Rotation that turns +X from ``start`` towards ``target``."""
        return Rotator._of(look_at(start._triple(), target._triple()))

    @classmethod
    @api
    def get_forward_vector(cls, rot: Rotator) -> Vector:
        """Image of +X."""
        return rot.get_forward_vector()

    @classmethod
    @api
    def get_right_vector(cls, rot: Rotator) -> Vector:
        """Image of +Y."""
        return rot.get_right_vector()

    @classmethod
    @api
    def get_up_vector(cls, rot: Rotator) -> Vector:
        """Image of +Z."""
        return rot.get_up_vector()

    @classmethod
    @api
    def compose_rotators(cls, a: Rotator, b: Rotator) -> Rotator:
        """``a`` first, then ``b``."""
        return a.combine(b)

    @classmethod
    @api
    def compose_transforms(cls, a: Transform, b: Transform) -> Transform:
        """``a`` first, then ``b``."""
        return a.multiply(b)

    @classmethod
    @api
    def greater_greater_vector_rotator(cls, a: Vector, b: Rotator) -> Vector:
        """``a`` turned by ``b``."""
        return Vector(*rotate(quat_from_rotator(b._triple()), a._triple()))

    @classmethod
    @api
    def vector_distance(cls, v1: Vector, v2: Vector) -> float:
        """Distance in cm."""
        return v1.distance(v2)

    @classmethod
    @api
    def degrees_to_radians(cls, a: float) -> float:
        """Degrees as radians."""
        return math.radians(a)

    @classmethod
    @api
    def lerp(cls, a: float, b: float, alpha: float) -> float:
        """Linear mix."""
        return a + (b - a) * alpha

    @classmethod
    @api
    def v_lerp(cls, a: Vector, b: Vector, alpha: float) -> Vector:
        """Linear mix of vectors."""
        return a.lerp_to(b, alpha)

    @classmethod
    @api
    def make_rot_from_x(cls, x: Vector) -> Rotator:
        """Rotation that turns +X into a direction."""
        return x.rotator()

    @classmethod
    @api
    def conv_rotator_to_vector(cls, rot: Rotator) -> Vector:
        """Image of +X."""
        return rot.get_forward_vector()

    @classmethod
    @api
    def transform_location(cls, t: Transform, location: Vector) -> Vector:
        """World place of a local point."""
        found: Vector = t.transform_location(location)
        return found

    @classmethod
    @api
    def random_float_in_range(cls, min: float, max: float) -> float:
        """A number between two, from Python's generator (``random.seed`` repeats it)."""
        return random.uniform(min, max)

    @classmethod
    @api
    def random_integer_in_range(cls, min: int, max: int) -> int:
        """A whole number between two, both included, from Python's generator."""
        return random.randint(min, max)


@public
class MaterialLibrary(Object):
    """Dynamic material instances without an owner."""

    @classmethod
    @api
    def create_dynamic_material_instance(cls, world_context_object: Object | None, parent: MaterialInterface,
                                         optional_name: Name | str = "None",
                                         creation_flags: MIDCreationFlags = MIDCreationFlags.NONE
                                         ) -> MaterialInstanceDynamic:
        """A transient instance."""
        name = "MaterialInstanceDynamic_0" if str(optional_name) == "None" else str(optional_name)
        made: MaterialInstanceDynamic = MaterialInstanceDynamic._owned(name, None, parent)
        return made


@public
class ScopedEditorTransaction:
    """A named edit; undo is not modelled."""

    def __init__(self, desc: str | Text) -> None:
        if not isinstance(desc, (str, Text)):
            raise TypeError(f"ScopedEditorTransaction: cannot convert type '{type(desc).__name__}' to Text")

    def __enter__(self) -> ScopedEditorTransaction:
        return self

    def __exit__(self, kind: type[BaseException] | None, value: BaseException | None,
                 trace: TracebackType | None) -> None:
        return None

    def cancel(self) -> None:
        """Undo is not modelled."""
        world().log.warning("ScopedEditorTransaction.cancel: undo is not modelled by the headless engine")


@public
class ScopedSlowTask:
    """Progress of a long edit; nothing is shown."""

    def __init__(self, work: float, desc: str | Text = "", enabled: bool = True) -> None:
        self._work = float(work)

    def __enter__(self) -> ScopedSlowTask:
        return self

    def __exit__(self, kind: type[BaseException] | None, value: BaseException | None,
                 trace: TracebackType | None) -> None:
        return None

    def make_dialog(self, can_cancel: bool = False, allow_in_pie: bool = False) -> None:
        """Nothing is shown."""

    def make_dialog_delayed(self, delay: float, can_cancel: bool = False, allow_in_pie: bool = False) -> None:
        """Nothing is shown."""

    def enter_progress_frame(self, work: float = 1.0, desc: str | Text = "") -> None:
        """Nothing is shown."""

    def should_cancel(self) -> bool:
        """Nobody cancels."""
        return False


def log(arg: object) -> None:
    """Log a line."""
    world().log.display(str(arg))


def log_warning(arg: object) -> None:
    """Log a warning."""
    world().log.warning(str(arg))


def log_error(arg: object) -> None:
    """Log an error."""
    world().log.error(str(arg))


def _loaded(outer: Object | None, name: str) -> Any:
    found = world().actors.get(name.rsplit(".", 1)[-1]) if ":PersistentLevel." in name else load(name)
    return found


@api
def load_asset(name: str, type: Class | type | None = None, follow_redirectors: bool = True) -> Any:
    """The asset of a path, or None with a logged warning."""
    found = load(name)
    if found is not None and type is not None and not subclass_of(found._class(), as_class(type)._python_type):
        return None
    return found


@api
def find_asset(name: str, type: Class | type | None = None, follow_redirectors: bool = True) -> Any:
    """The asset of a path, or None."""
    return world().find(name)


@api
def load_object(outer: Object | None, name: str, type: Class | type | None = None,
                follow_redirectors: bool = True) -> Any:
    """The object of a path, or None with a logged warning."""
    return _loaded(outer, name)


@api
def find_object(outer: Object | None, name: str, type: Class | type | None = None,
                follow_redirectors: bool = True) -> Any:
    """The object of a path, or None."""
    if ":PersistentLevel." in name:
        return world().actors.get(name.rsplit(".", 1)[-1])
    return world().find(name)


@api
def load_class(outer: Object | None, name: str, type: Class | type | None = None) -> Class | None:
    """The class ``/Script/Module.Name`` or ``/Game/A/B.B_C``, or None with a logged warning."""
    native = world().native_class(name)
    if native is not None:
        return as_class(native)
    found = world().find(name)
    if not isinstance(found, Class):
        world().log.warning(f"LoadClass failed: '{name}' does not exist")
        return None
    return found


@api
def get_editor_subsystem(subsystem: Class | type) -> Any:
    """An editor subsystem."""
    wanted = as_class(subsystem)._python_type
    if not issubclass(wanted, EditorSubsystem):
        raise TypeError(f"get_editor_subsystem: '{wanted.__name__}' is no editor subsystem")
    return _SUBSYSTEMS.get(wanted)


@api
def get_engine_subsystem(subsystem: Class | type) -> Any:
    """An engine subsystem."""
    if as_class(subsystem)._python_type is not SubobjectDataSubsystem:
        raise TypeError(f"get_engine_subsystem: '{as_class(subsystem).get_name()}' is no engine subsystem")
    return _SUBOBJECTS


@api
def new_object(type: Class | type, outer: Object | None = None, name: Name | str = "None",
               base_type: Class | type | None = None) -> Any:
    """A new object of a class that scripts may make."""
    return as_class(type)._python_type(outer, name)


def is_editor() -> bool:
    """This is an editor."""
    return True


_SUBSYSTEMS = {kind: kind._make(kind.__name__, None) for kind in SUBSYSTEMS}
_SUBOBJECTS: SubobjectDataSubsystem = SubobjectDataSubsystem._make("SubobjectDataSubsystem", None)
_ticks: dict[int, Callable[[float], None]] = {}


def register_slate_post_tick_callback(callable: Callable[[float], None]) -> object:
    """Register a function that is called after each tick; returns a handle."""
    handle = object()
    _ticks[id(handle)] = callable
    return _Handle(id(handle), handle)


def unregister_slate_post_tick_callback(handle: object) -> None:
    """Forget a tick function."""
    if not isinstance(handle, _Handle):
        raise TypeError("unregister_slate_post_tick_callback: not a handle")
    _ticks.pop(handle.number, None)


class _Handle:
    def __init__(self, number: int, anchor: object) -> None:
        self.number, self.anchor = number, anchor


def tick(delta_seconds: float) -> None:
    """Call the tick functions once (the server does so between requests)."""
    for callback in list(_ticks.values()):
        callback(delta_seconds)


def mesh_facts(path: str) -> dict[str, Any] | None:
    """What the snapshot keeps of a mesh: digest, local bounds and collision bodies (cm), or None when unknown."""
    asset = world().store.asset(path)
    if asset is None:
        found = world().find(path)
        asset = getattr(found, "_asset", None)
    if asset is None:
        return None
    return {"sha256": asset.mesh_sha256, "bounds_min_cm": list(asset.bounds_min_cm),
            "bounds_max_cm": list(asset.bounds_max_cm),
            "collision": [body.model_dump(mode="json") for body in asset.collision]}


FUNCTIONS: dict[str, Callable[..., Any]] = {
    f.__name__: f for f in (
        log, log_warning, log_error, load_asset, find_asset, load_object, find_object, load_class, get_editor_subsystem,
        get_engine_subsystem, new_object,
        is_editor, register_slate_post_tick_callback, unregister_slate_post_tick_callback)}
FUNCTIONS["c4s_mesh_facts"] = mesh_facts
