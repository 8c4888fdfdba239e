"""The static site: built from the warehouse, read from a folder without a server."""

from __future__ import annotations

from reports.place import check_place
from reports.site.build import build_site

__all__ = ["build_site", "check_place"]
