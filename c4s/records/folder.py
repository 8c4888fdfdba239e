"""The run folder: the truth about a run. All paths of a run are made here."""

from __future__ import annotations

from pathlib import Path


class TrialFolder:
    """``runs/<run-id>/<agent>/<case>/r<k>``."""

    def __init__(self, root: Path) -> None:
        self.root = root

    def attempt(self, number: int) -> Path:
        """Folder of an attempt: ``trajectory.jsonl``, ``usage.jsonl``, ``submission/``, ``outcome.json``."""
        return self.root / f"attempt-{number}"

    @property
    def evidence(self) -> Path:
        """What a clean engine process exported from the retained submission."""
        return self.root / "evidence"

    def verdict(self, verifier: str) -> Path:
        """A verifier's report."""
        return self.root / "verdicts" / f"{verifier}.json"

    @property
    def score(self) -> Path:
        """The trial's score."""
        return self.root / "score.json"


class RunFolder:
    """``runs/<run-id>``."""

    def __init__(self, root: Path) -> None:
        self.root = root

    @property
    def plan(self) -> Path:
        """The frozen plan."""
        return self.root / "plan.json"

    def trial(self, configuration: str, case_id: str, repeat: int) -> TrialFolder:
        """Folder of a trial; repeats count from 1."""
        return TrialFolder(self.root / configuration / case_id / f"r{repeat}")
