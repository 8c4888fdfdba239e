"""A headless engine process and the bridge to it, for as long as the host needs it."""

from __future__ import annotations

import os
import socket
import tempfile
from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Unpack

from c4s.engine.confine.confinement import Backend, Limits
from c4s.engine.confine.sandbox import Mounts
from c4s.engine.confine.sandbox import backend as choose_sandbox
from c4s.engine.confine.sandbox import start as start_confined
from c4s.engine.headless.host import kernels
from c4s.engine.host.places import session_places
from c4s.engine.host.session import SOCKET, Session
from c4s.engine.inputs import EngineInputs
from c4s.files import write_json
from c4s.folders import remove_tree

START_TIMEOUT_S = 120.0
OFFERED = "offered.json"
"""In scratch: paths of the assets that are there. It is read once, before any script runs."""


class EngineSession(Session):
    """One headless engine process."""

    kind = "headless"

    @classmethod
    def start(
        cls, *, limits: Limits | None = None, use: Backend | None = None, **given: Unpack[EngineInputs]
    ) -> EngineSession:
        """Start an engine and wait until it serves.

        The engine sees the pack folders and the level files (read-only), ``content`` and ``scratch`` (writable unless
        ``content_read_only``), the Python runtime, and nothing else. What it prints is kept in ``<scratch>.logs``.
        Raises ``BadInput`` for what cannot be loaded, ``MachineryFault`` when there is no sandbox or the engine does
        not come up.
        """
        at = session_places(given)
        for folder in (at.content, at.scratch, at.logs):
            folder.mkdir(parents=True, exist_ok=True)
        chosen, limits, compiled = use or choose_sandbox(), limits or Limits(), kernels.compiled()
        readable = (*at.packs, *at.levels, compiled, *((at.content,) if at.content_read_only else ()))
        writable = (at.scratch,) if at.content_read_only else (at.content, at.scratch)
        paths = Mounts(readable, writable, at.scratch)
        with ExitStack() as undo:
            socket_folder = Path(tempfile.mkdtemp(prefix="c4s-"))
            undo.callback(remove_tree, socket_folder, inside=socket_folder.parent)
            listener = undo.enter_context(socket.socket(socket.AF_UNIX))
            listener.bind(str(socket_folder / SOCKET))
            listener.listen(64)
            near, far = socket.socketpair()
            undo.enter_context(near)
            output, writing = os.pipe()
            undo.callback(os.close, output)
            try:
                process = start_confined(
                    "c4s.engine.headless.process.main",
                    {
                        "channel": far.fileno(),
                        "packs": [str(path) for path in at.packs],
                        "content": str(at.content),
                        "levels": [str(path) for path in at.levels],
                        "start_map": at.start_map,
                        "offered": None if at.offered is None else str(_noted(at.offered, at.scratch)),
                        "scratch": str(at.scratch),
                    },
                    paths=paths,
                    output=writing,
                    keep_open=[far.fileno()],
                    limits=limits,
                    use=chosen,
                    environment=kernels.linked(compiled, at.scratch),
                )
            finally:
                far.close()
                os.close(writing)
            undo.pop_all()
        session = cls(process, listener, near, output, paths, (socket_folder, at.logs), limits, chosen)
        try:
            session._wait_until_ready(START_TIMEOUT_S)
        except BaseException:
            session.kill()
            raise
        return session


def _noted(offered: Sequence[str], scratch: Path) -> Path:
    """The file that tells the engine what is offered: a command line holds no long list."""
    write_json(scratch / OFFERED, list(offered))
    return scratch / OFFERED
