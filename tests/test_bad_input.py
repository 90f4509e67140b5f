"""Input that cannot be, refused by both methods in the same words."""

import numpy as np
import pytest

from core_models.agreement import Agreement
from core_models.bulk_viscosity import BulkViscosity
from core_models.conduction import held_temperature
from core_models.errors import MatpointError, SceneError
from core_models.geometry import PlaneStrain
from core_models.load_checks import damping_rate
from core_models.loads import (
    BodyForce,
    Damping,
    Fixed,
    FixedTemperature,
    Prescribed,
    Pressure,
    Symmetry,
    Traction,
)
from core_models.redo import step_within
from meshes.block import block
from tests.conftest import CELL

METHODS = ("fem-explicit", "mpm")
SIZE = 4.0 * CELL


@pytest.fixture
def refused(build, elastic):
    """Assert that both methods refuse options for a block in plane strain, with an error of one line like a pattern."""

    def check(pattern, lower=(0.0, 0.0), **options):
        options = {"geometry": "plane-strain", "wall": None} | options
        mesh = options.pop("mesh", None) or block(lower, np.add(lower, SIZE), (4, 4))
        material = options.pop("material", elastic)
        texts = []
        for method in METHODS:
            with pytest.raises(MatpointError, match=pattern) as error:
                build(method, mesh, material, **options)
            texts.append(str(error.value))
        assert "\n" not in texts[0]
        return texts

    return check


@pytest.mark.parametrize(
    ("load", "pattern"),
    [
        (BodyForce(lambda x: x), r"BodyForce: function is a function \(x\), but is called with positions .* and time"),
        (BodyForce((0.0, -9.8)), r"no function of positions and time: use gravity\(vector\)"),
        (BodyForce(lambda x, t: x * np.nan), r"BodyForce: a load gives a number that is not finite at \(0, 0\) m"),
        (Traction("top", lambda x: x), "Traction on 'top': traction is a function"),
        (Traction("top", (0.0, np.nan)), "Traction on 'top': .*not finite"),
        (Traction("top", 1e5), "Traction on 'top': .*a vector of 2 components"),
        (Pressure("top", lambda x, t: 1.0), r"Pressure on 'top': pressure is a function \(x, t\), .*1 argument"),
        (Pressure("top", lambda t: np.inf), "Pressure on 'top': a load gives inf at t = 0 s: give a finite number"),
        (Prescribed("top", 0, np.nan), "Prescribed on 'top': .*not finite"),
        (Prescribed("top", True, 1.0), "component True does not exist in 2 dimensions: give 0 to 1"),
        (Damping(lambda: 1.0), "Damping: rate is a function"),
        (Prescribed("top", 1.0, 1.0), "component 1.0 does not exist in 2 dimensions: give 0 to 1"),
        (Fixed(["top"]), r"Fixed: the mesh has no boundary \['top'\]; .*valid: bottom, left, right, top"),
        (Symmetry(None), "Symmetry: the mesh has no boundary None; valid"),
    ],
)  # fmt: skip
def test_loads_that_cannot_act_are_refused(refused, load, pattern):
    """Functions of other arguments and values that are no finite numbers are refused before anything runs."""
    texts = refused(pattern, loads=(load,))
    assert texts[0] == texts[1]


@pytest.mark.parametrize(
    ("options", "pattern"),
    [
        ({"viscosity": 0.06}, "viscosity = 0.06 is no bulk viscosity: give .*BulkViscosity"),
        ({"viscosity": BulkViscosity(-1.0, 1.2)}, "viscosity: linear = -1.0 is out of range"),
        ({"velocity": "fast"}, "velocity = 'fast' is no velocity: give 2 numbers"),
        ({"velocity": lambda x, t: x}, "velocity is a function .* but is called with positions"),
        ({"velocity": np.inf}, "velocity is not finite at"),
        ({"displacement": 0.1}, "displacement = 0.1 is no function of positions"),
        ({"displacement": lambda x: x * [-2.0, 0.0]}, "initial displacement cannot be"),
        ({"displacement": lambda x: 0.0 * x - [0.0, CELL], "wall": "plane"},
         "from y = -0.0004 to 0.0012 m, and the wall is at y = 0"),
        ({"displacement": lambda x: 0.0 * x + [CELL, 0.0], "loads": (Symmetry("left"),)},
         r"moves node 0 \(0, 0\) m of 'left' by 0.0004 m along x, but a plane of symmetry stays where it is"),
        ({"displacement": lambda x: 0.0 * x + [CELL, 0.0], "geometry": "axisymmetric"},
         r"moves node 0 \(0, 0\) m of 'the axis' by 0.0004 m along r"),
        ({"displacement": lambda x: 0.0 * x - [2.0 * CELL, 0.0], "geometry": "axisymmetric", "lower": (CELL, 0.0)},
         "puts node 0 at r = -0.0004 m: give one that leaves the body at r >= 0"),
        ({"material": None}, "material = None is no material"),
        ({"mesh": "bar.msh"}, "mesh = 'bar.msh' is no mesh"),
        ({"wall": "unilateral", "lower": (0.0, -CELL)}, "from y = -0.0004 to 0.0012 m.*move the body up by 0.0004 m"),
        ({"loads": (Symmetry("left"), Prescribed("left", 0, 1.0)), "geometry": "axisymmetric", "lower": (CELL, 0.0)},
         "motion along r is held at 0 m/s"),
    ],
)  # fmt: skip
def test_bodies_that_cannot_be_are_refused(refused, options, pattern):
    """What is no mesh, material, viscosity, velocity or displacement, and bodies in the wall, are refused."""
    refused(pattern, **options)


def test_supports_that_contradict_each_other_later_are_refused_then(build, elastic):
    """Functions of time that agree at the start are watched; equal ones may hold the same nodes."""
    loads = (Fixed("left"), Prescribed("bottom", 0, lambda x, t: 1e3 * t))
    mesh = block((0.0, 0.0), (SIZE, SIZE), (4, 4))
    for method in METHODS:
        solver = build(method, mesh, elastic, geometry="plane-strain", wall=None, loads=loads)
        with pytest.raises(
            SceneError, match=r"node 0 \(0, 0\) m: motion along x is held at .* m/s by 'bottom'.* at t ="
        ):
            solver.advance()
    same = (Prescribed("left", 0, lambda x, t: 3.0 * t), Prescribed("bottom", 0, lambda x, t: t + 2.0 * t))
    Agreement(same, mesh, PlaneStrain()).check(0.7)


def test_values_that_become_impossible_later_are_refused_then():
    """A damping below 0 and a temperature that is not above 0 K, of functions that are fine at the start."""

    def later(time):
        return 1.0 if time == 0.0 else -1.0

    assert damping_rate(Damping(later), 0.0) == 1.0
    with pytest.raises(SceneError, match="rate = -1 1/s at t = 0.5 s is out of range"):
        damping_rate(Damping(later), 0.5)
    with pytest.raises(SceneError, match="FixedTemperature on 'top' at t = 0.5 s = -1.0 K is out of range"):
        held_temperature(FixedTemperature("top", later), 0.5)


@pytest.mark.parametrize("remaining", [np.nan, 0.0, -1.0])
def test_a_limit_that_is_not_later_is_refused(remaining):
    """`advance(limit)` needs a time after the present one."""
    with pytest.raises(SceneError, match="limit is .* s after the present time: give a later one"):
        step_within(1.0, remaining)
