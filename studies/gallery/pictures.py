"""Figures of reports as documents of their own, which follow light and dark like the page."""

import re

from studies.report.document import asset

SHADES = re.compile(r"--(?:page|ink|faint|grid|line|fem|mpm): #[0-9a-f]+;")


def standalone(svg: str) -> str:
    """A figure of a report with the page's colours inside it, light or dark as the reader has it."""
    light, dark = _shades()
    style = f"svg{{{light}background:var(--page)}}@media (prefers-color-scheme:dark){{svg{{{dark}}}}}"
    svg = re.sub(r' data-curves="[^"]*"', "", svg, count=1)
    return re.sub(r"(<svg [^>]*>)", lambda head: f"{head[1]}<style>{style}</style>", svg, count=1)


def _shades() -> tuple[str, str]:
    """The colours of the page's style, light and dark: the first and the second time that each is named."""
    found: dict[str, list[str]] = {}
    for shade in SHADES.findall(asset("style.css")):
        found.setdefault(shade.partition(":")[0], []).append(shade)
    return tuple("".join(values[min(k, len(values) - 1)] for values in found.values()) for k in (0, 1))
