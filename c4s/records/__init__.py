"""Every file format as a model with its one checker, and the paths of a run folder."""

__all__ = [
    "attempt",
    "base",
    "evidence",
    "evidence_digests",
    "fault",
    "folder",
    "handover",
    "judgement",
    "lease",
    "level",
    "pack",
    "plan",
    "policy",
    "score",
    "snapshot",
    "snapshot_faults",
    "suite",
    "unreal_content",
    "verdict",
    "version",
]
