"""How pages are made of templates."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any, Final

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from c4s.names import shown
from c4s.protocol.settings import SETTING_TITLES, is_construction
from c4s.verify.registry import VERIFIERS, headlines_of
from reports.frame import links
from reports.text import counted, headed, moment, number, p_value, percent, signed, slug, span, step

STATIC: Final = Path(__file__).parent.parent / "static"
"""Styles and scripts, copied to ``static/`` of the site."""


def _visible(value: Any) -> Any:
    """What a page shows of a value: of a text nothing that turns its direction or cannot be seen."""
    return shown(value, keep="\n\t") if isinstance(value, str) and not isinstance(value, Markup) else value


@cache
def environment() -> Environment:
    """How pages are made of templates: what is shown is escaped, and has a filter a kind of number."""
    made = Environment(
        loader=PackageLoader("reports"),
        autoescape=True,
        finalize=_visible,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    made.filters.update(
        counted=counted,
        headed=headed,
        moment=moment,
        number=number,
        p_value=p_value,
        percent=percent,
        signed=signed,
        slug=slug,
        span=span,
        step=step,
    )
    made.globals.update(
        links=links,
        setting_names=SETTING_TITLES,
        is_construction=is_construction,
        headlines=headlines_of,
        verifiers=VERIFIERS,
    )
    return made
