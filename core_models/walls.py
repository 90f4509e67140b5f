"""Rigid frictionless walls at z = 0: two names, the same meaning in both methods."""

from core_models.errors import SceneError
from core_models.names import suggestion

UNILATERAL = "unilateral"
PLANE = "plane"

MEANING = {
    UNILATERAL: "nothing passes, everything may leave",
    PLANE: "what touches the wall is held at zero normal velocity from then on",
}


def check_wall(name: str) -> str:
    """The wall's name if there is such a wall; SceneError with the nearest one otherwise."""
    if name in MEANING:
        return name
    raise SceneError(f"no wall is called {name!r}; {suggestion(name, MEANING)}")
