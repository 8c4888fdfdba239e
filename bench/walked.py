"""``python -m bench.walked RUN [RUN ...]``: the Embodied Utility Score of every trial of some runs, as tables.

RUN is a run folder. The first table has a row a case and a column a configuration: EUS, ``–`` where a trial saved no
scene, and the reason where the score is withheld. Time (of the processor) and memory (the peak of a process of its own)
are of the case's largest scene. The second has a row a configuration: the mean, and how many trials have each advisory.
"""

from __future__ import annotations

import argparse
import multiprocessing
import resource
import time
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import mean

from c4s.files import read_json
from c4s.navigation import measure_snapshot
from c4s.records.folder import RunFolder
from c4s.records.plan import Plan
from c4s.records.verdict import Verdict
from c4s.verify.navigation.verifier import NAVIGATION


@dataclass(frozen=True)
class WalkedTrial:
    """What one trial's verdict says."""

    configuration: str
    case: str
    verdict: Verdict | None
    snapshot: Path

    @property
    def told(self) -> str:
        """EUS, or why there is none."""
        if self.verdict is None:
            return "–"
        if self.verdict.score is None:
            return str(self.verdict.measurements["reason_code"])
        return f"{self.verdict.score:.3f}"


def trials(run: Path) -> Iterator[WalkedTrial]:
    """The first repeat of every trial, in the order of the plan."""
    folder = RunFolder(run)
    plan = Plan.read(folder.plan)
    for configuration in plan.configurations:
        for case in plan.cases:
            trial = folder.trial(configuration.name, case.alias, 1)
            found = trial.verdict(NAVIGATION.name)
            verdict = Verdict.read(found) if found.is_file() else None
            yield WalkedTrial(configuration.name, case.case_id, verdict, trial.evidence.snapshot)


def cost(snapshot: Path) -> tuple[float, float]:
    """Seconds of the processor and the peak in MB, in a process of its own whose kernels are loaded."""
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        return pool.apply(_cost, (snapshot,))


def _cost(snapshot: Path) -> tuple[float, float]:
    read = read_json(snapshot)
    measure_snapshot({**read, "actors": read["actors"][:1]})
    begun = time.process_time()
    measure_snapshot(read)
    return time.process_time() - begun, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def by_case(found: Sequence[WalkedTrial]) -> list[str]:
    """The first table, in Markdown."""
    columns = list(dict.fromkeys(trial.configuration for trial in found))
    rows: dict[str, dict[str, WalkedTrial]] = defaultdict(dict)
    for trial in found:
        rows[trial.case][trial.configuration] = trial
    lines = [f"| Case | {' | '.join(columns)} | Actors | Seconds | MB |", "|---" * (len(columns) + 4) + "|"]
    for case, of in sorted(rows.items()):
        cells = [of[name].told if name in of else "" for name in columns]
        sized = [(trial.verdict.population.get("actors", 0), trial.snapshot) for trial in of.values() if trial.verdict]
        actors, snapshot = max(sized, default=(0, None))
        seconds, megabytes = cost(snapshot) if snapshot is not None else (0.0, 0.0)
        lines.append(f"| {case} | {' | '.join(cells)} | {actors} | {seconds:.2f} | {megabytes:.0f} |")
    return lines


def by_configuration(found: Sequence[WalkedTrial]) -> list[str]:
    """The second table."""
    lines = ["| Configuration | Scored | Mean EUS | Withheld | Advisories |", "|---|---|---|---|---|"]
    of: dict[str, list[Verdict]] = defaultdict(list)
    for trial in found:
        of[trial.configuration] += [trial.verdict] if trial.verdict is not None else []
    for name, verdicts in of.items():
        scores = [verdict.score for verdict in verdicts if verdict.score is not None]
        codes = Counter(note["code"] for verdict in verdicts for note in verdict.advisories)
        told = ", ".join(f"`{code}` {count}" for code, count in sorted(codes.items()))
        average = f"{mean(scores):.3f}" if scores else "–"
        lines.append(f"| `{name}` | {len(scores)} | {average} | {len(verdicts) - len(scores)} | {told} |")
    return lines


def main() -> None:
    """Print both."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("runs", nargs="+", type=Path, metavar="RUN")
    found = [trial for run in parser.parse_args().runs for trial in trials(run)]
    print("\n".join([*by_case(found), "", *by_configuration(found)]))


if __name__ == "__main__":
    main()
