"""The run folder: the truth about a run. The names of all its files are spelt here and nowhere else."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

SAVES = "saves.jsonl"
"""In a submission: every package that the engine saved, a JSON line each."""

HANDOVER = "handover.json"
"""In a trial's folder: where it stood when the last work pool let go of it."""


def is_result(name: str) -> bool:
    """Whether a file of a trial, by its relative name, is a result that says what is done: outcome, verdict, score."""
    return name == "score.json" or name.startswith("verdicts/") or name.endswith(("/outcome.json", "/integrity.json"))


class EvidenceFolder:
    """What clean engine processes exported from the retained submission: ``<trial>/evidence``."""

    def __init__(self, root: Path) -> None:
        self.root = root

    @property
    def snapshot(self) -> Path:
        """The scene as the exporter records it."""
        return self.root / "snapshot.json"

    @property
    def dependencies(self) -> Path:
        """Packages that the scene refers to, and those that do not resolve."""
        return self.root / "dependencies.json"

    @property
    def contacts(self) -> Path:
        """Which collision bodies overlap, and how deep."""
        return self.root / "contacts.json"

    @property
    def support(self) -> Path:
        """What holds each actor, and how far it is from that."""
        return self.root / "support.json"

    @property
    def navigation(self) -> Path:
        """Where a body can walk, which targets it reaches, and how it walked."""
        return self.root / "navigation.json"

    @property
    def captures(self) -> Path:
        """Folder of the pictures and actor masks."""
        return self.root / "captures"

    @property
    def captures_index(self) -> Path:
        """What was taken: a record a view."""
        return self.captures / "captures.json"

    def digests(self, maker: str) -> Path:
        """SHA-256 of each file that a stage made, by its relative name."""
        return self.root / "digests" / f"{maker}.json"

    @property
    def early_digests(self) -> Path:
        """The one list of all files that c4s wrote before each stage had its own."""
        return self.root / "digests.json"

    def listings(self) -> list[Path]:
        """The lists of digests that are there."""
        found = sorted((self.root / "digests").glob("*.json"))
        return found or [path for path in (self.early_digests,) if path.is_file()]


class AttemptFolder:
    """One attempt: ``<trial>/attempt-<n>``."""

    def __init__(self, root: Path) -> None:
        self.root = root

    @property
    def number(self) -> int:
        """1 or 2."""
        return int(self.root.name.removeprefix("attempt-"))

    @property
    def outcome(self) -> Path:
        """How it ended; written last, so an attempt with it is done."""
        return self.root / "outcome.json"

    @property
    def trajectory(self) -> Path:
        """Every call, a JSON line each."""
        return self.root / "trajectory.jsonl"

    @property
    def usage(self) -> Path:
        """Every model request, a JSON line each."""
        return self.root / "usage.jsonl"

    @property
    def manifest(self) -> Path:
        """Which engine served it, what confined the engine and the agent, digests of the packs."""
        return self.root / "manifest.json"

    @property
    def submission(self) -> Path:
        """The content that the engine saved."""
        return self.root / "submission"

    @property
    def submission_digests(self) -> Path:
        """SHA-256 of each file that the engine saved, to tell which one was changed."""
        return self.root / "submission.digests.json"

    @property
    def saves(self) -> Path:
        """Every package that was saved, a JSON line each."""
        return self.submission / SAVES

    @property
    def images(self) -> Path:
        """Pictures that the agent was shown, by their digest."""
        return self.root / "images"

    @property
    def scratch(self) -> Path:
        """Engine log, job logs, screenshots."""
        return self.root / "scratch"

    @property
    def agent(self) -> Path:
        """The client's own files."""
        return self.root / "agent"

    @property
    def integrity(self) -> Path:
        """The gate's verdict on this attempt."""
        return self.root / "integrity.json"

    @property
    def done(self) -> bool:
        """Whether the attempt has ended and is on record."""
        return self.outcome.is_file()


class TrialFolder:
    """``runs/<run-id>/<agent>/<case>/r<k>``."""

    def __init__(self, root: Path) -> None:
        self.root = root

    def attempt(self, number: int) -> AttemptFolder:
        """Folder of an attempt; attempts count from 1."""
        return AttemptFolder(self.root / f"attempt-{number}")

    def attempts(self) -> list[AttemptFolder]:
        """The attempts that are on record, in order."""
        found = (AttemptFolder(path) for path in self.root.glob("attempt-?"))
        return sorted((attempt for attempt in found if attempt.done), key=lambda attempt: attempt.number)

    @property
    def evidence(self) -> EvidenceFolder:
        """What a clean engine process exported from the retained submission."""
        return EvidenceFolder(self.root / "evidence")

    @property
    def judged(self) -> Path:
        """Folder of what judges said."""
        return self.root / "judgements"

    def judgements(self, judge: str) -> Path:
        """What a judge said of the retained submission."""
        return self.judged / f"{judge}.json"

    def exchanges(self, judge: str) -> Path:
        """Folder of what a judge asked a model and what it answered: files by their digest."""
        return self.judged / judge

    def verdict(self, verifier: str) -> Path:
        """A verifier's report."""
        return self.root / "verdicts" / f"{verifier}.json"

    @property
    def verdicts(self) -> dict[str, Path]:
        """The verdicts that are there, by verifier."""
        return {path.stem: path for path in sorted((self.root / "verdicts").glob("*.json"))}

    @property
    def score(self) -> Path:
        """The trial's score."""
        return self.root / "score.json"

    @property
    def faults(self) -> Path:
        """What left the trial pending, a JSON line each time."""
        return self.root / "faults.jsonl"

    @property
    def leases(self) -> Path:
        """Who works on the trial."""
        return self.root / "lease"

    @property
    def handover(self) -> Path:
        """Where the trial stood when the last work pool let go of it."""
        return self.root / HANDOVER

    @property
    def stages(self) -> Path:
        """How long each stage took, a JSON line each."""
        return self.root / "stages.jsonl"


