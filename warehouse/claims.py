"""What a judge said of each requirement of a public case, as rows."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from typing import Any

from c4s.files import read_json
from c4s.protocol.bundle import read_requirements
from c4s.records.captures import Captures, ClaimViews
from c4s.records.judgement import Judgements
from c4s.records.plan import Plan
from c4s.records.suite import SuiteFolder, WithheldFolder
from c4s.run.plan import Trial
from warehouse.records import ClaimRow


def claim_rows(trial: Trial, plan: Plan, key: dict[str, Any]) -> Iterator[ClaimRow]:
    """A row a claim, scored ones first; none for a repair and where nothing was judged."""
    path = trial.folder.judgements(plan.judge)
    bundle = WithheldFolder(SuiteFolder(trial.suite).withheld(trial.case.case_id)).requirements
    if not path.is_file() or not bundle.is_file():
        return
    said = Judgements.read(path)
    predicates = read_requirements(read_json(bundle, what="requirement bundle")).predicates
    index = trial.folder.evidence.captures_index
    taken = Captures.read(index).claims if index.is_file() else {}
    asked: dict[str, list[str]] = defaultdict(list)
    for request in said.schedule:
        for claim in request.claims:
            if not request.again:
                asked[claim].append(request.purpose)
    for scored, claims in ((True, said.claims), (False, said.beneath)):
        for made in claims:
            of, views = predicates.get(made.claim), taken.get(made.claim, ClaimViews())
            yield ClaimRow(
                **key,
                claim=made.claim,
                text=of.text if of else "",
                kind=of.type if of else "",
                scored=scored,
                answer=made.answer,
                score=made.score,
                confidence=made.confidence,
                reason=made.reason,
                stage=made.stage,
                fallback=made.fallback,
                asked=" ".join(asked[made.claim]),
                shown=" ".join(made.views),
                cited=" ".join(made.cited),
                primary=" ".join(views.primary),
                alternate=" ".join(views.alternate),
                targets=views.coverage.targets or len(made.actors),
                seen=made.seen_actors,
            )
