"""A trial whose agent another program drives: c4s opens the scene, hands the tools over, and scores what was saved."""

from __future__ import annotations

import threading
from concurrent.futures import Future
from pathlib import Path

from c4s.agents.base import AgentContext, AgentReport
from c4s.agents.outside import OUTSIDE
from c4s.errors import MachineryFault
from c4s.folders import numbered_folder
from c4s.home import home
from c4s.records.attempt import AttemptOutcome
from c4s.records.folder import RunFolder
from c4s.records.plan import Configuration, Plan
from c4s.records.score import TrialScore
from c4s.records.suite import SuiteFolder
from c4s.run.attempt import run_attempt
from c4s.run.grading import open_trial, score_recorded
from c4s.run.inputs import inputs
from c4s.run.plan import Trial, trials
from c4s.toolbox.gateway import Endpoint

LOOK_S = 0.1


class HandedTools:
    """An agent that gives its tools away and waits until whoever got them says that the work is done."""

    def __init__(self) -> None:
        self.opened: Future[Endpoint] = Future()
        self.ended: Future[AgentReport] = Future()

    def run(self, context: AgentContext) -> AgentReport:
        """Hand the tools over; the report of the other side, which may come after the run's own end."""
        self.opened.set_result(context.endpoint)
        while not self.ended.done() and not context.stopped(LOOK_S):
            continue
        return self.ended.result()


class DrivenTrial:
    """One trial in a folder of its own under ``tries/``."""

    def __init__(self, trial: Trial, plan: Plan) -> None:
        self.trial, self.plan = trial, plan
        self._agent = HandedTools()
        self._outcome: Future[AttemptOutcome] = Future()

    @classmethod
    def open(
        cls, suite: Path, case: str, *, harness: str, model: str | None, policy: str, judge: str, engine: str
    ) -> DrivenTrial:
        """Check all that is asked for, and make the folder. ``BadInput`` before anything is made.

        Args:
            suite: the built suite.
            case: id of the case.
            harness: name of the program that drives the agent.
            model: what that program calls its model.
            policy: as for a run.
            judge: as for a run.
            engine: as for a run.
        """
        chosen = Configuration(name=OUTSIDE, client=OUTSIDE, model=model, harness=harness)
        alias = SuiteFolder(suite).case(case).alias
        return cls(
            *open_trial(
                suite,
                case,
                lambda: numbered_folder(home() / "tries", f"{harness}-{alias}") / "run",
                configuration=chosen,
                policy=policy,
                judge=judge,
                engine=engine,
            )
        )

    def start(self) -> Endpoint:
        """Start the engine; where the tools are. What keeps it from starting is raised here."""
        threading.Thread(target=self._attempt, name=f"driven-{self.trial.case.alias}", daemon=True).start()
        return self._agent.opened.result()

    def finish(self, report: AgentReport) -> AttemptOutcome:
        """End the attempt, with what the other side tells of its work."""
        self._agent.ended.set_result(report)
        return self._outcome.result()

    def _attempt(self) -> None:
        try:
            given = inputs(self.trial)
            self._outcome.set_result(
                run_attempt(
                    given.case,
                    given.agent_folder,
                    self.trial.working,
                    1,
                    self.trial.folder.attempt(1).root,
                    given.packs,
                    None,
                    engine=self.plan.engine,
                    agent=self._agent,
                )
            )
        except BaseException as error:
            self._outcome.set_exception(error)
            if not self._agent.opened.done():
                self._agent.opened.set_exception(error)


def score_driven(root: Path, suite: Path) -> TrialScore:
    """Verify and score the attempt in a run's folder. ``MachineryFault`` where it has not ended."""
    plan = Plan.read(RunFolder(root).plan)
    (trial,) = trials(root, suite, plan)
    if not trial.folder.attempt(1).done:
        raise MachineryFault("the attempt has not ended", where=trial.name)
    return score_recorded(trial, plan)
