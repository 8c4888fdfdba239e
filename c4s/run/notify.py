"""Telling somebody that a run ended, or that a guard stops it: a POST to an address, or a command with JSON as input.

An address may hold a secret, so no more of it than its host is ever shown. A notice that fails is told in a line and
changes nothing about the run.
"""

from __future__ import annotations

import json
import os
import shlex
import shutil
import subprocess
import threading
from collections.abc import Callable, Mapping
from typing import Any, Final
from urllib.parse import urlsplit

from c4s.errors import BadInput
from c4s.records.journal import Event

VARIABLE: Final = "C4S_NOTIFY"
POST_S, COMMAND_S = 10.0, 30.0
"""How long an address and a command may take."""


class Notifier:
    """Where notices go.

    Args:
        target: an http address, or a command line (split as a shell splits it, run without one). ``BadInput`` for an
            address without a host and for a command that is not there.
        tell: is given a line where a notice could not be sent.
    """

    def __init__(self, target: str, tell: Callable[[str], None]) -> None:
        self._tell = tell
        self._url, self._command = "", [""]
        self._sending: list[threading.Thread] = []
        if target.lower().startswith(("http://", "https://")):
            self._url, self.shown = target, _host(target)
        else:
            self._command = _command(target)
            self.shown = f"command {self._command[0]!r}"

    def send(self, notice: Mapping[str, Any]) -> None:
        """Send a notice, while the caller goes on."""
        thread = threading.Thread(target=self._send, args=(json.dumps(notice, default=str),), name="notice")
        self._sending.append(thread)
        thread.start()

    def wait(self) -> None:
        """Until all notices are sent, or have failed: each has its time."""
        for thread in self._sending:
            thread.join()
        self._sending.clear()

    def _send(self, body: str) -> None:
        failed = self._post(body) if self._url else self._run(body)
        if failed:
            self._tell(f"the notice to {self.shown} was not taken: {failed}; the run is not affected")

    def _post(self, body: str) -> str:
        """Why an address did not take a notice; empty where it did. An error's own text may name the address."""
        import httpx

        try:
            answer = httpx.post(
                self._url, content=body.encode(), headers={"content-type": "application/json"}, timeout=POST_S
            )
        except (httpx.HTTPError, httpx.InvalidURL, ValueError, OSError, ImportError) as error:
            return type(error).__name__
        return "" if answer.is_success else f"it answered {answer.status_code}"

    def _run(self, body: str) -> str:
        try:
            done = subprocess.run(
                self._command, input=body.encode(), timeout=COMMAND_S, check=False, capture_output=True
            )
        except subprocess.TimeoutExpired:
            return f"it took longer than {COMMAND_S:.0f} s"
        except OSError as error:
            return error.strerror or type(error).__name__
        if done.returncode == 0:
            return ""
        last = done.stderr.decode(errors="replace").strip().splitlines()[-1:]
        return f"it ended with {done.returncode}{''.join(f': {line[:200]}' for line in last)}"


def notifier(given: str | None, tell: Callable[[str], None]) -> Notifier | None:
    """What ``--notify`` names, else the variable ``C4S_NOTIFY``; None where neither does."""
    if given is not None and not given.strip():
        raise BadInput("it is empty", where="--notify", todo="name an address or a command")
    target = given or os.environ.get(VARIABLE, "").strip()
    return Notifier(target, tell) if target else None


def at_a_guard(to: Notifier, notice: Callable[[str], Mapping[str, Any]]) -> Callable[[Event], None]:
    """A listener that sends what ``notice`` makes of a line when a guard stops the run."""

    def listen(event: Event) -> None:
        if event.event == "stopped":
            to.send(notice(event.line or ""))

    return listen


def _host(target: str) -> str:
    try:
        address = urlsplit(target)
        host, _ = address.hostname, address.port
    except ValueError:
        host = None
    if not host:
        raise BadInput("this is no address of a host", where="--notify", todo="give one such as https://host/path")
    return f"{urlsplit(target).scheme.lower()}://{host}"


def _command(target: str) -> list[str]:
    try:
        words = shlex.split(target)
    except ValueError as error:
        raise BadInput(f"this is no command line: {error}", where="--notify") from None
    if not words or "\0" in target or shutil.which(words[0]) is None:
        raise BadInput(
            f"there is no command {words[0] if words else target!r}",
            where="--notify",
            todo="give an address with http:// or https://, or a command that can be run",
        )
    return words
