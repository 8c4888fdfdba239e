"""Attacks on the sandbox of agent code: the table, by theme, and the trial of each in every sandbox."""
