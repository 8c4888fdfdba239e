"""``make setup`` says in one line what a machine lacks, before it downloads anything."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
LACKS = {
    "an old Python": (
        "sys.version_info, sys.version = (3, 10, 2), '3.10.2 (main)'",
        "this is 3.10.2: run make PYTHON=",
    ),
    "another processor": ("platform.machine = lambda: 'aarch64'", "Linux on x86-64, this is Linux on aarch64"),
    "another system": ("sys.platform, platform.system = 'darwin', lambda: 'Darwin'", "this is Darwin on"),
    "an old C library": ("os.confstr = lambda name: 'glibc 2.17'", "glibc 2.28 or newer, this is 2.17: use Debian"),
    "musl": ("os.confstr = lambda name: None", "glibc 2.28 or newer, this is another C library (musl"),
    "no ensurepip": ("util.find_spec = lambda name: None", "apt install python3-venv"),
    "a read-only tree": ("os.access = lambda *told: False", "copy it to a folder of yours"),
}


def _python(change: str) -> subprocess.CompletedProcess[str]:
    told = f"import os, platform, runpy, sys; from importlib import util; {change}; "
    run = f"runpy.run_path({str(ROOT / 'preflight.py')!r}, run_name='__main__')"
    return subprocess.run([sys.executable, "-c", told + run], capture_output=True, text=True, timeout=60, check=False)


@pytest.mark.parametrize("what", LACKS)
def test_what_is_missing_is_one_line(what: str) -> None:
    change, line = LACKS[what]
    done = _python(change)
    assert done.returncode == 1 and done.stdout == ""
    assert done.stderr.startswith("c4s needs ") and line in done.stderr and done.stderr.count("\n") == 1


def test_a_machine_with_all_of_it_is_told_nothing() -> None:
    done = _python("pass")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


@pytest.mark.skipif(shutil.which("make") is None, reason="no make")
def test_make_ends_with_that_line(tmp_path: Path) -> None:
    tree = tmp_path / "mein Gerät"
    tree.mkdir()
    for name in ("Makefile", "preflight.py", "requirements.lock", "pyproject.toml"):
        shutil.copyfile(ROOT / name, tree / name)
    (tmp_path / "sitecustomize.py").write_text("import os; os.confstr = lambda name: None\n")
    environment = {**os.environ, "PYTHONPATH": str(tmp_path)}
    command = ["make", f"PYTHON={sys.executable}", "setup"]
    done = subprocess.run(command, cwd=tree, env=environment, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 2 and not (tree / ".venv").exists()
    assert done.stderr.splitlines()[0].startswith("c4s needs glibc 2.28 or newer")
