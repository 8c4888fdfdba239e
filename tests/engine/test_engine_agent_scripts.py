"""Scripts as agents write them, run unchanged; what each one saved is read by another, clean engine process.

Every script of ``scripts/`` saves ``/Game/SavedScenes/<its name>``. The clean process knows the pack and what the
scripts saved, nothing else.
"""

from __future__ import annotations

import itertools
import json
import math
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from script_stage import SIZES_CM, make_pack, start_level

from c4s.engine.headless.process.boot import boot

SCRIPTS = sorted((Path(__file__).parent / "scripts").glob("*.py"))
CLEAN = """
import json, sys
from hashlib import sha256
from pathlib import Path
from c4s.engine.headless.process.boot import boot
content, pack, out, names = Path(sys.argv[1]), Path(sys.argv[2]), Path(sys.argv[3]), sys.argv[4:]
unreal = boot([pack], content)
from c4s.editor.dependencies import export_dependencies
from c4s.editor.snapshot import export_snapshot
found = {}
actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
for name in names:
    if unreal.EditorLoadingAndSavingUtils.load_map("/Game/SavedScenes/" + name) is not None:
        volumes = [each for each in actors.get_all_level_actors() if isinstance(each, unreal.PostProcessVolume)]
        exposure = {each.get_actor_label(): each.settings.auto_exposure_bias for each in volumes}
        found[name] = {**export_snapshot(), "dependencies": export_dependencies(), "exposure": exposure}
out.write_text(json.dumps(found, allow_nan=False))
"""


