"""Elements whose locking cure leaves modes without stiffness where a body of revolution flows under tension.

The cures project the dilatation of an element's points on fewer modes than there are points. In a patch of flat
quadratic elements, held all round but at its side and pulled evenly, the other modes have negative stiffness once all
points flow (quad9 with linear, quad8 and tri6 with mean dilatation). Without a cure, or with as many points as modes,
none has: it is not the body's. A bar necks with a wrinkled surface; with mean dilatation quad8 wrinkles in any shape.
"""

import numpy as np

from core_models.errors import UnsupportedError
from core_models.geometry import Axisymmetric, Geometry
from core_models.material import Material
from fem.cures.choice import MEAN, NONE
from meshes.kinds import KINDS
from meshes.mesh import Mesh

FLATTEST = 4.0  # longer over shorter extent: bars neck smoothly with 2, with wrinkles with 8


def refuse_spurious_modes(mesh: Mesh, geometry: Geometry, material: Material, cure: str) -> None:
    """Refuse elements with modes that soften of themselves; UnsupportedError with what to use instead."""
    kind = KINDS[mesh.kind]
    if not isinstance(geometry, Axisymmetric) or material.flow is None or kind.degree == 1 or cure == NONE:
        return
    instead = "use quad8 with integration='reduced', quad4, or cure='none'"
    if cure == MEAN and mesh.kind != "tri6":
        raise UnsupportedError(
            f"{mesh.kind} with {cure} wrinkles where a body of revolution necks: {instead}"
        )
    flat = flatness(mesh)
    worst = int(flat.argmax())
    if flat[worst] > FLATTEST:
        raise UnsupportedError(
            f"{mesh.kind} with {cure} wrinkles where a body of revolution necks if its elements are flat, and element "
            f"{worst} is {flat[worst]:.3g} times as long as wide, more than {FLATTEST:g}: {instead}, or less grading"
        )


def flatness(mesh: Mesh) -> np.ndarray:
    """Longer over shorter extent (m,) of the elements: the ratio of the principal axes of their corners."""
    corners = mesh.points[mesh.cells[:, : KINDS[mesh.kind].corners]]
    extents = np.linalg.svd(corners - corners.mean(axis=1, keepdims=True), compute_uv=False)
    return extents[:, 0] / extents[:, -1]
