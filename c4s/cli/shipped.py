"""The suites that ship, built with progress."""

from __future__ import annotations

from types import MappingProxyType

from c4s.cli.progress import bars, step_line
from c4s.home import packs_root, suites_root
from c4s.records.suite import Suite


def build_starter_visibly(*, replace: bool = False) -> Suite:
    """Build the starter suite and its packs, or find them built; with progress."""
    from cases.starter.suite import build_starter

    with bars() as progress:
        task = progress.add_task("starter suite", total=None)

        def step(message: str) -> None:
            progress.update(task, description=f"building {message:42.42}")
            step_line(message)

        suite = build_starter(suites_root() / "starter", packs_root(), step, replace=replace)
        progress.update(task, description=f"{'starter suite ready':51}")
    return suite


def build_open190_visibly(*, replace: bool = False) -> Suite:
    """Build the suite open-190, or what of it is not there yet; with progress."""
    from cases.open190.suite import build_open190

    with bars() as progress:
        task = progress.add_task("open-190", total=None)

        def step(message: str) -> None:
            progress.update(task, description=f"building {message.strip():42.42}")
            step_line(message)

        def done(made: int, whole: int) -> None:
            progress.update(task, completed=made, total=whole)

        suite = build_open190(suites_root() / "open-190", packs_root(), step, done, replace=replace)
        progress.update(task, description=f"{'open-190 ready':51}")
    return suite


SHIPPED = MappingProxyType({"starter": build_starter_visibly, "open-190": build_open190_visibly})
"""How each suite that ships is built."""
