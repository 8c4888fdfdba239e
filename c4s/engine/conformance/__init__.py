"""What every engine behind the seam must do, as checks that a person can run against a real editor (see DESIGN.md)."""

from c4s.engine.conformance.check import Check
from c4s.engine.conformance.suite import Report, Result, all_checks, run

__all__ = ["Check", "Report", "Result", "all_checks", "run"]
