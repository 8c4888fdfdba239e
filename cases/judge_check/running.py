"""A check: a judge over all variants of all stages, plainly and as the probes have it, with the floors beside it.

What a judge said is kept in ``C4S_HOME/cache/judge-check/said/<key>.json``, by the judge's version, the probe and the
evidence, so that a check goes on where it was stopped.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from c4s.errors import unknown
from c4s.files import digest, digest_file
from c4s.home import cache_root
from c4s.judge.check.outcome import Key, Outcome
from c4s.judge.check.report import CheckCost, CheckReport
from c4s.judge.check.scoring import agreement, persuaded, score
from c4s.judge.desk import Desk
from c4s.judge.model.endpoints import served
from c4s.judge.registry import is_online, judge_version, make_judgements
from c4s.protocol.bundle import read_requirements
from c4s.records.evidence import Evidence
from c4s.records.judge import RULE_JUDGE, JudgeConfiguration
from c4s.records.judgement import ClaimJudgement, Judgements, JudgeUsage
from c4s.semantics.state import StateDecider
from cases.judge_check import probes
from cases.judge_check.evidence import ROOM, Shown, shown
from cases.judge_check.model import VARIANTS, Variant
from cases.judge_check.probes import Probe, probed
from cases.judge_check.stages import STAGES

YES, TEXT_ONLY, STATE = "always yes", "text only", "stage 1"
"""Floors: a judge that says yes to everything, the judge without pictures and state, and what state alone decides."""
PROBED: Final[Variant] = "edited"
"""The variant that the probes are made of."""
Heard = Callable[[str, Sequence[Outcome]], None]
Step = Callable[[str, int, int], None]
"""Told what is done, how many of the check's steps are done, and how many there are."""


@dataclass
class _Round:
    """One judge at work."""

    configuration: JudgeConfiguration
    seconds: float = 0.0
    reused: int = 0
    usages: list[JudgeUsage | None] = field(default_factory=list)

    def judged(self, given: Evidence, kept_as: Sequence[str]) -> Judgements:
        """What the judge says of evidence, from an earlier check where it lies there."""
        key = digest([judge_version(self.configuration), digest_file(Path(probes.__file__)), *kept_as])
        place = cache_root() / ROOM / "said" / f"{key}.json"
        if place.is_file():
            self.reused += 1
            made = Judgements.read(place)
            self.usages.append(made.usage)
            return made
        started = time.perf_counter()
        made = make_judgements(self.configuration, given, Desk())
        self.seconds += time.perf_counter() - started
        place.parent.mkdir(parents=True, exist_ok=True)
        made.write(place)
        self.usages.append(made.usage)
        return made

    def cost(self) -> CheckCost:
        """What was taken since this was asked last."""
        used = [one for one in self.usages if one]
        costs = [one.cost_usd for one in used if one.cost_usd is not None]
        taken = CheckCost(
            seconds=round(self.seconds, 3),
            requests=sum(one.requests for one in used),
            input_tokens=sum(one.input_tokens for one in used),
            output_tokens=sum(one.output_tokens for one in used),
            cost_usd=sum(costs) if len(costs) == len(used) else None,
            reused=self.reused,
        )
        self.seconds, self.reused, self.usages = 0.0, 0, []
        return taken


