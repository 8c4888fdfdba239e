"""A study made from the trials of one run: whose scenes are shown, who ranks what, what an annotator gets."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from c4s.errors import BadInput, unknown
from c4s.folders import beside, check_own, put_folder
from c4s.human.components import saved_candidate
from c4s.human.pictures import bare_png
from c4s.names import checked_name
from c4s.protocol.criteria import CRITERIA, PRIMARY, CriterionName
from c4s.protocol.graph.prompt import description_end
from c4s.protocol.settings import is_construction
from c4s.records.captures import OVERVIEW, Captures
from c4s.records.folder import RunFolder, TrialFolder
from c4s.records.human import (
    PICTURES,
    AnnotatorSheet,
    HumanCandidate,
    HumanPrompt,
    HumanStudy,
    HumanStudyFolder,
    HumanTask,
    Part,
    SavedCandidate,
    SavedCandidates,
    SheetCandidate,
    SheetTask,
)
from c4s.records.plan import Plan, PlannedCase
from c4s.records.score import TrialScore
from c4s.records.suite import SuiteFolder
from c4s.stats.human import POINTS, Progress, blocks, split

LEAST_PROMPTS = 2
HELD_OUT = 4
"""One prompt of so many is held out: four of sixteen."""
STUDY = "study.json"


def design_study(
    run: Path,
    suites: Path,
    place: Path,
    *,
    agents: Sequence[str],
    cases: Sequence[str],
    annotators: Sequence[str],
    criteria: Sequence[CriterionName],
    seed: int,
    told: Progress | None = None,
) -> tuple[HumanStudy, list[str]]:
    """Make a study in the folder ``place``, named as the folder.

    Args:
        run: folder of a run.
        suites: folder of the suites.
        agents: seven configurations of the run; all where it has seven.
        cases: text-to-scene cases of the run; without, all in which each of the seven has a scene to show.
        annotators: seven names.
        criteria: what is asked beside the primary criterion.
        seed: of all that is drawn.

    Returns:
        The study, and for each case that was left out why.

    Raises:
        BadInput: not seven of either, too few prompts, a case that was named and cannot be shown, or a study is there.
    """
    check_own(place, STUDY)
    if (place / STUDY).is_file():
        raise BadInput("there is such a study", where=str(place), todo="choose another name")
    plan = Plan.read(RunFolder(run).plan)
    suite = SuiteFolder(suites / plan.suite_id)
    if suite.suite().sha256() != plan.suite_digest:
        raise BadInput("this is not the suite of the run", where=str(suite.root), todo="build the suite that it was")
    people = _seven_annotators(annotators)
    configurations = _seven_configurations(plan, agents)
    asked = list(dict.fromkeys([PRIMARY, *criteria]))
    shown, left_out = _showable(RunFolder(run), plan, configurations, cases)
    development, holdout = split(len(shown), seed, max(1, len(shown) // HELD_OUT))
    random = np.random.default_rng([seed, len(shown)])
    ids = _tokens(random, len(shown) * 2 * POINTS)
    prompts, tasks = [], []
    for case, drawn in zip(shown, blocks(len(shown), seed), strict=True):
        candidates = [
            HumanCandidate(
                candidate=ids.pop(),
                configuration=name,
                trial=_trial(RunFolder(run), name, case).root.relative_to(run).as_posix(),
                score_sha256=TrialScore.read(_trial(RunFolder(run), name, case).score).sha256(),
            )
            for name in configurations
        ]
        text = suite.agent_case(case.alias).prompt
        text = text[: description_end(text)]
        prompts.append(HumanPrompt(case_id=case.case_id, prompt=text, candidates=candidates))
        tasks += [
            HumanTask(
                task=ids.pop(),
                case_id=case.case_id,
                candidates=[candidates[number].candidate for number in block.candidates],
                annotators=[people[number] for number in block.annotators],
            )
            for block in drawn
        ]
    parts: dict[Part, list[HumanPrompt]] = {
        "development": [prompts[number] for number in development],
        "holdout": [prompts[number] for number in holdout],
    }
    with beside(place) as scratch:
        made = HumanStudyFolder(scratch / place.name)
        digests: dict[Part, str] = {}
        for part, own in parts.items():
            saved = SavedCandidates(study=place.name, candidates=_saved(RunFolder(run), own))
            saved.write(made.components(part))
            digests[part] = saved.sha256()
        study = HumanStudy(
            study=checked_name(place.name, "a study"),
            run_id=plan.run_id,
            suite_id=plan.suite_id,
            suite_digest=plan.suite_digest,
            policy=plan.policy,
            judge=plan.judge,
            judge_version=plan.judge_version,
            engine=plan.engine,
            seed=seed,
            configurations=configurations,
            annotators=people,
            criteria=asked,
            prompts=prompts,
            tasks=tasks,
            development=[prompt.case_id for prompt in parts["development"]],
            holdout=[prompt.case_id for prompt in parts["holdout"]],
            components_sha256=digests,
        )
        _copy_pictures(RunFolder(run), study, made, told)
        for number, annotator in enumerate(people):
            order = np.random.default_rng([seed, POINTS, number])
            sheet(study, annotator, order).write(made.sheet(annotator))
        study.write(made.study)
        put_folder(made.root, place, marker=STUDY)
    return study, left_out


def sheet(study: HumanStudy, annotator: str, random: np.random.Generator) -> AnnotatorSheet:
    """What an annotator gets: own tasks, each criterion through all of them in an order of its own."""
    texts = {prompt.case_id: prompt.prompt for prompt in study.prompts}
    own = [task for task in study.tasks if annotator in task.annotators]
    names = HumanStudyFolder(Path())
    return AnnotatorSheet(
        study=study.study,
        annotator=annotator,
        tasks=[
            SheetTask(
                task=own[number].task,
                criterion=criterion,
                title=CRITERIA[criterion].title,
                question=CRITERIA[criterion].question,
                prompt=texts[own[number].case_id],
                candidates=[
                    SheetCandidate(
                        candidate=candidate,
                        pictures=[names.picture(candidate, view).as_posix() for view in range(1, PICTURES + 1)],
                    )
                    for candidate in own[number].candidates
                ],
            )
            for criterion in study.criteria
            for number in random.permutation(len(own)).tolist()
        ],
    )


def _seven_configurations(plan: Plan, agents: Sequence[str]) -> list[str]:
    known = [configuration.name for configuration in plan.configurations]
    for name in agents:
        if name not in known:
            raise unknown("agent", name, known)
    chosen = sorted(set(agents or known))
    if len(chosen) != POINTS:
        raise BadInput(
            f"a study compares {POINTS} configurations, not {len(chosen)}", todo=f"name {POINTS} with --agent"
        )
    return chosen


def _seven_annotators(annotators: Sequence[str]) -> list[str]:
    people = [checked_name(name, "an annotator") for name in annotators]
    if len(set(people)) != POINTS or len(people) != POINTS:
        raise BadInput(f"a study has {POINTS} annotators, each with a name of their own", todo="repeat --annotator")
    return people


def _showable(
    run: RunFolder, plan: Plan, configurations: list[str], wanted: Sequence[str]
) -> tuple[list[PlannedCase], list[str]]:
    """Text-to-scene cases with seven scenes to show, by id, and what keeps others from being shown."""
    known = {case.case_id: case for case in plan.cases if is_construction(case.setting)}
    for name in wanted:
        if name not in known:
            raise unknown("case with a prompt", name, known)
    shown, left_out = [], []
    for case_id in sorted(set(wanted or known)):
        faults = [
            f"{case_id}: {name} {fault}"
            for name in configurations
            if (fault := _fault(_trial(run, name, known[case_id])))
        ]
        if faults and wanted:
            raise BadInput(f"{faults[0]}, so this case cannot be shown", todo="leave the case or the agent out")
        if faults:
            left_out.append(faults[0])
        else:
            shown.append(known[case_id])
    if len(shown) < LEAST_PROMPTS:
        raise BadInput(
            f"{len(shown)} cases with a prompt have a scene of each of the {POINTS} configurations, "
            f"{LEAST_PROMPTS} are needed",
            todo=left_out[0] if left_out else "run a suite with more of them",
        )
    return shown, left_out


def _trial(run: RunFolder, configuration: str, case: PlannedCase) -> TrialFolder:
    return run.trial(configuration, case.alias, 1)


def _fault(trial: TrialFolder) -> str:
    """Why a trial's scene cannot be shown; empty where it can."""
    if not trial.score.is_file():
        return "has no score"
    status = TrialScore.read(trial.score).status
    if status == "pending" or status.startswith("zero_"):
        return f"has no valid scene ({status})"
    index = trial.evidence.captures_index
    if not index.is_file():
        return "has no pictures"
    views = Captures.read(index).of(OVERVIEW)
    if len(views) != PICTURES or not all((index.parent / view.file).is_file() for view in views):
        return f"has not {PICTURES} overview pictures"
    return ""


def _saved(run: RunFolder, prompts: list[HumanPrompt]) -> list[SavedCandidate]:
    return [
        saved_candidate(one.candidate, run.trial_named(one.trial)) for prompt in prompts for one in prompt.candidates
    ]


def _copy_pictures(run: RunFolder, study: HumanStudy, made: HumanStudyFolder, told: Progress | None) -> None:
    everyone = [one for prompt in study.prompts for one in prompt.candidates]
    for number, one in enumerate(everyone):
        index = run.trial_named(one.trial).evidence.captures_index
        for view, record in enumerate(Captures.read(index).of(OVERVIEW), start=1):
            target = made.picture(one.candidate, view)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(bare_png((index.parent / record.file).read_bytes()))
        if told is not None:
            told("copying pictures", number + 1, len(everyone))


def _tokens(random: np.random.Generator, count: int) -> list[str]:
    """So many distinct names that tell nothing."""
    found: dict[str, None] = {}
    while len(found) < count:
        found[random.bytes(5).hex()] = None
    return list(found)
