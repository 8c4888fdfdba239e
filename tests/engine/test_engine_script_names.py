"""Paths, constants and mixes that scripts use besides the scene itself."""

from __future__ import annotations

from pathlib import Path

import pytest

from c4s.engine.headless.process.boot import boot


@pytest.fixture
def unreal(tmp_path: Path):
    return boot([], tmp_path / "project" / "Content")


def test_paths(unreal, tmp_path):
    project = tmp_path / "project"
    assert unreal.Paths.get_project_file_path() == f"{project.as_posix()}/Content/Content.uproject"
    assert unreal.Paths.combine(["/a/", "b", "c.png"]) == "/a/b/c.png"
    assert unreal.Paths.directory_exists(str(project)) and not unreal.Paths.directory_exists(str(project / "none"))
    assert unreal.Paths.get_path("/a/b/c.d.png") == "/a/b"
    assert unreal.Paths.get_clean_filename("/a/b/c.d.png") == "c.d.png"
    assert unreal.Paths.get_base_filename("/a/b/c.d.png") == "c.d"
    assert unreal.Paths.get_base_filename("/a/b/c.d.png", False) == "/a/b/c.d"
    assert (unreal.Paths.get_extension("c.png"), unreal.Paths.get_extension("c.png", True)) == ("png", ".png")
    with pytest.raises(TypeError):
        unreal.Paths.combine("/a", "b")


def test_constants_are_copies(unreal):
    up = unreal.Vector.UP
    up.z = 7
    assert unreal.Vector.UP.to_tuple() == (0, 0, 1) and unreal.Vector.ZERO.is_zero()
    assert unreal.Vector(1e-5, 0, 0).is_nearly_zero() and not unreal.Vector(1e-5, 0, 0).is_zero()
    with pytest.raises(AttributeError):
        up.ZERO = unreal.Vector()


def test_mixes_and_chance(unreal):
    a, b = unreal.Vector(), unreal.Vector(10, 20, 0)
    assert unreal.MathLibrary.v_lerp(a, b, 0.5).to_tuple() == a.lerp_to(b, 0.5).to_tuple() == (5, 10, 0)
    assert unreal.MathLibrary.make_rot_from_x(unreal.Vector(0, 1, 0)).yaw == pytest.approx(90)
    assert b.length2d() == pytest.approx(500**0.5)
    assert all(2 <= unreal.MathLibrary.random_float_in_range(2, 3) <= 3 for _ in range(20))
    assert {unreal.MathLibrary.random_integer_in_range(1, 2) for _ in range(60)} == {1, 2}


def test_what_materials_lack_is_said(unreal):
    tools, library = unreal.AssetToolsHelpers.get_asset_tools(), unreal.MaterialEditingLibrary
    made = tools.create_asset(
        "MI_A", "/Game/M", unreal.MaterialInstanceConstant, unreal.MaterialInstanceConstantFactoryNew()
    )
    assert not library.set_material_instance_texture_parameter_value(made, "Albedo", None)
    assert len(library.get_texture_parameter_names(made)) == 0
    with pytest.raises(TypeError):
        library.set_material_instance_texture_parameter_value(made, "Albedo", "/Game/T_A")
