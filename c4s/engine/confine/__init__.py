"""Processes in a sandbox: bubblewrap or Landlock, system calls, limits, the watch."""

__all__ = ["confinement", "landlock", "leftovers", "sandbox", "seccomp", "watch"]
