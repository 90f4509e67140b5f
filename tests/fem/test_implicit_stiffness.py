"""Implicit finite elements: the stiffness is exact, and Newton converges with it."""

import numpy as np
import pytest

from core_models.equilibrium.order import newton_orders
from core_models.loads import Prescribed, Pressure, Symmetry
from fem import ImplicitSolver
from meshes.block import block
from meshes.elevate import elevate
from tests.fem.implicit_bodies import bar, pulled, steel
from tests.stiffness import stiffness_error


@pytest.mark.parametrize(
    ("kind", "geometry"), [("quad4", "axisymmetric"), ("quad9", "axisymmetric"), ("quad8", "plane-strain")]
)
def test_stiffness_is_the_derivative_of_the_residual(kind, geometry):
    """Every column agrees with central differences, plastic points, cure and follower pressure included."""
    mesh = elevate(block([1e-3, 0.0], [3e-3, 2e-3], [2, 2], distortion=0.2), kind)
    loads = (Symmetry("bottom"), Prescribed("top", 1, 1e-5), Pressure("right", lambda t: 1e9 * t))
    solver = ImplicitSolver(mesh, steel(), geometry=geometry, loads=loads, increment=0.1)
    system = solver._system
    x = mesh.points * [1.0, 1.01] + np.random.default_rng(0).uniform(-2e-5, 2e-5, mesh.points.shape)
    assert system.balance(x, 1.0, 0.1).plastic.any()
    assert stiffness_error(system, x, 1.0, 0.1) < 3e-8


def test_linear_fields_are_exact_on_a_distorted_mesh():
    """With every edge moved linearly the inside follows, stress is the same everywhere, and forces balance."""
    gradient = np.array([[0.03, 0.02], [-0.01, 0.05]])
    mesh = block([0.0, 0.0], [1.0, 1.0], [3, 3], distortion=0.3, seed=3)
    loads = tuple(
        Prescribed(name, i, lambda X, t, row=gradient[i]: X @ row)
        for name in mesh.boundaries
        for i in range(2)
    )
    solver = ImplicitSolver(mesh, steel(), geometry="plane-strain", loads=loads, increment=0.5)
    while solver.time < 1.0:
        solver.advance(1.0)
    assert np.abs(solver.positions - mesh.points @ (np.eye(2) + gradient).T).max() < 1e-12
    stress = solver.points.old.stress
    assert np.ptp(stress, axis=0).max() < 1e-8 * np.abs(stress).max()
    total = sum(solver._supports.reactions)
    assert np.abs(total).max() < 1e-8 * np.abs(solver.nodal_forces()).max()


def test_newton_converges_at_second_order():
    """Where three corrections in a row see the same flowing points, the order is at least 1.8."""
    solver = bar(3, 8, 0.982, 0.1, grading=0.3, tolerance=1e-11)
    pulled(solver, 0.6)
    orders = newton_orders(solver.log)
    assert len(orders) >= 2 and min(orders) >= 1.8


@pytest.mark.parametrize(
    ("name", "chosen", "module"), [(None, "pardiso", "pypardiso"), ("petsc", "petsc", "petsc4py")]
)
def test_linear_solvers_give_the_same_forces(name, chosen, module):
    """PARDISO is chosen by itself where it is installed; it and PETSc agree with SciPy."""
    pytest.importorskip(module)
    solvers = [bar(3, 8, 0.982, 0.1, linear_solver=each) for each in (name, "scipy")]
    assert [solver.linear_solver for solver in solvers] == [chosen, "scipy"]
    forces = [pulled(solver, 0.3) for solver in solvers]
    assert forces[0] == pytest.approx(forces[1], rel=1e-7)


def test_results_do_not_depend_on_the_number_of_threads():
    """One and two threads are bitwise equal."""
    finals = []
    for threads in (1, 2):
        solver = bar(8, 20, 0.982, 0.05, threads=threads)
        pulled(solver, 0.1)
        finals.append(solver.positions)
    assert (finals[0] == finals[1]).all()
