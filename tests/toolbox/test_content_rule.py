"""What a scene may be made of (``c4s.protocol.content``), by class: a tool, a script and the gate say the same."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from made_case import make_case, make_pack, path_of

from c4s.engine import DEFAULT_ENGINE, Engine, open_engine
from c4s.evidence import open_clean
from c4s.files import read_json
from c4s.records.evidence import ManifestDigests
from c4s.records.folder import EvidenceFolder
from c4s.records.level import Level
from c4s.records.pack import Asset, BlueprintPart, Pack
from c4s.run.inputs import offered
from c4s.toolbox.catalog import CaseCatalog
from c4s.toolbox.refusal import ToolRefused
from c4s.toolbox.registry import TOOLS
from c4s.toolbox.workbench import Workbench
from c4s.verify.integrity.verdict import verify_integrity

OTHER, COPY = "/Game/Elsewhere/SM_thing.SM_thing", "/Game/Mine/SM_copy.SM_copy"
LOADED = "unreal.load_asset('{}')"
COPIED = "unreal.EditorAssetLibrary.duplicate_asset('{}', '{}')"
MADE = (
    "unreal.AssetToolsHelpers.get_asset_tools().create_asset("
    "'MI_made', '/Game/Mine', unreal.MaterialInstanceConstant, unreal.MaterialInstanceConstantFactoryNew())"
)
SAVED = "/Game/SavedScenes"


@dataclass(frozen=True)
class Thing:
    """A class of thing: what a script places (an expression), by what tool and path, and what the rule says."""

    name: str
    expression: str
    may: bool
    tool: str = ""
    path: str = ""
    surface: str = ""
    """An expression for a material of it."""


def mesh(name: str, path: str, may: bool) -> Thing:
    return Thing(name, LOADED.format(path), may, "spawn_actor", path)


def blueprint(name: str, path: str, may: bool) -> Thing:
    return Thing(name, f"unreal.load_class(None, '{path}_C')", may, "spawn_blueprint_actor", path)


CUBE = LOADED.format("/Engine/BasicShapes/Cube")
THINGS = [
    mesh("mesh of the catalog", path_of("SM_crate"), True),
    blueprint("Blueprint of the catalog", path_of("BP_stacked_table"), True),
    mesh("part of a Blueprint of the catalog", path_of("SM_oak_table"), True),
    mesh("mesh of the start level", path_of("SM_floor_tile"), True),
    mesh("mesh of the pack alone", path_of("SM_sofa"), False),
    blueprint("Blueprint of the pack alone", path_of("BP_seat"), False),
    mesh("mesh of no pack of the case", OTHER, False),
    mesh("basic shape", "/Engine/BasicShapes/Cube.Cube", True),
    mesh("engine content", "/Engine/EngineMeshes/Sphere.Sphere", True),
    blueprint("Blueprint of the engine", "/Engine/EngineSky/BP_Sky_Sphere.BP_Sky_Sphere", True),
    Thing("light", "unreal.PointLight", True),
    Thing("volume", "unreal.PostProcessVolume", True),
    Thing("camera", "unreal.CameraActor", True),
    Thing("material of the pack", CUBE, True, surface=LOADED.format(path_of("M_plain"))),
    Thing("material of the engine", CUBE, True, surface=LOADED.format("/Engine/BasicShapes/BasicShapeMaterial")),
    Thing("material that was made", CUBE, True, surface=MADE),
    Thing("copy of a mesh", COPIED.format(path_of("SM_crate"), COPY.split(".")[0]), True, "spawn_actor", COPY),
    Thing("copy of a mesh of the pack alone", COPIED.format(path_of("SM_sofa"), "/Game/Mine/SM_other"), False),
]
PLACE = """
import unreal
thing, surface = {expression}, {surface}
place = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
spawn = place.spawn_actor_from_class if isinstance(thing, (type, unreal.Class)) else place.spawn_actor_from_object
actor = None if thing is None else spawn(thing, unreal.Vector(0, 0, 500))
if {needs_surface}:
    actor = actor if surface is not None else None
    actor.static_mesh_component.set_material(0, surface)
    unreal.EditorAssetLibrary.save_loaded_asset(surface)
if thing is not None and isinstance(thing, unreal.StaticMesh):
    unreal.EditorAssetLibrary.save_loaded_asset(thing)
