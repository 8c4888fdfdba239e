"""Stage 1, the rule judge and the whole ladder on the claims of known truth, the ladder with an endpoint that answers
from that truth: it must reach 1.000, or the ladder loses something.

``python -m bench.judges [--out FILE] [SCENE ...]`` prints the table, and what the ladder loses claim by claim.
"""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

from bench.truth_endpoint import truth_endpoint
from c4s.judge.check.outcome import Outcome
from c4s.judge.check.report import CheckReport
from c4s.judge.model.endpoints import URL_VARIABLE
from c4s.judge.names import judge_configuration
from c4s.records.judge import JudgeConfiguration
from cases.judge_check.evidence import shown
from cases.judge_check.running import check_judge
from cases.judge_check.truth import Truth

LADDER = "truth-on-the-ladder"


def checked(scenes: list[str]) -> tuple[CheckReport, list[Outcome]]:
    """The report of the ladder over the truth, and the outcomes that are not right."""
    truth = Truth(shown(scenes, lambda line: print(line, file=sys.stderr)))
    told = {**judge_configuration("qwen3.8-27b").plain(), "name": LADDER, "model": "truth"}
    wrong: list[Outcome] = []
    before = os.environ.get(URL_VARIABLE)
    with truth_endpoint(truth) as url:
        os.environ[URL_VARIABLE] = url
        try:
            report = check_judge(
                JudgeConfiguration.model_validate(told),
                scenes,
                with_probes=False,
                step=lambda what, *_: print(what, file=sys.stderr),
                heard=lambda name, rows: wrong.extend(row for row in rows if name == LADDER and not row.right),
            )
        finally:
            if before is None:
                del os.environ[URL_VARIABLE]
            else:
                os.environ[URL_VARIABLE] = before
    return report, wrong


def main() -> int:
    """Print the table; 1 where the ladder loses something."""
    parser = argparse.ArgumentParser(prog="python -m bench.judges", description=__doc__)
    parser.add_argument("--out", type=Path)
    parser.add_argument("scene", nargs="*")
    given = parser.parse_args()
    report, wrong = checked(given.scene)
    if given.out:
        report.write(given.out)
    print("| judge | n | accuracy | coverage | right of decided | false accepts | false rejects | pairs both right |")
    print("|---|---:|---:|---:|---:|---:|---:|---:|")
    for name, found in report.judges.items():
        rates = found.all
        decided = "–" if rates.accuracy_decided is None else f"{rates.accuracy_decided:.3f}"
        print(
            f"| {name} | {rates.claims} | {rates.accuracy:.3f} | {rates.decided / rates.claims:.3f} | {decided} | "
            f"{rates.false_accepts} | {rates.false_rejects} | {found.pairs_right}/{found.pairs} |"
        )
    for row in wrong:
        print(f"{row.stage}: {row.scene}/{row.variant} {row.text!r} is {row.holds}, answered {row.answer}")
    own = report.judges[LADDER].all
    return int(own.accuracy < 1.0)


if __name__ == "__main__":
    sys.exit(main())
