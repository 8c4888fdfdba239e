"""The engine process: confine, build the world, run jobs for the host until told to stop."""

from __future__ import annotations

import gc
import json
import os
import random
import socket
import sys
from pathlib import Path
from typing import Any

import numpy as np

from c4s.engine.confine.confinement import Confinement, confine


def main() -> None:
    """Entry point; ``sys.argv[1]`` is the JSON that ``c4s.engine.headless.host.session`` wrote."""
    settings = json.loads(sys.argv.pop(1))
    confine(Confinement.from_json(settings["confinement"]))
    connection = socket.socket(fileno=settings["channel"])
    serve(connection, settings)
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(0)


def serve(connection: socket.socket, settings: dict[str, Any]) -> None:
    """Build the world of ``settings`` and run jobs; bad input is told to the host."""
    from c4s.engine import channel
    from c4s.engine.headless.process.boot import boot
    from c4s.engine.headless.process.worker import Worker
    from c4s.engine.headless.unreal.libraries import tick
    from c4s.engine.headless.version import ENGINE_VERSION
    from c4s.errors import BadInput
    from c4s.files import read_json

    gc.disable()  # what loads now stays: looking through it again and again would take longer than loading it
    saved, offered = Path(settings["scratch"]) / "Saved", settings["offered"]
    saved.mkdir(exist_ok=True)
    try:
        boot(
            [Path(pack) for pack in settings["packs"]],
            Path(settings["content"]),
            levels=[Path(level) for level in settings["levels"]],
            start_map=settings["start_map"],
            scratch=saved,
            offered=None if offered is None else read_json(Path(offered)),
        )
    except BadInput as error:
        refused = {"what": error.what, "where": error.where, "todo": error.todo}
        channel.send(connection, json.dumps({"refused": refused}).encode())
        return
    draw_the_same_lots()
    from c4s.editor.capture import frame_level  # these need the `unreal` that boot installs
    from c4s.editor.host import register
    from c4s.engine.headless.process import revision
    from c4s.engine.headless.process.offers import HOST

    register(HOST)
    frame_level()
    gc.freeze()
    gc.enable()
    Worker(connection, tick, revision.begin, ENGINE_VERSION).run_forever()


def draw_the_same_lots() -> None:
    """Start Python's and NumPy's shared generators from fixed seeds, so that the same calls make the same scene."""
    random.seed(0)
    np.random.seed(0)
