"""Markdown to HTML: headings that can be linked, code in colours, links between pages, no markup of its own."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Final

from markdown_it import MarkdownIt
from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import get_lexer_by_name
from pygments.lexers.special import TextLexer
from pygments.util import ClassNotFound

EXTERNAL: Final = re.compile(r"[a-z]+:")
SCROLLED: Final = (
    ("<pre>", '<pre tabindex="0">'),
    ("<table>", '<div class="wide" tabindex="0"><table>'),
    ("</table>", "</table></div>"),
)
"""What may be wider than the page is scrolled, by keys too."""
SHELL: Final = {"sh", "", "console"}


@dataclass
class PageText:
    """A page's HTML and what is told of it elsewhere."""

    title: str
    html: str
    headings: list[tuple[int, str, str]] = field(default_factory=list)
    """Level, anchor and text, in order."""
    parts: list[tuple[str, str]] = field(default_factory=list)
    """For the search: the anchor of a heading, and the plain text below it."""
    links: list[str] = field(default_factory=list)
    """Links within the site, from its root, with their anchors."""


def page_text(
    source: str, markdown: str, target_of: Callable[[str], str | None], files: Callable[[str], bool]
) -> PageText:
    """A page.

    Args:
        source: path of the Markdown from the root.
        markdown: its text.
        target_of: the page that a Markdown file becomes, from the site's root; None where it becomes none.
        files: whether the site shows a file of the checkout (a picture).
    """
    reader = MarkdownIt("commonmark", {"html": False, "highlight": _coloured}).enable("table")
    tokens = reader.parse(markdown)
    page = PageText(title=source, html="")
    used: set[str] = set()
    anchor = ""
    for place, token in enumerate(tokens):
        if token.type == "heading_open":
            inline = tokens[place + 1]
            anchor, level = _anchor(_plain(inline), used), int(token.tag[1])
            token.attrSet("id", anchor)
            if level == 1:
                page.title = _plain(inline)
            page.headings.append((level, anchor, _plain(inline)))
            page.parts.append((anchor, _plain(inline)))
        elif token.type in ("inline", "fence", "code_block"):
            text = _plain(token) if token.type == "inline" else token.content
            if tokens[place - 1].type != "heading_open":
                page.parts.append((anchor, text))
        unlinked = False
        for child in token.children or ():
            if child.type in ("link_open", "image"):
                unlinked = not _linked(child, source, target_of, files, page.links)
            if unlinked and child.type in ("link_open", "link_close"):
                child.tag = "span"
    depth = (target_of(source) or source).count("/")
    html = str(reader.renderer.render(tokens, reader.options, {}))
    for plain, reached in SCROLLED:
        html = html.replace(plain, reached)
    page.html = html.replace('="site:/', f'="{"../" * depth}')
    return page


def _linked(
    token: Any, source: str, target_of: Callable[[str], str | None], files: Callable[[str], bool], links: list[str]
) -> bool:
    """A link or picture as from where the page will lie. False for one to what is no part of the site."""
    name = "href" if token.type == "link_open" else "src"
    address = str(token.attrGet(name))
    if EXTERNAL.match(address):
        return True
    path, _, anchor = address.partition("#")
    here = posixpath.normpath(posixpath.join(posixpath.dirname(source), path)) if path else source
    target = target_of(here) or (here if files(here) else None)
    if target is None:
        token.attrs = {"title": f"{here}, in the checkout"}
        return False
    links.append(target + (f"#{anchor}" if anchor else ""))
    token.attrSet(name, f"site:/{links[-1]}")
    return True


def _plain(token: Any) -> str:
    """The text of an inline token without its markup."""
    return "".join(child.content if child.type != "softbreak" else " " for child in token.children or ())


def _anchor(text: str, used: set[str]) -> str:
    """As code hosts make it: lower case, words joined by hyphens, numbered where it is taken."""
    base = re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")
    name, number = base, 0
    while name in used:
        number += 1
        name = f"{base}-{number}"
    used.add(name)
    return name


def _coloured(code: str, language: str, _: str) -> str:
    try:
        lexer = get_lexer_by_name("bash" if language in SHELL else language)
    except ClassNotFound:
        lexer = TextLexer()
    return str(highlight(code, lexer, HtmlFormatter(nowrap=True)))
