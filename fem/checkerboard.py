"""How much the pressure of neighbouring elements alternates, beyond what a smooth field explains."""

import numpy as np

from fem.explicit import ExplicitSolver
from meshes.facets import find_facets


def checkerboard(solver: ExplicitSolver) -> float:
    """Alternating part of the mean stress over the stress [-]: 0 for smooth fields, 1 for alternating pressure alone.

        r_e = p_e - mean over the nodes of e of (sum_e V_e p_e / sum_e V_e round the node)
        C = 1/2 sqrt(mean over inner facets of (r_1 - r_2)^2) / sqrt(mean over the volume of sigma : sigma / 3)

    p_e is the mean of the mean stress over element e [Pa], V_e its current volume. The scale is the whole stress, since
    a cure takes away most of the pressure of a body that locks. A stress that is linear in position
    counts as smooth on an even mesh; elsewhere what is left of it falls with the size of the elements. 0 for a body
    without stress or without inner facets.
    """
    mesh, count = solver.mesh, len(solver.mesh.cells)
    volumes = solver.point_volumes().reshape(count, -1)
    stress = solver.points.fields()["stress"].array
    volume = volumes.sum(axis=1)
    pressure = (volumes * stress[:, :3].mean(axis=1).reshape(count, -1)).sum(axis=1) / volume
    square = (stress[:, :3] ** 2).sum(axis=1) + 2.0 * (stress[:, 3:] ** 2).sum(axis=1)
    scale = np.sqrt((volumes.ravel() * square).sum() / (3.0 * volume.sum()))
    rough = pressure - _smoothed(mesh.cells, volume, pressure)
    facets = find_facets(mesh.kind, mesh.points, mesh.cells)
    shared = np.flatnonzero(facets.uses == 2)
    if len(shared) == 0 or scale == 0.0:
        return 0.0
    pairs = shared[np.argsort(facets.key[shared], kind="stable")].reshape(-1, 2) // (
        len(facets.nodes) // count
    )
    jumps = rough[pairs[:, 0]] - rough[pairs[:, 1]]
    return float(0.5 * np.sqrt((jumps**2).mean()) / scale)


def _smoothed(cells: np.ndarray, volume: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Averages (m,) over the nodes of each element of the averages round them, weighed with volumes."""
    nodes, corners = cells.ravel(), cells.shape[1]
    total = np.bincount(nodes, weights=np.repeat(volume * values, corners))
    return (total / np.bincount(nodes, weights=np.repeat(volume, corners)))[cells].mean(axis=1)
