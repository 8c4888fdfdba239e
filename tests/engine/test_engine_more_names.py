"""Names that scripts use beside the common ones, each doing what Unreal's does, or saying that it does not."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from c4s.engine.headless.editor import world

pytestmark = pytest.mark.usefixtures("empty_level")


def reopened(unreal):
    library = unreal.EditorLoadingAndSavingUtils
    assert library.save_map(world().map, "/Game/Names") and library.load_map("/Game/Names")
    return list(unreal.get_editor_subsystem(unreal.EditorActorSubsystem).get_all_level_actors())


@pytest.mark.parametrize("shape", ["Cube", "Sphere", "Cylinder", "Cone", "Plane"])
def test_a_mesh_description_is_the_geometry(unreal, shape):
    mesh = unreal.load_asset(f"/Engine/BasicShapes/{shape}")
    told = mesh.get_static_mesh_description(0)
    count, triangles = told.get_vertex_count(), told.get_triangle_count()
    assert triangles == mesh.get_num_triangles(0) and told.get_vertex_instance_count() == 3 * triangles
    points = np.array([told.get_vertex_position(unreal.VertexID(i)).to_tuple() for i in range(count)])
    corners = np.array(
        [[v.id_value for v in told.get_triangle_vertices(unreal.TriangleID(t))] for t in range(triangles)]
    )
    assert len(np.unique(points, axis=0)) == count and set(corners.ravel()) <= set(range(count))
    found = mesh._geometry()
    assert np.array_equal(points[corners], found.vertices[found.faces].astype(float))
    corner = told.get_triangle_vertex_instance(unreal.TriangleID(1), 2)
    assert told.get_vertex_instance_vertex(corner).id_value == corners[1][2]
    uv = told.get_vertex_instance_uv(corner)
    assert (uv.x, uv.y) == tuple(map(float, found.uvs[found.faces[1][2]]))
    assert told.get_polygon_polygon_group(unreal.PolygonID(0)) == unreal.PolygonGroupID(0)


def test_a_mesh_description_knows_its_ends(unreal):
    cube = unreal.load_asset("/Engine/BasicShapes/Cube")
    told = cube.get_static_mesh_description(0)
    assert told.get_vertex_count() == 8 and told.get_triangle_count() == 12 and told.get_polygon_group_count() == 1
    for number, valid in ((-1, False), (0, True), (7, True), (8, False)):
        assert told.is_vertex_valid(unreal.VertexID(number)) is valid
    assert told.is_triangle_valid(unreal.TriangleID(11)) and not told.is_triangle_valid(unreal.TriangleID(12))
    assert not told.is_vertex_instance_valid(unreal.VertexInstanceID(36)) and not told.is_empty()
    assert len(told.get_triangle_vertices(unreal.TriangleID(12))) == 0
    assert told.get_triangle_vertex_instance(unreal.TriangleID(0), 3).id_value == -1
    assert told.get_vertex_position(unreal.VertexID(8)) == unreal.Vector()
    assert cube.get_static_mesh_description(1) is None and cube.find_socket("any") is None
    with pytest.raises(TypeError):
        told.get_vertex_position(unreal.TriangleID(0))


@pytest.mark.parametrize(
    ("kind", "half"), [("TriggerBox", (40, 40, 40)), ("TriggerSphere", (40, 40, 40)), ("TriggerCapsule", (40, 40, 80))]
)
def test_triggers_have_their_size_and_no_collision(unreal, actors, kind, half):
    actor = actors.spawn_actor_from_class(getattr(unreal, kind), unreal.Vector(1, 2, 3))
    assert actor.get_actor_bounds(False)[1] == unreal.Vector(*half)
    part = actor.collision_component
    assert part.get_class().get_name() == f"{kind.removeprefix('Trigger')}Component"
    assert isinstance(part, unreal.ShapeComponent) and not part.is_collision_enabled()
    (again,) = reopened(unreal)
    assert again.get_actor_bounds(False)[1] == unreal.Vector(*half)


def test_shapes_are_sized_and_saved_whatever_their_size(unreal, actors):
    box = actors.spawn_actor_from_class(unreal.TriggerBox, unreal.Vector())
    ball = actors.spawn_actor_from_class(unreal.TriggerSphere, unreal.Vector())
    pill = actors.spawn_actor_from_class(unreal.TriggerCapsule, unreal.Vector())
    box.collision_component.set_box_extent(unreal.Vector(32, 32, 32))
    ball.collision_component.set_sphere_radius(32)
    pill.collision_component.set_capsule_size(22, 44)
    for actor in (box, ball, pill):
        actor.set_actor_scale3d(unreal.Vector(2, 3, 4))
    box, ball, pill = reopened(unreal)
    assert box.collision_component.get_unscaled_box_extent() == unreal.Vector(32, 32, 32)
    assert box.collision_component.get_scaled_box_extent() == unreal.Vector(64, 96, 128)
    assert ball.collision_component.get_scaled_sphere_radius() == 64
    assert pill.collision_component.get_unscaled_capsule_size() == (22, 44)
    assert pill.collision_component.get_scaled_capsule_size() == (44, 176)
    pill.collision_component.set_capsule_radius(100)
    assert pill.collision_component.get_unscaled_capsule_size() == (100, 100)
    assert box.collision_component.get_class() is unreal.BoxComponent.static_class()
    start = actors.spawn_actor_from_class(unreal.PlayerStart, unreal.Vector())
    assert start.root_component.get_unscaled_capsule_size() == (40, 92)


@pytest.mark.parametrize("kind", ["SphereReflectionCapture", "BoxReflectionCapture", "PlaneReflectionCapture"])
def test_reflection_captures_are_kept(unreal, actors, kind):
    capture = actors.spawn_actor_from_class(getattr(unreal, kind), unreal.Vector())
    capture.capture_component.set_editor_property("brightness", 2.5)
    (again,) = reopened(unreal)
    assert again.capture_component.brightness == 2.5 and again.get_class().get_name() == kind


def test_kinds_that_cannot_be_placed_are_not(unreal, actors, capsys):
    for kind in (unreal.TriggerBase, unreal.ReflectionCapture):
        assert actors.spawn_actor_from_class(kind, unreal.Vector()) is None
    assert capsys.readouterr().out.count("not a class that can be placed") == 2


def test_what_is_made_without_a_level_is_never_saved(unreal, actors, capsys):
    cube = actors.spawn_actor_from_object(unreal.load_asset("/Engine/BasicShapes/Cube"), unreal.Vector())
    loose = unreal.Actor()
    part = unreal.new_object(unreal.StaticMeshComponent, cube)
    assert part.get_owner() is cube and loose.get_path_name().startswith("/Engine/Transient.")
    assert part.set_static_mesh(unreal.load_asset("/Engine/BasicShapes/Cone"))
    said = capsys.readouterr().out
    assert "is in no level" in said and "is no part of StaticMeshActor_0 and is not saved" in said
    keep = unreal.AttachmentRule.KEEP_WORLD
    assert not cube.attach_to_actor(loose, "None", keep, keep, keep)
    assert "nothing in the level can be attached to it" in capsys.readouterr().out
    assert part.attach_to_component(cube.root_component, "None", keep, keep, keep)
    assert not actors.destroy_actor(loose) and len(actors.get_all_level_actors()) == 1
    part.destroy_component(part)
    (again,) = reopened(unreal)
    assert len(again.get_components_by_class(unreal.StaticMeshComponent)) == 1
    for kind in (unreal.ActorComponent, unreal.PrimitiveComponent, unreal.LightComponent):
        with pytest.raises(Exception, match="cannot be made"):
            unreal.new_object(kind)


def test_labels_count_on(unreal, actors):
    cube = actors.spawn_actor_from_object(unreal.load_asset("/Engine/BasicShapes/Cube"), unreal.Vector())

    def copies(label: str, count: int) -> list[str]:
        cube.set_actor_label(label)
        return [actors.duplicate_actor(cube).get_actor_label() for _ in range(count)]

    assert copies("Crate_01", 3) == ["Crate_02", "Crate_03", "Crate_04"]
    assert copies("Wall", 3) == ["Wall2", "Wall3", "Wall4"]
    assert copies("Wall9", 2) == ["Wall10", "Wall11"]
    assert copies("Tile_099", 2) == ["Tile_100", "Tile_101"]
    assert copies("7", 2) == ["8", "9"]


def test_material_instances_tell_their_values(unreal):
    tools = unreal.AssetToolsHelpers.get_asset_tools()
    made = tools.create_asset(
        "MI_Names", "/Game/Names", unreal.MaterialInstanceConstant, unreal.MaterialInstanceConstantFactoryNew()
    )
    made.set_editor_property("parent", unreal.load_asset("/Engine/BasicShapes/BasicShapeMaterial"))
    library = unreal.MaterialEditingLibrary
    assert library.set_material_instance_vector_parameter_value(made, "BaseColor", unreal.LinearColor(1, 0, 0, 1))
    assert library.set_material_instance_scalar_parameter_value(made, "Roughness", 0.25)
    assert made.get_vector_parameter_value("BaseColor") == unreal.LinearColor(1, 0, 0, 1)
    assert made.get_scalar_parameter_value("Roughness") == 0.25
    assert made.get_texture_parameter_value("Any") is None
    (scalar,), (vector,) = made.scalar_parameter_values, made.get_editor_property("vector_parameter_values")
    assert (str(scalar.parameter_info.name), scalar.parameter_value) == ("Roughness", 0.25)
    assert vector.parameter_value == unreal.LinearColor(1, 0, 0, 1) and len(made.texture_parameter_values) == 0
    assert scalar.parameter_info.association is unreal.MaterialParameterAssociation.GLOBAL_PARAMETER


@pytest.fixture
def material(unreal):
    world().created.clear()
    tools = unreal.AssetToolsHelpers.get_asset_tools()
    return tools.create_asset("M_Names", "/Game/Names", unreal.Material, unreal.MaterialFactoryNew())


def expression(unreal, material, kind, **properties):
    made = unreal.MaterialEditingLibrary.create_material_expression(
        material, getattr(unreal, f"MaterialExpression{kind}")
    )
    for name, value in properties.items():
        made.set_editor_property(name, value)
    return made


@pytest.mark.parametrize(
    ("kind", "properties", "inputs", "value"),
    [
        ("Power", {}, {"Base": 0.5}, 0.25),
        ("Power", {}, {"Base": 0.5, "Exponent": 3.0}, 0.125),
        ("Min", {"const_a": 0.75, "const_b": 0.5}, {}, 0.5),
        ("Max", {"const_a": 0.75, "const_b": 0.5}, {}, 0.75),
        ("Clamp", {"max_default": 0.5}, {"Input": 0.75}, 0.5),
        ("Saturate", {}, {"Input": 2.0}, 1.0),
        ("Abs", {}, {"Input": -0.25}, 0.25),
        ("Desaturation", {}, {"Input": 0.5}, 0.5),
        ("ComponentMask", {"r": True}, {"Input": 0.5}, 0.5),
        ("OneMinus", {}, {"Input": 0.25}, 0.75),
    ],
)
def test_expressions_calculate(unreal, material, kind, properties, inputs, value):
    library = unreal.MaterialEditingLibrary
    made = expression(unreal, material, kind, **properties)
    for name, number in inputs.items():
        assert library.connect_material_expressions(expression(unreal, material, "Constant", r=number), "", made, name)
    assert library.connect_material_property(made, "", unreal.MaterialProperty.MP_ROUGHNESS)
    library.recompile_material(material)
    assert library.get_material_default_scalar_parameter_value(material, "Roughness") == pytest.approx(value)
    assert library.get_material_property_input_node(material, unreal.MaterialProperty.MP_ROUGHNESS) is made


@pytest.mark.parametrize(
    "kind", ["TextureSample", "Noise", "WorldPosition", "Fresnel", "Time", "TextureSampleParameter2D", "OneMinus"]
)
def test_expressions_without_a_constant_leave_the_surface(unreal, material, kind, capsys):
    library = unreal.MaterialEditingLibrary
    before = library.get_material_default_vector_parameter_value(material, "BaseColor")
    made = expression(unreal, material, kind)
    assert library.connect_material_property(made, "", unreal.MaterialProperty.MP_BASE_COLOR)
    assert "base_color stays as it is" in capsys.readouterr().out
    assert library.get_material_default_vector_parameter_value(material, "BaseColor") == before
    assert library.connect_material_property(made, "", unreal.MaterialProperty.MP_NORMAL)
    assert library.get_material_property_input_node(material, unreal.MaterialProperty.MP_OPACITY) is None


def test_collision_and_merging_say_that_they_are_not_offered(unreal, actors, capsys):
    meshes = unreal.get_editor_subsystem(unreal.StaticMeshEditorSubsystem)
    cube = unreal.load_asset("/Engine/BasicShapes/Cube")
    before = meshes.get_simple_collision_count(cube)
    assert meshes.add_simple_collisions(cube, unreal.ScriptCollisionShapeType.BOX) == -1
    assert meshes.remove_collisions(cube) is False
    assert meshes.set_convex_decomposition_collisions(cube, 4, 16, 100000) is False
    assert meshes.merge_static_mesh_actors([], unreal.MergeStaticMeshActorsOptions()) is None
    assert meshes.join_static_mesh_actors([], unreal.JoinStaticMeshActorsOptions()) is None
    older = unreal.EditorStaticMeshLibrary
    assert older.remove_collisions(cube) is False
    assert older.add_simple_collisions(cube, unreal.ScriptCollisionShapeType.BOX) == -1
    assert meshes.get_simple_collision_count(cube) == before
    assert capsys.readouterr().out.count("Error: ") == 7


def test_the_older_base_of_utilities_reaches_the_selection(unreal, actors):
    @unreal.uclass()
    class Utility(unreal.GlobalEditorUtilityBase):
        speed = unreal.uproperty(float)
        names = unreal.uproperty(unreal.Name)

        @unreal.ufunction(ret=int, params=[int])
        def twice(self, number):
            return 2 * number

        @unreal.ufunction(static=True)
        def ready():
            return True

    cube = actors.spawn_actor_from_object(unreal.load_asset("/Engine/BasicShapes/Cube"), unreal.Vector(0, 0, 5))
    tool = Utility()
    assert list(tool.get_selection_set()) == [cube] and tool.get_selection_bounds()[0].z == 5
    tool.clear_actor_selection_set()
    assert list(tool.get_selection_set()) == []
    tool.set_actor_selection_state(cube, True)
    assert list(actors.get_selected_level_actors()) == [cube]
    assert tool.get_actor_reference(cube.get_path_name()) is cube
    assert tool.speed == 0.0 and tool.twice(4) == 8 and Utility.ready()
    tool.speed = 2
    tool.set_editor_property("names", "x")
    assert tool.get_editor_property("speed") == 2.0 and str(tool.names) == "x"
    with pytest.raises(TypeError):
        tool.speed = "fast"
    with pytest.raises(AttributeError):
        tool.other = 1
    with pytest.raises(Exception, match="must derive"):
        unreal.uclass()(dict)


def test_packages_are_files_and_back(unreal):
    tools = unreal.PackageTools
    cube = "/Engine/BasicShapes/Cube"
    made = unreal.EditorAssetLibrary.duplicate_asset(cube, "/Game/Packages/SM_Box")
    assert unreal.EditorAssetLibrary.save_loaded_asset(made)
    file = tools.package_name_to_filename("StaticMesh'/Game/Packages/SM_Box.SM_Box'", ".asset.json")
    assert Path(file).is_file() and tools.filename_to_package_name(file) == "/Game/Packages/SM_Box"
    assert tools.package_name_to_filename(cube) == "" and tools.filename_to_package_name("/etc/passwd") == ""
    assert tools.sanitize_package_name("/Game//A b:c") == "/Game/A_b_c"


def test_strings(unreal):
    of = unreal.StringLibrary
    assert of.split("a=b=C", "=") == ("a", "b=C") and of.split("a=b", "=", search_dir=unreal.SearchDir.FROM_END)
    assert of.split("aXb", "x", unreal.SearchCase.CASE_SENSITIVE) is None and of.split("aXb", "x") == ("a", "b")
    assert list(of.parse_into_array("a,,b", ",")) == ["a", "b"]
    assert list(of.parse_into_array("a,,b", ",", False)) == ["a", "", "b"]
    assert of.join_string_array(["a", "b"], "-") == "a-b" and of.len("abc") == 3
    assert of.replace("a.A.b", "a", "x") == "x.x.b"
    assert of.replace("a.A.b", "A", "x", unreal.SearchCase.CASE_SENSITIVE) == "a.x.b"
    assert of.contains("Chair_01", "chair") and not of.contains("Chair_01", "chair", True)
    assert of.find_substring("abcabc", "b", False, True) == 4 and of.find_substring("abc", "z") == -1
    assert of.starts_with("SM_Chair", "sm_") and of.ends_with("SM_Chair", "CHAIR") and not of.ends_with("a", "b")
    assert of.matches_wildcard("SM_Chair_01", "sm_*_0?") and not of.matches_wildcard("a[b", "a[b]")
    assert of.left("abcd", 2) == "ab" and of.right("abcd", 2) == "cd" and of.mid("abcd", 1, 2) == "bc"
    assert of.left_chop("abcd", 1) == "abc" and of.right_chop("abcd", 1) == "bcd" and of.left_pad("a", 3) == "  a"
    assert of.get_substring("abc", 1, 2) == "bc" and of.get_substring("abc", 2, 2) == ""
    assert of.is_numeric("-1.5") and not of.is_numeric("1x") and of.conv_string_to_int(" 12px") == 12
    vector = unreal.Vector(1, -2.5, 3)
    assert of.conv_string_to_vector(of.conv_vector_to_string(vector)) == (vector, True)
    turn = unreal.Rotator(roll=3, pitch=1, yaw=2)
    assert of.conv_string_to_rotator(of.conv_rotator_to_string(turn)) == (turn, True)
    assert of.conv_string_to_vector("X=1 Y=2") == (unreal.Vector(), False)
    assert of.conv_double_to_string(2.0) == "2.0" and of.conv_bool_to_string(True) == "true"


def test_second_names_of_chance_and_choices(unreal):
    of = unreal.MathLibrary
    assert {of.rand_range(2, 4) for _ in range(200)} == {2, 3, 4} and of.rand(1) == 0
    assert 1 <= of.f_rand_range(1, 2) <= 2 and of.v_rand().length() == pytest.approx(1)
    assert of.random_unit_vector_in_cone(unreal.Vector(0, 0, 1), 0.1).z > 0.99
    box = unreal.Box(unreal.Vector(1, 1, 1), unreal.Vector(2, 2, 2))
    assert all(1 <= part <= 2 for part in of.random_point_in_bounding_box_box(box).to_tuple())
    stream = unreal.RandomStream(7)
    first = [of.rand_range_from_stream(stream, 0, 1000) for _ in range(5)]
    of.reset_random_stream(stream)
    assert [of.rand_range_from_stream(stream, 0, 1000) for _ in range(5)] == first
    assert of.select_float(1, 2, True) == 1 and of.select_string("a", "b", False) == "b"
    assert of.max_of_int_array([3, 9, 4]) == (1, 9) and of.min_of_int_array([]) == (-1, 0)
    assert of.average_of_int_array([1, 2]) == 1.5 and of.median_of_int_array([3, 1, 2]) == 2


def test_paths(unreal):
    of = unreal.Paths
    assert of.project_saved_dir() == of.combine([of.project_dir(), "Saved"]) + "/"
    assert of.split("/a/b.c") == ("/a", "b", "c") and of.change_extension("/a/b.c", "d") == "/a/b.d"
    assert of.change_extension("/a/b", "d") == "/a/b" and of.set_extension("/a/b", ".d") == "/a/b.d"
    assert of.normalize_directory_name("\\a\\b\\") == "/a/b" and of.is_same_path("/a/./b", "/a/c/../b")
    assert of.is_relative("a/b") and not of.is_relative("/a") and of.remove_duplicate_slashes("/a//b") == "/a/b"
    assert of.collapse_relative_directories("/a/../b") == "/b" and of.collapse_relative_directories("../b") is None
    assert of.make_path_relative_to("/a/b/c", "/a/d") == "b/c" and of.make_path_relative_to("a", "/b") is None
    assert of.make_valid_file_name("a:b?", "_") == "a_b_"
    assert of.create_temp_filename("/a") != of.create_temp_filename("/a")


def test_names_of_5_8_are_the_same_things(unreal):
    assert unreal.TraceTypeQuery.ECC_VISIBILITY is unreal.TraceTypeQuery.TRACE_TYPE_QUERY1
    assert unreal.TraceTypeQuery.ECC_CAMERA is unreal.TraceTypeQuery.TRACE_TYPE_QUERY2
    names = ("WORLD_STATIC", "WORLD_DYNAMIC", "PAWN", "PHYSICS_BODY", "VEHICLE", "DESTRUCTIBLE")
    for number, name in enumerate(names, 1):
        old = unreal.ObjectTypeQuery[f"OBJECT_TYPE_QUERY{number}"]
        assert unreal.ObjectTypeQuery[f"ECC_{name}"] is old
    assert unreal.SystemLibrary.get_engine_version().startswith("5.6.")
