"""Loads and supports: resultants, reactions and the work that they do."""

import numpy as np
import pytest

from core_models.loads import (
    BodyForce,
    Damping,
    Fixed,
    Prescribed,
    Pressure,
    Symmetry,
    Traction,
    gravity,
)
from fem import ExplicitSolver
from meshes.block import block

SOLIDS = [("plane-strain", "quad4"), ("axisymmetric", "quad4"), ("spatial", "hex8")]
QUADRATIC = [("plane-strain", "quad9"), ("axisymmetric", "tri6"), ("spatial", "hex20"), ("spatial", "tet10")]


@pytest.fixture
def solid(elastic):
    """Make an elastic block of edges 1 m, in the ring 1 m < r < 2 m if axisymmetric, with loads."""

    def make(geometry, kind, *loads, material=None, **options):
        low = np.array([1.0 if geometry == "axisymmetric" else 0.0, 0.0, 0.0])[
            : 3 if geometry == "spatial" else 2
        ]
        mesh = block(low, low + 1.0, [2] * len(low), kind)
        return ExplicitSolver(mesh, material or elastic, geometry=geometry, loads=loads, **options)

    return make


def first_change(solver):
    """Momentum that the first step brings, over half its length, the time that forces have acted [N]."""
    before = (solver.nodal_mass[:, None] * solver.velocities).sum(axis=0)
    solver.advance()
    after = (solver.nodal_mass[:, None] * solver.velocities).sum(axis=0)
    return (after - before) / (0.5 * solver.time)


def height_area(geometry):
    """Area of the upper side [m^2]."""
    return np.pi * (2.0**2 - 1.0**2) if geometry == "axisymmetric" else 1.0


@pytest.mark.parametrize(("geometry", "kind"), SOLIDS + QUADRATIC)
def test_uniform_gravity_is_free_fall(solid, geometry, kind):
    """Every node falls with g exactly, so no stress arises."""
    g = -9.81
    solver = solid(geometry, kind, gravity([0.0] * (2 if geometry == "spatial" else 1) + [g]))
    for _ in range(20):
        solver.advance()
    fallen = g * (solver.time - 0.5 * solver._last_step)
    assert np.allclose(solver.velocities[:, -1], fallen, rtol=1e-12)
    assert np.abs(solver.points.fields()["stress"].array).max() < 1e-12 * 130e9
    assert solver.ledger.external == pytest.approx(solver.ledger.kinetic, rel=2e-2)


@pytest.mark.parametrize(("geometry", "kind"), SOLIDS + QUADRATIC)
def test_tractions_and_pressures_have_the_resultant_of_their_area(solid, geometry, kind):
    """A traction of 3 MPa upwards and a pressure of 2 MPa on the upper side: 1 MPa times the area."""
    up = [0.0] * (2 if geometry == "spatial" else 1) + [3e6]
    solver = solid(geometry, kind, Traction("top", up), Pressure("top", lambda t: 2e6))
    force = first_change(solver)
    assert force[-1] == pytest.approx(1e6 * height_area(geometry), rel=1e-12)
    assert np.abs(force[:-1]).max() < 1e-6


@pytest.mark.parametrize(("geometry", "kind"), SOLIDS + QUADRATIC)
def test_pressure_all_round_is_balanced_on_any_shape(solid, elastic, geometry, kind):
    """Pressure on the whole rim of an unevenly deformed body has no resultant: current normals, current areas."""
    names = ("left", "right", "bottom", "top", "front", "back")[: 6 if geometry == "spatial" else 4]
    loads = [Pressure(name, 1e6) for name in names]
    shift = 0.05 * np.random.default_rng(0).uniform(-1.0, 1.0, solid(geometry, kind).positions.shape)
    solver, free = (solid(geometry, kind, *some, displacement=lambda x: shift) for some in (loads, []))
    forces = first_change(solver) - first_change(free)
    first = 1 if geometry == "axisymmetric" else 0
    assert np.abs(forces[first:]).max() < 1e-9 * 1e6


@pytest.mark.parametrize(("geometry", "kind"), SOLIDS)
def test_a_body_force_in_space_and_time_does_the_work_that_the_body_gains(solid, geometry, kind):
    """A force field that varies with x and t: external work is kinetic and strain energy."""
    load = BodyForce(lambda x, t: 1e7 * np.sin(5.0 * x) * np.cos(1e4 * t))
    other = BodyForce(lambda x, t: 1e6 * x, at="reference")
    solver = solid(geometry, kind, load, other, safety=0.3)
    for _ in range(150):
        solver.advance()
    assert solver.ledger.external > 0.0
    assert solver.ledger.strain > 0.05 * solver.ledger.external
    assert abs(solver.ledger.relative_error) < 5e-3


