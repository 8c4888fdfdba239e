"""Edits and progress as context managers."""

from __future__ import annotations

from types import TracebackType

from c4s.engine.headless.state import world
from c4s.engine.headless.unreal.containers import Text
from c4s.engine.headless.unreal.core import public


@public
class ScopedEditorTransaction:
    """A named edit; undo is not modelled."""

    def __init__(self, desc: str | Text) -> None:
        if not isinstance(desc, (str, Text)):
            raise TypeError(f"ScopedEditorTransaction: cannot convert type '{type(desc).__name__}' to Text")

    def __enter__(self) -> ScopedEditorTransaction:
        return self

    def __exit__(self, kind: type[BaseException] | None, value: BaseException | None,
                 trace: TracebackType | None) -> None:
        return None

    def cancel(self) -> None:
        """Undo is not modelled."""
        world().log.warning("ScopedEditorTransaction.cancel: undo is not modelled by the headless engine")


@public
class ScopedSlowTask:
    """Progress of a long edit; nothing is shown."""

    def __init__(self, work: float, desc: str | Text = "", enabled: bool = True) -> None:
        self._work = float(work)

    def __enter__(self) -> ScopedSlowTask:
        return self

    def __exit__(self, kind: type[BaseException] | None, value: BaseException | None,
                 trace: TracebackType | None) -> None:
        return None

    def make_dialog(self, can_cancel: bool = False, allow_in_pie: bool = False) -> None:
        """Nothing is shown."""

    def make_dialog_delayed(self, delay: float, can_cancel: bool = False, allow_in_pie: bool = False) -> None:
        """Nothing is shown."""

    def enter_progress_frame(self, work: float = 1.0, desc: str | Text = "") -> None:
        """Nothing is shown."""

    def should_cancel(self) -> bool:
        """Nobody cancels."""
        return False
