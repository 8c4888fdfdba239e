"""A human study on disk: who ranks which scenes, what an annotator gets, what came back, and weights that were frozen.

::

    <study>/study.json                    HumanStudy: who is who; no annotator ever sees it
    <study>/annotators/<name>.json        AnnotatorSheet: all that an annotator gets, with ...
    <study>/pictures/<candidate>/<n>.png  ... the pictures it names
    <study>/development/components.json   SavedCandidates: what the scores of these prompts are made of
    <study>/development/rankings.jsonl    HumanRanking, a line one
    <study>/holdout/...                   the same of the prompts that no fit looks at
    <study>/fits/<labels>.json            FrozenFit
    <study>/opened.json                   HoldoutOpened: from here on nothing is fitted or taken in
    <study>/evaluation.json               HumanEvaluation
    <study>/access.json                   Access: keys of the links of `c4s human serve`
    <study>/answers.jsonl                 HumanRanking, as annotators gave them there, only ever added to
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import ClassVar, Final, Literal, Self

from pydantic import model_validator

from c4s.names import InnerPath, Name
from c4s.protocol.criteria import PRIMARY, CriterionName
from c4s.protocol.rules import Family
from c4s.records.analysis import Findings
from c4s.records.base import Record, Sealed

Part = Literal["development", "holdout"]
Labels = Literal["individual", "consensus"]
"""What a fit agrees with: the preferences of single annotators, or their Plackett-Luce consensus."""
PICTURES: Final = 4
"""Overview pictures of a candidate."""
_AGAIN: Final = "make the study again under another name: `c4s human design`"


class HumanCandidate(Record):
    """Whose scene an anonymous candidate is."""

    candidate: Name
    configuration: Name
    trial: str
    """Its path below the run's folder."""
    score_sha256: str
    """Digest of the trial's score."""


class HumanPrompt(Record):
    """A prompt with its candidates, in the order of the study's configurations."""

    case_id: Name
    prompt: str
    candidates: list[HumanCandidate]


class HumanTask(Record):
    """A triplet of candidates and who ranks it."""

    task: Name
    case_id: Name
    candidates: list[Name]
    """In the order in which they are shown."""
    annotators: list[Name]


class HumanStudy(Sealed):
    """The design of a study, made from the trials of one run."""

    REMEDY: ClassVar[str] = _AGAIN
    schema_version: Literal["c4s.human-study.v1"] = "c4s.human-study.v1"
    study: Name
    run_id: Name
    suite_id: Name
    suite_digest: str
    policy: str
    judge: str
    judge_version: str
    engine: str
    seed: int
    """Of who ranks what, and of the split."""
    configurations: list[Name]
    annotators: list[Name]
    criteria: list[CriterionName]
    """The primary one first."""
    prompts: list[HumanPrompt]
    """By case."""
    tasks: list[HumanTask]
    development: list[Name]
    holdout: list[Name]
    """Cases; scores had no part in the split."""
    components_sha256: dict[Part, str]

    def prompts_of(self, *parts: Part) -> list[HumanPrompt]:
        """The prompts of some parts, by case."""
        cases = {case for part in parts for case in (self.development if part == "development" else self.holdout)}
        return [prompt for prompt in self.prompts if prompt.case_id in cases]

    def expected(self, cases: Sequence[str]) -> int:
        """Rankings by one criterion that some prompts are to have."""
        return sum(len(task.annotators) for task in self.tasks if task.case_id in cases)


class SheetCandidate(Record):
    """A candidate as an annotator sees it."""

    candidate: Name
    pictures: list[InnerPath]
    """Below the study's folder, in the order of the views."""


class SheetTask(Record):
    """One ranking that is asked for."""

    task: Name
    criterion: CriterionName
    title: str
    question: str
    prompt: str
    candidates: list[SheetCandidate]


class AnnotatorSheet(Record):
    """All that one annotator gets: no model, no score, no measurement, nobody else's answer."""

    schema_version: Literal["c4s.human-sheet.v1"] = "c4s.human-sheet.v1"
    study: Name
    annotator: Name
    tasks: list[SheetTask]
    """In the order in which they are asked: all of the primary criterion first."""


class HumanRanking(Record):
    """One answer: the candidates of a task, the best first, no two alike and none left out."""

    schema_version: Literal["c4s.human-ranking.v1"] = "c4s.human-ranking.v1"
    study: Name
    annotator: Name
    task: Name
    criterion: CriterionName = PRIMARY
    order: list[Name]


