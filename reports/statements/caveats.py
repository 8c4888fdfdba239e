"""What has to be said beside results: in short, and why."""

from __future__ import annotations

from typing import Final

CAVEATS: Final[tuple[tuple[str, str], ...]] = (
    (
        "Static checks only",
        "A scene is measured as it was saved, at rest. Nothing falls, moves or is played; support is a contact of "
        "boxes and penetration a depth of collision shapes.",
    ),
    (
        "An interval is no test",
        "Intervals say how scores vary with the source scenes that happen to be in the suite. Two that overlap prove "
        "nothing equal, and two that do not are no test of significance; paired differences are a study of their own.",
    ),
    (
        "One scene stands for a configuration and case",
        "Without repeats nothing is told of how another run of the same agent would fall out.",
    ),
    (
        "Public cases are no sample in proportion",
        "They are not spread over categories, content packages or difficulties as the whole suite is.",
    ),
    (
        "A configuration is scored, not a model",
        "Client, prompts, tools and limits are part of it; the same model elsewhere may score otherwise.",
    ),
    ("Difficulty is what an author says", "Labels are not calibrated; a score need not fall from easy to hard."),
    (
        "No safety certificate",
        "A high score does not say that a scene is fit for a simulation or for people to rely on.",
    ),
)
