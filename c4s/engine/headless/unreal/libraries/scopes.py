"""Edits and progress as context managers."""

from __future__ import annotations

from types import TracebackType
from typing import Literal

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.containers import Text
from c4s.engine.headless.unreal.core import need, public


@public
class ScopedEditorTransaction:
    """A named edit. Edits need none, and none can be undone here."""

    def __init__(self, desc: str | Text) -> None:
        self._description = str(
            need(desc, "Text", "ScopedEditorTransaction: Failed to convert parameter 'desc'", "desc")
        )
        self._index: int | None = None

    def __enter__(self) -> ScopedEditorTransaction:
        world().transactions.append(self._description)
        self._index = len(world().transactions) - 1
        return self

    def __exit__(
        self, type: type[BaseException] | None, value: BaseException | None, traceback: TracebackType | None
    ) -> Literal[False]:
        self.cancel()
        return False

    def cancel(self) -> None:
        """Stop recording; what was edited stays, as in Unreal."""
        if self._index is not None:
            del world().transactions[self._index :]
            self._index = None


@public
class ScopedSlowTask:
    """Progress of a long edit; nothing is shown."""

    def __init__(self, work: float, desc: str | Text = "", enabled: bool = True) -> None:
        self._work = float(work)

    def __enter__(self) -> ScopedSlowTask:
        return self

    def __exit__(
        self, type: type[BaseException] | None, value: BaseException | None, traceback: TracebackType | None
    ) -> Literal[False]:
        return False

    def make_dialog(self, can_cancel: bool = False, allow_in_pie: bool = False) -> None:
        """Nothing is shown."""

    def make_dialog_delayed(self, delay: float, can_cancel: bool = False, allow_in_pie: bool = False) -> None:
        """Nothing is shown."""

    def enter_progress_frame(self, work: float = 1.0, desc: str | Text = "") -> None:
        """Nothing is shown."""

    def should_cancel(self) -> bool:
        """Nobody cancels."""
        return False
