"""The return to the yield surface over wild paths: strains up to 50 % a step, any temperature, any rate."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core_models.driver import drive
from core_models.errors import RunFailure
from core_models.flow.voce import Voce
from core_models.laws import flow_stress
from core_models.paths import isochoric_tension, simple_shear

NAMES = [
    "hypo-linear",
    "hyper-linear",
    "hypo-power",
    "hyper-voce",
    "hypo-jc-hot",
    "hyper-jc-hot",
    "hyper-mts-hot",
]


def equivalent(stress):
    """Von Mises stresses of (k, 6)."""
    mean = stress[:, :3].mean(axis=1, keepdims=True)
    return np.sqrt(1.5 * ((stress[:, :3] - mean) ** 2).sum(axis=1) + 3.0 * (stress[:, 3:] ** 2).sum(axis=1))


def random_path(seed, steps, size):
    """Random increments of velocity gradient times time, largest component `size`."""
    random = np.random.default_rng(seed)
    path = [np.eye(3)]
    for _ in range(steps):
        path.append((np.eye(3) + random.uniform(-size, size, (3, 3))) @ path[-1])
    return np.array(path)


def strengths(material, history, row, dt):
    """Flow stress at the end of a step, at the rates between which round-off in the strain leaves the rate."""
    strain = history.fields["equivalent_plastic_strain"]
    zeros = np.zeros(len(strain))
    variable = history.fields.get("hardening_variable", zeros)[row]
    temperature = history.fields.get("temperature", zeros)[row - 1]
    increment, round_off = strain[row] - strain[row - 1], 4e-16 * strain[row]
    return [
        flow_stress(
            material.flow, variable, strain[row], max(increment + sign * round_off, 0.0) / dt, temperature
        )[0]
        for sign in (-1.0, 1.0)
    ]


def slack(material, history, row):
    """What the tolerance of the return, relative to the trial stress, allows on top of 1e-9 of the strength [Pa]."""
    increment = np.diff(history.fields["equivalent_plastic_strain"])[row - 1]
    return 1e-2 + material.update.tolerance * 6.0 * 45.45e9 * increment


def assert_admissible(material, history, path, dt, precision=1e-9):
    """Every state on or inside the yield surface; dissipation, strain and damage never fall."""
    fields = history.fields
    measure = equivalent(history.stress)
    if "elastic_left_cauchy_green" in fields:
        measure = measure * np.linalg.det(path)
        b = fields["elastic_left_cauchy_green"][:, [[0, 3, 5], [3, 1, 4], [5, 4, 2]]]
        assert np.linalg.det(b) == pytest.approx(1.0, abs=1e-12)
    assert np.all(np.diff(history.plastic) >= 0.0)
    for name in ("equivalent_plastic_strain", "damage"):
        assert np.all(np.diff(fields.get(name, [0.0])) >= 0.0)
    assert all(np.all(np.isfinite(array)) for array in fields.values())
    for row in range(1, len(path)):
        if material.melting is not None and fields["temperature"][row - 1] >= 1356.0:
            assert measure[row] <= 1e-15 * abs(history.stress[row, 0])
            continue
        low, high = strengths(material, history, row, dt)
        assert measure[row] <= high * (1.0 + precision) + slack(material, history, row)
        if fields["equivalent_plastic_strain"][row] > fields["equivalent_plastic_strain"][row - 1]:
            assert measure[row] >= low * (1.0 - precision) - slack(material, history, row)


@pytest.mark.parametrize("name", NAMES)
@settings(max_examples=40, deadline=None)
@given(
    seed=st.integers(0, 2**32 - 1),
    size=st.floats(-6.0, np.log10(0.5)).map(lambda power: 10.0**power),
    rate=st.floats(-8.0, 8.0).map(lambda power: 10.0**power),
    temperature=st.floats(1.0, 1500.0),
)
def test_states_are_admissible(pool, name, seed, size, rate, temperature):
    """Admissible states, dissipation that never falls, det b_e = 1; a path too wild ends in a RunFailure."""
    path, dt = random_path(seed, 8, size), size / rate
    try:
        history = drive(pool[name], path, dt, temperature=temperature)
    except RunFailure:
        assert size > 0.05
        return
    assert_admissible(pool[name], history, path, dt)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("rate", [0.3, 0.99, 1.0, 1.01, 3.0, 1e7])
def test_the_kinks_of_the_laws_do_not_spoil_the_return(pool, name, rate):
    """Steps around the reference rates, where slopes jump, end on the surface as well, to 1e-6."""
    for size in (1e-7, 1e-5, 1e-3):
        strain = np.concatenate([np.linspace(0.0, 0.02, 5), 0.02 + size * np.arange(1, 9)])
        path, dt = simple_shear(np.sqrt(3.0) * strain), size / rate
        assert_admissible(pool[name], drive(pool[name], path, dt), path, dt, precision=1e-6)


@pytest.mark.parametrize("law", [Voce(400e6, 150e6, 40.0, 0.0), Voce(400e6, 100e6, 300.0, 50e6)])
@pytest.mark.parametrize("size", [1e-4, 1e-2, 0.3])
def test_softening_laws_return_to_the_surface(copper, law, size):
    """A strength that falls with plastic strain is followed, in small steps and in large ones."""
    material = copper("hyper", law)
    path = isochoric_tension(np.exp(size * np.arange(20)))
    assert_admissible(material, drive(material, path, 1e-6), path, 1e-6)


@pytest.mark.parametrize("tolerance", [1e-3, 1e-6, 1e-12])
def test_the_tolerance_of_the_card_is_honoured(pool, tolerance):
    """The stress strays from the flow stress by no more than the tolerance asked for."""
    update = pool["hypo-jc-hot"].update._replace(tolerance=tolerance)
    material = replace(pool["hypo-jc-hot"], update=update)
    path, dt = random_path(5, 50, 0.02), 1e-6
    history = drive(material, path, dt)
    measure = equivalent(history.stress)
    for row in range(1, len(path)):
        strength = strengths(material, history, row, dt)[1]
        assert measure[row] <= strength * (1.0 + tolerance) + slack(material, history, row)
