"""From case rows to model scores and ranks: pooled case means (scorer fact 7; paper, "Score Aggregation")."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from c4s.errors import BadInput
from c4s.protocol.numbers import mean
from c4s.protocol.rules import I2S_POLICY, MODEL_POLICY, MODEL_WEIGHTS, PHYSICS_RATE, REPAIR_RATES
from c4s.protocol.settings import SETTING_ALIASES, SETTINGS, Setting

ZERO_STATUSES = frozenset({"zero_invalid_candidate", "zero_missing_submission", "zero_missing_result"})
MEASURED_STATUSES = frozenset({"measured", "measured_with_missing_zero"})
_T2S, _INDOOR, _OUTDOOR = SETTINGS


def setting_of(text: Any) -> Setting:
    """A setting by its name or a published short form, in any case. Raises ``BadInput``."""
    key = str(text or "").strip().lower().replace("_", "-")
    if key not in SETTING_ALIASES:
        raise BadInput(f"unknown setting {text!r}", todo=f"one of {', '.join(SETTINGS)}")
    return SETTING_ALIASES[key]


@dataclass(frozen=True, slots=True)
class CaseRow:
    """One scheduled contribution of a model, as given."""

    setting: Setting
    case_id: str
    status: str
    given: Mapping[str, Any]

    @property
    def zero(self) -> bool:
        """Whether the status forces a zero, whatever the row says."""
        return self.status in ZERO_STATUSES

    @property
    def resolved(self) -> bool:
        """Whether it has a final score."""
        return self.zero or self.status in MEASURED_STATUSES

    def number(self, name: str, where: str) -> float | None:
        """``score`` or a rate: zero for a zero row, None for a rate that is not given. Raises ``BadInput``."""
        if self.zero:
            return 0.0
        value = self.given.get(name)
        return None if name != "score" and value in (None, "") else _number(value, name, where)


def _number(value: Any, name: str, where: str) -> float:
    try:
        number = math.nan if isinstance(value, bool) else float(value)
    except (TypeError, ValueError, OverflowError):
        number = math.nan
    if not 0 <= number <= 1:
        raise BadInput(f"{name} is outside [0, 1]: {value!r}", where=where)
    return number


def _case_row(row: Any) -> tuple[str, CaseRow]:
    if not isinstance(row, Mapping):
        raise BadInput("a case row must be a JSON object")
    missing = [name for name in ("model", "case_id", "setting") if row.get(name) in (None, "")]
    if missing:
        raise BadInput(f"a case row needs {', '.join(missing)}")
    return str(row["model"]), CaseRow(
        setting_of(row["setting"]), str(row["case_id"]), str(row.get("status") or "measured"), row
    )


def _schedule(given: Mapping[str, Sequence[str]] | None, rows: Iterable[CaseRow]) -> dict[Setting, list[str]]:
    """Case ids by setting: as scheduled, else all that any model has."""
    schedule: dict[Setting, list[str]] = {}
    if given is not None and not isinstance(given, Mapping):
        raise BadInput("a schedule must be case ids by setting")
    if given is None:
        seen: dict[Setting, set[str]] = defaultdict(set)
        for row in rows:
            seen[row.setting].add(row.case_id)
        return {setting: sorted(seen[setting]) for setting in SETTINGS if setting in seen}
    for name, cases in given.items():
        setting = setting_of(name)
        if not isinstance(cases, (list, tuple)) or not cases or not all(isinstance(case, str) for case in cases):
            raise BadInput(f"the schedule of {setting} must be a list of case ids that is not empty")
        if len(set(cases)) != len(cases):
            raise BadInput(f"the schedule of {setting} names a case twice")
        schedule[setting] = list(cases)
    return schedule


def _pool(*groups: Sequence[float] | None) -> float | None:
    """Mean over one or several groups of case values, each case once; None when a group is not complete."""
    means = [(len(group), mean(group)) for group in groups if group]
    if len(means) < len(groups):
        return None
    if len(means) == 1:
        return means[0][1]
    return math.fsum(size * value for size, value in means) / sum(size for size, _ in means)


def _percent(value: float | None) -> float | None:
    return None if value is None else 100 * value


def _complete(values: Iterable[float | None]) -> list[float] | None:
    items = list(values)
    known = [value for value in items if value is not None]
    return known if len(known) == len(items) else None


def _values(rows: Sequence[CaseRow], model: str) -> dict[str, list[float] | None]:
    """Scores and rates of a setting's rows; None for what is not complete. Every score must be a number in [0, 1]."""
    scores = [row.number("score", f"{model}/{row.case_id}") for row in rows]
    if not rows or not all(row.resolved for row in rows):
        return dict.fromkeys(("score", *REPAIR_RATES.values()))
    rates = (
        {name: _complete(row.number(name, f"{model}/{row.case_id}") for row in rows) for name in REPAIR_RATES.values()}
        if rows[0].setting != _T2S
        else {}
    )
    return dict.fromkeys(REPAIR_RATES.values()) | rates | {"score": _complete(scores)}


