"""The bridge of an engine, served by the host: one request a connection, work handed to the engine's queue.

The engine process itself cannot be reached: requests are read, checked and bounded here, and the state of the engine
and of its jobs is answered here whatever the engine is doing.
"""

from __future__ import annotations

import os
import re
import socket
import struct
import threading
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import orjson

from c4s.engine.bridge import MAX_REQUEST_BYTES, decode, read_line
from c4s.engine.host.job import EngineJob
from c4s.engine.host.jobs import JobBoard

DEFAULT_WAIT_S = 20.0
MAX_SHOTS = 16
_READ_S = 10.0
_MAX_CONNECTIONS = 128
_CREDENTIALS = struct.Struct("3i")
_FUNCTION = re.compile(r"[a-z_]+\.[a-z_0-9]+")

Params = Mapping[str, Any]


class BadRequest(Exception):
    """A request that cannot be understood; its text is the reply's ``error``."""


class BridgeServer:
    """Answers bridge requests. Work on the scene is queued (``JobBoard``); the rest is answered at once."""

    def __init__(
        self, listener: socket.socket, board: JobBoard, scratch: Path, kind: str, read_s: float = _READ_S
    ) -> None:
        self._listener, self._board, self._scratch, self._kind, self._read_s = listener, board, scratch, kind, read_s
        self._scripts, self._closed = 0, False
        self._lock = threading.Lock()
        self._places = threading.BoundedSemaphore(_MAX_CONNECTIONS)
        self._answers: dict[str, Callable[[Params], dict[str, Any]]] = {
            "execute_python_script": self._execute,
            "read_job_log": self._read,
            "abandon_job": self._abandon,
            "editor_status": self._status,
            "call_function": self._call,
            "take_screenshot": self._screenshot,
            "take_screenshot_batch": self._screenshots,
            "begin_rendering": lambda _: {"status": "ok"},
            "shutdown": self._shutdown,
        }
        threading.Thread(target=self._accept, name="bridge", daemon=True).start()

    def close(self) -> None:
        """Take no more connections."""
        if not self._closed:
            self._closed = True
            self._listener.shutdown(socket.SHUT_RDWR)

    def _accept(self) -> None:
        with self._listener:
            while True:
                try:
                    connection, _ = self._listener.accept()
                except OSError as error:
                    if not self._closed:
                        self._board.fail(error)
                    return
                self._places.acquire()
                threading.Thread(target=self._serve, args=(connection,), name="bridge-request", daemon=True).start()

    def _serve(self, connection: socket.socket) -> None:
        """One request, one reply. A client that left gets none, and its job goes on."""
        with connection:
            try:
                reply = self._answer(connection)
            finally:
                self._places.release()
            connection.settimeout(self._read_s)
            try:
                connection.sendall(orjson.dumps(reply, option=orjson.OPT_APPEND_NEWLINE))
                connection.shutdown(socket.SHUT_WR)
                _discard(connection)
            except (BrokenPipeError, ConnectionResetError, TimeoutError):
                return

    def _answer(self, connection: socket.socket) -> dict[str, Any]:
        if not _same_user(connection):
            return _refusal("only the user who started the engine may speak to it")
        try:
            message = decode(read_line(connection, MAX_REQUEST_BYTES, time.monotonic() + self._read_s))
            orjson.dumps(message)
        except TimeoutError:
            return _refusal(f"no whole message in {self._read_s:g} s")
        except (ValueError, TypeError, OSError) as error:
            return _refusal(f"not a valid message: {error}")
        kind, params = message.get("type"), message.get("params")
        params = {} if params is None else params
        answer = self._answers.get(kind) if isinstance(kind, str) else None
        try:
            if answer is None:
                raise BadRequest(f"unknown request type {kind!a:.100}; known: {', '.join(self._answers)}")
            if not isinstance(params, dict):
                raise BadRequest("params must be an object")
            return answer(params)
        except BadRequest as error:
            return _refusal(str(error))

    def _execute(self, params: Params) -> dict[str, Any]:
        script = params.get("script")
        if not isinstance(script, str):
            raise BadRequest("script must be a string")
        wait_s, limit_s = _number(params, "wait_s", DEFAULT_WAIT_S), _optional(params, "limit_s")
        with self._lock:
            self._scripts += 1
            job = self._board.submit({"script": script, "name": self._scripts}, limit_s)
        return self._finish(job, wait_s, params)

    def _call(self, params: Params) -> dict[str, Any]:
        function, arguments = params.get("function"), params.get("params")
        arguments = {} if arguments is None else arguments
        if not isinstance(function, str) or not _FUNCTION.fullmatch(function):
            raise BadRequest("function must be module.function")
        if not isinstance(arguments, dict):
            raise BadRequest("params of a function must be an object")
        wait_s, limit_s = _number(params, "wait_s", DEFAULT_WAIT_S), _optional(params, "limit_s")
        return self._finish(self._board.submit({"function": function, "params": arguments}, limit_s), wait_s, params)

    def _finish(self, job: EngineJob, wait_s: float, params: Params) -> dict[str, Any]:
        offset, most = _optional(params, "offset"), _optional(params, "max_bytes")
        job.done.wait(wait_s)
        return job.reply(None if offset is None else int(offset), None if most is None else int(most))

    def _known(self, params: Params) -> EngineJob:
        job = self._board.job(str(params.get("job_id")))
        if job is None:
            raise BadRequest(f"no such job {params.get('job_id')!a:.100}")
        return job

    def _read(self, params: Params) -> dict[str, Any]:
        return self._finish(self._known(params), _number(params, "wait_s", 0.0), params)

    def _abandon(self, params: Params) -> dict[str, Any]:
        self._board.abandon(self._known(params))
        return {"status": "ok"}

    def _status(self, _: Params) -> dict[str, Any]:
        return {"status": "ok", "engine": self._kind, **self._board.status()}

    def _screenshot(self, params: Params) -> dict[str, Any]:
        limit = {"limit_s": params["limit_s"]} if "limit_s" in params else {}
        reply = self._screenshots({"shots": [dict(params)], **limit})
        if reply["status"] == "success":
            return {"status": "ok", **reply["results"][0]}
        return reply

    def _screenshots(self, params: Params) -> dict[str, Any]:
        shots = params.get("shots")
        if not isinstance(shots, list) or not 1 <= len(shots) <= MAX_SHOTS:
            raise BadRequest(f"shots must be a list of 1 to {MAX_SHOTS}")
        for shot in shots:
            _check_shot(shot)
        job = self._board.submit(
            {
                "function": "capture.take_screenshots",
                "params": {"shots": shots, "folder": str(self._scratch / "screenshots")},
            },
            _optional(params, "limit_s"),
        )
        job.done.wait()
        if job.error is not None or job.value is None:
            return job.reply()
        taken = orjson.loads(job.value)
        if not _is_batch(taken):
            return {"status": "error", "error": "the engine gave no pictures", "fault": "ValueError"}
        return {key: taken[key] for key in ("status", "results", "missing")}

    def _shutdown(self, _: Params) -> dict[str, Any]:
        self._board.stop()
        return {"status": "ok"}


