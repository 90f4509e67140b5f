"""Heat in implicit finite elements: series solutions, balances, and the limits of a pulled bar."""

from dataclasses import replace

import numpy as np
import pytest

from core_models.errors import MaterialError
from core_models.heating.taylor_quinney import TaylorQuinney
from core_models.loads import FixedTemperature, HeatFlux, Prescribed, Symmetry
from core_models.specific_heat.constant import ConstantSpecificHeat
from fem import ImplicitSolver
from fem.heat_flow import FLOW
from meshes.block import block
from meshes.necking_bar import necking_bar
from studies.necking.reader import read_necking_scene
from studies.verification.closed_forms.conduction import cylinder, heated_slab, slab
from studies.verification.orders import fitted_order

START, SURFACE, FOURIER = 400.0, 300.0, 0.2


def hot_steel(conductivity):
    """The necking bar's steel, warmed by 0.9 of its plastic work; 3.6e6 W/(m K) are a diffusivity of 1 m^2/s."""
    return replace(
        read_necking_scene("necking-simo").material,
        density=7800.0,
        specific_heat=ConstantSpecificHeat(3.6e6 / 7800.0),
        heating=TaylorQuinney(0.9),
        thermal_conductivity=conductivity,
    )


def strip(count, increment, geometry="plane-strain", load=None, kind="quad4"):
    """A slab of 1 m from the middle to the surface, or a cylinder, after a Fourier number of 0.2."""
    mesh = block((0.0, 0.0), (1.0, 1.0 / count), (count, 1), kind)
    held = (Symmetry("left"),) if geometry == "plane-strain" else ()
    loads = (*held, Symmetry("bottom"), load or FixedTemperature("right", SURFACE))
    solver = ImplicitSolver(
        mesh, hot_steel(3.6e6), geometry=geometry, loads=loads, increment=increment, conduction=True, temperature=START
    )  # fmt: skip
    while solver.time < FOURIER:
        solver.advance(FOURIER)
    return solver


def temperatures(solver):
    """Temperatures of the points [K]."""
    return solver.points.old.temperature


@pytest.mark.parametrize(
    ("geometry", "load", "exact"),
    [
        ("plane-strain", None, lambda x: SURFACE + (START - SURFACE) * slab(x, FOURIER)),
        ("axisymmetric", None, lambda x: SURFACE + (START - SURFACE) * cylinder(x, FOURIER)),
        ("plane-strain", HeatFlux("right", 3.6e8), lambda x: START + 100.0 * heated_slab(x, FOURIER)),
    ],
)
def test_temperatures_converge_to_the_series_at_second_order_in_space(geometry, load, exact):
    """Increments go with the square of the size of the elements, which is first order in them."""
    counts, errors = (6, 12), []
    for count in counts:
        solver = strip(count, 0.4 / count**2, geometry, load)
        error = temperatures(solver) - exact(solver.reference_positions[:, 0])
        errors.append(np.sqrt((error**2).mean()))
    assert errors[-1] < 0.5 and fitted_order([1.0 / count for count in counts], errors) >= 1.8


def test_temperatures_converge_at_first_order_in_time():
    """Halved increments halve the difference to the next."""
    found = [temperatures(strip(8, increment)) for increment in (0.02, 0.01, 0.005)]
    first, second = (np.abs(after - before).max() for before, after in zip(found, found[1:], strict=False))
    assert 1.8 < first / second < 2.2


def test_heat_in_the_body_is_what_has_come_in():
    """Through a flux and a given temperature, with increments much longer than explicit ones."""
    solver = strip(6, 0.1, load=FixedTemperature("right", lambda t: START + 1e3 * t))
    content = 3.6e6 * float((solver.points.reference_volumes * (temperatures(solver) - START)).sum())
    assert content == pytest.approx(solver.ledger.heat, rel=1e-10) and content > 0.0
    flux = strip(6, 0.1, load=HeatFlux("right", 1e5))
    assert flux.ledger.heat == pytest.approx(1e5 * FOURIER / 6.0, rel=1e-10)


def pulled(conductivity, conduction=True, loads=(), **options):
    """A tapered bar pulled by 10 % in 1 s."""
    mesh = necking_bar(6.413e-3, 26.667e-3, 2, 4, 0.9, kind=options.pop("kind", "quad4"))
    loads = (Symmetry("neck"), Prescribed("end", 1, 2.6e-3), *loads)
    solver = ImplicitSolver(
        mesh, hot_steel(conductivity), loads=loads, increment=0.1, conduction=conduction, **options
    )
    while solver.time < 1.0:
        solver.advance(1.0)
    return solver


def test_pulled_bar_is_adiabatic_without_conductivity_and_evenly_warm_with_much():
    """The heat is 0.9 of the plastic work in both limits and between them; a cold boundary takes all of it."""
    adiabatic, slow, fast = pulled(45.0, conduction=False), pulled(1e-300), pulled(1e7)
    between = pulled(2e3)
    assert (temperatures(slow) == temperatures(adiabatic)).all()
    start = adiabatic.material.room_temperature
    for solver in (slow, between, fast):
        heat = 3.6e6 * float((solver.points.reference_volumes * (temperatures(solver) - start)).sum())
        assert heat == pytest.approx(0.9 * solver.ledger.plastic, rel=1e-10)
    spread = [np.ptp(temperatures(each)) for each in (slow, between, fast)]
    assert spread[0] > 10.0 and 0.1 * spread[0] < spread[1] < 0.9 * spread[0] and spread[2] < 0.1
    cold = pulled(1e12, loads=(FixedTemperature("neck", 294.0),))
    assert temperatures(cold) == pytest.approx(294.0, abs=1e-4)
    assert cold.ledger.heat == pytest.approx(-0.9 * cold.ledger.plastic, rel=1e-3)


def test_heat_flows_through_the_deformed_body_as_in_explicit_elements():
    """Conductances times temperatures are what the explicit kernel lets flow, with a locking cure at work."""
    solver = pulled(2e3)
    heat = solver._conduction
    assert np.ptp(solver._body.scales) > 1e-6
    heat._conduct(0.1, temperatures(solver))
    expected = np.bincount(
        heat._tables.nodes.ravel(), weights=heat._corners[..., FLOW].ravel(), minlength=len(heat.temperatures)
    )
    flow = heat._flow(heat._conductances(), heat.temperatures)
    assert np.abs(flow + expected).max() < 1e-12 * np.abs(flow).max()


def test_conducting_body_restarts_bitwise():
    """Temperatures of the nodes are part of a checkpoint."""
    first = pulled(2e3)
    second = ImplicitSolver(
        first.mesh, first.material, loads=(Symmetry("neck"), Prescribed("end", 1, 2.6e-3)), increment=0.1,
        conduction=True,
    )  # fmt: skip
    second.restore(first.checkpoint())
    for solver in (first, second):
        solver.advance(1.1)
    assert (temperatures(second) == temperatures(first)).all()


def test_material_that_cannot_conduct_is_refused():
    """The message names what the card lacks."""
    mesh = block((0.0, 0.0), (1.0, 1.0), (1, 1))
    with pytest.raises(MaterialError, match="<thermal_conductivity> and <specific_heat>"):
        ImplicitSolver(mesh, read_necking_scene("necking-simo").material, increment=1.0, conduction=True)
