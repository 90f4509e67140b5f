"""Implicit quasi-static material points: exact stiffness, equilibrium, closed forms, cut cells, and what is refused."""

import math
from dataclasses import replace

import numpy as np
import pytest

from core_models.driver import drive_program
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.equilibrium.order import newton_orders
from core_models.errors import LoadBeyondEquilibrium, SceneError, SingularStiffness, UnsupportedError
from core_models.flow.voce import Voce
from core_models.loading import Deformation, Stress
from core_models.loading_program import Program, Segment
from core_models.loads import BodyForce, Damping, Fixed, Prescribed, Pressure, Symmetry, Traction, gravity
from core_models.material import Material
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.yield_condition.von_mises import VonMises
from meshes.annulus import annulus
from meshes.block import block
from meshes.necking_bar import necking_bar
from mpm import ImplicitSolver
from mpm.implicit.splines import Splines

H = 1e-3  # m, size of the cells
MEAN = "mean-dilatation"
RADIUS, LENGTH, TAPER = 6.413e-3, 26.667e-3, 0.982
PULL = 7e-3  # m per second


def steel():
    """The necking bar's steel."""
    bulk, shear = 164.206e9, 80.1938e9
    flow = Voce(0.45e9, 0.715e9, 16.93, 0.12924e9)
    return Material(
        "steel", 7800.0, HyperelasticPlastic(), IsotropicElastic(bulk, shear), NeoHookean(bulk), flow, VonMises()
    )  # fmt: skip


def solve(mesh, loads, increment=0.5, end=1.0, **options):
    """Lead a body up to a time [s]."""
    solver = ImplicitSolver(mesh, steel(), loads=loads, increment=increment, **({"cell_size": H} | options))
    while solver.time < end:
        solver.advance(end)
    return solver


def bar(increment, across=5, along=20, taper=TAPER, grading=0.2, **options):
    """The necking bar, with lines of the grid through the nodes on its axis."""
    mesh = necking_bar(RADIUS, LENGTH, across, along, taper, grading)
    heights = np.sort(mesh.points[mesh.points[:, 0] == 0.0, 1])
    loads = (Symmetry("neck"), Prescribed("end", 1, PULL))
    options = {"cell_size": (RADIUS / across, heights), "cure": MEAN} | options
    return ImplicitSolver(mesh, steel(), loads=loads, increment=increment, **options)


def pulled(solver, end):
    """Force [N] at the end of every increment up to a time [s]."""
    forces = []
    while solver.time < end:
        solver.advance(end)
        forces.append(solver.boundary_force("end")[1])
    return np.array(forces)


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
        assert np.abs(measured - exact[:, dof]).max() < 1e-8 * np.abs(exact).max()


@pytest.mark.parametrize(
    ("interpolation", "cure"), [("linear", MEAN), ("quadratic", MEAN), ("quadratic", None)]
)
def test_linear_fields_are_exact(interpolation, cure):
    """With every side moved linearly the inside follows, stress is the same everywhere, and forces balance."""
    gradient = np.array([[0.03, 0.02], [-0.01, 0.05]])
    mesh = block([0.0, 0.0], [3.0 * H, 3.0 * H], [3, 3])
    loads = tuple(
        Prescribed(name, i, lambda X, t, row=gradient[i]: X @ row)
        for name in mesh.boundaries
        for i in range(2)
    )
    solver = solve(mesh, loads, geometry="plane-strain", interpolation=interpolation, cure=cure)
    expected = solver.reference_positions @ (np.eye(2) + gradient).T
    assert np.abs(solver.positions - expected).max() < 1e-12 * H
    stress = solver.points.old.stress
    assert np.ptp(stress, axis=0).max() < 1e-8 * np.abs(stress).max()
    total = sum(solver._supports.reactions)
    assert np.abs(total).max() < 1e-8 * np.abs(solver.nodal_forces()).max()


