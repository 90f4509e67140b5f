"""A body that starts deformed or moving, in both methods."""

import numpy as np
import pytest

from core_models.bulk_viscosity import BulkViscosity
from meshes.block import block
from tests.conftest import CELL

STRETCH = np.array([[1.02, 0.01], [0.01, 0.97]])


def in_plane(solver):
    """Stresses (n, 2, 2) [Pa] in the plane."""
    xx, yy, xy = solver.points.old.stress[:, [0, 1, 3]].T
    return np.stack([xx, xy, xy, yy], axis=1).reshape(-1, 2, 2)


@pytest.mark.parametrize("method", ["fem-explicit", "mpm"])
@pytest.mark.parametrize("law", ["j2", "johnson_cook"])
def test_a_body_that_starts_turned_starts_with_the_turned_stress(build, request, method, law):
    """With F = R U the stress is R s(U) R^T, and what is stored and dissipated is that of U, for any rotation R."""
    material = request.getfixturevalue(law)
    mesh = block((0.0, 0.0), (4.0 * CELL, 4.0 * CELL), (4, 4))

    def start(gradient):
        return build(
            method, mesh, material, geometry="plane-strain", wall=None, displacement=lambda x: x @ gradient.T - x,
            viscosity=BulkViscosity(),
        )  # fmt: skip

    straight = start(STRETCH)
    ledger = straight.ledger
    assert min(ledger.plastic, ledger.strain) > 0.1 * ledger.initial
    assert ledger.relative_error == 0.0
    assert not straight.points.viscous_pressure.any()
    for angle in np.radians([1.0, 60.0, 175.0]):
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        unstrained, turned = start(turn), start(turn @ STRETCH)
        size = np.abs(in_plane(straight)).max()
        assert np.abs(in_plane(unstrained)).max() < 1e-7 * size
        assert abs(unstrained.ledger.initial) < 1e-9 * ledger.initial
        assert np.allclose(in_plane(turned), turn @ in_plane(straight) @ turn.T, rtol=0.0, atol=1e-7 * size)
        assert turned.ledger.strain == pytest.approx(ledger.strain, rel=1e-7)
        assert turned.ledger.plastic == pytest.approx(ledger.plastic, rel=1e-7)


@pytest.mark.parametrize("method", ["fem-explicit", "mpm"])
def test_points_start_with_the_velocities_asked_for(build, j2, method):
    """Where a field of velocities is linear, those of the points are the field's at their places to round-off."""
    mesh = block((0.0, 0.0), (4.0 * CELL, 4.0 * CELL), (4, 4))
    rates = np.array([[2.0, -1.0], [3.0, 1.0]])
    solver = build(
        method,
        mesh,
        j2,
        geometry="plane-strain",
        wall=None,
        velocity=lambda x: x @ rates.T,
        viscosity=BulkViscosity(),
    )
    expected = solver.point_positions() @ rates.T
    assert np.abs(solver.point_velocities() - expected).max() < 1e-14 * np.abs(expected).max()
