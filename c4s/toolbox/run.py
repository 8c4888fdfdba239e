"""One run behind the gateway: its tool set, budgets, trajectory, and the execution of its calls.

A call counts when it starts, failed or not. Calls that are refused before they start (a tool off the list, a spent
budget, an ended run) and repeats of a request id do not count. Every one of them is a line of ``trajectory.jsonl``.
"""

from __future__ import annotations

import asyncio
import json
import secrets
import threading
import time
import weakref
from collections import deque
from collections.abc import Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from pathlib import Path
from typing import Any, BinaryIO, Literal

from c4s.case.package import Budget
from c4s.errors import C4SError
from c4s.files import canonical_json, digest_bytes, write_bytes
from c4s.toolbox.registry import TOOLS, VALIDATORS, tool_set
from c4s.toolbox.tool import ToolRefused, ToolResult
from c4s.toolbox.workbench import Workbench

EndReason = Literal["finished", "wall_budget", "killed", "fault"]
KEPT_ANSWERS = 32
"""Answers kept for repeats of a request id; older repeats are refused, never run again."""
RECORDED_RESULT_CHARACTERS = 20_000
PARALLEL_CALLS = 8
POLL_S = 0.05
POLLING = "read_job_log"
"""The tool that asks for the state of a job; its calls count, and are told apart."""


class Answer:
    """What goes back to the client: one JSON text and at most one PNG."""

    def __init__(self, payload: dict[str, Any], *, error: bool, image: bytes | None = None) -> None:
        self.text = json.dumps(payload, ensure_ascii=False, allow_nan=False)
        self.error, self.image = error, image


