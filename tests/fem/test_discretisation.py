"""The element: its tables, patch test, and forces as the gradient of the stored energy."""

import numpy as np
import pytest

from meshes.geometry import volumes_of_revolution

SOME = 0.2  # of an element's size: how far nodes are moved at random


@pytest.fixture
def solver_at(build, elastic):
    """An elastic body whose nodes were moved from its mesh to given places, at rest."""

    def place(mesh, positions):
        solver = build("fem-explicit", mesh, elastic)
        solver.positions[:] = positions
        solver.advance()
        assert np.array_equal(solver.positions, positions)
        return solver

    return place


@pytest.fixture
def mesh(bar, distorted):
    """A distorted bar that hovers above the wall."""
    return distorted(bar(3, 4, gap=2.0), SOME)


def stored_energy(solver, bulk, shear):
    """Hyperelastic energy of the points' deformation gradients [J]."""
    gradient = solver.points.fields()["deformation_gradient"].array
    ratio = np.linalg.det(gradient)
    isochoric = (gradient**2).sum(axis=(1, 2)) * ratio ** (-2.0 / 3.0)
    density = 0.5 * shear * (isochoric - 3.0) + 0.5 * bulk * (0.5 * (ratio**2 - 1.0) - np.log(ratio))
    return float(solver.points.reference_volumes @ density)


def test_each_point_lies_in_its_own_domain(build, mesh, elastic):
    """Domains come in the order of the points."""
    solver = build("fem-explicit", mesh, elastic)
    corners, points = solver.domains(), solver.point_positions()
    edges = np.roll(corners, -1, axis=1) - corners
    to_point = points[:, None, :] - corners
    assert (edges[..., 0] * to_point[..., 1] - edges[..., 1] * to_point[..., 0] > 0.0).all()


def test_domains_fill_the_body(build, mesh, elastic):
    """The domains' volumes of revolution sum to the body's, and so do the points' volumes."""
    solver = build("fem-explicit", mesh, elastic)
    body = volumes_of_revolution(mesh.corners()).sum()
    assert volumes_of_revolution(solver.domains()).sum() == pytest.approx(body, rel=1e-13)
    assert solver.point_volumes().sum() == pytest.approx(body, rel=1e-13)


def test_lumped_mass_is_the_exact_mass(build, mesh, elastic):
    """The nodes' masses are positive and sum to density times the exact volume of revolution."""
    solver = build("fem-explicit", mesh, elastic)
    assert (solver.nodal_mass > 0.0).all()
    exact = elastic.density * volumes_of_revolution(mesh.corners()).sum()
    assert solver.nodal_mass.sum() == pytest.approx(exact, rel=1e-13)
    assert solver.mass == pytest.approx(exact, rel=1e-13)


def test_uniform_deformation_gives_the_exact_uniform_stress(solver_at, mesh, elastic):
    """Patch test, plane part and hoop: a linear displacement gives the law's stress at every point."""
    gradient = np.array([[1.03, 0.0, 0.0], [0.04, 0.95, 0.0], [0.0, 0.0, 1.03]])
    solver = solver_at(mesh, mesh.points @ gradient[:2, :2].T)
    ratio = np.linalg.det(gradient)
    left = gradient @ gradient.T * ratio ** (-2.0 / 3.0)
    bulk, shear = elastic.elasticity
    expected = shear / ratio * (left - np.trace(left) / 3.0 * np.eye(3))
    expected += 0.5 * bulk * (ratio - 1.0 / ratio) * np.eye(3)
    six = expected[[0, 1, 2, 0, 1, 2], [0, 1, 2, 1, 2, 0]]
    assert np.abs(solver.points.fields()["stress"].array - six).max() < 1e-12 * bulk


def test_uniform_stress_leaves_inner_nodes_without_force(solver_at, mesh):
    """Patch test: u_r = a r, u_z = b z puts no force on any node inside the body, also next to the axis."""
    solver = solver_at(mesh, mesh.points * [1.03, 0.95])
    forces = solver.nodal_forces()
    rim = np.unique(np.concatenate([mesh.boundaries[name].ravel() for name in ("foot", "side", "rear")]))
    inner = np.setdiff1d(np.arange(len(forces)), rim)
    free = mesh.points[inner, 0] > 0.0
    largest = np.abs(forces).max()
    assert np.abs(forces[inner[free]]).max() < 1e-12 * largest
    assert np.abs(forces[inner, 1]).max() < 1e-12 * largest


def test_forces_are_the_gradient_of_the_stored_energy(solver_at, mesh, distorted, elastic):
    """Mean dilatation is variationally consistent: f = - dW/dx at a distorted, unevenly deformed mesh."""
    positions = distorted(mesh, 0.1, seed=1).points * [1.05, 0.97]
    forces = solver_at(mesh, positions).nodal_forces()
    step = 1e-5 * positions[:, 0].max()
    gradient = np.zeros_like(forces)
    for node, axis in np.ndindex(forces.shape):
        if axis == 0 and mesh.points[node, 0] == 0.0:
            gradient[node, axis] = -forces[node, axis]  # the axis holds it: no energy to compare with
            continue
        energies = []
        for sign in (-1.0, 1.0):
            moved = positions.copy()
            moved[node, axis] += sign * step
            energies.append(stored_energy(solver_at(mesh, moved), *elastic.elasticity))
        gradient[node, axis] = (energies[1] - energies[0]) / (2.0 * step)
    assert np.abs(forces + gradient).max() < 1e-7 * np.abs(forces).max()


def test_rigid_translation_leaves_the_body_without_stress(build, mesh, elastic):
    """A body that only flies along the axis keeps its velocity and no stress."""
    solver = build("fem-explicit", mesh, elastic, velocity=100.0)
    for _ in range(50):
        solver.advance()
    assert np.abs(solver.points.fields()["stress"].array).max() < 1e-10 * elastic.elasticity.bulk_modulus
    assert np.allclose(solver.velocities, [0.0, 100.0], rtol=1e-10, atol=1e-9)
