"""The proxies of the environment (``HTTP_PROXY``, ``HTTPS_PROXY``, ``ALL_PROXY``): used for what lies elsewhere only.

No proxy leads back to this machine, and nobody who sets one thinks of the servers on loopback that c4s starts: so
loopback is added to ``NO_PROXY``, here and for all that is started from here.
"""

from __future__ import annotations

import os
from typing import Final

from c4s.errors import BadInput

LOOPBACK: Final = ("127.0.0.1", "localhost", "::1")
_NAMES: Final = ("http_proxy", "https_proxy", "all_proxy")


def spare_loopback() -> None:
    """Let no proxy of the environment be asked for loopback."""
    if not _proxies():
        return
    told = os.environ.get("no_proxy") or os.environ.get("NO_PROXY", "")
    names = [name.strip() for name in told.split(",") if name.strip()]
    if "*" not in names:
        os.environ["no_proxy"] = os.environ["NO_PROXY"] = ",".join(dict.fromkeys((*names, *LOOPBACK)))


def check_proxies() -> None:
    """Loopback spared, and ``BadInput`` for a proxy that does not speak HTTP. Its address may hold a password."""
    spare_loopback()
    for name, address in _proxies().items():
        scheme, found, _ = address.partition("://")
        if found and scheme.lower() not in ("http", "https"):
            raise BadInput(f"proxies of {scheme!r} are not spoken", where=name, todo="name an http:// one, or unset it")


def _proxies() -> dict[str, str]:
    """Addresses by the variables that name them."""
    return {name: told for low in _NAMES for name in (low, low.upper()) if (told := os.environ.get(name, "").strip())}
