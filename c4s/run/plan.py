"""Making, freezing and reopening the plan of a run."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from c4s.errors import BadInput, unknown
from c4s.files import digest
from c4s.judge.names import judge_configuration
from c4s.packs.suite_check import check_case
from c4s.records.folder import RunFolder, TrialFolder
from c4s.records.plan import Configuration, LeftOut, Plan, PlannedCase
from c4s.records.suite import SuiteFolder, WithheldFolder
from c4s.run.choices import check_configurations, check_labels, check_originals, check_substitutes
from c4s.run.grounds import check_grounds

_FIXED = {
    "run_id": "--run-id",
    "suite_id": "suite",
    "suite_digest": "content of its suite",
    "policy": "policy",
    "judge": "judge",
    "judge_version": "version of its judge",
    "engine": "engine",
}
"""What no run changes, and what it is called."""
_JUDGE_AGAIN = "judge what it holds by this version (the flow `rejudge`: docs/judge.md), or choose another --run-id"
VERSIONED = ("prefect", "numpy", "scipy", "embreex", "python-fcl", "coal", "trimesh", "mcp", "duckdb", "pyarrow")


@dataclass(frozen=True)
class Trial:
    """A scheduled configuration x case x repeat, addressed by its run folder."""

    run: Path
    suite: Path
    configuration: Configuration
    case: PlannedCase
    repeat: int

    @property
    def working(self) -> Configuration:
        """What works on the case: the configuration, or what it names for such a case."""
        return self.configuration.on(self.case.case_id, self.case.setting)

    @property
    def folder(self) -> TrialFolder:
        """Where the trial's files lie."""
        return RunFolder(self.run).trial(self.configuration.name, self.case.alias, self.repeat)

    @property
    def name(self) -> str:
        """``configuration/case/r<k>``, for people."""
        return f"{self.configuration.name}/{self.case.case_id}/r{self.repeat}"


def trial_id(plan: Plan, trial: Trial) -> str:
    """Identity of a trial (16 hex) by content only: suite, case, configuration, repeat, policy, judge with its version,
    engine."""
    return digest(
        [
            plan.suite_digest,
            trial.case.plain(),
            trial.configuration.plain(),
            trial.repeat,
            plan.policy,
            plan.judge,
            plan.judge_version,
            plan.engine,
        ]
    )[:16]


def versions() -> dict[str, str]:
    """Versions of c4s and of the libraries that can change a result."""
    found = {"c4s": "source"}
    for name in ("c4s", *VERSIONED):
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            continue
    return found


def make_plan(
    suite: SuiteFolder,
    configurations: Sequence[Configuration],
    *,
    run_id: str,
    policy: str,
    judge: str,
    engine: str,
    repeats: int = 1,
    cases: Sequence[str] = (),
    left_out: Sequence[LeftOut] = (),
) -> Plan:
    """A plan over the suite's cases (all, or those named).

    ``judge`` is a name or the YAML file of one; ``left_out`` are default agents that it does without.
    Raises ``BadInput`` for an unknown case, for a case or pack that is not as it was frozen, and for an engine, judge,
    policy or configuration that cannot be obeyed (``c4s.run.choices``).
    """
    from c4s.judge.registry import judge_version
    from c4s.run.host import this_host

    check_labels(engine, policy)
    judging = judge_configuration(judge)
    check_configurations(configurations)
    if repeats < 1:
        raise BadInput(f"{repeats} repeats are no plan", todo="give 1 or more")
    record = suite.suite()
    known = {case.case_id for case in record.cases}
    check_substitutes(configurations, known, where=f"suite {record.suite_id}")
    for case_id in cases:
        if case_id not in known:
            raise unknown("case", case_id, known, where=f"suite {record.suite_id}")
    if not record.cases:
        raise BadInput("this suite has no cases", where=str(suite.record))
    chosen = [case for case in record.cases if not cases or case.case_id in cases]
    for case in chosen:
        _, packs = check_case(suite, case)
        check_grounds(WithheldFolder(suite.withheld(case.case_id)), packs)
    check_originals(configurations, suite, chosen)
    planned = [
        PlannedCase(
            case_id=case.case_id,
            alias=case.alias,
            setting=case.setting,
            agent_digest=case.agent_digest,
            withheld_digest=case.withheld_digest,
            scene_id=suite.withheld_case(case.case_id).scene_id,
        )
        for case in chosen
    ]
    return Plan(
        run_id=run_id,
        suite_id=record.suite_id,
        suite_digest=record.sha256(),
        configurations=list(configurations),
        left_out=list(left_out),
        cases=planned,
        repeats=repeats,
        policy=policy,
        judge=judging.name,
        judge_configuration=judging,
        judge_version=judge_version(judging),
        engine=engine,
        versions=versions(),
        host=this_host(),
    )