class SavedCandidate(Record):
    """What the score of one candidate is made of, as its verdicts have it."""

    candidate: Name
    score: float
    """Under the policy of the run; the components give it again."""
    families: dict[Family, float]
    dimensions: dict[str, float] | None
    structure: float = 0.0
    capped: bool = False
    leaves: dict[str, float]


class SavedCandidates(Sealed):
    """The components of all candidates of some prompts, saved when the study was made."""

    REMEDY: ClassVar[str] = _AGAIN
    schema_version: Literal["c4s.human-components.v1"] = "c4s.human-components.v1"
    study: Name
    candidates: list[SavedCandidate]


class WeightBlocks(Record):
    """Weights of a text-to-scene score; each block sums to 1."""

    families: dict[Family, float]
    dimensions: dict[str, float]
    leaves: dict[str, float]
    final: dict[str, float]


class FrozenFit(Sealed):
    """Weights that were fitted to the development prompts, frozen before anybody looked at the others."""

    REMEDY: ClassVar[str] = "remove the file and fit again, while the holdout is not open"
    schema_version: Literal["c4s.human-fit.v1"] = "c4s.human-fit.v1"
    study: Name
    study_sha256: str
    labels: Labels
    saw: list[Name]
    """Cases whose rankings it was fitted to."""
    holdout: list[Name]
    """Cases that it must not have seen."""
    rankings_sha256: str
    components_sha256: str
    """What it was fitted to."""
    weights: WeightBlocks
    agreement: float
    """On the development prompts: mean over prompts, pairs and reviewers."""
    loss: float
    distance: float
    comparison_agreement: float
    """Of the adopted weights on the same labels."""
    seed: int
    looked_at: dict[str, int]
    """Policies that each stage of the search looked at."""
    passes: int
    made_by: str
    """Version of the code that fits."""

    @model_validator(mode="after")
    def _blind(self) -> Self:
        if both := sorted(set(self.saw) & set(self.holdout)):
            raise ValueError(f"this fit has seen the holdout prompt {both[0]!r}: it cannot be evaluated on it")
        return self


class HoldoutOpened(Sealed):
    """That the holdout was opened, and what was frozen then."""

    REMEDY: ClassVar[str] = _AGAIN
    schema_version: Literal["c4s.human-opened.v1"] = "c4s.human-opened.v1"
    study_sha256: str
    fits: dict[Labels, str]
    """Digest of each frozen fit."""
    rankings_sha256: dict[Part, str]


class HumanEvaluation(Sealed):
    """How far frozen policies agree with people."""

    REMEDY: ClassVar[str] = "run `c4s human evaluate` again"
    schema_version: Literal["c4s.human-evaluation.v1"] = "c4s.human-evaluation.v1"
    study: Name
    study_sha256: str
    fits: dict[Labels, str]
    findings: Findings
    made_by: str


class HumanStudyFolder:
    """The names of the files of a study are spelt here and nowhere else."""

    def __init__(self, root: Path) -> None:
        self.root = root

    @property
    def study(self) -> Path:
        """The design; written last."""
        return self.root / "study.json"

    def sheet(self, annotator: str) -> Path:
        """What an annotator gets."""
        return self.root / "annotators" / f"{annotator}.json"

    def picture(self, candidate: str, number: int) -> Path:
        """A candidate's picture; they count from 1."""
        return self.root / "pictures" / candidate / f"{number}.png"

    def components(self, part: Part) -> Path:
        """What the scores of a part's prompts are made of."""
        return self.root / part / "components.json"

    def rankings(self, part: Part) -> Path:
        """What came back."""
        return self.root / part / "rankings.jsonl"

    def fit(self, labels: Labels) -> Path:
        """A frozen fit."""
        return self.root / "fits" / f"{labels}.json"

    @property
    def opened(self) -> Path:
        """That the holdout was opened."""
        return self.root / "opened.json"

    @property
    def evaluation(self) -> Path:
        """What was found."""
        return self.root / "evaluation.json"

    @property
    def access(self) -> Path:
        """Keys of the links under which annotators answer."""
        return self.root / "access.json"

    @property
    def answers(self) -> Path:
        """What annotators answered there; it is taken in as any other file of rankings is."""
        return self.root / "answers.jsonl"
