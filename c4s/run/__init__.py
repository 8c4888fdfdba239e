"""A run: its plan and its holder, attempts, the stages of a trial and the one program over them, worker processes."""

__all__ = [
    "attempt",
    "check",
    "choices",
    "configurations",
    "drive",
    "headroom",
    "inputs",
    "lease",
    "limits",
    "plan",
    "pool",
    "stages",
    "torn",
    "trial",
]
