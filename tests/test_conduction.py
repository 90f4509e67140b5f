"""Heat conduction in both methods: series solutions, balances, symmetry, what is off costs nothing, refusals."""

from dataclasses import replace

import numpy as np
import pytest

from core_models.elasticity.isotropic import IsotropicElastic
from core_models.errors import MaterialError, SceneError
from core_models.loads import FixedTemperature, HeatFlux, Prescribed, Symmetry
from core_models.material import Material
from core_models.specific_heat.constant import ConstantSpecificHeat
from core_models.updates.compressible_neo_hookean import CompressibleNeoHookean
from meshes.block import block
from studies.verification.closed_forms.conduction import cylinder, heated_slab, slab
from studies.verification.orders import fitted_order

METHODS = ("fem-explicit", "mpm")
HEAVINESS, CONDUCTIVITY = 1000.0, 1000.0  # J/(m^3 K), W/(m K): a diffusivity of 1 m^2/s
START, SURFACE = 400.0, 300.0  # K
COUNTS = (8, 12, 16)
LEAST_ORDER = 1.9
ROUND_OFF = 1e-12


@pytest.fixture
def conductor():
    """A body in which heat moves much faster than waves do."""
    return Material(
        "conductor",
        HEAVINESS,
        CompressibleNeoHookean(),
        IsotropicElastic(1e4 / 3.0, 5e3),
        specific_heat=ConstantSpecificHeat(1.0),
        thermal_conductivity=CONDUCTIVITY,
    )


@pytest.fixture
def strip(conductor, build):
    """A solver of a slab of 1 m from the middle to the surface, or of a cylinder, two cells high."""

    def make(method, count, geometry="plane-strain", **options):
        mesh = block((0.0, 0.0), (1.0, 2.0 / count), (count, 2))
        cell = {"cell_size": 1.0 / count} if method == "mpm" else {}
        options = {"temperature": START, "wall": None, "conduction": True} | cell | options
        return build(method, mesh, conductor, geometry=geometry, **options)

    return make


def temperatures(solver):
    """Temperatures of the points."""
    return solver.points.fields()["temperature"].array


def content(solver):
    """Heat in the body above 0 K."""
    capacities = solver.points.reference_volumes * HEAVINESS
    return float((capacities * temperatures(solver)).sum())


def run(solver, end):
    """Step to a time."""
    while solver.time < end:
        solver.advance(end)
    return solver


def order(make, exact, fourier):
    """Observed order of the root-mean-square error of the points' temperatures."""
    errors = []
    for count in COUNTS:
        solver = run(make(count), fourier)
        error = temperatures(solver) - exact(solver.reference_positions[:, 0])
        errors.append(np.sqrt((error**2).mean()))
    return fitted_order([1.0 / count for count in COUNTS], errors)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(("geometry", "series"), [("plane-strain", slab), ("axisymmetric", cylinder)])
def test_cold_surface_converges_to_the_series(strip, method, geometry, series):
    """A slab and a cylinder whose surface is suddenly cold: second order."""

    def make(count):
        return strip(method, count, geometry, loads=(FixedTemperature("right", SURFACE),))

    assert order(make, lambda x: SURFACE + (START - SURFACE) * series(x, 0.2), 0.2) >= LEAST_ORDER


@pytest.mark.parametrize("method", METHODS)
def test_heated_surface_converges_to_the_series(strip, method):
    """A slab heated by a constant flux from one side: second order."""

    def make(count):
        return strip(method, count, loads=(HeatFlux("right", 1e5),))

    assert order(make, lambda x: START + 1e5 / CONDUCTIVITY * heated_slab(x, 0.2), 0.2) >= LEAST_ORDER


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("geometry", ["plane-strain", "axisymmetric"])
def test_heat_in_the_body_is_what_has_come_in(strip, method, geometry):
    """Content changes by the ledger's heat to round-off; a flux brings flux times area times time; else it stays."""
    insulated = run(strip(method, 6, geometry), 0.02)
    assert insulated.ledger.heat == 0.0
    assert content(insulated) == pytest.approx(START * insulated.mass, rel=ROUND_OFF)
    loads = (HeatFlux("right", lambda t: 1e5 * t), FixedTemperature("top", lambda t: START + 1e3 * t))
    solver = strip(method, 6, geometry, loads=loads)
    before = content(solver)
    run(solver, 0.02)
    assert content(solver) - before == pytest.approx(solver.ledger.heat, rel=1e-9)
    flux = run(strip(method, 6, geometry, loads=(HeatFlux("right", 1e5),)), 0.02)
    area = (2.0 * np.pi if geometry == "axisymmetric" else 1.0) * 2.0 / 6.0
    assert flux.ledger.heat == pytest.approx(1e5 * area * 0.02, rel=1e-9)
    assert abs(flux.ledger.total - flux.ledger.initial) < ROUND_OFF * flux.ledger.heat


