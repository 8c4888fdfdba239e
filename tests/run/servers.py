"""Real servers for tests: an S3-compatible object store, and PostgreSQL."""

from __future__ import annotations

import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import httpx


def free_ports(count: int) -> list[int]:
    """Ports that nobody listens on, each another."""
    with ExitStack() as opened:
        probes = [opened.enter_context(socket.socket()) for _ in range(count)]
        for probe in probes:
            probe.bind(("127.0.0.1", 0))
        return [int(probe.getsockname()[1]) for probe in probes]


def free_port() -> int:
    """A port that nobody listens on."""
    return free_ports(1)[0]


@contextmanager
def object_store() -> Iterator[dict[str, str]]:
    """A SeaweedFS server with a bucket ``c4s``; the environment that reaches it."""
    folder = Path(tempfile.mkdtemp(prefix="s3-"))
    keys = {"accessKey": "key", "secretKey": "secret"}
    identity = {"name": "c4s", "credentials": [keys], "actions": ["Admin", "Read", "Write", "List"]}
    (folder / "s3.json").write_text(json.dumps({"identities": [identity]}))
    names = ("master", "volume", "filer", "s3")
    taken = free_ports(2 * len(names))
    ports, own = dict(zip(names, taken, strict=False)), dict(zip(names, taken[len(names) :], strict=True))
    weed = Path(sys.executable).with_name("weed")
    server = subprocess.Popen(
        [
            *(weed, "server", "-s3", f"-s3.config={folder / 's3.json'}", f"-dir={folder}", "-ip=127.0.0.1"),
            *(f"-{name}.port={port}" for name, port in ports.items()),
            *(f"-{name}.port.grpc={own[name]}" for name in names),
            *("-master.volumeSizeLimitMB=64", "-volume.max=32", "-master.telemetry=false"),
            *("-s3.port.iceberg=0", "-s3.port.lance=0"),
        ],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    settings = {
        "AWS_ACCESS_KEY_ID": keys["accessKey"],
        "AWS_SECRET_ACCESS_KEY": keys["secretKey"],
        "AWS_ENDPOINT_URL_S3": f"http://127.0.0.1:{ports['s3']}",
        "AWS_DEFAULT_REGION": "us-east-1",
        "C4S_STORE": "s3://c4s/bench",
    }
    try:
        _make_bucket(settings, server)
        yield settings
    finally:
        server.kill()
        server.wait()
        shutil.rmtree(folder)


def _make_bucket(settings: dict[str, str], server: subprocess.Popen[bytes]) -> None:
    """Make the bucket as soon as the server makes buckets."""
    program = "import s3fs; s3fs.S3FileSystem().mkdir('c4s')"
    while subprocess.run([sys.executable, "-c", program], env=os.environ | settings, capture_output=True).returncode:
        assert server.poll() is None, "the object store does not come up"


def postgres_programs() -> Path | None:
    """Folder of the newest PostgreSQL server that is installed here; None where there is none."""
    found = sorted(Path("/usr/lib/postgresql").glob("*/bin/initdb"), key=lambda path: int(path.parents[1].name))
    on_path = shutil.which("initdb")
    return found[-1].parent if found else Path(on_path).parent if on_path else None


@contextmanager
def postgres() -> Iterator[str]:
    """A PostgreSQL server; its URL. It does not run as root, so root starts it as the user `postgres`."""
    programs = postgres_programs()
    assert programs is not None
    folder = Path(tempfile.mkdtemp(prefix="pg-"))
    as_user: list[str | Path] = []
    if os.getuid() == 0:
        shutil.chown(folder, "postgres")
        as_user = ["runuser", "-u", "postgres", "--"]
    data, port = folder / "data", free_port()
    initdb = [*as_user, programs / "initdb", "-D", data, "-U", "c4s", "--auth=trust", "--no-sync"]
    subprocess.run(initdb, check=True, capture_output=True, cwd=folder)
    server = subprocess.Popen(
        [*as_user, programs / "postgres", "-D", data, "-p", str(port), "-k", folder, "-c", "fsync=off"],
        stderr=subprocess.DEVNULL,
        cwd=folder,
    )
    ready = [programs / "pg_isready", "-q", "-h", "127.0.0.1", "-p", str(port)]
    try:
        while subprocess.run(ready, check=False).returncode:
            assert server.poll() is None, "PostgreSQL does not come up"
        yield f"postgresql://c4s@127.0.0.1:{port}/postgres"
    finally:
        os.kill(int((data / "postmaster.pid").read_text().split()[0]), signal.SIGQUIT)
        server.wait()
        shutil.rmtree(folder, ignore_errors=True)


def answers(url: str) -> bool:
    """Whether a server answers."""
    try:
        return httpx.get(url, timeout=3.0).is_success
    except httpx.HTTPError:
        return False
