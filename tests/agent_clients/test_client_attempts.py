"""Attempts of agents that use a model, on a real engine: the API loop, and a program of its own in the sandbox."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from canned import CannedUpstream, Reply
from made_case import make_case, make_pack
from scripted_endpoint import ScriptedEndpoint, Use

from c4s.agents.base import AgentContext, agent_of
from c4s.agents.model import open_model
from c4s.engine.confine.sandbox import faults
from c4s.errors import AgentFault, BadInput, MachineryFault
from c4s.files import json_lines
from c4s.meter.spending import Ledger, SpendingLimitReached
from c4s.records.attempt import AttemptOutcome
from c4s.records.plan import Configuration
from c4s.toolbox.gateway import Endpoint

Attempt = Callable[..., tuple[AttemptOutcome, Path]]
SAVE = [Use("save_scene_as", {"name": "submission"})]
SCRIPT = [
    [Use("search_assets", {"query": "table"}), Use("get_categories")],
    [Use("get_asset_preview", {"id": "crate"})],
    SAVE,
]
confined = pytest.mark.skipif(faults()["bubblewrap"] is not None, reason=f"no bubblewrap: {faults()['bubblewrap']}")


def lines(path: Path) -> list[dict[str, Any]]:
    with path.open() as source:
        return list(json_lines(source))


def test_the_api_loop_plays_a_case(attempt: Attempt) -> None:
    with ScriptedEndpoint(SCRIPT) as endpoint:
        outcome, folder = attempt("api", endpoint.url, options={"thinking": False, "seed": 4})
        total = endpoint.totals()
        assert endpoint.bodies[-1]["seed"] == 4 and endpoint.served[-1].pictures == 1
        assert endpoint.bodies[-1]["chat_template_kwargs"] == {"enable_thinking": False}
        roles = [message["role"] for message in endpoint.bodies[-1]["messages"]]
    assert roles == ["user", "assistant", "tool", "tool", "assistant", "tool", "user", "assistant", "tool"]
    assert (outcome.ended_by, outcome.submission, outcome.tool_calls, outcome.message) == (
        "finished",
        "/Game/SavedScenes/submission",
        4,
        "The scene is saved.",
    )
    assert outcome.input_tokens == total["fresh"] + total["cache_read"] + total["cache_write"]
    assert outcome.output_tokens == total["output"] and outcome.cost_usd == pytest.approx(
        (10 * total["fresh"] + total["cache_read"] + 12 * total["cache_write"] + 100 * total["output"]) / 1e6
    )
    turns = [line for line in lines(folder / "agent/api.jsonl") if line["event"] == "turn"]
    pictures = [line["images"] for line in lines(folder / "trajectory.jsonl") if line.get("images")]
    assert turns[1]["pictures"] == [pictures[0][0]["sha256"]]
    assert Ledger(folder.parent / "spending.jsonl", None).spent().settled_usd == pytest.approx(outcome.cost_usd)


def test_a_full_context_is_trimmed_bad_arguments_are_counted_and_a_loop_is_stopped(attempt: Attempt) -> None:
    class Rambling(ScriptedEndpoint):
        """Asks for picture after picture, and with arguments that are none; saves; then repeats itself."""

        def _next(self, results: list[str], tools: dict[str, Any]) -> tuple[list[tuple[Any, Any]], str]:
            done = len(self.bodies)
            if done <= 8:
                return [("get_asset_preview", {"id": "crate"}), ("get_categories", ["none " * 1000, done])], ""
            return [("save_scene_as", {"name": "submission"}) if done == 9 else ("get_categories", {})], ""

    with Rambling([]) as endpoint:
        outcome, folder = attempt(
            "api", endpoint.url, options={"context_tokens": 8_000, "max_tokens": 1000, "same_calls": 3}
        )
    trims = [line for line in lines(folder / "agent/api.jsonl") if line["event"] == "trim"]
    assert trims and sum(trim["pictures_removed"] for trim in trims) > 0
    assert all(trim["after_tokens"] < trim["before_tokens"] for trim in trims)
    assert (outcome.ended_by, outcome.tool_calls) == ("finished", 19) and "same call 3 times" in outcome.message
    assert outcome.submission == "/Game/SavedScenes/submission"
    errors = [
        line
        for line in lines(folder / "trajectory.jsonl")
        if line["event"] == "call" and line["tool"] == "get_categories"
    ][:8]
    assert len(errors) == 8 and all(line["outcome"] == "error" and line["counted"] for line in errors)


HALF = "\ud83d"
UNSENDABLE = {
    "half a character": ("search_assets", json.dumps({"query": HALF, "nothing": 1})),
    "half a character in a key": ("search_assets", json.dumps({HALF: "1"})),
    "half a character in the name": (f"search{HALF}", "{}"),
    "half a character bare": ("search_assets", HALF),
    "too large": ("execute_python_script", json.dumps({"script": "#" * 4_300_000})),
    "nested": ("search_assets", '{"query":' + "[" * 200 + "]" * 200 + "}"),
    "nested deep": ("search_assets", '{"query":' + "[" * 3000 + "]" * 3000 + "}"),
    "a long number": ("get_actors_in_level", '{"offset":' + "9" * 4200 + "}"),
}


def said(name: str, arguments: str) -> Reply:
    call = {"id": "1", "type": "function", "function": {"name": name, "arguments": arguments}}
    message = {"content": f"a {HALF}", "reasoning_content": HALF, "tool_calls": [call] if name else []}
    return Reply([json.dumps({"choices": [{"message": message, "finish_reason": "stop"}]}).encode()])


@pytest.mark.parametrize("name", UNSENDABLE)
def test_a_call_that_cannot_be_sent_is_refused_and_the_model_goes_on(attempt: Attempt, name: str) -> None:
    replies = [said("save_scene_as", '{"name": "submission"}'), said(*UNSENDABLE[name]), said("", "")]
    with CannedUpstream(*replies) as upstream:
        outcome, folder = attempt("api", upstream.url, options={"context_tokens": 4_000_000})
    assert (outcome.ended_by, outcome.submission) == ("finished", "/Game/SavedScenes/submission")
    assert outcome.message == "a ?"
    turns = lines(folder / "agent/api.jsonl")
    assert [turn["assistant"]["reasoning_content"] for turn in turns] == ["?", "?"]
    assert "error" in json.loads(turns[1]["results"][0])


def test_waiting_for_a_job_is_no_loop(attempt: Attempt) -> None:
    script = [[Use("execute_python_script", {"script": "print(1)"})], *[[Use("read_job_log")]] * 6, SAVE]
    with ScriptedEndpoint(script) as endpoint:
        outcome, folder = attempt("api", endpoint.url, options={"same_calls": 3})
    assert (outcome.tool_calls, outcome.submission) == (8, "/Game/SavedScenes/submission")
    assert sum(line.get("polling", False) for line in lines(folder / "trajectory.jsonl") if line["counted"]) == 6


def test_the_spending_limit_leaves_the_trial_pending_and_a_higher_one_completes_it(
    attempt: Attempt, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    with ScriptedEndpoint(SCRIPT) as endpoint:
        monkeypatch.setenv("C4S_SPENDING_LIMIT_USD", "0.02")
        with pytest.raises(SpendingLimitReached, match="spending limit"):
            attempt("api", endpoint.url)
        assert not (tmp_path / "run/attempt-1/outcome.json").exists()
        spent = lines(tmp_path / "run/attempt-1/usage.jsonl")
        assert 1 <= len([line for line in spent if line["ending"] == "ok"]) < 4 and spent[-1]["ending"] == "refused"
        monkeypatch.setenv("C4S_SPENDING_LIMIT_USD", "5")
        outcome, folder = attempt("api", endpoint.url)
    assert outcome.ended_by == "finished" and (folder.parent / "attempt-1.interrupted-1/usage.jsonl").is_file()


PLAIN = Path(__file__).with_name("plain_client.py").absolute()


def plain(*probes: str) -> dict[str, Any]:
    python = Path(sys.executable).resolve()
    return {
        "command": [
            str(python),
            str(PLAIN),
            "{model}",
            "{model_url}",
            "{model_token}",
            "{tools_url}",
            "{tools_token}",
            *probes,
        ],
        "environment": {"TOKEN": "{tools_token}"},
        "read_only": [str(PLAIN), *([] if python.is_relative_to("/usr") else [str(python.parents[1])])],
        "version": "plain 7",
    }


@confined
def test_a_program_of_its_own_plays_a_case_and_sees_nothing_else(attempt: Attempt, tmp_path: Path) -> None:
    (tmp_path / "suite/withheld/room").mkdir(parents=True)
    (tmp_path / "suite/withheld/room/truth.level.json").write_text("{}")
    hidden = [
        str(tmp_path / "suite/withheld/room/truth.level.json"),
        str(tmp_path / "suite"),
        str(tmp_path / "home"),
        str(Path(__file__).parents[2] / "c4s"),
        "/etc/shadow",
        "/proc/1/root" + str(tmp_path / "suite"),
    ]
    with ScriptedEndpoint(SCRIPT) as endpoint:
        addresses = [f"127.0.0.1:{endpoint.port}", "127.0.0.1:22", "10.255.255.1:80"]
        outcome, folder = attempt("command", endpoint.url, options=plain(*hidden, *addresses))
        assert {one.key for one in endpoint.served} == {"the-real-key"} and not endpoint.missing
    assert (outcome.ended_by, outcome.submission, outcome.tool_calls) == ("finished", "/Game/SavedScenes/submission", 4)
    assert outcome.client_version == "command plain 7" and outcome.output_tokens == endpoint.totals()["output"]
    told = json.loads((folder / "agent/command.stdout").read_text().splitlines()[0])
    assert "reached" not in told["probes"].values() and len(told["probes"]) == 9
    assert set(told["environment"]) <= {"PATH", "HOME", "LANG", "USER", "TMPDIR", "TOKEN", "PWD", "LC_CTYPE"}
    assert "the-real-key" not in json.dumps(told) and told["home"] == ["mcp.json"]


def alone(client: str, url: str, tmp_path: Path, options: dict[str, Any]) -> None:
    """Run a client's adapter against a model endpoint, with no gateway behind its address."""
    case, agent_folder = make_case(tmp_path / "suite", make_pack(tmp_path / "packs"), setting="text-to-scene")
    (tmp_path / "home/endpoints.yaml").write_text(
        json.dumps({"endpoints": {"here": {"url": url, "formats": ["openai-chat"]}}})
    )
    configuration = Configuration(name=client, client=client, model="m", options={"endpoint": "here", **options})
    (tmp_path / "agent").mkdir()
    with open_model(
        configuration, "here", "openai-chat", usage=tmp_path / "usage.jsonl", ledger=None, at_limit=lambda: None
    ) as model:
        agent_of(configuration).run(
            AgentContext(
                case,
                agent_folder,
                Endpoint("http://127.0.0.1:18765/mcp", "t"),
                configuration,
                1,
                tmp_path / "agent",
                None,
                model,
            )
        )


