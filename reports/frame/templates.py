"""How pages are made of templates."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any, Final

import jinja2
from jinja2 import Environment, FileSystemBytecodeCache, PackageLoader, StrictUndefined
from jinja2.bccache import Bucket
from markupsafe import Markup

from c4s.files import digest
from c4s.home import cache_root
from c4s.kept_code import prune, writable
from c4s.names import shown
from c4s.protocol.settings import SETTING_TITLES, is_construction
from c4s.verify.registry import VERIFIERS, headlines_of
from reports.frame import links
from reports.frame.sources import code_digest
from reports.text import counted, headed, moment, number, p_value, percent, signed, slug, span, step

_PACKAGE: Final = Path(__file__).parent.parent
STATIC: Final = _PACKAGE / "static"
"""Styles and scripts, copied to ``static/`` of the site."""


def _visible(value: Any) -> Any:
    """What a page shows of a value: of a text nothing that turns its direction or cannot be seen."""
    return shown(value, keep="\n\t") if isinstance(value, str) and not isinstance(value, Markup) else value


class KeptTemplates(FileSystemBytecodeCache):
    """Compiled templates in a folder. One whose file is damaged is compiled again."""

    def load_bytecode(self, bucket: Bucket) -> None:
        """What is kept of a template, or nothing."""
        try:
            super().load_bytecode(bucket)
        except Exception:  # a damaged pickle may raise anything
            bucket.reset()


def _kept() -> KeptTemplates | None:
    """Templates that are compiled already: beside the package's compiled Python or in c4s's cache; None where neither
    can be written to."""
    for root in (_PACKAGE / "__pycache__", cache_root()):
        folder = root / f"templates-{digest([code_digest(), jinja2.__version__])[:16]}"
        if writable(folder):
            prune(folder, "templates")
            return KeptTemplates(str(folder))
    return None


@cache
def environment() -> Environment:
    """How pages are made of templates: what is shown is escaped, and has a filter a kind of number."""
    made = Environment(
        loader=PackageLoader("reports"),
        autoescape=True,
        finalize=_visible,
        undefined=StrictUndefined,
        bytecode_cache=_kept(),
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
