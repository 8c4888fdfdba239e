"""A run: its plan, attempts, the stages of a trial and the one program over them, worker processes."""

__all__ = ["attempt", "check", "choices", "configurations", "drive", "limits", "plan", "pool", "stages", "trial"]
