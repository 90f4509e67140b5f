"""The nearest of the valid names to a wrong one."""

import difflib
from collections.abc import Iterable

ALIKE = 0.6  # least likeness (difflib's ratio) of a name that is suggested


def suggestion(wrong: str, valid: Iterable[str], none: str = "nothing may stand here") -> str:
    """The remedy for an unknown name: the valid one that is like it, if there is one, and all of them.

    none : what to say where no name is valid.
    """
    known = sorted(valid)
    if not known:
        return none
    near = difflib.get_close_matches(str(wrong), known, n=1, cutoff=ALIKE)
    guess = f"did you mean '{near[0]}'? " if near else ""
    return f"{guess}valid: {', '.join(known)}"