@confined
@pytest.mark.parametrize(
    ("shell", "reply", "error", "text"),
    [
        ("exit 3", None, MachineryFault, "status 3: broken, before it asked its model"),
        ("exit 0", None, MachineryFault, "before it asked its model"),
        (
            "{ask}; exit 4",
            Reply([b'{"error": {"message": "bad key"}}'], status="401 No"),
            MachineryFault,
            "401: bad key",
        ),
        ("{ask}; exit 5", Reply([b'{"choices": []}']), AgentFault, "status 5: broken$"),
    ],
)
def test_whose_fault_it_is_when_a_program_fails(
    attempt: Attempt, tmp_path: Path, shell: str, reply: Reply | None, error: type[Exception], text: str
) -> None:
    ask = """python3 -c 'import sys, urllib.request as u
try: u.urlopen(u.Request("{model_url}/v1/chat/completions", b"{\\"model\\": \\"m\\"}",
                         {"Authorization": "Bearer {model_token}"}))
except OSError: pass'"""
    options = {**plain(), "command": ["sh", "-c", "echo broken >&2; " + shell.replace("{ask}", ask)]}
    with CannedUpstream(reply or Reply([b"{}"])) as upstream, pytest.raises(error, match=text):
        alone("command", upstream.url, tmp_path, options)


