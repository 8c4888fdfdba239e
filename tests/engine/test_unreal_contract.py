"""The strict ``unreal`` module and the editor scripts against the published stub of Unreal's own module."""

from __future__ import annotations

import ast
import inspect
import re
from collections.abc import Iterator
from enum import Enum
from pathlib import Path
from typing import Any

import pytest
from stub_index import Parameter, Signature, StubIndex
from used_names import table

from c4s.engine.headless.unreal import build
from c4s.engine.headless.unreal.structs import StructBase

EDITOR = Path(__file__).parents[2] / "c4s" / "editor"

BEYOND_THE_STUB = {
    "c4s_mesh_facts": "c4s's own hook: digests and collision of a mesh; editor scripts use it only where it exists",
    "HitResult.to_dict": "Unreal 5.8 has it beside to_tuple; scripts for both probe for it",
    **{
        f"ObjectTypeQuery.ECC_{name}": "Unreal 5.8's name"
        for name in ("WORLD_STATIC", "WORLD_DYNAMIC", "PAWN", "PHYSICS_BODY", "VEHICLE", "DESTRUCTIBLE")
    },
    **{f"TraceTypeQuery.ECC_{name}": "Unreal 5.8's name" for name in ("VISIBILITY", "CAMERA")},
}
"""Names that Unreal 5.6 does not have, each with the reason why ours does."""

OTHER_CONSTRUCTORS = {
    "ARFilter": "keywords only: the fields between those that exist here hold soft paths and sets, which do not",
    "CameraFocusSettings": "keywords only: the settings of tracking, between those that exist here, do not",
    "StaticMaterial": "the first two fields: texture density and overlays do not exist here",
    "PostProcessSettings": "keywords only: the stub leaves its hundreds of fields open",
}
"""Structs whose constructor takes less than Unreal's."""


@pytest.fixture(scope="module")
def stub() -> StubIndex:
    return StubIndex.installed()


@pytest.fixture(scope="module")
def ours() -> dict[str, Any]:
    made = build()
    return {name: getattr(made, name) for name in dir(made) if not name.startswith("__")}


def signature(function: Any) -> Signature:
    parameters = list(inspect.signature(function).parameters.values())
    if parameters and parameters[0].name in ("self", "cls"):
        parameters = parameters[1:]
    kinds = {inspect.Parameter.VAR_POSITIONAL: "*", inspect.Parameter.VAR_KEYWORD: "**"}
    return tuple(
        Parameter(p.name, p.default is p.empty and p.kind not in kinds, kinds.get(p.kind, "")) for p in parameters
    )


def members(cls: type) -> Iterator[tuple[str, Any]]:
    """Public members of a class as Python finds them, inherited ones too."""
    seen = set()
    for base in cls.__mro__[:-1]:
        for name, value in base.__dict__.items():
            if not name.startswith("_") and name not in seen:
                seen.add(name)
                yield name, value


def call_differences(stub: StubIndex, name: str, cls: type) -> Iterator[str]:
    for member, value in members(cls):
        label, function = f"{name}.{member}", getattr(value, "__func__", value)
        if label in BEYOND_THE_STUB:
            continue
        if not callable(function):
            if not stub.has(name, member):
                yield f"{label}: not in Unreal"
            continue
        theirs = stub.method(name, member)
        if theirs is None:
            yield f"{label}: no such method in Unreal"
        elif signature(function) != theirs:
            yield f"{label}: {signature(function)} is not {theirs}"


def field_differences(stub: StubIndex, name: str, fields: dict[str, Any]) -> Iterator[str]:
    """Attributes must be attributes there, hidden properties must be listed as editor properties."""
    listed = {p for c in stub.lineage(name) for p in c.editor_properties}
    for field, prop in fields.items():
        if prop.attribute != stub.has(name, field):
            yield f"{name}.{field}: {'not ' if prop.attribute else ''}an attribute in Unreal"
        if prop.scripts and field not in listed and not stub.has(name, field):
            yield f"{name}.{field}: no such editor property in Unreal"


