"""How tests are run: properties are judged by their outcome, what lasts longest begins first, names stay the same."""

from __future__ import annotations

import shutil
import signal
from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest
from hypothesis import HealthCheck, settings

if TYPE_CHECKING:
    from playwright.sync_api import Browser

settings.register_profile("c4s", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("c4s")

LONGEST = (
    "run/test_evaluate.py",
    "run/test_starter_texts.py",
    "run/test_pools.py",
    "manual/test_tutorials.py",
    "run/test_torn.py",
    "run/test_limits.py",
    "cli/test_wrong_invocations.py",
    "study/test_browser.py",
    "reports/test_every_page.py",
    "catalog/test_ingest_folder.py",
    "run/test_faults.py",
    "run/test_operations.py",
    "judge/test_judge_hostile.py",
    "run/test_store.py",
    "run/test_scale.py",
    "reports/test_scene_view.py",
    "cases/test_scene_import.py",
    "cases/test_replacing.py",
    "run/test_labels.py",
    "toolbox/test_shipped_cases.py",
    "study/test_door.py",
    "robustness/test_forged_answers.py",
    "warehouse/test_refresh.py",
    "toolbox/test_answer_sizes.py",
    "run/test_repeatability.py",
    "run/test_odd_scenes.py",
    "warehouse/test_release.py",
    "study/test_pages.py",
    "cases/test_false_penetration.py",
    "run/test_model_judge.py",
    "cases/test_admissible.py",
    "run/test_serve_apart.py",
    "agent_clients/test_client_attempts.py",
    "unreal/test_editor_process.py",
    "unreal/test_trial_on_an_editor.py",
    "cli/test_bad_input.py",
    "cli/test_boundary.py",
    "run/test_frozen_suite.py",
    "judge/test_judge_check.py",
    "judge/test_sight.py",
    "cli/test_light_start.py",
)
"""Modules whose tests last longest (``--durations=0`` tells). One process runs all of a module, so a long one that
begins last keeps the others waiting. The first two ask for no folder that the other builds (``built_once``)."""


def pytest_configure() -> None:
    """Hear Ctrl-C, and with it all that tests start, where a shell's ``&`` has it ignored."""
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Bring the longest modules to the front; the rest stays in its order."""
    rank = {f"tests/{name}": place for place, name in enumerate(LONGEST)}
    items.sort(key=lambda item: rank.get(item.location[0], len(rank)))


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    """Headless Chromium; tests are skipped where there is none. It ends with its module: others run event loops."""
    from playwright.sync_api import sync_playwright

    chromium = shutil.which("chromium") or shutil.which("google-chrome")
    if chromium is None:
        pytest.skip("no Chromium on this machine")
    with sync_playwright() as playwright:
        started = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox", "--use-angle=swiftshader"])
        yield started
        started.close()


def pytest_make_parametrize_id(val: object, argname: str) -> str | None:
    """Name a case of bytes by its argument: packed bytes hold the hour, and processes must collect the same names."""
    return argname if isinstance(val, bytes) else None