@pytest.mark.parametrize("geometry", ["axisymmetric", "spatial"])
def test_uniaxial_tension_is_that_of_a_point(geometry):
    """Drawn to 1.6 times its length through cells that it cuts, a block has the stress of the point driver."""
    d, stretch, steps = 3 if geometry == "spatial" else 2, 1.6, 32
    size = [0.7 * H] * (d - 1) + [2.0 * H]
    mesh = block([0.0] * d, size, [1] * (d - 1) + [2], "hex8" if d == 3 else "quad4")
    sides = ("left", "front") if d == 3 else ()
    loads = (*map(Symmetry, ("bottom", *sides)), Prescribed("top", d - 1, (stretch - 1.0) * size[-1]))
    options = {"interpolation": "linear"} if d == 3 else {"cure": MEAN}
    solver = solve(mesh, loads, 1.0 / steps, cell_size=(*[0.45 * H] * (d - 1), H), **options)
    controls = {"11": Stress(), "22": Stress(), "33": Deformation(stretch)}
    history = drive_program(steel(), Program([Segment(1.0, steps, controls)]))
    axial = solver.points.old.stress[:, d - 1]
    assert axial == pytest.approx(history.stress[-1, 2], rel=1e-7)
    lateral = history.deformation_gradient[-1, 0, 0]
    assert solver.boundary_positions("right")[:, 0] == pytest.approx(lateral * size[0], rel=1e-8)
    area = math.pi * size[0] ** 2 if d == 2 else size[0] ** 2
    assert solver.boundary_force("top")[-1] == pytest.approx(
        area * lateral**2 * history.stress[-1, 2], rel=1e-7
    )
    assert solver.step_count == steps


def test_untapered_bar_reaches_the_largest_uniform_force():
    """79.46 kN in closed form, within 0.1 %, with a rim that cuts the cells."""
    solver = bar(0.02, 2, 2, 1.0, 1.0, cell_size=(0.4 * RADIUS, LENGTH / 2))
    forces = pulled(solver, 0.6)
    assert np.ptp(solver.points.old.equivalent_plastic_strain) < 1e-9
    assert forces.max() == pytest.approx(79.46e3, rel=1e-3)


def test_tapered_bar_necks():
    """On 5 x 20 cells the force peaks at 77.3 kN near 2.8 mm and falls, the neck alone goes on, without a cut."""
    solver = bar(1.0 / 32.0)
    forces = pulled(solver, 1.0)
    peak = int(forces.argmax())
    assert forces[peak] == pytest.approx(77.3e3, rel=1e-3)
    assert PULL * solver.log.increments[peak].time == pytest.approx(2.83e-3, abs=0.2e-3)
    assert solver.log.cuts == [] and forces[-1] < 0.5 * forces[peak]
    assert solver.boundary_positions("neck")[:, 0].max() < 0.5 * RADIUS
    assert solver.boundary_positions("end")[:, 0].max() > 0.9 * RADIUS
    assert solver.ledger.hourglass < 5e-3 * solver.ledger.external


def test_cure_holds_changes_of_volume_within_a_cell():
    """Beyond the largest force no surface wrinkles: cubic splines give the neck of quadratic ones, cured or not."""
    radii = []
    for interpolation, cure in (("quadratic", MEAN), ("cubic", MEAN), ("cubic", None)):
        solver = bar(1.0 / 32.0, interpolation=interpolation, cure=cure)
        pulled(solver, 0.75)
        side = solver.boundary_positions("side")
        radii.append(solver.boundary_positions("neck")[:, 0].max())
        assert (np.diff(side[np.argsort(side[:, 1]), 0])[:10] > 0.0).all()
    assert radii == pytest.approx([radii[0]] * 3, rel=0.01)


def test_cure_frees_linear_functions():
    """A strip clamped at one end and pulled past yield takes the force that it does with splines; uncured 14 % more."""
    mesh = block([0.0, 0.0], [6.0 * H, 2.0 * H], [6, 2])
    loads = (Fixed("left"), Symmetry("bottom"), Prescribed("right", 0, 0.6 * H))
    splines, cured, plain = (
        solve(
            mesh, loads, 0.1, geometry="plane-strain", interpolation=interpolation, cure=cure
        ).boundary_force("right")[0]
        for interpolation, cure in (("quadratic", MEAN), ("linear", MEAN), ("linear", None))
    )
    assert cured == pytest.approx(splines, rel=5e-3)
    assert plain > 1.1 * splines


def test_newton_converges_at_second_order():
    """Where three corrections in a row see the same flowing points, the order is at least 1.8."""
    solver = bar(0.1, tolerance=1e-11)
    pulled(solver, 0.6)
    orders = newton_orders(solver.log)
    assert len(orders) >= 2 and min(orders) >= 1.8


