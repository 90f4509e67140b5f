"""The gallery as Markdown."""

from collections.abc import Iterable, Sequence

from studies.gallery.entry import Entry

LEAD = (
    "Pictures from the studies. Each comes with the command that gives the same and with one number, which "
    "`make gallery` asserts before it writes this page."
)


def gallery_page(entries: Sequence[Entry]) -> str:
    """The whole page; pictures lie in images/."""
    return "\n".join(["# Gallery", "", LEAD, "", *(line for entry in entries for line in _lines(entry))])


def picture_file(entry: Entry) -> str:
    """Path of an entry's picture beside the page."""
    return f"images/gallery-{entry.name}.svg"


def _lines(entry: Entry) -> Iterable[str]:
    yield from (f"## {entry.title}", "", entry.text, "", f"    {entry.command}", "")
    yield from (f"![{entry.title}]({picture_file(entry)})", "", f"Asserted: {entry.assertion}.", "")
