"""A Harbor environment without containers, and an agent that saves what it finds; imported by Harbor, not by tests.

Each environment is a root of its own: what the images of ``deploy/harbor/Dockerfile`` hold is bound read-only (the
system, c4s, the packs), the folders that Harbor writes to are private. ``C4S_BIN`` and ``C4S_HOME`` say where c4s is.
"""

from __future__ import annotations

import asyncio
import os
import shlex
import shutil
import tempfile
from pathlib import Path

from harbor.agents.base import BaseAgent
from harbor.agents.capabilities import AgentCapabilities
from harbor.environments.base import BaseEnvironment, ExecResult
from harbor.environments.capabilities import EnvironmentCapabilities

OWN = ("c4s", "logs", "tests", "solution", "installed-agent")
HIDDEN = ("proc", "dev", "tmp", "sys", *OWN)


class LocalEnvironment(BaseEnvironment):
    """Folders, and bubblewrap around every command."""

    @staticmethod
    def type() -> str:
        return "local"

    @property
    def capabilities(self) -> EnvironmentCapabilities:
        return EnvironmentCapabilities(disable_internet=True)

    def _validate_definition(self) -> None:
        assert self.task_env_config.docker_image

    async def start(self, force_build: bool) -> None:
        self._root = Path(tempfile.mkdtemp(prefix="c4s-harbor-"))
        for name in ("logs/agent", "logs/verifier", "logs/artifacts", "c4s/home", *OWN):
            (self._root / name).mkdir(parents=True, exist_ok=True)
        (self._root / "c4s/home/packs").symlink_to(Path(os.environ["C4S_HOME"], "packs"))
        await self._upload_environment_dir_after_start()

    async def stop(self, delete: bool) -> None:
        if hasattr(self, "_root"):
            shutil.rmtree(self._root, ignore_errors=True)

    def _inside(self, path: str) -> Path:
        return self._root / path.lstrip("/")

    async def upload_file(self, source_path: Path | str, target_path: str) -> None:
        self._inside(target_path).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(source_path, self._inside(target_path))

    async def upload_dir(self, source_dir: Path | str, target_dir: str) -> None:
        shutil.copytree(source_dir, self._inside(target_dir), dirs_exist_ok=True, symlinks=True)

    async def download_file(self, source_path: str, target_path: Path | str) -> None:
        Path(target_path).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(self._inside(source_path), target_path)

    async def download_dir(self, source_dir: str, target_dir: Path | str) -> None:
        shutil.copytree(self._inside(source_dir), target_dir, dirs_exist_ok=True, symlinks=True)

    async def exec(
        self,
        command: str,
        cwd: str | None = None,
        env: dict[str, str] | None = None,
        timeout_sec: int | None = None,
        user: str | int | None = None,
    ) -> ExecResult:
        binds = [
            word
            for found in sorted(Path("/").iterdir())
            if found.name not in HIDDEN
            for word in ("--bind", str(found), str(found))
        ]
        own = [word for name in OWN for word in ("--bind", str(self._root / name), f"/{name}")]
        told = {
            "PATH": f"{os.environ['C4S_BIN']}:{os.environ['PATH']}",
            "C4S_HOME": "/c4s/home",
            "HOME": "/c4s",
            **(env or {}),
        }
        process = await asyncio.create_subprocess_exec(
            *(
                "bwrap",
                "--tmpfs",
                "/",
                *binds,
                *own,
                "--dev-bind",
                "/dev",
                "/dev",
                "--proc",
                "/proc",
                "--bind",
                "/tmp",
                "/tmp",
            ),
            *("--chdir", cwd or self.task_env_config.workdir or "/", "sh", "-c", command),
            env=told,
            stdout=asyncio.subprocess.PIPE,
            stderr=asyncio.subprocess.PIPE,
        )
        out, err = await asyncio.wait_for(process.communicate(), timeout_sec)
        return ExecResult(stdout=out.decode(), stderr=err.decode(), return_code=process.returncode or 0)


class SavingAgent(BaseAgent):
    """Connects to the task's tool server as the task tells, and saves the scene as it is."""

    capabilities = AgentCapabilities(mcp_servers=True)

    @staticmethod
    def name() -> str:
        return "saving"

    def version(self) -> str:
        return "1"

    async def setup(self, environment: BaseEnvironment) -> None:
        await environment.upload_file(Path(__file__).with_name("stdio_save.py"), "/installed-agent/stdio_save.py")

    async def run(self, instruction: str, environment: BaseEnvironment, context: object) -> None:
        (server,) = self.mcp_servers
        told = shlex.join([server.command, *server.args])
        done = await environment.exec(f"python /installed-agent/stdio_save.py {told}", timeout_sec=300)
        assert done.return_code == 0, done.stderr
