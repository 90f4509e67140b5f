"""Whatever a point goes through: its stress is a number, on or inside the yield surface, objective; work is dissipated.

Hypothesis draws parameters, paths, steps, temperatures and rates over a fixed pool of materials. The suite takes draws
over materials that other tests compile as well, and a few over the whole pool in plain Python; the long run compiles
the whole pool:

    MATPOINT_FUZZ_DRAWS=100000 python -m pytest tests/core_models/test_fuzz.py
"""

import os
from dataclasses import replace
from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from core_models.errors import MaterialError
from core_models.laws import elastic_moduli, flow_stress
from core_models.paths import rotations
from core_models.points import MaterialPoints, PointFailure
from core_models.state import PointState
from core_models.status import BEYOND_EOS
from core_models.updates.conditions import flow_before, shear_before
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.prediction import has_no_strength
from core_models.yield_condition.gurson import Gurson
from core_models.yield_condition.gurson_flow import CLOSED
from tests.core_models.fuzz_pool import LARGEST_POOL, covering_pool, general_materials
from tests.core_models.yield_excess import excess, mises

DRAWS = int(os.environ.get("MATPOINT_FUZZ_DRAWS", "2000"))
PLAIN_DRAWS = 400
IS_LONG = "MATPOINT_FUZZ_DRAWS" in os.environ
FEW = ("hypo-jc-hot", "hyper-jc-hot", "hyper-mts-hot", "hypo-linear", "hyper-voce", "hypo-power")
SHARES = (1.0, 0.5, 0.0)  # of the displacement gradient of the first point that the others get
VARIED = ("flow", "yield_condition", "kinematic_hardening", "damage")


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


@pytest.fixture(scope="module")
def whole_pool():
    """All materials of the long run."""
    return covering_pool()


@pytest.fixture(scope="module")
def materials(pool, whole_pool):
    """The pool of the run."""
    return whole_pool if IS_LONG else [*(pool[name] for name in FEW), *general_materials()]


def varied(material, random):
    """The material with numbers of its laws that are up to twice or half; MaterialError where they make none."""
    laws = {}
    for slot in VARIED:
        law = getattr(material, slot)
        if law is not None:
            numbers = {
                name: value * 2.0 ** random.uniform(-1.0, 1.0)
                for name, value in law._asdict().items()
                if isinstance(value, float)
            }
            laws[slot] = law._replace(**numbers)
    return replace(material, **laws)


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
    material, new = points.material, points.new
    j1 = np.linalg.det(points.deformation_gradient[0])
    stress = new.stress[0] * (j1 if isinstance(material.update, HyperelasticPlastic) else 1.0)
    bulk, shear = elastic_moduli(material.elasticity)
    slack = 1e-9 * 3.0 * shear * size + 1e-12 * (bulk + shear)
    if has_no_strength(material.model, before, j0):
        assert mises(stress) <= slack
        return
    if new.back_stress is not None:
        stress = stress - new.back_stress[0].reshape(-1, 6).sum(axis=0)
    strain = new.equivalent_plastic_strain[0]
    grown = strain - before.equivalent_plastic_strain
    # Voids that were closed before an elastic step stay closed; those that a step closes still let the matrix flow.
    porosity = 0.0 if new.porosity is None else new.porosity[0]
    if grown == 0.0 and porosity <= CLOSED:
        porosity = 0.0
    variable = 0.0 if new.hardening_variable is None else new.hardening_variable[0]
    flow = flow_before(material.model, before, j0)
    # The rate is known no better than the difference of the two strains.
    doubt = 4e-16 * strain
    low, high = (
        flow_stress(flow, variable, strain, max(grown + change, 0.0) / dt, before.temperature)[0]
        for change in (-doubt, doubt)
    )
    assert grown >= 0.0
    if high <= slack and isinstance(material.yield_condition, Gurson):
        assert mises(stress) <= 2.0 * slack
        return
    allowed = 1e-8 * (high + np.abs(stress).max()) + slack
    assert excess(material.yield_condition, stress, high, porosity) <= allowed
    if grown > 1e-12:
        assert excess(material.yield_condition, stress, low, porosity) >= -allowed


def round_off(points, before, j0, size):
    """What is left of an elastic energy, and of the work of a mean stress, where stresses are differences, and of work,
    where strains are those of a deformation gradient near 1 [J].

    The energy is that of the shear modulus which the point has in the step: where it melts under stress, a large one.
    """
    bulk, shear = elastic_moduli(points.material.elasticity)
    shear = min(shear, shear_before(points.material.model, before, j0))
    stress = max(np.abs(state.stress).max() for state in (points.old, points.new))
    if points.new.plastic_volume is not None:
        size = max(size, np.abs(points.new.plastic_volume - points.old.plastic_volume).max())
    return points.n * (1e-14 * stress * stress / shear + 1e-15 * (bulk * size + stress))


