"""What an agent can read in a text-to-scene prompt: the description, the palette lines, the counts asked for."""

from __future__ import annotations

import re
from dataclasses import dataclass

LINE = re.compile(
    r"^\s*-\s*(?P<id>[^|\n]+?)\s*\|\s*(?P<name>[^|\n]+?)\s*\|\s*(?P<category>[^|\n]+?)\s*\|\s*"
    r"(?P<w>[\d.]+)x(?P<d>[\d.]+)x(?P<h>[\d.]+)\s*m\s*\|\s*(?P<path>/\S+)\s*$",
    re.MULTILINE,
)
SECTION = re.compile(r"^\s*===", re.MULTILINE)
NUMBERS = {
    "a": 1, "an": 1, "one": 1, "single": 1, "two": 2, "pair": 2, "couple": 2, "three": 3, "four": 4, "five": 5,
    "six": 6, "seven": 7, "eight": 8, "nine": 9, "ten": 10, "eleven": 11, "twelve": 12, "dozen": 12, "fifteen": 15,
    "sixteen": 16, "eighteen": 18, "twenty": 20, "thirty": 30, "forty": 40, "fifty": 50, "sixty": 60, "eighty": 80,
    "few": 3, "several": 5, "some": 4, "many": 10, "rows": 8, "row": 6, "scattered": 6, "clusters": 6, "cluster": 5,
    "occasional": 3,
}  # fmt: skip
REACH_WORDS = 5


@dataclass(frozen=True)
class PaletteItem:
    """A palette line: width (X), depth (Y), height (Z) in metres."""

    id: str
    name: str
    category: str
    width: float
    depth: float
    height: float
    path: str

    @property
    def words(self) -> set[str]:
        """Singular words of name and category, without numbers."""
        return {singular(word) for word in re.findall(r"[a-z]{3,}", f"{self.name} {self.category}".lower())}

    @property
    def area(self) -> float:
        """Footprint in square metres."""
        return self.width * self.depth


def singular(word: str) -> str:
    """A plural without its ending, roughly: enough to match words of a prompt with names of assets."""
    for ending, replacement in (
        ("shelves", "shelf"),
        ("ies", "y"),
        ("sses", "ss"),
        ("ches", "ch"),
        ("shes", "sh"),
        ("xes", "x"),
        ("ses", "se"),
    ):
        if word.endswith(ending) and len(word) > len(ending):
            return word[: -len(ending)] + replacement
    return word[:-1] if word.endswith("s") and not word.endswith("ss") and len(word) > 3 else word


def description(prompt: str) -> str:
    """The prose before the first section heading."""
    found = SECTION.search(prompt)
    return prompt[: found.start()].strip() if found else prompt.strip()


def palette(prompt: str) -> list[PaletteItem]:
    """The palette lines of a prompt, in order."""
    return [
        PaletteItem(
            id=m["id"],
            name=m["name"],
            category=m["category"],
            width=float(m["w"]),
            depth=float(m["d"]),
            height=float(m["h"]),
            path=m["path"],
        )
        for m in LINE.finditer(prompt)
    ]


def asked_counts(text: str) -> dict[str, int]:
    """For each singular word of the text, how many are asked for: the last number a few words before it, else 0."""
    counts: dict[str, int] = {}
    for clause in re.split(r"[.;,:]", text.lower()):
        words = re.findall(r"[a-z]+|\d+", clause.replace("-", " "))
        for index, word in enumerate(words):
            number = 0
            for earlier in words[max(0, index - REACH_WORDS) : index]:
                if earlier.isdigit():
                    number = int(earlier)
                elif earlier in NUMBERS:
                    number = NUMBERS[earlier] if number == 0 or earlier != "dozen" else 12 * number
            key = singular(word)
            counts[key] = max(counts.get(key, 0), min(number, 80))
    return counts
