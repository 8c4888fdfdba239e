"""The gateway under load, and what it adds to a call: ``python -m bench gateway``; as JSON ``python -m bench.gateway``.

*Load*: 32 runs at once, each with a real MCP client of its own that makes calls that succeed, fail, break the schema,
are off the run's list, and repeat or overlap request ids. What was sent is compared with what each run counted and
recorded.

*Overhead*: one client each of the gateway and of a bare server (same SDK, transport and answers, trivial tools, no
record), called in turn; the difference of the medians, and of the fastest tenths, which other work on the machine
disturbs less. Two tools: one that both answer at once, and one that both run in a thread, as a tool that waits for an
engine must be. Both servers are in one process of their own, as clients are elsewhere in a real run. The tools need no
engine, so there is none.
"""

from __future__ import annotations

import asyncio
import json
import multiprocessing
import socket
import tempfile
import threading
import time
from collections import Counter
from collections.abc import Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, contextmanager, suppress
from itertools import product
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import mcp_types as wire
import uvicorn
from anyio import to_thread
from mcp.server.lowlevel import Server

from bench.row import Row
from c4s.files import json_lines
from c4s.protocol.settings import TEXT_TO_SCENE
from c4s.records.folder import AttemptFolder
from c4s.records.suite import AgentCase, Budget
from c4s.toolbox.catalog import CaseCatalog
from c4s.toolbox.client import GatewayClient
from c4s.toolbox.gateway import Endpoint, Gateway
from c4s.toolbox.gateway_run import Run
from c4s.toolbox.size import MAX_BODY_BYTES
from c4s.toolbox.workbench import Workbench

RUNS = 32
ROUNDS = 6
CALLS, WARM = 400, 30
GOAL_MS = 1.0
TOOL = "get_categories"
OFFERED = (TOOL, "get_asset_metadata", "search_assets", "validate_scene_graph")
MEASURED: dict[str, tuple[str, dict[str, Any]]] = {
    "": (TOOL, {}),
    "thread_": ("validate_scene_graph", {"graph": {"nodes": []}}),
}
"""What is measured: a tool that both servers answer at once, and one that both run in a thread, as tools that wait for
an engine must be. By the beginning of the figures' names."""


class _NoEngine:
    """Stands where an engine would; the tools of this benchmark ask for nothing but the actors of an empty level."""

    def request(self, kind: str, params: Any = None, timeout_s: float = 60.0) -> dict[str, Any]:
        raise ValueError(f"no tool of this benchmark asks an engine for {kind}")

    def call(self, function: str, /, *, timeout_s: float = 60.0, **params: Any) -> Any:
        if function != "scene_tools.actor_ids":
            raise ValueError(f"no tool of this benchmark asks an engine for {function}")
        return []


def new_run(name: str, folder: Path, calls: int = 100_000) -> Run:
    """A run on an empty case."""
    case = AgentCase.parse(
        {
            "alias": name,
            "setting": TEXT_TO_SCENE,
            "prompt": "-",
            "start_map": "/Game/B/M",
            "packs": [],
            "catalog": [],
            "budget": Budget(tool_calls=calls, wall_minutes=60).plain(),
        }
    )
    bench = Workbench(case, folder, CaseCatalog([]), _NoEngine(), folder)
    return Run(name, bench, case.budget, AttemptFolder(folder / name).trajectory, OFFERED)


def one_client(endpoint: Endpoint) -> dict[str, int]:
    """The calls of one run; tells how many posts of which sort were sent."""
    with GatewayClient(endpoint) as client, ThreadPoolExecutor(2) as both:
        for number in range(ROUNDS):
            client.answer(TOOL, {}, call_id=f"a{number}")
            client.answer(TOOL, {}, call_id=f"a{number}")
            list(both.map(lambda _, n=number: client.answer(TOOL, {}, call_id=f"b{n}"), range(2)))
            client.answer("get_asset_metadata", {"ids": ["nothing"]}, call_id=f"c{number}")
            client.answer("search_assets", {"k": number}, call_id=f"d{number}")
            client.answer("delete_actor", {"name": "x"}, call_id=f"e{number}")
    return {"ok": 2 * ROUNDS, "error": 2 * ROUNDS, "duplicate": 2 * ROUNDS, "refused": ROUNDS}


def load(folder: Path, runs: int = RUNS) -> dict[str, Any]:
    """All runs at once; ``exact`` says that every run counted and recorded just what its client sent."""
    with Gateway() as gateway, ThreadPoolExecutor(runs) as pool:
        opened = [new_run(f"load-{number}", folder) for number in range(runs)]
        endpoints = [gateway.open_run(run) for run in opened]
        began = time.perf_counter()
        sent = list(pool.map(one_client, endpoints))
        took = time.perf_counter() - began
    wrong = []
    for run, expected in zip(opened, sent, strict=True):
        with run.trajectory.open() as lines:
            recorded = list(json_lines(lines))
        counts = Counter(line["outcome"] for line in recorded if line["event"] != "started")
        begun = sorted(line["call"] for line in recorded if line["event"] == "started")
        numbers = sorted(line["call"] for line in recorded if line["event"] == "call")
        counted = expected["ok"] + expected["error"]
        if (
            dict(counts) != expected
            or run.calls != counted
            or not begun == numbers == list(range(1, counted + 1))
            or sum(line["counted"] for line in recorded) != counted
            or [line["seq"] for line in recorded] != list(range(1, len(recorded) + 1))
        ):
            wrong.append({"run": run.run_id, "sent": expected, "recorded": dict(counts), "counted": run.calls})
    posts = sum(sum(one.values()) for one in sent)
    return {
        "runs": runs,
        "posts": posts,
        "counted": sum(run.calls for run in opened),
        "exact": not wrong,
        "wrong": wrong,
        "seconds": round(took, 3),
        "posts_per_second": round(posts / took),
    }


