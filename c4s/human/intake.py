"""Answers of annotators taken in: every line is held against the study's design, and all are taken or none."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from c4s.errors import BadInput, unknown
from c4s.files import json_text, read_json_lines, write_text
from c4s.human.study import RANKINGS, OpenStudy
from c4s.protocol.criteria import PRIMARY
from c4s.records.human import HumanRanking, Part

Key = tuple[str, str, str]
"""Task, annotator, criterion."""


@dataclass(frozen=True)
class IntakeFault:
    """Why a line cannot be taken; lines count from 1."""

    line: int
    fault: str


@dataclass(frozen=True)
class TakenRankings:
    """What came of a file."""

    faults: list[IntakeFault]
    """Where there is one, nothing was taken."""
    taken: int
    there: int
    """Answers that were there already, word for word."""
    missing: dict[Part, int]
    """Primary rankings that are still missing."""


def take(opened: OpenStudy, file: Path) -> TakenRankings:
    """Check a file of JSON lines, one ranking each, and keep them where all can be taken.

    Raises:
        BadInput: the file is none of JSON lines, or the holdout of the study is open.
    """
    if opened.is_opened():
        raise BadInput("the holdout of this study is open: no ranking is taken any more", where=opened.study.study)
    kept: dict[Part, dict[Key, HumanRanking]] = {
        part: {_key(row): row for row in opened.rankings(part)} for part in ("development", "holdout")
    }
    held_out = {prompt.case_id for prompt in opened.study.prompts_of("holdout")}
    cases = {task.task: task.case_id for task in opened.study.tasks}
    faults, taken, there, lines = [], 0, 0, dict[Key, int]()
    for number, row in enumerate(read_json_lines(file, what=RANKINGS), start=1):
        fault = next(_faults(opened, row), "")
        if fault:
            faults.append(IntakeFault(number, fault))
            continue
        ranking = HumanRanking.parse(row)
        part: Part = "holdout" if cases[ranking.task] in held_out else "development"
        key, earlier = _key(ranking), kept[part].get(_key(ranking))
        if key in lines:
            faults.append(IntakeFault(number, f"line {lines[key]} answers the same task"))
        elif earlier is not None and earlier.order != ranking.order:
            faults.append(IntakeFault(number, f"task {ranking.task} has another answer of {ranking.annotator} already"))
        elif earlier is not None:
            there += 1
        else:
            kept[part][key] = ranking
            taken += 1
        lines.setdefault(key, number)
    if not faults:
        for part, rows in kept.items():
            text = "".join(json_text(row.plain(), indent=None) for _, row in sorted(rows.items()))
            write_text(opened.folder.rankings(part), text)
    return TakenRankings(faults, 0 if faults else taken, there, _missing(opened))


def _faults(opened: OpenStudy, row: Mapping[str, Any]) -> Iterator[str]:
    """What is wrong with a line, the first first."""
    study = opened.study
    order = row.get("order")
    if order is None or order == []:
        yield "an abstention: every task asks for a ranking"
    if isinstance(order, list) and any(isinstance(one, list) for one in order):
        yield "a tie: every task asks for a strict ranking"
    try:
        ranking = HumanRanking.parse(row)
    except BadInput as error:
        yield error.line()
        return
    tasks = {task.task: task for task in study.tasks}
    if ranking.study != study.study:
        yield f"it is of the study {ranking.study!r}, not of {study.study!r}"
    if ranking.annotator not in study.annotators:
        yield unknown("annotator", ranking.annotator, study.annotators).line()
    if ranking.task not in tasks:
        yield f"unknown task {ranking.task!r}"
        return
    if ranking.criterion not in study.criteria:
        yield f"the study does not ask for {ranking.criterion!r}"
    task = tasks[ranking.task]
    if ranking.annotator not in task.annotators:
        yield f"task {task.task} is not {ranking.annotator}'s"
    if foreign := [one for one in ranking.order if one not in task.candidates]:
        yield f"candidate {foreign[0]!r} is not in task {task.task}"
    if twice := [one for one in task.candidates if ranking.order.count(one) > 1]:
        yield f"candidate {twice[0]!r} is ranked twice"
    if left := [one for one in task.candidates if one not in ranking.order]:
        yield f"candidate {left[0]!r} is not ranked: a ranking leaves none out"


def _key(row: HumanRanking) -> Key:
    return row.task, row.annotator, row.criterion


def _missing(opened: OpenStudy) -> dict[Part, int]:
    left: dict[Part, int] = {}
    for part in ("development", "holdout"):
        cases = [prompt.case_id for prompt in opened.study.prompts_of(part)]
        primary = sum(row.criterion == PRIMARY for row in opened.rankings(part))
        left[part] = opened.study.expected(cases) - primary
    return left