def assert_objective(points, work, turn, dt):
    """A rotation after the step turns the stress and changes nothing else; leaves the step as it was."""
    f1, stress, strain = points.deformation_gradient[0].copy(), points.new.stress[0].copy(), work.stress
    points.deformation_gradient[0] = turn @ f1
    turned = points.advance(dt)
    tensor = turn @ stress[[[0, 3, 5], [3, 1, 4], [5, 4, 2]]] @ turn.T
    scale = 1e-9 * (np.abs(stress).max() + elastic_moduli(points.material.elasticity)[0])
    assert np.abs(points.new.stress[0] - tensor[[0, 1, 2, 0, 1, 2], [0, 1, 2, 1, 2, 0]]).max() <= scale
    assert turned.stress == pytest.approx(strain, rel=1e-7, abs=scale)
    points.deformation_gradient[0] = f1
    points.advance(dt)


def lead(points, steps, random):
    """Lead the first of some points through the steps and check each; a step beyond the equation of state ends it.

    The others follow it half way and not at all.
    """
    for step in steps:
        direction = random.normal(size=(3, 3))
        gradient = step.size * direction / np.linalg.norm(direction)
        turn = rotations(random.normal(size=3), random.uniform(-3.0, 3.0, 1))[0]
        f0, before = points.old_deformation_gradient[0].copy(), state(points)
        for point, share in enumerate(SHARES[: points.n]):
            points.deformation_gradient[point] = (
                np.eye(3) + share * gradient
            ) @ points.old_deformation_gradient[point]
        dt = max(step.size, 1e-9) / 10.0**step.rate
        try:
            work = points.advance(dt)
            assert work.plastic >= -round_off(points, before, np.linalg.det(f0), step.size)
            assert_on_or_inside(points, before, np.linalg.det(f0), dt, step.size)
            if points.material.objective_rate is None:
                assert_objective(points, work, turn, dt)
        except PointFailure as reason:
            assert reason.status == BEYOND_EOS
            return
        points.accept()
        for array in points.old:
            assert array is None or np.isfinite(array).all()
        if points.old.porosity is not None:
            assert points.old.porosity.min() >= 0.0 and points.old.damage.max() <= 1.0
        if points.material.stability is not None:
            assert np.isfinite(points.stability()).all()


DRAW = st.builds(
    Draw,
    st.integers(0, LARGEST_POOL - 1),
    st.floats(1.0, 4000.0),
    st.lists(st.builds(Step, st.floats(0.0, 0.5), st.floats(-8.0, 8.0)), min_size=1, max_size=3),
    st.integers(0, 2**32 - 1),
)
common = settings(deadline=None, database=None, suppress_health_check=list(HealthCheck), print_blob=True)


def try_draw(materials, draw):
    """Make the material of a draw and lead it."""
    random = np.random.default_rng(draw.seed)
    try:
        material = varied(materials[draw.material % len(materials)], random)
    except MaterialError:
        return
    count = 1 if material.damage_radius is None else len(SHARES)
    points = MaterialPoints(material, np.ones(count), temperature=draw.temperature)
    points.connect(np.arange(float(count))[:, None])
    lead(points, draw.steps, random)


@settings(common, max_examples=DRAWS)
@given(draw=DRAW)
def test_no_draw_breaks_a_point(materials, draw):
    """Finite, on or inside the yield surface to 1e-8, dissipation not negative, objective; typed errors only."""
    try_draw(materials, draw)


@pytest.mark.skipif(IS_LONG, reason="the long run takes the whole pool, compiled")
@pytest.mark.usefixtures("interpreted")
@settings(common, max_examples=PLAIN_DRAWS)
@given(draw=DRAW)
@example(draw=Draw(1, 1.0, [Step(0.15625, 0.0), Step(0.0, 0.0)], 1)).via("a viscous apex, held for a moment")
@example(draw=Draw(8, 4000.0, [Step(1.3488880585675103e-09, 6.744426922311945)], 312023609)).via(
    "no cohesion"
)
@example(
    draw=Draw(8, 1783.3455317479556, [Step(0.0011, -3.3), Step(0.4756, 0.0), Step(1e-12, 0.0)], 3868577674)
).via("no cohesion: the order of what is left of the shear stress")
@example(draw=Draw(11, 434.0, [Step(0.25, 0.0), Step(0.25, 0.0), Step(2.0**-24, 0.0)], 4370704)).via(
    "no shear left"
)
@example(draw=Draw(6, 1.0, [Step(1.0928379256712217e-163, 0.0)], 0)).via("squares of stresses that underflow")
@example(draw=Draw(28, 3373.0, [Step(0.25, -2.0), Step(0.0, 0.0)], 196)).via("melts under stress")
@example(
    draw=Draw(36, 2.0, [Step(0.001, 1.0), Step(0.2676906165506852, 8.0), Step(0.0584, -3.6)], 1872952006)
).via("a mean stress at the spall cut-off says nothing of the volume")
def test_no_draw_breaks_a_point_of_the_whole_pool(whole_pool, draw):
    """The same for every law, in plain Python."""
    try_draw(whole_pool, draw)