class RepeatsFolder:
    """Repeats of what a run's judge said: ``<run>/repeatability/<study>``."""

    def __init__(self, root: Path) -> None:
        self.root = root

    @property
    def record(self) -> Path:
        """What the repeats came to; written last."""
        return self.root / "repeatability.json"

    @property
    def picture(self) -> Path:
        """How far each repeat deviates."""
        return self.root / "deviations.svg"

    def scene(self, trial: Path) -> Path:
        """Folder of a scene, by the name of its trial below the run."""
        return self.root / "scenes" / trial

    def repeat(self, trial: Path, number: int) -> Path:
        """What a judge said of a scene in one repeat; repeats count from 1."""
        return self.scene(trial) / f"repeat-{number}.json"

    def answers(self, trial: Path, number: int) -> Path:
        """Answers of a repeat in work."""
        return self.scene(trial) / f"repeat-{number}"

    def exchanges(self, trial: Path) -> Path:
        """What was asked and answered in the repeats of a scene: files by their digest."""
        return self.scene(trial) / "exchanges"


class RunFolder:
    """``runs/<run-id>``."""

    def __init__(self, root: Path) -> None:
        self.root = root

    @property
    def plan(self) -> Path:
        """The frozen plan."""
        return self.root / "plan.json"

    def earlier_plan(self, sha256: str) -> Path:
        """A plan that the run has outgrown."""
        return self.root / "plans" / f"{sha256[:12]}.json"

    @property
    def leases(self) -> Path:
        """Who works on the run."""
        return self.root / "lease"

    @property
    def spending(self) -> Path:
        """What the whole run has spent on models, against its limit."""
        return self.root / "spending.jsonl"

    @property
    def judging(self) -> Path:
        """What the whole run has spent on its judge, against its limits."""
        return self.root / "judging.jsonl"

    @property
    def elsewhere(self) -> Path:
        """What other machines sent of the run: a folder each, laid out as this one."""
        return self.root / "elsewhere"

    def of_machine(self, name: str) -> Path:
        """What one of the other machines sent."""
        return self.elsewhere / name

    @property
    def repeatability(self) -> Path:
        """Folder of the studies of repeats."""
        return self.root / "repeatability"

    def repeats(self, study: str) -> RepeatsFolder:
        """Folder of a study."""
        return RepeatsFolder(self.repeatability / study)

    @property
    def guards(self) -> Path:
        """What may stop the whole run."""
        return self.root / "guards.json"

    @property
    def asked(self) -> Path:
        """What an operator asked of the run while it goes."""
        return self.root / "asked.json"

    @property
    def journals(self) -> Path:
        """What was begun, ended and failed: a file a process that worked on the run."""
        return self.root / "journal"

    @property
    def logs(self) -> Path:
        """Logs as JSON lines: files of each process that worked on the run."""
        return self.root / "log"

    @property
    def status_page(self) -> Path:
        """The page that tells how far the run is."""
        return self.root / "status.html"

    @classmethod
    def own_names(cls) -> frozenset[str]:
        """What directly below a run is no folder of a configuration."""
        run = cls(Path())
        files = (run.plan, run.spending, run.judging, run.guards, run.asked, run.status_page)
        folders = (run.earlier_plan(""), run.leases, run.journals, run.logs, run.elsewhere, run.repeatability)
        return frozenset(path.parts[0] for path in (*files, *folders))

    @classmethod
    def planned(cls, runs: Path) -> list[RunFolder]:
        """The runs of a folder that have a plan, by name."""
        return [folder for path in sorted(runs.glob("*")) if (folder := cls(path)).plan.is_file()]

    def trials(self) -> Iterator[TrialFolder]:
        """The trials that have a folder, by name."""
        return (TrialFolder(path) for path in sorted(self.root.glob("*/*/r[0-9]*")) if path.name[1:].isdigit())

    def trial_named(self, name: str) -> TrialFolder:
        """Folder of a trial by its path below the run's, ``configuration/alias/r<k>`` (``c4s.records.journal``)."""
        return TrialFolder(self.root / name)

    def trial(self, configuration: str, alias: str, repeat: int) -> TrialFolder:
        """Folder of a trial; repeats count from 1. Agent code sees the path, so it names the case by its alias."""
        return TrialFolder(self.root / configuration / alias / f"r{repeat}")
