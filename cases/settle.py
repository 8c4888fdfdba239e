"""Whether a suite may be built in its place: nothing is replaced without being asked by name."""

from __future__ import annotations

from pathlib import Path

from c4s.errors import BadInput
from c4s.folders import check_own
from c4s.packs.suite_check import tree_changes
from c4s.records.suite import SUITE, SuiteFolder
from c4s.trees import refuse

REMEDY = "give --replace to build it anew, or choose another name"


def to_build(root: Path, *, same: bool, replace: bool) -> bool:
    """Whether a suite is to be put at ``root``; False where it lies there already, as it was frozen.

    Args:
        root: the suite's folder.
        same: whether what lies there calls itself the suite that is asked for.
        replace: whether another suite, or one that was changed, may be replaced.

    Raises ``BadInput`` where what lies there is not to be replaced, and for a folder that holds no suite.
    """
    check_own(root, SUITE)
    if not root.exists():
        return True
    if not same:
        if not replace:
            raise BadInput("another suite of this name lies here", where=str(root), todo=REMEDY)
        return True
    changed = tree_changes(SuiteFolder(root))
    if not replace:
        refuse(changed, todo=f"restore the file, or {REMEDY}")
    return bool(changed)
