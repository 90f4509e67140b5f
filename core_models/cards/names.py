"""Unknown names: the nearest valid one, and all of them."""

from collections.abc import Iterable
from difflib import get_close_matches


def valid_names(name: str, valid: Iterable[str]) -> str:
    """The remedy for an unknown name: the nearest of the valid names, if one is near, and their list."""
    known = sorted(valid)
    if not known:
        return "nothing may stand here"
    near = get_close_matches(name, known, n=1)
    suggestion = f"did you mean {near[0]}? " if near else ""
    return f"{suggestion}valid here: {', '.join(known)}"
