"""A run of the paper's shape, 16 prompts x 7 configurations, with stored verdicts and pictures, and who ranks its
scenes."""

from __future__ import annotations

import json
import random
from collections.abc import Collection
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from bench.scored_run import made_verdict
from c4s.human import OpenStudy
from c4s.protocol.rules import DEFAULT_POLICY, GATE
from c4s.protocol.settings import TEXT_TO_SCENE
from c4s.records.captures import Captures, View, ViewCamera
from c4s.records.folder import RunFolder, TrialFolder
from c4s.records.human import HumanRanking
from c4s.records.plan import Configuration, Plan, PlannedCase
from c4s.records.suite import SuiteFolder
from c4s.records.verdict import Verdict
from c4s.score.case import case_score
from c4s.verify.registry import weighed_of
from cases.code4scene.importer import import_code4scene

PROMPTS = 16
AGENTS = [f"agent-{letter}" for letter in "abcdefgh"]
"""One more than a study shows."""
PALETTE = "=== ASSET PALETTE ===\n\n- box | Box | props | 1x1x1 m | /Game/P/SM_Box.SM_Box\n"


def make_run(home: Path, prompts: int = PROMPTS, agents: list[str] = AGENTS, seed: int = 1) -> Path:
    """A suite of imported tasks below ``home``, and a run of it whose folder is returned."""
    tasks = home / "tasks"
    for number in range(prompts):
        task = tasks / f"place-{number:02}" / "task.yaml"
        task.parent.mkdir(parents=True)
        prompt = json.dumps(f"Place {number}: a yard.\n\n{PALETTE}")
        task.write_text(
            f"id: place-{number:02}\nkind: scene_generation\ninputs:\n  prompt: {prompt}\n"
            "  init_map: /Game/Blank\n  size_m: 200\n  budget: {tool_calls: 10, wall_minutes: 5}\n"
        )
    import_code4scene(tasks, home / "suites" / "places", home / "packs", lambda step: None)
    suite = SuiteFolder(home / "suites" / "places").suite()
    plan = Plan(
        run_id="night",
        suite_id="places",
        suite_digest=suite.sha256(),
        policy=DEFAULT_POLICY,
        judge="rule",
        engine="headless",
        configurations=[Configuration(name=name, client="noop") for name in agents],
        cases=[PlannedCase(scene_id=case.case_id, **case.plain()) for case in suite.cases],
        versions={},
    )
    folder = RunFolder(home / "runs" / "night")
    chance = random.Random(seed)
    for case in plan.cases:
        for name in agents:
            _write(folder.trial(name, case.alias, 1), case.case_id, name, chance)
    plan.write(folder.plan)
    return folder.root


def _write(trial: TrialFolder, case_id: str, configuration: str, chance: random.Random) -> None:
    verdicts = {GATE: Verdict(verifier=GATE, status="valid", policy="made")}
    verdicts |= {one.name: made_verdict(one.name, chance) for one in weighed_of(TEXT_TO_SCENE)}
    for name, verdict in verdicts.items():
        verdict.write(trial.verdict(name))
    score = case_score(
        case_id=case_id,
        setting=TEXT_TO_SCENE,
        configuration=configuration,
        repeat=1,
        judge="rule",
        engine="headless",
        submitted=True,
        verdicts=verdicts,
        policy=DEFAULT_POLICY,
    )
    score.write(trial.score)
    camera = ViewCamera(location_cm=(0, 0, 0), rotation_deg=(0, 0, 0), fov_deg=60, width=8, height=6)
    views = [View(name=f"overview-{n}", file=f"overview-{n}.png", camera=camera) for n in range(1, 5)]
    trial.evidence.captures.mkdir(parents=True)
    for view in views:
        colour = tuple(chance.randrange(256) for _ in range(3))
        Image.new("RGB", (8, 6), colour).save(trial.evidence.captures / view.file)
    Captures(engine="headless", views=views).write(trial.evidence.captures_index)


def answers(
    opened: OpenStudy, worth: dict[str, float], sharpness: float, seed: int = 1, clickers: Collection[str] = ()
) -> list[dict[str, Any]]:
    """What annotators answer to their sheets: Plackett-Luce draws by what candidates are worth to them."""
    chance = np.random.default_rng(seed)
    found = []
    for annotator in opened.study.annotators:
        sheet = json.loads(opened.folder.sheet(annotator).read_text())
        for task in sheet["tasks"]:
            shown = [one["candidate"] for one in task["candidates"]]
            taste = 0.0 if annotator in clickers else sharpness
            order = np.argsort([-(worth[one] * taste + chance.gumbel()) for one in shown])
            ranking = HumanRanking(
                study=sheet["study"],
                annotator=annotator,
                task=task["task"],
                criterion=task["criterion"],
                order=[shown[at] for at in order],
            )
            found.append(ranking.plain())
    return found


def write_answers(path: Path, rows: list[Any]) -> Path:
    """As a file of JSON lines."""
    path.write_text("".join(json.dumps(row) + "\n" for row in rows))
    return path
