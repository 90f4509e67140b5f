"""The gallery of docs/gallery.md: pictures from the studies, each with a number that it must show."""
