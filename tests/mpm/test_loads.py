"""Loads in the material point method: forces and prescribed motion against closed forms, and what is refused."""

import numpy as np
import pytest

from core_models.errors import SceneError
from core_models.loads import BodyForce, Damping, Fixed, Prescribed, Pressure, Symmetry, Traction, gravity
from tests.mpm.conftest import CELL

ROUND_OFF = 1e-12


def run(solver, steps):
    """Make some steps; returns the solver."""
    for _ in range(steps):
        solver.advance()
    return solver


@pytest.mark.parametrize("transfer", ["apic", "flip", "pic", "xpic"])
def test_free_fall_is_exact(body, transfer):
    """Under gravity every particle is at X + v t + g t^2 / 2, and has the velocity of the middle of the last step."""
    g, v = np.array([2e4, -5e4]), np.array([3.0, -20.0])
    solver = body(loads=(gravity(g),), velocity=v, transfer=transfer)
    for _ in range(30):
        before = solver.time
        solver.advance()
    t = solver.time
    assert np.allclose(
        solver.positions, solver.reference_positions + v * t + 0.5 * g * t**2, rtol=1e-13, atol=0.0
    )
    assert np.allclose(solver.velocities, v + g * 0.5 * (before + t), rtol=1e-11)
    assert solver.ledger.external == pytest.approx(
        float(solver.mass * g @ (solver.positions - solver.reference_positions).mean(axis=0)), rel=1e-11
    )


def test_a_body_force_may_depend_on_place_and_time(body):
    """The momentum is the time integral of the force on all particles, at current or at reference positions."""
    for at in ("current", "reference"):
        solver = body(loads=(BodyForce(lambda x, t: 1e9 * x * (1.0 + 1e6 * t), at=at),), velocity=(50.0, 0.0))
        expected, last = solver.momentum, 0.0
        for _ in range(10):
            places = solver.positions if at == "current" else solver.reference_positions
            force = (solver.particle_mass[:, None] * 1e9 * places).sum(axis=0) * (1.0 + 1e6 * solver.time)
            before = solver.time
            solver.advance()
            dt = solver.time - before
            expected = expected + 0.5 * (last + dt) * force
            last = dt
        assert np.allclose(solver.momentum, expected, rtol=1e-12)


@pytest.mark.parametrize("geometry", ["axisymmetric", "plane-strain", "spatial"])
def test_a_dead_traction_has_its_resultant(body, geometry):
    """The body's momentum grows by traction times reference area, wherever the surface lies in its cells."""
    d = 3 if geometry == "spatial" else 2
    traction = np.array([0.0, 3e6, 2e6])[-d:]
    if geometry == "axisymmetric":
        traction[0] = 0.0
    solver = body(geometry, corner=(0.0, 0.37, 0.61)[:d], loads=(Traction("top", traction),))
    size = np.ptp(solver.mesh.points, axis=0)
    area = {"axisymmetric": np.pi * size[0] ** 2, "plane-strain": size[0], "spatial": size[0] * size[1]}[
        geometry
    ]
    run(solver, 20)
    forced = solver.time - 0.5 * solver._last_step
    axes = slice(1, None) if geometry == "axisymmetric" else slice(None)
    assert np.allclose(solver.momentum[axes], (traction * area * forced)[axes], rtol=1e-9)


@pytest.mark.parametrize("geometry", ["axisymmetric", "plane-strain", "spatial"])
def test_pressure_acts_along_the_current_normal_on_the_current_area(body, geometry):
    """On the top of a body that was stretched before, the force is pressure times stretched area, downwards."""
    d = 3 if geometry == "spatial" else 2
    stretch, p = np.array([1.1, 1.1, 1.0])[:d], 5e6
    stretch[-1] = 1.0
    solver = body(geometry, displacement=lambda x: (stretch - 1.0) * x, loads=(Pressure("top", lambda t: p),))
    solver.points.old.stress[:] = 0.0
    size = np.ptp(solver.mesh.points, axis=0) * stretch
    area = {"axisymmetric": np.pi * size[0] ** 2, "plane-strain": size[0], "spatial": size[0] * size[1]}[
        geometry
    ]
    dt = solver.time_step
    solver.advance()
    # The middles of the faces see the area of a cone only to second order.
    tolerance = 1e-9 if geometry == "spatial" else 1e-6
    assert solver.momentum[-1] == pytest.approx(-0.5 * dt * p * area, rel=tolerance)


