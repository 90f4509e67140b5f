"""The deformed body as polygons and lines, from the deformed domains of the particles."""

import numpy as np

from mpm.particles import Particles


def particle_domains(
    particles: Particles, positions: np.ndarray, deformation_gradient: np.ndarray
) -> np.ndarray:
    """Deformed domains x_p + F (X - X_p) of all particles: (n, 4, 2) [m]."""
    return positions[:, None, :] + np.einsum(
        "nij,ncj->nci", deformation_gradient[:, :2, :2], particles.corners
    )


def outline(
    particles: Particles, positions: np.ndarray, deformation_gradient: np.ndarray
) -> dict[str, np.ndarray]:
    """Deformed boundary lines: ends of the boundary faces, averaged where two faces meet; r is not below 0."""
    lines = {}
    for name, faces in particles.faces.items():
        starts, ends = (
            _corners(particles, positions, deformation_gradient, faces[:, 0], (faces[:, 1] + k) % 4)
            for k in (0, 1)
        )
        line = np.concatenate([starts[:1], 0.5 * (starts[1:] + ends[:-1]), ends[-1:]])
        line[:, 0] = np.maximum(line[:, 0], 0.0)
        lines[name] = line
    return _joined(lines)


def _corners(
    particles: Particles,
    positions: np.ndarray,
    deformation_gradient: np.ndarray,
    which: np.ndarray,
    corner: np.ndarray,
) -> np.ndarray:
    """One deformed corner each of some particles' domains: (k, 2) [m]."""
    offsets = particles.corners[which, corner]
    return positions[which] + np.einsum("nij,nj->ni", deformation_gradient[which, :2, :2], offsets)


def _joined(lines: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Let the lines meet: foot and rear end on the axis, neighbours share the mean of their common corner."""
    lines["foot"][0, 0] = lines["rear"][-1, 0] = 0.0
    for name, following in (("foot", "side"), ("side", "rear")):
        corner = 0.5 * (lines[name][-1] + lines[following][0])
        lines[name][-1] = lines[following][0] = corner
    return lines
