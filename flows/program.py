"""A program of Prefect as it starts soonest here: ``python -m flows.program MODULE [ARGUMENTS]``."""

from __future__ import annotations

import runpy
import sys


def main() -> None:
    """Run a module of Prefect as if Python had been asked for it."""
    del sys.argv[0]
    runpy.run_module(sys.argv[0], run_name="__main__", alter_sys=True)


if __name__ == "__main__":
    main()
