"""Help with misspelt names."""

from collections.abc import Iterable
from difflib import get_close_matches


def nearest(name: str, valid: Iterable[str]) -> str:
    """'did you mean ...?' when one is close, else the list of all valid names."""
    valid = sorted(valid)
    close = get_close_matches(name, valid, n=1)
    if close:
        return f"did you mean '{close[0]}'?"
    return "valid: " + ", ".join(valid)
