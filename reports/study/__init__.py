"""A server on this machine that asks people: annotators of a study, reviewers of a suite."""

from __future__ import annotations

from reports.study.server import QuestionServer

__all__ = ["QuestionServer"]
