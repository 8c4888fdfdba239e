"""``python -m bench.userlands FOLDER RELEASE ... [--demo]``: a new user's first minutes, in a chroot.

Each release (of Debian: bookworm, trixie, sid; of Ubuntu: jammy, noble) is made in ``FOLDER`` with debootstrap and
holds Python, make, git and certificates alone; the last commit of this checkout is cloned into it, set up with
``make setup``, and tries one case, or the whole ``make demo``. One line a step: the release, the command, its exit code
and its processor time. Needs root, and the keys of Ubuntu for its releases (Debian's package ``ubuntu-keyring``).
"""

from __future__ import annotations

import argparse
import os
import resource
import shutil
import subprocess
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Final

ROOT: Final = Path(__file__).resolve().parents[1]
PACKAGES: Final = "python3,python3-venv,make,git,ca-certificates"
UBUNTU: Final = ("jammy", "noble")
UBUNTU_SCRIPT: Final = "/usr/share/debootstrap/scripts/jammy"
"""debootstrap makes all of them alike, but does not know those newer than itself."""
SHORT: Final = (
    "make setup",
    ".venv/bin/c4s --version",
    ".venv/bin/c4s suite build starter",
    ".venv/bin/c4s run starter -a noop -c outdoor-farm-yard",
)
WHOLE: Final = ("make demo",)
TREE: Final = "root/c4s"
CERTIFICATES: Final = "etc/ssl/certs/ca-certificates.crt"
MOUNTED: Final = """
set -e; cd "$1"; mount --make-rprivate /; mount -t proc proc proc; mount -t tmpfs tmpfs dev
for name in null zero full random urandom tty; do touch dev/$name; mount --bind /dev/$name dev/$name; done
mkdir dev/shm; ln -s /proc/self/fd dev/fd
exec chroot . sh -c "cd /root/c4s && $2"
"""
"""What runs in a mount namespace of its own: all that it mounts is gone with it."""
KEPT: Final = (
    "PIP_CERT",
    "PIP_INDEX_URL",
    "PIP_DEFAULT_TIMEOUT",
    "HTTP_PROXY",
    "HTTPS_PROXY",
    "http_proxy",
    "https_proxy",
)


def made(folder: Path, release: str) -> Path:
    """The userland of a release, with a new clone of the checkout."""
    place = folder.absolute() / release
    if not place.is_dir():
        command = ["debootstrap", "--variant=minbase", f"--include={PACKAGES}"]
        if release in UBUNTU:
            default_mirror = ""
            command += ["--components=main,universe", release, str(place), default_mirror, UBUNTU_SCRIPT]
        else:
            command += [release, str(place)]
        subprocess.run(command, check=True)
    for name in ("etc/resolv.conf", "etc/hosts", CERTIFICATES):
        shutil.copyfile(f"/{name}", place / name)
    subprocess.run(["git", "clone", "--quiet", str(ROOT), str(place / TREE)], check=True)
    return place


def tried(place: Path, commands: Sequence[str]) -> Iterator[tuple[str, int, float]]:
    """Each command with its exit code and processor seconds."""
    kept = {name: value for name, value in os.environ.items() if name in KEPT}
    environment = {"HOME": "/root", "PATH": "/usr/sbin:/usr/bin:/sbin:/bin", **kept}
    for command in commands:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        line = ["unshare", "--mount", "--pid", "--fork", "--kill-child", "sh", "-c", MOUNTED, "sh", str(place), command]
        code = subprocess.run(line, env=environment, check=False).returncode
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        yield command, code, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main() -> int:
    """Try and print; 0 when every command ended with 0."""
    parser = argparse.ArgumentParser(prog="python -m bench.userlands", description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("releases", nargs="+")
    parser.add_argument("--demo", action="store_true", help="the whole demo, not one case")
    given = parser.parse_args()
    rows = [
        (release, *row)
        for release in given.releases
        for row in tried(made(given.folder, release), WHOLE if given.demo else SHORT)
    ]
    for release, command, code, seconds in rows:
        print(f"{release:10} exit {code}  {seconds:6.0f} s  {command}")
    return int(any(code for _, _, code, _ in rows))


if __name__ == "__main__":
    raise SystemExit(main())
