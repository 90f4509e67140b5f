"""Implicit quasi-static finite elements: exact stiffness, equilibrium, closed forms, and what is refused."""

import json
import math
from dataclasses import asdict, replace

import numpy as np
import pytest

from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.equilibrium.order import newton_orders
from core_models.errors import NoEquilibrium, OutputError, SceneError, SingularStiffness, UnsupportedError
from core_models.flow.voce import Voce
from core_models.loads import Damping, Fixed, Prescribed, Pressure, Symmetry, Traction
from core_models.material import Material
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.yield_condition.von_mises import VonMises
from fem import ImplicitSolver
from meshes.block import block
from meshes.elevate import elevate
from meshes.join import join
from meshes.necking_bar import necking_bar

BULK, SHEAR = 164.206e9, 80.1938e9
YOUNG = 9.0 * BULK * SHEAR / (3.0 * BULK + SHEAR)
RADIUS, LENGTH = 6.413e-3, 26.667e-3
PULL = 7e-3  # m per second


def steel(yield_stress=0.45e9):
    """The necking bar's steel."""
    flow = Voce(yield_stress, yield_stress + 0.265e9, 16.93, 0.12924e9)
    return Material(
        "steel", 7800.0, HyperelasticPlastic(), IsotropicElastic(BULK, SHEAR), NeoHookean(BULK), flow, VonMises()
    )  # fmt: skip


def bar(across, along, taper, increment, **options):
    """The necking bar, pulled by PULL within 1 s."""
    mesh = necking_bar(
        RADIUS, LENGTH, across, along, taper, options.pop("grading", 1.0), options.pop("kind", "quad4")
    )
    loads = (Symmetry("neck"), Prescribed("end", 1, PULL))
    return ImplicitSolver(mesh, options.pop("material", steel()), loads=loads, increment=increment, **options)


def pulled(solver, end):
    """Force [N] at the end of every increment up to a time [s]."""
    forces = []
    while solver.time < end:
        solver.advance(end)
        forces.append(solver.boundary_force("end")[1])
    return np.array(forces)


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
    exact = np.zeros((x.size, x.size))
    for table, blocks in zip(system.tables, system.stiffness(), strict=True):
        for dofs, values in zip(table, blocks, strict=True):
            exact[np.ix_(dofs, dofs)] += values
    step = 1e-9
    for dof in range(x.size):
        shift = np.zeros(x.size)
        shift[dof] = step
        high, low = (system.balance(x + sign * shift.reshape(x.shape), 1.0, 0.1).residual for sign in (1, -1))
        measured = (high - low).ravel() / (2.0 * step)
        assert np.abs(measured - exact[:, dof]).max() < 3e-8 * np.abs(exact).max()


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


def test_untapered_bar_follows_the_closed_form():
    """Force = A0 sigma_y / stretch, Hencky strain = p + sigma_y / E, up to the maximum, 79.46 kN."""
    solver = bar(1, 2, 1.0, 0.02)
    forces = pulled(solver, 0.5)
    flow = steel().flow
    strain = solver.points.old.equivalent_plastic_strain
    assert np.ptp(strain) < 1e-9
    p = np.linspace(0.0, 0.3, 3001)
    stress = flow.saturation_stress + flow.linear_modulus * p
    stress -= (flow.saturation_stress - flow.yield_stress) * np.exp(-flow.saturation_rate * p)
    total = p + stress / YOUNG
    curve = math.pi * RADIUS**2 * stress * np.exp(-total)
    times = np.array([each.time for each in solver.log.increments])
    expected = np.interp(np.log1p(PULL * times / LENGTH), total, curve)
    flowing = times > 0.02
    assert np.abs(forces / expected - 1.0)[flowing].max() < 1e-3
    assert forces.max() == pytest.approx(79.46e3, rel=1e-3)


def test_tapered_bar_necks():
    """On a coarse mesh the force peaks at 77.4 kN near 2.8 mm and falls, the neck alone goes on, without a cut."""
    solver = bar(3, 8, 0.982, 1.0 / 25.0, grading=0.3)
    forces = pulled(solver, 1.0)
    peak = int(forces.argmax())
    assert forces[peak] == pytest.approx(77.4e3, rel=1e-3)
    assert PULL * solver.log.increments[peak].time == pytest.approx(2.83e-3, abs=0.2e-3)
    assert solver.log.cuts == [] and forces[-1] < 0.6 * forces[peak]
    assert solver.boundary_positions("neck")[:, 0].max() < 0.5 * RADIUS
    assert solver.boundary_positions("end")[:, 0].max() > 0.9 * RADIUS


