"""The share of its own volume ratio that a point keeps under a cure holds what nothing else does in a neck."""

import numpy as np
import pytest

from core_models.loads import Prescribed, Symmetry
from fem import ImplicitSolver
from meshes.block import block
from meshes.elevate import elevate
from meshes.kinds import KINDS
from meshes.necking_bar import necking_bar
from studies.necking.reader import read_necking_scene

STEEL = read_necking_scene("necking-simo").material


def lowest_stiffness(kind, **options):
    """Lowest eigenvalue [N/m] of flat elements in a ring, held all round but at the side, once all of it flows."""
    mesh = elevate(block([0.0, 0.0], [1.0, 0.1], [3, 3], KINDS[kind].linear), kind)
    loads = (Symmetry("bottom"), Prescribed("top", 1, 0.1))
    solver = ImplicitSolver(mesh, STEEL, loads=loads, increment=0.05, **options)
    while solver.time < 0.3:
        solver.advance(0.3)
    assert (solver.points.old.equivalent_plastic_strain > 0.1).all()
    matrix = np.zeros((mesh.points.size,) * 2)
    for table, blocks in zip(solver._system.tables, solver._system.stiffness(), strict=True):
        for dofs, values in zip(table, blocks, strict=True):
            matrix[np.ix_(dofs, dofs)] += values
    r, z = mesh.points.T
    free = np.repeat((r > 1e-9) & (z > 1e-9) & (z < 0.1 - 1e-9), 2)
    matrix = matrix[np.ix_(free, free)]
    return np.linalg.eigvalsh(0.5 * (matrix + matrix.T))[0]


@pytest.mark.parametrize(("kind", "cure"), [("quad9", None), ("quad9", "mean-dilatation"), ("tri6", None)])
def test_cured_elements_do_not_soften_of_themselves(kind, cure):
    """Flat quadratic elements have no mode of negative stiffness, since points keep a share of their volume ratio."""
    assert lowest_stiffness(kind, cure=cure) > 0.0
    assert lowest_stiffness(kind, cure=cure, own_share=0.0) < 0.0


def neck_curvatures(**options):
    """Curvature of the profile [1/m] at the first nodes of a neck of flat quad4."""
    mesh = necking_bar(6.413e-3, 26.667e-3, 6, 16, grading=0.03)
    loads = (Symmetry("neck"), Prescribed("end", 1, 7e-3))
    solver = ImplicitSolver(mesh, STEEL, loads=loads, increment=0.04, **options)
    while solver.time < 0.76:
        solver.advance(0.76)
    side = solver.boundary_positions("side")
    r, z = side[np.argsort(side[:, 1])][:7].T
    return np.diff(np.diff(r) / np.diff(z)) / np.diff(0.5 * (z[1:] + z[:-1]))


def test_a_neck_of_flat_quads_is_smooth_with_a_share():
    """The profile's curvature falls from the neck on where points keep a tenth of their volume ratio, else it jumps."""
    assert (np.diff(neck_curvatures(own_share=0.1)) < 0.0).all()
    assert not (np.diff(neck_curvatures()) < 0.0).all()
