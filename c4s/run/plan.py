"""Making, freezing and reopening the plan of a run."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from c4s.errors import BadInput
from c4s.files import digest
from c4s.packs.suite_check import check_case
from c4s.records.folder import RunFolder, TrialFolder
from c4s.records.plan import Configuration, Plan, PlannedCase
from c4s.records.suite import SuiteFolder
from c4s.run.choices import check_configurations, check_labels

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
    def folder(self) -> TrialFolder:
        """Where the trial's files lie."""
        return RunFolder(self.run).trial(self.configuration.name, self.case.case_id, self.repeat)

    @property
    def name(self) -> str:
        """``configuration/case/r<k>``, for people."""
        return f"{self.configuration.name}/{self.case.case_id}/r{self.repeat}"


def trial_id(plan: Plan, trial: Trial) -> str:
    """Identity of a trial (16 hex) by content only: suite, case, configuration, repeat, policy, judge, engine."""
    return digest(
        [
            plan.suite_digest,
            trial.case.plain(),
            trial.configuration.plain(),
            trial.repeat,
            plan.policy,
            plan.judge,
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
) -> Plan:
    """A plan over the suite's cases (all, or those named).

    Raises ``BadInput`` for an unknown case, for a case or pack that is not as it was frozen, and for an engine, judge,
    policy or configuration that cannot be obeyed (``c4s.run.choices``).
    """
    from c4s.run.host import this_host

    check_labels(engine, judge, policy)
    check_configurations(configurations)
    if repeats < 1:
        raise BadInput(f"{repeats} repeats are no plan", todo="give 1 or more")
    record = suite.suite()
    known = {case.case_id for case in record.cases}
    for case_id in cases:
        if case_id not in known:
            raise BadInput(f"no case {case_id!r} in suite {record.suite_id!r}", todo="see `c4s suite show`")
    chosen = [case for case in record.cases if not cases or case.case_id in cases]
    for case in chosen:
        check_case(suite, case)
    planned = [
        PlannedCase(
            case_id=case.case_id,
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
        cases=planned,
        repeats=repeats,
        policy=policy,
        judge=judge,
        engine=engine,
        versions=versions(),
        host=this_host(),
    )


def open_run(root: Path, plan: Plan) -> Plan:
    """Freeze the plan in the run folder, or check that the frozen one asks for the same.

    Library versions and the host may differ from the frozen ones; everything else must agree, else ``BadInput``.
    """
    path = RunFolder(root).plan
    if not path.is_file():
        plan.write(path)
        return plan
    frozen = Plan.read(path)
    if frozen.model_copy(update={"versions": plan.versions, "host": plan.host}) != plan:
        raise BadInput(
            "this run was started with another plan (suite, agents, policy, judge or engine)",
            where=str(path),
            todo="choose another --run-id",
        )
    return frozen


def trials(run: Path, suite: Path, plan: Plan) -> Iterator[Trial]:
    """All scheduled trials, case by case so that every configuration advances together."""
    for repeat in range(1, plan.repeats + 1):
        for case in plan.cases:
            for configuration in plan.configurations:
                yield Trial(run=run, suite=suite, configuration=configuration, case=case, repeat=repeat)
