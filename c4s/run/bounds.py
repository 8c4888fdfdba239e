"""Bounds as people give them: a deadline (how long from now, or when), a duration, an amount."""

from __future__ import annotations

import re
from datetime import datetime, timedelta

from c4s.errors import BadInput

_PARTS = re.compile(r"(?:(\d+)d)?(?:(\d+)h)?(?:(\d+)m)?(?:(\d+)s)?")
_CLOCK = re.compile(r"([01]?\d|2[0-3]):([0-5]\d)")
MOST_DAYS = 366
MOST_REPEATS, MOST_SLOTS, MOST_FAULTS = 1000, 1024, 1_000_000
MOST_TOKENS = 10**15


def moment(text: str, option: str) -> float:
    """Unix time, seconds, of ``8h``, ``1h30m``, ``07:30`` (the next one here) or ``2026-11-24T07:30``.

    A time without a zone is this machine's. ``BadInput``, which names ``option``, for anything else, for what is past,
    and for what is more than a year away.
    """
    at, here = _read(text.strip(), option), datetime.now().astimezone()
    if at <= here:
        raise BadInput(f"{text!r} is past", where=option, todo="give a time to come, or a duration such as 8h")
    if at - here > timedelta(days=MOST_DAYS):
        raise BadInput(f"{text!r} is more than a year away", where=option)
    return at.timestamp()


def seconds_of(text: str, option: str) -> float:
    """Seconds of a duration (``90m``, ``8h``, ``30d``). ``BadInput``, which names ``option``, for another text."""
    parts = _PARTS.fullmatch(text.strip())
    if not text.strip() or parts is None or any(len(part or "") > 9 for part in parts.groups()):
        raise BadInput(f"{text!r} is no duration", where=option, todo="give one such as 90m, 8h or 30d")
    days, hours, minutes, seconds = (int(part or 0) for part in parts.groups())
    return float(((days * 24 + hours) * 60 + minutes) * 60 + seconds)


def amount(usd: float, option: str) -> float:
    """An amount of US dollars; ``BadInput``, which names ``option``, for what is none."""
    if not 0 <= usd < float("inf"):
        raise BadInput(f"{usd} is no amount in US dollars", where=option)
    return usd


def count(value: int, most: int, option: str, *, least: int = 1) -> int:
    """A count of ``least`` to ``most``; ``BadInput``, which names ``option``, for another."""
    if value < least:
        raise BadInput(f"Input should be greater than or equal to {least}", where=option)
    if value > most:
        raise BadInput(f"Input should be less than or equal to {most}", where=option)
    return value


def _read(text: str, option: str) -> datetime:
    here = datetime.now().astimezone()
    if clock := _CLOCK.fullmatch(text):
        return _next(int(clock[1]), int(clock[2]), here)
    try:
        return datetime.fromisoformat(text).astimezone()
    except (ValueError, OverflowError):
        pass
    try:
        return here + timedelta(seconds=seconds_of(text, option))
    except (BadInput, OverflowError):
        raise BadInput(
            f"{text!r} is neither a duration nor a time",
            where=option,
            todo="give one such as 8h, 07:30 or 2026-11-24T07:30",
        ) from None


def _next(hour: int, minute: int, here: datetime) -> datetime:
    """The next time at which clocks here show it, also where they are set forward or back before then.

    What they show twice comes twice; what they leave out comes as late as if they had not been set.
    """
    today = here.replace(hour=hour, minute=minute, second=0, microsecond=0, tzinfo=None)
    times = []
    for day in (today, today + timedelta(days=1)):
        first, second = (day.replace(fold=fold).astimezone() for fold in (0, 1))
        times += [first, max(first, second)]
    return min(at for at in times if at > here)