@confined
def test_a_program_that_goes_on_after_its_budget_is_ended(attempt: Attempt) -> None:
    with ScriptedEndpoint([SAVE, *[[Use("get_categories")]] * 500]) as endpoint:
        outcome, _ = attempt("command", endpoint.url, options=plain(), calls=3)
    assert (outcome.ended_by, outcome.tool_calls, outcome.submission) == (
        "call_budget",
        3,
        "/Game/SavedScenes/submission",
    )


@pytest.mark.parametrize(
    ("client", "options", "text"),
    [
        ("codex", {"program": "/nowhere/codex"}, "npm install .*@openai/codex"),
        ("claude_code", {"program": "/nowhere/claude"}, "npm install .*@anthropic-ai/claude-code"),
        ("gemini", {"program": "/nowhere/gemini"}, "npm install .*@google/gemini-cli"),
        ("opencode", {"program": "/nowhere/opencode"}, "npm install .*opencode-ai"),
        ("hermes", {"program": "/nowhere/hermes"}, r"pip.*hermes-agent\[mcp\]"),
        ("antigravity", {"command": ["/nowhere/agy"]}, "not installed.*Antigravity"),
        ("command", {"command": ["/nowhere/agent"]}, "not installed"),
        ("command", {}, "needs its command line"),
    ],
)
def test_a_client_that_is_not_installed_says_how_to_install_it(
    attempt: Attempt, client: str, options: dict[str, Any], text: str
) -> None:
    with pytest.raises(BadInput, match=text):
        attempt(client, "http://127.0.0.1:1", options=options)


