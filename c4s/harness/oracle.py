"""The oracle's attempt where only one case is: ``python -m c4s.harness.oracle CASE WITHHELD OUT``.

``solve.sh`` calls it. It validates a task that was exported, and is never ranked.
"""

from __future__ import annotations

import sys
from pathlib import Path

from c4s.engine import DEFAULT_ENGINE
from c4s.errors import AgentFault, BadInput
from c4s.protocol.baselines import ORACLE
from c4s.records.attempt import AttemptOutcome
from c4s.records.plan import Configuration
from c4s.run.agent_side import AgentSide


def solve(case: Path, withheld: Path, out: Path) -> AttemptOutcome:
    """Save the truth of a case as an attempt.

    Args:
        case: the agent's folder of the case.
        withheld: a folder with the truth.
        out: a new folder for the attempt.

    ``AgentFault`` where nothing was saved.
    """
    outcome = AgentSide.of_folder(case).attempt(
        Configuration(name=ORACLE, client=ORACLE), out, engine=DEFAULT_ENGINE, withheld=withheld
    )
    if outcome.submission is None:
        raise AgentFault(outcome.message or "nothing was saved", where=str(out))
    return outcome


if __name__ == "__main__":
    if len(sys.argv) != 4:
        raise BadInput("give three folders", where="python -m c4s.harness.oracle", todo="CASE WITHHELD OUT")
    solve(*(Path(argument) for argument in sys.argv[1:]))