def test_equal_pressure_all_round_moves_nothing_off(body):
    """The resultant on a closed surface is 0, and the body gets the pressure as its stress when it comes to rest."""
    p, names = 2e8, ("left", "right", "bottom", "top")
    solver = body(
        counts=(6, 6), loads=(*(Pressure(name, p) for name in names), Damping(2e6)), corner=(0.3, 0.1)
    )
    solver.advance()
    speed = float(np.linalg.norm(solver.velocities, axis=1).max())
    assert np.abs(solver.momentum).max() < ROUND_OFF * solver.mass * speed
    run(solver, 600)
    assert np.abs(solver.momentum).max() < 1e-3 * solver.mass * speed
    stress = solver.points.old.stress
    assert np.allclose(stress[:, :2].mean(axis=0), -p, rtol=0.01)
    assert np.abs(stress[:, 3].mean()) < 1e-3 * p
    assert abs(solver.ledger.relative_error) < 0.05
    assert solver.ledger.damping > 0.0


@pytest.mark.parametrize(
    ("interpolation", "heights"),
    [("quadratic", (4.25, 4.251, 4.6, 4.9)), ("cubic", (4.75, 4.8)), ("gimp", (4.501,)), ("cpdi", (4.501,))],
)
def test_a_loaded_surface_may_lie_anywhere_in_its_cells(body, elastic, interpolation, heights):
    """At rest under a traction, no particle is stressed much more than the rest, however few share the last nodes."""
    p, modulus = 1e7, elastic.elasticity.bulk_modulus + 4.0 / 3.0 * elastic.elasticity.shear_modulus
    for cells in heights:
        height = 4.0 * CELL
        slowest = 0.5 * np.pi * np.sqrt(modulus / elastic.density) / height
        solver = body(
            counts=(4, 4),
            cell_size=height / cells,
            interpolation=interpolation,
            loads=(Symmetry("left"), Symmetry("bottom"), Traction("top", (0.0, -p)), Damping(1.5 * slowest)),
        )
        while solver.time < 25.0 / slowest:
            solver.advance()
        stress = solver.points.old.stress[:, 1]
        assert np.abs(stress / p + 1.0).max() < 0.25, cells
        assert stress.mean() == pytest.approx(-p, rel=1e-3), cells
        assert solver.boundary_force("bottom")[1] == pytest.approx(p * height, rel=1e-3)


def test_damping_slows_a_flying_body_exponentially(body):
    """v = v0 exp(-rate t), and the ledger says where the energy went."""
    rate, v = 2e5, 100.0
    solver = run(body(velocity=(v, 0.0), loads=(Damping(lambda t: rate),)), 100)
    middle = solver.time - 0.5 * solver._last_step
    assert np.allclose(solver.velocities[:, 0], v * np.exp(-rate * middle), rtol=1e-3)
    assert solver.ledger.damping == pytest.approx(solver.ledger.initial - solver.ledger.kinetic, rel=1e-9)


@pytest.mark.parametrize("interpolation", ["quadratic", "linear", "gimp", "cubic"])
def test_a_prescribed_side_moves_as_told(body, interpolation):
    """The top of a block is pulled up at a speed that grows; its corners follow, and the rest of it is free."""
    solver = body(
        counts=(6, 8),
        corner=(0.2, 0.3),
        interpolation=interpolation,
        loads=(Prescribed("top", 1, lambda x, t: 1e7 * t), Symmetry("bottom")),
    )
    run(solver, 60)
    moved = solver.boundary_positions("top")[:, 1] - solver.mesh.points[:, 1].max()
    assert np.allclose(moved, 0.5e7 * solver.time**2, rtol=0.05)