def constructor_differences(stub: StubIndex, name: str, cls: type[StructBase]) -> Iterator[str]:
    if name in OTHER_CONSTRUCTORS:
        return
    own = "__init__" in cls.__dict__
    taken = [p.name for p in signature(cls.__init__)] if own else list(cls._fields)[: cls._takes]
    theirs = stub.method(name, "__init__")
    if theirs is not None and taken != [p.name for p in theirs]:
        yield f"{name}(): {taken} is not {[p.name for p in theirs]}"


def test_every_name_is_unreals_own(stub, ours):
    unknown = {
        name
        for name, value in ours.items()
        if name not in (stub.classes() if isinstance(value, type) else stub.functions())
    }
    assert unknown == {name for name in BEYOND_THE_STUB if "." not in name}


def test_functions_take_what_unreals_take(stub, ours):
    functions = {
        name: value for name, value in ours.items() if not isinstance(value, type) and name not in BEYOND_THE_STUB
    }
    assert {n: signature(f) for n, f in functions.items()} == {n: stub.function(n) for n in functions}


def test_classes_follow_the_stub(stub, ours):
    wrong: list[str] = []
    calls = 0
    for name, cls in ours.items():
        if not isinstance(cls, type):
            continue
        if issubclass(cls, Enum):
            labels = [f"{name}.{member}" for member in cls.__members__ if not stub.has(name, member)]
            wrong += [label for label in labels if label not in BEYOND_THE_STUB]
            continue
        line = {c.name for c in stub.lineage(name)}
        wrong += [
            f"{name}: {b.__name__} is no base of it"
            for b in cls.__mro__[1:]
            if ours.get(b.__name__) is b and b.__name__ not in line
        ]
        if getattr(cls, "_absent", False):
            continue  # known by name: nothing is one
        wrong += call_differences(stub, name, cls)
        calls += sum(1 for _ in members(cls))
        if issubclass(cls, StructBase):
            wrong += field_differences(stub, name, cls._fields)
            wrong += constructor_differences(stub, name, cls)
        else:
            wrong += field_differences(stub, name, getattr(cls, "_properties", {}))
    assert not wrong
    assert calls > 1000


def plain(result: str) -> str:
    """A result of the stub in the words of ours: items of containers and the module's name aside."""
    result = result.removeprefix("unreal.")
    if result.startswith("Optional["):
        return f"{plain(result[len('Optional[') : -1])} | None"
    return re.sub(r"\b(Array|Map|Set)\[[^\]]*\]*?\]", r"\1", result).replace("Tuple", "tuple")


OTHER_RESULTS = {"popitem", "items", "keys", "values", "to_tuple", "cast", "get_default_object", "copy", "__copy__"}
"""Methods whose result the stub gives with type variables."""


def result_differences(stub: StubIndex, name: str, cls: type) -> Iterator[str]:
    """Results that differ from Unreal's. Ours may be looser (``None`` for no object, ``Any``), never another thing."""
    for member, value in members(cls):
        node = stub.node(name, member)
        function = inspect.unwrap(getattr(value, "__func__", value))
        if node is None or node.returns is None or not callable(function) or member in OTHER_RESULTS:
            continue
        theirs, mine = plain(ast.unparse(node.returns)), str(inspect.signature(function).return_annotation)
        mine = mine.replace(" | None,", ",")
        if mine not in ("Any", theirs, f"{theirs} | None") and theirs not in ("Any", f"{mine} | None"):
            yield f"{name}.{member} gives {mine}, not {theirs}"


def default_differences(stub: StubIndex, name: str, cls: type) -> Iterator[str]:
    """Numbers, texts and structs that stand for a parameter left out."""
    for member, value in members(cls):
        node = stub.node(name, member)
        function = inspect.unwrap(getattr(value, "__func__", value))
        if node is None or not inspect.isfunction(function):
            continue
        arguments = node.args
        theirs = dict(
            zip(
                [a.arg for a in arguments.args][len(arguments.args) - len(arguments.defaults) :],
                arguments.defaults,
                strict=True,
            )
        )
        for parameter in inspect.signature(function).parameters.values():
            if parameter.default is parameter.empty or parameter.name not in theirs:
                continue
            if not same_default(parameter.default, ast.unparse(theirs[parameter.name])):
                yield f"{name}.{member}: {parameter.name}={parameter.default!r}, {ast.unparse(theirs[parameter.name])}"


