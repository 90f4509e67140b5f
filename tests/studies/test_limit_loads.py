"""Limit loads and the scenes of the pressure-dependent, porous and kinematic laws: a number of every figure."""

import json
import math
import os
import subprocess
import sys

import numpy as np
import pytest

from studies.limit_loads import footing
from studies.limit_loads.cavity import limit, pressures
from studies.limit_loads.closed_forms import (
    CYLINDER,
    SPHERE,
    bearing_factor,
    cavity_pressure,
    kinematic_path,
)
from studies.limit_loads.loading import IMPLICIT
from studies.limit_loads.materials import COHESION, mohr_coulomb
from studies.report.figures import picture_svg
from studies.report.parts import Picture
from studies.verification.problems import sandia_spall

IN_PLAIN_PYTHON = """
import json
from dataclasses import replace
from pathlib import Path
from studies.limit_loads import reversed_bar, solder_lap
from studies.methods.method import build_solver
from studies.scenes.reader import read_scene
from studies.scenes.shipped import find_scene

solder_lap.ROWS, solder_lap.LENGTH = 5, 0.4e-3
test = solder_lap.TESTS[0]
shear, stress = solder_lap.slab(test)
lap = solder_lap.sheared("fem-implicit", test, 1).values[-1]
reversed_bar.SIZE, reversed_bar.RADIUS, reversed_bar.QUARTERS, reversed_bar.ROWS = 6e-3, 6e-3, 3, 4
bar = reversed_bar.compared(reversed_bar.cycled("fem-implicit"))
solver = build_solver(read_scene(find_scene("taylor-hy100-gtn")), "fem-explicit", 2, "unilateral", 1)
while solver.time < 2e-6:
    solver.advance(2e-6)
print(json.dumps({
    "slab": float(stress[-1]), "lap": float(lap[2]), "bar": [float(max(abs(bar[1] - bar[2]))), float(max(bar[1]))],
    "voids": float(solver.points.old.porosity.max()),
}))
"""


def test_closed_forms_have_their_published_values():
    """Thick walls of b / a = 2, N_c for four angles; pressure-dependent walls tend to Tresca's without friction."""
    assert cavity_pressure(1.0 / math.sqrt(3.0), 0.0, 1.0, 2.0) == pytest.approx(0.80038, abs=5e-6)
    assert cavity_pressure(0.5, 0.0, 1.0, 2.0, SPHERE) == pytest.approx(1.38629, abs=5e-6)
    for around in (CYLINDER, SPHERE):
        frictionless = cavity_pressure(1.0, 0.0, 1.0, 2.0, around)
        assert cavity_pressure(1.0, 1e-4, 1.0, 2.0, around) == pytest.approx(frictionless, rel=1e-5)
    factors = [bearing_factor(friction) for friction in (0.0, 10.0, 20.0, 30.0)]
    assert factors == pytest.approx([5.14159, 8.34493, 14.83471, 30.13963], abs=5e-6)


def test_a_kinematic_bar_flows_back_twice_the_yield_stress_lower():
    """+1 %: 285.714 MPa; 400 MPa lower it still is elastic; -1 %: -285.714 MPa."""
    path = kinematic_path(200e9, 0.2e9, 10e9, [0.01, 0.008, -0.01])
    assert np.array(path) / 1e6 == pytest.approx([285.714, -114.286, -285.714], abs=1e-3)


@pytest.mark.parametrize("around", [CYLINDER, SPHERE])
def test_thick_walls_collapse_at_the_closed_form(around):
    """Mohr-Coulomb with 30 degrees, implicit elements, 6 across the wall: 1 %."""
    found = pressures(IMPLICIT, around, (mohr_coulomb(30.0), COHESION, 30.0), 6)
    assert limit(found) == pytest.approx(1.0, abs=0.01)


def test_a_footing_is_carried_up_to_prandtls_pressure():
    """Without friction, two and four cells under half the footing: within 5 % for cells of size 0, and drawn."""
    found = [footing.pressed(IMPLICIT, "Tresca", cells) for cells in (2, 4)]
    assert footing.extrapolated(found, (2, 4)) == pytest.approx(2.0 + math.pi, rel=0.05)
    solver = found[-1].solver
    fields = {"ground": (solver.domains(), solver.points.old.equivalent_plastic_strain)}
    assert picture_svg(Picture("Wedge", "plastic strain", fields), "footing").startswith("<svg")


def test_a_joint_a_bar_and_a_porous_impact_in_plain_python():
    """The soldered joint near its slab, the reversed bar on the closed form, voids of the HY100 bar as recorded."""
    environment = os.environ | {"NUMBA_DISABLE_JIT": "1"}
    done = subprocess.run(
        [sys.executable, "-c", IN_PLAIN_PYTHON], env=environment, capture_output=True, text=True, check=True
    )
    found = json.loads(done.stdout)
    assert found["slab"] == pytest.approx(24.19e6, rel=1e-3)
    assert found["lap"] == pytest.approx(found["slab"], rel=0.01)
    assert found["bar"][0] < 1e3
    assert found["bar"][1] == pytest.approx(285.714e6, rel=1e-5)
    assert found["voids"] == pytest.approx(0.03992, rel=1e-3)


def test_a_target_parts_where_the_releases_meet():
    """Sandia's voids in copper, by elements: the flyer's thickness from the target's back, within 10 %."""
    found = sandia_spall.shot(sandia_spall.VARIANTS[0], 12)
    assert sandia_spall.spall_plane(found) == pytest.approx(sandia_spall.FLYER, rel=0.1)
