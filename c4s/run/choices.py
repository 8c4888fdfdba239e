"""What a plan may name: engine, judge, policy, configurations. A label is a promise, so none is taken on trust."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Sequence

from c4s.agents.base import ModelClient, agent_of
from c4s.engine import engine_kinds
from c4s.engine.confine.sandbox import backend
from c4s.errors import BadInput, unknown
from c4s.judge.registry import is_online
from c4s.meter.endpoints import key_of, spending_limit
from c4s.meter.spending import UNPRICED
from c4s.protocol.baselines import BASELINES, CHEATS, ORACLE
from c4s.protocol.settings import SETTING_ALIASES, SETTINGS
from c4s.records.folder import RunFolder
from c4s.records.plan import Configuration, LeftOut, Plan
from c4s.records.suite import SuiteCase, SuiteFolder, WithheldFolder
from c4s.score.policies import POLICIES
from c4s.weights import model_folder


def check_labels(engine: str, policy: str) -> None:
    """``BadInput``, with the choices, for an engine or policy that is not there, needed by a case or not."""
    if engine not in engine_kinds():
        raise unknown("engine", engine, engine_kinds())
    if policy not in POLICIES:
        raise unknown("policy", policy, POLICIES)


def check_configurations(configurations: Sequence[Configuration]) -> None:
    """``BadInput`` for a name that is given twice or that a run folder needs, an unknown client, and a model that its
    client could not reach."""
    for name, times in Counter(chosen.name.lower() for chosen in configurations).items():
        if times > 1:
            raise BadInput(
                f"{times} configurations are called {name!r}, letter case aside",
                todo="give each agent a name of its own",
            )
    for chosen in configurations:
        if chosen.name.lower() in RunFolder.own_names():
            raise BadInput(
                f"{chosen.name!r} is the name of something in every run folder", todo="give this agent another name"
            )
        if chosen.name in (*BASELINES, *CHEATS) and any(one.client != chosen.name for one in chosen.everyone()):
            raise BadInput(f"{chosen.name!r} is the name of a baseline", todo="give this agent a name of its own")
        for one in chosen.everyone():
            _check_client(one)


def _check_client(chosen: Configuration) -> None:
    agent = agent_of(chosen)
    if isinstance(agent, ModelClient):
        from c4s.agents.model import check_model

        check_model(chosen, agent.endpoint, agent.wire_of(chosen))


def check_substitutes(configurations: Sequence[Configuration], cases: Collection[str], *, where: str) -> None:
    """``BadInput`` where a configuration names another client for what is neither a setting nor one of the cases."""
    for chosen in configurations:
        for key in chosen.per_case:
            if key not in cases and key not in SETTING_ALIASES:
                raise unknown("case or setting", key, [*SETTINGS, *cases], where=f"per_case of {chosen.name}, {where}")


def default_agents(suite: SuiteFolder, cases: Collection[str]) -> tuple[tuple[str, ...], list[LeftOut]]:
    """The baselines that can work on the named cases of a suite (all where none is named), and those that cannot.

    The oracle needs an original of every case, and tasks that came from others may have none.
    """
    chosen = [case for case in suite.suite().cases if not cases or case.case_id in cases]
    bare = [case.case_id for case in chosen if not _has_original(suite, case)]
    if not bare:
        return BASELINES, []
    without = f"{bare[0]!r}" if len(bare) == 1 else f"{len(bare)} of {len(chosen)} cases, such as {bare[0]!r},"
    reason = f"{without} came without an original scene, so it has nothing to save"
    return tuple(name for name in BASELINES if name != ORACLE), [LeftOut(agent=ORACLE, reason=reason)]


def check_originals(configurations: Sequence[Configuration], suite: SuiteFolder, cases: Sequence[SuiteCase]) -> None:
    """``BadInput`` where the oracle would have to save the original of a case that has none."""
    for chosen in configurations:
        for case in cases:
            if chosen.on(case.case_id, case.setting).client == ORACLE and not _has_original(suite, case):
                raise BadInput(
                    f"the case {case.case_id!r} came without an original scene, so the oracle has nothing to save",
                    where=f"agent {chosen.name}",
                    todo="leave it out: name the agents, such as -a planner",
                )


def _has_original(suite: SuiteFolder, case: SuiteCase) -> bool:
    return WithheldFolder(suite.withheld(case.case_id)).truth_level.is_file()


def check_judge(plan: Plan, limit_usd: float | None = None) -> None:
    """``BadInput`` where the plan's judge asks a model whose endpoint or key is not there, where a price file cannot
    be read, and where a limit in dollars is set for a model without a price."""
    if is_online(plan.judge_configuration):
        from c4s.judge.model.endpoints import served
        from c4s.meter.prices import price_today

        served(plan.judge_configuration)
        model = plan.judge_configuration.model
        if price_today(model) is None and limit_usd is not None:
            raise BadInput(
                f"the judge's spending limit of {limit_usd:.2f} USD cannot be kept: no price for model {model!r}",
                todo=UNPRICED,
            )


def check_ready(configurations: Sequence[Configuration]) -> None:
    """``BadInput`` or ``MachineryFault`` for what cannot be started on this machine, with what to do.

    That is a client, the key of its model's endpoint, the sentence model of the asset search, or the sandbox that
    ``C4S_SANDBOX`` names; a spending limit that is no amount is refused too.
    """
    backend()
    spending_limit()
    for chosen in [one for configuration in configurations for one in configuration.everyone()]:
        agent = agent_of(chosen)
        if isinstance(agent, ModelClient):
            from c4s.agents.model import check_model

            agent.ready(chosen)
            name, endpoint, _ = check_model(chosen, agent.endpoint, agent.wire_of(chosen))
            key_of(name, endpoint)
    model_folder()
