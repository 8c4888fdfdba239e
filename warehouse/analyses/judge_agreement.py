"""How far two judges, or two versions of one, agree where they scored the same evidence (ours).

One judge that is asked again, the paper's "Detailed Alignment repeatability", is ``c4s judge repeat``.

Evidence is the same where the listing of its files is, byte for byte.
"""

from __future__ import annotations

from itertools import combinations
from typing import Final

import numpy as np
import pandas as pd

from c4s.errors import BadInput
from c4s.records.analysis import Chart, Column, Findings, Intervals, Table, Value
from c4s.stats.bootstrap import Design, percentile_interval, weighted_means
from c4s.stats.judges import kappa, score_agreement
from c4s.stats.repeats import tau_b
from warehouse.analyses.cases import intervals_of, known_agents
from warehouse.analyses.study import RESAMPLING, Frames, StudyDefinition, StudyOptions

_SAME: Final = ["configuration", "case_id", "repeat", "evidence"]


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """Each two judges on the scenes that both scored."""
    judged = frames["judged"]
    known_agents(judged, options)
    if options.agents:
        judged = judged[judged["configuration"].isin(options.agents)]
    names = sorted(set(judged["judged_by"]))
    if len(names) < 2:
        raise BadInput(
            f"one judge scored this: {names[0]}" if names else "no scored evidence is here",
            todo="score the same runs with another: `c4s run ... --judge OTHER`",
        )
    rows, points, intervals = [], [], list[Intervals]()
    for one, other in combinations(names, 2):
        both = _both(judged, one, other)
        if both.empty:
            continue
        design = Design.of(both["scene_id"].tolist(), both["setting"].tolist())
        made = intervals_of(design, options)
        if made not in intervals:
            intervals.append(made)
        rows.append(_row(both, one, other, design, made) | _missed(judged, both, one, other))
        points += _points(both, one, other)
    if not rows:
        raise BadInput(
            "no two judges scored the same evidence",
            todo="score the same runs with another: `c4s run ... --judge OTHER`",
        )
    decisions = _decisions(frames["decisions"], judged, names)
    return Findings(
        tables=[_agreement(rows), *([decisions] if decisions.rows else []), _scenes(points, rows)],
        charts=[
            Chart(
                name="judges",
                title="Scores of the same scenes by two judges",
                kind="scatter",
                table="scenes",
                x="first",
                y="second",
                group="judges" if len(rows) > 1 else None,
                diagonal=True,
            )
        ],
        intervals=intervals,
        notes=[
            "Of trials whose evidence is the same file by file. Bias: the first judge's mean less the second's. tau-b "
            "of configurations: do both put them in the same order? Alpha (Krippendorff, interval): 1 is full "
            "agreement, 0 what chance gives."
        ],
    )


def _both(judged: pd.DataFrame, one: str, other: str) -> pd.DataFrame:
    """Scenes that both scored, each once, with both scores."""
    sides = [judged[judged["judged_by"] == name].drop_duplicates(_SAME) for name in (one, other)]
    return sides[0].merge(sides[1][[*_SAME, "trial_id", "score"]], on=_SAME, suffixes=("", "_other"))


def _row(both: pd.DataFrame, one: str, other: str, design: Design, how: Intervals) -> dict[str, Value]:
    found = score_agreement(both["score"], both["score_other"])
    means = both.groupby("configuration")[["score", "score_other"]].mean()
    row: dict[str, Value] = {
        "first": one,
        "second": other,
        "scenes": found.things,
        "bias": found.bias,
        "distance": found.distance,
        "equal": found.equal,
        "tau_b": found.tau_b,
        "alpha": found.alpha,
        "configurations": len(means),
        "order": tau_b(means["score"].to_numpy(), means["score_other"].to_numpy()),
    }
    if how.honest:
        shares = design.sizes() / design.sizes().sum()
        differences = (both["score"] - both["score_other"]).to_numpy()
        drawn = weighted_means(design, design.draw(how.draws, how.seed), differences, shares)
        low, high = percentile_interval(drawn, how.level)
        row |= {"bias_low": float(low[0]), "bias_high": float(high[0])}
    return row


def _missed(judged: pd.DataFrame, both: pd.DataFrame, one: str, other: str) -> dict[str, Value]:
    """Trials that both judges scored on different evidence: other attempts, or evidence taken anew."""
    keys = _SAME[:-1]
    sides = [judged[judged["judged_by"] == name][keys].drop_duplicates() for name in (one, other)]
    return {"other_evidence": len(sides[0].merge(sides[1], on=keys)) - len(both[keys].drop_duplicates())}


def _points(both: pd.DataFrame, one: str, other: str) -> list[dict[str, Value]]:
    return [
        {
            "judges": f"{one} – {other}",
            "scene": f"{row['configuration']}, {row['case_id']}, {row['repeat']}",
            "first": float(row["score"]),
            "second": float(row["score_other"]),
        }
        for row in both.sort_values(_SAME).to_dict("records")
    ]


