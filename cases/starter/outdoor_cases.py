"""The outdoor cases of the starter suite: six repairs and two texts, on the harbour street and the small farm."""

from __future__ import annotations

from cases.corruption import Author
from cases.model import CaseView, RepairCase, SourceScene, TextCase
from cases.starter import farm_scene, harbour_scene
from cases.starter.outdoor_texts import farm_text, harbour_text

HARBOUR, FARM = harbour_scene.PATHS, farm_scene.PATHS


def scenes() -> list[SourceScene]:
    """Both outdoor scenes."""
    return [harbour_scene.build(), farm_scene.build()]


def cases(known: list[SourceScene]) -> list[RepairCase | TextCase]:
    """All outdoor cases; ``known`` are the scenes that ``scenes`` built."""
    levels = {scene.scene_id: scene.level for scene in known}
    harbour = Author(levels[harbour_scene.SCENE_ID], harbour_scene.SCENE_ID)
    farm = Author(levels[farm_scene.SCENE_ID], farm_scene.SCENE_ID)
    return [*_harbour_repairs(harbour), *_farm_repairs(farm), harbour_text(), farm_text()]


def _view(location: tuple[float, float, float], target: tuple[float, float, float], fov_deg: float = 60.0) -> CaseView:
    return CaseView("reference", location, target, fov_deg, 1600, 900)


def _harbour_repairs(a: Author) -> list[RepairCase]:
    scene = harbour_scene.SCENE_ID
    return [
        RepairCase(
            "outdoor-harbour-market-row",
            scene,
            "The market row is out of order",
            [
                a.move("SM_MarketStallBlue_3", by_cm=(40.0, -190.0, 0.0)),
                a.rotate("SM_MarketStallRed_2", 60.0),
                a.insertion(HARBOUR["HandTruck"], (-1930.0, -225.0, 0.0), yaw_deg=40.0),
                a.rescale("SM_MarketStallRed_3", 0.72),
            ],
            "Layout",
            "hard",
            [_view((-2250.0, 640.0, 1050.0), (-2330.0, -560.0, 40.0), 66.0)],
        ),
        RepairCase(
            "outdoor-harbour-cafe",
            scene,
            "The quayside cafe lost a parasol and gained furniture",
            [
                a.removal("SM_Parasol_2"),
                a.duplication("SM_CafeTable_3", (4020.0, -640.0, 0.0)),
                a.replacement("SM_CafeTable_4", HARBOUR["Barrel"]),
            ],
            "Lifecycle",
            "medium",
            [_view((4350.0, 420.0, 420.0), (4250.0, -480.0, 70.0), 70.0)],
        ),
        RepairCase(
            "outdoor-harbour-cream-house",
            scene,
            "A mirrored house and a disturbed pavement",
            [
                a.mirror("SM_TownhouseCream_2", "x"),
                a.replacement("SM_StreetLamp_17", HARBOUR["SlimTree"]),
                a.rotate("SM_Bench_11", 90.0),
                a.move("SM_Bicycle_8", by_cm=(330.0, 20.0, 0.0)),
                a.rescale("SM_CarTeal_4", 1.3),
            ],
            "Symmetry",
            "hard",
            [_view((4430.0, -430.0, 640.0), (3950.0, -1850.0, 130.0), 72.0)],
        ),
    ]


def _farm_repairs(a: Author) -> list[RepairCase]:
    scene = farm_scene.SCENE_ID
    return [
        RepairCase(
            "outdoor-farm-yard",
            scene,
            "Tractor, well and cart stand wrong in the yard",
            [
                a.rotate("SM_TractorRed_1", 75.0),
                a.move("SM_Well_1", by_cm=(420.0, 260.0, 0.0)),
                a.rescale("SM_HayCart_1", 1.35),
            ],
            "Transform",
            "medium",
            [_view((-1450.0, -800.0, 700.0), (1300.0, 1500.0, 0.0))],
        ),
        RepairCase(
            "outdoor-farm-pasture",
            scene,
            "A cow is gone, strange things are in the pasture",
            [
                a.removal("SM_Cow_2"),
                a.insertion(FARM["Boulder"], (-3350.0, -2500.0, 0.0), yaw_deg=70.0),
                a.duplication("SM_Sheep_3", (-2950.0, -2650.0, 0.0), yaw_deg=30.0),
                a.replacement("SM_WaterTrough_1", FARM["RoundBale"]),
            ],
            "Lifecycle",
            "medium",
            [_view((-5500.0, -2900.0, 950.0), (-2700.0, -2050.0, 0.0))],
        ),
        RepairCase(
            "outdoor-farm-tool-shed",
            scene,
            "Missing hay and a shed the wrong way round",
            [a.removal("SM_HayBale_6"), a.mirror("SM_ToolShed_1", "x")],
            "Restore",
            "easy",
            [_view((1250.0, 1750.0, 330.0), (1900.0, 2700.0, 90.0), 66.0)],
        ),
    ]