class Run:
    """A run of an agent. Thread-safe where it says so; the rest belongs to the gateway's event loop."""

    def __init__(self, run_id: str, bench: Workbench, budget: Budget, trajectory: Path,
                 tools: Iterable[str] | None = None) -> None:
        self.run_id, self.bench, self.budget, self.trajectory = run_id, bench, budget, trajectory
        self.tools = tool_set(tools)
        self.token = secrets.token_urlsafe(32)
        self.calls = 0
        self.polls = 0
        """How many of the calls asked for the state of a job."""
        self.blocked = 0
        self.over_calls = False
        """Whether a call was refused because the call budget was spent."""
        self.end_reason: EndReason | None = None
        self.end_message = ""
        self.fault: BaseException | None = None
        self.ended = threading.Event()
        self._started: float | None = None
        self._stopped: float | None = None
        self._records = 0
        self._lines: BinaryIO | None = None
        self._answers: dict[str, asyncio.Task[Answer] | None] = {}
        self._kept: deque[str] = deque()
        self._loop: asyncio.AbstractEventLoop | None = None
        self._timer: asyncio.TimerHandle | None = None
        self._waiting: set[asyncio.Future[ToolResult | None]] = set()
        """The tools at work."""
        self._pool = ThreadPoolExecutor(PARALLEL_CALLS, thread_name_prefix=f"tools-{run_id}")

    def start(self, loop: asyncio.AbstractEventLoop) -> None:
        """Start the clock of the wall budget. Thread-safe."""
        self._loop = loop
        self._started = time.monotonic()

        def arm() -> None:
            self._timer = loop.call_later(self.budget.wall_minutes * 60, self._end, "wall_budget",
                                          "the time budget is spent")
        loop.call_soon_threadsafe(arm)

    def end(self, reason: EndReason, message: str) -> None:
        """End the run from the server's side: calls in flight are answered with an error, later ones refused.

        Thread-safe; the first reason stays.
        """
        assert self._loop is not None, "the run has not started"
        self._loop.call_soon_threadsafe(self._end, reason, message)
        self.ended.wait()

    def _end(self, reason: EndReason, message: str) -> None:
        if self.end_reason is None:
            self.end_reason, self.end_message = reason, message
            self._stopped = time.monotonic()
            for waiting in self._waiting:
                _settle(waiting, None)
            if self._timer is not None:
                self._timer.cancel()
            self._pool.shutdown(wait=False, cancel_futures=True)
        self.ended.set()

    def ended_or(self, done: threading.Event) -> None:
        """Wait until the run has ended or ``done`` is set by another thread."""
        while not self.ended.is_set() and not done.wait(POLL_S):
            continue

    @property
    def wall_s(self) -> float:
        """Seconds since the start, up to the end of the run."""
        if self._started is None:
            return 0.0
        return (self._stopped or time.monotonic()) - self._started

    def left(self) -> dict[str, Any]:
        """The budget left, as every result tells it."""
        return {"tool_calls_left": max(0, self.budget.tool_calls - self.calls),
                "seconds_left": max(0, round(self.budget.wall_minutes * 60 - self.wall_s))}

    async def call(self, name: str, arguments: Mapping[str, Any], key: str | None) -> Answer:
        """Answer one call. A request id that was seen before gets the first answer again."""
        arguments, told, problem = _plain_arguments(arguments)
        if key is None:
            return await self._serve(name, arguments, problem, None)
        key = f"{key} {name} {digest_bytes(told)}"
        if key in self._answers:
            self.record_duplicate(name, key)
            task = self._answers[key]
            if task is None:
                return self._refusal("this request id was already answered")
            return await asyncio.shield(task)
        task = self._answers[key] = asyncio.ensure_future(self._serve(name, arguments, problem, key))
        task.add_done_callback(lambda _: self._keep_answer(key))
        return await asyncio.shield(task)

    def record_duplicate(self, name: str, key: str) -> None:
        """Note a repeat of a request id."""
        self._record("duplicate", name, key, counted=False, outcome="duplicate")

    def _keep_answer(self, key: str) -> None:
        """Keep a finished answer for repeats, and let go of the oldest one above ``KEPT_ANSWERS``."""
        self._kept.append(key)
        if len(self._kept) > KEPT_ANSWERS:
            self._answers[self._kept.popleft()] = None

    async def _serve(self, name: str, arguments: dict[str, Any], problem: str, key: str | None) -> Answer:
        if self.end_reason is not None:
            return self._refuse(name, arguments, key, f"the run has ended: {self.end_message}", stop=True)
        if self._started is None:
            return self._refuse(name, arguments, key, "the run has not started")
        if name not in self.tools:
            self.blocked += 1
            return self._refuse(name, arguments, key, f"there is no tool {name!r} in this run; the tools are "
                                + ", ".join(tool for tool in TOOLS if tool in self.tools))
        if self.calls >= self.budget.tool_calls:
            self.over_calls = True
            return self._refuse(name, arguments, key, "the tool call budget is spent", stop=True)
        self.calls += 1
        self.polls += name == POLLING
        started, clock = self.wall_s, time.perf_counter()
        number = self.calls
        result, error, outcome = None, problem or _schema_problem(name, arguments), "error"
        if not error:
            result, error, outcome = await self._work(name, arguments)
        image = result.image if result is not None else None
        stop = {"stop": self.end_message} if outcome == "ended" else {}
        try:
            answer = Answer({"result": result.data, "budget": self.left()} if result is not None
                            else {"error": error, "budget": self.left(), **stop}, error=result is None, image=image)
        except ValueError:
            outcome, error, image = "error", "the scene holds numbers that are not finite: mend those actors", None
            answer = self._refusal(error)
        if image is not None:
            self._keep(image)
        self._record("call", name, key, counted=True, polling=name == POLLING, outcome=outcome, call=number,
                     arguments=arguments, start_s=round(started, 4),
                     duration_s=round(time.perf_counter() - clock, 4), error=error,
                     result=answer.text[:RECORDED_RESULT_CHARACTERS], result_characters=len(answer.text),
                     images=[] if image is None else [{"sha256": digest_bytes(image), "bytes": len(image)}])
        return answer

    async def _work(self, name: str, arguments: dict[str, Any]) -> tuple[ToolResult | None, str, str]:
        """Run the tool in a thread until it is done or the run ends: (result, error, outcome)."""
        loop = asyncio.get_running_loop()
        done: asyncio.Future[ToolResult | None] = loop.create_future()
        """Holds what the tool gave or raised; None when the run has ended before."""

        def work() -> None:
            try:
                result: ToolResult | BaseException = TOOLS[name].run(self.bench, arguments)
            except BaseException as error:
                result = error
            with suppress(RuntimeError):  # the gateway's loop is closed: nobody waits
                loop.call_soon_threadsafe(_settle, done, result)

        self._waiting.add(done)
        try:
            self._pool.submit(work)
            result = await done
            if result is None:
                return None, f"the run has ended: {self.end_message}", "ended"
            return result, "", "ok"
        except ToolRefused as refusal:
            return None, refusal.line(), "error"
        except Exception as fault:
            self.fault = fault
            line = fault.line() if isinstance(fault, C4SError) else f"{type(fault).__name__}: {fault}"
            self._end("fault", "the engine or a tool failed")
            return None, line, "fault"
        finally:
            self._waiting.discard(done)

    def _refuse(self, name: str, arguments: dict[str, Any], key: str | None, error: str, *, stop: bool = False
                ) -> Answer:
        self._record("refused", name, key, counted=False, outcome="refused", arguments=arguments, error=error)
        return self._refusal(error, stop=stop)

    def _refusal(self, error: str, *, stop: bool = False) -> Answer:
        return Answer({"error": error, "budget": self.left(), **({"stop": error} if stop else {})}, error=True)

    def _keep(self, image: bytes) -> None:
        """Keep a picture beside the trajectory, which names it by its digest."""
        path = self.trajectory.parent / "images" / f"{digest_bytes(image)}.png"
        if not path.is_file():
            write_bytes(path, image)

    def _record(self, event: str, name: str, key: str | None, **more: Any) -> None:
        self._records += 1
        line = canonical_json({"seq": self._records, "time": round(time.time(), 4), "event": event, "tool": name,
                               "request": key, **more, **self.left()})
        self._file().write(line.encode() + b"\n")

    def _file(self) -> BinaryIO:
        """The trajectory, open for appending without a buffer: a line is in the file when it is written."""
        if self._lines is None:
            self.trajectory.parent.mkdir(parents=True, exist_ok=True)
            self._lines = self.trajectory.open("ab", buffering=0)
            weakref.finalize(self, self._lines.close)
        return self._lines


