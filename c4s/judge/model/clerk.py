"""Asking: from the cache or from the endpoint, within the budget, with every request and answer stored by its
digest."""

from __future__ import annotations

import random
import threading
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import FIRST_EXCEPTION, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Any, Generic, Self, TypeVar

from c4s.chat.client import ChatClient, Reply
from c4s.chat.failures import ChatEnded, ChatFailed
from c4s.chat.replicas import WIRE
from c4s.files import append_json_line, digest, write_json
from c4s.judge.desk import Desk
from c4s.judge.model.cache import Cache
from c4s.judge.model.contract import WHOLE, Broken
from c4s.judge.model.endpoints import served
from c4s.judge.model.requests import Request
from c4s.judge.model.version import asked_by
from c4s.meter.metered import estimate_tokens, estimate_usd
from c4s.meter.prices import cost_of, price_today
from c4s.meter.spending import UNPRICED, SpendingLimitReached
from c4s.meter.usage import UNKNOWN, Usage
from c4s.meter.wire import BY_NAME
from c4s.records.judge import JudgeConfiguration
from c4s.records.judgement import Asked, JudgeUsage, Serving

T = TypeVar("T")
Read = Callable[[Reply], tuple[T, dict[str, str]]]
"""Makes of a reply what it says, and how claims of it break the contract; ``Broken`` where it does as a whole."""
SLICE_S = 1.0
_NOT_BILLED = frozenset({"rate", "server", "context", "refused"})
_KEPT = ("content", "refusal")


@dataclass(frozen=True)
class Told(Generic[T]):
    """What came of a request; ``value`` is None where the answer is broken as a whole, or none came."""

    value: T | None
    asked: Asked


