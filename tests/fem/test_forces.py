"""Nodal forces of every element as the exact gradient of the energy that it stores."""

import numpy as np
import pytest

from fem.cures.choice import LINEAR, MEAN
from meshes.kinds import KINDS

STEP = 1e-6  # m, of central differences, in a block of 1 m
SOME = 0.05  # of the distance of nodes: how far they are moved at random


def stored_energy(solver, bulk, shear):
    """Hyperelastic energy of what the points see, and that of hourglass control [J]."""
    gradient = solver.points.fields()["deformation_gradient"].array
    ratio = np.linalg.det(gradient)
    isochoric = (gradient**2).sum(axis=(1, 2)) * ratio ** (-2.0 / 3.0)
    density = 0.5 * shear * (isochoric - 3.0) + 0.5 * bulk * (0.5 * (ratio**2 - 1.0) - np.log(ratio))
    return float(solver.points.reference_volumes @ density) + solver.ledger.hourglass


@pytest.fixture
def uneven(which, element):
    """A random displacement of the nodes of a block [m]."""
    mesh = element(which).mesh
    distance = 1.0 / (3 * KINDS[mesh.kind].degree)
    return SOME * distance * np.random.default_rng(2).uniform(-1.0, 1.0, mesh.points.shape)


def test_forces_are_the_gradient_of_the_stored_energy(which, element, uneven, elastic):
    """f . d = - dW along random directions d, at a distorted and unevenly deformed mesh: every cure has a potential,
    a part of its own volume ratio that each point keeps included.
    """
    share = {"own_share": 0.1} if which[3] in (MEAN, LINEAR) else {}

    def energy(change):
        return stored_energy(element(which, lambda x: uneven + change, **share), *elastic.elasticity)

    forces = element(which, lambda x: uneven, **share).nodal_forces()
    for direction in np.random.default_rng(3).uniform(-1.0, 1.0, (2, *uneven.shape)):
        slope = (energy(STEP * direction) - energy(-STEP * direction)) / (2.0 * STEP)
        assert abs((forces * direction).sum() + slope) < 1e-7 * np.abs(forces * direction).sum()


def test_inner_forces_neither_push_nor_turn_the_body(which, element, uneven):
    """Whatever the deformation, the internal forces have no resultant, and no moment where the body can turn."""
    solver = element(which, lambda x: uneven)
    forces, size = solver.nodal_forces(), np.abs(solver.nodal_forces()).sum()
    first = 1 if which[0] == "axisymmetric" else 0
    assert np.abs(forces.sum(axis=0)[first:]).max() < 1e-12 * size
    if which[0] != "axisymmetric":
        d = forces.shape[1]
        moment = np.cross(
            np.pad(solver.positions, ((0, 0), (0, 3 - d))), np.pad(forces, ((0, 0), (0, 3 - d)))
        )
        assert np.abs(moment.sum(axis=0)).max() < 1e-12 * size
