"""The trusted side of any engine process: its bridge, the queue of its jobs, their logs, and its end."""

__all__ = ["job", "joblog", "jobs", "places", "server", "session"]
