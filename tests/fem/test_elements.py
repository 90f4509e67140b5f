"""Every element as geometry: mass, volume, and the part of the body that each point stands for."""

import numpy as np
import pytest

from meshes.geometry import volumes_of_revolution

BLOCK = 1.0  # m^3 of a block; axisymmetric ones are rings between the inner radius 0.7 m and 1.7 m


@pytest.fixture
def body(which, element):
    """A distorted block of an element, and its volume [m^3]."""
    volume = np.pi * (1.7**2 - 0.7**2) if which[0] == "axisymmetric" else BLOCK
    return element(which), volume


def hexahedron_volumes(corners):
    """Volumes of hexahedra (n, 8, 3) with flat faces, as twelve tetrahedra with their centres [m^3]."""
    faces = ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7))
    centre = corners.mean(axis=1)
    total = np.zeros(len(corners))
    for a, b, c, d in faces:
        for i, j, k in ((a, b, c), (a, c, d)):
            edges = corners[:, [i, j, k]] - centre[:, None]
            total += np.linalg.det(edges) / 6.0
    return total


def test_mass_is_positive_and_that_of_the_body(body, elastic):
    """Nodal masses are positive and sum, like the points' volumes, to the exact volume times density."""
    solver, volume = body
    assert (solver.nodal_mass > 0.0).all()
    assert solver.mass == pytest.approx(elastic.density * volume, rel=1e-12)
    assert solver.point_volumes().sum() == pytest.approx(volume, rel=1e-12)


def test_domains_fill_the_body(body):
    """The points' domains do not leave a gap: their volumes sum to the body's, all positive."""
    solver, volume = body
    corners = solver.domains()
    assert len(corners) == solver.points.n
    if solver.mesh.dimension == 3:
        volumes = hexahedron_volumes(corners)
    elif type(solver.geometry).__name__ == "Axisymmetric":
        volumes = volumes_of_revolution(corners)
    else:
        x, y = corners[..., 0], corners[..., 1]
        volumes = 0.5 * (x * np.roll(y, -1, axis=1) - np.roll(x, -1, axis=1) * y).sum(axis=1)
    assert (volumes > 0.0).all()
    assert volumes.sum() == pytest.approx(volume, rel=1e-12)


def test_a_rigid_motion_leaves_no_stress(which, element):
    """A turn by 100 degrees and a shift (along the axis if there is one) give neither stress nor force."""
    geometry, angle = which[0], np.deg2rad(100.0)
    turn = np.eye(3)
    if geometry != "axisymmetric":
        turn[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    if geometry == "spatial":
        turn = turn @ turn[[2, 0, 1]][:, [2, 0, 1]]
    dimension = 3 if geometry == "spatial" else 2
    shift = np.array([0.0, 0.0, 2.0] if dimension == 3 else [0.0, 2.0])
    solver = element(which, lambda x: x @ turn[:dimension, :dimension].T + shift - x)
    assert np.abs(solver.points.fields()["stress"].array).max() < 1e-13 * 130e9
    assert np.abs(solver.nodal_forces()).max() < 1e-12 * 130e9
    assert solver.ledger.hourglass < 1e-20 * 130e9