@pytest.mark.parametrize(("interpolation", "most"), [("quadratic", 2e5), ("cubic", 2e5)])
def test_ghost_penalty_bounds_the_condition_number(interpolation, most):
    """While the edge of a body moves through a cell it stays bounded; without the penalty it grows without bound."""
    condition = {}
    for filled in (1e-3, 1e-2, 0.1, 1.0):
        mesh = block([0.0, 0.0], [5.0 * H, 4.0 * H], [5, 4])
        points = mesh.points.copy()
        points[points[:, 0] > 4.5 * H, 0] = (4.0 + filled) * H
        for ghost in (0.0, 1e-4):
            solver = ImplicitSolver(
                replace(mesh, points=points), steel(), geometry="plane-strain", cell_size=H, increment=1.0,
                loads=(Symmetry("left"), Symmetry("bottom")), interpolation=interpolation, ghost=ghost,
            )  # fmt: skip
            condition[filled, ghost] = solver.log.records[0].condition
    assert condition[1e-3, 1e-4] < min(most, 1.5 * condition[1e-2, 1e-4])
    assert condition[1e-3, 0.0] > 100.0 * condition[1e-2, 0.0] > 1e4 * condition[0.1, 0.0] > 1e4 * 1e4
    assert condition[1.0, 1e-4] == pytest.approx(condition[1.0, 0.0], rel=0.1)
    assert solver.condition_number() == pytest.approx(solver.log.records[0].condition, rel=1e-6)
    assert "condition number" in solver.log.text()


def test_pressure_follows_the_surface():
    """A pressurised ring: the hoop force of its section balances the pressure on its current inner radius."""
    mesh = block([10e-3, 0.0], [11e-3, 1e-3], [4, 1])
    pressure = 20e6
    loads = (Symmetry("bottom"), Symmetry("top"), Pressure("left", lambda t: pressure * t))
    solver = solve(mesh, loads, cell_size=(0.25e-3, 1e-3))
    areas = solver.point_volumes() / (2.0 * math.pi * solver.point_positions()[:, 0])
    inner = solver.boundary_positions("left")[:, 0].mean()
    hoop = (solver.points.old.stress[:, 2] * areas).sum()
    assert hoop == pytest.approx(pressure * inner * 1e-3, rel=1e-5)
    assert sum(each.iterations for each in solver.log.increments) <= 8


def test_loads_go_through_the_supports():
    """Weight and a traction on the top, which cuts cells, are what the support at the foot carries; energy closes."""
    mesh = block([0.0, 0.0], [2.0 * H, 2.3 * H], [4, 6])
    pull = Traction("top", lambda X, t: np.tile([0.0, 1e8 * t], (len(X), 1)))
    weight = BodyForce(lambda X, t: np.tile([0.0, -1e6 * t], (len(X), 1)), "reference")
    loads = (Symmetry("left"), Fixed("bottom"), pull, weight)
    solver = solve(mesh, loads, geometry="plane-strain", cell_size=0.6 * H)
    expected = 1e6 * solver.mass - 1e8 * 2.0 * H
    assert solver.boundary_force("bottom")[1] == pytest.approx(expected, rel=1e-7)
    assert abs(solver.ledger.relative_error) < 1e-3
    assert set(solver.outline()) >= {"top", "right"}
    volume = solver.point_volumes().sum()
    corners = solver.domains()
    across, along = corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]
    areas = 0.5 * (across[:, 0] * along[:, 1] - across[:, 1] * along[:, 0])
    assert areas.sum() == pytest.approx(volume, rel=1e-5)


def test_parts_of_a_face_are_held_by_springs():
    """The two halves of a top, held one by one, carry what the whole top does; reactions and energy balance."""
    mesh = block([0.0, 0.0], [4.0 * H, 3.0 * H], [8, 6])
    ends = mesh.boundaries["top"]
    first = mesh.points[ends][:, :, 0].mean(axis=1) < 2.0 * H
    mesh = replace(mesh, boundaries=mesh.boundaries | {"left half": ends[first], "right half": ends[~first]})
    forces = {}
    for names in (("top",), ("left half", "right half")):
        tops = [load for name in names for load in (Prescribed(name, 1, 0.02 * H), Prescribed(name, 0))]
        solver = solve(mesh, (Fixed("bottom"), *tops), 0.1, geometry="plane-strain", cell_size=0.75 * H)
        forces[names] = sum(solver.boundary_force(name)[1] for name in names)
        assert solver.boundary_force("bottom")[1] == pytest.approx(-forces[names], rel=1e-6)
        assert abs(solver.ledger.relative_error) < 0.03
    whole, parts = forces.values()
    assert parts == pytest.approx(whole, rel=5e-3)


