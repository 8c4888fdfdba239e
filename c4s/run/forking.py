"""The process that worker processes are forked from, as its parent sees it."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
from dataclasses import dataclass, field

from c4s.run.template import ENDED, ORDER

_BOOTSTRAP = (
    "import json, sys; sys.path[:] = json.loads(sys.argv[1]); from c4s.run.template import serve; "
    "serve(int(sys.argv[2]), int(sys.argv[3]))"
)


@dataclass(eq=False)
class Template:
    """A process that forks workers. They die with it, and it with the thread that started it."""

    process: subprocess.Popen[bytes]
    _orders: socket.socket
    _codes: dict[int, int] = field(default_factory=dict)

    @classmethod
    def start(cls) -> Template:
        """Start one; it takes orders at once, and does them when it has loaded what workers need."""
        near, far = socket.socketpair(type=socket.SOCK_SEQPACKET)
        with far:
            try:
                process = subprocess.Popen(
                    [sys.executable, "-c", _BOOTSTRAP, json.dumps(sys.path), str(far.fileno()), str(os.getpid())],
                    stdin=subprocess.DEVNULL,
                    stdout=2,
                    pass_fds=(far.fileno(),),
                )
            except BaseException:
                near.close()
                raise
        near.setblocking(False)
        return cls(process, near)

    @property
    def alive(self) -> bool:
        """Whether the process runs."""
        return self.process.poll() is None

    def fork(self, channel: socket.socket) -> None:
        """Have a worker forked that serves at this end of its channel. ``OSError`` where nobody takes the order."""
        self._note_ends()
        socket.send_fds(self._orders, [ORDER], [channel.fileno()])

    def exit_code(self, worker: int) -> int | None:
        """The exit code of a worker that ended (negative: the signal's), None where it is not told yet."""
        alive = self.alive
        self._note_ends()
        return self._codes.pop(worker, None if alive else -signal.SIGKILL)

    def _note_ends(self) -> None:
        try:
            while told := self._orders.recv(ENDED.size):
                worker, code = ENDED.unpack(told)
                self._codes[worker] = code
        except OSError:
            return

    def end(self) -> None:
        """End the process, and with it what is left of its workers."""
        self.process.kill()
        self.process.wait()
        self._orders.close()
