"""How firmly the leaderboard stands when its source scenes are drawn again, or one of them is left out (ours)."""

from __future__ import annotations

import numpy as np

from c4s.errors import BadInput
from c4s.records.analysis import Chart, Column, Findings, Intervals, Table, Value
from c4s.stats.bootstrap import Floats, percentile_interval
from c4s.stats.ranks import competition_ranks, settled
from c4s.stats.stability import above_shares, order_agreements, rank_shares
from warehouse.analyses.cases import case_table, intervals_of
from warehouse.analyses.parts import ScoreMean, compared, score_means
from warehouse.analyses.study import RESAMPLING, Frames, StudyDefinition, StudyOptions


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """Ranks of the ranked configurations by the widest mean there is; of all where fewer than two are."""
    table = case_table(frames["trials"], options)
    places = compared(table)
    if len(places) < 2:
        raise BadInput("one configuration has no order", todo="run another agent on the same suite")
    mean = score_means(table)[-1]
    values = table.values("score")[:, places]
    observed = _means(mean, table.design.observed(), values)[0]
    order = np.argsort(-observed, kind="stable")
    names = [table.agents[places[place]] for place in order]
    scores = _Scores(mean, names, observed[order], values[:, order])
    intervals = intervals_of(table.design, options, "source-cluster bootstrap of the leaderboard, percentile")
    drawn = _means(mean, table.design.draw(options.draws, options.seed), scores.values) if intervals.honest else None
    tables = [scores.ranks(drawn), *([] if drawn is None else [scores.shares(drawn)]), scores.left_out(), table.apart]
    charts = [
        Chart(
            name="ranks",
            title=f"Share of draws in which a configuration has a rank ({mean.title})",
            kind="heat",
            table="rank_shares",
            y="configuration",
            series=[f"rank_{rank + 1}" for rank in range(len(names))],
        )
    ]
    return Findings(
        tables=tables,
        charts=charts if drawn is not None else [],
        intervals=[intervals],
        notes=[f"Ordered by: {mean.title}, of {len(places)} configurations.", *_agreement(scores, drawn, intervals)],
    )


class _Scores:
    """Configurations in their observed order."""

    def __init__(self, mean: ScoreMean, names: list[str], observed: Floats, values: Floats) -> None:
        self.mean, self.names, self.observed, self.values = mean, names, observed, values
        self.without = _means(mean, _each_left_out(mean), values)
        """Scores without each source of the mean, shape (sources, configurations)."""

    def ranks(self, drawn: Floats | None) -> Table:
        """Ranks, and how they move."""
        rows: list[dict[str, Value]] = []
        ranks, moved = competition_ranks(self.observed), competition_ranks(self.without)
        for place, name in enumerate(self.names):
            row: dict[str, Value] = {"rank": int(ranks[place]), "configuration": name}
            row |= {"score": float(self.observed[place])}
            row |= {"without_best": int(moved[:, place].min()), "without_worst": int(moved[:, place].max())}
            if drawn is not None:
                shares = rank_shares(drawn)[place]
                row |= {"keeps": float(shares[ranks[place] - 1]), "leads": float(shares[0])}
                row["above_next"] = (
                    float(above_shares(drawn)[place, place + 1]) if place + 1 < len(self.names) else None
                )
            rows.append(row)
        told = [
            Column(name="keeps", title="keeps its rank", unit="share", decimals=3),
            Column(name="leads", title="leads", unit="share", decimals=3),
            Column(name="above_next", title="above the next", unit="share", decimals=3),
        ]
        return Table(
            name="stability",
            title="Ranks when sources are drawn again",
            columns=[
                Column(name="rank", title="rank"),
                Column(name="configuration", title="configuration"),
                Column(name="score", title="score", unit="score", decimals=3),
                *(told if drawn is not None else []),
                Column(name="without_best", title="best rank without a source"),
                Column(name="without_worst", title="worst rank"),
            ],
            rows=rows,
        )

    def shares(self, drawn: Floats) -> Table:
        """A column a rank."""
        shares = rank_shares(drawn)
        ranks = range(len(self.names))
        return Table(
            name="rank_shares",
            title="Share of draws by rank",
            columns=[
                Column(name="configuration", title="configuration"),
                *(Column(name=f"rank_{rank + 1}", title=str(rank + 1), unit="share", decimals=3) for rank in ranks),
            ],
            rows=[
                {"configuration": name} | {f"rank_{rank + 1}": float(shares[place, rank]) for rank in ranks}
                for place, name in enumerate(self.names)
            ],
        )

    def left_out(self) -> Table:
        """Sources without which the order is another one, by how much."""
        design = self.mean.table.design
        own = np.nonzero(self.mean.shares[design.domain_of] > 0)[0]
        agreement = order_agreements(self.observed, self.without)
        leader = self.without.argmax(axis=1)
        rows: list[dict[str, Value]] = [
            {
                "source": str(design.clusters[cluster]),
                "cases": int((design.cluster_of == cluster).sum()),
                "tau": float(agreement[place]),
                "leader": self.names[int(leader[place])],
            }
            for place, cluster in enumerate(own)
            if agreement[place] < 1
        ]
        return Table(
            name="without_source",
            title="Sources without which the order changes",
            columns=[
                Column(name="source", title="source scene left out"),
                Column(name="cases", title="cases"),
                Column(name="tau", title="tau with the whole", decimals=3),
                Column(name="leader", title="leads then"),
            ],
            rows=sorted(rows, key=lambda row: (float(row["tau"] or 0), str(row["source"]))),
        )


def _means(mean: ScoreMean, counts: Floats, values: Floats) -> Floats:
    return settled(mean.means(counts, values))


def _each_left_out(mean: ScoreMean) -> Floats:
    """Counts without each source of the mean; a setting's only source stays."""
    design = mean.table.design
    own = np.nonzero(mean.shares[design.domain_of] > 0)[0]
    counts = np.ones((len(own), len(design.clusters)))
    alone = np.bincount(design.domain_of)[design.domain_of[own]] == 1
    counts[np.arange(len(own)), own] = alone
    return counts


def _agreement(scores: _Scores, drawn: Floats | None, intervals: Intervals) -> list[str]:
    if drawn is None:
        return []
    agreement = order_agreements(scores.observed, drawn)
    low, high = percentile_interval(agreement[:, None], intervals.level)
    return [
        f"Agreement of a drawn leaderboard with this one (tau): {agreement.mean():.3f} on average, "
        f"{intervals.level:.0%} of them between {low[0]:.3f} and {high[0]:.3f}."
    ]


STABILITY = StudyDefinition(
    name="stability",
    title="How firmly the leaderboard stands",
    section="",
    sources={"trials": "SELECT * FROM chosen ORDER BY configuration, case_id, repeat"},
    compute=compute,
    takes=RESAMPLING | {"agents"},
)
