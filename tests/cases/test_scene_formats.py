"""SDF frames, geometry and lights, and what a glTF tree holds beside meshes, come in where they belong."""

from __future__ import annotations

import math
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest
import trimesh

from c4s.errors import BadInput
from c4s.packs.store import PackStore
from c4s.records.level import Level, LevelActor
from cases.importers.importing import import_scene
from tests.catalog.gltf_maker import Gltf

BOX = "<visual name='v'><geometry><box><size>1 1 1</size></box></geometry></visual>"


def actors_of(report: dict[str, Any]) -> dict[str, LevelActor]:
    """Actors of the imported level by name."""
    return {actor.name: actor for actor in Level.read(Path(report["level"])).actors}


def sdf(tmp_path: Path, world: str, **options: Any) -> dict[str, Any]:
    """The report of importing a world of these elements."""
    path = tmp_path / "scene" / "a.world"
    path.parent.mkdir(exist_ok=True)
    path.write_text(f"<sdf version='1.9'><world name='w'>{world}</world></sdf>")
    return import_scene(path, "a", suites=tmp_path / "suites", packs=tmp_path / "packs", **options)


def test_poses_are_read_in_the_frames_that_they_name(tmp_path: Path) -> None:
    placed = actors_of(
        sdf(
            tmp_path,
            f"""
      <frame name="door"><pose degrees="true">10 0 0 0 0 90</pose></frame>
      <frame name="mat" attached_to="door"><pose>1 0 0 0 0 0</pose></frame>
      <model name="in_door"><static>true</static><pose relative_to="door">0 2 0 0 0 0</pose><link name="l">{BOX}</link>
      </model>
      <model name="on_mat"><pose relative_to="mat">0 0 0 0 0 0</pose><link name="l">{BOX}</link></model>
      <model name="beside"><pose relative_to="table::top">0 0 1 0 0 0</pose><link name="l">{BOX}</link></model>
      <model name="table"><pose>5 5 0 0 0 0</pose><frame name="top"><pose>0 0 2 0 0 0</pose></frame>
        <link name="l">{BOX}</link></model>
      <model name="hung" placement_frame="hook"><pose>0 0 9 0 0 0</pose>
        <frame name="hook"><pose>0 0 3 0 0 0</pose></frame><link name="l">{BOX}</link></model>
      <model name="turned"><pose rotation_format="quat_xyzw">1 0 0 0 0 1 0</pose><link name="l">{BOX}</link></model>
    """,
        )
    )
    where = {name: actor.transform.location_cm for name, actor in placed.items() if not name.startswith("Light")}
    assert where["in_door"] == pytest.approx((800, 0, 0)) and where["on_mat"] == pytest.approx((1000, -100, 0))
    assert where["beside"] == pytest.approx((500, -500, 300)) and where["hung"] == pytest.approx((0, 0, 600))
    assert abs(placed["turned"].transform.rotation_deg[1]) == pytest.approx(180)
    mobile = {name: placed[name].components[0].properties.get("mobility") for name in ("in_door", "on_mat")}
    assert mobile == {"in_door": None, "on_mat": "MOVABLE"}


def test_frames_that_do_not_exist_or_hang_on_themselves_skip_their_model_alone(tmp_path: Path) -> None:
    report = sdf(
        tmp_path,
        f"""
      <frame name="a" attached_to="b"/><frame name="b" attached_to="a"/>
      <model name="round"><pose relative_to="a">0 0 0 0 0 0</pose><link name="l">{BOX}</link></model>
      <model name="lost"><pose relative_to="nowhere">0 0 0 0 0 0</pose><link name="l">{BOX}</link></model>
      <model name="fine"><link name="l">{BOX}</link></model>
      <actor name="walker"/><population name="crowd"/><light name="odd" type="laser"/>""",
    )
    why = {row["name"]: row["reason"] for row in report["skipped"]}
    assert "hangs on itself" in why["round"] and "'nowhere' does not exist" in why["lost"]
    assert "people" in why["walker"] and "chance" in why["crowd"] and "laser" in why["odd"] and report["actors"] == 1


