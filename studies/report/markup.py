"""Small pieces of HTML."""

import re
from collections.abc import Iterable, Mapping, Sequence
from html import escape

WORDY = 34  # letters of a cell above which its column holds running text
FAMILIES = re.compile(r"(fem|mpm)\b", re.IGNORECASE)
UNIT = re.compile(r" \[([^\]]+)\]")
MARKS = {"on": "on", "stable": "on", "yes": "on", "off": "off", "FAILED": "bad", "failed": "bad", "✓": "on"}
"""Cells that are a verdict, and their classes in the style."""
TOGETHER = re.compile(r"(?<=\d) (?=(?:%|±|(?:s|µs|mm|K|kN|MPa|min)\b))|(?<=[±≤~]) | (?=\*$)")
FIXED = "\u00a0"  # a space at which no line ends
STAR, BEST = "*", "best"  # end of a cell that is the best of its kind, and its class


def table(head: Sequence[str], rows: Sequence[Sequence[str]], places: Mapping[str, str] | None = None) -> str:
    """A table of plain text; the first cell of a row is its header.

    places : titles of sections and their places on the page; a first cell that is such a title leads there. Methods
    have their colours, units stand back, and a column of running text is left aligned and wraps.
    """
    wordy = [max((len(row[k]) for row in rows), default=0) > WORDY for k in range(len(head))]
    top = "".join(
        f"<th{_class(wordy[k] and k > 0, text)}>{_with_unit(text)}</th>" for k, text in enumerate(head)
    )
    lines = "".join(
        "<tr>" + "".join(_cell(k, text, wordy[k], places or {}) for k, text in enumerate(row)) + "</tr>"
        for row in rows
    )
    return f'<div class="wide"><table><thead><tr>{top}</tr></thead><tbody>{lines}</tbody></table></div>'


def _cell(index: int, text: str, wordy: bool, places: Mapping[str, str]) -> str:
    if index > 0:
        return f"<td{_class(wordy, _mark(text))}>{_whole(text)}</td>"
    content = f'<a href="#{places[text]}">{_whole(text)}</a>' if text in places else _with_unit(text)
    return f'<th scope="row"{_class(wordy, text)}>{content}</th>'


def _mark(text: str) -> str:
    if text.endswith(STAR):
        return BEST
    return "bad" if text.endswith(" not met") else MARKS.get(text, "")


def _class(wordy: bool, text: str) -> str:
    family = FAMILIES.match(text)
    names = (
        ["words"] * wordy
        + ([family[1].lower()] if family else [])
        + [text] * (text in (*MARKS.values(), BEST))
    )
    return f' class="{" ".join(names)}"' if names else ""


def _whole(text: str) -> str:
    """Escaped; numbers stay with their units, uncertainties and marks on one line."""
    return TOGETHER.sub(FIXED, escape(text))


def _with_unit(text: str) -> str:
    return UNIT.sub(r' <span class="unit">\1</span>', _whole(text))


def panels(pictures: Iterable[str], caption: str, first: str = "") -> str:
    """Figures side by side where there is room, with one caption; first : what stands before them."""
    inner = f"<div>{first}</div>" * bool(first) + "".join(
        f"<figure>{picture}</figure>" for picture in pictures
    )
    return f'<div class="pair">{inner}</div>{note(caption) if caption else ""}' if inner else ""


def note(text: str) -> str:
    """A remark in small print."""
    return f'<p class="note">{_whole(text)}</p>'


def section(title: str, *content: str, place: str = "") -> str:
    """A section with its heading, at a place that links can name; nothing at all when there is no content."""
    inner = "".join(content)
    here = f' id="{escape(place)}"' if place else ""
    return f"<section{here}><h2>{escape(title)}</h2>{inner}</section>" if inner else ""


def items(kind: str, entries: Iterable[tuple[str, str]]) -> str:
    """A list of (class, text)."""
    return (
        f'<ul class="{kind}">'
        + "".join(f'<li class="{c}">{_whole(text)}</li>' for c, text in entries)
        + "</ul>"
    )