@pytest.fixture(scope="module")
def saved(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """Snapshots of all saved scenes, by script name."""
    home = tmp_path_factory.mktemp("scripts")
    pack, level = make_pack(home / "pack"), start_level(home)
    content = home / "project" / "Content"
    failed: dict[str, BaseException] = {}
    for script in SCRIPTS:
        boot([pack], content, levels=[level])
        try:
            run(script)
        except Exception as error:
            failed[script.stem] = error
    out = home / "found.json"
    subprocess.run(
        [sys.executable, "-c", CLEAN, str(content), str(pack), str(out), *(s.stem for s in SCRIPTS)],
        check=True,
        timeout=200,
    )
    return {**json.loads(out.read_text()), **failed}


def run(script: Path) -> None:
    """Run a script as the engine's job runner does: in a fresh main namespace."""
    exec(compile(script.read_text(encoding="utf-8"), script.name, "exec"), {"__name__": "__main__"})


class Scene:
    """A saved scene, as its snapshot tells it."""

    def __init__(self, shot: dict[str, Any]) -> None:
        self.actors = {actor["label"]: actor for actor in shot["actors"]}
        self.rows = shot["actors"]
        self.unresolved = shot["dependencies"]["unresolved"]
        self.exposure: dict[str, float] = shot["exposure"]

    def count(self, part: str) -> int:
        return sum(part in label for label in self.actors)

    def at(self, label: str) -> list[float]:
        return self.actors[label]["transform"]["location_cm"]

    def turned(self, label: str) -> list[float]:
        return self.actors[label]["transform"]["rotation_deg"]

    def scale(self, label: str) -> list[float]:
        return self.actors[label]["transform"]["scale"]

    def near(self, label: str, *wanted: float) -> bool:
        return all(abs(a - b) < 0.01 for a, b in zip(self.at(label), wanted, strict=True))


def village(s: Scene) -> None:
    assert len(s.rows) == 11 and s.near("House_05", -2000, 800, 0) and s.near("House_04", 2000, -800, 0)
    assert s.turned("House_00") == pytest.approx([0, 90, 0]) and s.turned("House_09") == pytest.approx([0, -90, 0])
    assert s.scale("Ground") == [100, 100, 1]


def rig(s: Scene) -> None:
    assert s.turned("Rig_Sun") == pytest.approx([-42, -35, 0])
    sun, lamp, spot = (s.actors[f"Rig_{n}"]["properties"] for n in ("Sun", "Lamp1", "Spot"))
    assert sun["intensity"] == pytest.approx(7.5) and sun["light_color"][3] == 255
    assert lamp["intensity"] == 50 and lamp["intensity_units"] == "<LightUnits.CANDELAS: 1>"
    assert spot["light_color"][:3] == [255, 0, 0]
    assert s.turned("Rig_Spot") == pytest.approx([-45, 90, 0])
    assert s.exposure == {"Rig_PPV": 0.5}


def forest(s: Scene) -> None:
    (host,) = s.rows
    parts = [c for c in host["c4s"]["components"] if c["mesh"]]
    assert host["label"] == "Forest" and len(parts) >= 1
    assert host["component_asset_paths"] == ["/Game/Props/SM_Tree.SM_Tree"]
    low = host["bounds"]["origin_cm"][0] - host["bounds"]["extent_cm"][0]
    assert -4200 < low < -3000


def fence(s: Scene) -> None:
    around = math.pi * (3 * 2500 - math.sqrt((3 * 1500 + 1000) * (1500 + 3 * 1000)))
    assert abs(len(s.rows) - around / 200) < 5
    for actor in s.rows:
        x, y, _ = actor["transform"]["location_cm"]
        yaw = math.radians(actor["transform"]["rotation_deg"][1])
        tangent = math.atan2(x / 1500 * 1000, -y / 1000 * 1500)
        assert abs(math.remainder(yaw - tangent, math.tau)) < 0.15
        assert "fence" in actor["actor_tags"]


def snapped(s: Scene) -> None:
    for label in ("House_A", "Tree_A", "Tree_B", "Rock_A", "Bench_A"):
        bounds = s.actors[label]["bounds"]
        assert abs(bounds["origin_cm"][2] - bounds["extent_cm"][2]) < 1, label
    assert s.at("Tree_A")[:2] == [900, 0] and s.near("Bench_A", -300, -900, 0)


def paints(s: Scene) -> None:
    used = [s.actors[f"Box_{n}"]["material_paths"] for n in ("Red", "Green", "Blue")]
    assert used == [[f"/Game/Generated/Materials/MI_Paint_{n}.MI_Paint_{n}"] for n in ("Red", "Green", "Blue")]
    assert s.unresolved == []


def organized(s: Scene) -> None:
    assert set(s.actors) == {
        "Tree_01",
        "Tree_02",
        "Tree_03",
        "Rock_01",
        "Building_01",
        "Light_01",
        "Misc_01",
        "Misc_02",
    }


def repaired(s: Scene) -> None:
    assert "Rock_A" not in s.actors and s.near("House_A", 0, 0, 0)
    assert s.turned("House_A") == pytest.approx([0, 35, 0])
    assert s.scale("Tree_B") == [1, 1, 1] and s.turned("Tree_A") == pytest.approx([0, 45, 0])


def parking(s: Scene) -> None:
    assert s.count("Line_") == 24 and s.count("Car_") == 8
    assert s.near("Car_1_2", 625, 1100, 75) and s.scale("Car_0_0") == pytest.approx([1.8, 4.2, 1.5])
    assert not s.actors["Line_0_0"]["collision"]["collision_enabled"]


def furniture(s: Scene) -> None:
    assert s.near("TableTop", 0, 0, 75) and s.near("Leg_0", 40, -90, 35) and s.near("Leg_3", -40, 90, 35)
    assert s.near("DeskLamp", 0, 0, 115)
    assert s.actors["Leg_0"]["attachment_parent_label"] == "TableTop"
    assert s.actors["Leg_3"]["attachment_parent_label"] is None


def gates(s: Scene) -> None:
    assert sorted(s.actors) == ["Gate_East", "Gate_North", "Gate_South", "Gate_West"]
    assert s.near("Gate_East", 0, 1000, 0) and s.turned("Gate_North") == pytest.approx([0, 90, 0])
    assert s.actors["Gate_West"]["class"] == "/Game/Props/BP_Gate.BP_Gate_C"
    assert s.actors["Gate_West"]["material_paths"] == ["/Game/Props/M_Stone.M_Stone"]


def samples(s: Scene) -> None:
    assert sorted(s.actors) == [f"Sample_{n}" for n in sorted(SIZES_CM)]
    assert s.near("Sample_Bench", 80, 0, 0) and s.near("Sample_Fence", 360, 0, 0)


def rebuilt(s: Scene) -> None:
    assert sorted(s.actors) == ["GEN_Block_1", "GEN_Block_2", "GEN_Block_3", "GEN_Block_4", "GEN_Copy", "Keeper"]
    assert s.near("GEN_Copy", 500, 300, 50)


def tower(s: Scene) -> None:
    assert s.count("Step_") == 36 and s.near("Step_09", -300, 0, 237.5) and s.near("Step_18", 300, 0, 462.5)
    assert abs(abs(s.turned("Step_09")[1]) - 180) < 0.01 and s.scale("Tower_Core") == pytest.approx([2.5, 2.5, 9])
    assert s.actors["Tower_Beacon"]["properties"]["intensity"] == 8000


def tagged(s: Scene) -> None:
    assert s.actors["House_A"]["actor_tags"] == ["building", "static", "landmark"]
    assert s.actors["Tree_A"]["actor_tags"] == ["vegetation", "static"]
    assert ("Tree_B" in s.actors) != ("Tree_B_copy" in s.actors)


def balls(s: Scene) -> None:
    slots = [s.actors[f"Ball_{i}"]["component_material_slots"][0] for i in range(5)]
    assert all(slot["is_dynamic"] for slot in slots) and s.near("Ball_4", 480, 0, 50)


def scattered(s: Scene) -> None:
    rocks = [s.at(f"Rock_{i:02d}") for i in range(1, 26)]
    assert min(math.dist(a[:2], b[:2]) for i, a in enumerate(rocks) for b in rocks[:i]) >= 300
    assert s.near("Rock_01", *first_point_of_stream())


def first_point_of_stream() -> tuple[float, float, float]:
    """First point of the generator of seed 1234 in the area of the script that lies clear of both houses."""
    seed, found = 1234, []

    def fraction() -> float:
        nonlocal seed
        seed = (seed * 196314165 + 907633515) % 2**32
        return (seed >> 9) / 2**23

    while not found:
        x, y, _ = -2000 + 5000 * fraction(), -2000 + 4000 * fraction(), fraction()
        if not any(abs(x - hx) < 450 and abs(y - hy) < 400 for hx, hy in ((0, 0), (1500, 300))):
            found = [x, y]
    return found[0], found[1], 0.0


def orbit(s: Scene) -> None:
    assert s.near("Cam_0", 600, 0, 400) and s.count("Cam_") == 6
    assert s.turned("Cam_0") == pytest.approx([-math.degrees(math.atan2(300, 600)), 180, 0])


def room(s: Scene) -> None:
    assert s.near("Wall_S_Lintel", 400, -10, 255) and s.scale("Wall_S_Lintel") == pytest.approx([1, 0.2, 0.9])
    assert s.turned("CeilingLight") == pytest.approx([-90, 0, 0]) and len(s.rows) == 9


def mirrored(s: Scene) -> None:
    for i in range(4):
        assert s.near(f"Bench_L{i}", -(300 + 200 * i), 100 * i, 0) and s.scale(f"Bench_L{i}") == [1, -1, 1]
        assert s.turned(f"Bench_L{i}")[1] == pytest.approx(180 - 15 * i)


def housekept(s: Scene) -> None:
    assert s.unresolved == []
    for label, wanted in (("Bench_0", "MI_Keep"), ("Bench_1", "MI_Keep"), ("Bench_Plain", "M_WoodDark")):
        assert s.actors[label]["material_paths"] == [f"/Game/Variants/{wanted}.{wanted}"], label


def subject(s: Scene) -> None:
    assert list(s.actors) == ["Subject"]


def terraces(s: Scene) -> None:
    assert s.count("T_") == 144 and s.near("Flag", 1000, 1000, 500) and s.scale("T_00_00")[2] == 0.5
    assert all(abs(s.scale(f"T_{i:02}_05")[2] * 2 % 1) < 1e-6 for i in range(12))


def town(s: Scene) -> None:
    assert s.count("House_") == 6 and s.count("Tree_") == 6
    assert s.near("House_1_2", 900, 1800, 0) and s.near("Tree_0_1", -660, 450, 0)


def merged(s: Scene) -> None:
    (host,) = s.rows
    assert host["component_asset_paths"] == ["/Game/Props/SM_Post.SM_Post", "/Game/Props/SM_Rock.SM_Rock"]
    assert host["bounds"]["origin_cm"][0] == pytest.approx(950, abs=80)


def clock(s: Scene) -> None:
    assert s.near("Hour_00", 0, 0, 500) and s.near("Hour_06", 0, 0, 100)
    assert s.near("Hour_03", -200 * math.sin(math.radians(30)), 200 * math.cos(math.radians(30)), 300)
    assert s.scale("Hour_07") == pytest.approx([0.2, 0.2, 0.4])


def probed(s: Scene) -> None:
    assert s.near("Probe", 10, 20, 30) and s.scale("Probe") == [1, 1, 2]
    assert s.actors["ProbeLight"]["properties"]["intensity"] == 1234


def lamps(s: Scene) -> None:
    assert s.turned("Sun") == pytest.approx([-60, 120, 0]) and s.actors["Sun"]["properties"]["intensity"] == 3
    assert [s.actors[f"Lamp_{i}"]["properties"]["intensity"] for i in (0, 2, 4)] == [1500] * 3
    assert s.actors["Lamp_4"]["properties"]["light_color"][:3] == [0, 0, 255]


def extended(s: Scene) -> None:
    assert sorted(s.actors) == ["Empty", "Post_0", "Post_1", "Post_2", "Rail_0", "Rail_1"]
    assert s.near("Rail_1", 450, 0, 0) and s.actors["Empty"]["asset_path"] == "/Engine/BasicShapes/Sphere.Sphere"


def markup(s: Scene) -> None:
    own = [row for row in s.rows if row["class"] != "/Script/NavigationSystem.RecastNavMesh"]
    assert len(own) == 7 and len(s.rows) == 8, "a navigation volume brings the navigation data with it"
    assert s.actors["Nav"]["bounds"]["extent_cm"] == pytest.approx([1500, 1000, 500])
    assert s.actors["Goal"]["class"] == "/Script/Engine.TargetPoint"


def stacked(s: Scene) -> None:
    tops = sorted(
        (
            a["bounds"]["origin_cm"][2] - a["bounds"]["extent_cm"][2],
            a["bounds"]["origin_cm"][2] + a["bounds"]["extent_cm"][2],
        )
        for a in s.rows
    )
    assert all(abs(low - top) < 0.01 for (_, top), (low, _) in itertools.pairwise(tops))
    assert tops[-1][1] == pytest.approx(50 + 100 + 80 + 50 + 50)


def foliage(s: Scene) -> None:
    trees, rocks = (
        next(part for part in s.actors[name]["c4s"]["components"] if part["mesh"])["instances"]
        for name in ("Foliage_Trees", "Foliage_Rocks")
    )
    assert len(trees) + len(rocks) == 80 and max(t["location_cm"][2] for t in trees) > 30
    assert all(abs(t["rotation_deg"][0]) < 1e-6 and abs(t["rotation_deg"][2]) < 1e-6 for t in trees)
    assert any(abs(r["rotation_deg"][0]) + abs(r["rotation_deg"][2]) > 1 for r in rocks)


def building(s: Scene) -> None:
    assert s.near("Block_A", 2000, -500, 20) and s.turned("Block_A") == pytest.approx([0, 90, 0])
    assert s.actors["Block_A_Bench"]["attachment_parent_label"] == "Block_A_Slab_0"
    assert s.near("Block_A_Bench", 1800, -500, 20) and s.turned("Block_A_Bench") == pytest.approx([0, 135, 0])
    assert s.near("Block_A_N_1_2", 1600, -100, 470) and s.near("Block_A_Lamp", 2000, -500, 280)
    assert s.actors["Gate_Standalone"]["class"] == s.actors["Block_A_Door"]["class"] == "/Game/Props/BP_Gate.BP_Gate_C"
    assert s.count("Block_A") == 25 + 1 and s.near("Gate_Standalone", 0, 0, 0)


def mood(s: Scene) -> None:
    assert s.actors["Sun"]["properties"]["temperature"] == 3200 and s.turned("Moon") == pytest.approx([-40, 60, 0])
    assert s.actors["HeightFog"]["properties"]["fog_density"] == pytest.approx(0.035)
    assert s.exposure == {"PPV_Global": -0.5, "PPV_Indoor": 1.0}
    assert s.actors["PPV_Indoor"]["bounds"]["extent_cm"] == pytest.approx([300, 200, 150])
    head = s.actors["LampHead_3"]
    assert head["attachment_parent_label"] == "LampPost_3" and head["properties"]["light_color"][:3] == [255, 190, 110]
    assert s.actors["Cam_Hero"]["class"] == "/Script/CinematicCamera.CineCameraActor"
    assert s.turned("Cam_Hero")[1] == pytest.approx(math.degrees(math.atan2(1000, 1500)))


def library(s: Scene) -> None:
    assert s.unresolved == []
    used = {label: actor["material_paths"] for label, actor in s.actors.items()}
    assert used["Wall_Worn"] == ["/Game/MaterialLib/Worn/MI_BrickWorn.MI_BrickWorn"]
    assert used["Wall_Blue"] == ["/Game/MaterialLib/MI_BrickBlue.MI_BrickBlue"] and len(used) == 5


def edited(s: Scene) -> None:
    assert len(s.rows) == 7 and s.actors["Tree_A"]["actor_tags"] == ["plant", "classified"]
    assert s.turned("House_A") == pytest.approx([0, 35, 0])
    (tall,) = {"Tree_B", "Tree_B_copy"} & set(s.actors)
    assert s.scale(tall) == pytest.approx([3 ** (1 / 3)] * 3)
    low = [s.actors[n]["bounds"]["origin_cm"][2] - s.actors[n]["bounds"]["extent_cm"][2] for n in ("Rock_A", "Bench_A")]
    assert low == pytest.approx([0, 0], abs=0.01)


def in_place(s: Scene) -> None:
    assert s.near("Crate_01", 0, 0, 50) and s.near("Cube", 200, 0, 50) and s.near("Cube2", 400, 0, 50)
    assert s.turned("Cube2") == pytest.approx([0, 30, 0]) and s.near("Crate_02", 0, 0, 150)
    assert sorted(s.actors["Crate_02"]["actor_tags"]) == ["crate", "stacked"]
    assert s.exposure == {"Mood": 0.75}
    assert s.actors["Fog"]["properties"]["fog_density"] == pytest.approx(0.02)


OUTCOMES: dict[str, Callable[[Scene], None]] = {
    "s01_village_street": village,
    "s02_lighting_rig": rig,
    "s03_hism_forest": forest,
    "s04_fence_around_yard": fence,
    "s05_ground_snap": snapped,
    "s06_materials_and_instances": paints,
    "s07_organize_outliner": organized,
    "s08_repair_rotations": repaired,
    "s09_parking_lot": parking,
    "s10_attach_furniture": furniture,
    "s11_blueprint_gates": gates,
    "s12_asset_search": samples,
    "s13_delete_and_rebuild": rebuilt,
    "s14_spiral_tower": tower,
    "s15_tag_pass": tagged,
    "s16_dynamic_materials": balls,
    "s17_scatter_rejection": scattered,
    "s18_camera_orbit": orbit,
    "s19_room_with_walls": room,
    "s20_mirror_copies": mirrored,
    "s21_asset_housekeeping": housekept,
    "s22_capture_pose_check": subject,
    "s23_terraces": terraces,
    "s24_town_from_spec": town,
    "s25_merge_to_hism": merged,
    "s26_transform_chain": clock,
    "s27_version_tolerant": probed,
    "s28_batch_light_edit": lamps,
    "s29_save_twice_extend": extended,
    "s30_level_markup": markup,
    "s31_stack_by_bounds": stacked,
    "s32_foliage_on_hills": foliage,
    "s33_modular_building": building,
    "s34_evening_mood": mood,
    "s35_material_library": library,
    "s36_mass_edit": edited,
    "s37_mood_in_place": in_place,
}


def test_every_script_has_an_outcome():
    assert [script.stem for script in SCRIPTS] == sorted(OUTCOMES)


@pytest.mark.parametrize("name", sorted(OUTCOMES))
def test_what_a_script_saved(saved, name):
    assert name in saved, "the script saved no such scene"
    if isinstance(saved[name], Exception):
        raise saved[name]
    OUTCOMES[name](Scene(saved[name]))
