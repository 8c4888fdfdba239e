"""What an agent did, as data: tool counts, operations inside Python, execution feedback. See DESIGN.md."""

from c4s.trajectory.analysis import POLLING_TOOL, PYTHON_TOOL, Analysis, Submission, analyse
from c4s.trajectory.operations import FAMILIES, families_of

__all__ = ["FAMILIES", "POLLING_TOOL", "PYTHON_TOOL", "Analysis", "Submission", "analyse", "families_of", "lines"]