def _decisions(decisions: pd.DataFrame, judged: pd.DataFrame, names: list[str]) -> Table:
    """How often two judges decide alike on the same requirement of the same evidence, by verifier."""
    rows: list[dict[str, Value]] = []
    told = decisions.merge(judged[["trial_id", "judged_by", *_SAME]], on="trial_id")
    told["place"] = told.groupby(["trial_id", "verifier", "subject"]).cumcount()
    keys = [*_SAME, "verifier", "subject", "place"]
    for one, other in combinations(names, 2):
        sides = [told[told["judged_by"] == name].drop_duplicates(keys) for name in (one, other)]
        pairs = sides[0].merge(sides[1][[*keys, "outcome"]], on=keys, suffixes=("", "_other"))
        for verifier, own in pairs.groupby("verifier"):
            answers = sorted({*own["outcome"], *own["outcome_other"]})
            counts = (
                pd.crosstab(own["outcome"], own["outcome_other"])
                .reindex(index=answers, columns=answers, fill_value=0)
                .to_numpy(dtype=np.int64)
            )
            rows.append(
                {
                    "first": one,
                    "second": other,
                    "verifier": str(verifier),
                    "decisions": len(own),
                    "alike": float((own["outcome"] == own["outcome_other"]).mean()),
                    "kappa": kappa(counts),
                    "turned": ", ".join(
                        f"{answers[row]} to {answers[column]} {int(counts[row, column])}"
                        for row, column in np.argwhere(counts > 0)
                        if row != column
                    ),
                }
            )
    return Table(
        name="decisions",
        title="Decisions on the same requirements",
        columns=[
            Column(name="first", title="first judge"),
            Column(name="second", title="second judge"),
            Column(name="verifier", title="verifier"),
            Column(name="decisions", title="decisions"),
            Column(name="alike", title="alike", unit="share", decimals=3),
            Column(name="kappa", title="Cohen's kappa", decimals=3),
            Column(name="turned", title="not alike, first to second"),
        ],
        rows=rows,
    )


def _agreement(rows: list[dict[str, Value]]) -> Table:
    ends = any("bias_low" in row for row in rows)
    return Table(
        name="agreement",
        title="Agreement of judges on the same evidence",
        columns=[
            Column(name="first", title="first judge"),
            Column(name="second", title="second judge"),
            Column(name="scenes", title="scenes"),
            Column(name="other_evidence", title="on other evidence"),
            Column(name="bias", title="bias", unit="score", decimals=4),
            *(
                [Column(name=f"bias_{end}", title=end, unit="score", decimals=4) for end in ("low", "high")]
                if ends
                else []
            ),
            Column(name="distance", title="mean distance", unit="score", decimals=4),
            Column(name="equal", title="equal", unit="share", decimals=3),
            Column(name="tau_b", title="tau-b of scenes", decimals=3),
            Column(name="alpha", title="alpha", decimals=3),
            Column(name="configurations", title="configurations"),
            Column(name="order", title="tau-b of configurations", decimals=3),
        ],
        rows=rows,
    )


def _scenes(points: list[dict[str, Value]], rows: list[dict[str, Value]]) -> Table:
    return Table(
        name="scenes",
        title="Scores of the same scenes",
        columns=[
            Column(name="judges", title="judges"),
            Column(name="scene", title="configuration, case, repeat"),
            Column(name="first", title=_side(rows, "first"), unit="score", decimals=3),
            Column(name="second", title=_side(rows, "second"), unit="score", decimals=3),
        ],
        rows=points,
    )


def _side(rows: list[dict[str, Value]], name: str) -> str:
    """The judge of an axis, where all scenes are of one pair."""
    return str(rows[0][name]) if len(rows) == 1 else f"{name} judge"


JUDGE_AGREEMENT = StudyDefinition(
    name="judge-agreement",
    title="Agreement of judges on the same evidence",
    section="",
    sources={
        "judged": """
            SELECT c.trial_id, c.configuration, c.setting, c.scene_id, c.case_id, c.repeat, c.score, e.evidence,
                c.judge || ' ' || c.judge_version AS judged_by
            FROM chosen AS c JOIN (
                SELECT trial_id, max(json_extract_string(document, '$.inputs.evidence_listing')) AS evidence
                FROM verdicts GROUP BY trial_id
            ) AS e USING (trial_id)
            WHERE c.score IS NOT NULL AND e.evidence IS NOT NULL
            ORDER BY judged_by, c.configuration, c.case_id, c.repeat""",
        "decisions": """
            SELECT f.trial_id, f.verifier, f.subject, f.outcome FROM chosen AS c JOIN findings AS f USING (trial_id)
            WHERE f.outcome IN ('MATCH', 'MISMATCH', 'UNKNOWN')
            ORDER BY f.trial_id, f.verifier, f.subject, f.outcome""",
    },
    compute=compute,
    takes=RESAMPLING | {"agents"},
    across=frozenset({"judge", "judge_version"}),
)