def same_default(mine: Any, theirs: str) -> bool:
    """Whether a default is the one that the stub writes (numbers to six places, enums by name)."""
    if theirs in ("...", "Ellipsis"):
        return True
    if isinstance(mine, Enum):
        return theirs.rsplit(".", 1)[-1] == mine.name
    wanted = ast.literal_eval(theirs)
    if isinstance(wanted, list):
        given = mine if isinstance(mine, tuple) else mine.to_tuple()
        return bool(list(given) == pytest.approx(wanted, abs=1e-4))
    if isinstance(wanted, float):
        return bool(mine == pytest.approx(wanted, abs=1e-6))
    return bool(mine == wanted)


def test_results_and_defaults_are_unreals(stub, ours):
    classes = {n: c for n, c in ours.items() if isinstance(c, type) and not issubclass(c, Enum)}
    wrong = [w for n, c in classes.items() for w in (*result_differences(stub, n, c), *default_differences(stub, n, c))]
    assert not wrong


def test_what_others_use_is_here(stub, ours):
    rows = table(stub, ours)
    assert [row.name for row in rows if row.in_unreal and not row.here] == []
    assert len(rows) > 100


def test_enums_have_unreals_numbers(stub, ours):
    """Of those enums whose numbers the stub tells."""
    enums = {n: c for n, c in ours.items() if isinstance(c, type) and issubclass(c, Enum)}
    told = {(n, member): number for n in enums for member, number in stub.numbers(n).items()}
    wrong = {
        key: number
        for key, number in told.items()
        if key[1] in enums[key[0]].__members__ and enums[key[0]][key[1]].value != number
    }
    assert not wrong and len(told) > 50


COMMON = {
    "": "get_editor_subsystem log log_warning log_error load_asset load_class load_object Name Array Text Vector "
    "Rotator Transform LinearColor Color ARFilter TopLevelAssetPath AssetImportTask StaticMeshActor "
    "DirectionalLight PointLight SpotLight RectLight SkyLight SkyAtmosphere ExponentialHeightFog CameraActor "
    "PlayerStart NavMeshBoundsVolume PostProcessVolume MaterialFactoryNew MaterialInstanceConstantFactoryNew "
    "BlueprintFactory ScopedEditorTransaction ScopedSlowTask InstancedStaticMeshComponent SubobjectDataSubsystem "
    "MathLibrary register_slate_post_tick_callback unregister_slate_post_tick_callback",
    "EditorAssetLibrary": "load_asset does_asset_exist list_assets save_asset delete_asset make_directory "
    "load_blueprint_class save_loaded_asset find_asset_data duplicate_asset does_directory_exist",
    "EditorActorSubsystem": "spawn_actor_from_class spawn_actor_from_object get_all_level_actors destroy_actor",
    "EditorLevelLibrary": "get_editor_world get_all_level_actors spawn_actor_from_class get_selected_level_actors",
    "UnrealEditorSubsystem": "get_editor_world set_level_viewport_camera_info",
    "LevelEditorSubsystem": "save_current_level load_level new_level",
    "EditorLoadingAndSavingUtils": "save_map load_map save_dirty_packages",
    "SystemLibrary": "execute_console_command get_engine_version line_trace_single quit_editor collect_garbage "
    + " ".join(
        f"{shape}_trace_{number}{by}"
        for shape in ("line", "sphere", "box", "capsule")
        for number in ("single", "multi")
        for by in ("", "_for_objects", "_by_profile")
    )
    + " "
    + " ".join(
        f"{shape}_overlap_{what}"
        for shape in ("sphere", "box", "capsule", "component")
        for what in ("actors", "components")
    ),
    "NavigationSystemV1": "get_navigation_system is_navigation_being_built project_point_to_navigation "
    "find_path_to_location_synchronously get_random_reachable_point_in_radius "
    "navigation_raycast get_path_length on_navigation_bounds_updated",
    "PrimitiveComponent": "set_collision_enabled get_collision_response_to_channel get_collision_profile_name "
    "line_trace_component get_closest_point_on_collision ignore_component_when_moving",
    "GameplayStatics": "get_all_actors_of_class",
    "AssetRegistryHelpers": "get_asset_registry",
    "AssetToolsHelpers": "get_asset_tools",
    "AssetTools": "create_asset import_asset_tasks",
    "StaticMeshComponent": "set_static_mesh set_material set_mobility set_world_location",
    "MaterialEditingLibrary": "create_material_expression connect_material_property recompile_material "
    "set_material_instance_vector_parameter_value "
    "set_material_instance_scalar_parameter_value "
    "set_material_instance_texture_parameter_value",
    "AutomationLibrary": "take_high_res_screenshot",
    "Paths": "project_dir project_saved_dir project_content_dir get_project_file_path",
    "PointLightComponent": "set_intensity set_light_color set_attenuation_radius set_cast_shadows",
    "DirectionalLightComponent": "set_atmosphere_sun_light",
    "Actor": "get_name get_path_name get_editor_property set_editor_property get_actor_location get_class "
    "get_actor_label set_actor_scale3d get_components_by_class get_actor_rotation set_actor_location "
    "get_component_by_class set_actor_rotation get_actor_scale3d static_class set_actor_label "
    "get_actor_bounds set_folder_path attach_to_actor add_actor_world_offset get_actor_transform modify "
    "destroy_actor",
    "Vector": "length dot cross normal distance",
}
"""Names that public editor scripts use most, by owner."""


