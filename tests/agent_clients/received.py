"""What each client's model receives of the largest answers of the tools: whole, cut, or something else in their place.

``python tests/agent_clients/received.py [--case CASE] [CLIENT ...]`` lets a scripted model call the tools whose answers
are longest, on the largest start level of the starter suite, through every installed client. It prints a table answer x
client with the characters that the gateway sent and, where the next request of the client held other text, the
characters that its model received. Exit 1 where one was not whole. ``matrix.py --install`` installs the clients.
"""

from __future__ import annotations

import argparse
import json
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


def answers(catalog: Sequence[str]) -> list[Answer]:
    """The calls, in the order in which they are made."""
    nodes = [
        {"id": f"n{number}", "asset": path, "at": [8 * (number % 20) - 80, 8 * (number // 20) - 40], "count": 2}
        for number, path in enumerate(2 * [path for path in catalog if not path.endswith("_C")])
    ]
    return [
        Answer("get_actors_in_level", Use("get_actors_in_level")),
        Answer("get_actors_in_level, most", Use("get_actors_in_level", {"limit": 1000})),
        Answer("find_actors_by_name *", Use("find_actors_by_name", {"pattern": "*", "limit": 1000})),
        Answer("search_assets, 100", Use("search_assets", {"query": "house boat stall barrel tree wall", "k": 100})),
        Answer("get_asset_metadata, all", Use("get_asset_metadata", {"ids": list(catalog)[:200]})),
        Answer("a script's output", Use("execute_python_script", {"script": PRINT % 330, "execution_mode": "sync"})),
        Answer("a script's output, wide", Use("execute_python_script", {"script": WIDE, "execution_mode": "sync"})),
        Answer("read_job_log, most", Use("read_job_log", {"max_bytes": 200_000, "wait_s": 30})),
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
    """``whole``, ``cut`` (its beginning is there), ``replaced``, ``nothing``, or ``too long`` to be on record."""

    def cell(self) -> str:
        """It, for the table."""
        return f"{self.sent}" if self.how == "whole" else f"{self.sent} > {self.received} {self.how}"


def compared(sent: str, length: int, received: str | None) -> Received:
    """How an answer of ``length`` characters, recorded as ``sent``, compares with a tool result of a request."""
    if received is None:
        return Received(length, 0, "nothing")
    found = list(_texts(received))
    shapes = [sent, *(json.dumps(sent, ensure_ascii=ascii)[1:-1] for ascii in (False, True))]
    if len(sent) < length:
        return Received(length, len(max(found, key=len)), "too long")
    if any(shape in text for shape in shapes for text in found):
        return Received(length, length, "whole")
    began = any(shape[:BEGINNING] in text for shape in shapes for text in found)
    return Received(length, len(max(found, key=len)), "cut" if began else "replaced")


def _texts(received: str) -> Iterator[str]:
    """A tool result, and the texts in it where it is JSON. Clients wrap answers in JSON of their own, and in words."""
    yield received
    try:
        inside = [json.loads(received)]
    except ValueError:
        return
    while inside:
        value = inside.pop()
        if isinstance(value, str):
            yield value
        elif isinstance(value, dict):
            inside += value.values()
        elif isinstance(value, list):
            inside += value


def results_in(bodies: Sequence[dict[str, Any]], wire: str) -> list[str]:
    """Each tool result as the first request that held it: later requests may hold less."""
    (found,) = [one for one in WIRES if one.name == wire]
    told: list[str] = []
    for body in bodies:
        told += found.results(body)[len(told) :]
    return told


def drive(client: str, case_id: str, folder: Path) -> dict[str, Received]:
    """One attempt of one client; each answer by its title."""
    suite = SuiteFolder(built_suite())
    case = suite.agent_case(suite.case(case_id).alias)
    asked = answers(case.catalog)
    with ScriptedEndpoint([[answer.use] for answer in asked], "Done.") as endpoint, endpoints(endpoint.url):
        configuration = Configuration(
            name=client,
            client=client,
            model=MODELS.get(client, "scripted-1"),
            options={**stand_in(client), "endpoint": "scripted"},
        )
        run_attempt(
            case,
            suite.agent(case.alias),
            configuration,
            1,
            folder,
            [packs_root() / pack.pack_id for pack in case.packs],
            None,
        )
        wire = next(one.wire for one in endpoint.served if one.tools)
        told = results_in([body for body, one in zip(endpoint.bodies, endpoint.served, strict=True) if one.tools], wire)
    with (folder / "trajectory.jsonl").open() as lines:
        calls = [line for line in json_lines(lines) if line["event"] == "call"]
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
    return int(any(one.how != "whole" for row in found.values() for one in row.values()))


if __name__ == "__main__":
    sys.exit(main())
