"""What each client's model receives of the largest answers of the tools: whole, cut, or something else in their place.

``python tests/agent_clients/received.py [--case CASE] [CLIENT ...]`` lets a scripted model call the tools whose answers
are longest, on the largest start level of the starter suite, through every installed client. It prints a table answer x
client with the characters that the gateway sent and, where the next request of the client held other text, the
characters that its model received. Exit 1 where one was not whole, unless the call asked for a longer one than it gets
by itself. ``matrix.py --install`` installs the clients.
"""

from __future__ import annotations

import argparse
import json
import re
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parent))
from matrix import CLIENTS, MODELS, built_suite, endpoints, stand_in
from scripted_endpoint import WIRES, ScriptedEndpoint, Use

from c4s.errors import C4SError
from c4s.files import json_lines
from c4s.home import home, packs_root
from c4s.records.plan import Configuration
from c4s.records.suite import SuiteFolder
from c4s.run.attempt import run_attempt

BEGINNING = 200
"""Characters at the beginning of an answer that tell it."""
CASE = "outdoor-harbour-market-row"
PRINT = "print('\\n'.join(f'{number:05d} a line of output of a script, as long as a line is' for number in range(%d)))"
WIDE = "print('\u5834\u666f\u4e2d\u7684\u7269\u4ef6 ' * 5000)"
LONG_ERROR = "raise ValueError('no ' * 1_000_000)"
LONG_NAME = {"name": "Nothing", "static_mesh": "nothing " * 2_000, "location": [0, 0, 0]}


@dataclass(frozen=True)
class Answer:
    """A call whose answer is long."""

    title: str
    use: Use
    asked: bool = False
    """Whether the call asks for more than an answer has by itself: then a client may cut it."""


