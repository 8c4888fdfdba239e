"""One request through the meter, from the client's head to the record."""

from __future__ import annotations

import asyncio
import json
import time
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any
from urllib.parse import parse_qsl, urlencode

import httpx
from starlette.types import Receive, Scope, Send

from c4s.meter.events import BodyReader, EventReader
from c4s.meter.metered import MeterRun
from c4s.meter.prices import Cost, cost_of
from c4s.meter.record import NOT_BILLED, Ending, RequestRecord
from c4s.meter.usage import UNKNOWN, ZERO, MalformedUsage
from c4s.meter.wire import BY_NAME, nearest_wire
from c4s.meter.wire.base import Reading, Wire

MOST_REQUEST_BYTES = 64 << 20
MOST_HELD_BYTES = 256 << 20
"""Bodies of one run's requests that are held at the same time."""
_HOP = frozenset(
    {
        "connection",
        "keep-alive",
        "proxy-authenticate",
        "proxy-authorization",
        "te",
        "trailer",
        "transfer-encoding",
        "upgrade",
        "host",
        "content-length",
        "content-encoding",
        "accept-encoding",
        "authorization",
        "x-api-key",
        "x-goog-api-key",
        "cookie",
        "set-cookie",
        "expect",
        "forwarded",
        "x-forwarded-for",
        "x-forwarded-host",
        "x-forwarded-proto",
    }
)
"""Headers that belong to one hop or carry a credential; lengths and encodings are made anew."""


@dataclass(frozen=True)
class Timeouts:
    """Seconds to connect to the endpoint, and between two portions of its answer (models think for minutes)."""

    connect_s: float = 30.0
    silence_s: float = 900.0

    @property
    def httpx(self) -> httpx.Timeout:
        """For the HTTP client."""
        return httpx.Timeout(self.silence_s, connect=self.connect_s)


class _ClientGone(Exception):
    """The client closed its connection."""


