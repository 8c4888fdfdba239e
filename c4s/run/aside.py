"""Moving out of the way what cannot be used, and keeping it."""

from __future__ import annotations

from pathlib import Path

from c4s.files import digest_bytes, digest_file
from c4s.folders import remove_tree

TORN, OUTDATED = "torn", "outdated"
"""What is set aside is called: a file that was cut off or changed, and what was made from one."""


def set_aside(attempt: Path) -> None:
    """Move the remains of an attempt that was cut off out of the way, and keep them."""
    if attempt.exists():
        number = 1
        while (kept := attempt.with_name(f"{attempt.name}.interrupted-{number}")).exists():
            number += 1
        attempt.rename(kept)


def aside(path: Path, what: str, why: str = "it is no JSON") -> str:
    """Rename a file or folder, and tell it. The same content that was set aside before takes its place."""
    kept = path.with_name(f"{path.name}.{what}-{_content(path)[:12]}")
    if kept.is_dir():
        remove_tree(kept, inside=path.parent)
    path.replace(kept)
    return f"{path} is set aside as {kept.name} and made again ({why})"


def _content(path: Path) -> str:
    if path.is_file():
        return digest_file(path)
    rows = [f"{inner.relative_to(path)} {digest_file(inner)}" for inner in sorted(path.rglob("*")) if inner.is_file()]
    return digest_bytes("\n".join(rows).encode(errors="surrogatepass"))