def test_curved_surfaces_are_held_by_springs():
    """A hollow elastic sphere whose inner surface is moved outwards: Lame's displacement of the outer one, force."""
    inner, outer, grown = 5.0 * H, 10.0 * H, 1e-4 * H
    mesh = annulus(inner, outer, [8, 24], "quad4", quarter=True)
    loads = [Prescribed("inner", i, lambda X, t, i=i: grown * X[:, i] / inner) for i in range(2)]
    solver = solve(mesh, (*loads, Symmetry("symmetry_y")), 1.0, cell_size=0.6 * H)
    bulk, shear = steel().elasticity
    # u = a r + b / r^2 with 3 K a = 4 G b / outer^3 where no stress is
    b = grown / (1.0 / inner**2 + 4.0 * shear * inner / (3.0 * bulk * outer**3))
    a = 4.0 * shear * b / (3.0 * bulk * outer**3)
    reference, current = solver.boundary_points("outer")
    moved = ((current - reference) * reference).sum(axis=1) / outer
    assert moved == pytest.approx(a * outer + b / outer**2, rel=0.01)
    pressure = 4.0 * shear * b / inner**3 - 3.0 * bulk * a
    assert solver.boundary_force("inner")[1] == pytest.approx(math.pi * inner**2 * pressure, rel=0.01)


def test_half_a_body_is_half_of_the_whole():
    """A plane of symmetry stands for the other half, but for the slopes that the grid's end leaves free there."""
    loads = (Fixed("left"), Prescribed("right", 0, 0.4 * H))
    whole, half = (
        solve(
            block([0.0, low * H], [3.0 * H, 2.0 * H], [6, 2 * (2 - low)]),
            (*loads, *more),
            geometry="plane-strain",
            cell_size=0.5 * H,
        )
        for low, more in ((-2, ()), (0, (Symmetry("bottom"),)))
    )
    upper = whole.reference_positions[:, 1] > 0.0
    moved = half.positions - half.reference_positions
    assert np.abs(whole.positions[upper] - half.positions).max() < 0.01 * np.abs(moved).max()


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


@pytest.mark.parametrize(
    ("geometry", "loads", "told"),
    [
        ("plane-strain", (), "translation along x, translation along y, rotation"),
        ("plane-strain", (Symmetry("bottom"),), "translation along x:"),
        ("axisymmetric", (Pressure("right", 1.0),), "translation along z"),
    ],
)
def test_missing_support_is_told_by_its_motion(geometry, loads, told):
    """A singular stiffness is an error with status 3 that names the free motion."""
    with pytest.raises(SingularStiffness, match=told) as caught:
        solve(block([0, 0], [2.0 * H, 2.0 * H], [2, 2]), loads, geometry=geometry)
    assert caught.value.exit_status == 3


def test_too_few_particles_are_told():
    """Where particles are farther apart than cells, motions between them cost nothing: refused with the numbers."""
    mesh = block([0.0, 0.0], [4.0 * H, 4.0 * H], [4, 4])
    with pytest.raises(SingularStiffness, match="64 particles in 64 cells.*give a finer mesh"):
        solve(
            mesh,
            (Fixed("bottom"),),
            geometry="plane-strain",
            interpolation="cubic",
            cell_size=0.4 * H,
            ghost=0.0,
        )


@pytest.mark.parametrize(
    ("options", "error", "told"),
    [
        ({"interpolation": "cpdi"}, UnsupportedError, "'cpdi'.*linear, quadratic, cubic"),
        ({"interpolation": "quadrtic"}, SceneError, "quadratic"),
        ({"cure": "mean"}, SceneError, MEAN),
        ({"ghost": -1.0}, SceneError, "ghost = -1.0 is out of range"),
        ({"cell_size": 0.0}, SceneError, "cell_size"),
        ({"cell_size": (H,)}, SceneError, "cell_size has 1 entries"),
        ({"cell_size": (H, [0.0, H])}, SceneError, "the grid ends at y = 0.001 m, the body at 0.002"),
        ({"cell_size": (H, [-H, H, 2 * H])}, SceneError, "held at y = 0 m, but the grid ends at -0.001"),
        ({"cell_size": (H, [H, 0.0])}, SceneError, "ascending"),
        ({"loads": (Damping(1.0),)}, SceneError, "Damping does nothing without motion.*mpm.Solver"),
        ({"loads": (Symmetry("bottom"), gravity([0.0, 1.0, 2.0]))}, SceneError, "shape"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused(options, error, told):
    """In one line, before anything is solved."""
    mesh = block([0.0, 0.0], [2.0 * H, 2.0 * H], [2, 2])
    given = {"cell_size": H, "loads": (Symmetry("bottom"),), "geometry": "plane-strain"} | options
    with pytest.raises(error, match=told) as caught:
        ImplicitSolver(mesh, steel(), increment=1.0, **given)
    assert "\n" not in str(caught.value)
