"""Recognises licences in text and addresses: their SPDX ids, and whether they let content be used by AI."""

from __future__ import annotations

import re
from typing import Literal

AiUse = Literal["allowed", "forbidden", "unknown"]
UNKNOWN = "unknown"
PARTS = {
    "by": "BY",
    "attribution": "BY",
    "nc": "NC",
    "noncommercial": "NC",
    "sa": "SA",
    "sharealike": "SA",
    "nd": "ND",
    "noderivs": "ND",
    "noderivatives": "ND",
    "noderivative": "ND",
}
PORTS = {
    "united states": "US",
    "usa": "US",
    "germany": "DE",
    "deutschland": "DE",
    "austria": "AT",
    "netherlands": "NL",
    "australia": "AU",
    "france": "FR",
    "england and wales": "UK",
    "uk": "UK",
    "united kingdom": "UK",
    "japan": "JP",
    "spain": "ES",
    "italy": "IT",
    "poland": "PL",
    "canada": "CA",
    "switzerland": "CH",
    "brazil": "BR",
    "igo": "IGO",
    "intergovernmental organisations": "IGO",
    "intergovernmental organizations": "IGO",
}
_COUNTRY = "|".join(sorted(PORTS, key=len, reverse=True))
_WORD = r"(?:attribution|non-?commercial|share-?alike|no-?deriv(?:ative)?s?(?:\s+works)?)"
CREATIVE_ADDRESS = re.compile(
    r"creativecommons\.org/licenses/(?P<parts>by(?:-(?:nc|nd|sa))*)(?:/(?P<version>\d\.\d)(?:/(?P<port>[a-z]{2,3})\b)?)?",
    re.IGNORECASE,
)
CREATIVE_ID = re.compile(
    r"\bCC[-_ ](?P<parts>BY(?:[-_ ](?:NC|ND|SA))*)"
    r"(?:[-_ ]v?(?P<version>\d(?:\.\d)?)(?:[-_ ](?P<port>[A-Z]{2,3}\b))?)?",
    re.IGNORECASE,
)
CREATIVE_NAME = re.compile(
    rf"(?:creative\s+commons|\bCC)[\s:,-]+(?:\d\.\d\s+)?(?P<parts>{_WORD}(?:[\s,-]+{_WORD})*)"
    rf"(?:[\s,]*(?:licen[cs]e\s*)?\(?v?(?:ersion\s*)?(?P<version>\d\.\d))?(?:[\s,()-]*(?P<port>{_COUNTRY})\b)?",
    re.IGNORECASE,
)
BARE_NAME = re.compile(
    rf"\b(?P<parts>Attribution(?:[\s-]+{_WORD})*)\s+(?P<version>\d\.\d)(?:[\s,()-]*(?P<port>{_COUNTRY})\b)?",
    re.IGNORECASE,
)
OTHERS: tuple[tuple[str, str], ...] = (
    ("CC0-1.0", r"\bCC[-_ ]?0\b|creative\s+commons\s+zero|creativecommons\.org/(?:publicdomain|choose|license)/zero"),
    ("PDDL-1.0", r"\bPDDL\b"),
    ("Unlicense", r"unlicense\.org|\bThe\s+Unlicense\b|released\s+into\s+the\s+public\s+domain"),
    ("LicenseRef-PublicDomain", r"public\s+domain|creativecommons\.org/publicdomain/mark"),
    (
        "Apache-2.0",
        r"apache\.org/licenses/LICENSE-2\.0|Apache[- ]Licen[cs]e|"
        r"\bApache[- ](?:Licen[cs]e,?\s+)?v?(?:ersion\s+)?2(?:\.0)?\b",
    ),
    ("MIT-0", r"\bMIT-0\b|MIT\s+No\s+Attribution"),
    ("MIT", r"opensource\.org/licenses?/MIT\b|\bMIT\b|Expat\s+licen[cs]e"),
    ("AGPL-3.0", r"GNU\s+Affero\s+General\s+Public|\bAGPL(?:[- ]?v?3(?:\.0)?)?\b"),
    ("LGPL-2.1", r"\bLGPL[- ]?v?2(?:\.1)?\b|GNU\s+Lesser\s+General\s+Public\s+Licen[cs]e[\s,]+version\s+2\.1"),
    ("LGPL-3.0", r"\bLGPL(?:[- ]?v?3(?:\.0)?)?\b|GNU\s+Lesser\s+General\s+Public"),
    (
        "GPL-2.0",
        r"\bGPL[- ]?v?2(?:\.0)?\b|"
        r"GNU\s+General\s+Public\s+Licen[cs]e[\s,(]+(?:as\s+published[^.]*?)?v(?:ersion)?\s*2\b",
    ),
    (
        "GPL-3.0",
        r"\bGPL[- ]?v?3(?:\.0)?\b|gnu\.org/licenses/gpl|GNU\s+General\s+Public\s+Licen[cs]e[\s,(]+v(?:ersion)?\s*3\b",
    ),
    ("GPL", r"\bGPL\b|GNU\s+General\s+Public\s+Licen[cs]e"),
    ("OFL-1.1", r"\bOFL\b|SIL\s+Open\s+Font|scripts\.sil\.org/OFL|openfontlicense\.org"),
    ("MPL-2.0", r"\bMPL[- ]?2(?:\.0)?\b|Mozilla\s+Public\s+Licen[cs]e"),
    ("ISC", r"\bISC\s+Licen[cs]e|Permission\s+to\s+use,\s+copy,\s+modify,\s+and(?:/or)?\s+distribute\s+this"),
    ("Zlib", r"\bzlib(?:/libpng)?\s+licen[cs]e"),
    ("BSD-3-Clause", r"\bBSD[- ]3|opensource\.org/licenses?/BSD-3|neither\s+the\s+name\s+of"),
    ("BSD-2-Clause", r"\bBSD[- ]2|Redistribution\s+and\s+use\s+in\s+source"),
    ("WTFPL", r"\bWTFPL\b"),
    ("LicenseRef-RoyaltyFree", r"royalty[- ]free\s+licen[cs]e"),
    ("LicenseRef-AllRightsReserved", r"all\s+rights\s+reserved"),
)
"""Ids and the words that tell them. Of two that begin at one place the first of this table counts."""
GRANT = re.compile(r"Permission\s+is\s+hereby\s+granted,?\s+free\s+of\s+charge", re.IGNORECASE)
KEEP_NOTICE = re.compile(r"above\s+copyright\s+notice\s+and\s+this\s+permission\s+notice", re.IGNORECASE)
NO_NAME = re.compile(r"neither\s+the\s+name\s+of|endorse\s+or\s+promote", re.IGNORECASE)
SPDX = re.compile(r"SPDX-License-Identifier:\s*([A-Za-z0-9.+() -]+?)\s*(?:\*/|-->|$)", re.MULTILINE)
AI = r"(?:A\.?I\.?|artificial\s+intelligence|machine[- ]learning|neural\s+networks?|(?:text\s+and\s+)?data\s+mining)"
FORBIDS_AI = re.compile(
    rf"\bNo[- ]?AI\b|(?:may|must|can|shall|should)\s*not[^.]{{0,120}}?\b{AI}\b"
    rf"|\bnot\s+(?:be\s+)?(?:used?|allowed|permitted)[^.]{{0,80}}?\b{AI}\b|prohibit\w*[^.]{{0,120}}?\b{AI}\b"
    rf"|\b{AI}\b[^.]{{0,80}}?\b(?:is|are)\s+(?:not\s+(?:allowed|permitted)|prohibited|forbidden)"
    rf"|\b{AI}\s+(?:use|usage|training)\s*[:=]\s*(?:no|false|forbidden|not\s+allowed|disallowed)\b",
    re.IGNORECASE,
)
ALLOWS_AI = re.compile(
    rf"\b{AI}\s+(?:use|usage|training)\s*[:=]\s*(?:yes|true|allowed|permitted)\b|\b{AI}\b[^.]{{0,60}}?\b(?:is|are)\s+(?:allowed|permitted)\b"
    rf"|\b(?:allowed|permitted)\s+for\s+(?:use\s+(?:by|with|in)\s+)?{AI}\b",
    re.IGNORECASE,
)
FREE_FOR_ALL = re.compile(
    r"CC0-1\.0|CC-BY(?:-[0-9A-Z.]+)*|MIT(?:-0)?|Apache-2\.0|BSD-[0-9A-Za-z-]+|ISC|Zlib|Unlicense|WTFPL|PDDL-1\.0|LicenseRef-PublicDomain"
)
LIMITED = re.compile(r"-(?:NC|ND)\b|-SA(?!-[34]\.0)")


