"""Runs a repair of the starter suite inside other programs that drive agents: Harbor, Inspect AI, verifiers.

``python tests/agent_clients/harness.py [--install] [--case CASE] [HARNESS ...]`` prints a line a harness and agent,
with the reward that arrived there (of a trajectory, its steps). ``--install`` installs each in an environment of its
own under ``C4S_HOME/harnesses``, from PyPI. Exit 1 where one that is installed does not score as c4s does: what saves
the scene as it is gets what ``noop`` gets. One that is not installed, or cannot be, is a line with the reason.
"""

from __future__ import annotations

import argparse
import shutil
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import harness_harbor
import harness_inspect
import harness_verifiers
from harness_made import Made
from matrix import built_suite

from c4s.home import home

CASE = "indoor-flat-02-living-room"


@dataclass(frozen=True)
class Harness:
    """A program, what it is installed from, and how it is run."""

    name: str
    package: str
    pythons: tuple[str, ...]
    """Which Python it needs; none where it stands beside c4s, in a copy of the environment that this runs in."""
    run: Callable[[Path, str], list[Made]]
    files_of: str = ""
    """A package of which only files are needed, not what it depends on."""
    beside: tuple[str, ...] = ()
    """What else it needs in its environment."""


HARNESSES = {
    "harbor": Harness("harbor", "harbor==0.24.0", ("python3.12", "python3.13"), harness_harbor.run),
    "inspect": Harness("inspect", "inspect-ai==0.3.285", (), harness_inspect.run, files_of="litellm"),
    "verifiers": Harness(
        "verifiers",
        "verifiers==0.4.0",
        ("python3.12", "python3.13"),
        harness_verifiers.run,
        beside=("uv", "setuptools>=80", "wheel"),
    ),
}


def environment(harness: Harness, install: bool) -> tuple[Path | None, str]:
    """The harness's own environment, or why there is none."""
    place = home() / "harnesses" / harness.name
    if (place / "done").is_file():
        return place, ""
    if not install:
        return None, "not installed (--install)"
    if not harness.pythons:
        return _beside(place, harness)
    python = next((found for name in harness.pythons if _works(found := shutil.which(name) or "")), None)
    if python is None:
        return None, f"no {' or '.join(harness.pythons)} here"
    subprocess.run([python, "-m", "venv", str(place)], check=True)
    return _installed(place, harness)


def _beside(place: Path, harness: Harness) -> tuple[Path | None, str]:
    shutil.copytree(sys.prefix, place, symlinks=True, copy_function=_linked)
    return _installed(place, harness)


def _linked(source: str, target: str) -> str:
    """One content under two names, where one file system has both; a copy else."""
    try:
        Path(target).hardlink_to(source)
    except OSError:
        shutil.copy2(source, target)
    return target


def _installed(place: Path, harness: Harness) -> tuple[Path | None, str]:
    print(f"installing {harness.package}", flush=True)
    install = [str(place / "bin/python"), "-m", "pip", "install", "--quiet", harness.package, *harness.beside]
    pip = subprocess.run(install, capture_output=True, text=True)
    if not pip.returncode and harness.files_of:
        command = [str(place / "bin/python"), "-m", "pip", "install", "--quiet", "--no-deps", harness.files_of]
        pip = subprocess.run(command, capture_output=True, text=True)
    if pip.returncode:
        return None, f"{harness.package} cannot be installed: {(pip.stderr.strip().splitlines() or [''])[-1]}"
    (place / "done").touch()
    return place, ""


def _works(python: str) -> bool:
    return bool(python) and subprocess.run([python, "--version"], capture_output=True).returncode == 0


def main() -> int:
    """Print the lines."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--install", action="store_true")
    parser.add_argument("--case", default=CASE)
    parser.add_argument("harnesses", nargs="*", default=list(HARNESSES))
    chosen = parser.parse_args()
    built_suite()
    failed = False
    for name in chosen.harnesses:
        place, reason = environment(HARNESSES[name], chosen.install)
        if place is None:
            print(f"{name:10} skipped: {reason}", flush=True)
            continue
        for made in HARNESSES[name].run(place, chosen.case):
            right = made.reward is not None and abs(made.reward - made.expected) < 1e-6
            failed |= not right
            word = "as expected" if right else f"EXPECTED {made.expected}"
            print(f"{name:10} {made.agent:10} {made.reward} {word}  {made.note}", flush=True)
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
