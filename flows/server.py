"""The server that Prefect starts for a flow where none is named. It ends with the flow's process, whatever ends that.

Prefect stops its server when the process that started it leaves in order; one that was killed would leave it for ever.
"""

from __future__ import annotations

import os
import subprocess
import sys
from typing import TYPE_CHECKING, Any, Final

import prefect
from prefect.settings import get_current_settings

if TYPE_CHECKING:
    from prefect.server.api.server import SubprocessASGIServer

_TIED: Final = """
import os, runpy, sys, threading
import flows
def watch(line):
    os.read(line, 1)
    os._exit(1)
threading.Thread(target=watch, args=(int(sys.argv.pop(1)),), daemon=True).start()
runpy.run_module("uvicorn", run_name="__main__", alter_sys=True)
"""
"""The server's own program, with a thread that ends it when the other end of a pipe is closed."""
_lines: list[int] = []
"""This process's ends of these pipes: the system closes them when it ends."""


def tie() -> None:
    """From now on a server that Prefect starts in this process is tied to it. Where one is named it starts none, and
    its code, which takes longer to load than a flow, is left out."""
    if get_current_settings().api.url is not None:
        return
    from prefect.server.api.server import SubprocessASGIServer

    SubprocessASGIServer._run_uvicorn_command = _run  # type: ignore[method-assign, assignment]


def _run(server: SubprocessASGIServer) -> subprocess.Popen[Any]:
    """As ``SubprocessASGIServer`` of Prefect 3.8 starts its server, but tied."""
    far, near = os.pipe()
    _lines.append(near)
    place = ["--app-dir", str(prefect.__module_path__.parent), "--host", "127.0.0.1", "--port", str(server.port)]
    try:
        return subprocess.Popen(
            [
                *(sys.executable, "-c", _TIED, str(far)),
                *("--factory", "prefect.server.api.server:create_app", *place),
                *("--log-level", "error", "--lifespan", "on"),
            ],
            env={
                **os.environ,
                "PREFECT_UI_ENABLED": "0",
                "PREFECT__SERVER_EPHEMERAL": "1",
                "PREFECT__SERVER_FINAL": "1",
                **get_current_settings().to_environment_variables(exclude_unset=True),
            },
            pass_fds=(far,),
        )
    finally:
        os.close(far)
