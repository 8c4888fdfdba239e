"""The indoor part of the starter suite: its scenes, its texts, and authored changes of the office and of the flat."""

from __future__ import annotations

from collections.abc import Sequence

from cases.corruption import Author
from cases.model import CaseView, RepairCase, SourceScene, TextCase
from cases.starter import flat_scene, office_scene
from cases.starter.indoor_text_cases import INDOOR_TEXT_CASES

OFFICE_FOLDER, HOME_FOLDER = "C4SOffice", "C4SHome"


def scenes() -> list[SourceScene]:
    """The office and the flat."""
    return [
        SourceScene(office_scene.SCENE_ID, "indoor", "Open-plan office", office_scene.office_level(), ("c4s-office",)),
        SourceScene(flat_scene.SCENE_ID, "indoor", "Furnished flat", flat_scene.flat_level(), ("c4s-home",)),
    ]


def cases(of: Sequence[SourceScene]) -> list[RepairCase | TextCase]:
    """All indoor cases; ``of`` are the scenes of ``scenes()``."""
    office, flat = of
    return [*INDOOR_TEXT_CASES, *office_cases(office), *flat_cases(flat)]


def _mesh(folder: str, category: str, name: str) -> str:
    return f"/Game/{folder}/{category}/SM_{name}.SM_{name}"


def office_cases(scene: SourceScene) -> list[RepairCase]:
    """Repairs of the office: chains of one, two and four changes."""
    author = Author(scene.level, scene.scene_id)
    return [
        RepairCase(
            "indoor-office-01-lounge-plant",
            scene.scene_id,
            "A plant is missing in the lounge",
            [author.removal("TallPlant_02")],
            "Restore",
            "easy",
            [
                CaseView("view-01", (-380, 180, 190), (-720, 450, 50), 75),
                CaseView("view-02", (-480, 340, 200), (-680, 540, 50), 80),
            ],
            "image-to-scene/indoor",
        ),
        RepairCase(
            "indoor-office-02-cafe-intruders",
            scene.scene_id,
            "A coat stand too many, a wrong chair at the cafe table",
            [
                author.insertion(_mesh(OFFICE_FOLDER, "Storage", "CoatStand"), (-490, 470, 2)),
                author.replacement("VisitorChair_02", _mesh(OFFICE_FOLDER, "Seating", "ConferenceChair")),
            ],
            "Lifecycle",
            "medium",
            [
                CaseView("view-01", (-130, 250, 190), (-420, 400, 50), 70),
                CaseView("view-02", (-560, 240, 190), (-360, 430, 50), 75),
            ],
            "image-to-scene/indoor",
        ),
        RepairCase(
            "indoor-office-03-meeting-room",
            scene.scene_id,
            "Four changes in the meeting room",
            [
                author.move("LowCabinet_01", by_cm=(330, 0, 0)),
                author.rotate("ConferenceChair_02", 65),
                author.rescale("TallPlant_01", 1.5),
                author.removal("Laptop_05"),
            ],
            "Layout",
            "hard",
            [
                CaseView("view-01", (330, 230, 230), (650, 430, 60), 85),
                CaseView("view-02", (880, 225, 230), (520, 480, 50), 85),
            ],
            "image-to-scene/indoor",
        ),
    ]


def flat_cases(scene: SourceScene) -> list[RepairCase]:
    """Repairs of the flat: chains of one, three and five changes."""
    author = Author(scene.level, scene.scene_id)
    return [
        RepairCase(
            "indoor-flat-01-mirrored-bath",
            scene.scene_id,
            "The bathtub is the wrong way round",
            [author.mirror("Bathtub_01", "x")],
            "Symmetry",
            "easy",
            [
                CaseView("view-01", (184, 214, 225), (80, 365, 45), 90),
                CaseView("view-02", (16, 212, 225), (125, 370, 45), 90),
            ],
            "image-to-scene/indoor",
        ),
        RepairCase(
            "indoor-flat-02-living-room",
            scene.scene_id,
            "Turned armchair, small television, chair out of its place",
            [
                author.rotate("Armchair_01", 110),
                author.rescale("Television_01", 0.55),
                author.move("DiningChair_04", by_cm=(110, -45, 0)),
            ],
            "Transform",
            "medium",
            [
                CaseView("view-01", (-560, -60, 190), (-150, -250, 50), 85),
                CaseView("view-02", (-40, 180, 210), (-260, -110, 30), 85),
            ],
            "image-to-scene/indoor",
        ),
        RepairCase(
            "indoor-flat-03-child-room",
            scene.scene_id,
            "Five changes in the child's room",
            [
                author.duplication("TeddyBear_01", (300, -40, 2), yaw_deg=-120),
                author.removal("ToyBlocks_01"),
                author.replacement("DiningChair_05", _mesh(HOME_FOLDER, "Seating", "KitchenStool")),
                author.move("ChildChair_01", to_cm=(300, -355, 2)),
                author.rescale("DeskGlobe_02", 1.5),
            ],
            "Lifecycle",
            "hard",
            [
                CaseView("view-01", (590, -225, 215), (330, -200, 20), 95),
                CaseView("view-02", (320, -18, 215), (410, -330, 40), 85),
            ],
            "image-to-scene/indoor",
        ),
    ]
