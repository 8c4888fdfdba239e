"""What a folder says about its licence."""

from __future__ import annotations

import os
import re
from pathlib import Path

from c4s.files import read_plain

FILES = re.compile(r"(licen[cs]e|copying|source|notice)[^/]*(\.(txt|md))?", re.IGNORECASE)
KNOWN = (
    ("CC0-1.0", r"CC0|creative commons zero|public domain"),
    ("CC-BY-4.0", r"CC[- ]BY[- ]4\.0|attribution 4\.0"),
    ("CC-BY-3.0", r"CC[- ]BY[- ]3\.0"),
    ("Apache-2.0", r"Apache License|Apache-2\.0"),
    ("MIT-0", r"MIT-0|MIT No Attribution"),
    ("MIT", r"\bMIT\b|above copyright notice and this permission notice"),
    ("MIT-0", r"Permission is hereby granted, free of charge"),
    ("BSD-3-Clause", r"Redistribution and use in"),
)
UNKNOWN = "unknown"


def licence(folder: Path) -> tuple[str, str]:
    """Short name of the licence (``unknown`` where none is told) and the text of the files that tell it."""
    files = [path for path in sorted(folder.iterdir()) if FILES.fullmatch(path.name) and _is_own(path, folder)]
    files.sort(key=lambda path: path.name.lower().startswith("source"))
    texts = [read_plain(path)[:100_000].decode("utf-8", errors="replace") for path in files]
    for text in texts:
        for name, pattern in KNOWN:
            if re.search(pattern, text, re.IGNORECASE):
                return name, "\n\n".join(texts)
    return UNKNOWN, "\n\n".join(texts)


def _is_own(path: Path, folder: Path) -> bool:
    """Whether it is a plain file of the folder, and no link out of it."""
    return path.is_file() and Path(os.path.realpath(path)).is_relative_to(Path(os.path.realpath(folder)))