def test_newton_converges_at_second_order():
    """Where three corrections in a row see the same flowing points, the order is at least 1.8."""
    solver = bar(3, 8, 0.982, 0.1, grading=0.3, tolerance=1e-11)
    pulled(solver, 0.6)
    orders = newton_orders(solver.log)
    assert len(orders) >= 2 and min(orders) >= 1.8


def test_work_from_outside_is_stored_or_dissipated():
    """The ledger closes at second order in the increment, but for the dissipation, which is that of its end."""
    errors = []
    for increment in (0.02, 0.01):
        solver = bar(1, 2, 1.0, increment)
        pulled(solver, 0.2)
        errors.append(abs(solver.ledger.relative_error))
    assert errors[1] < 0.6 * errors[0] < 0.02


def test_pressure_follows_the_surface():
    """A pressurised elastic ring: the hoop force of its section balances the pressure on its current inner radius."""
    mesh = block([10e-3, 0.0], [11e-3, 1e-3], [4, 1])
    pressure = 20e6
    loads = (Symmetry("bottom"), Symmetry("top"), Pressure("left", lambda t: pressure * t))
    solver = ImplicitSolver(mesh, steel(), loads=loads, increment=0.5)
    while solver.time < 1.0:
        solver.advance(1.0)
    hoop = solver.points.old.stress[:, 2]
    areas = solver.point_volumes() / (2.0 * math.pi * solver.point_positions()[:, 0])
    inner = solver.boundary_positions("left")[:, 0].mean()
    assert (hoop * areas).sum() == pytest.approx(pressure * inner * 1e-3, rel=1e-5)
    assert sum(each.iterations for each in solver.log.increments) <= 8


def test_log_tells_every_iteration(tmp_path):
    """The file has one JSON object for each record, in order; the text has a line for each."""
    solver = bar(1, 1, 1.0, 0.01, log=tmp_path / "log.jsonl")
    solver.advance()
    lines = [json.loads(line) for line in (tmp_path / "log.jsonl").read_text().splitlines()]
    assert lines == [asdict(record) for record in solver.log.records]
    assert [line["kind"] for line in lines] == ["start", *["iteration"] * (len(lines) - 2), "increment"]
    assert lines[0]["linear_solver"] == solver.linear_solver
    assert lines[-1]["outcome"] == "converged" and lines[-2]["relative"] <= 1e-8
    assert len(solver.log.text().splitlines()) == len(lines) + 1


def test_results_do_not_depend_on_the_number_of_threads():
    """One and two threads are bitwise equal."""
    finals = []
    for threads in (1, 2):
        solver = bar(8, 20, 0.982, 0.05, threads=threads)
        pulled(solver, 0.1)
        finals.append(solver.positions)
    assert (finals[0] == finals[1]).all()


def test_load_that_cannot_be_carried_ends_with_the_last_converged_state():
    """A traction beyond the plastic limit is cut down to the smallest increment, then refused; the state stays."""
    mesh = necking_bar(RADIUS, LENGTH, 1, 2, 1.0)
    loads = (Symmetry("neck"), Traction("end", lambda X, t: np.tile([0.0, 1e9 * t], (len(X), 1))))
    solver = ImplicitSolver(mesh, steel(), loads=loads, increment=0.2, smallest=0.01)
    with pytest.raises(NoEquilibrium, match=r"cut below 1.000e-02 s.*last converged state is kept") as caught:
        while solver.time < 1.0:
            solver.advance(1.0)
    assert caught.value.exit_status == 3 and "\n" not in str(caught.value)
    assert 0.55 < solver.time < 0.615 and solver.log.cuts
    assert solver.points.old.stress[:, 1].max() == pytest.approx(1e9 * solver.time, rel=0.3)


def test_restart_goes_on_bitwise():
    """A solver built alike and given the checkpoint of another makes the same increments."""
    first, second = (bar(3, 8, 0.982, 0.05, grading=0.3) for _ in range(2))
    pulled(first, 0.1)
    kept = first.checkpoint()
    expected = pulled(first, 0.25)
    second.restore(kept)
    assert (pulled(second, 0.25) == expected).all() and (second.positions == first.positions).all()
    with pytest.raises(SceneError, match="the checkpoint is of another solver"):
        bar(2, 8, 0.982, 0.05).restore(kept)


