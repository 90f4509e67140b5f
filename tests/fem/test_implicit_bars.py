"""Bars in equilibrium, by finite elements: closed forms, necks, work, and going on."""

import json
import math
from dataclasses import asdict

import numpy as np
import pytest

from core_models.errors import SceneError
from core_models.loads import Pressure, Symmetry
from fem import ImplicitSolver
from meshes.block import block
from tests.fem.implicit_bodies import LENGTH, PULL, RADIUS, YOUNG, bar, pulled, steel


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
