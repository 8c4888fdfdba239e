"""The same work for a scene known to be good, before a failure is called the scene's or the agent's.

It is done only where a stage failed twice on a scene, or an attempt has spent its repeats.
"""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from c4s.evidence import open_level
from c4s.files import write_json
from c4s.judge.registry import is_online, make_judgements
from c4s.protocol.rules import GATE
from c4s.records.folder import EvidenceFolder
from c4s.records.plan import Plan
from c4s.run.inputs import TrialInputs, evidence_in
from c4s.run.limits import Stage
from c4s.run.looking import cameras_for
from c4s.run.plan import Trial
from c4s.verify.registry import make_verdict, measure, verifier_named


def same_for_the_start_level(
    trial: Trial, plan: Plan, given: TrialInputs, stage: Stage, verifier: Any = GATE, *_: Any
) -> None:
    """Export the start level; then look at it, judge it and verify it, where the stage does or needs that."""
    needs = verifier_named(verifier).needs if stage == "verify" else frozenset[str]()
    judged = stage == "judge" or "judgements" in needs
    with tempfile.TemporaryDirectory(prefix="c4s-control-") as name:
        exported = EvidenceFolder(Path(name) / "start")
        level = given.agent_folder / "start.level.json"
        with open_level(engine=plan.engine, packs=given.packs, level=level) as clean:
            clean.export(exported.root)
            if judged or stage in ("attempt", "look") or "captures" in needs:
                clean.look(exported.root, cameras_for(given))
        kept = trial.folder.judgements(plan.judge)
        judgements = kept if kept.is_file() else Path(name) / kept.name
        shown = evidence_in(exported, given, judgements)
        if judged and not shown.has("judgements") and not is_online(plan.judge_configuration):
            make_judgements(plan.judge_configuration, shown).write(judgements)
        if stage == "verify":
            for measured, record in measure(verifier, shown).items():
                write_json(shown.path(measured), record, indent=None)
            make_verdict(verifier, shown)
