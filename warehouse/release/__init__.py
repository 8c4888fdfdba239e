"""What is published: sums over private cases by an allow-list, a search for what such cases hold, the download."""

from __future__ import annotations

from warehouse.release.download import MANIFEST, write_download
from warehouse.release.leaks import Leak, kinds_in, leaks_in, refuse_leaks
from warehouse.release.packing import look_through, pack_release
from warehouse.release.panel import PrivateStanding, private_standings
from warehouse.release.secrets import Secrets, secrets_of
from warehouse.release.words import strings_of

__all__ = [
    "MANIFEST",
    "Leak",
    "PrivateStanding",
    "Secrets",
    "kinds_in",
    "leaks_in",
    "look_through",
    "pack_release",
    "private_standings",
    "refuse_leaks",
    "secrets_of",
    "strings_of",
    "write_download",
]