@contextmanager
def bare_server(texts: Mapping[str, str]) -> Iterator[Endpoint]:
    """A server of the SDK with a tool a text that gives it, and nothing around them; all but ``TOOL`` in a thread."""

    async def list_tools(_: Any, __: Any) -> wire.ListToolsResult:
        return wire.ListToolsResult(tools=[wire.Tool(name=name, input_schema={"type": "object"}) for name in texts])

    async def call_tool(_: Any, params: wire.CallToolRequestParams) -> wire.CallToolResult:
        name = params.name
        text = texts[name] if name == TOOL else await to_thread.run_sync(texts.__getitem__, name)
        return wire.CallToolResult(content=[wire.TextContent(type="text", text=text)])

    server: Server[Any] = Server("bare", version="1", on_list_tools=list_tools, on_call_tool=call_tool)
    app = server.streamable_http_app(host="127.0.0.1", max_request_body_size=MAX_BODY_BYTES, session_idle_timeout=None)
    listener = socket.socket()
    listener.bind(("127.0.0.1", 0))
    http = uvicorn.Server(
        uvicorn.Config(app, log_level="error", lifespan="on", access_log=False, timeout_graceful_shutdown=1)
    )
    thread = threading.Thread(target=lambda: asyncio.run(http.serve([listener])), daemon=True)
    thread.start()
    try:
        yield Endpoint(f"http://127.0.0.1:{listener.getsockname()[1]}/mcp", "none")
    finally:
        http.should_exit = True
        thread.join()


def _text(answer: wire.CallToolResult) -> str:
    return next(block.text for block in answer.content if isinstance(block, wire.TextContent))


def _serve_both(folder: Path, line: Connection) -> None:
    """Both servers in this process until the other end of the line is closed."""
    with Gateway() as gateway:
        endpoint = gateway.open_run(new_run("one", folder))
        with GatewayClient(endpoint) as client:
            texts = {name: _text(client.answer(name, arguments)) for name, arguments in MEASURED.values()}
        with bare_server(texts) as bare:
            line.send({"gateway": (endpoint.url, endpoint.token), "bare": (bare.url, bare.token)})
            with suppress(EOFError):
                line.recv()


def overhead(folder: Path, calls: int = CALLS) -> dict[str, Any]:
    """Medians in milliseconds of a call through the gateway and to a bare server, in turn."""
    took: dict[tuple[str, str], list[float]] = {}
    spawn = multiprocessing.get_context("spawn")
    ours, theirs = spawn.Pipe()
    process = spawn.Process(target=_serve_both, args=(folder, theirs), daemon=True)
    process.start()
    theirs.close()
    with ExitStack() as stack:
        clients = {name: stack.enter_context(GatewayClient(Endpoint(*place))) for name, place in ours.recv().items()}
        for number in range(calls + WARM):  # each second time the other way round: no place in the turn is better
            turn = list(product(MEASURED.items(), clients.items()))
            for (kind, call), (name, client) in turn if number % 2 else reversed(turn):
                began = time.perf_counter()
                client.answer(*call)
                if number >= WARM:
                    took.setdefault((kind, name), []).append(1000 * (time.perf_counter() - began))
    ours.close()
    process.join()
    told: dict[str, Any] = {"calls": calls}
    for kind, (name, part) in product(MEASURED, (("", 0.5), ("quiet_", 0.1))):
        gateway, bare = (sorted(took[kind, server])[int(part * calls)] for server in clients)
        told |= {
            f"{kind}{name}gateway_ms": round(gateway, 3),
            f"{kind}{name}bare_ms": round(bare, 3),
            f"{kind}{name}added_ms": round(gateway - bare, 3),
        }
    return told


def rows() -> list[Row]:
    """Exact counts under load, and the median that the gateway adds."""
    with tempfile.TemporaryDirectory(prefix="c4s-gateway-") as root:
        under, added = load(Path(root) / "load"), overhead(Path(root) / "one")
    return [
        Row(
            f"gateway: {under['runs']} runs at once, {under['posts']} posts, {under['counted']} calls counted "
            f"({'exact' if under['exact'] else 'WRONG'})",
            under["seconds"],
            "every count exact",
            under["exact"],
        ),
        *(
            Row(
                f"gateway: one tool call{what}, median of {added['calls']} (adds {added[f'{kind}added_ms']} ms)",
                added[f"{kind}gateway_ms"],
                f"at most +{GOAL_MS:g} ms",
                added[f"{kind}added_ms"] <= GOAL_MS,
                "ms",
                f"bare MCP server{what}",
                added[f"{kind}bare_ms"],
                round(added[f"{kind}bare_ms"] / added[f"{kind}gateway_ms"], 3),
            )
            for kind, what in (("", ""), ("thread_", ", tool in a thread"))
        ),
    ]


if __name__ == "__main__":
    with tempfile.TemporaryDirectory(prefix="c4s-gateway-") as at:
        print(json.dumps({"load": load(Path(at) / "load"), "overhead": overhead(Path(at) / "one")}, indent=1))
