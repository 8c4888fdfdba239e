"""What a run will do, frozen before it starts."""

from __future__ import annotations

from typing import Any, ClassVar, Literal

from pydantic import Field, SerializerFunctionWrapHandler, model_serializer

from c4s.names import Name
from c4s.protocol.settings import SETTING_ALIASES, Setting
from c4s.records.base import Record, Sealed
from c4s.records.judge import RULE_JUDGE, JudgeConfiguration


class Substitute(Record):
    """The client that works in a configuration's place on some cases."""

    client: Name
    model: str | None = None
    """Null: the configuration's."""
    options: dict[str, Any] = Field(default_factory=dict)


class Configuration(Record):
    """An agent configuration: client, model and options. ``name`` is its identity in tables."""

    name: Name
    client: Name
    """``noop``, ``random``, ``planner``, ``vandal``, ``oracle``, or the name of an agent client."""
    model: str | None = None
    options: dict[str, Any] = Field(default_factory=dict)
    per_case: dict[str, Substitute] = Field(default_factory=dict)
    """Who works instead, by case id or by setting (any of its published names); a case goes before its setting."""
    harness: Name | None = None
    """The program that drives the agent where c4s does not start it (``inspect_ai``, ``harbor``): what counts as a
    call, and which budgets hold, differs by harness. Null, and left out of the record, where c4s does."""

    @model_serializer(mode="wrap")
    def _without_none(self, made: SerializerFunctionWrapHandler) -> dict[str, Any]:
        """A configuration that knows no harness keeps the digest that it had before there were any."""
        record: dict[str, Any] = made(self)
        if record.get("harness", "") is None:
            del record["harness"]
        return record

    def on(self, case_id: str, setting: Setting) -> Configuration:
        """The configuration that works on a case: this one, or one of its name with the client that it names there."""
        by_setting = {SETTING_ALIASES.get(key): substitute for key, substitute in self.per_case.items()}
        chosen = self.per_case.get(case_id) or by_setting.get(setting)
        return self if chosen is None else self._with(chosen)

    def everyone(self) -> list[Configuration]:
        """This one, and every one that works in its place."""
        return [self, *map(self._with, self.per_case.values())]

    def _with(self, chosen: Substitute) -> Configuration:
        return Configuration(
            name=self.name,
            client=chosen.client,
            model=chosen.model or self.model,
            options=chosen.options,
            harness=self.harness,
        )


class LeftOut(Record):
    """A default agent that cannot work on the cases of a run, and why."""

    agent: Name
    reason: str


class PlannedCase(Record):
    """A scheduled case with the digests that identify its content."""

    case_id: Name
    alias: Name
    """What the case is called where an agent can see it."""
    setting: Setting
    scene_id: Name
    agent_digest: str
    withheld_digest: str


class Host(Record):
    """The machine that a plan was made on. It is for the record: no identity, and any other machine may go on."""

    engine_version: str
    """Version of the engine's API."""
    commit: str | None
    """Commit of the c4s checkout, with ``-dirty`` where files were changed; null for an installed c4s."""
    system: str
    processor: str
    cores: int
    """How many the process may use."""
    gpus: list[str]
    sandbox: str | None
    """What confines engines here: ``bubblewrap``, ``landlock``, ``none`` by choice; null where there is nothing."""


class Plan(Sealed):
    """What a run will do, frozen before it starts. Nothing volatile (path, port, time) is part of it."""

    REMEDY: ClassVar[str] = "restore the file, or choose another --run-id"
    schema_version: Literal["c4s.plan.v2"] = "c4s.plan.v2"
    run_id: Name
    suite_id: Name
    suite_digest: str
    configurations: list[Configuration]
    left_out: list[LeftOut] = Field(default_factory=list)
    """Default agents that the run does without; none where its agents were named."""
    cases: list[PlannedCase]
    repeats: int = 1
    policy: str
    judge: str
    """Name of the judge: ``rule`` for the offline rule judge, else what its configuration is called."""
    judge_configuration: JudgeConfiguration = RULE_JUDGE
    judge_version: str = ""
    """Digest of that configuration, its prompts and the code that judges. Another one is another judge."""
    engine: str
    """``headless`` or ``unreal``."""
    versions: dict[str, str]
    """Of c4s and of the libraries that can change a result; for the record, like ``host``."""
    host: Host | None = None
