"""Python with its tokens told apart, for pages: kinds of tokens by short names, nothing of it as markup."""

from __future__ import annotations

from typing import Final

from pygments.lexers.python import PythonLexer
from pygments.token import Comment, Keyword, Name, Number, Operator, String, _TokenType

_KINDS: Final = (
    (Comment, "c"),
    (String, "s"),
    (Number, "n"),
    (Keyword, "k"),
    (Name.Builtin, "b"),
    (Name.Function, "f"),
    (Name.Class, "f"),
    (Name.Decorator, "f"),
    (Operator.Word, "k"),
)
_LEXER: Final = PythonLexer(stripnl=False, ensurenl=False)


def code_tokens(text: str) -> list[tuple[str, str]]:
    """Kind and text of each run of tokens of one kind; the texts together are the whole text."""
    found: list[tuple[str, str]] = []
    for token, part in _LEXER.get_tokens(text):
        kind = next((name for parent, name in _KINDS if _is(token, parent)), "")
        if found and (found[-1][0] == kind or not part.strip()):
            found[-1] = (found[-1][0], found[-1][1] + part)
        else:
            found.append((kind, part))
    return found


def _is(token: _TokenType, parent: _TokenType) -> bool:
    return token in parent
