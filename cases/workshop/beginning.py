"""The first case of a new suite file: a change of one thing and the views that show it, to go on from."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Final, Literal, get_args

from c4s.errors import BadInput, unknown
from c4s.files import write_json, write_text
from c4s.names import checked_id
from cases.generate import SoundThing, views_of
from cases.model import CaseView
from cases.workshop.document import (
    SUITE_FILE,
    ChangeEntry,
    Mirror,
    Move,
    Removal,
    RepairCaseEntry,
    Rescale,
    Rotation,
    SceneEntry,
    SuiteFile,
    ViewEntry,
)
from cases.workshop.writing import suite_text

SCHEMA_FILE: Final = "suite.schema.json"
FirstChange = Literal["removal", "move", "rotate", "rescale", "mirror"]
FIRST_CHANGES: Final[tuple[FirstChange, ...]] = get_args(FirstChange)
TURN_DEG, FACTOR, ASIDE = 65.0, 1.5, 1.4


def first_suite(
    suite_id: str,
    scene: SceneEntry,
    things: Sequence[SoundThing],
    *,
    author: str,
    actor: str | None = None,
    kind: FirstChange = "move",
) -> SuiteFile:
    """A suite with one repair of a scene.

    Args:
        suite_id: its id.
        scene: the scene.
        things: what may be changed in it (``cases.generate.sound_things``).
        author: pseudonym of who makes it.
        actor: what is changed; the middle one by size when None.
        kind: how.

    Raises ``BadInput`` where nothing can be changed, and for an actor that cannot.
    """
    if not things:
        raise BadInput("nothing in this scene stands, fits and has a handy size", where=scene.scene_id)
    thing = _thing(things, actor)
    outdoor = scene.environment == "outdoor"
    return SuiteFile(
        suite_id=checked_id(suite_id, "suite"),
        title=suite_id.replace("-", " ").capitalize(),
        description="",
        authors=[author],
        scenes=[scene],
        repairs=[
            RepairCaseEntry(
                case_id=f"{suite_id}-01-{kind}",
                scene_id=scene.scene_id,
                title=f"{thing.name}: {kind}",
                corruptions=[_change(kind, thing)],
                views=[_entry(view) for view in views_of([thing], 1 if outdoor else 2)],
            )
        ],
    )


def _thing(things: Sequence[SoundThing], actor: str | None) -> SoundThing:
    by_size = sorted(things, key=lambda thing: (max(thing.extent), thing.name))
    if actor is None:
        return by_size[len(by_size) // 2]
    found = next((thing for thing in things if thing.name == actor), None)
    if found is None:
        raise unknown("actor that can be changed", actor, [thing.name for thing in things])
    return found


def _change(kind: FirstChange, thing: SoundThing) -> ChangeEntry:
    match kind:
        case "removal":
            return Removal(kind="removal", actor=thing.name)
        case "rotate":
            return Rotation(kind="rotate", actor=thing.name, yaw_deg=TURN_DEG)
        case "rescale":
            return Rescale(kind="rescale", actor=thing.name, factor=FACTOR)
        case "mirror":
            return Mirror(kind="mirror", actor=thing.name, axis="x")
        case "move":
            return Move(kind="move", actor=thing.name, by_cm=(round(max(40.0, ASIDE * thing.extent[0]), 1), 0.0, 0.0))


def _entry(view: CaseView) -> ViewEntry:
    place = [tuple(round(value, 1) for value in point) for point in (view.location_cm, view.target_cm)]
    return ViewEntry(name=view.name, location_cm=place[0], target_cm=place[1], fov_deg=view.fov_deg)


def write_suite(file: SuiteFile, folder: Path) -> Path:
    """Write a suite file and its JSON Schema into a folder; ``BadInput`` where a suite file lies there already."""
    path = folder / SUITE_FILE
    if path.exists():
        raise BadInput("a suite file lies here already", where=str(path), todo="choose another folder with --out")
    write_json(folder / SCHEMA_FILE, SuiteFile.model_json_schema())
    write_text(path, suite_text(file, SCHEMA_FILE))
    return path
