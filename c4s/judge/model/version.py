"""Which judge it is: its configuration, its prompts, and the code that judges by them."""

from __future__ import annotations

from c4s.files import digest
from c4s.judge.model.prompts import prompt_versions
from c4s.records.judge import JudgeConfiguration
from c4s.records.version import code_version, release

DECIDE = ("judge/model", "judge/paired", "semantics", "protocol", "geometry")
"""Folders of ``c4s`` whose sources decide what is asked and what is made of the answers."""


def model_version(configuration: JudgeConfiguration) -> str:
    """``<release>+<12 hex>``: changes with anything that can change an answer or what follows from it."""
    return f"{release()}+{digest([asked_by(configuration), code_version(*DECIDE)])[:12]}"


def asked_by(configuration: JudgeConfiguration) -> str:
    """Digest of what a request's answer depends on beside the request: the configuration and the prompts."""
    return digest([configuration.identity(), prompt_versions()])
