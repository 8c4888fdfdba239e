"""What only some commands need: they say in one line how it is installed, and the others do without."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from importlib.metadata import packages_distributions
from pathlib import Path

import pytest

from bench.locks import RUN, WHOLE, locked, normal
from c4s import extras
from tests.cli.contract import faults_of_line
from tests.cli.warm import Done
from tests.hidden import hiding

EVERY_MODULE = """
import importlib, pkgutil
INSIDE = ("c4s.editor.", "c4s.engine.headless.process.", "c4s.engine.headless.unreal.", "c4s.engine.unreal.boot.")
for root in ("c4s", "cases", "catalog", "reports", "warehouse"):
    for found in pkgutil.walk_packages(importlib.import_module(root).__path__, root + "."):
        if not found.name.startswith(INSIDE) and found.name.rpartition(".")[2] not in ("__main__", "inspecting"):
            importlib.import_module(found.name)
"""


def _c4s(environment: dict[str, str], *arguments: str) -> Done:
    done = subprocess.run(
        [sys.executable, "-m", "c4s.cli", *arguments],
        env=environment,
        capture_output=True,
        text=True,
        timeout=200,
        check=False,
    )
    return Done(done.returncode, done.stdout, done.stderr)


def _beyond_the_run_lock() -> set[str]:
    """The top modules that only packages of the whole lock bring."""
    kept, known = ({row.name for row in locked(name)} for name in (RUN, WHOLE))
    brought = {module: {*map(normal, by)} for module, by in packages_distributions().items()}
    return {module for module, by in brought.items() if by <= known - kept}


@pytest.mark.parametrize(
    ("arguments", "variables", "says"),
    [
        (["up"], {}, "`c4s up` needs prefect, which is not installed (pip install 'c4s[service]')"),
        (
            ["worker", "--pool", "engines", "--url", "http://127.0.0.1:9/api"],
            {},
            "`c4s worker` needs prefect, which is not installed (pip install 'c4s[service]')",
        ),
        (
            ["run", "yard", "-a", "noop"],
            {"C4S_STORE": "s3://bucket/place"},
            "C4S_STORE=s3://bucket/place needs s3fs, which is not installed (pip install 'c4s[s3]')",
        ),
        (
            ["analyze", "main-results", "--plot", "charts"],
            {},
            "--plot needs matplotlib, which is not installed (pip install 'c4s[plots]')",
        ),
        (
            ["run", "yard", "-a", "noop", "--run-id", "told"],
            {"OTEL_EXPORTER_OTLP_ENDPOINT": "http://127.0.0.1:9"},
            "OTEL_EXPORTER_OTLP_ENDPOINT needs opentelemetry.exporter.otlp.proto.http, which is not installed "
            "(pip install 'c4s[telemetry]')",
        ),
    ],
)
def test_a_command_whose_extra_is_missing_says_how_it_is_installed(
    tmp_path: Path, world: Path, arguments: list[str], variables: dict[str, str], says: str
) -> None:
    environment = hiding(tmp_path, extras.PACKAGES.values()) | {"C4S_HOME": str(world / "home")} | variables
    done = _c4s(environment, *arguments)
    assert (done.code, done.out, done.err) == (2, "", f"c4s: {says}\n")
    assert faults_of_line(done) == []


def test_doctor_tells_that_prefect_is_missing_and_what_it_costs(tmp_path: Path) -> None:
    done = _c4s(hiding(tmp_path, ["prefect"]) | {"C4S_HOME": str(tmp_path / "home")}, "doctor", "--json")
    row = next(row for row in json.loads(done.out) if row["what"] == "Prefect server")
    assert not row["found"] and not row["needed"] and "(pip install 'c4s[service]')" in row["text"]


def test_doctor_gives_a_row_where_the_working_directory_takes_no_home() -> None:
    environment = {name: value for name, value in os.environ.items() if name != "C4S_HOME"}
    command = [sys.executable, "-m", "c4s.cli", "doctor", "--json"]
    done = subprocess.run(command, env=environment, cwd="/proc", capture_output=True, text=True, check=False)
    row = next(row for row in json.loads(done.stdout) if row["what"] == "C4S_HOME")
    assert done.returncode == 1 and done.stderr == ""
    assert row["needed"] and not row["found"] and "nothing can be made in /proc" in row["text"]


def test_without_what_only_extras_and_tests_need_every_module_is_there_and_a_trial_runs(
    tmp_path: Path, world: Path
) -> None:
    missing = _beyond_the_run_lock()
    assert {"prefect", "fastapi", "sqlalchemy", "s3fs", "matplotlib", "pytest", "unreal"} <= missing
    environment = hiding(tmp_path, missing) | {"C4S_HOME": str(world / "home")}
    subprocess.run([sys.executable, "-c", EVERY_MODULE], env=environment, timeout=200, check=True)
    done = _c4s(environment, "agent", "try", "noop", "--suite", "yard", "--case", "yard")
    assert done.code == 0, done.err