def licences_in(text: str) -> list[str]:
    """SPDX ids (``LicenseRef-...`` where there is none) of the licences that a text names, the first named first."""
    declared = [" ".join(found.group(1).split()) for found in SPDX.finditer(text)]
    if declared:
        return list(dict.fromkeys(declared))
    found: list[tuple[int, int, str]] = []
    for pattern in (CREATIVE_ADDRESS, CREATIVE_ID, CREATIVE_NAME, BARE_NAME):
        found += [(one.start(), 0, _creative(one)) for one in pattern.finditer(text)]
    for rank, (name, words) in enumerate(OTHERS, start=1):
        one = re.search(words, text, re.IGNORECASE)
        if one is not None:
            found.append((one.start(), rank, name))
    grant = GRANT.search(text)
    if grant is not None:
        found.append((grant.start(), 0, "MIT" if KEEP_NOTICE.search(text) else "MIT-0"))
    return _distinct([name for _, _, name in sorted(found)], text)


def _distinct(names: list[str], text: str) -> list[str]:
    """Names once each, without those that another one says better."""
    every = set(names)
    creative = [name for name in names if name.startswith("CC")]
    drop = {"LicenseRef-AllRightsReserved"} if len(every) > 1 else set()
    if creative or every & {"Unlicense", "MIT", "Apache-2.0"}:
        drop.add("LicenseRef-PublicDomain")
    if "BSD-3-Clause" in every or ("BSD-2-Clause" in every and NO_NAME.search(text)):
        names = ["BSD-3-Clause" if name == "BSD-2-Clause" else name for name in names]
    if every & {"MIT-0"} and re.search(r"MIT-0|No\s+Attribution", text, re.IGNORECASE):
        drop.add("MIT")
    head = next((name for name in names if name not in drop), "")
    if head.startswith(("GPL", "LGPL", "AGPL", "MPL")):
        names = [next((one for one in names if one.startswith(head) and one not in drop and one != "GPL"), head)]
    if head == "GPL" and (version := re.search(r"GPL-\d\.\d", " ".join(every))):
        names = [version.group()]
    for name in creative:
        if any(other != name and other.startswith(f"{name}-") for other in creative) and not LIMITED.search(
            next(other for other in creative if other != name and other.startswith(f"{name}-"))[len(name) :]
        ):
            drop.add(name)
    return [name for name in dict.fromkeys(names) if name not in drop]