@pytest.mark.parametrize("method", METHODS)
def test_plastic_work_warms_the_body_by_its_heated_part(build, bar, johnson_cook, method):
    """With conduction the heat in an insulated bar is 0.9 of the plastic work to round-off, and spread out further."""
    hottest = []
    for conductivity in (1e-300, 4e5):
        material = replace(johnson_cook, thermal_conductivity=conductivity)
        solver = build(method, bar(4, 6), material, velocity=-200.0, conduction=True)
        run(solver, 2e-6)
        rise = temperatures(solver) - material.room_temperature
        heat = material.density * 383.0 * float((solver.points.reference_volumes * rise).sum())
        assert heat == pytest.approx(0.9 * solver.ledger.plastic, rel=1e-10)
        hottest.append(rise.max())
    assert hottest[1] < 0.8 * hottest[0]


@pytest.mark.parametrize("method", METHODS)
def test_without_conductivity_points_are_adiabatic_to_the_last_bit(build, bar, johnson_cook, method):
    """A vanishing conductivity changes nothing at all."""
    material = replace(johnson_cook, thermal_conductivity=1e-300)
    runs = [
        run(build(method, bar(3, 4), material, velocity=-200.0, conduction=on), 1e-6) for on in (False, True)
    ]
    fields = [solver.points.fields() for solver in runs]
    assert fields[0]["temperature"].array.max() > material.room_temperature + 1.0
    for name, field in fields[0].items():
        assert np.array_equal(field.array, fields[1][name].array), name


@pytest.mark.parametrize("method", METHODS)
def test_what_is_off_is_not_there(strip, method):
    """Without conduction no temperature that no law asks for, and no thermal load."""
    off = strip(method, 4, conduction=False)
    assert "temperature" not in off.points.fields() and off._conduction is None
    with pytest.raises(SceneError, match="without conduction: turn it on"):
        strip(method, 4, conduction=False, loads=(FixedTemperature("right", SURFACE),))


@pytest.mark.parametrize("method", METHODS)
def test_half_a_body_is_as_warm_as_the_whole(build, conductor, method):
    """A symmetry plane lets no heat through: half and whole agree to round-off."""

    def body(low, **options):
        mesh = block((low, 0.0), (1.0, 0.5), (round((1.0 - low) * 4), 2))
        cell = {"cell_size": 0.25} if method == "mpm" else {}
        options = {
            "wall": None,
            "conduction": True,
            "temperature": START,
            "geometry": "plane-strain",
        } | options
        return run(build(method, mesh, conductor, **cell, **options), 0.05)

    right = FixedTemperature("right", SURFACE)
    half = body(0.0, loads=(right, Symmetry("left")))
    whole = body(-1.0, loads=(right, FixedTemperature("left", SURFACE)))
    inner = whole.reference_positions[:, 0] > 0.0
    found = whole.reference_positions[inner]
    order_half = np.lexsort(np.round(half.reference_positions, 9).T)
    order_whole = np.lexsort(np.round(found, 9).T)
    assert temperatures(whole)[inner][order_whole] == pytest.approx(temperatures(half)[order_half], rel=1e-11)
    assert whole.ledger.heat == pytest.approx(2.0 * half.ledger.heat, rel=1e-9)


@pytest.mark.parametrize("method", METHODS)
def test_a_slice_in_three_dimensions_is_as_warm_as_in_two(build, conductor, method):
    """A body between two symmetry planes in 3-D has the temperatures of plane strain to round-off."""
    warm = []
    for d in (2, 3):
        counts = (4, 2) if d == 2 else (4, 2, 2)
        mesh = block((0.0,) * d, tuple(0.25 * n for n in counts), counts, "quad4" if d == 2 else "hex8")
        loads = (FixedTemperature("right", SURFACE), HeatFlux("top", 1e5))
        loads += () if d == 2 else (Symmetry("front"), Symmetry("back"))
        cell = {"cell_size": 0.25} if method == "mpm" else {}
        solver = build(
            method, mesh, conductor, geometry="plane-strain" if d == 2 else "spatial", wall=None, conduction=True,
            temperature=START, loads=loads, **cell,
        )  # fmt: skip
        for _step in range(8):
            solver.time_step = 2e-3
            solver.advance(0.016)
        warm.append((solver.reference_positions[:, [0, -1]], temperatures(solver)))
    (places, flat), (others, deep) = warm
    nearest = np.linalg.norm(others[:, None] - places[None], axis=2).argmin(axis=1)
    assert deep == pytest.approx(flat[nearest], rel=1e-11)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("stretch", [0.75, 1.5])