class Exchange:
    """A request and its answer."""

    def __init__(
        self,
        client: httpx.AsyncClient,
        scope: Scope,
        receive: Receive,
        send: Send,
        wire: Wire | None,
        run: MeterRun | None,
    ) -> None:
        self._client, self._scope, self._receive, self._send = client, scope, receive, send
        self.wire, self.run = wire, run
        self._path: str = scope["path"]
        self._clock, self._time = time.perf_counter(), time.time()
        self._body: Mapping[str, Any] = {}
        self._sent_bytes = self._got_bytes = 0
        self._first_byte: float | None = None
        self._status: int | None = None
        self._reading, self._problem = Reading(), ""
        self._usage_wanted = True
        self._entry: str | None = None
        self._rest = b""

    async def run_through(self) -> None:
        """Check, send, pass on, record."""
        assert self.run is not None
        try:
            await self._take()
        finally:
            self.run.held_bytes -= self._sent_bytes

    async def _take(self) -> None:
        assert self.run is not None
        try:
            raw = await self._request_body()
        except _ClientGone:
            self._finish("aborted")
            return
        if raw is None:
            await self.refuse(
                413,
                "too_large",
                f"the request is over {MOST_REQUEST_BYTES >> 20} MiB, or all in work over {MOST_HELD_BYTES >> 20} MiB",
            )
            return
        if self.wire is not None:
            try:
                parsed = json.loads(raw)
                if not isinstance(parsed, dict):
                    raise ValueError("not an object")
            except (ValueError, RecursionError) as error:
                await self.refuse(400, "invalid_request", f"the request body is not a JSON object: {error}")
                return
            self._body = parsed
            model = self.wire.model(self._path, parsed)
            if self.run.models and model not in self.run.models:
                await self.refuse(
                    403,
                    "model_not_allowed",
                    f"this run may not use model {model!r}; it uses " + ", ".join(sorted(self.run.models)),
                )
                return
            self._entry, refusal = self.run.admit(self.wire, model, parsed)
            if refusal:
                await self.refuse(402, "spending_limit_reached", refusal)
                return
            raw = self._ask_for_usage(raw)
        await self._forward(raw)

    async def _request_body(self) -> bytes | None:
        assert self.run is not None
        portions: list[bytes] = []
        while True:
            message = await self._receive()
            if message["type"] == "http.disconnect":
                raise _ClientGone
            portions.append(message.get("body", b""))
            self._sent_bytes += len(portions[-1])
            self.run.held_bytes += len(portions[-1])
            if self._sent_bytes > MOST_REQUEST_BYTES or self.run.held_bytes > MOST_HELD_BYTES:
                return None
            if not message.get("more_body", False):
                return b"".join(portions)

    def _ask_for_usage(self, raw: bytes) -> bytes:
        """Chat streams tell their usage only on request: ask, and keep the extra chunk from a client that did not."""
        if self.wire is not BY_NAME["openai-chat"] or not self._body.get("stream"):
            return raw
        options = self._body.get("stream_options")
        options = dict(options) if isinstance(options, dict) else {}
        self._usage_wanted = options.get("include_usage") is True
        if self._usage_wanted:
            return raw
        return json.dumps({**self._body, "stream_options": {**options, "include_usage": True}}).encode()

    def _request(self, raw: bytes) -> httpx.Request:
        assert self.run is not None
        upstream, key = self.run.upstream, self.run.key
        headers = [
            (name, value) for name, value in self._scope["headers"] if name.decode("latin-1").lower() not in _HOP
        ]
        headers += [(name.lower().encode(), value.encode()) for name, value in upstream.headers.items()]
        headers.append((b"accept-encoding", b"identity"))
        if key is not None:
            name = upstream.header_of(self.wire)
            headers.append((name.encode(), (f"Bearer {key}" if name == "authorization" else key).encode()))
        query = urlencode(
            [
                (name, value)
                for name, value in parse_qsl(self._scope["query_string"].decode("latin-1"), keep_blank_values=True)
                if name != "key"
            ]
        )
        address = upstream.url.rstrip("/") + _below(upstream.url, self._path) + (f"?{query}" if query else "")
        return self._client.build_request(
            self._scope["method"],
            address,
            headers=headers,
            content=raw if raw or self._scope["method"] == "POST" else None,
        )

    async def _forward(self, raw: bytes) -> None:
        gone = asyncio.ensure_future(self._disconnect())
        work = asyncio.ensure_future(self._pass_on(raw))
        try:
            await asyncio.wait((gone, work), return_when=asyncio.FIRST_COMPLETED)
        except asyncio.CancelledError:
            work.cancel()
            self._finish(self._left())
            raise
        finally:
            gone.cancel()
        if not work.done():
            work.cancel()
            await asyncio.wait((work,))
            self._finish(self._left())
            return
        ending = work.result()
        if self._first_byte is None:
            self._status = 504 if ending == "timeout" else 502
        self._finish(ending)
        if ending in ("timeout", "cut") and self._first_byte is not None:
            raise ConnectionError(f"the model endpoint's answer ended early ({ending})")
        if self._first_byte is None:
            await self._answer(self._status or 502, ending, f"the model endpoint failed: {self._problem}")
        else:
            await self._send({"type": "http.response.body", "body": self._rest})

    def _left(self) -> Ending:
        """The ending where the client left first: some close the connection as soon as they have the last event."""
        return "ok" if self._reading.finished and self._reading.usage is not None else "aborted"

    async def _disconnect(self) -> None:
        while (await self._receive())["type"] != "http.disconnect":
            continue

    async def _pass_on(self, raw: bytes) -> Ending:
        """Send the request and hand its answer on, portion by portion, up to its close.

        The record is written before the close: a client that has a whole answer leaves no request untold.
        """
        sent = time.perf_counter()
        try:
            response = await self._client.send(self._request(raw), stream=True)
        except (httpx.ConnectError, httpx.ConnectTimeout, httpx.InvalidURL, httpx.UnsupportedProtocol) as error:
            return self._failed("unreachable", error)
        except httpx.TimeoutException as error:
            return self._failed("timeout", error)
        except httpx.HTTPError as error:
            return self._failed("cut", error)
        try:
            self._first_byte, self._status = time.perf_counter() - sent, response.status_code
            await self._send(
                {
                    "type": "http.response.start",
                    "status": response.status_code,
                    "headers": [
                        (name.lower(), value)
                        for name, value in response.headers.raw
                        if name.decode("latin-1").lower() not in _HOP
                    ],
                }
            )
            events = "event-stream" in response.headers.get("content-type", "")
            reader: EventReader | BodyReader = EventReader() if events else BodyReader()
            keep = _UsageFilter() if events and not self._usage_wanted else None
            async for portion in response.aiter_bytes():
                self._got_bytes += len(portion)
                shown = portion if keep is None else keep.feed(portion)
                if shown:
                    await self._send({"type": "http.response.body", "body": shown, "more_body": True})
                self._read(reader, portion)
            self._read(reader, None)
        except httpx.TimeoutException as error:
            return self._failed("timeout", error)
        except httpx.HTTPError as error:
            return self._failed("cut", error)
        finally:
            await response.aclose()
        self._rest = b"" if keep is None else keep.end()
        return self._ending(events, reader.done)

    def _failed(self, ending: Ending, error: Exception) -> Ending:
        self._problem = f"{type(error).__name__}: {error}".rstrip(": ")
        return ending

    def _ending(self, events: bool, done: bool) -> Ending:
        assert self._status is not None
        if self._status >= 400:
            self._problem = self._problem or self._reading.error
            return "upstream_error"
        if self._reading.error:
            self._problem = self._reading.error
            return "stream_error"
        if self.wire is not None and events and not (done or self._reading.finished):
            self._problem = self._problem or "the stream ended before the answer did"
            return "cut"
        return "ok"

    def _read(self, reader: EventReader | BodyReader, portion: bytes | None) -> None:
        """Learn from a portion; None ends the answer. What cannot be read is noted, and never stops the answer."""
        if self.wire is None:
            return
        try:
            for message in reader.end() if portion is None else reader.feed(portion):
                if isinstance(message, dict):
                    self.wire.read(self._reading, message)
        except MalformedUsage as error:
            self._reading.usage, self._problem = None, f"malformed usage: {error}"
        except (ValueError, RecursionError) as error:
            self._problem = self._problem or f"unreadable answer: {error}"

    async def refuse(self, status: int, kind: str, text: str, *, record: bool = True) -> None:
        """Answer with an error of the client's own format, and send nothing."""
        self._problem, self._status = text, status
        if record:
            self._finish("refused")
        await self._answer(status, kind, text)

    async def _answer(self, status: int, kind: str, text: str) -> None:
        body = json.dumps((self.wire or nearest_wire(self._path)).error(status, kind, text)).encode()
        headers = [(b"content-type", b"application/json"), (b"content-length", str(len(body)).encode())]
        if status in (401, 403, 429):
            headers.append((b"connection", b"close"))
        if status == 402:
            headers.append((b"x-should-retry", b"false"))
        await self._send({"type": "http.response.start", "status": status, "headers": headers})
        await self._send({"type": "http.response.body", "body": body})

    def _finish(self, ending: Ending) -> None:
        """Price the request and write its record."""
        assert self.run is not None
        usage = ZERO if ending in NOT_BILLED or self.wire is None else (self._reading.usage or UNKNOWN)
        model = self.wire.model(self._path, self._body) if self.wire is not None else None
        price = self.run.price(model) or self.run.price(self._reading.model)
        cost = Cost(0.0) if usage is ZERO else cost_of(usage, price)
        if self.wire is not None and ending in ("aborted", "timeout", "cut", "stream_error") and cost.usd is not None:
            cost = Cost(None, "the answer was not complete")
        self.run.settle(self._entry, cost.usd)
        if ending == "ok" and self.wire is not None and self._reading.usage is None and not self._problem:
            self._problem = "the answer told no usage"
        self.run.record(
            RequestRecord(
                seq=self.run.next_number(),
                time=round(self._time, 4),
                wire=self.wire.name if self.wire else None,
                path=self._path,
                model=model,
                served_model=self._reading.model,
                response_id=self._reading.response_id,
                stream=self.wire is not None and self.wire.streams(self._path, self._body),
                ending=ending,
                status=self._status,
                first_byte_s=None if self._first_byte is None else round(self._first_byte, 4),
                duration_s=round(time.perf_counter() - self._clock, 4),
                request_bytes=self._sent_bytes,
                response_bytes=self._got_bytes,
                cost_usd=cost.usd,
                cost_note=cost.reason,
                price_from=price.valid_from.isoformat() if price is not None and usage is not ZERO else None,
                reported_cost_usd=self._reading.reported_cost_usd,
                problem=" ".join(self._problem.split())[:500],
                **usage.plain(),
            )
        )


def _below(base: str, path: str) -> str:
    """The path below the upstream's base: a version that both the base and the client name is named once."""
    first = "/" + path.lstrip("/").split("/", 1)[0]
    return path[len(first) :] if base.rstrip("/").endswith(first) else path


class _UsageFilter:
    """Takes the chunk with usage and no choices out of a chat stream for a client that did not ask for it."""

    def __init__(self) -> None:
        self._rest = b""
        self._event: list[bytes] = []

    def feed(self, portion: bytes) -> bytes:
        """What the client is to see of this portion; whole events only."""
        lines = (self._rest + portion).split(b"\n")
        self._rest = lines.pop()
        shown = b""
        for line in lines:
            self._event.append(line + b"\n")
            if not line.strip(b"\r"):
                event, self._event = b"".join(self._event), []
                shown += b"" if _only_usage(event) else event
        return shown

    def end(self) -> bytes:
        """What is left of a stream without a closing blank line."""
        return b"".join(self._event) + self._rest


def _only_usage(event: bytes) -> bool:
    if not event.startswith(b"data:") or b'"usage"' not in event:
        return False
    try:
        message = json.loads(event[5:])
    except ValueError:
        return False
    return isinstance(message, dict) and message.get("choices") == [] and message.get("usage") is not None
