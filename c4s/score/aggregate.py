"""From case rows to model scores and ranks: pooled case means (scorer fact 7; paper, "Score Aggregation")."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from c4s.case.package import SETTINGS, Setting
from c4s.errors import BadInput
from c4s.score.numbers import mean
from c4s.score.policy import I2S_POLICY, MODEL_POLICY, MODEL_WEIGHTS

ZERO_STATUSES = frozenset({"zero_invalid_candidate", "zero_missing_submission", "zero_missing_result"})
MEASURED_STATUSES = frozenset({"measured", "measured_with_missing_zero"})
_T2S, _INDOOR, _OUTDOOR = SETTINGS
_ALIASES: dict[str, Setting] = {
    "text-to-scene": _T2S, "t2s": _T2S,
    "image-to-scene/indoor": _INDOOR, "indoor": _INDOOR, "i2s-indoor": _INDOOR, "image-to-scene-indoor": _INDOOR,
    "image-to-scene/outdoor": _OUTDOOR, "outdoor": _OUTDOOR, "i2s-outdoor": _OUTDOOR,
    "image-to-scene-outdoor": _OUTDOOR}
_RATES = {"f1": "repair_f1", "precision": "precision", "recall": "recall", "physics": "physics"}


def setting_of(text: Any) -> Setting:
    """A setting by its name or a published short form, in any case. Raises ``BadInput``."""
    key = str(text or "").strip().lower().replace("_", "-")
    if key not in _ALIASES:
        raise BadInput(f"unknown setting {text!r}", todo=f"one of {', '.join(SETTINGS)}")
    return _ALIASES[key]


@dataclass(frozen=True, slots=True)
class CaseRow:
    """One scheduled contribution of a model. ``score`` is None while it is not resolved."""

    model: str
    setting: Setting
    case_id: str
    zero: bool
    score: float | None
    rates: Mapping[str, float | None]
    """``repair_f1``, ``precision``, ``recall``, ``physics``; zeros for a zero row, None where absent."""


def _number(value: Any, name: str, where: str) -> float:
    try:
        number = math.nan if isinstance(value, bool) else float(value)
    except (TypeError, ValueError, OverflowError):
        number = math.nan
    if not 0 <= number <= 1:
        raise BadInput(f"{name} is outside [0, 1]: {value!r}", where=where)
    return number


def _rate(value: Any, name: str, where: str) -> float | None:
    return None if value is None or value == "" else _number(value, name, where)


def _case_row(row: Mapping[str, Any]) -> CaseRow:
    model, case_id = str(row.get("model") or "").strip(), str(row.get("case_id") or "").strip()
    if not model or not case_id:
        raise BadInput("a case row needs 'model' and 'case_id'")
    where = f"{model}/{case_id}"
    status = str(row.get("status") or "measured")
    if status in ZERO_STATUSES:
        if row.get("score") is not None:
            _number(row["score"], "score", where)
        return CaseRow(model, setting_of(row.get("setting")), case_id, True, 0.0, dict.fromkeys(_RATES.values(), 0.0))
    score = _number(row.get("score"), "score", where)
    rates = {name: _rate(row.get(name), name, where) for name in _RATES.values()}
    if status not in MEASURED_STATUSES:
        return CaseRow(model, setting_of(row.get("setting")), case_id, False, None, dict.fromkeys(rates))
    return CaseRow(model, setting_of(row.get("setting")), case_id, False, score, rates)


def _schedule(given: Mapping[str, Sequence[str]] | None, rows: Iterable[CaseRow]) -> dict[Setting, list[str]]:
    """Case ids by setting: as scheduled, else all that any model has."""
    schedule: dict[Setting, list[str]] = {}
    if given is None:
        seen: dict[Setting, set[str]] = defaultdict(set)
        for row in rows:
            seen[row.setting].add(row.case_id)
        return {setting: sorted(seen[setting]) for setting in SETTINGS if setting in seen}
    for name, cases in given.items():
        setting = setting_of(name)
        if not cases:
            raise BadInput(f"the schedule of {setting} is empty")
        if len(set(cases)) != len(cases):
            raise BadInput(f"the schedule of {setting} names a case twice")
        schedule[setting] = list(cases)
    return schedule


def _pool(*groups: Sequence[float] | None) -> float | None:
    """Mean over several groups of case values, each case once; None when a group is not complete."""
    means = [(len(group), mean(group)) for group in groups if group]
    if len(means) < len(groups):
        return None
    return sum(size * value for size, value in means) / sum(size for size, _ in means)


def _percent(value: float | None) -> float | None:
    return None if value is None else 100 * value


def _complete(values: Iterable[float | None]) -> list[float] | None:
    items = list(values)
    known = [value for value in items if value is not None]
    return known if len(known) == len(items) else None


def _model_row(model: str, schedule: Mapping[Setting, Sequence[str]], rows: Mapping[tuple[Setting, str], CaseRow],
               missing_as_zero: bool) -> dict[str, Any]:
    contributions: dict[Setting, list[CaseRow]] = {}
    unresolved: list[str] = []
    for setting in SETTINGS:
        contributions[setting] = []
        for case_id in schedule.get(setting, ()):
            row = rows.get((setting, case_id)) or CaseRow(
                model, setting, case_id, missing_as_zero, 0.0 if missing_as_zero else None,
                dict.fromkeys(_RATES.values(), 0.0 if missing_as_zero else None))
            contributions[setting].append(row)
            if row.score is None:
                unresolved.append(f"{setting}:{case_id}")
    scores = {setting: _complete(row.score for row in contributions[setting]) or None for setting in SETTINGS}
    means = {setting: mean(values) if values else None for setting, values in scores.items()}

    def rate(name: str, *settings: Setting) -> float | None:
        return _pool(*(_complete(row.rates[name] for row in contributions[setting]) for setting in settings))

    i2s = _pool(scores[_INDOOR], scores[_OUTDOOR])
    t2s = means[_T2S]
    total = (None if t2s is None or i2s is None else MODEL_WEIGHTS["t2s"] * t2s + MODEL_WEIGHTS["i2s"] * i2s)
    return {
        "model": model, "model_score": total, "model_score_100": _percent(total), "t2s_score": t2s, "i2s_score": i2s,
        "i2s_score_100": _percent(i2s), "indoor_i2s_score": means[_INDOOR], "outdoor_i2s_score": means[_OUTDOOR],
        "indoor_f1_case_macro": rate("repair_f1", _INDOOR), "outdoor_f1_case_macro": rate("repair_f1", _OUTDOOR),
        **{f"i2s_{short}_case_macro": rate(name, _INDOOR, _OUTDOOR) for short, name in _RATES.items()},
        "indoor_physics_case_macro": rate("physics", _INDOOR), "outdoor_physics_case_macro": rate("physics", _OUTDOOR),
        **{f"{short}_cases": len(contributions[setting])
           for short, setting in (("t2s", _T2S), ("indoor", _INDOOR), ("outdoor", _OUTDOOR))},
        **{f"{short}_zero_cases": sum(row.zero for row in contributions[setting])
           for short, setting in (("t2s", _T2S), ("indoor", _INDOOR), ("outdoor", _OUTDOOR))},
        "unresolved_cases": unresolved, "i2s_policy": I2S_POLICY, "model_policy": MODEL_POLICY}


def ranks(values: Sequence[float | None]) -> list[int | None]:
    """Competition ranks: one plus the number of strictly greater values; equal values share one, None has none."""
    known = [value for value in values if value is not None]
    return [None if value is None else 1 + sum(other > value for other in known) for value in values]


def aggregate(rows: Iterable[Mapping[str, Any]], schedule: Mapping[str, Sequence[str]] | None = None,
              missing_as_zero: bool = True) -> list[dict[str, Any]]:
    """Model scores of case rows, best first.

    A setting with an unresolved case has no mean, and what needs it has none either: missing results are never
    dropped. ``model_score`` is unrounded.

    Args:
        rows: ``{"model", "setting", "case_id", "status", "score"}`` and optionally ``repair_f1``, ``precision``,
            ``recall``, ``physics``. Statuses that force a zero do so whatever the score says.
        schedule: case ids by setting; None takes every case that any model has.
        missing_as_zero: a scheduled case without a row is a zero; else it is unresolved.

    Raises:
        BadInput: a row twice, a row that is not scheduled, an unknown setting, or a score outside [0, 1].
    """
    parsed = [_case_row(row) for row in rows]
    cases = _schedule(schedule, parsed)
    models: dict[str, dict[tuple[Setting, str], CaseRow]] = defaultdict(dict)
    for row in parsed:
        key, where = (row.setting, row.case_id), f"{row.model} / {row.setting} / {row.case_id}"
        if key in models[row.model]:
            raise BadInput("duplicate case row", where=where)
        if row.case_id not in cases.get(row.setting, ()):
            raise BadInput("this case is not scheduled", where=where)
        models[row.model][key] = row
    table = [_model_row(model, cases, found, missing_as_zero) for model, found in models.items()]
    for name, score in (("model_rank", "model_score"), ("i2s_rank", "i2s_score")):
        for line, rank in zip(table, ranks([line[score] for line in table]), strict=True):
            line[name] = rank
    return sorted(table, key=lambda line: (line["model_score"] is None, -(line["model_score"] or 0.0), line["model"]))
