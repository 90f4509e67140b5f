"""Reports: self-contained HTML pages with vector figures that follow light and dark, Markdown, CSV tables."""
