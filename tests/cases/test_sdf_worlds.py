"""SDF worlds as people publish them: unnamed includes, lights alone, submeshes, ground, merged and many files."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from PIL import Image

from c4s.errors import BadInput
from c4s.packs.store import PackStore
from c4s.records.level import Level, LevelActor
from c4s.records.pack import Asset
from cases.importers.importing import import_scene
from cases.standing import snapshot_of, unsound

BOX = (
    "<visual name='v'><geometry><box><size>1 1 1</size></box></geometry></visual>"
    "<collision name='c'><geometry><box><size>1 1 1</size></box></geometry></collision>"
)
MODEL = "<sdf version='1.6'><model name='{name}'><static>true</static><link name='link'>{inside}</link></model></sdf>"


def model(root: Path, name: str, inside: str = BOX, **files: bytes) -> None:
    """Write ``models/<name>/model.sdf`` of one link, and files beside it (``oak_dae``: ``oak.dae``)."""
    folder = root / "models" / name
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "model.sdf").write_text(MODEL.format(name=name, inside=inside))
    for file, data in files.items():
        (folder / file.replace("_", ".")).write_bytes(data)


def imported(root: Path, *worlds: str, **options: Any) -> dict[str, Any]:
    """The report of importing worlds of these elements that lie in ``root/worlds``."""
    (root / "worlds").mkdir(parents=True, exist_ok=True)
    (root / "models").mkdir(exist_ok=True)
    paths = [root / "worlds" / f"w{number}.world" for number in range(len(worlds))]
    for path, inside in zip(paths, worlds, strict=True):
        path.write_text(f"<?xml version='1.0'?><sdf version='1.9'><world name='{path.stem}'>{inside}</world></sdf>")
    return import_scene(paths, "town", suites=root / "suites", packs=root / "packs", replace=True, **options)


def actors_of(report: dict[str, Any]) -> dict[str, LevelActor]:
    """Actors of the imported level by name."""
    return {actor.name: actor for actor in Level.read(Path(report["level"])).actors}


def asset_of(root: Path, report: dict[str, Any], name: str) -> Asset:
    """The asset that an actor of the imported level shows."""
    found = PackStore([root / "packs" / "town"]).asset(str(actors_of(report)[name].components[0].static_mesh))
    assert found is not None
    return found


def test_unnamed_includes_are_called_as_what_they_include(tmp_path: Path) -> None:
    model(tmp_path, "crate")
    include = "<include><uri>model://{}</uri><pose>{} 0 0.5 0 0 0</pose></include>"
    report = imported(
        tmp_path,
        include.format("sun", 0)
        + include.format("ground_plane", 0)
        + include.format("crate", 1)
        + include.format("crate", 3)
        + "<include><uri>https://fuel.example/1.0/people/models/crate/3</uri><pose>5 0 0.5 0 0 0</pose></include>"
        + include.format("ghost", 7)
        + f"<model name='on_ghost'><pose relative_to='ghost'>0 0 1 0 0 0</pose><link name='l'>{BOX}</link></model>",
    )
    names = set(actors_of(report))
    assert names == {"crate", "crate_x2", "crate_x3", "ground_plane", "Light_sun", "Light_Sky"}
    assert {row["name"] for row in report["skipped"]} == {"ghost", "on_ghost"}
    assert report["skipped_kinds"] == {"model is missing": 2}
    assert {row["name"] for row in report["notes"] if "Gazebo's own" in row["note"]} == {"sun", "ground_plane"}
    assert asset_of(tmp_path, report, "ground_plane").size_m[:2] == (100, 100)


def test_lights_alone_are_no_fault_and_what_is_skipped_is_summed(tmp_path: Path) -> None:
    model(tmp_path, "lamp_post", "<light name='bulb' type='point'/><sensor name='s' type='camera'/>")
    (tmp_path / "models/moon").mkdir()
    (tmp_path / "models/moon/model.config").write_text(
        "<model><sdf version='1.4'>old.sdf</sdf><sdf version='1.10'>moon.sdf</sdf></model>"
    )
    (tmp_path / "models/moon/moon.sdf").write_text(
        "<sdf><light name='moon' type='directional'><pose>0 0 9 0 0 0</pose></light></sdf>"
    )
    report = imported(
        tmp_path,
        "<include><uri>model://moon</uri></include><include><name>post</name><uri>model://lamp_post</uri></include>"
        "<light name='bad' type='point'><diffuse>red</diffuse></light><plugin name='p'/><plugin name='q'/>"
        "<actor name='walker'/><population name='crowd'/>"
        f"<model name='crate'><plugin name='r'/><link name='l'>{BOX}</link></model>",
    )
    assert set(actors_of(report)) == {"crate", "Light_moon", "Light_post_bulb", "Light_Sky"}
    assert report["lights"] == 2
    assert report["skipped_kinds"] == {
        "plugin": 3,
        "animated person": 1,
        "population": 1,
        "sensor": 1,
        "is not 3 numbers": 1,
    }


@pytest.mark.parametrize("world", ["", "<plugin name='p'/>", "<include><uri>model://ghost</uri></include>"])
def test_only_a_world_of_which_nothing_is_left_is_bad_input(tmp_path: Path, world: str) -> None:
    with pytest.raises(BadInput, match="no actor of this scene can be placed"):
        imported(tmp_path, world)


def dae(*nodes: tuple[str, str, float]) -> bytes:
    """A DAE file of boxes: name of the node, id of its geometry, and where it stands along X."""
    box = trimesh.creation.box()
    points, faces = " ".join(map(str, box.vertices.ravel())), " ".join(map(str, box.faces.ravel()))
    geometry = (
        '<geometry id="{0}" name="{0}-data"><mesh><source id="{0}-p"><float_array id="{0}-a" count="24">{1}'
        '</float_array><technique_common><accessor source="#{0}-a" count="8" stride="3"><param name="X" type="float"/>'
        '<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>'
        '<vertices id="{0}-v"><input semantic="POSITION" source="#{0}-p"/></vertices>'
        '<triangles count="12"><input semantic="VERTEX" source="#{0}-v" offset="0"/><p>{2}</p></triangles>'
        "</mesh></geometry>"
    )
    shown = "".join(
        f'<node id="n{number}" name="{name}"><translate>{at} 0 0</translate><instance_geometry url="#{mesh}"/></node>'
        for number, (name, mesh, at) in enumerate(nodes)
    )
    geometries = "".join(geometry.format(mesh, points, faces) for mesh in dict.fromkeys(mesh for _, mesh, _ in nodes))
    return (
        '<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><unit meter="1"/>'
        f"<up_axis>Z_UP</up_axis></asset><library_geometries>{geometries}</library_geometries><library_visual_scenes>"
        f'<visual_scene id="s">{shown}</visual_scene></library_visual_scenes><scene>'
        '<instance_visual_scene url="#s"/></scene></COLLADA>'
    ).encode()


def test_a_submesh_is_the_node_of_its_name(tmp_path: Path) -> None:
    tree = dae(("Branch", "Cube_002-mesh", 4), ("Bark", "Cube_001-mesh", 0), ("Bark2", "Cube_001-mesh", 9))
    part = (
        "<visual name='{0}'><geometry><mesh><uri>model://oak/oak.dae</uri><submesh><name>{0}</name>"
        "<center>{1}</center></submesh></mesh></geometry></visual>"
    )
    for name, shown in (("oak", "Branch"), ("trunk", "bark"), ("far", "Bark2"), ("by_id", "Cube_002-mesh")):
        model(tmp_path, name, part.format(shown, "false"), **({"oak_dae": tree} if name == "oak" else {}))
    model(tmp_path, "middle", part.format("Branch", "true"))
    model(tmp_path, "leafless", part.format("Leaf", "false"))
    names = ("oak", "trunk", "far", "by_id", "middle", "leafless")
    report = imported(tmp_path, "".join(f"<include><uri>model://{name}</uri></include>" for name in names))
    low = {name: asset_of(tmp_path, report, name).bounds_min_cm[0] for name in names[:-1]}
    assert low == pytest.approx({"oak": 350, "trunk": -50, "far": 850, "by_id": 350, "middle": -50}, abs=0.01)
    assert [row["name"] for row in report["skipped"]] == ["leafless"]


def png(levels: Any, mode: str = "L") -> bytes:
    """A picture of grey levels, of 8 bits (``L``) or 16."""
    out = io.BytesIO()
    Image.fromarray(np.asarray(levels, np.uint8 if mode == "L" else np.uint16)).save(out, format="PNG")
    return out.getvalue()


HEIGHTMAP = (
    "<geometry><heightmap><uri>model://hills/hills.png</uri><size>64 64 8</size><pos>0 0 -4</pos>{}</heightmap>"
    "</geometry>"
)


@pytest.mark.parametrize("mode", ["L", "I;16"])
def test_a_heightmap_is_ground_that_carries(tmp_path: Path, mode: str) -> None:
    """A plateau at 4 m (grey level half) in the near west, black elsewhere, one white pixel at 8 m in the far east."""
    levels = np.zeros((65, 65))
    levels[40:, :30], levels[2, 60] = 128, 256
    levels = levels - (levels > 0) if mode == "L" else levels * 200
    shown = HEIGHTMAP.format("<texture><diffuse>grass.png</diffuse><size>4</size></texture>")
    model(
        tmp_path,
        "hills",
        f"<visual name='v'>{shown}</visual><collision name='c'>{HEIGHTMAP.format('')}</collision>",
        hills_png=png(levels, mode),
        grass_png=png(np.full((8, 8), 90)),
    )
    place = f"<model name='{{}}'><pose>{{}} {{}} {{}} 0 0 0</pose><link name='l'>{BOX}</link></model>"
    top = 4 * (127 / 255 * 2 if mode == "L" else 1) - 4
    report = imported(
        tmp_path,
        "<include><uri>model://hills</uri></include>"
        + place.format("on_plateau", -20, -20, top + 0.502)
        + place.format("in_valley", 10, -20, -4 + 0.502)
        + place.format("floats", 10, 20, 0.502),
    )
    ground = asset_of(tmp_path, report, "hills")
    assert ground.size_m == pytest.approx((64, 64, 8)) and ground.bounds_max_cm[2] == pytest.approx(400)
    assert ground.collision_source == "authored" and 20 < len(ground.collision) < 700
    level = Level.read(Path(report["level"]))
    bad = unsound(snapshot_of(level, [tmp_path / "packs" / "town"]))
    assert bad & {"on_plateau", "in_valley", "floats"} == {"floats"}
    surface = PackStore([tmp_path / "packs" / "town"]).material(ground.slots[0].material)
    assert surface is not None and surface.texture is not None


def test_roads_are_ground_of_their_width(tmp_path: Path) -> None:
    report = imported(
        tmp_path,
        "<road name='road_1'><width>4</width><point>0 0 0.01</point><point>20 0 0.01</point><point>20 20 0.01</point>"
        "</road><road name='walk'><width>2</width><point>0 5 0</point><point>9 5 0</point>"
        "<material><script><name>Gazebo/Pedestrian</name></script></material></road>"
        "<road name='stub'><width>2</width><point>0 5 0</point></road>"
        f"<model name='car'><pose>20 10 0.512 0 0 0</pose><link name='l'>{BOX}</link></model>",
    )
    road = asset_of(tmp_path, report, "road_1")
    assert road.size_m[:2] == pytest.approx((22, 22)) and len(road.collision) == 2
    assert actors_of(report)["road_1"].transform.location_cm == pytest.approx((1000, -1000, 1))
    assert asset_of(tmp_path, report, "walk").size_m[:2] == pytest.approx((9, 2))
    assert [row["name"] for row in report["skipped"]] == ["stub"]
    assert "car" not in unsound(snapshot_of(Level.read(Path(report["level"])), [tmp_path / "packs" / "town"]))


def test_worlds_of_several_files_join(tmp_path: Path) -> None:
    model(tmp_path, "crate")
    (tmp_path / "worlds").mkdir(exist_ok=True)
    (tmp_path / "worlds/yard.sdf").write_text(
        "<sdf><world name='yard'><include><uri>model://crate</uri><pose>1 0 0 0 0 0</pose></include></world></sdf>"
    )
    crate = "<include><name>{}</name><uri>model://crate</uri><pose>{} 0 0 0 0 0</pose></include>"
    yard = "<include><name>yard</name><uri>yard.sdf</uri><pose degrees='true'>10 0 0 0 0 90</pose></include>"
    report = imported(tmp_path, crate.format("a", 3) + yard, crate.format("b", 5) + crate.format("a", 7))
    where = {name: actor.transform.location_cm for name, actor in actors_of(report).items() if "Light" not in name}
    assert set(where) == {"a", "b", "a_x2", "yard_crate"} and report["assets"] == 1
    assert where["yard_crate"] == pytest.approx((1000, -100, 0)) and where["a_x2"] == pytest.approx((700, 0, 0))
    (tmp_path / "table.csv").write_text("")
    with pytest.raises(BadInput, match="only SDF worlds join"):
        both = [tmp_path / "worlds/w0.world", tmp_path / "table.csv"]
        import_scene(both, "x", suites=tmp_path / "suites", packs=tmp_path / "packs")


def test_models_of_other_folders_are_found_where_they_are_named(tmp_path: Path) -> None:
    model(tmp_path / "elsewhere", "crate")
    world = f"<include><uri>model://crate</uri></include><model name='b'><link name='l'>{BOX}</link></model>"
    assert imported(tmp_path / "here", world)["actors"] == 1
    report = imported(tmp_path / "here", world, resources=[tmp_path / "elsewhere/models"])
    assert set(actors_of(report)) >= {"crate", "b"} and report["skipped"] == []
    with pytest.raises(BadInput, match="no such folder"):
        imported(tmp_path / "here", world, resources=[tmp_path / "nowhere"])


def test_a_merged_include_is_a_part_of_its_parent(tmp_path: Path) -> None:
    model(tmp_path, "seat", BOX)
    report = imported(
        tmp_path,
        f"<model name='chair'><pose>5 0 0 0 0 0</pose><link name='leg'>{BOX}</link>"
        "<include merge='true'><uri>model://seat</uri><pose degrees='true'>0 0 2 0 0 90</pose></include>"
        "<frame name='over' attached_to='link'><pose>0 0 1 0 0 0</pose></frame></model>"
        f"<model name='hat'><pose relative_to='chair::over'>0 0 0 0 0 0</pose><link name='l'>{BOX}</link></model>",
    )
    assert set(actors_of(report)) == {"chair", "hat", "Light_Sun", "Light_Sky"} and report["skipped"] == []
    chair = asset_of(tmp_path, report, "chair")
    assert chair.size_m == pytest.approx((1, 1, 3)) and len(chair.collision) == 2
    assert actors_of(report)["hat"].transform.location_cm == pytest.approx((500, 0, 300))


def test_a_file_of_a_model_is_a_scene(tmp_path: Path) -> None:
    model(tmp_path, "crate")
    report = import_scene(
        tmp_path / "models/crate/model.sdf", "town", suites=tmp_path / "suites", packs=tmp_path / "packs"
    )
    assert set(actors_of(report)) == {"crate", "Light_Sun", "Light_Sky"}


def test_broken_scripts_and_pictures_cost_their_own_thing_alone(tmp_path: Path) -> None:
    script = (
        b"material Odd/Base\n{ diffuse 1 0 0\n texture broken.png\n scale 1e 2\n}\nmaterial Odd/One : Odd/Base\n{}\n"
    )
    painted = "<material><script><name>Odd/One</name></script></material>"
    inside = f"{BOX}<visual name='w'><geometry><box/></geometry>{painted}</visual>"
    model(tmp_path, "crate", inside, odd_material=script, broken_png=b"no picture")
    report = imported(tmp_path, "<include><uri>model://crate</uri></include>")
    assert report["actors"] == 1 and any("broken.png" in row["note"] for row in report["notes"])
    colours = {
        material.base_color
        for slot in asset_of(tmp_path, report, "crate").slots
        if (material := PackStore([tmp_path / "packs" / "town"]).material(slot.material)) is not None
    }
    assert (1.0, 0.0, 0.0) in colours