def _settle(done: asyncio.Future[ToolResult | None], result: ToolResult | BaseException | None) -> None:
    """Give a future its result or error, unless it has one."""
    if done.done():
        return
    if isinstance(result, BaseException):
        done.set_exception(result)
    else:
        done.set_result(result)


def _plain_arguments(arguments: Mapping[str, Any]) -> tuple[dict[str, Any], bytes, str]:
    """The arguments that can be written down, as JSON, and what is wrong with them (a number that is none)."""
    plain = dict(arguments)
    try:
        return plain, canonical_json(plain).encode(), ""
    except ValueError as error:
        shown = repr(plain)[:1000].encode("ascii", "backslashreplace").decode()
        return {"unusable": shown}, shown.encode(), f"invalid arguments: {error}"


def _schema_problem(name: str, arguments: dict[str, Any]) -> str:
    """The first way in which arguments break the tool's schema, in one line; empty when they do not."""
    errors = sorted(VALIDATORS[name].iter_errors(arguments), key=lambda error: list(map(str, error.absolute_path)))
    if not errors:
        return ""
    where = ".".join(map(str, errors[0].absolute_path))[:200]
    tool = TOOLS[name]
    takes = ", ".join(f"{key}*" if key in tool.required else key for key in tool.properties) or "no arguments"
    return (f"invalid arguments{f' in {where}' if where else ''}: {errors[0].message[:500]} "
            f"({name} takes {takes}; * must be given)")