def check_judge(
    configuration: JudgeConfiguration,
    stages: Sequence[str] = (),
    *,
    with_probes: bool = True,
    step: Step = lambda *_: None,
    heard: Heard = lambda *_: None,
) -> CheckReport:
    """Check a judge on the stages of these names, all where none is named. ``BadInput`` for an unknown name, and
    for a model whose endpoint is not described.

    ``heard`` is told all outcomes of each judge and floor, by its name.

    Raises what the judge raises; what it has said by then is kept.
    """
    known = [stage.name for stage in STAGES]
    for name in stages:
        if name not in known:
            raise unknown("scene", name, known)
    if is_online(configuration):
        served(configuration)
    asked = [stage for stage in STAGES if not stages or stage.name in stages]
    extra: tuple[Probe, ...] = ("blank", "primary", "alternate", "order", "planted") if with_probes else ("blank",)
    total, done = len(asked) * (2 * len(VARIANTS) + len(extra)), 0

    def tell(what: str) -> None:
        nonlocal done
        step(what, done, total)
        done += 1

    scenes = []
    for scene in shown([stage.name for stage in asked], lambda line: step(line, done, total)):
        tell(f"{scene.name} is there")
        scenes.append(scene)
    work, rule = _Round(configuration), _Round(RULE_JUDGE)
    said: dict[str, list[Outcome]] = {name: [] for name in (configuration.name, "rule", YES, STATE)}
    probing: dict[Probe, list[Outcome]] = {probe: [] for probe in extra}
    for scene in scenes:
        tell(f"judging {scene.name}")
        made = work.judged(scene.evidence(), ["plain", scene.folder.name])
        said[configuration.name] += _outcomes(scene, _by_text(scene.evidence(), made.claims))
        if configuration.name != "rule":
            told = rule.judged(scene.evidence(), ["plain", scene.folder.name])
            said["rule"] += _outcomes(scene, _by_text(scene.evidence(), told.claims))
        said[STATE] += _outcomes(scene, _by_text(scene.evidence(), stage_1(scene.evidence())))
    cost = work.cost()
    for scene in scenes:
        if scene.variant != PROBED:
            continue
        for probe in extra:
            tell(f"judging {scene.name}, {probe}")
            with tempfile.TemporaryDirectory() as folder:
                given = probed(probe, scene.evidence(), Path(folder))
                made = work.judged(given, [probe, scene.folder.name])
                rows = _by_text(given, made.claims)
            probing[probe] += _blind(scene, scenes, rows) if probe == "blank" else _outcomes(scene, rows)
    step("done", total, total)
    plain = said[configuration.name]
    said[YES] = [one.model_copy(update={"answer": "MATCH", "confidence": None}) for one in plain]
    said[TEXT_ONLY] = probing["blank"]
    named = [configuration.name, *(["rule"] if configuration.name != "rule" else []), STATE, TEXT_ONLY, YES]
    for name in named:
        heard(name, said[name])
    return CheckReport(
        judge=configuration.name,
        judge_version=judge_version(configuration),
        claims_sha256=digest([[*one.key, one.text, one.holds] for one in plain]),
        scenes=len(asked),
        judges={name: score(said[name]) for name in named},
        views=agreement(probing["primary"], probing["alternate"], _seen_twice(scenes, said[STATE]))
        if with_probes
        else None,
        order=agreement(plain, probing["order"], _open(said[STATE])) if with_probes else None,
        planted=persuaded(plain, probing["planted"]) if with_probes else None,
        cost=cost,
        further=work.cost(),
    )


def stage_1(given: Evidence) -> list[ClaimJudgement]:
    """What state alone decides of evidence."""
    requirements = read_requirements(given.json("requirements"))
    judge = StateDecider(requirements, given.json("candidate_snapshot"), given.catalog())
    found = [(node, judge.decide(node)) for node in requirements.scored]
    return [
        ClaimJudgement(claim=node, answer=made.status, score=made.score, reason=made.reason) for node, made in found
    ]


def _by_text(given: Evidence, claims: Iterable[ClaimJudgement]) -> dict[str, ClaimJudgement]:
    predicates = read_requirements(given.json("requirements")).predicates
    return {predicates[claim.claim].text: claim for claim in claims}


def _outcomes(scene: Shown, rows: Mapping[str, ClaimJudgement]) -> list[Outcome]:
    """The answers to those claims of a scene whose truth on this variant was made."""
    made = []
    for claim in scene.claims:
        for holds, variant in ((True, claim.true_on), (False, claim.false_on)):
            if variant == scene.variant:
                told = rows[claim.row.source_text]
                made.append(
                    Outcome(
                        scene=scene.stage.name,
                        variant=scene.variant,
                        claim=told.claim,
                        kind="existence" if claim.kind == "presence" else claim.kind,
                        text=claim.row.source_text,
                        pair=claim.pair,
                        holds=holds,
                        answer=told.answer,
                        confidence=told.confidence,
                        stage=told.stage,
                    )
                )
    return made


def _blind(scene: Shown, scenes: Sequence[Shown], rows: Mapping[str, ClaimJudgement]) -> list[Outcome]:
    """What was said without seeing anything, as the answer on every variant of the scene."""
    return [one for other in scenes if other.stage is scene.stage for one in _outcomes(other, rows)]


def _open(state: Iterable[Outcome]) -> set[Key]:
    """Claims that state leaves open: what it decides is the same in every round."""
    return {one.key for one in state if not one.decided}


def _seen_twice(scenes: Sequence[Shown], state: Iterable[Outcome]) -> set[Key]:
    """Claims that state leaves open and that have views from two sides."""
    sides = {
        (scene.stage.name, scene.variant, claim)
        for scene in scenes
        for claim, row in scene.evidence().json("captures")["claims"].items()
        if row["primary"] and row["alternate"]
    }
    return _open(state) & sides