class Clerk:
    """Asks one model for one submission's judge. Safe for threads; a context manager."""

    def __init__(self, configuration: JudgeConfiguration, desk: Desk) -> None:
        place = served(configuration)
        self._desk, self.parallel = desk, place.parallel
        self._cache = Cache(asked_by(configuration))
        self._own = None if desk.answers is None else Cache(asked_by(configuration), desk.answers)
        self._replicas = len(place.addresses)
        self._models, self._fingerprints = set[str](), set[str]()
        self._over = threading.Event()
        self._lock = threading.Lock()
        self._made = JudgeUsage()
        price = price_today(configuration.model)
        self._price, self._model = price, configuration.model
        self.faults: list[str] = []
        self._chat = ChatClient(
            place.addresses,
            wait=self._wait,
            jitter=random.Random(configuration.sha256()),
            note=self._note,
            answer_s=configuration.timeout_s,
        )

    def __enter__(self) -> Self:
        """Ready to ask."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._chat.close()

    @property
    def usage(self) -> JudgeUsage:
        """What was asked and used so far."""
        with self._lock:
            return self._made

    @property
    def served(self) -> Serving:
        """Who answered so far."""
        with self._lock:
            return Serving(
                replicas=self._replicas,
                parallel=self.parallel,
                models=sorted(self._models),
                fingerprints=sorted(self._fingerprints),
            )

    def ask(self, request: Request, read: Read[T], *, may_split: bool = False) -> Told[T]:
        """The answer to a request, as ``read`` understands it.

        ``ChatFailed`` where none comes, unless the desk accepts faults; where the request ``may_split``, one that is
        too long for the model is always told so. ``SpendingLimitReached`` at a limit of the run.
        """
        self._store(request.sha256, request.document)
        if self._own is not None and (mine := self._own.get(request)) is not None:
            self._note_answer(mine, cost_of(_usage_of(mine), self._price).usd)
            return self._told(request, mine, read, cached=False)
        kept = None if self._desk.fresh else self._cache.get(request)
        if kept is not None:
            told = self._told(request, kept, read, cached=True)
            if not told.asked.broken:
                self._count(cached=True)
                return told
        try:
            answer = self._fresh(request)
        except ChatFailed as failure:
            too_long = may_split and failure.kind == "context"
            if not self._desk.accept_faults or too_long or isinstance(failure, ChatEnded):
                raise
            with self._lock:
                self.faults.append(failure.what)
            return Told(None, self._asked(request, None, {}, fault=failure.what))
        told = self._told(request, answer, read, cached=False)
        if not told.asked.broken and not self._desk.fresh:
            self._cache.put(request, answer)
        return told

    def side_by_side(self, jobs: Sequence[Callable[[], T]]) -> list[T]:
        """The results of all jobs in their order, so many at once as the endpoint takes.

        The first that fails ends the others, and is raised.
        """
        with ThreadPoolExecutor(max(1, min(self.parallel, len(jobs))), "judge") as pool:
            futures = [pool.submit(job) for job in jobs]
            done, left = wait(futures, return_when=FIRST_EXCEPTION)
            failed = [future for future in futures if future in done and future.exception() is not None]
            if left or failed:
                self._over.set()
                for future in left:
                    future.cancel()
            if failed:
                raise _first(failed)
        return [future.result() for future in futures]

    def _fresh(self, request: Request) -> dict[str, Any]:
        body = request.body()
        entry = self._hold(body)
        try:
            reply = self._chat.ask(body)
        except ChatFailed as failure:
            if entry is not None and self._desk.ledger is not None:
                nothing = failure.kind in _NOT_BILLED
                self._desk.ledger.settle(entry, 0.0 if nothing else None, 0 if nothing else None)
            raise
        cost = cost_of(reply.usage, self._price).usd
        used = _tokens(reply.usage)
        if entry is not None and self._desk.ledger is not None:
            self._desk.ledger.settle(entry, cost, used)
        message = {name: reply.message[name] for name in _KEPT if reply.message.get(name) is not None}
        answer = {
            "message": message,
            "finish": reply.finish,
            "model": reply.model,
            "fingerprint": reply.fingerprint,
            "usage": reply.usage.plain(),
        }
        self._note_answer(answer, cost)
        if self._own is not None:
            self._own.put(request, answer)
        return answer

    def _note_answer(self, answer: Mapping[str, Any], cost: float | None) -> None:
        with self._lock:
            self._models |= {str(answer["model"])} if answer.get("model") else set()
            self._fingerprints |= {str(answer["fingerprint"])} if answer.get("fingerprint") else set()
        self._count(usage=_usage_of(answer), cost=cost)

    def _hold(self, body: Mapping[str, Any]) -> str | None:
        """Enter a request in the run's books. ``SpendingLimitReached`` where a limit is."""
        ledger = self._desk.ledger
        if ledger is None:
            return None
        wire = BY_NAME[WIRE]
        price = self._price
        entry = ledger.hold(
            None if price is None else estimate_usd(wire, body, price), round(sum(estimate_tokens(wire, body)))
        )
        if entry is not None:
            return entry
        if ledger.limit_usd is not None and price is None:
            raise SpendingLimitReached(
                f"the judge's spending limit of {ledger.limit_usd:.2f} USD cannot be kept: no price for model "
                f"{self._model!r}",
                todo=UNPRICED,
            )
        raise SpendingLimitReached(
            f"the judge's limit for this run is reached: {ledger.spent().told()}",
            todo="raise --judge-spend or --judge-tokens and run the same command again",
        )

    def _told(self, request: Request, answer: Mapping[str, Any], read: Read[T], *, cached: bool) -> Told[T]:
        sha256 = digest(answer_of(answer))
        self._store(sha256, answer_of(answer))
        message = answer.get("message")
        reply = Reply(message if isinstance(message, dict) else {}, str(answer.get("finish") or ""), None, None)
        try:
            value, broken = read(reply)
        except Broken as fault:
            return Told(None, self._asked(request, sha256, {WHOLE: fault.kind}, cached=cached))
        return Told(value, self._asked(request, sha256, broken, cached=cached))

    def _asked(
        self, request: Request, answer: str | None, broken: dict[str, str], *, cached: bool = False, fault: str = ""
    ) -> Asked:
        return Asked(
            purpose=request.purpose,
            request_sha256=request.sha256,
            answer_sha256=answer,
            claims=list(request.claims),
            views=list(request.views),
            again=request.again,
            broken=broken,
            fault=fault,
            cached=cached,
        )

    def _store(self, sha256: str, document: Mapping[str, Any]) -> None:
        folder = self._desk.exchanges
        if folder is not None and not exchange_file(folder, sha256).is_file():
            write_json(exchange_file(folder, sha256), document, indent=None)

    def _note(self, record: dict[str, Any]) -> None:
        with self._lock:
            self._made = self._made.model_copy(update={"failures": self._made.failures + 1})
            if self._desk.exchanges is not None:
                append_json_line(self._desk.exchanges / "failures.jsonl", record)

    def _count(self, *, cached: bool = False, usage: Usage = UNKNOWN, cost: float | None = 0.0) -> None:
        with self._lock:
            made = self._made
            used = usage.input_tokens is not None and usage.output_tokens is not None
            total = None if made.cost_usd is None or cost is None else made.cost_usd + cost
            self._made = made.model_copy(
                update={
                    "cached": made.cached + cached,
                    "input_tokens": made.input_tokens + (usage.input_tokens or 0),
                    "output_tokens": made.output_tokens + (usage.output_tokens or 0),
                    "unknown": made.unknown + (not used and not cached),
                    "cost_usd": total,
                }
            )

    def _wait(self, seconds: float) -> bool:
        """Wait, in slices, until the time is over, the run takes no more, or another request failed for good."""
        left = seconds
        while not self._over.is_set() and not self._desk.wait(max(0.0, min(SLICE_S, left))):
            left -= SLICE_S
            if left <= 0:
                return self._over.is_set()
        return True


def exchange_file(folder: Path, sha256: str) -> Path:
    """Where a request or an answer lies."""
    return folder / f"{sha256}.json"


def answer_of(record: Mapping[str, Any]) -> dict[str, Any]:
    """An answer as it is stored: without the digest of its request, which a cached one has."""
    return {name: value for name, value in record.items() if name != "request_sha256"}


def _usage_of(answer: Mapping[str, Any]) -> Usage:
    return Usage.parse(answer.get("usage") or {})


def _tokens(usage: Usage) -> int | None:
    if usage.input_tokens is None or usage.output_tokens is None:
        return None
    return usage.input_tokens + usage.output_tokens


def _first(failed: Sequence[Future[Any]]) -> BaseException:
    """The error to tell: a limit of the run before an endpoint's failure, and that before what merely ended with it."""
    errors = [error for future in failed if (error := future.exception()) is not None]
    return min(errors, key=lambda error: (not isinstance(error, SpendingLimitReached), isinstance(error, ChatEnded)))
