"""Scripts of these tests use the older static functions too, which warn their caller."""

from __future__ import annotations


def pytest_configure(config):
    config.addinivalue_line("filterwarnings", "ignore:Function '.*' on '.*' is deprecated:DeprecationWarning")