def test_a_bar_that_is_pulled_answers_with_its_stiffness(body, elastic):
    """Stretched slowly and damped, reaction and stress are those of uniaxial strain; the reactions balance."""
    strain, counts = 1e-4, (4, 10)
    height = counts[1] * CELL
    travel = height / np.sqrt(
        (elastic.elasticity.bulk_modulus + 4 / 3 * elastic.elasticity.shear_modulus) / elastic.density
    )
    end = 40.0 * travel
    solver = body(
        counts=counts,
        corner=(0.0, 0.4),
        loads=(
            Symmetry("left"),
            Symmetry("right"),
            Fixed("bottom"),
            Prescribed("top", 1, lambda x, t: 2.0 * strain * height / end * max(1.0 - t / end, 0.0)),
            Damping(0.5 / travel),
        ),
    )
    while solver.time < 1.3 * end:
        solver.advance()
    stiffness = elastic.elasticity.bulk_modulus + 4.0 / 3.0 * elastic.elasticity.shear_modulus
    exact = stiffness * strain * counts[0] * CELL
    assert solver.boundary_force("top")[1] == pytest.approx(exact, rel=0.01)
    assert solver.boundary_force("bottom")[1] == pytest.approx(-exact, rel=0.01)
    sideways = (
        (elastic.elasticity.bulk_modulus - 2.0 / 3.0 * elastic.elasticity.shear_modulus) * strain * height
    )
    assert solver.boundary_force("left")[0] == pytest.approx(-sideways, rel=0.03)
    assert solver.boundary_force("right")[0] == pytest.approx(sideways, rel=0.03)
    assert solver.points.old.stress[:, 1].mean() == pytest.approx(stiffness * strain, rel=0.01)
    ledger = solver.ledger
    assert ledger.strain == pytest.approx(0.5 * exact * strain * height, rel=0.02)
    assert abs(ledger.relative_error) < 0.02


def test_a_fixed_side_takes_all_momentum_that_changes(body):
    """The change of momentum is the sum of the impulses of the fixed side."""
    solver = body(velocity=(30.0, -50.0), loads=(Fixed("bottom"),), corner=(0.3, 0.3))
    total = np.zeros(2)
    start, last = solver.momentum, 0.0
    for _ in range(40):
        before = solver.time
        solver.advance()
        dt = solver.time - before
        total += solver.boundary_force("bottom") * 0.5 * (last + dt)
        last = dt
        assert np.allclose(solver.momentum - start, total, atol=1e-11 * np.abs(start).max())
    assert np.linalg.norm(total) > 0.1 * np.linalg.norm(start)


def test_energy_closes_in_cells_of_any_size_where_a_body_is_stopped(body):
    """What the first step takes from a moving body whose side is fixed counts as contact; the rest closes."""
    errors = []
    for finer in (1, 2, 4):
        counts = (5 * finer, 6 * finer)
        solver = run(
            body(counts=counts, velocity=(30.0, -50.0), loads=(Fixed("bottom"),), corner=(0.3, 0.3)),
            40 * finer,
        )
        assert solver.ledger.contact > 0.0
        errors.append(abs(solver.ledger.relative_error))
    assert max(errors) < 1e-3


def test_a_uniform_deformation_that_the_sides_follow_is_exact_inside(body):
    """Patch test: the sides move with an affine velocity; F is exact to round-off where they have not been felt."""
    rates = np.array([[300.0, 150.0], [-80.0, -200.0]])

    def along(component):
        return lambda x, t: (x @ rates.T)[:, component]

    names = ("left", "right", "bottom", "top")
    loads = tuple(Prescribed(name, c, along(c)) for name in names for c in (0, 1))
    solver = body(counts=(20, 20), corner=(0.3, 0.45), loads=loads, velocity=lambda x: x @ rates.T)
    run(solver, 2)
    exact = np.eye(2) + solver.time * rates
    inside = (np.abs(solver.reference_positions / CELL - [10.3, 10.45]) < 3.0).all(axis=1)
    found = solver.points.old_deformation_gradient[inside, :2, :2]
    assert inside.sum() == 144
    assert np.abs(found - exact).max() < 1e-12


@pytest.mark.parametrize(
    ("load", "remedy"),
    [
        (Traction("topp", (0.0, 1.0)), "did you mean 'top'"),
        (Prescribed("top", 2), "component 2"),
        (Symmetry("top"), None),
        ("gravity", "is no load"),
    ],
)
def test_loads_that_cannot_be_are_refused(body, load, remedy):
    """An unknown boundary or component, or what is no load, is a SceneError with the remedy."""
    if remedy is None:
        body(loads=(load,))
        return
    with pytest.raises(SceneError, match=remedy):
        body(loads=(load,))


def test_planes_that_are_no_whole_number_of_cells_apart_are_refused(body):
    """The grid has to fit between two symmetry planes; the message has the numbers and cells that would do."""
    with pytest.raises(
        SceneError, match=r"'right' at x = 0.002 m is 4.54545 cells .* whole number.*0.0004 m"
    ):
        body(symmetries=["left", "right"], cell_size=1.1 * CELL)


def test_a_boundary_without_a_force_of_its_own_is_refused(body):
    """Asking for the reaction of a free side tells which sides have one."""
    with pytest.raises(SceneError, match=r"no support holds 'top'.*bottom"):
        body(symmetries=["bottom"]).boundary_force("top")
