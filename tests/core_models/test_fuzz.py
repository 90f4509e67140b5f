"""Whatever a point goes through: its stress is a number, on or inside the yield surface, objective; work is dissipated.

Hypothesis draws parameters, paths, steps, temperatures and rates over a fixed pool of compiled materials. The suite
takes few draws over materials that other tests compile as well; the long run is

    MATPOINT_FUZZ_DRAWS=100000 python -m pytest tests/core_models/test_fuzz.py
"""

import os
from dataclasses import replace
from itertools import combinations
from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from core_models.compatibility import clash_of
from core_models.errors import MaterialError
from core_models.laws import flow_stress
from core_models.material import Material
from core_models.paths import rotations
from core_models.points import MaterialPoints, PointFailure
from core_models.state import PointState
from core_models.status import BEYOND_EOS
from core_models.updates.conditions import flow_before
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.prediction import has_no_strength
from studies.sample_laws import DENSITY, SAMPLES

DRAWS = int(os.environ.get("MATPOINT_FUZZ_DRAWS", "2000"))
IS_LONG = "MATPOINT_FUZZ_DRAWS" in os.environ
FEW = ("hypo-jc-hot", "hyper-jc-hot", "hyper-mts-hot", "hypo-linear", "hyper-voce", "hypo-power")
LARGEST_POOL = 40
AXES = {
    "update": SAMPLES["update"][:2],
    "eos": SAMPLES["eos"],
    "flow": SAMPLES["flow"],
    "shear_modulus": [None, *SAMPLES["shear_modulus"]],
    "damage": [None, *SAMPLES["damage"]],
    "melting": [None, *SAMPLES["melting"]],
    "heating": [None, SAMPLES["heating"][0]],
    "specific_heat": SAMPLES["specific_heat"],
    "erosion": [None, *SAMPLES["erosion"]],
    "objective_rate": [None, *SAMPLES["objective_rate"]],
}


class Step(NamedTuple):
    """A step: size of the displacement gradient [-] and log10 of the rate [1/s]."""

    size: float
    rate: float


class Draw(NamedTuple):
    """A material of the pool, temperature [K], steps; a seed for the flow law's numbers, directions and rotations."""

    material: int
    temperature: float
    steps: list
    seed: int


def is_possible(laws):
    """Whether the table lets these laws together."""
    pairs = combinations(laws.items(), 2)
    return all(clash_of(slot, type(a), other, type(b)) is None for (slot, a), (other, b) in pairs)


def covering_pool():
    """At most 40 materials, each of which adds as many new pairs of laws as 60 random ones offer."""
    random = np.random.default_rng(0)
    seen, pool = set(), []
    while len(pool) < LARGEST_POOL:
        best, gain = None, set()
        for _attempt in range(60):
            picks = {slot: int(random.integers(len(laws))) for slot, laws in AXES.items()}
            laws = {slot: AXES[slot][number] for slot, number in picks.items()}
            pairs = set(combinations(picks.items(), 2)) - seen
            if len(pairs) > len(gain) and is_possible(laws):
                best, gain = laws, pairs
        seen |= gain
        rest = {"yield_condition": SAMPLES["yield_condition"][0], "elasticity": SAMPLES["elasticity"][0]}
        pool.append(Material(f"fuzz-{len(pool)}", DENSITY, **best, **rest))
    return pool


@pytest.fixture(scope="module")
def materials(pool):
    """The pool of the run."""
    return covering_pool() if IS_LONG else [pool[name] for name in FEW]


def varied(material, random):
    """The material with numbers of its flow law that are up to twice or half; MaterialError where they make none."""
    numbers = {
        name: value * 2.0 ** random.uniform(-1.0, 1.0)
        for name, value in material.flow._asdict().items()
        if isinstance(value, float)
    }
    return replace(material, flow=material.flow._replace(**numbers))


def mises(stress):
    """Equivalent stress [Pa] of six components."""
    normal = stress[:3] - stress[:3].mean()
    return np.sqrt(1.5 * (normal @ normal) + 3.0 * (stress[3:] @ stress[3:]))


