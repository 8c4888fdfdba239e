"""Builds the documentation's site: pages that open from the disk, with a search, and no request to anywhere."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Final

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup
from pygments.formatters import HtmlFormatter

from c4s.errors import BadInput
from c4s.files import write_text
from c4s.folders import beside, check_own, put_folder
from manual.commands import commands_page
from manual.contents import ROOT, SECTIONS, ManualPage, pages
from manual.formats import formats_page
from manual.text import PageText, page_text

MARKER: Final = ".c4s-manual"
STATIC: Final = Path(__file__).parent / "static"
PICTURES: Final = (".png", ".jpg", ".svg")
MADE: Final[dict[str, Callable[[], str]]] = {
    "reference/commands.md": commands_page,
    "reference/formats.md": lambda: formats_page(ROOT / "docs" / "schemas"),
}
DARK: Final = "@media screen and (prefers-color-scheme: dark)"


def build_manual(out: Path) -> Path:
    """Write the site into a folder, in place of an older one; returns its first page.

    Raises:
        BadInput: the folder holds something else, or a page links to a page or heading that there is not.
    """
    check_own(out, MARKER)
    listed = pages()
    targets = {page.source: page.target for page in listed}
    texts = {page: page_text(page.source, _markdown(page), targets.get, _is_picture) for page in listed}
    if broken := _broken(texts):
        raise BadInput("links to nothing: " + "; ".join(broken))
    with beside(out) as scratch:
        site = scratch / out.name
        shutil.copytree(STATIC, site / "static")
        write_text(site / "static" / "code.css", _colours())
        write_text(site / "static" / "searched.js", f"window.searched = {json.dumps(_searched(texts))};\n")
        for picture in {link for text in texts.values() for link in text.links if _is_picture(link)}:
            (site / picture).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / picture, site / picture)
        _write(site, texts)
        write_text(site / MARKER, "")
        put_folder(site, out, marker=MARKER)
    return out / "index.html"


def _markdown(page: ManualPage) -> str:
    made = MADE.get(page.source)
    return made() if made else (ROOT / page.source).read_text(encoding="utf-8")


def _is_picture(path: str) -> bool:
    return path.endswith(PICTURES) and (ROOT / path).is_file()


def _broken(texts: dict[ManualPage, PageText]) -> list[str]:
    """Links whose page or heading is not there."""
    anchors = {page.target: {anchor for _, anchor, _ in text.headings} for page, text in texts.items()}
    return [
        f"{page.source} to {link}"
        for page, text in texts.items()
        for link in text.links
        for target, _, anchor in [link.partition("#")]
        if not _is_picture(target) and anchor and anchor not in anchors[target]
    ]


def _searched(texts: dict[ManualPage, PageText]) -> list[list[str]]:
    """For each part below a heading: page, anchor, titles, text."""
    rows = []
    for page, text in texts.items():
        names = {anchor: name for _, anchor, name in text.headings}
        for anchor, name in names.items():
            words = " ".join(" ".join(part for at, part in text.parts if at == anchor).split())
            rows.append([page.target, anchor, text.title, "" if name == text.title else name, words])
    return rows


def _write(site: Path, texts: dict[ManualPage, PageText]) -> None:
    environment = Environment(loader=PackageLoader("manual"), autoescape=True, undefined=StrictUndefined)
    template = environment.get_template("page.html.j2")
    sections = [
        (title, [(page.target, text.title) for page, text in texts.items() if page.section == title])
        for title, _ in SECTIONS
    ]
    order = list(texts)
    for place, (page, text) in enumerate(texts.items()):
        near = [order[at] if 0 <= at < len(order) else None for at in (place - 1, place + 1)]
        html = template.render(
            root="../" * page.target.count("/"),
            page=page,
            text=text,
            body=Markup(text.html),
            sections=sections,
            near=[(one.target, texts[one].title) if one else None for one in near],
        )
        write_text(site / page.target, html)


def _colours() -> str:
    light = HtmlFormatter(style="default").get_style_defs(".page pre")
    dark = HtmlFormatter(style="github-dark").get_style_defs(".page pre")
    return f"{light}\n{DARK} {{\n{dark}\n}}\n.page pre {{ background: var(--panel); }}\n"
