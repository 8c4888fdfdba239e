"""``python -m bench.installed [--json] [--python PROGRAM] [--keep FOLDER]``: what an installation takes on disk.

An empty environment gets ``requirements-run.lock`` and the wheel of the last commit, is added up by package, and
added up again after ``deploy/slim.sh``. Compared are the environment that runs this (``make setup``: all that
development needs), and what each extra adds. Ends with 1 where more than two thirds of the 1.8 GB are left that an
installation took before there were extras.
"""

from __future__ import annotations

import argparse
import json
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Iterator
from importlib.metadata import Distribution, distributions
from pathlib import Path
from typing import Any, Final

from bench.dist import ROOT, build, exported
from bench.locks import RUN, normal

BEFORE_MB: Final = 1_800.0
SHARE: Final = 2 / 3
SHOWN: Final = 20
EXTRAS: Final = ("service", "s3", "plots", "telemetry")
_BLOCK: Final = 512
_NAME: Final = re.compile(r"^[\w.-]+")


def install(place: Path, python: str) -> None:
    """Make an environment of a Python with what runs c4s."""
    with tempfile.TemporaryDirectory(prefix="c4s-wheel-") as scratch:
        tree = Path(scratch, "tree")
        wheel, _ = build(tree, Path(scratch, "out"), exported(tree))
        subprocess.run([python, "-m", "venv", str(place)], check=True)
        pip = [str(place / "bin/python"), "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-deps"]
        subprocess.run([*pip, "--require-hashes", "-r", str(ROOT / RUN)], check=True)
        subprocess.run([*pip, str(wheel)], check=True)


def held_mb(one: Distribution) -> float:
    """Megabytes (10^6 bytes) of a package's files as the disk holds them."""
    places = (Path(str(one.locate_file(file))) for file in one.files or ())
    return sum(place.lstat().st_blocks * _BLOCK for place in places if place.exists()) / 1e6


def whole_mb(place: Path) -> float:
    """Megabytes of all that lies below a folder."""
    return sum(file.lstat().st_blocks * _BLOCK for file in place.rglob("*")) / 1e6


def found(*path: Path) -> dict[str, Distribution]:
    """The packages of an environment by name; of the one that runs this where no folder is given."""
    listed = distributions(path=list(map(str, path))) if path else distributions()
    return {normal(one.name): one for one in listed}


def brought(c4s: Distribution, extra: str, here: dict[str, Distribution]) -> set[str]:
    """All packages of this environment that an extra of c4s brings, one by another."""
    wanted = {name for name, given in _asked(c4s) if given == extra}
    waiting = list(wanted)
    while waiting:
        one = here.get(waiting.pop())
        new = set() if one is None else {name for name, given in _asked(one) if not given} - wanted
        wanted |= new
        waiting += new
    return wanted & here.keys()


def _asked(one: Distribution) -> Iterator[tuple[str, str]]:
    """The packages that one asks for, and the extra of it that asks."""
    for line in one.requires or ():
        name, extra = _NAME.match(line), re.search(r"extra == ['\"]([\w-]+)", line)
        if name is not None:
            yield normal(name[0]), extra[1] if extra else ""


def _said(*command: str | Path) -> str:
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()


def measured(place: Path) -> dict[str, Any]:
    """What an environment with c4s alone takes, before and after it is slimmed, and how much more is here."""
    alone = found(next(place.glob("lib/python3.*/site-packages")))
    own = alone["c4s"]
    packages = {name: held_mb(one) for name, one in alone.items()}
    before = whole_mb(place)
    subprocess.run(["sh", str(ROOT / "deploy/slim.sh"), str(place)], check=True)
    here = found()
    return {
        "python": _said(place / "bin/python", "--version").removeprefix("Python "),
        "c4s": _said(place / "bin/c4s", "--version").splitlines(),
        "installed_mb": before,
        "slimmed_mb": whole_mb(place),
        "developed_mb": whole_mb(Path(sys.prefix)),
        "packages_mb": dict(sorted(packages.items(), key=lambda row: -row[1])),
        "extras_mb": {
            name: sum(held_mb(here[one]) for one in brought(own, name, here) - alone.keys()) for name in EXTRAS
        },
    }


def lines(told: dict[str, Any]) -> Iterable[str]:
    """It, as a table."""
    packages: dict[str, float] = told["packages_mb"]
    shown, rest = list(packages.items())[:SHOWN], list(packages.values())[SHOWN:]
    for name, size in [*shown, (f"{len(rest)} others", sum(rest))]:
        yield f"{size:8,.0f} MB  {name}"
    yield f"{told['installed_mb']:8,.0f} MB  installed ({RUN} and the wheel, Python {told['python']})"
    yield f"{told['slimmed_mb']:8,.0f} MB  after deploy/slim.sh"
    for name, size in told["extras_mb"].items():
        yield f"{size:+8,.0f} MB  c4s[{name}]"
    yield f"{told['developed_mb']:8,.0f} MB  make setup, for comparison"


def main() -> int:
    """Install, measure and print; 0 when at most two thirds are left."""
    parser = argparse.ArgumentParser(prog="python -m bench.installed", description=__doc__)
    parser.add_argument("--json", action="store_true", help="as JSON, every package")
    parser.add_argument("--python", default=sys.executable, help="of which Python (default: this one)")
    parser.add_argument("--keep", type=Path, help="new folder for the environment (default: a temporary one)")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="c4s-installed-") as scratch:
        place = (given.keep or Path(scratch, "environment")).absolute()
        install(place, given.python)
        told = measured(place)
    print(json.dumps(told, indent=1) if given.json else "\n".join(lines(told)))
    return int(told["slimmed_mb"] > BEFORE_MB * SHARE)


if __name__ == "__main__":
    raise SystemExit(main())
