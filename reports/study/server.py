"""The server itself: on loopback only, in a thread of its own."""

from __future__ import annotations

import asyncio
import socket
import threading
from types import TracebackType
from typing import Self

import uvicorn

from c4s import loopback
from c4s.human import QuestionDesk
from c4s.records.asking import ORGANISER, Access
from reports.study.door import FrontDoor
from reports.study.seats import Seats


class QuestionServer:
    """Asks people until it is closed. Use it as a context manager."""

    def __init__(self, desk: QuestionDesk, access: Access, listener: socket.socket) -> None:
        """``listener``: of ``loopback.listener``, closed with the server."""
        host, port = listener.getsockname()[:2]
        self._base = f"http://{host}:{port}"
        self._keys, self._listener = access.keys, listener
        app = FrontDoor(Seats(desk, access.keys).app(), access.keys)
        options = loopback.config(app, loopback.DoorLimits(), log_level="critical", lifespan="off", date_header=False)
        self._server = uvicorn.Server(options)
        self._thread = threading.Thread(target=self._serve, name="questions", daemon=True)
        self.people = list(desk.people)

    def link(self, name: str = ORGANISER) -> str:
        """Where somebody sits."""
        return f"{self._base}/{self._keys[name]}/"

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._server.should_exit = True
        self._thread.join()

    def wait(self) -> None:
        """Wait until the server ends, which it does by itself only where it fails."""
        self._thread.join()

    def _serve(self) -> None:
        asyncio.run(self._server.serve([self._listener]))