@pytest.mark.parametrize(
    ("mesh", "geometry", "loads", "told"),
    [
        (block([0, 0], [1, 1], [2, 2]), "plane-strain", (), "translation along x, translation along y, rotation"),
        (block([0, 0], [1, 1], [2, 2]), "plane-strain", (Symmetry("bottom"),), "translation along x:"),
        (block([0, 0], [1, 1], [2, 2]), "axisymmetric", (Pressure("right", 1.0),), "translation along z"),
        (block([0] * 3, [1] * 3, [1] * 3, "hex8"), None, (Symmetry("left"), Symmetry("bottom")), "along y:"),
    ],
)  # fmt: skip
def test_missing_support_is_told_by_its_motion(mesh, geometry, loads, told):
    """A singular stiffness is an error with status 3 that names the free motion."""
    solver = ImplicitSolver(mesh, steel(), geometry=geometry, loads=loads, increment=1.0)
    with pytest.raises(SingularStiffness, match=told) as caught:
        solver.advance()
    assert caught.value.exit_status == 3


def test_several_bodies_are_refused():
    """They would pass through each other: the message says what has contact."""
    two = join([block([0, 0], [1, 1], [1, 1]), replace(block([2, 0], [3, 1], [1, 1]), boundaries={})])
    with pytest.raises(UnsupportedError, match="2 bodies, between which fem.ImplicitSolver has no contact"):
        ImplicitSolver(two, steel(), geometry="plane-strain", loads=(Fixed("left"),), increment=1.0)


def test_element_that_inverts_is_named():
    """A body squeezed through itself is cut and refused with the number of the element."""
    mesh = block([0.0, 0.0], [1.0, 1.0], [1, 2])
    loads = (Symmetry("bottom"), Symmetry("left"), Prescribed("top", 1, -2.0))
    solver = ImplicitSolver(
        mesh, steel(), geometry="plane-strain", loads=loads, increment=1.0, smallest=0.6, cure="none"
    )
    with pytest.raises(NoEquilibrium, match=r"at point \d+ \(element \d\)"):
        solver.advance()


def test_tangents_that_are_not_finite_are_refused(monkeypatch):
    """Stress or tangent that turns to NaN ends the run and does not pass for equilibrium."""
    solver = bar(1, 1, 1.0, 1.0, smallest=0.9)
    linearise = solver.points.linearise

    def spoilt(dt, stresses, tangents):
        work = linearise(dt, stresses, tangents)
        tangents[0, 4, 4] = np.nan
        return work

    monkeypatch.setattr(solver.points, "linearise", spoilt)
    with pytest.raises(NoEquilibrium, match="the tangent is not finite"):
        solver.advance()
    assert solver.time == 0.0 and (solver.positions == solver.mesh.points).all()


@pytest.mark.parametrize(
    ("options", "error", "told"),
    [
        ({"increment": 0.0}, SceneError, "increment = 0 s is out of range"),
        ({"smallest": 2.0}, SceneError, "smallest = 2 s is out of range"),
        ({"tolerance": 0.1}, SceneError, "tolerance"),
        ({"iterations": 0}, SceneError, "iterations = 0 is out of range"),
        ({"log": "no/such/folder/log.jsonl"}, OutputError, "the log cannot be written"),
        ({"linear_solver": "scipi"}, SceneError, "scipy"),
        ({"own_share": 1.5}, SceneError, "own_share"),
        (
            {"own_share": 0.1, "cure": "none"},
            SceneError,
            "own_share is void: the cure 'none' projects nothing",
        ),
        ({"integration": "reduced"}, UnsupportedError, "one-point quad4 has no implicit hourglass control"),
        ({"loads": (Damping(1.0),)}, SceneError, "Damping does nothing without motion"),
    ],
)
def test_senseless_options_are_refused(options, error, told):
    """Options out of range, and what has no tangent, are refused before anything is solved."""
    mesh = block([0.0, 0.0], [1.0, 1.0], [1, 1])
    with pytest.raises(error, match=told):
        ImplicitSolver(mesh, steel(), **({"increment": 1.0} | options))


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


def test_nodal_averages_have_no_tangent():
    """Linear triangles with their cure are refused; the message says what to use."""
    with pytest.raises(UnsupportedError, match="use tri6 elements, or cure='none'"):
        ImplicitSolver(block([0, 0], [1, 1], [1, 1], "tri3"), steel(), increment=1.0)
