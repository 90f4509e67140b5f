"""Implicit material points: exact stiffness, Newton's order, runs that are kept and gone on from, the largest load."""

import numpy as np
import pytest

from core_models.equilibrium.order import newton_orders
from core_models.errors import LoadBeyondEquilibrium, SceneError
from core_models.loads import Prescribed, Pressure, Symmetry, Traction
from meshes.block import block
from meshes.necking_bar import necking_bar
from mpm import ImplicitSolver
from mpm.implicit.splines import Splines
from tests.mpm.implicit_bodies import LENGTH, MEAN, RADIUS, H, bar, pulled, steel
from tests.stiffness import stiffness_error


@pytest.mark.parametrize("degree", [1, 2, 3])
def test_splines_are_smooth_and_carry_a_linear_field(degree):
    """On uneven cells: sum 1, sum of places times functions x, slopes the derivatives, jumps only of the last one."""
    splines = Splines(degree, np.array([0.0, 1.0, 1.5, 3.0, 4.2]))
    x = np.linspace(0.01, 4.19, 57)
    cells = splines.cells_of(x)
    near = splines.places[cells[:, None] + np.arange(degree + 1)]
    values, slopes = splines.values(x, cells), splines.values(x, cells, 1)
    assert np.allclose(values.sum(axis=1), 1.0) and np.allclose((values * near).sum(axis=1), x)
    ahead, behind = (splines.values(x + step, cells) for step in (1e-6, -1e-6))
    assert np.allclose((ahead - behind) / 2e-6, slopes, atol=1e-8)
    lines, below = splines.lines[1:-1], np.arange(3)
    for derivative in range(degree):
        left, right = np.zeros((2, 3, degree + 2))
        left[:, :-1] = splines.values(lines, below, derivative)
        right[:, 1:] = splines.values(lines, below + 1, derivative)
        assert np.allclose(left, right)
    assert np.abs(splines.jumps()).max() > 0.1


@pytest.mark.parametrize(
    ("geometry", "interpolation", "cure"),
    [("axisymmetric", "quadratic", MEAN), ("plane-strain", "cubic", None), ("spatial", "linear", MEAN)],
)
def test_stiffness_is_the_derivative_of_the_residual(geometry, interpolation, cure):
    """Every column agrees with central differences: plastic points, cure, ghost penalty, pressure that follows."""
    d = 3 if geometry == "spatial" else 2
    low, kind = np.eye(d)[0] * H, "hex8" if d == 3 else "quad4"
    mesh = block(low, low + 2.0 * H, [2 if d == 2 else 1] * d, kind, distortion=0.2 if d == 2 else 0.0)
    loads = (Symmetry("bottom"), Prescribed("top", d - 1, 1e-5), Pressure("right", lambda t: 1e9 * t))
    solver = ImplicitSolver(
        mesh, steel(), geometry=geometry, loads=loads, increment=0.1, cell_size=0.9 * H if d == 2 else 1.4 * H,
        interpolation=interpolation, cure=cure, ghost=0.1,
    )  # fmt: skip
    system, places = solver._system, solver._grid.places
    x = places + 0.01 * places * np.eye(d)[-1]
    x += np.random.default_rng(0).uniform(-2e-5, 2e-5, places.shape)
    assert system.balance(x, 1.0, 0.1).plastic.any()
    assert stiffness_error(system, x, 1.0, 0.1) < 1e-8


def test_newton_converges_at_second_order():
    """Where three corrections in a row see the same flowing points, the order is at least 1.8."""
    solver = bar(0.1, tolerance=1e-11)
    pulled(solver, 0.6)
    orders = newton_orders(solver.log)
    assert len(orders) >= 2 and min(orders) >= 1.8


def test_results_do_not_depend_on_the_number_of_threads():
    """One and two threads are bitwise equal."""
    finals = []
    for threads in (1, 2):
        solver = bar(0.05, 8, 24, threads=threads)
        pulled(solver, 0.1)
        finals.append(solver.positions)
    assert (finals[0] == finals[1]).all()


def test_restart_goes_on_bitwise():
    """A solver built alike and given the checkpoint of another makes the same increments."""
    first, second = (bar(0.05) for _ in range(2))
    pulled(first, 0.1)
    kept = first.checkpoint()
    expected = pulled(first, 0.25)
    second.restore(kept)
    assert (second.positions != second.reference_positions).any()
    assert (pulled(second, 0.25) == expected).all() and (second.positions == first.positions).all()
    with pytest.raises(SceneError, match="the checkpoint is of another solver"):
        bar(0.05, 4).restore(kept)


def test_load_that_cannot_be_carried_ends_with_the_last_converged_state():
    """A traction beyond the plastic limit is cut down to the smallest increment, then refused; the state stays."""
    mesh = necking_bar(RADIUS, LENGTH, 4, 8, 1.0)
    loads = (Symmetry("neck"), Traction("end", lambda X, t: np.tile([0.0, 1e9 * t], (len(X), 1))))
    solver = ImplicitSolver(
        mesh, steel(), loads=loads, increment=0.2, smallest=0.01, cell_size=(RADIUS / 4, LENGTH / 8)
    )
    told = r"cut below 1.000e-02 s.*last converged state is kept.*more than a force of 7\d{4} N on 'end'"
    with pytest.raises(LoadBeyondEquilibrium, match=told) as caught:
        while solver.time < 1.0:
            solver.advance(1.0)
    assert caught.value.exit_status == 3 and "\n" not in str(caught.value)
    assert 0.55 < solver.time < 0.615 and solver.log.cuts
    stretch = solver.boundary_positions("end")[:, 1].mean() / LENGTH
    mean = np.average(solver.points.old.stress[:, 1], weights=solver.points.reference_volumes)
    assert mean / stretch == pytest.approx(1e9 * solver.time, rel=2e-3)