def test_doctor_lists_the_clients_with_their_version_or_how_to_install_them(tmp_path: Path) -> None:
    module = tmp_path / "clients/codex/node_modules"
    (module / "@openai/codex").mkdir(parents=True)
    (module / "@openai/codex/package.json").write_text('{"version": "9.8.7"}')
    (module / ".bin").mkdir()
    (module / ".bin/codex").write_text("#!/bin/sh\n")
    (module / ".bin/codex").chmod(0o755)
    environment = {**os.environ, "C4S_HOME": str(tmp_path), "COLUMNS": "400", "PATH": "/usr/bin:/bin"}
    shown = subprocess.run(
        [sys.executable, "-m", "c4s.cli", "doctor"], env=environment, text=True, capture_output=True, check=False
    ).stdout
    rows = {row.split("│")[0].strip(): row for row in shown.splitlines() if row.startswith("client ")}
    assert re.search(r"│ yes +│ no +│ 9\.8\.7, .*codex", rows["client codex"])
    for name, way in (
        ("claude_code", "npm install"),
        ("gemini", "npm install"),
        ("opencode", "npm install"),
        ("hermes", "hermes-agent[mcp]"),
        ("antigravity", "vendor"),
    ):
        assert re.search(r"│ no +│ no +│.*" + re.escape(way), rows[f"client {name}"])


@pytest.mark.parametrize(
    ("options", "text"),
    [({"endpoint": "nowhere"}, "unknown model endpoint"), ({"endpoint": "anthropic"}, "speaks openai-chat")],
)
def test_an_endpoint_that_does_not_fit_is_named(attempt: Attempt, options: dict[str, Any], text: str) -> None:
    with pytest.raises(BadInput, match=text):
        attempt("api", "http://127.0.0.1:1", options=options)
