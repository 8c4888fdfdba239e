"""Who works on a run: the record of a lease."""

from __future__ import annotations

from typing import Literal

from c4s.records.base import Record


class Owner(Record):
    """A process, told apart from every other one, also from a later one of the same number."""

    host: str
    """Name of the machine, for people."""
    boot_id: str
    """Id of the kernel's start."""
    pid_namespace: str
    """Which numbering ``pid`` belongs to: processes of two containers may have the same number."""
    pid: int
    started_ticks: int
    """When the process started, in clock ticks since the kernel's start."""


class Lease(Record):
    """A run's holder. The time of the file is that of the last sign of life; the clock is the file system's."""

    schema_version: Literal["c4s.lease.v1"] = "c4s.lease.v1"
    owner: Owner
    since: str
    """When it was taken: UTC, ISO 8601, for people."""
    lasts_s: float
    """After so long without a sign of life another machine may take it over."""
    given_back: bool = False
