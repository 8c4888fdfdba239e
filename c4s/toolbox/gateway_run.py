"""One run behind the gateway: its tool set, budgets, trajectory, and the execution of its calls.

A call counts when it starts, failed or not. Calls that are refused before they start (a tool off the list, a spent
budget, an ended run) and repeats of a request id do not count. Every one of them is a line of ``trajectory.jsonl``; a
call that counts has two, one before its tool runs and one before its answer goes out, so that one which a killed
process left behind is on record as unfinished.
"""

from __future__ import annotations

import asyncio
import secrets
import threading
import time
from collections import deque
from collections.abc import Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import orjson

from c4s.errors import C4SError, MachineryFault
from c4s.files import digest_bytes
from c4s.records.suite import Budget
from c4s.toolbox.arguments import plain, schema_problem
from c4s.toolbox.record import RunRecord, short
from c4s.toolbox.refusal import ToolRefused
from c4s.toolbox.registry import TOOLS, tool_set
from c4s.toolbox.size import ANSWER_SIZE, ERROR_SIZE, clipped, held, json_text, size, whole
from c4s.toolbox.workbench import Workbench

EndReason = Literal["finished", "wall_budget", "killed", "fault"]
Outcome = Literal["ok", "error", "ended", "fault"]
KEPT_ANSWERS = 32
"""Answers kept for repeats of a request id; older repeats are refused, never run again."""
RECORDED_RESULT_CHARACTERS = ANSWER_SIZE
RECORDED_REFUSED_BYTES = 20_000
"""Longest arguments of a refused call that are recorded."""
_BUDGET_SIZE = 120
"""Room in an answer for the budget and what holds both."""
UNCOUNTED_CALLS = 10_000
"""Refused calls and repeats that a run may send: each is a line of its record, and more of them end it."""
PARALLEL_CALLS = 8
POLL_S = 0.05
POLLING = "read_job_log"
"""The tool that asks for the state of a job; its calls count, and are told apart."""


@dataclass(frozen=True, slots=True)
class CallAnswer:
    """What goes back to the client: one JSON text and at most one PNG."""

    text: str
    error: bool
    image: bytes | None = None


@dataclass(frozen=True, slots=True)
class _Given:
    """What a tool gave: its data as JSON, its picture, and how the trajectory names that."""

    text: str
    whole_size: int
    """Bytes of the data before it was held to the bound of an answer."""
    image: bytes | None
    images: list[dict[str, Any]]


@dataclass(eq=False, slots=True)
class _Call:
    """A call that counts, until it is answered."""

    number: int
    name: str
    arguments: dict[str, Any]
    told: bytes
    """The arguments as JSON."""
    key: str | None
    start_s: float
    clock: float
    answered: asyncio.Future[CallAnswer]

    def fields(self) -> dict[str, Any]:
        """What both of its lines tell."""
        return {
            "tool": self.name,
            "request": self.key,
            "call": self.number,
            "polling": self.name == POLLING,
            "arguments": orjson.Fragment(self.told),
            "start_s": round(self.start_s, 4),
        }


@dataclass(frozen=True, slots=True)
class AskedCall:
    """A call that a client asked for."""

    what: str
    """Tool and digest of the arguments, by which a repeat over a new connection is known; empty where it is known by
    an id of the client's own."""
    answered: asyncio.Future[CallAnswer]


