"""Stored judgements repeated from their own schedule, beside the run's record: how far Detailed Alignment depends on
the judge's day (paper, "Detailed Alignment repeatability").

Scenes, bundles, pictures, earlier decisions and requests are the stored ones; only the model's answers are new. Each
scene and repeat is a file of its own, so a study that was killed goes on where it was, with the answers it had.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from c4s.errors import BadInput, unknown
from c4s.files import digest
from c4s.folders import remove_tree
from c4s.judge.registry import is_online, repeat_judgements
from c4s.protocol.settings import is_construction
from c4s.records.folder import RepeatsFolder, RunFolder
from c4s.records.judgement import Judgements
from c4s.records.plan import Plan
from c4s.run.desk import repeat_desk
from c4s.run.inputs import inputs
from c4s.run.plan import Trial, trials
from c4s.run.stages import evidence, retained

LEAST, MOST = 2, 20
"""Repeats of a study."""


@dataclass(frozen=True)
class JudgedScene:
    """A generated scene of a study."""

    trial: Trial
    judged: Judgements | None
    """What is repeated; None where no attempt left a valid scene, which is worth 0 in every repeat."""

    @property
    def place(self) -> Path:
        """The trial's folder below the run's."""
        return self.trial.folder.root.relative_to(self.trial.run)


@dataclass(frozen=True)
class Study:
    """Scenes of one run, each to be judged several times over."""

    plan: Plan
    folder: RepeatsFolder
    scenes: tuple[JudgedScene, ...]
    repeats: int

    def left(self) -> list[tuple[JudgedScene, int]]:
        """The scenes with the repeats of them that are not there yet, one repeat after another."""
        return [
            (scene, number)
            for number in range(1, self.repeats + 1)
            for scene in self.scenes
            if scene.judged is not None and not self.folder.repeat(scene.place, number).is_file()
        ]

    def size(self) -> int:
        """Repeats of scenes that a judge is asked for."""
        return self.repeats * sum(scene.judged is not None for scene in self.scenes)


def study_of(
    run: Path, suite: Path, plan: Plan, repeats: int, agents: Sequence[str] = (), cases: Sequence[str] = ()
) -> Study:
    """The study of a run's constructions, of all agents and cases or of those that are named.

    ``BadInput`` for a number of repeats or a name that cannot be, a judge that asks nothing, a trial without a score,
    and where nothing is left to repeat.
    """
    if not LEAST <= repeats <= MOST:
        raise BadInput(f"{repeats} repeats", todo=f"give {LEAST} to {MOST}")
    _check_names("agent", agents, [chosen.name for chosen in plan.configurations])
    _check_names("case", cases, [case.case_id for case in plan.cases])
    if not is_online(plan.judge_configuration):
        raise BadInput(
            f"judge {plan.judge!r} asks no model, so there is nothing to repeat",
            where=str(run),
            todo="repeat a run that a model judged (c4s run --judge)",
        )
    chosen = [
        trial
        for trial in trials(run, suite, plan)
        if is_construction(trial.case.setting)
        and (not agents or trial.configuration.name in agents)
        and (not cases or trial.case.case_id in cases)
    ]
    scenes = tuple(_scene(trial, plan) for trial in chosen)
    if not any(scene.judged for scene in scenes):
        raise BadInput("none of these trials is a construction with a judged scene", where=str(run))
    name = digest([plan.judge, plan.judge_version, [_identity(scene) for scene in scenes]])[:12]
    return Study(plan, RunFolder(run).repeats(name), scenes, repeats)


def _check_names(what: str, given: Sequence[str], known: Sequence[str]) -> None:
    for name in given:
        if name not in known:
            raise unknown(what, name, known)


def _identity(scene: JudgedScene) -> list[str | None]:
    return [scene.trial.name, None if scene.judged is None else scene.judged.sha256()]


def _scene(trial: Trial, plan: Plan) -> JudgedScene:
    if not trial.folder.score.is_file():
        raise BadInput(
            f"the trial {trial.name} has no score here",
            where=str(trial.folder.root),
            todo="finish the run first, or leave it out with --agent or --case",
        )
    if retained(trial) is None:
        return JudgedScene(trial, None)
    judged = Judgements.read(trial.folder.judgements(plan.judge))
    return JudgedScene(trial, judged) if judged.claims else _without_claims(trial)


def _without_claims(trial: Trial) -> JudgedScene:
    raise BadInput(
        f"the case of the trial {trial.name} has no requirement bundle, so it has no Detailed Alignment",
        todo="leave it out with --case",
    )


def repeat_scene(scene: JudgedScene, plan: Plan, folder: RepeatsFolder, number: int) -> None:
    """Judge a scene by its schedule once more, and write what was said; nothing where it is there already."""
    judged, place, trial = scene.judged, scene.place, scene.trial
    written, answers = folder.repeat(place, number), folder.answers(place, number)
    if judged is None or written.is_file():
        return
    made = repeat_judgements(
        plan.judge_configuration,
        judged,
        evidence(trial, plan, inputs(trial)),
        trial.folder.exchanges(plan.judge),
        repeat_desk(trial, answers, folder.exchanges(place)),
    )
    made.write(written)
    if answers.is_dir():
        remove_tree(answers, inside=folder.root)


def repeat_all(study: Study, told: Callable[[int, int, JudgedScene, int], None]) -> None:
    """Make all repeats that are missing, one after another; ``told`` of each: how many are there, of how many, and
    which one it was."""
    left = study.left()
    done = study.size() - len(left)
    for scene, number in left:
        repeat_scene(scene, study.plan, study.folder, number)
        done += 1
        told(done, study.size(), scene, number)


def said_of(study: Study) -> Iterator[tuple[JudgedScene, list[Judgements]]]:
    """Each scene with what was said of it in every repeat; no judgements for one without a valid scene."""
    for scene in study.scenes:
        if scene.judged is None:
            yield scene, []
            continue
        files = [study.folder.repeat(scene.place, number) for number in range(1, study.repeats + 1)]
        yield scene, [Judgements.read(file) for file in files]
