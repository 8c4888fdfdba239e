"""One page of the site, told before it is made."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class SitePage:
    """One page."""

    path: str
    """Below the site, as ``links`` spells it."""
    template: str
    values: Callable[[], dict[str, Any]]
    """What the template is given besides ``root``, ``page`` and ``navigation``; asked for only where the page is
    written. Pictures and data files that it shows are put on the site by ``SiteContext.put`` meanwhile."""
    made_of: str
    """Digest of what it is made of (``SiteContext.stamp``): a page whose digest is last time's is not written again."""
    navigation: str = ""
    """Its title in the navigation of every page; empty where it is not there."""

    @property
    def root(self) -> str:
        """The way from the page to the site's folder."""
        return "../" * self.path.count("/")
