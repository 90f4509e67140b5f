"""Patch test of every element: linear fields on distorted meshes, to round-off."""

import numpy as np

ROUND_OFF = 2e-12
GRADIENTS = {
    "plane-strain": np.array([[1.03, 0.05, 0.0], [-0.04, 0.96, 0.0], [0.0, 0.0, 1.0]]),
    "axisymmetric": np.diag([1.03, 0.95, 1.03]),
    "spatial": np.array([[1.03, 0.05, -0.02], [-0.04, 0.96, 0.03], [0.02, 0.01, 1.02]]),
}


def neo_hookean(gradient, bulk, shear):
    """Cauchy stress of the material of the patch (6,), components 11, 22, 33, 12, 23, 31 [Pa]."""
    ratio = np.linalg.det(gradient)
    left = gradient @ gradient.T * ratio ** (-2.0 / 3.0)
    stress = shear / ratio * (left - np.trace(left) / 3.0 * np.eye(3))
    stress += 0.5 * bulk * (ratio - 1.0 / ratio) * np.eye(3)
    return stress[[0, 1, 2, 0, 1, 2], [0, 1, 2, 1, 2, 0]]


def test_a_linear_field_gives_uniform_stress_and_no_force_inside(which, element, elastic, inner_nodes):
    """Every point has the law's stress of the gradient, no inner node feels a force, hourglass control nothing."""
    geometry = which[0]
    gradient = GRADIENTS[geometry]
    flat = gradient if geometry == "spatial" else gradient[:2, :2]
    solver = element(which, lambda x: x @ (flat.T - np.eye(len(flat))))
    bulk, shear = elastic.elasticity
    expected = neo_hookean(gradient, bulk, shear)
    assert np.abs(solver.points.fields()["stress"].array - expected).max() < ROUND_OFF * bulk
    forces, inner = solver.nodal_forces(), inner_nodes(solver.mesh)
    assert np.abs(forces[inner]).max() < ROUND_OFF * np.abs(forces).max()
    assert solver.ledger.hourglass < ROUND_OFF * solver.ledger.strain
    volumes = np.linalg.det(gradient) * solver.points.reference_volumes
    assert np.allclose(solver.point_volumes(), volumes, rtol=1e-12)
