"""The engine's side of the bridge: accepts connections on an inherited socket and answers one request on each."""

from __future__ import annotations

import builtins
import importlib
import re
import socket
import threading
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from c4s.engine.bridge import MAX_REQUEST_BYTES, decode, encode, read_line
from c4s.engine.headless.jobs import Job, JobRunner, run_script

DEFAULT_WAIT_S = 20.0
MAX_SHOTS = 16
_READ_S = 60.0
_MAX_CONNECTIONS = 32
_FUNCTION = re.compile(r"[a-z_]+\.[a-z_0-9]+")

Params = Mapping[str, Any]


class BadRequest(Exception):
    """A request that cannot be understood; its text is the reply's ``error``."""


class BridgeServer:
    """Answers bridge requests. Work on the scene runs on the main thread (``JobRunner``); the rest at once."""

    def __init__(self, listener: socket.socket, runner: JobRunner, scratch: Path) -> None:
        self._listener, self._runner, self._scratch = listener, runner, scratch
        self._namespace: dict[str, Any] = {"__name__": "__main__", "__builtins__": builtins, "__doc__": None}
        self._places = threading.BoundedSemaphore(_MAX_CONNECTIONS)
        self._answers: dict[str, Callable[[Params], dict[str, Any]]] = {
            "execute_python_script": self._execute, "read_job_log": self._read, "abandon_job": self._abandon,
            "editor_status": self._status, "call_function": self._call, "take_screenshot": self._screenshot,
            "take_screenshot_batch": self._screenshots, "begin_rendering": lambda _: {"status": "ok"},
            "shutdown": self._shutdown}

    def start(self) -> None:
        """Serve in the background."""
        threading.Thread(target=self._accept, name="bridge", daemon=True).start()

    def _accept(self) -> None:
        self._listener.setblocking(True)
        while True:
            connection, _ = self._listener.accept()
            self._places.acquire()
            threading.Thread(target=self._serve, args=(connection,), name="bridge-request", daemon=True).start()

    def _serve(self, connection: socket.socket) -> None:
        """One request, one reply. A client that left gets none, and its job goes on."""
        with connection:
            try:
                reply = self._answer(connection)
            finally:
                self._places.release()
            connection.settimeout(_READ_S)
            try:
                connection.sendall(encode(reply))
            except (BrokenPipeError, ConnectionResetError, TimeoutError):
                return

    def _answer(self, connection: socket.socket) -> dict[str, Any]:
        try:
            message = decode(read_line(connection, MAX_REQUEST_BYTES, time.monotonic() + _READ_S))
            kind, params = message.get("type"), message.get("params") or {}
            answer = self._answers.get(kind) if isinstance(kind, str) else None
            if answer is None:
                raise BadRequest(f"unknown request type {kind!r}; known: {', '.join(self._answers)}")
            if not isinstance(params, dict):
                raise BadRequest("params must be an object")
            reply = answer(params)
            encode(reply)
            return reply
        except BadRequest as error:
            return {"status": "error", "error": str(error), "fault": "BadRequest"}
        except (ValueError, TypeError, TimeoutError) as error:
            return {"status": "error", "error": f"not a valid message: {error}", "fault": "BadRequest"}

    def _execute(self, params: Params) -> dict[str, Any]:
        script = params.get("script")
        if not isinstance(script, str):
            raise BadRequest("script must be a string")
        name = f"<script {self._scripts()}>"
        return self._finish(self._runner.submit(lambda: run_script(script, self._namespace, name)), params)

    def _scripts(self) -> int:
        self._script_count = getattr(self, "_script_count", 0) + 1
        return self._script_count

    def _call(self, params: Params) -> dict[str, Any]:
        function, arguments = params.get("function"), params.get("params") or {}
        if not isinstance(function, str) or not _FUNCTION.fullmatch(function):
            raise BadRequest("function must be module.function")
        if not isinstance(arguments, dict):
            raise BadRequest("params of a function must be an object")
        module, _, name = function.partition(".")
        return self._finish(
            self._runner.submit(lambda: getattr(importlib.import_module(f"c4s.editor.{module}"), name)(**arguments)),
            params)

    def _finish(self, job: Job, params: Params) -> dict[str, Any]:
        job.done.wait(_number(params, "wait_s", DEFAULT_WAIT_S))
        return job.reply()

    def _known(self, params: Params) -> Job:
        job = self._runner.job(str(params.get("job_id")))
        if job is None:
            raise BadRequest(f"no such job {params.get('job_id')!r}")
        return job

    def _read(self, params: Params) -> dict[str, Any]:
        job = self._known(params)
        job.done.wait(_number(params, "wait_s", 0.0))
        return job.reply(int(_number(params, "offset", 0.0)))

    def _abandon(self, params: Params) -> dict[str, Any]:
        self._runner.abandon(self._known(params))
        return {"status": "ok"}

    def _status(self, _: Params) -> dict[str, Any]:
        running = self._runner.running
        return {"status": "ok", "engine": "headless", "busy": running is not None,
                "job_id": running.id if running else None, "waiting": self._runner.waiting()}

    def _screenshot(self, params: Params) -> dict[str, Any]:
        reply = self._screenshots({**params, "shots": [params]})
        if reply["status"] == "success":
            return {"status": "ok", **reply["results"][0]}
        return reply

    def _screenshots(self, params: Params) -> dict[str, Any]:
        shots = params.get("shots")
        if not isinstance(shots, list) or not 1 <= len(shots) <= MAX_SHOTS:
            raise BadRequest(f"shots must be a list of 1 to {MAX_SHOTS}")
        folder = str(self._scratch / "screenshots")

        def take() -> Any:
            return importlib.import_module("c4s.editor.capture").take_screenshots(shots=shots, folder=folder)

        job = self._runner.submit(take)
        job.done.wait()
        return {**job.value} if job.error is None else job.reply()

    def _shutdown(self, _: Params) -> dict[str, Any]:
        self._runner.stop()
        return {"status": "ok"}


def _number(params: Params, name: str, default: float) -> float:
    value = params.get(name, default)
    if isinstance(value, bool) or not isinstance(value, int | float) or not 0 <= value < 1e9:
        raise BadRequest(f"{name} must be a number that is not negative")
    return float(value)
