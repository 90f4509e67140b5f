"""The nearest of the valid names to a wrong one."""

import difflib
from collections.abc import Iterable


def nearest(wrong: str, valid: Iterable[str]) -> str:
    """The valid name most like `wrong`."""
    return difflib.get_close_matches(str(wrong), list(valid), n=1, cutoff=0.0)[0]