def _check_shot(shot: Any) -> None:
    """Refuse a shot whose fields are not what they should be."""
    if not isinstance(shot, dict):
        raise BadRequest("a shot must be an object")
    for name in ("camera_location", "camera_rotation"):
        value = shot.get(name)
        if value is not None and not (isinstance(value, list) and len(value) == 3 and all(map(_is_number, value))):
            raise BadRequest(f"{name} must be three numbers")
    for name in ("width", "height", "field_of_view", "exposure_bias_ev"):
        value = shot.get(name)
        if value is not None and not (_is_number(value) and (value > 0 or name == "exposure_bias_ev")):
            raise BadRequest(f"{name} must be a number{'' if name == 'exposure_bias_ev' else ' above 0'}")
    if not isinstance(shot.get("filepath", ""), str):
        raise BadRequest("filepath must be a string")


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and -1e9 < value < 1e9


def _discard(connection: socket.socket) -> None:
    """Read away what is left of a refused request: a socket that is closed on unread data takes its reply with it."""
    left = MAX_REQUEST_BYTES
    while left > 0 and (part := connection.recv(1 << 20)):
        left -= len(part)


def _same_user(connection: socket.socket) -> bool:
    """Whether the process on the other side belongs to this user."""
    credentials = connection.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, _CREDENTIALS.size)
    return bool(_CREDENTIALS.unpack(credentials)[1] == os.getuid())


def _is_batch(taken: Any) -> bool:
    """Whether this is the reply of ``capture.take_screenshots``: agent code shares the engine with that function."""
    return (
        isinstance(taken, dict)
        and taken.get("status") in ("success", "partial")
        and all(isinstance(taken.get(key), list) for key in ("results", "missing"))
        and all(isinstance(result, dict) and isinstance(result.get("filepath"), str) for result in taken["results"])
        and (taken["status"] == "partial" or bool(taken["results"]))
    )


def _refusal(text: str) -> dict[str, Any]:
    return {"status": "error", "error": text.encode("utf-8", "replace").decode(), "fault": "BadRequest"}


def _optional(params: Params, name: str) -> float | None:
    return _number(params, name, 0.0) if name in params else None


def _number(params: Params, name: str, default: float) -> float:
    value = params.get(name, default)
    if isinstance(value, bool) or not isinstance(value, int | float) or not 0 <= value < 1e9:
        raise BadRequest(f"{name} must be a number that is not negative")
    return float(value)