class Run:
    """A run of an agent. Thread-safe where it says so; the rest belongs to the gateway's event loop."""

    def __init__(
        self, run_id: str, bench: Workbench, budget: Budget, trajectory: Path, tools: Iterable[str] | None = None
    ) -> None:
        self.run_id, self.bench, self.budget, self.trajectory = run_id, bench, budget, trajectory
        self.tools = tool_set(tools)
        self.token = secrets.token_urlsafe(32)
        self.calls = 0
        self.polls = 0
        """How many of the calls asked for the state of a job."""
        self.blocked = 0
        self._uncounted = 0
        self.over_calls = False
        """Whether a call was refused because the call budget was spent."""
        self.end_reason: EndReason | None = None
        self.end_message = ""
        self.fault: BaseException | None = None
        self.ended = threading.Event()
        self._started: float | None = None
        self._stopped: float | None = None
        self._record = RunRecord(trajectory)
        self._answers: dict[str, asyncio.Future[CallAnswer] | None] = {}
        self._kept: deque[str] = deque()
        self._lost: dict[str, asyncio.Future[CallAnswer]] = {}
        """Calls whose answer went nowhere, by what they are."""
        self._loop: asyncio.AbstractEventLoop | None = None
        self._timer: asyncio.TimerHandle | None = None
        self._waiting: set[_Call] = set()
        """The calls whose tools are at work."""
        self._pool = ThreadPoolExecutor(PARALLEL_CALLS, thread_name_prefix=f"tools-{run_id}")

    def start(self, loop: asyncio.AbstractEventLoop) -> None:
        """Start the clock of the wall budget. Thread-safe."""
        self._loop = loop
        self._started = time.monotonic()

        def arm() -> None:
            self._timer = loop.call_later(
                self.budget.wall_minutes * 60, self._end, "wall_budget", "the time budget is spent"
            )

        loop.call_soon_threadsafe(arm)

    def end(self, reason: EndReason, message: str) -> None:
        """End the run from the server's side: calls in flight are answered with an error, later ones refused.

        Thread-safe; the first reason stays.
        """
        assert self._loop is not None, "the run has not started"
        self._loop.call_soon_threadsafe(self._end, reason, message)
        self.ended.wait()

    def _end(self, reason: EndReason, message: str) -> None:
        if self.end_reason is not None:
            return
        self.end_reason, self.end_message = reason, message
        self._stopped = time.monotonic()
        try:
            for call in list(self._waiting):
                self._finish(call, None)
        finally:
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
        return {
            "tool_calls_left": max(0, self.budget.tool_calls - self.calls),
            "seconds_left": max(0, round(self.budget.wall_minutes * 60 - self.wall_s)),
        }

    def ask(self, name: str, arguments: Mapping[str, Any], key: str | None, own: bool) -> AskedCall:
        """Begin one call; who waits for its answer may be cancelled: the call goes on, and is recorded.

        A request id that was seen before gets the first answer again. So does the repeat of a call whose answer went
        nowhere (``lose``), by a client that gives its calls no id of its own (``own``) and comes over a new connection.
        """
        given, told, problem = plain(arguments)
        what = short(f"{name} {digest_bytes(told)}")
        key = None if key is None else short(f"{key} {what}")
        if key is not None and key in self._answers:
            self.record_duplicate(name, key)
            first = self._answers[key]
            return AskedCall("", first or self._answered(self._refusal("this request id was already answered")))
        lost = None if own else self._lost.pop(what, None)
        if lost is not None:
            self.record_duplicate(name, key)
        answered = lost or self._begin(name, given, told, problem, key)
        if key is not None:
            self._answers[key] = answered
            answered.add_done_callback(lambda _: self._keep_answer(key))
        return AskedCall("" if own else what, answered)

    def lose(self, asked: AskedCall) -> None:
        """Note that the answer to a call went nowhere. Its repeat is given it, unless another call begins before."""
        if asked.what:
            self._lost[asked.what] = asked.answered

    def record_duplicate(self, name: str, key: str | None) -> None:
        """Note a repeat of a call."""
        self._note("duplicate", tool=name, request=key, outcome="duplicate")

    def _note(self, event: str, **fields: Any) -> None:
        """Record a call that does not count; too many of them end the run."""
        self._write(event, counted=False, **fields)
        self._uncounted += 1
        if self._uncounted > UNCOUNTED_CALLS:
            self._end("killed", f"more than {UNCOUNTED_CALLS} refused and repeated calls")

    def _keep_answer(self, key: str) -> None:
        """Keep a finished answer for repeats, and let go of the oldest one above ``KEPT_ANSWERS``."""
        self._kept.append(key)
        if len(self._kept) > KEPT_ANSWERS:
            self._answers[self._kept.popleft()] = None

    def _begin(
        self, name: str, arguments: dict[str, Any], told: bytes, problem: str, key: str | None
    ) -> asyncio.Future[CallAnswer]:
        """Refuse a call, or count it, record its start and set its tool to work."""
        refused = self._refused(name)
        if refused is not None:
            why, stop = refused
            self._note(
                "refused",
                tool=name,
                request=key,
                outcome="refused",
                error=why,
                arguments=orjson.Fragment(told if len(told) <= RECORDED_REFUSED_BYTES else b"null"),
            )
            return self._answered(self._refusal(why, stop=stop))
        answered = self._answered(None)
        self._lost.clear()
        self.calls += 1
        self.polls += name == POLLING
        call = _Call(self.calls, name, arguments, told, key, self.wall_s, time.perf_counter(), answered)
        self._waiting.add(call)
        if self._write("started", counted=False, outcome="unfinished", **call.fields()):
            problem = problem or schema_problem(name, arguments)
            if problem:
                self._finish(call, ToolRefused(problem))
            elif TOOLS[name].instant:
                self._finish(call, self._carry_out(call))
            else:
                self._pool.submit(self._work, call)
        return answered

    def _answered(self, answer: CallAnswer | None) -> asyncio.Future[CallAnswer]:
        """A promise of an answer; kept at once where there is one."""
        assert self._loop is not None, "the run has not started"
        made: asyncio.Future[CallAnswer] = self._loop.create_future()
        if answer is not None:
            made.set_result(answer)
        return made

    def _refused(self, name: str) -> tuple[str, bool] | None:
        """Why a call does not count and is not carried out, and whether no other will be; None for one that is."""
        if self.end_reason is not None:
            return f"the run has ended: {self.end_message}", True
        if name not in self.tools:
            self.blocked += 1
            return (
                f"there is no tool {short(name)!r} in this run; the tools are "
                + ", ".join(tool for tool in TOOLS if tool in self.tools)
            ), False
        if self.calls >= self.budget.tool_calls:
            self.over_calls = True
            return "the tool call budget is spent", True
        return None

    def _work(self, call: _Call) -> None:
        """Carry a call out in a thread of the pool; it is answered in the gateway's loop."""
        assert self._loop is not None
        given = self._carry_out(call)
        with suppress(RuntimeError):  # the gateway's loop is closed: nobody waits
            self._loop.call_soon_threadsafe(self._finish, call, given)

    def _carry_out(self, call: _Call) -> _Given | BaseException:
        """Run the tool: what it gives, or raises."""
        try:
            tool = TOOLS[call.name]
            result = tool.run(self.bench, call.arguments)
            images = [] if result.image is None else [self._record.keep(result.image)]
            return _Given(*held(result.data, tool.bound(call.arguments) - _BUDGET_SIZE), result.image, images)
        except BaseException as error:
            return error

    def _finish(self, call: _Call, given: _Given | BaseException | None) -> None:
        """Record a call's end and answer it, once; None is given where the run ended before its tool did."""
        if call not in self._waiting:
            return
        self._waiting.discard(call)
        image, images, stop, error, cut = None, [], "", "", {}
        if isinstance(given, _Given):
            outcome: Outcome = "ok"
            image, images = given.image, given.images
            text = f'{{"result":{given.text},"budget":{json_text(self.left())}}}'
            cut = {"cut_from": given.whole_size} if given.whole_size > size(given.text) else {}
        else:
            outcome, error = _failure(given, self.end_message)
            stop = self.end_message if outcome == "ended" else ""
            text = self._refusal(error, stop=bool(stop)).text
        answer = CallAnswer(text, outcome != "ok", image)
        if isinstance(given, BaseException) and outcome == "fault":
            self.fault = self.fault or given
        written = self._write(
            "call",
            counted=True,
            outcome=outcome,
            error=error,
            **call.fields(),
            duration_s=round(time.perf_counter() - call.clock, 4),
            result=text[:RECORDED_RESULT_CHARACTERS],
            result_characters=len(text),
            **cut,
            images=images,
        )
        call.answered.set_result(
            answer if written else self._refusal(f"the run has ended: {self.end_message}", stop=True)
        )
        if self.fault is not None:
            self._end("fault", "the engine or a tool failed")

    def _refusal(self, error: str, *, stop: bool = False) -> CallAnswer:
        error = clipped(error, ERROR_SIZE // 2 if stop else ERROR_SIZE)
        return CallAnswer(json_text({"error": error, "budget": self.left(), **({"stop": error} if stop else {})}), True)

    def _write(self, event: str, **fields: Any) -> bool:
        """Record a line. A line that cannot be written is a fault of the machinery and ends the run: False."""
        try:
            self._record.write(event, **fields, **self.left())
        except OSError as error:
            self.fault = self.fault or MachineryFault(
                f"the trajectory cannot be written: {error.strerror}",
                where=str(self.trajectory.resolve()),
                todo="is the disk full?",
            )
            self._end("fault", "the trajectory cannot be written")
            return False
        return True


def _failure(given: BaseException | None, end_message: str) -> tuple[Outcome, str]:
    """How a call without a result ended, and what the agent is told of it."""
    if given is None:
        return "ended", f"the run has ended: {end_message}"
    line = given.line() if isinstance(given, C4SError) else f"{type(given).__name__}: {given}"
    return "error" if isinstance(given, ToolRefused) else "fault", whole(line)
