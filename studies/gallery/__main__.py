"""Draw the gallery: `python -m studies.gallery docs` writes docs/gallery.md and its pictures, if every number holds."""

import argparse
import sys
from pathlib import Path

from core_models.atomic import replacing
from studies.gallery.entries import ENTRIES
from studies.gallery.page import gallery_page, picture_file

UNMET = 1


def main() -> int:
    """Make all entries; status 1, with nothing written, when some number does not hold."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", metavar="DIR", type=Path, help="folder of gallery.md")
    folder = parser.parse_args().folder
    made = {}
    for entry in ENTRIES:
        made[entry] = entry.make()
        verdict = "holds" if entry.holds(made[entry].number) else "DOES NOT HOLD"
        print(
            f"{entry.name}: {made[entry].number:.6g} {entry.unit}; {entry.assertion}: {verdict}", flush=True
        )
    if not all(entry.holds(shown.number) for entry, shown in made.items()):
        return UNMET
    (folder / "images").mkdir(parents=True, exist_ok=True)
    for entry, shown in made.items():
        _write(folder / picture_file(entry), shown.picture)
    _write(folder / "gallery.md", gallery_page(ENTRIES))
    return 0


def _write(path: Path, text: str) -> None:
    with replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main())
