"""From a suite file to the definition that is built."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import yaml
from pydantic import ValidationError

from c4s.errors import BadInput
from c4s.files import read_plain_text, read_yaml
from c4s.names import file_in
from c4s.records.base import first_fault
from c4s.records.level import Level
from c4s.records.suite import Visibility
from cases.corruption import Author, Corruption
from cases.importers.scene import imported_scene
from cases.model import (
    GROUP_OF_KIND,
    TEXT_BUDGET,
    CaseView,
    Difficulty,
    Group,
    RepairCase,
    SourceScene,
    SuiteDefinition,
    TextCase,
    difficulty_of,
)
from cases.recipe import Kind
from cases.requirements import RequirementSpec
from cases.workshop.document import (
    SUITE_FILE,
    ChangeEntry,
    Duplication,
    Insertion,
    Mirror,
    Move,
    Removal,
    RepairCaseEntry,
    Replacement,
    RequirementsEntry,
    Rescale,
    Rotation,
    SceneEntry,
    SelectionFile,
    SuiteFile,
    TextCaseEntry,
    ViewEntry,
)

LEVEL_SUFFIX = ".level.json"


def suite_file(path: Path) -> Path:
    """The suite file that a path means: itself, or ``suite.yaml`` in a folder."""
    return path / SUITE_FILE if path.is_dir() else path


def read_suite_file(path: Path) -> SuiteFile:
    """Read a suite file. ``BadInput`` names the line, the field and what is wrong with it."""
    value = read_yaml(path, what="suite file")
    try:
        return SuiteFile.model_validate(value)
    except ValidationError as error:
        field, message = first_fault(error)
        raise BadInput(
            f"field {field!r}: {message}", where=f"{path} line {_line(read_plain_text(path), error)}"
        ) from None


def read_definition(path: Path, suites: Path, packs: Path) -> SuiteDefinition:
    """The definition that a suite file holds; ``BadInput`` where it names what is not there.

    Args:
        path: the suite file.
        suites: where imported scenes lie.
        packs: where packs lie.
    """
    file = read_suite_file(path)
    try:
        return _Definition(file, path.parent, suites, packs).whole()
    except BadInput as error:
        raise BadInput(
            error.what, where=f"{path}: {error.where}" if error.where else str(path), todo=error.todo
        ) from None


class _Definition:
    """Puts a definition together."""

    def __init__(self, file: SuiteFile, folder: Path, suites: Path, packs: Path) -> None:
        self._file, self._folder, self._suites, self._packs = file, folder, suites, packs

    def whole(self) -> SuiteDefinition:
        """Scenes and cases, with every reference resolved."""
        scenes = [self._scene(entry) for entry in self._file.scenes]
        shown = self._selected()
        known = {scene.scene_id: scene for scene in scenes}
        authors = {scene.scene_id: Author(scene.level, scene.scene_id) for scene in scenes}

        def of(case: RepairCaseEntry | TextCaseEntry) -> SourceScene:
            if case.scene_id not in known:
                raise BadInput(f"no scene {case.scene_id!r} in this file", where=case.case_id)
            return known[case.scene_id]

        repairs = [
            self._repair(case, of(case), authors[case.scene_id], shown.get(case.case_id, case.visibility))
            for case in self._file.repairs
        ]
        texts = [self._text(case, of(case), shown.get(case.case_id, case.visibility)) for case in self._file.texts]
        return SuiteDefinition(
            suite_id=self._file.suite_id,
            title=self._file.title,
            description=self._file.description,
            packs=tuple(dict.fromkeys(pack for scene in scenes for pack in scene.packs)),
            scenes=tuple(scenes),
            cases=(*repairs, *texts),
            authors={case.case_id: name for case in self._file.cases if (name := self._file.author_of(case))},
        )

    def _selected(self) -> dict[str, Visibility]:
        """What a selection file says of the cases; nothing without one."""
        if self._file.visibility is None:
            return {}
        path = file_in(self._folder, self._file.visibility)
        selection = SelectionFile.parse(read_yaml(path, what="selection"), where=str(path))
        if selection.suite_id != self._file.suite_id:
            raise BadInput(f"a selection of suite {selection.suite_id!r}", where=str(path))
        gone = sorted({case.case_id for case in self._file.cases} & set(selection.withdrawn))
        if gone:
            raise BadInput(
                f"{gone[0]!r} was withdrawn by the selection", where=str(path), todo="take it out of the suite file"
            )
        return selection.visibility

    def _scene(self, entry: SceneEntry) -> SourceScene:
        imported = not entry.level.endswith(LEVEL_SUFFIX)
        if imported:
            level = imported_scene(self._suites, self._packs, entry.level)
        else:
            level = Level.read(file_in(self._folder, entry.level))
        packs = tuple(dict.fromkeys([*entry.packs, *([entry.level] if imported else [])]))
        if not packs:
            raise BadInput("a scene from a level document names its packs", where=entry.scene_id)
        title = entry.title or entry.scene_id.replace("-", " ").capitalize()
        return SourceScene(entry.scene_id, entry.environment, title, level, packs)

    def _repair(self, case: RepairCaseEntry, scene: SourceScene, author: Author, visibility: Visibility) -> RepairCase:
        changes = [_made(author, case.case_id, number, one) for number, one in enumerate(case.corruptions, 1)]
        kinds: list[Kind] = [made.kind for made in changes]
        group: Group = case.group or GROUP_OF_KIND[kinds[0]]
        difficulty: Difficulty = case.difficulty or difficulty_of(len(changes))
        return RepairCase(
            case_id=case.case_id,
            scene_id=case.scene_id,
            title=case.title or f"{len(changes)} change{'s' if len(changes) > 1 else ''}: {', '.join(kinds)}",
            corruptions=tuple(changes),
            group=group,
            difficulty=difficulty,
            views=tuple(map(_view, case.views)),
            setting="image-to-scene/indoor" if scene.environment == "indoor" else "image-to-scene/outdoor",
            prompt=case.prompt,
            budget=case.budget,
            visibility=visibility,
        )

    def _text(self, case: TextCaseEntry, scene: SourceScene, visibility: Visibility) -> TextCase:
        asked = case.requirements
        if not isinstance(asked, RequirementsEntry):
            path = file_in(self._folder, asked)
            asked = RequirementsEntry.parse(read_yaml(path, what="requirements"), where=str(path))
        return TextCase(
            case_id=case.case_id,
            scene_id=case.scene_id,
            title=case.title or scene.title,
            description=case.description.strip(),
            requirements=RequirementSpec(
                tuple(asked.entities), tuple(asked.predicates), author=self._file.author_of(case) or self._file.suite_id
            ),
            plate_m=case.plate_m,
            difficulty=case.difficulty,
            palette=tuple(case.palette),
            ground=tuple(case.ground),
            minimum_actors=case.minimum_actors,
            budget=case.budget or TEXT_BUDGET,
            visibility=visibility,
        )


def change(author: Author, entry: ChangeEntry) -> Corruption:
    """The corruption that an entry of a suite file stands for; ``BadInput`` for an actor that the scene has not."""
    match entry:
        case Removal():
            return author.removal(entry.actor)
        case Insertion():
            return author.insertion(entry.mesh, entry.location_cm, yaw_deg=entry.yaw_deg, scale=entry.scale)
        case Duplication():
            return author.duplication(entry.actor, entry.location_cm, yaw_deg=entry.yaw_deg)
        case Replacement():
            return author.replacement(entry.actor, entry.mesh)
        case Move():
            return author.move(entry.actor, by_cm=entry.by_cm, to_cm=entry.to_cm)
        case Rotation():
            return author.rotate(entry.actor, entry.yaw_deg)
        case Rescale():
            return author.rescale(entry.actor, entry.factor)
        case Mirror():
            return author.mirror(entry.actor, entry.axis)


def _made(author: Author, case_id: str, number: int, entry: ChangeEntry) -> Corruption:
    try:
        return change(author, entry)
    except BadInput as error:
        raise BadInput(error.what, where=f"{case_id} change {number}: {error.where}", todo=error.todo) from None


def _view(entry: ViewEntry) -> CaseView:
    return CaseView(entry.name, entry.location_cm, entry.target_cm, entry.fov_deg, entry.width, entry.height)


def _line(text: str, error: ValidationError) -> int:
    """The line of the first wrong field, or of the part that lacks it."""
    place: Sequence[Any] = error.errors(include_url=False, include_input=False, include_context=False)[0]["loc"]
    node = yaml.compose(text, Loader=yaml.SafeLoader)
    line = 1
    for part in place:
        found = _inner(node, part)
        if found is not None:
            node = found
            line = node.start_mark.line + 1
    return line


def _inner(node: yaml.Node | None, part: Any) -> yaml.Node | None:
    if isinstance(node, yaml.SequenceNode) and isinstance(part, int) and part < len(node.value):
        inner: yaml.Node = node.value[part]
        return inner
    if isinstance(node, yaml.MappingNode):
        return next((value for key, value in node.value if key.value == str(part)), None)
    return None
