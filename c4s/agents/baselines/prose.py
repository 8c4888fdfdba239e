"""What a prompt's prose says: the things it names, how many of each, and which stand on or near which."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from c4s.agents.baselines.english import (
    ADJECTIVES,
    BUILDING_WORDS,
    COLOURS,
    EACH,
    MEASURES,
    NEGATIONS,
    NUMBERS,
    PEOPLE,
    PLACES,
    RELATIONS,
    SIZES,
    STOPS,
    STRIPS,
    VERBS,
)
from c4s.agents.baselines.naming import Names, is_flat, is_long
from c4s.agents.baselines.palette import description, palette, singular
from c4s.agents.baselines.reading import Chunk, Mention, Prose
from c4s.agents.baselines.sentences import relate

MOST = 120
"""Copies of one thing."""
LONGEST = max(len(phrase.split()) for phrase in RELATIONS)
DETERMINERS = frozenset({"a", "an", "the"}) | EACH
PRONOUNS = frozenset({"it", "its", "them", "their", "there"})


def read(prompt: str) -> Prose:
    """The reading of a prompt; empty where it names nothing of its palette."""
    text = description(prompt)
    names = Names(palette(prompt), text)
    reading = Prose(size_m=_size(text))
    for number, sentence in enumerate(re.split(r"[.;:!?]", text.lower())):
        words = re.findall(r"[a-z]+|\d+|,", _plain(sentence))
        relate(list(_chunks(words, names, reading, opening=number == 0)), reading)
    return reading


def _plain(sentence: str) -> str:
    """Without what confuses the counts: ``two-storey`` is no two, and ``child's`` is child."""
    sentence = re.sub(r"\b(\w+)- (?:to|and|or) ", " ", re.sub(r"'s\b", "", sentence))
    sentence = re.sub(r"\b(high|mid|low)[- ]rise\b", r"\1rise", sentence)
    return " ".join(_compound(part) if "-" in part else part for part in re.split(r"(\w+(?:-\w+)+)", sentence))


def _compound(word: str) -> str:
    """The words of a hyphened one that describe: ``timber-and-stone`` is timber stone, ``two-storey`` storey."""
    parts = word.split("-")
    if len(parts) > 1 and _number(parts[0]):
        return " ".join(parts[1:])
    return " ".join(part for part in parts if part not in ("and", "or", "like") and part not in VERBS)


def _size(text: str) -> tuple[float, float] | None:
    found = re.search(r"(\w+)(?: metres| meters| m)? (?:by|x) (\w+) ?(?:metres|meters|m)\b", text.lower())
    sides = [_number(side) for side in found.groups()] if found else []
    return (float(max(sides)), float(min(sides))) if sides and all(side > 1 for side in sides) else None


def _number(word: str) -> int:
    if word.isdigit():
        return int(word)
    tail = next((ending for ending in ("teen", "ty") if word.endswith(ending)), None)
    if word not in NUMBERS and tail:
        stem = {"thir": 3, "fif": 5, "eigh": 8}.get(word.removesuffix(tail)) or NUMBERS.get(word.removesuffix(tail), 0)
        return (10 + stem if tail == "teen" else 10 * stem) if stem else 0
    return NUMBERS.get(word, 0)


def _chunks(words: Sequence[str], names: Names, reading: Prose, *, opening: bool) -> Iterator[Chunk]:
    """The parts of a sentence, in order; what is named is added to the reading."""
    nearby = {singular(word) for word in words}
    said: list[str] = []
    place, started = 0, False
    material = 0
    absent = False
    while place < len(words):
        word = words[place]
        if word in NEGATIONS:
            absent, said = True, []
        elif absent and (word in VERBS or (word in ("but", "and") and words[place - 1] != ",")):
            absent = False
        if absent:
            place += 1
            continue
        if phrase := _relation(words, place):
            place += phrase.count(" ") + 1
            said, started, material = [], True, 0
            if RELATIONS[phrase]:
                yield Chunk(RELATIONS[phrase])
            continue
        if word in DETERMINERS and any(known not in STOPS and not _number(known) for known in said):
            yield Chunk("unknown")
            said = []
        if (
            _is_noun(words, place, names)
            and place >= material
            and not (opening and not started and singular(word) in STRIPS | PLACES)
        ):
            yield Chunk("noun", named=_name(words, place, said, nearby, names, reading))
            material = place + 5 if words[place + 1 : place + 2] == ["of"] else 0
            said, started = [], True
        elif word in PRONOUNS:
            yield Chunk("unknown")
        elif word in (",", "and", "or"):
            if word == "," and said and (_is_plural(said[-1]) or len(set(said) - STOPS) > 1):
                yield Chunk("unknown")
            yield Chunk("comma" if word == "," else word)
            material = 0
            said = said if _describes(word, said) else []
        elif word in VERBS:
            yield Chunk("verb")
            said, material = [], 0
        else:
            said.append(word)
        place += 1