def test_what_scripts_use_most_is_there(ours):
    assert not [
        f"{owner}.{name}"
        for owner, names in COMMON.items()
        for name in names.split()
        if not (hasattr(ours[owner], name) if owner else name in ours)
    ]


def test_reviewed_names_are_still_needed(stub, ours):
    for label in BEYOND_THE_STUB:
        name, _, member = label.partition(".")
        assert name in ours and (not member or hasattr(ours[name], member))
        assert (stub.method(name, member) is None) if member else (name not in stub.classes() | stub.functions())
    assert all(name in ours for name in OTHER_CONSTRUCTORS)


def uses(tree: ast.AST) -> Iterator[tuple[int, str, str]]:
    """``unreal.X`` and ``unreal.X.y`` in a script, as line, X, and y or an empty string."""
    owners = {id(node.value): node for node in ast.walk(tree) if isinstance(node, ast.Attribute)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "unreal":
            above = owners.get(id(node))
            yield node.lineno, node.attr, above.attr if above is not None else ""
        if (
            isinstance(node, ast.Call)
            and isinstance(node.func, ast.Name)
            and node.func.id == "getattr"
            and isinstance(node.args[0], ast.Name)
            and node.args[0].id == "unreal"
            and isinstance(node.args[1], ast.Constant)
        ):
            yield node.lineno, str(node.args[1].value), ""


@pytest.mark.parametrize("script", sorted(EDITOR.glob("*.py")), ids=lambda path: path.stem)
def test_editor_scripts_use_names_of_both_modules(stub, ours, script):
    wrong = []
    for line, name, member in uses(ast.parse(script.read_text(encoding="utf-8"))):
        label = f"{name}.{member}" if member else name
        here = name in ours and (not member or hasattr(ours[name], member))
        there = name in stub.functions() or (name in stub.classes() and (not member or stub.has(name, member)))
        if not here or not (there or label in BEYOND_THE_STUB):
            wrong.append(f"{script.name}:{line}: unreal.{label}")
    assert not wrong


def test_a_wrong_script_would_be_found():
    found = set(uses(ast.parse("import unreal\nunreal.Foo\nunreal.Actor.bar(1)\ngetattr(unreal, 'baz', None)")))
    assert {(2, "Foo", ""), (3, "Actor", "bar"), (4, "baz", "")} <= found
