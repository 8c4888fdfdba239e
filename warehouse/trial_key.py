"""What every row of a trial carries."""

from __future__ import annotations

from c4s.records.base import Record


class TrialKey(Record):
    """What every row carries: which trial it belongs to."""

    trial_id: str
    """16 hex digits by content: suite, case, configuration, repeat, policy, judge with its version, engine."""
    run_id: str
    """The run that scored it."""
    suite: str
    """Name of the suite."""
    suite_digest: str
    """Of the suite's record: another build of a suite is another suite."""
    configuration: str
    """Its name. Two contents may have one: ``configuration_digest`` tells them apart, the questions show its start."""
    configuration_digest: str
    """SHA-256 of the configuration's canonical JSON."""
    case_id: str
    """Unique in its suite."""
    repeat: int
    """From 1."""