def state(points):
    """State before the step, as the kernels see it."""
    absent = {"rotation": (0.0,) * 3, "elastic_left_cauchy_green": (0.0,) * 6}
    values = {}
    for name in PointState._fields:
        array = getattr(points.old, name)
        values[name] = absent.get(name, 0.0) if array is None else array[0].tolist()
    return PointState(**{name: tuple(v) if isinstance(v, list) else v for name, v in values.items()})


def assert_on_or_inside(points, before, j0, dt, size):
    """The new stress does not lie outside the yield surface, and on it where the point has flowed."""
    material = points.material
    j1 = np.linalg.det(points.deformation_gradient[0])
    measure = j1 if isinstance(material.update, HyperelasticPlastic) else 1.0
    equivalent = measure * mises(points.new.stress[0])
    shear = material.elasticity.shear_modulus
    slack = 1e-9 * 3.0 * shear * size + 1e-12 * shear
    if has_no_strength(material.model, before, j0):
        assert equivalent <= slack
        return
    strain = points.new.equivalent_plastic_strain[0]
    grown = strain - before.equivalent_plastic_strain
    variable = 0.0 if points.new.hardening_variable is None else points.new.hardening_variable[0]
    flow = flow_before(material.model, before, j0)
    # The rate is known no better than the difference of the two strains.
    doubt = 4e-16 * strain
    low, high = (
        flow_stress(flow, variable, strain, max(grown + change, 0.0) / dt, before.temperature)[0]
        for change in (-doubt, doubt)
    )
    assert grown >= 0.0
    assert equivalent <= high * (1.0 + 1e-8) + slack
    if grown > 1e-12:
        assert equivalent >= low * (1.0 - 1e-8) - slack


def assert_objective(points, work, turn, dt):
    """A rotation after the step turns the stress and changes nothing else; leaves the step as it was."""
    f1, stress, strain = points.deformation_gradient[0].copy(), points.new.stress[0].copy(), work.stress
    points.deformation_gradient[0] = turn @ f1
    turned = points.advance(dt)
    tensor = turn @ stress[[[0, 3, 5], [3, 1, 4], [5, 4, 2]]] @ turn.T
    scale = 1e-9 * (np.abs(stress).max() + points.material.elasticity.bulk_modulus)
    assert np.abs(points.new.stress[0] - tensor[[0, 1, 2, 0, 1, 2], [0, 1, 2, 1, 2, 0]]).max() <= scale
    assert turned.stress == pytest.approx(strain, rel=1e-7, abs=scale)
    points.deformation_gradient[0] = f1
    points.advance(dt)


def lead(points, steps, random):
    """Lead a point through the steps and check each; a step beyond the equation of state ends it."""
    for step in steps:
        direction = random.normal(size=(3, 3))
        gradient = step.size * direction / np.linalg.norm(direction)
        turn = rotations(random.normal(size=3), random.uniform(-3.0, 3.0, 1))[0]
        f0, before = points.old_deformation_gradient[0].copy(), state(points)
        points.deformation_gradient[0] = (np.eye(3) + gradient) @ f0
        dt = max(step.size, 1e-9) / 10.0**step.rate
        try:
            work = points.advance(dt)
            assert work.plastic >= 0.0
            assert_on_or_inside(points, before, np.linalg.det(f0), dt, step.size)
            if points.material.objective_rate is None:
                assert_objective(points, work, turn, dt)
        except PointFailure as reason:
            assert reason.status == BEYOND_EOS
            return
        for array in points.new:
            assert array is None or np.isfinite(array).all()
        points.accept()


@settings(
    max_examples=DRAWS, deadline=None, database=None, suppress_health_check=list(HealthCheck), print_blob=True
)
@given(
    draw=st.builds(
        Draw,
        st.integers(0, LARGEST_POOL - 1),
        st.floats(1.0, 4000.0),
        st.lists(st.builds(Step, st.floats(0.0, 0.5), st.floats(-8.0, 8.0)), min_size=1, max_size=3),
        st.integers(0, 2**32 - 1),
    )
)
def test_no_draw_breaks_a_point(materials, draw):
    """Finite, on or inside the yield surface to 1e-8, dissipation not negative, objective; typed errors only."""
    random = np.random.default_rng(draw.seed)
    try:
        material = varied(materials[draw.material % len(materials)], random)
    except MaterialError:
        return
    lead(MaterialPoints(material, np.ones(1), temperature=draw.temperature), draw.steps, random)
