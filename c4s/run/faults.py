"""The one place that decides whose fault a failure is, after the table in ``c4s.errors``."""

from __future__ import annotations

from c4s.errors import AgentFault, C4SError, Place, ReasonCode, Unforeseen, Whose, row_of, shortage


class SceneFault(AgentFault):
    """The scene made a stage fail, and did so again in a fresh worker. An outcome, not a fault of the machinery."""

    def __init__(self, what: str, *, code: ReasonCode, where: str = "", todo: str = "") -> None:
        self.code: ReasonCode = code
        super().__init__(what, where=where, todo=todo)


def whose(error: BaseException, place: Place) -> Whose:
    """Whose fault an error is that surfaced in a place."""
    return row_of(error).whose(place)


def may_be_the_scenes(error: Exception) -> bool:
    """Whether a stage that reads one scene is repeated after it, to see whether the scene is why."""
    return whose(error, "scene") == "scene" or _unforeseen(error)


def of_scene(again: Exception) -> Exception:
    """What the same failure in a fresh worker is: ``SceneFault``, unless it is not the scene's."""
    if _unforeseen(again):
        return _told(again, "a fresh worker did the same; ")
    if whose(again, "scene") != "scene":
        return again
    code: ReasonCode = getattr(again, "code", None) or row_of(again).code or "crash"
    return SceneFault(again.what if isinstance(again, C4SError) else str(again), code=code)


def of_machinery(error: BaseException, *, where: str) -> C4SError:
    """An error that leaves a trial pending, as one line with what to do about it."""
    short = shortage(error)
    if short is not None:
        return short
    if isinstance(error, C4SError):
        return error
    return _told(error, "", where=where)


def _unforeseen(error: BaseException) -> bool:
    return row_of(error).failure == "Exception" and not isinstance(error, C4SError)


def _told(error: BaseException, first: str, *, where: str = "") -> Unforeseen:
    made = Unforeseen(f"{type(error).__name__}: {error}", where=where, todo=first + row_of(error).todo)
    for note in getattr(error, "__notes__", ()):
        made.add_note(note)
    made.__cause__ = error
    return made
