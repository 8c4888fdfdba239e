"""The part of a case page that shows its scenes in three dimensions, and in tables what can be seen there."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass
from typing import Any, Final

from c4s.protocol.baselines import NOOP, ORACLE
from c4s.protocol.settings import is_construction
from reports.frame import Board, SiteContext
from reports.frame.asked import findings, verdicts
from reports.frame.board import Row
from reports.text import slug
from reports.viewer.difference import Difference, differences
from reports.viewer.files import data_file, json_file, scenes_of, shape_files, three_file
from reports.viewer.said import PHYSICAL, Said, said_of_actors
from reports.viewer.walks import walk_of_verdicts
from warehouse.scenes import unpacked

ROWS_SHOWN: Final = 40
"""Rows of a trial's table on the page; the list of the viewer has all."""
START, TRUTH, SUBMISSION = "start", "truth", "submission"
_STANDS: Final = {NOOP: START, ORACLE: TRUTH}
"""Whose walks stand for those of the case's own scenes."""


@dataclass(frozen=True)
class TrialScene:
    """What the page tells of one submission without a script."""

    configuration: str
    repeat: int
    key: str
    """As ``#actor=...&of=<key>`` names it."""
    actors: int
    differences: list[Difference]
    offenders: list[tuple[str, str, str, str]]
    """Label, name, outcome and detail of each finding of physics."""


@dataclass(frozen=True)
class ScenePart:
    """The values of ``case/scene.html.j2``."""

    three: str
    """Paths below the site: of three.js ..."""
    index: str
    """... and of what the viewer loads first."""
    name: str
    """The name under which it is handed over."""
    size_mb: float
    """What a browser reads until the scene of one submission is whole."""
    trials: list[TrialScene]
    compared: bool
    """Whether submissions are compared with the truth: construction has no one true scene."""
    rows_shown: int = ROWS_SHOWN


def scene_part(site: SiteContext, board: Board, case: Row) -> ScenePart | None:
    """Put the scenes of a public case, a row of ``Board.cases``, on the site; None where the warehouse holds none."""
    scenes = scenes_of(site, board, case["case_id"])
    if not scenes:
        return None
    documents = {place: unpacked(row["document"]) for place, row in scenes.items()}
    shapes = shape_files(site, board, _shapes(documents.values()))
    found_of = findings(site.warehouse, board, case["case_id"])
    judged_of = verdicts(site.warehouse, board, case["case_id"])
    compared = not is_construction(case["setting"]) and ("", TRUTH) in scenes
    files = {place: data_file(site, row["document"])[0] for place, row in scenes.items()}
    told, shown = [], []
    walks: dict[str, str] = {}
    for configuration in board.order:
        for trial in case["scores"].get(configuration, []):
            place = (trial["trial_id"], SUBMISSION)
            if place not in scenes:
                continue
            said = said_of_actors(found_of.get(trial["trial_id"], []), judged_of.get(trial["trial_id"], []))
            found = differences(documents["", TRUTH], documents[place], said.pairs) if compared else []
            one = _trial(configuration, trial, documents[place], found, said)
            shown.append(one)
            walk = walk_of_verdicts(judged_of.get(trial["trial_id"], []))
            walk_file = json_file(site, walk)[0] if walk else None
            if walk_file and trial["client"] in _STANDS:
                walks.setdefault(_STANDS[trial["client"]], walk_file)
            told.append(_index(one, files[place], scenes[place]["views"], said) | {"walk": walk_file})
    index = {
        "compared": compared,
        "case": {role: files["", role] for role in (START, TRUTH) if ("", role) in scenes},
        "shapes": {sha256: name for sha256, (name, _) in shapes.items()},
        "trials": told,
        "walks": walks,
    }
    name, path = json_file(site, index)
    three = three_file(site)
    most = max(len(row["document"]) for row in scenes.values()) * (2 if compared else 1)
    size = (site.folder / three).stat().st_size + (site.folder / path).stat().st_size
    size += round((most + sum(bytes_ for _, bytes_ in shapes.values())) * 4 / 3)
    return ScenePart(three, path, name, size / 1e6, shown, compared)


def _shapes(documents: Iterable[Mapping[str, Any]]) -> Iterable[str]:
    for document in documents:
        yield from (mesh[1] for mesh in document["meshes"] if mesh[1])
        yield from (look["texture"] for look in document["materials"] if "texture" in look)


def _trial(
    configuration: str, trial: Row, document: Mapping[str, Any], found: list[Difference], said: Said
) -> TrialScene:
    labels = {actor["name"]: actor["label"] for actor in document["actors"]}
    offenders = [
        (labels.get(name, name), name, outcome, text)
        for name, rows in said.submission.items()
        for _, outcome, text in rows
        if outcome in PHYSICAL
    ]
    key = f"{slug(configuration)}~{trial['repeat']}"
    return TrialScene(configuration, trial["repeat"], key, len(document["actors"]), found, sorted(offenders))


def _index(trial: TrialScene, scene: str, views: str, said: Said) -> dict[str, Any]:
    return {
        "key": trial.key,
        "title": trial.configuration + (f", repeat {trial.repeat}" if trial.repeat > 1 else ""),
        "scene": scene,
        "views": json.loads(views),
        "differences": [{**asdict(one), "told": one.told} for one in trial.differences],
        "said": {SUBMISSION: said.submission, TRUTH: said.truth},
        "pairs": said.pairs,
        "offenders": sorted(
            name for name, rows in said.submission.items() if any(outcome in PHYSICAL for _, outcome, _ in rows)
        ),
    }
