"""A study that is there: its record, and what came back as arrays of statistics."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from c4s.errors import BadInput, unknown
from c4s.files import digest, read_json_lines
from c4s.human.components import scene_of
from c4s.names import name_fault
from c4s.protocol.criteria import PRIMARY, CriterionName
from c4s.records.human import HumanRanking, HumanStudy, HumanStudyFolder, Part, SavedCandidates
from c4s.stats.human import HumanOrder, Preferences, SceneTable

RANKINGS = "file of rankings"


@dataclass(frozen=True)
class OpenStudy:
    """A study on disk."""

    folder: HumanStudyFolder
    study: HumanStudy

    def is_opened(self) -> bool:
        """Whether the holdout was opened."""
        return self.folder.opened.is_file()

    def rankings(self, part: Part) -> list[HumanRanking]:
        """What came back for the prompts of a part."""
        path = self.folder.rankings(part)
        if not path.is_file():
            return []
        found = [HumanRanking.parse(row, where=str(path)) for row in read_json_lines(path, what=RANKINGS)]
        own = {prompt.case_id for prompt in self.study.prompts_of(part)}
        tasks = {task.task: task for task in self.study.tasks if task.case_id in own}
        seen = set[tuple[str, str, str]]()
        for number, row in enumerate(found, start=1):
            task, key = tasks.get(row.task), (row.task, row.annotator, row.criterion)
            if (
                task is None
                or key in seen
                or row.annotator not in task.annotators
                or sorted(row.order) != sorted(task.candidates)
            ):
                raise BadInput(
                    f"line {number} is no answer that was taken for a {part} prompt",
                    where=str(path),
                    todo="put the file back as `c4s human intake` wrote it",
                )
            seen.add(key)
        return found

    def candidates(self) -> int:
        """Candidates of a prompt."""
        return len(self.study.configurations)

    def orders(self, *parts: Part, criterion: CriterionName = PRIMARY) -> list[HumanOrder]:
        """Rankings by a criterion as numbers: prompts as in ``prompts_of``, candidates as the configurations."""
        prompts = self.study.prompts_of(*parts)
        place = {
            one.candidate: (number, at)
            for number, prompt in enumerate(prompts)
            for at, one in enumerate(prompt.candidates)
        }
        people = {name: number for number, name in enumerate(self.study.annotators)}
        return [
            HumanOrder(
                prompt=place[row.order[0]][0],
                annotator=people[row.annotator],
                order=tuple(place[candidate][1] for candidate in row.order),
            )
            for part in parts
            for row in self.rankings(part)
            if row.criterion == criterion
        ]

    def preferences(self, *parts: Part, criterion: CriterionName = PRIMARY) -> Preferences:
        """The same as pairwise preferences."""
        prompts = len(self.study.prompts_of(*parts))
        return Preferences.of(self.orders(*parts, criterion=criterion), prompts, self.candidates())

    def complete(self, part: Part) -> None:
        """``BadInput`` where a primary ranking of a part is missing."""
        cases = [prompt.case_id for prompt in self.study.prompts_of(part)]
        missing = self.study.expected(cases) - len(self.orders(part))
        if missing:
            raise BadInput(
                f"{missing} of {self.study.expected(cases)} rankings of the {part} prompts are missing",
                where=self.study.study,
                todo="take them in first: `c4s human intake`",
            )

    def rankings_digest(self, part: Part) -> str:
        """Digest of the primary rankings of a part, in whatever order they came."""
        rows = [row.plain() for row in self.rankings(part) if row.criterion == PRIMARY]
        return digest(sorted(rows, key=lambda row: (row["task"], row["annotator"])))

    def saved(self, part: Part) -> SavedCandidates:
        """The components of a part's candidates; ``BadInput`` where they are not those of the study."""
        path = self.folder.components(part)
        found = SavedCandidates.read(path)
        if found.sha256() != self.study.components_sha256[part]:
            raise BadInput("these are not the components of the study", where=str(path), todo=SavedCandidates.REMEDY)
        return found

    def scenes(self, *parts: Part) -> SceneTable:
        """Components of the candidates of some parts, prompt by prompt as in ``prompts_of``."""
        saved = {one.candidate: one for part in parts for one in self.saved(part).candidates}
        return SceneTable.of(
            [scene_of(saved[one.candidate]) for prompt in self.study.prompts_of(*parts) for one in prompt.candidates]
        )

    def by_prompt(self, values: np.ndarray) -> np.ndarray:
        """Values of candidates, a row a prompt."""
        return values.reshape(-1, self.candidates())


def study_named(root: Path, name: str) -> OpenStudy:
    """A study of the folder of studies; ``BadInput`` where there is none of this name."""
    there = sorted(path.parent.name for path in root.glob("*/study.json"))
    folder = HumanStudyFolder(root / name)
    if name_fault(name) or not folder.study.is_file():
        raise unknown("human study", name, there, todo="make one: `c4s human design`")
    return OpenStudy(folder, HumanStudy.read(folder.study))