def test_every_geometry_has_its_size_and_its_body(tmp_path: Path) -> None:
    shapes = {
        "box": ("<size>1 2 3</size>", (1, 2, 3)),
        "plane": ("<size>4 5</size>", (4, 5, 0)),
        "sphere": ("<radius>0.5</radius>", (1, 1, 1)),
        "cylinder": ("<radius>0.5</radius><length>2</length>", (1, 1, 2)),
        "capsule": ("<radius>0.5</radius><length>2</length>", (1, 1, 3)),
        "cone": ("<radius>0.5</radius><length>2</length>", (1, 1, 2)),
        "ellipsoid": ("<radii>1 2 3</radii>", (2, 4, 6)),
        "polyline": (
            "<point>0 0</point><point>2 0</point><point>2 1</point><point>0 4</point><height>3</height>",
            (2, 4, 3),
        ),
    }
    report = sdf(
        tmp_path,
        "".join(
            f"<model name='{kind}'><link name='l'>"
            f"<visual name='v'><geometry><{kind}>{text}</{kind}></geometry></visual>"
            f"<collision name='c'><geometry><{kind}>{text}</{kind}></geometry></collision></link></model>"
            for kind, (text, _) in shapes.items()
        )
        + "<model name='odd'><link name='l'><visual name='v'><geometry><image/></geometry></visual></link></model>",
    )
    store = PackStore([tmp_path / "packs" / "a"])
    placed = actors_of(report)
    for kind, (_, size) in shapes.items():
        asset = store.asset(str(placed[kind].components[0].static_mesh))
        assert asset is not None and asset.size_m == pytest.approx(size, rel=0.03, abs=0.01), kind
        assert asset.collision_source == "authored", kind
        assert asset.collision[0].kind == {"sphere": "sphere", "capsule": "capsule"}.get(kind, "hull")
    assert "<image>" in report["skipped"][0]["reason"]


def test_parts_of_meshes_scripts_transparency_state_and_lights(tmp_path: Path) -> None:
    (tmp_path / "scene").mkdir()
    (tmp_path / "scene" / "set.obj").write_text(
        "".join(
            f"g {name}\n"
            + "".join(f"v {x + at} {y} {z}\n" for x, y, z in trimesh.creation.box().vertices)
            + "".join(
                f"f {a + 8 * i + 1} {b + 8 * i + 1} {c + 8 * i + 1}\n" for a, b, c in trimesh.creation.box().faces
            )
            for i, (name, at) in enumerate((("seat", 0), ("back", 10)))
        )
    )
    mesh = "<geometry><mesh><uri>{}</uri><scale>1 2 1</scale>{}</mesh></geometry>"
    sub = "<submesh><name>back</name><center>true</center></submesh>"
    script = "<material><script><name>Gazebo/Red</name></script></material><transparency>0.25</transparency>"
    world = f"""
      <model name="part"><link name="l"><visual name="v">{mesh.format("file://set.obj", sub)}{script}</visual></link>
      </model>
      <model name="all"><link name="l"><visual name="v">{mesh.format("set.obj", "")}</visual></link></model>
      <model name="lost"><link name="l"><visual name="v">{mesh.format("old/chair.obj", "")}</visual></link></model>
      <light name="spot" type="spot"><pose>0 0 3 0 0 0</pose><direction>1 0 0</direction>
        <spot><inner_angle>0.5</inner_angle><outer_angle>1.0</outer_angle></spot></light>
      <state world_name="w"><model name="all"><pose>7 0 0 0 0 0</pose></model></state>"""
    with_out = sdf(tmp_path, world)
    assert {row["name"]: row["reason"] for row in with_out["skipped"]} == {"lost": "mesh 'old/chair.obj' is missing"}
    report = sdf(tmp_path, world, meshes=["old/chair.obj=set.obj#seat"], replace=True)
    store, placed = PackStore([tmp_path / "packs" / "a"]), actors_of(report)
    part, lost = (store.asset(str(placed[name].components[0].static_mesh)) for name in ("part", "lost"))
    assert part is not None and part.bounds_max_cm == pytest.approx((50, 100, 50)) and report["skipped"] == []
    assert lost is not None and lost.size_m == pytest.approx((1, 2, 1))
    red = store.material(part.slots[0].material)
    assert red is not None and red.base_color == (1, 0, 0) and red.opacity == 0.75
    assert placed["all"].transform.location_cm == pytest.approx((700, 0, 0))
    assert any("saved state" in row["note"] for row in report["notes"])
    light = placed["Light_spot"]
    assert light.class_path.endswith("SpotLight") and light.transform.rotation_deg == pytest.approx((0, 0, 0))
    assert light.components[0].properties["outer_cone_angle"] == pytest.approx(math.degrees(0.5), abs=0.001)
    with pytest.raises(BadInput, match="has no part 'leg'"):
        sdf(tmp_path, world.split("</model>", 1)[0].replace("back", "leg") + "</model>")
    with pytest.raises(BadInput, match="NAME=FILE"):
        sdf(tmp_path, world, meshes=["nonsense"])


