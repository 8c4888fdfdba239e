"""What the tools do on shipped cases, as the model of each client is told it: a table of statements x clients.

``python tests/agent_clients/behaviour.py [CLIENT ...]`` lets a scripted model call tools on three cases of the starter
suite through every installed client, and holds what its next requests say to what must be told. Exit 1 where one does
not hold. ``matrix.py --install`` installs the clients.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parent))
from matrix import CLIENTS
from received import json_in, play, texts
from scripted_endpoint import Use

from c4s.errors import C4SError
from c4s.home import home

Told = dict[str, Any]
FARM, FLAT, REPAIR = "text-small-farm", "text-flat-family", "outdoor-harbour-cafe"
PLATE = {"location": [0, 0, 0]}
BY_CLIENT = "must not have additional properties"
"""What Gemini CLI says of an argument that no schema has: it looks at them itself, and the gateway hears nothing."""
ENDLESS = {"script": "while True:\n    pass"}


@dataclass(frozen=True)
class Statement:
    """Calls, and what the model must have been told by the last of them: its answer, or its error."""

    case: str
    says: str
    uses: Sequence[Use]
    holds: Callable[[Told], bool]


def said(told: Told) -> str:
    return str(told.get("error", told)).casefold()


def first(told: Told) -> str:
    return str(told["result"]["assets"][0]["id"])


def search(query: str) -> list[Use]:
    return [Use("search_assets", {"query": query, "k": 5})]


def ground(text: str, half_extent_m: int) -> list[Use]:
    """A ground, and what then stands in the level."""
    return [
        Use("ground_pass", {"scene_text": text, "half_extent_m": half_extent_m}),
        Use("get_actors_in_level", {"limit": 30}),
    ]


def of_job(number: int, **arguments: Any) -> Use:
    """A look at a job, by its place among those that were started."""

    def made(results: list[str]) -> Told:
        answers = [answer_in(result).get("result", {}) for result in results]
        started = [answer["job_id"] for answer in answers if "log_path" in answer]
        return {"job_id": list(dict.fromkeys(started))[number], **arguments}

    return Use("read_job_log", made)


STATEMENTS = [
    Statement(FARM, "swine is the pig", search("swine"), lambda told: first(told) == "pig"),
    Statement(FARM, "barn is the barn", search("barn"), lambda told: first(told) == "barn"),
    Statement(
        FARM,
        "the ground of a farm is no pond",
        ground("a small farm with a barn, a yard and animals", 20),
        lambda told: told["result"]["total"] > 0 and "pond" not in said(told),
    ),
    Statement(
        FARM,
        "a wrong argument's name is put right",
        [Use("spawn_actor", {"name": "A", "static_mesh": "barn", "rotaton": [0, 0, 0], **PLATE})],
        lambda told: "mean 'rotation'" in said(told) or BY_CLIENT in said(told),
    ),
    Statement(
        FARM,
        "scale 0 is refused",
        [Use("spawn_actor", {"name": "B", "static_mesh": "barn", "scale": 0, **PLATE})],
        lambda told: "scale" in said(told) and "result" not in told,
    ),
    Statement(
        FARM,
        "a later time of day is done or refused",
        [Use("setup_environment", {"time_of_day": "noon"}), Use("setup_environment", {"time_of_day": "sunset"})],
        lambda told: "sun" in said(told),
    ),
    Statement(
        FLAT,
        "the ground of a flat is no rug",
        ground("a family flat with a kitchen and a bath", 8),
        lambda told: "result" in told and "rug" not in said(told),
    ),
    Statement(
        FLAT,
        "a Blueprint is found",
        search("dining set, a table with chairs"),
        lambda told: "dining_set_bp" in said(told),
    ),
    Statement(
        FLAT,
        "a Blueprint is placed",
        [Use("spawn_blueprint_actor", {"actor_name": "Set", "blueprint_id": "dining_set_bp", **PLATE})],
        lambda told: told["result"]["actor"]["label"] == "Set",
    ),
    Statement(
        REPAIR, "a repair's environment stays", [Use("setup_environment")], lambda told: told["result"]["added"] == []
    ),
    Statement(
        REPAIR,
        "nothing that stood so floats",
        [Use("measure_scene")],
        lambda told: told["result"]["floating"] == [] and told["result"]["changed_or_added"] == 0,
    ),
    Statement(
        REPAIR,
        "a script behind another is queued",
        [Use("execute_python_script", ENDLESS), Use("execute_python_script", {"script": "print('second')"})],
        lambda told: told["result"]["status"] == "queued",
    ),
    Statement(
        REPAIR,
        "jobs are listed",
        [Use("read_job_log", {"action": "list"})],
        lambda told: told["result"]["running_or_queued"] == 2,
    ),
    Statement(
        REPAIR,
        "an endless script is cancelled",
        [of_job(0, action="cancel"), of_job(0, wait_s=30)],
        lambda told: told["result"]["status"] not in ("running", "queued"),
    ),
    Statement(
        REPAIR,
        "what waited behind it is done",
        [of_job(1, wait_s=30)],
        lambda told: told["result"]["status"] == "done" and told["result"]["output"] == "second",
    ),
]


def answer_in(received: str) -> Told:
    """The gateway's answer in a tool result, whatever the client put around it; without one the text as an error."""
    for text in texts(received):
        for value in json_in(text):
            if isinstance(value, dict) and "budget" in value:
                return value
    return {"error": received}


def drive(client: str, folder: Path) -> dict[str, str]:
    """One attempt a case: what holds, by statement."""
    found = {}
    for case in dict.fromkeys(statement.case for statement in STATEMENTS):
        of_case = [statement for statement in STATEMENTS if statement.case == case]
        _, told = play(client, case, [use for one in of_case for use in one.uses], folder / case / "attempt-1")
        end = 0
        for statement in of_case:
            end += len(statement.uses)
            found[statement.says] = _cell(statement, told[end - 1]) if end <= len(told) else "no answer"
    return found


def _cell(statement: Statement, received: str) -> str:
    told = answer_in(received)
    try:
        holds = statement.holds(told)
    except (KeyError, IndexError, TypeError):
        holds = False
    return "yes" if holds else f"NO: {' '.join(str(told).split())[:160]}"


def main() -> int:
    """Print the table."""
    parser = argparse.ArgumentParser()
    parser.add_argument("clients", nargs="*", default=CLIENTS)
    chosen = parser.parse_args()
    found: dict[str, dict[str, str]] = {}
    with tempfile.TemporaryDirectory(dir=home()) as root:
        for client in chosen.clients:
            try:
                found[client] = drive(client, Path(root) / client)
            except C4SError as error:
                print(f"{client}: {error.line()}", flush=True)
    print(f"| statement | {' | '.join(found)} |\n|{'---|' * (len(found) + 1)}")
    for statement in STATEMENTS:
        print(f"| {statement.says} | {' | '.join(row[statement.says] for row in found.values())} |")
    return int(any(cell != "yes" for row in found.values() for cell in row.values()))


if __name__ == "__main__":
    sys.exit(main())