def _describes(joint: str, said: Sequence[str]) -> bool:
    """Whether what was said before ``and`` or a comma goes on to describe what comes."""
    if not said or _is_plural(said[-1]):
        return False
    return said[-1] in COLOURS or (joint == "," and any(_number(word) > 1 for word in said))


def _is_plural(word: str) -> bool:
    return singular(word) != word


def _relation(words: Sequence[str], place: int) -> str:
    """The longest phrase of the relations that begins at a place; empty where none does."""
    phrases = (" ".join(words[place : place + count]) for count in range(LONGEST, 0, -1))
    return next((phrase for phrase in phrases if phrase in RELATIONS), "")


def _is_noun(words: Sequence[str], place: int, names: Names) -> bool:
    """Whether a word is the noun of its phrase: it names something and no such word follows."""
    word = singular(words[place])
    if _is_building(words, place):
        return names.means("building")
    known = names.knows(word) or word in PLACES
    if not known or word in MEASURES or word in STOPS | VERBS | PEOPLE:
        return False
    after = words[place + 1] if place + 1 < len(words) else ","
    following = singular(after)
    if (
        after == ","
        or after in NUMBERS
        or after in STOPS | VERBS
        or following in MEASURES
        or _relation(words, place + 1)
    ):
        return names.means(word) or word in PLACES | STRIPS or words[place] != word or after == "of"
    if names.knows(following) or following in PLACES or word in ADJECTIVES:
        return False
    goes_on = words[place] != word or after.endswith(("s", "ed", "ing"))
    return word in PLACES or (names.means(word) and goes_on)


def _is_building(words: Sequence[str], place: int) -> bool:
    """Whether a ``block`` or a ``slab`` is one of a town."""
    return singular(words[place]) in ("block", "slab") and bool(
        BUILDING_WORDS & {singular(word) for word in words[max(0, place - 3) : place]}
    )


def _name(
    words: Sequence[str], place: int, said: Sequence[str], nearby: set[str], names: Names, reading: Prose
) -> Mention:
    noun = "building" if _is_building(words, place) else singular(words[place])
    before = [names.stem(word) for word in said]
    behind = []
    if words[place + 1 : place + 2] == ["of"]:
        behind = [names.stem(word) for word in words[place + 2 : place + 5] if word not in STOPS]
    definite = bool({"the", *EACH} & set(said)) and not any(_number(word) > 1 for word in said)
    mods = frozenset(before) - STOPS - EACH
    plural = words[place] != singular(words[place])
    again = plural and not mods and not any(_number(word) for word in said)
    if known := _known(noun, mods, reading, definite=definite or again):
        return known
    items = names.of(noun, [*before, *behind], nearby, plural=plural)
    if noun in PLACES:
        items = tuple(item for item in items if is_flat(item)) or tuple(
            item for word in [*before, *behind] for item in names.of(word, [], ()) if is_flat(item)
        )
        items = items[:1]
    if noun in STRIPS:
        items = tuple(item for item in items if is_flat(item) or is_long(item))[:1]
    number = max((_number(word) for word in said if word not in ("a", "an")), default=0)
    named = Mention(
        noun, items, said=mods | set(behind), count=min(MOST, number) or 1, counted=number > 0, plural=plural
    )
    reading.named.append(named)
    return named


def _known(noun: str, mods: frozenset[str], reading: Prose, *, definite: bool) -> Mention | None:
    """What was named before, where ``the`` refers to it."""
    same = [named for named in reading.named if named.noun == noun]
    if not definite or not same:
        return None
    if not mods:
        return same[-1]
    signs = {SIZES.get(word) for word in mods} - {None}
    alike = [n for n in same if n.said & mods or signs & {SIZES.get(word) for word in n.said}]
    return alike[-1] if alike else same[0] if len(same) == 1 else None