@pytest.mark.parametrize(("geometry", "kind"), SOLIDS)
def test_energy_closes_for_a_plastic_body_between_moving_supports(solid, j2, geometry, kind):
    """One side fixed, one moved: the supports' work is kinetic, strain and plastic energy, and damping."""
    up = (3 if geometry == "spatial" else 2) - 1
    moved = Prescribed("top", up, lambda x, t: 40.0 * min(t / 5e-4, 1.0))
    damping = Damping(2e3)
    solver = solid(geometry, kind, Fixed("bottom"), moved, damping, material=j2, safety=0.5)
    while solver.time < 3e-3:
        solver.advance()
    ledger = solver.ledger
    assert ledger.plastic > 0.5 * ledger.external
    assert ledger.damping > 0.0
    assert abs(ledger.relative_error) < 2e-3
    assert solver.boundary_positions("top")[:, up].min() == pytest.approx(
        1.0 + 40.0 * (3e-3 - 2.5e-4), rel=1e-3
    )


@pytest.mark.parametrize(("geometry", "kind"), SOLIDS)
def test_reactions_are_what_changes_the_momentum(solid, geometry, kind):
    """In every step the supports' forces, less those of damping, are the change of momentum, to round-off."""
    up, rate = (3 if geometry == "spatial" else 2) - 1, 2e3
    moved = Prescribed("top", up, lambda x, t: 40.0 * t / 5e-4)
    solver = solid(geometry, kind, Fixed("bottom"), moved, Damping(rate), safety=0.5)
    steps = [0.0]
    for _ in range(50):
        momentum, before = solver.momentum[up], solver.time
        solver.advance()
        steps.append(solver.time - before)
        held = solver.boundary_force("top")[up] + solver.boundary_force("bottom")[up]
        damping = rate * 0.5 * (momentum + solver.momentum[up])
        change = (held - damping) * 0.5 * (steps[-2] + steps[-1])
        assert solver.momentum[up] - momentum == pytest.approx(change, rel=1e-9)


@pytest.mark.parametrize(("geometry", "kind"), SOLIDS)
def test_a_prescribed_velocity_is_met_at_mid_step(solid, geometry, kind):
    """The displacement of a support follows the integral of its velocity to second order, exactly if that is linear."""
    up = (3 if geometry == "spatial" else 2) - 1
    solver = solid(geometry, kind, Prescribed("top", up, lambda x, t: 1e3 * t))
    for _ in range(30):
        solver.advance()
    height = solver.boundary_positions("top")[:, up]
    assert np.allclose(height, 1.0 + 0.5e3 * solver.time**2, rtol=1e-13)


@pytest.mark.parametrize(("geometry", "kind"), [s for s in SOLIDS if s[0] != "axisymmetric"])
def test_a_symmetry_plane_is_the_other_half(elastic, geometry, kind):
    """Half a body with a symmetry plane moves as half of the whole body does."""
    d = 3 if geometry == "spatial" else 2
    whole, half = (
        block([low] + [0.0] * (d - 1), [1.0] * d, [count] + [2] * (d - 1), kind)
        for low, count in ((-1.0, 4), (0.0, 2))
    )
    squeeze = Traction("right", [-1e8] + [0.0] * (d - 1))
    other = Traction("left", [1e8] + [0.0] * (d - 1))
    full = ExplicitSolver(whole, elastic, geometry=geometry, loads=(squeeze, other))
    mirrored = ExplicitSolver(half, elastic, geometry=geometry, loads=(squeeze, Symmetry("left")))
    for _ in range(50):
        full.advance(full.time + 1e-5)
        mirrored.advance(mirrored.time + 1e-5)
    right, same = full.boundary_positions("right"), mirrored.boundary_positions("right")
    assert np.allclose(right, same, rtol=1e-12)
    assert (mirrored.boundary_positions("left")[:, 0] == 0.0).all()
    assert mirrored.boundary_force("left")[0] > 0.0


def test_damping_slows_a_flying_body_at_its_rate(solid):
    """A body without forces slows like exp(-rate t), and the ledger has what it lost."""
    rate = 500.0
    solver = solid("spatial", "hex8", Damping(lambda t: rate), velocity=[3.0, 0.0, 0.0])
    while solver.time < 2e-3:
        solver.advance()
    middle = solver.time - 0.5 * solver._last_step
    assert np.allclose(solver.velocities[:, 0], 3.0 * np.exp(-rate * middle), rtol=1e-3)
    lost = solver.ledger.initial - solver.ledger.kinetic
    assert solver.ledger.damping == pytest.approx(lost, rel=1e-3)
