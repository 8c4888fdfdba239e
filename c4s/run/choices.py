"""What a plan may name: engine, judge, policy, configurations. A label is a promise, so none is taken on trust."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Sequence

from c4s.agents.base import ModelClient, agent_of
from c4s.engine import engine_kinds
from c4s.engine.confine.sandbox import backend
from c4s.errors import BadInput, unknown
from c4s.judge.names import JUDGE_NAMES
from c4s.meter.endpoints import key_of, spending_limit
from c4s.protocol.baselines import BASELINES, CHEATS
from c4s.protocol.settings import SETTING_ALIASES, SETTINGS
from c4s.records.folder import RunFolder
from c4s.records.plan import Configuration
from c4s.score.policies import POLICIES


def check_labels(engine: str, judge: str, policy: str) -> None:
    """``BadInput``, with the choices, for an engine, judge or policy that is not there, needed by a case or not."""
    if engine not in engine_kinds():
        raise unknown("engine", engine, engine_kinds())
    if judge not in JUDGE_NAMES:
        raise unknown("judge", judge, JUDGE_NAMES)
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


def check_ready(configurations: Sequence[Configuration]) -> None:
    """``BadInput`` or ``MachineryFault`` for what cannot be started on this machine, with what to do.

    That is a client, the key of its model's endpoint, or the sandbox that ``C4S_SANDBOX`` names; a spending limit that
    is no amount is refused too.
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
