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
    "part",
    "plan",
    "pool",
    "stages",
    "store",
    "torn",
    "trial",
]
