"""Suites without Python: a suite file in YAML, and what an author does with it. See DESIGN.md in this folder."""

from cases.workshop.document import SuiteFile
from cases.workshop.reading import read_definition, read_suite_file

__all__ = ["SuiteFile", "read_definition", "read_suite_file"]