def _model_row(
    model: str,
    schedule: Mapping[Setting, Sequence[str]],
    rows: Mapping[tuple[Setting, str], CaseRow],
    missing_as_zero: bool,
) -> dict[str, Any]:
    absent = "zero_missing_result" if missing_as_zero else "unresolved"
    contributions: dict[Setting, list[CaseRow]] = {setting: [] for setting in SETTINGS}
    for setting, cases in schedule.items():
        contributions[setting] = [
            rows.get((setting, case_id)) or CaseRow(setting, case_id, absent, {"score": 0.0}) for case_id in cases
        ]
    unresolved = [
        f"{setting}:{row.case_id}" for setting in schedule for row in contributions[setting] if not row.resolved
    ]
    values = {setting: _values(contributions[setting], model) for setting in SETTINGS}

    def rate(name: str, *settings: Setting) -> float | None:
        return _pool(*(values[setting][name] for setting in settings))

    t2s, i2s = rate("score", _T2S), rate("score", _INDOOR, _OUTDOOR)
    total = None if t2s is None or i2s is None else MODEL_WEIGHTS["t2s"] * t2s + MODEL_WEIGHTS["i2s"] * i2s
    return {
        "model": model,
        "model_score": total,
        "model_score_100": _percent(total),
        "t2s_score": t2s,
        "i2s_score": i2s,
        "i2s_score_100": _percent(i2s),
        "indoor_i2s_score": rate("score", _INDOOR),
        "outdoor_i2s_score": rate("score", _OUTDOOR),
        "indoor_f1_case_macro": rate("repair_f1", _INDOOR),
        "outdoor_f1_case_macro": rate("repair_f1", _OUTDOOR),
        **{f"i2s_{short}_case_macro": rate(name, _INDOOR, _OUTDOOR) for short, name in REPAIR_RATES.items()},
        "indoor_physics_case_macro": rate(PHYSICS_RATE, _INDOOR),
        "outdoor_physics_case_macro": rate(PHYSICS_RATE, _OUTDOOR),
        **{
            f"{short}_cases": len(contributions[setting])
            for short, setting in (("t2s", _T2S), ("indoor", _INDOOR), ("outdoor", _OUTDOOR))
        },
        **{
            f"{short}_zero_cases": sum(row.zero for row in contributions[setting])
            for short, setting in (("t2s", _T2S), ("indoor", _INDOOR), ("outdoor", _OUTDOOR))
        },
        "unresolved_cases": unresolved,
        "i2s_policy": I2S_POLICY,
        "model_policy": MODEL_POLICY,
    }


def ranks(values: Sequence[float | None]) -> list[int | None]:
    """Competition ranks: one plus the number of strictly greater values; equal values share one, None has none."""
    known = [value for value in values if value is not None]
    return [None if value is None else 1 + sum(other > value for other in known) for value in values]


def aggregate(
    rows: Sequence[Mapping[str, Any]], schedule: Mapping[str, Sequence[str]] | None = None, missing_as_zero: bool = True
) -> list[dict[str, Any]]:
    """Model scores of case rows, best first.

    A setting with an unresolved case has no mean, and what needs it has none either: missing results are never
    dropped. ``model_score`` is unrounded.

    Args:
        rows: ``{"model", "setting", "case_id", "status", "score"}`` and optionally ``repair_f1``, ``precision``,
            ``recall``, ``physics``. Statuses that force a zero do so whatever the score says.
        schedule: case ids by setting; None takes every case that any model has. Rows of a setting that is not
            scheduled at all do not count.
        missing_as_zero: a scheduled case without a row is a zero; else it is unresolved.

    Raises:
        BadInput: a row twice, a case that its setting's schedule lacks, an unknown setting, or a score outside [0, 1].
    """
    if not isinstance(rows, (list, tuple)):
        raise BadInput("case rows must be a list")
    parsed = [_case_row(row) for row in rows]
    cases = _schedule(schedule, (row for _, row in parsed))
    models: dict[str, dict[tuple[Setting, str], CaseRow]] = defaultdict(dict)
    for model, row in parsed:
        key, where = (row.setting, row.case_id), f"{model} / {row.setting} / {row.case_id}"
        if key in models[model]:
            raise BadInput("duplicate case row", where=where)
        if row.setting in cases and row.case_id not in cases[row.setting]:
            raise BadInput("this case is not scheduled", where=where)
        models[model][key] = row
    table = [_model_row(model, cases, found, missing_as_zero) for model, found in models.items()]
    for name, score in (("model_rank", "model_score"), ("i2s_rank", "i2s_score")):
        for line, rank in zip(table, ranks([line[score] for line in table]), strict=True):
            line[name] = rank
    return sorted(table, key=lambda line: (line["model_score"] is None, -(line["model_score"] or 0.0), line["model"]))