def test_heat_flows_in_the_deformed_body(strip, method, stretch):
    """A slab stretched by s, held there: the series at the Fourier number k t / (rho_0 c a^2) / s."""
    held = (("left", 0), ("right", 0), ("bottom", 1), ("top", 1))
    cell = {"cell_size": stretch / 12} if method == "mpm" and stretch < 1.0 else {}
    solver = strip(
        method, 12, displacement=lambda x: (stretch - 1.0) * x * [1.0, 0.0],
        loads=(*(Prescribed(*each) for each in held), FixedTemperature("right", SURFACE)), **cell,
    )  # fmt: skip
    run(solver, 0.2 * stretch)
    exact = SURFACE + (START - SURFACE) * slab(solver.reference_positions[:, 0], 0.2)
    assert solver.point_positions()[:, 0] == pytest.approx(
        stretch * solver.reference_positions[:, 0], abs=0.01
    )
    assert np.abs(temperatures(solver) - exact).max() < 0.02 * (START - SURFACE)


@pytest.mark.parametrize("stretch", [1.0, 1.5])
def test_heat_flows_through_convected_domains(strip, stretch):
    """The same with CPDI: the domains follow the deformation, and the heat is what has come in."""
    held = (("left", 0), ("right", 0), ("bottom", 1), ("top", 1))
    solver = strip(
        "mpm", 12, displacement=lambda x: (stretch - 1.0) * x * [1.0, 0.0], interpolation="cpdi",
        loads=(*(Prescribed(*each) for each in held), FixedTemperature("right", SURFACE)),
    )  # fmt: skip
    before = content(solver)
    run(solver, 0.2 * stretch)
    exact = SURFACE + (START - SURFACE) * slab(solver.reference_positions[:, 0], 0.2)
    assert np.abs(temperatures(solver) - exact).max() < 0.02 * (START - SURFACE)
    assert content(solver) - before == pytest.approx(solver.ledger.heat, rel=1e-9)


@pytest.mark.parametrize("method", METHODS)
def test_heat_goes_with_a_moving_body(strip, method):
    """Straight flight across many cells changes temperatures by no more than the error at rest."""
    loads = (FixedTemperature("right", SURFACE),)
    rest, flight = (run(strip(method, 12, loads=loads, velocity=v), 0.1) for v in ((0.0, 0.0), (3.0, -2.0)))
    assert np.abs(flight.point_positions() - rest.point_positions() - [0.3, -0.2]).max() < 1e-3
    assert np.abs(temperatures(flight) - temperatures(rest)).max() < 3e-3 * (START - SURFACE)


@pytest.mark.parametrize("method", METHODS)
def test_what_nodes_cannot_tell_apart_evens_out(strip, method):
    """Points hot and cold in turns within a cell all come to the mean, and no heat is lost."""
    solver = strip(method, 4)
    random = np.random.default_rng(0)
    temperatures(solver)[:] += random.uniform(-50.0, 50.0, solver.points.n)
    if method == "fem-explicit":
        solver._conduction.start()
    mean = content(solver) / (HEAVINESS * solver.points.reference_volumes.sum())
    run(solver, 2.0)
    assert temperatures(solver) == pytest.approx(np.full(solver.points.n, mean), abs=0.05)
    assert content(solver) == pytest.approx(
        mean * HEAVINESS * solver.points.reference_volumes.sum(), rel=1e-12
    )


@pytest.mark.parametrize("method", METHODS)
def test_temperatures_are_bitwise_the_same_for_any_number_of_threads(strip, method):
    """One thread and two."""
    loads = (FixedTemperature("right", SURFACE), HeatFlux("top", 1e4))
    one, two = (run(strip(method, 24, loads=loads, threads=n), 2e-3) for n in (1, 2))
    assert np.array_equal(temperatures(one), temperatures(two))
    assert one.ledger.heat == two.ledger.heat


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    ("change", "loads", "error", "told"),
    [
        ({"thermal_conductivity": None}, (), MaterialError, "<thermal_conductivity>"),
        ({"specific_heat": None}, (), MaterialError, "<specific_heat>"),
        ({}, (FixedTemperature("right", -1.0),), SceneError, "above 0"),
        ({}, (HeatFlux("right", np.nan),), SceneError, "finite"),
        ({}, (FixedTemperature("rigth", 300.0),), SceneError, "did you mean 'right'"),
        ({}, (FixedTemperature("top", 300.0), HeatFlux("top", 1.0)), SceneError, "2 temperatures or fluxes"),
        ({}, (FixedTemperature("left", 300.0),), SceneError, "lie on the axis"),
    ],
)
def test_what_cannot_be_conducted_is_refused_by_name(build, conductor, method, change, loads, error, told):
    """Materials without the constants, temperatures and fluxes that are none, boundaries that are not there."""
    mesh = block((0.0, 0.0), (1.0, 0.5), (4, 2))
    cell = {"cell_size": 0.25} if method == "mpm" else {}
    with pytest.raises(error, match=told):
        build(method, mesh, replace(conductor, **change), wall=None, conduction=True, loads=loads, **cell)