def open_run(root: Path, plan: Plan) -> Plan:
    """Freeze the plan in the run folder, or let the frozen one grow by what is asked for; the plan of the run.

    Library versions and the host may differ from the frozen ones. Suite, policy, judge and engine must agree, and a
    configuration of the same name must be the same, else ``BadInput``. A plan that has grown replaces the frozen one,
    which is kept beside it under its digest.
    """
    folder = RunFolder(root)
    if not folder.plan.is_file():
        plan.write(folder.plan)
        return plan
    frozen = Plan.read(folder.plan)
    grown = _grown(frozen, plan, str(folder.plan))
    if grown != frozen:
        frozen.write(folder.earlier_plan(frozen.sha256()))
        grown.write(folder.plan)
    return grown


def judged_now(root: Path, plan: Plan) -> Plan:
    """A run's plan with the version that its judge has now. The frozen one is kept beside it, under its digest."""
    from c4s.judge.registry import judge_version

    now = plan.model_copy(update={"judge_version": judge_version(plan.judge_configuration)})
    if now != plan:
        folder = RunFolder(root)
        plan.write(folder.earlier_plan(plan.sha256()))
        now.write(folder.plan)
    return now


def _grown(frozen: Plan, asked: Plan, where: str) -> Plan:
    """The frozen plan with the configurations, cases and repeats that are asked for beside its own."""
    for name, label in _FIXED.items():
        if getattr(frozen, name) != getattr(asked, name):
            todo = _JUDGE_AGAIN if name == "judge_version" else "choose another --run-id"
            raise BadInput(f"this run was started with another {label}", where=where, todo=todo)
    configurations = {chosen.name: chosen for chosen in frozen.configurations}
    for chosen in asked.configurations:
        if configurations.setdefault(chosen.name, chosen) != chosen:
            raise BadInput(
                f"this run has another configuration {chosen.name!r}",
                where=where,
                todo="give the agent another name, or choose another --run-id",
            )
    cases = {case.case_id: case for case in (*frozen.cases, *asked.cases)}
    without = {row.agent: row for row in (*frozen.left_out, *asked.left_out) if row.agent not in configurations}
    grown = frozen.model_copy(
        update={
            "configurations": list(configurations.values()),
            "left_out": list(without.values()),
            "cases": list(cases.values()),
            "repeats": max(frozen.repeats, asked.repeats),
        }
    )
    unasked = _cells(grown) - _cells(frozen) - _cells(asked)
    if unasked:
        raise BadInput(
            f"this run would grow by trials that nobody asked for ({len(unasked)}), such as {'/'.join(min(unasked))}: "
            "a plan is every agent on every case",
            where=where,
            todo="ask for all of the run's agents or all of its cases, or choose another --run-id",
        )
    return grown


def _cells(plan: Plan) -> set[tuple[str, str, str]]:
    return {
        (chosen.name, case.case_id, f"r{repeat}")
        for chosen in plan.configurations
        for case in plan.cases
        for repeat in range(1, plan.repeats + 1)
    }


def trials(run: Path, suite: Path, plan: Plan) -> Iterator[Trial]:
    """All scheduled trials, case by case so that every configuration advances together."""
    for repeat in range(1, plan.repeats + 1):
        for case in plan.cases:
            for configuration in plan.configurations:
                yield Trial(run=run, suite=suite, configuration=configuration, case=case, repeat=repeat)
