"""A study of the paper's shape, and its server as a process of its own."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import pytest

from c4s.human import OpenStudy, design_study, study_named
from c4s.protocol.criteria import CRITERIA, SPLIT_SEED
from tests.built import built_once
from tests.human.made_study import AGENTS, make_run

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

SEVEN = AGENTS[:7]
PEOPLE = [f"person-{number}" for number in range(1, 8)]
PROMPTS = 2
EXPECTED = ("ERR_CONNECTION_RE", "422", "status of 404")
"""What a browser's console says of a server that was killed, of an answer that is refused, of a question too far."""


@dataclass
class Served:
    """A server that runs."""

    process: subprocess.Popen[str]
    links: dict[str, str]
    """By person; ``organiser`` among them."""

    def kill(self) -> None:
        """End it as a power cut would."""
        self.process.kill()
        self.process.wait()


Serve = Callable[..., Served]


def make_home(home: Path) -> None:
    """A run, and a study ``yards`` of its prompts and all seven criteria."""
    run = make_run(home, prompts=PROMPTS)
    design_study(
        run,
        home / "suites",
        home / "human" / "yards",
        agents=SEVEN,
        cases=[],
        annotators=PEOPLE,
        criteria=list(CRITERIA),
        seed=SPLIT_SEED,
    )


@pytest.fixture
def home(tmp_path_factory: pytest.TempPathFactory, tmp_path: Path) -> Path:
    """A home with a study ``yards`` of three prompts and all seven criteria, for changing."""
    made = built_once(tmp_path_factory, "asking-home", make_home)
    return Path(shutil.copytree(made, tmp_path / "home"))


@pytest.fixture
def study(home: Path) -> OpenStudy:
    """The study."""
    return study_named(home / "human", "yards")


@contextmanager
def serving(home: Path) -> Iterator[Serve]:
    """Starts ``c4s human`` servers on a home, and ends them."""
    begun: list[Served] = []

    def started(*words: str) -> Served:
        process = subprocess.Popen(
            [sys.executable, "-m", "c4s.cli", "human", *words, "--json"],
            env={**os.environ, "C4S_HOME": str(home)},
            stdout=subprocess.PIPE,
            text=True,
        )
        assert process.stdout is not None
        line = process.stdout.readline()
        told: dict[str, Any] = json.loads(line)
        begun.append(Served(process, {"organiser": told["organiser"], **told["people"]}))
        return begun[-1]

    yield started
    for one in begun:
        one.kill()
        assert one.process.stdout is not None
        one.process.stdout.close()


@pytest.fixture
def serve(home: Path) -> Iterator[Serve]:
    """Starts ``c4s human`` servers on the home."""
    with serving(home) as started:
        yield started


@contextmanager
def seat(browser: Browser, scheme: Literal["light", "dark"] = "light") -> Iterator[Page]:
    """A browser of its own for one person; nothing may be wrong on its pages: no error, no request to elsewhere."""
    context = browser.new_context(
        viewport={"width": 1400, "height": 1000}, color_scheme=scheme, reduced_motion="reduce"
    )
    opened = context.new_page()
    wrong: list[str] = []
    opened.on("console", lambda line: wrong.append(line.text) if line.type == "error" else None)
    opened.on("pageerror", lambda error: wrong.append(str(error)))
    opened.on("request", lambda made: wrong.append(made.url) if "//127.0.0.1:" not in made.url else None)
    yield opened
    context.close()
    assert [line for line in wrong if not any(word in line for word in EXPECTED)] == []


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    """A page on which nothing may be wrong."""
    with seat(browser) as opened:
        yield opened
