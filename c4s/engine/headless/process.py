"""The engine process: confine, build the world, serve the bridge on an inherited socket until told to stop."""

from __future__ import annotations

import json
import os
import socket
import sys
from pathlib import Path
from typing import Any

from c4s.engine.confine import Confinement, confine


def main() -> None:
    """Entry point; ``sys.argv[1]`` is the JSON that ``c4s.engine.session`` wrote."""
    settings = json.loads(sys.argv.pop(1))
    confine(Confinement.from_json(settings["confinement"]))
    listener = socket.socket(fileno=settings["listener"])
    serve(listener, settings)
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(0)


def serve(listener: socket.socket, settings: dict[str, Any]) -> None:
    """Build the world of ``settings`` and answer requests; bad input is told to the first that asks."""
    from c4s.engine.headless.boot import boot
    from c4s.engine.headless.jobs import JobRunner
    from c4s.engine.headless.render_scene import attach
    from c4s.engine.headless.server import BridgeServer
    from c4s.engine.headless.unreal.libraries import tick
    from c4s.errors import BadInput

    scratch = Path(settings["scratch"])
    try:
        boot([Path(pack) for pack in settings["packs"]], Path(settings["content"]),
             levels=[Path(level) for level in settings["levels"]], start_map=settings["start_map"], scratch=scratch)
    except BadInput as error:
        _refuse(listener, error.what, error.where, error.todo)
        return
    attach()
    from c4s.editor.capture import frame_level  # needs the `unreal` that boot installs

    frame_level()
    runner = JobRunner(scratch / "jobs", tick)
    BridgeServer(listener, runner, scratch).start()
    runner.run_forever()


def _refuse(listener: socket.socket, what: str, where: str, todo: str) -> None:
    from c4s.engine.bridge import encode

    connection, _ = listener.accept()
    with connection:
        connection.recv(1 << 16)
        connection.sendall(encode({"status": "error", "fault": "BadInput", "what": what, "where": where, "todo": todo,
                                   "error": what}))
