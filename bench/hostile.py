"""A judge against a hostile model endpoint at 64 requests at once: scores lost, scores invented, and what it took.

The endpoint knows the truth of 400 claims. Before it tells it, it is silent, rate-limited, broken, overloaded, cut off,
malformed, contradictory and persuaded, by turns and for every request (``tests/judge/hostile_endpoint.py``). The rival
is the same judge on the same endpoint when it behaves. Waits between tries are left out.
"""

from __future__ import annotations

import os
import tempfile
import time
from pathlib import Path

import yaml

from bench.row import Row
from c4s.records.judgement import Judgements
from tests.judge.hostile_endpoint import Hostile
from tests.judge.judge_endpoint import JudgeEndpoint, Truth
from tests.judge.model_evidence import Claim, evidence, judged

CLAIMS, PARALLEL, SILENCE_S = 400, 64, 2.0


def rows() -> list[Row]:
    """Lost and invented scores, and the time against an endpoint that behaves."""
    claims = [Claim(f"p{number}", f"part {number} is there") for number in range(CLAIMS)]
    met = {claim.text: number % 3 > 0 for number, claim in enumerate(claims)}
    truth = Truth(met, lambda purpose, claim: str(claim["requirement"]).endswith("7 is there"))
    hostile = Hostile(truth)
    calm_s, _ = _judged(claims, JudgeEndpoint(truth))
    worst_s, made = _judged(claims, JudgeEndpoint(hostile))
    hostile.release.set()
    wanted = {claim.id: "MATCH" if met[claim.text] else "MISMATCH" for claim in claims}
    lost = sum(claim.answer not in ("MATCH", "MISMATCH") for claim in made.claims)
    invented = sum(
        claim.answer in ("MATCH", "MISMATCH") and claim.answer != wanted[claim.claim] for claim in made.claims
    )
    failures = 0 if made.usage is None else made.usage.failures
    asked = f"{len(made.schedule)} requests, {failures} of their tries failed, {PARALLEL} at once"
    return [
        Row(f"scores lost to a hostile judge endpoint ({asked})", lost, "0", lost == 0, "claims"),
        Row("scores invented by it", invented, "0", invented == 0, "claims"),
        Row("time to judge 400 claims on it", worst_s, "it ends", True, "s", "an endpoint that behaves", calm_s),
    ]


def _judged(claims: list[Claim], endpoint: JudgeEndpoint) -> tuple[float, Judgements]:
    """Judge the claims one by one in a home of its own."""
    before = os.environ.get("C4S_HOME")
    with tempfile.TemporaryDirectory(prefix="c4s-hostile-") as name, endpoint:
        os.environ["C4S_HOME"] = name
        row = {"url": endpoint.url, "formats": ["openai-chat"], "parallel": PARALLEL}
        Path(name, "endpoints.yaml").write_text(yaml.safe_dump({"endpoints": {"judge": row}}))
        started = time.perf_counter()
        try:
            made = judged(evidence(Path(name, "evidence"), claims), claims_per_request=1, timeout_s=SILENCE_S)
        finally:
            os.environ.pop("C4S_HOME")
            if before is not None:
                os.environ["C4S_HOME"] = before
        return time.perf_counter() - started, made
