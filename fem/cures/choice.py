"""Which locking cures an element can have, and which one it gets."""

import numpy as np

from core_models.errors import SceneError
from core_models.names import suggestion
from fem.cures.linear_dilatation import LinearDilatation, linear_dilatation
from fem.cures.mean_dilatation import MeanDilatation
from fem.cures.nodal_average import NodalAverage
from fem.elements import FULL
from fem.tables import Space
from meshes.mesh import Mesh

NONE, MEAN, LINEAR, NODAL = "none", "mean-dilatation", "linear-dilatation", "nodal-average"
CURES = (NONE, MEAN, LINEAR, NODAL)

Cure = MeanDilatation | LinearDilatation | NodalAverage | None

_VALID = {
    "quad4": (MEAN,), "hex8": (MEAN,), "tri3": (NODAL,), "tet4": (NODAL,), "tri6": (MEAN,), "tet10": (MEAN,),
    "quad8": (LINEAR, MEAN), "quad9": (LINEAR, MEAN), "hex20": (LINEAR, MEAN), "hex27": (LINEAR, MEAN),
}  # fmt: skip
"""Cures of each kind with full integration; the first is the default."""


def cures_of(kind: str, integration: str) -> tuple[str, ...]:
    """Names of the cures that an element can have, its default first."""
    return (*(_VALID[kind] if integration == FULL else ()), NONE)


def find_cure(name: str | None, kind: str, integration: str) -> str:
    """The cure of that name if it does something for the element; by default the element's own.

    Raises SceneError for an unknown one, and for one that would change nothing or does not exist for the element.
    """
    valid = cures_of(kind, integration)
    if name is None:
        return valid[0]
    if name in valid:
        return name
    if name not in CURES:
        raise SceneError(f"no locking cure is called {name!r}; {suggestion(name, CURES)}")
    if integration != FULL:
        why = "has too few points to lock"
    elif kind in ("tri3", "tet4"):
        why = "has one point, so there is nothing to project within the element"
    else:
        why = "has other cures"
    raise SceneError(
        f"cure {name!r} is void: {kind} with {integration} integration {why}; use {' or '.join(valid)}"
    )


def make_cure(name: str, mesh: Mesh, space: Space, share: float) -> Cure:
    """The cure of that name, as `find_cure` returns it, for a mesh; share : see `fem.cures.own_share`."""
    if name == MEAN:
        return MeanDilatation(share)
    if name == LINEAR:
        places = np.einsum("qa,eai->eqi", space.shape, mesh.points[mesh.cells])
        return linear_dilatation(places, space.tables.weights, share)
    if name == NODAL:
        return NodalAverage(np.ones((len(mesh.points), 2)))
    return None