def test_a_gltf_tree_brings_names_instances_lights_and_cameras(tmp_path: Path) -> None:
    made = Gltf()
    made.mesh(made.box((1, 1, 1)))
    half = math.sqrt(0.5)
    made.tree["nodes"] = [
        {"name": "Room", "children": [1, 2, 3, 4], "translation": [0, 0, 1]},
        {"name": "Chair", "mesh": 0},
        {
            "name": "Row",
            "mesh": 0,
            "extensions": {
                "EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": made.accessor([[0, 0, 0], [4, 0, 0]])}}
            },
        },
        {
            "name": "Lamp",
            "translation": [0, 3, 0],
            "rotation": [-half, 0, 0, half],
            "extensions": {"KHR_lights_punctual": {"light": 0}},
        },
        {"name": "View", "camera": 0, "translation": [0, 0, 5]},
    ]
    made.tree |= {
        "extensionsUsed": ["EXT_mesh_gpu_instancing", "KHR_lights_punctual"],
        "extensions": {
            "KHR_lights_punctual": {
                "lights": [
                    {
                        "type": "spot",
                        "intensity": 40,
                        "color": [1, 0.5, 0.25],
                        "range": 6,
                        "spot": {"outerConeAngle": 0.5},
                    }
                ]
            }
        },
        "cameras": [{"type": "perspective", "perspective": {"yfov": 1.0, "aspectRatio": 2.0, "znear": 0.1}}],
    }
    path = made.write(tmp_path / "room.glb")
    report = import_scene(path, "room", suites=tmp_path / "suites", packs=tmp_path / "packs", scale=2.0)
    placed = actors_of(report)
    assert set(placed) == {
        "Room_Chair",
        "Room_Row_0",
        "Room_Row_1",
        "Camera_View",
        "Light_Room_Lamp",
        "Light_Sun",
        "Light_Sky",
    }
    assert placed["Room_Row_1"].folder == "Room" and report["assets"] == 1
    assert placed["Room_Row_1"].transform.location_cm == pytest.approx((800, 200, 0))
    lamp, camera = placed["Light_Room_Lamp"], placed["Camera_View"]
    assert lamp.transform.location_cm == pytest.approx((0, 200, 600))
    assert lamp.transform.rotation_deg[0] == pytest.approx(-90), "it shines down"
    assert lamp.components[0].properties["intensity_units"] == "CANDELAS"
    assert lamp.components[0].properties["attenuation_radius"] == pytest.approx(1200)
    assert camera.transform.location_cm == pytest.approx((0, 1200, 0))
    assert camera.transform.rotation_deg[1] == pytest.approx(-90), "it looks from the front (+Z there, +Y here) back"
    assert camera.components[1].properties["field_of_view"] == pytest.approx(
        math.degrees(2 * math.atan(2 * math.tan(0.5))), abs=0.01
    )


BLENDER = shutil.which("blender")
MAKE = """
import bpy
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.mesh.primitive_cube_add(size=2, location=(1, 2, 3))
bpy.context.object.name = "Crate"
bpy.ops.mesh.primitive_cube_add(size=1)
bpy.context.object.name = "Ghost"
bpy.context.object.hide_render = True
bpy.ops.wm.save_as_mainfile(filepath={!r})
"""


@pytest.mark.skipif(BLENDER is None, reason="Blender is not installed")
def test_a_blender_file_comes_in_through_blender(tmp_path: Path) -> None:
    (tmp_path / "make.py").write_text(MAKE.format(str(tmp_path / "room.blend")))
    subprocess.run([str(BLENDER), "-b", "--python", str(tmp_path / "make.py")], check=True, capture_output=True)
    report = import_scene(tmp_path / "room.blend", "room", suites=tmp_path / "suites", packs=tmp_path / "packs")
    placed = actors_of(report)
    assert {name for name in placed if "Light" not in name} == {"Crate"}
    assert placed["Crate"].transform.location_cm == pytest.approx((100, -200, 300), abs=0.01)
    (tmp_path / "torn.blend").write_bytes(b"BLENDER-v300 torn")
    with pytest.raises(BadInput, match="Blender cannot export"):
        import_scene(tmp_path / "torn.blend", "torn", suites=tmp_path / "suites", packs=tmp_path / "packs")


def test_without_blender_its_files_are_refused_in_a_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    (tmp_path / "room.blend").write_bytes(b"BLENDER")
    with pytest.raises(BadInput, match="Blender, which is not installed"):
        import_scene(tmp_path / "room.blend", "room", suites=tmp_path / "suites", packs=tmp_path / "packs")