print("placed", actor is not None)
"""
SAVE = "\nunreal.EditorLoadingAndSavingUtils.save_map(place.get_world(), '{}')"


def script(thing: Thing) -> str:
    return PLACE.format(expression=thing.expression, surface=thing.surface or None, needs_surface=bool(thing.surface))


@pytest.fixture(scope="module")
def case(tmp_path_factory: pytest.TempPathFactory) -> tuple[Any, Path, Path]:
    """A case whose catalog is a crate and a Blueprint of its pack, and whose start level shows a floor."""
    root = tmp_path_factory.mktemp("rule")
    pack = make_pack(root)
    manifest = Pack.read(pack / "pack.json")
    seat = Asset(
        id="seat",
        name="Seat",
        kind="blueprint",
        path=path_of("BP_seat"),
        category="Seating",
        bounds_min_cm=(-100, -45, 0),
        bounds_max_cm=(100, 45, 80),
        parts=[BlueprintPart(name="Sofa", asset=path_of("SM_sofa"))],
    )
    manifest.model_copy(update={"assets": [*manifest.assets, seat]}).write(pack / "pack.json")
    made, folder = make_case(root, pack)
    start = Level.read(folder / "start.level.json")
    start.model_copy(update={"actors": start.actors[:1]}).write(folder / "start.level.json")
    named = [path_of("SM_crate"), f"{path_of('BP_stacked_table')}_C"]
    return made.model_copy(update={"catalog": named}), folder, pack


def engine_of(root: Path, case: tuple[Any, Path, Path], *, whole: bool) -> Engine:
    made, folder, pack = case
    return open_engine(
        DEFAULT_ENGINE,
        packs=[pack],
        content=root / "content",
        scratch=root / "scratch",
        levels=[folder / "start.level.json"],
        start_map=made.start_map,
        offered=None if whole else offered(made, folder),
    )


@pytest.fixture(scope="module")
def agents(case: tuple[Any, Path, Path], tmp_path_factory: pytest.TempPathFactory) -> Iterator[Workbench]:
    """What an agent works on."""
    root = tmp_path_factory.mktemp("agents")
    with engine_of(root, case, whole=False) as engine:
        yield Workbench(case[0], case[1], CaseCatalog.load(case[0], [case[2]]), engine, root / "scratch")


def output(engine: Any, source: str) -> str:
    return "\n".join(engine.execute(source)["result"]["python_logs"])


@pytest.mark.parametrize("thing", THINGS, ids=[thing.name for thing in THINGS])
def test_a_script_may_place_what_the_rule_allows(agents: Workbench, thing: Thing) -> None:
    assert ("placed True" in output(agents.engine, script(thing))) is thing.may


@pytest.mark.parametrize("thing", [t for t in THINGS if t.tool], ids=[t.name for t in THINGS if t.tool])
def test_a_tool_places_the_same(agents: Workbench, thing: Thing) -> None:
    label, asset = {"spawn_actor": ("name", "static_mesh"), "spawn_blueprint_actor": ("actor_name", "blueprint_id")}[
        thing.tool
    ]
    for path in (thing.path, thing.path.split(".")[0]):
        try:
            TOOLS[thing.tool].run(agents, {label: f"{thing.name} {path}", asset: path, "location": [0, 0, 900]})
            placed = True
        except ToolRefused:
            placed = False
        assert placed == thing.may, path


def test_the_gate_lets_the_same_through(case: tuple[Any, Path, Path], tmp_path: Path) -> None:
    """Scenes that an engine with all of the packs saved, as if there were a way past the two doors."""
    made, folder, pack = case
    saved = {thing: f"{SAVED}/thing_{number}" for number, thing in enumerate(THINGS)}
    with engine_of(tmp_path, case, whole=True) as engine:
        for thing, package in saved.items():
            output(engine, f"import unreal\nunreal.EditorLoadingAndSavingUtils.load_map('{made.start_map}')")
            save = SAVE.replace("place.get_world()", "unreal.EditorLevelLibrary.get_editor_world()").format(package)
            assert "placed True" in output(engine, script(thing) + save) or thing.path == OTHER, thing.name
    elsewhere = tmp_path / f"content{saved[next(t for t in THINGS if t.path == OTHER)]}.level.json"
    elsewhere.write_text(elsewhere.read_text().replace("SM_floor_tile.SM_floor_tile", "SM_thing.SM_thing"))
    told = {}
    manifest = ManifestDigests(frozen={}, scorer={}, submission={})
    for thing, package in saved.items():
        out = EvidenceFolder(tmp_path / "out" / package.rsplit("_", 1)[-1])
        with open_clean(
            engine=DEFAULT_ENGINE,
            packs=[pack],
            submission_content=tmp_path / "content",
            package=package,
            offered=offered(made, folder),
        ) as clean:
            snapshot = clean.export(out.root)
        verdict = verify_integrity(snapshot, read_json(out.dependencies), 0, manifest)
        told[thing.name] = verdict.measurements.get("reason_code", verdict.status)
    assert told == {thing.name: "valid" if thing.may else "unresolved_dependencies" for thing in THINGS}
