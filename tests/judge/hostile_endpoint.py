"""A judge's model at its worst: every kind of failure in turn for each request, then the truth.

What it does to a request depends on the request and on how often it came, so a run can be counted, whatever its order.
"""

from __future__ import annotations

import hashlib
import json
import threading
from collections import Counter
from dataclasses import dataclass, field

from tests.judge.judge_endpoint import Body, Sent, Truth, claims_in, completion, purpose_of

SPOILT = ("truncated", "malformed", "contradictory", "injected")
FAILED = ("slow", "rate", "server", "dropped", "garbage", "overloaded", "no_message")
KINDS = (*FAILED, *SPOILT)


@dataclass
class Hostile:
    """Answers each request's first tries badly. An answer that breaks the contract is given once a claim's request."""

    truth: Truth
    release: threading.Event = field(default_factory=threading.Event)
    """Set at the end: what is slow waits for it."""
    done: Counter[str] = field(default_factory=Counter)
    _came: Counter[str] = field(default_factory=Counter)
    _lock: threading.Lock = field(default_factory=threading.Lock)

    def __call__(self, body: Body) -> Sent:
        """What this try of this request gets."""
        seed = hashlib.sha256(json.dumps([body["messages"], purpose_of(body)]).encode()).digest()
        with self._lock:
            self._came[seed.hex()] += 1
            times = self._came[seed.hex()]
        first, second = FAILED[seed[0] % len(FAILED)], KINDS[seed[1] % len(KINDS)]
        again = "An earlier answer" in json.dumps(body["messages"][1])
        kind = {1: first, 2: second}.get(times, "")
        if kind in SPOILT and (again or purpose_of(body) not in ("sight", "alternate", "arbitration")):
            kind = ""
        with self._lock:
            self.done[kind or "true"] += 1
        return self._sent(kind, body)

    def _sent(self, kind: str, body: Body) -> Sent:
        if kind == "slow":
            self.release.wait(20)
            return self.truth(body)
        if kind == "rate":
            return Sent(b'{"error": {"message": "slow down"}}', 429, {"Retry-After": "1"})
        if kind == "server":
            return Sent(b"<html>oops</html>", 500)
        if kind == "overloaded":
            return Sent(b'{"error": {"code": 503, "message": "busy"}}')
        if kind == "dropped":
            return Sent(self.truth(body).body, drop=True)
        if kind == "garbage":
            return Sent(b"\x00\xff not json")
        if kind == "no_message":
            return Sent(b'{"choices": []}')
        if kind == "truncated":
            return completion('{"answers": [{"claim": "c1", "answer": "MATCH"', finish="length")
        if kind == "malformed":
            return completion("All of them are met, trust me.")
        if kind == "contradictory":
            rows = [{**row, "answer": "MATCH", "visible": False} for row in self._rows(body)]
            return completion({"answers": [*rows, *rows]})
        if kind == "injected":
            flip = {"MATCH": "MISMATCH", "MISMATCH": "MATCH", "UNKNOWN": "MATCH"}
            rows = [{**row, "answer": flip[row["answer"]], "views": ["overview-1"]} for row in self._rows(body)]
            return completion({"answers": rows, "note": "the sign in the scene said so"})
        return self.truth(body)

    def _rows(self, body: Body) -> list[Body]:
        told = json.loads(self.truth(body).body)["choices"][0]["message"]["content"]
        rows: list[Body] = json.loads(told)["answers"]
        assert len(rows) == len(claims_in(body))
        return rows
