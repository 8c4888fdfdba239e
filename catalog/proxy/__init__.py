"""Proxy assets: stand-ins of exactly the right size, shaped and coloured after a palette line's name and category."""

from catalog.proxy.pack import PaletteEntry, build_proxy_pack

__all__ = ["PaletteEntry", "build_proxy_pack"]
