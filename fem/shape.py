"""The deformed body as polygons and lines, for pictures and quantities of interest."""

import numpy as np

# Local coordinates of the corners of the quarter that belongs to each of the 2 x 2 points, in scikit-fem's order
# of points (first coordinate runs slowest) and counter-clockwise.
_LOW, _MIDDLE, _HIGH = 0.0, 0.5, 1.0


def element_domains(corners: np.ndarray) -> np.ndarray:
    """Quarters of bilinear quads: corners (m, 4, 2) -> polygons (4 m, 4, 2), one for each quadrature point."""
    quarters = []
    for s0, s1 in ((_LOW, _MIDDLE), (_MIDDLE, _HIGH)):
        for t0, t1 in ((_LOW, _MIDDLE), (_MIDDLE, _HIGH)):
            quarters.append([(s0, t0), (s1, t0), (s1, t1), (s0, t1)])
    local = np.array(quarters)
    s, t = local[..., 0], local[..., 1]
    shape = np.stack([(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t], axis=-1)
    return np.einsum("qcI,eIk->eqck", shape, corners).reshape(-1, 4, 2)


def outline(boundaries: dict[str, np.ndarray], positions: np.ndarray) -> dict[str, np.ndarray]:
    """Deformed polylines of the named boundaries but the axis, from ordered node pairs."""
    lines = {}
    for name, pairs in boundaries.items():
        if name != "axis":
            lines[name] = positions[np.append(pairs[:, 0], pairs[-1, 1])]
    return lines
