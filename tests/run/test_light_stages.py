"""A worker process loads what its stage works with, not what every stage of a trial might."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from c4s.protocol.baselines import BASELINES, CHEATS

HEAVY = ("duckdb", "jsonschema", "mcp", "numba", "pandas", "pyarrow", "scipy")


def test_stages_are_known_without_what_they_work_with() -> None:
    code = f"import sys, c4s.run.stages; print(*(name for name in {HEAVY} if name in sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=True)
    assert done.stdout.split() == []


def test_walks_are_judged_without_a_library_of_trees() -> None:
    code = "import sys, c4s.verify.navigation.verdict; print('scipy.spatial' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=True)
    assert done.stdout.split() == ["False"]


def test_a_small_matching_loads_no_compiled_code() -> None:
    code = (
        "import sys, numpy; from c4s.verify.repair.assignment import minimum_cost; "
        "minimum_cost(numpy.eye(20)); print('numba' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=True)
    assert done.stdout.split() == ["False"]


def test_checking_calls_makes_no_grammar_of_web_addresses() -> None:
    code = "import sys, c4s.toolbox.arguments; print('rfc3987_syntax' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=True)
    assert done.stdout.split() == ["False"]


@pytest.mark.parametrize("module", ["c4s.evidence", "cases.starter.suite", "c4s.cli.evaluation"])
def test_what_is_done_is_found_without_what_makes_it(module: str) -> None:
    makers = ("jsonschema", "mcp", "numba", "openpyxl", "pandas", "scipy.spatial", "trimesh")
    code = f"import sys, {module}; print(*(name for name in {makers} if name in sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=True)
    assert done.stdout.split() == []


def test_pages_are_written_without_what_none_of_them_may_need() -> None:
    makers = ("jsonschema", "mcp", "numba", "openpyxl", "scipy", "trimesh")
    code = f"import sys, reports.site; print(*(name for name in {makers} if name in sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=True)
    assert done.stdout.split() == []


@pytest.mark.parametrize("name", [*BASELINES, *CHEATS])
def test_agents_are_known_without_what_they_connect_with(name: str) -> None:
    makers = ("httpx2", "mcp", "numba", "pandas", "scipy.spatial", "trimesh", "uvicorn")
    code = (
        f"import sys; from c4s.agents.base import agent_of; from c4s.run.configurations import configuration; "
        f"agent_of(configuration({name!r})); print(*(name for name in {makers} if name in sys.modules))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=True)
    assert done.stdout.split() == []


@pytest.mark.parametrize("flow", ["flows.trial", "flows.evaluate"])
def test_a_flow_whose_server_is_named_loads_no_server_and_no_grammar(flow: str) -> None:
    makers = ("prefect.server.api.server", "prefect.server.database", "rfc3987_syntax.syntax_helpers")
    code = f"import sys, {flow}; print(*(name for name in {makers} if name in sys.modules))"
    named = {**os.environ, "PREFECT_API_URL": "http://127.0.0.1:9/api"}
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=named, check=True)
    assert done.stdout.split() == []
