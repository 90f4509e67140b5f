"""Small pieces of HTML."""

from collections.abc import Iterable
from html import escape


def table(head: Iterable[str], rows: Iterable[Iterable[str]], words: tuple[int, ...] = ()) -> str:
    """A table; the first cell of a row is its header; columns in `words` hold running text."""

    def cell(tag: str, index: int, content: str) -> str:
        kind = ' class="words"' if index in words else ""
        return f"<{tag}{kind}>{content}</{tag}>"

    top = "".join(cell("th", i, content) for i, content in enumerate(head))
    body = "".join(
        "<tr>"
        + "".join(cell("th" if i == 0 else "td", i, content) for i, content in enumerate(row))
        + "</tr>"
        for row in rows
    )
    return f'<div class="wide"><table><thead><tr>{top}</tr></thead><tbody>{body}</tbody></table></div>'


def panels(pictures: Iterable[str], caption: str) -> str:
    """Figures side by side where there is room, with one caption."""
    inner = "".join(f"<figure>{picture}</figure>" for picture in pictures)
    return f'<div class="pair">{inner}</div>{note(caption)}' if inner else ""


def note(text: str) -> str:
    """A remark in small print."""
    return f'<p class="note">{escape(text)}</p>'


def section(title: str, *content: str) -> str:
    """A section with its heading; nothing at all when there is no content."""
    inner = "".join(content)
    return f"<section><h2>{escape(title)}</h2>{inner}</section>" if inner else ""


def items(kind: str, entries: Iterable[tuple[str, str]]) -> str:
    """A list of (class, text)."""
    return (
        f'<ul class="{kind}">'
        + "".join(f'<li class="{c}">{escape(text)}</li>' for c, text in entries)
        + "</ul>"
    )