def answers(catalog: Sequence[str]) -> list[Answer]:
    """The calls, in the order in which they are made."""
    nodes = [
        {"id": f"n{number}", "asset": path, "at": [8 * (number % 20) - 80, 8 * (number // 20) - 40], "count": 2}
        for number, path in enumerate(2 * [path for path in catalog if not path.endswith("_C")])
    ]
    return [
        Answer("get_actors_in_level", Use("get_actors_in_level")),
        Answer("get_actors_in_level, limit 1000", Use("get_actors_in_level", {"limit": 1000}), asked=True),
        Answer("find_actors_by_name *", Use("find_actors_by_name", {"pattern": "*"})),
        Answer("search_assets", Use("search_assets", {"query": "house boat stall barrel tree wall"})),
        Answer("search_assets, k 100", Use("search_assets", {"query": "house boat stall barrel tree", "k": 100}), True),
        Answer("get_asset_metadata, all", Use("get_asset_metadata", {"ids": list(catalog)[:200]})),
        Answer("get_categories", Use("get_categories")),
        Answer("a script's output", Use("execute_python_script", {"script": PRINT % 3000, "execution_mode": "sync"})),
        Answer("read_job_log", Use("read_job_log", {"wait_s": 30})),
        Answer("read_job_log, max_bytes 150000", Use("read_job_log", {"max_bytes": 150_000}), asked=True),
        Answer("a script's output, wide", Use("execute_python_script", {"script": WIDE, "execution_mode": "sync"})),
        Answer("a script's error", Use("execute_python_script", {"script": LONG_ERROR, "execution_mode": "sync"})),
        Answer("check_collisions", Use("check_collisions", {"touch_tolerance_cm": 0})),
        Answer("check_floating", Use("check_floating", {"threshold_cm": 0})),
        Answer("measure_scene", Use("measure_scene")),
        Answer("validate_scene_graph", Use("validate_scene_graph", {"graph": {"nodes": nodes}})),
        Answer("solve_scene_graph", Use("solve_scene_graph", {"graph": {"nodes": nodes}})),
        Answer("tier_derivation", Use("tier_derivation")),
        Answer("a refusal", Use("spawn_actor", LONG_NAME)),
    ]


@dataclass(frozen=True)
class Received:
    """What the gateway sent and what the model got of it, in characters."""

    sent: int
    received: int
    how: str
    """``whole``, ``cut`` (its beginning is there), ``replaced``, or ``nothing``."""

    def cell(self) -> str:
        """It, for the table."""
        return f"{self.sent}" if self.how == "whole" else f"{self.sent} > {self.received} {self.how}"


def compared(sent: str, length: int, received: str | None) -> Received:
    """How an answer of ``length`` characters, whose beginning is on record as ``sent``, compares with a tool result."""
    if received is None:
        return Received(length, 0, "nothing")
    found = list(texts(received))
    got = max((len(text) - at for text in found if (at := text.find(sent)) >= 0), default=0)
    if got >= length:
        return Received(length, length, "whole")
    began = any(sent[:BEGINNING] in text for text in found)
    return Received(length, len(max(found, key=len)), "cut" if began else "replaced")


def texts(received: str) -> Iterator[str]:
    """A tool result, and the texts in the JSON that it holds: clients wrap answers in JSON and in words."""
    waiting: list[Any] = [received]
    while waiting:
        value = waiting.pop()
        if isinstance(value, dict):
            waiting += value.values()
        elif isinstance(value, list):
            waiting += value
        elif isinstance(value, str):
            yield value
            waiting += json_in(value)


def json_in(text: str) -> Iterator[Any]:
    """What begins in a text like an answer, a client's own or the gateway's."""
    for found in re.finditer(r'\{"|\[', text):
        try:
            yield json.JSONDecoder().raw_decode(text, found.start())[0]
        except ValueError:
            continue
        return


def results_in(bodies: Sequence[dict[str, Any]], wire: str) -> list[str]:
    """Each tool result as the first request that held it: later requests may hold less."""
    (found,) = [one for one in WIRES if one.name == wire]
    told: list[str] = []
    for body in bodies:
        told += found.results(body)[len(told) :]
    return told


def play(client: str, case_id: str, uses: Sequence[Use], folder: Path) -> tuple[list[dict[str, Any]], list[str]]:
    """One attempt of one client that makes these calls, one a turn: the calls on record, and the model's results."""
    suite = SuiteFolder(built_suite())
    case = suite.agent_case(suite.case(case_id).alias)
    with ScriptedEndpoint([[use] for use in uses], "Done.") as endpoint, endpoints(endpoint.url):
        configuration = Configuration(
            name=client,
            client=client,
            model=MODELS.get(client, "scripted-1"),
            options={**stand_in(client), "endpoint": "scripted"},
        )
        packs = [packs_root() / pack.pack_id for pack in case.packs]
        run_attempt(case, suite.agent(case.alias), configuration, 1, folder, packs, None)
        wire = next(one.wire for one in endpoint.served if one.tools)
        bodies = [body for body, one in zip(endpoint.bodies, endpoint.served, strict=True) if one.tools]
    with (folder / "trajectory.jsonl").open() as lines:
        return [line for line in json_lines(lines) if line["event"] == "call"], results_in(bodies, wire)


def drive(client: str, case_id: str, folder: Path) -> dict[str, Received]:
    """What one client's model received of each answer, by its title."""
    suite = SuiteFolder(built_suite())
    asked = answers(suite.agent_case(suite.case(case_id).alias).catalog)
    calls, told = play(client, case_id, [answer.use for answer in asked], folder)
    return {
        answer.title: compared(call["result"], call["result_characters"], told[number] if number < len(told) else None)
        for number, (answer, call) in enumerate(zip(asked, calls, strict=False))
    }


def main() -> int:
    """Print the table."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--case", default=CASE)
    parser.add_argument("clients", nargs="*", default=CLIENTS)
    chosen = parser.parse_args()
    found: dict[str, dict[str, Received]] = {}
    with tempfile.TemporaryDirectory(dir=home()) as root:
        for client in chosen.clients:
            try:
                found[client] = drive(client, chosen.case, Path(root) / client / "attempt-1")
            except C4SError as error:
                print(f"{client}: {error.line()}", flush=True)
    titles = list(dict.fromkeys(title for row in found.values() for title in row))
    print(f"| answer | {' | '.join(found)} |\n|{'---|' * (len(found) + 1)}")
    for title in titles:
        print(f"| {title} | {' | '.join(row[title].cell() if title in row else '' for row in found.values())} |")
    may_be_cut = {answer.title for answer in answers([]) if answer.asked}
    return int(
        any(one.how != "whole" for row in found.values() for title, one in row.items() if title not in may_be_cut)
    )


if __name__ == "__main__":
    sys.exit(main())