def _creative(found: re.Match[str]) -> str:
    """The id of a Creative Commons licence: ``CC-BY-SA-3.0-US``."""
    words = re.split(r"[\s,_-]+", re.sub(r"(?i)(non|share|no)-(?=commercial|alike|deriv)", r"\1", found["parts"]))
    kinds = {PARTS.get(word.lower(), "") for word in words}
    ordered = ["BY", *(kind for kind in ("NC", "SA", "ND") if kind in kinds)]
    version = found["version"] or ""
    version = f"{version}.0" if version and "." not in version else version
    port = (found["port"] or "").strip()
    port = PORTS.get(port.lower(), port.upper())
    plain = port in ("", "EN", "DEED", "LEG") or not version or version.startswith("4") or len(port) > 3
    return "-".join(["CC", *ordered, *([version] if version else []), *([] if plain else [port])])


def ai_use(licence: str, text: str) -> tuple[AiUse, str]:
    """Whether content may be used by AI, and what says so.

    Words about it in ``text`` decide; else a licence that allows every use allows this one. CC-BY-SA does, from 3.0 on:
    that the work is named and shared alike binds who passes it on. Licences that limit the use (NC, ND), the GPL and
    unknown ones say nothing about it.
    """
    if (found := FORBIDS_AI.search(text)) is not None:
        return "forbidden", f"the licence text says: {' '.join(found.group().split())[:100]}"
    if (found := ALLOWS_AI.search(text)) is not None:
        return "allowed", f"the licence text says: {' '.join(found.group().split())[:100]}"
    names = [name.strip() for name in re.split(r" (?:AND|OR) ", licence)]
    if all(FREE_FOR_ALL.fullmatch(name) and not LIMITED.search(name) for name in names):
        return "allowed", f"{licence} allows every use"
    return "unknown", f"{licence} says nothing about it" if licence != UNKNOWN else "no licence is known"
