"""Where the work of the stress goes."""

import numpy as np
import pytest

from core_models.bulk_viscosity import BulkViscosity
from core_models.driver import drive
from core_models.laws import pressure
from core_models.paths import isochoric_tension, principal_stretches, simple_shear, uniaxial_strain

BULK, SHEAR, DENSITY, CAPACITY = 136.35e9, 45.45e9, 8930.0, 383.0
FULL = [[0, 3, 5], [3, 1, 4], [5, 4, 2]]


def bent_path(steps):
    """Shear, stretch and compression at once, with a change of direction."""
    t = np.linspace(0.0, 1.0, steps + 1)
    stretched = principal_stretches(np.exp(0.1 * np.sin(3.0 * t)), np.exp(-0.05 * t), np.exp(-0.02 * t))
    return simple_shear(0.2 * t**2) @ stretched


def power_integral(history, path):
    """Work P : dF of the first Piola-Kirchhoff stress along the path by the trapezoidal rule."""
    cauchy = history.stress[:, FULL]
    piola = np.linalg.det(path)[:, None, None] * cauchy @ np.linalg.inv(path).transpose(0, 2, 1)
    return np.sum(0.5 * (piola[1:] + piola[:-1]) * np.diff(path, axis=0))


def stored_energy(history, path):
    """G/2 (tr b_e - 3) + K/2 [(J^2 - 1)/2 - ln J] at the end of the path."""
    j = np.linalg.det(path[-1])
    shape = history.fields["elastic_left_cauchy_green"][-1, :3].sum() - 3.0
    return 0.5 * SHEAR * shape + 0.5 * BULK * (0.5 * (j**2 - 1.0) - np.log(j))


def test_elastic_work_is_the_stored_energy(pool):
    """Hyperelastic work along any path is the stored energy at its end, with an error of second order in the step."""
    errors = []
    for steps in (50, 100, 200):
        path = bent_path(steps)
        history = drive(pool["hyper-elastic"], path, 1e-6)
        errors.append(abs(history.stress_work[-1] / stored_energy(history, path) - 1.0))
        assert np.all(history.plastic == 0.0)
    assert errors[2] < 1e-4
    assert np.all(np.diff(np.log2(errors)) < -1.9)


def test_a_closed_elastic_cycle_gives_all_work_back(pool):
    """There and back by another way: no stress, no work left in the hyperelastic update."""
    there, back = (
        bent_path(400),
        principal_stretches(*np.linspace(np.ones(3), bent_path(1)[-1].diagonal(), 401).T),
    )
    back[:, 0, 1] = np.linspace(0.0, bent_path(1)[-1][0, 1], 401)
    history = drive(pool["hyper-elastic"], np.vstack([there, back[::-1][1:]]), 1e-6)
    assert np.abs(history.stress[-1]).max() < 1e-12 * SHEAR
    assert abs(history.stress_work[-1]) < 1e-5 * history.stress_work.max()


def test_plastic_work_is_stored_or_dissipated(pool):
    """Hyperelastic work less dissipation is the stored energy, to the square of the elastic strain (1e-4)."""
    path = bent_path(4000)
    history = drive(pool["hyper-linear"], path, 1e-6)
    assert history.plastic[-1] > 10.0 * stored_energy(history, path) / 50.0
    rest = history.stress_work[-1] - history.plastic[-1] - stored_energy(history, path)
    assert abs(rest) < 4e-4 * history.plastic[-1]


@pytest.mark.parametrize(
    "name", ["hypo-elastic", "hypo-linear", "hyper-linear", "hypo-jc-hot", "hyper-mts-hot"]
)
def test_work_is_that_of_the_nodal_forces(pool, name):
    """The ledger's work of the stress is the integral of P : dF, which is what the nodes of a mesh feel."""
    path = bent_path(2000)
    history = drive(pool[name], path, 1e-7)
    assert history.stress_work[-1] == pytest.approx(power_integral(history, path), rel=2e-5)


@pytest.mark.parametrize("name", ["hypo-jc-hot", "hyper-jc-hot", "hyper-mts-hot"])
def test_internal_energy_is_all_work_and_feeds_the_pressure(pool, name):
    """With Mie-Grüneisen the energy is the work of the whole stress, and the pressure belongs to it at each step."""
    path = bent_path(100)
    history = drive(pool[name], path, 1e-7)
    energy = history.fields["internal_energy"]
    assert energy == pytest.approx(history.stress_work, rel=1e-12)
    for f, e, stress in zip(path, energy, history.stress, strict=True):
        expected = pressure(pool[name].eos, np.linalg.det(f), e)[0]
        assert stress[:3].mean() == pytest.approx(expected, rel=1e-10, abs=1e-3)


def test_heat_is_the_heated_fraction_of_the_dissipation(pool):
    """rho_0 c dT = chi sigma_y dep, to round-off, at every step."""
    history = drive(pool["hypo-jc-hot"], bent_path(100), 1e-7)
    heat = DENSITY * CAPACITY * (history.fields["temperature"] - 294.0)
    assert history.plastic[-1] > 1e7
    assert heat == pytest.approx(0.9 * history.plastic, rel=1e-9, abs=1e-3)


def test_dissipation_is_strength_times_plastic_strain(pool):
    """With linear hardening the dissipation tends to Y ep + H ep^2 / 2 as the steps become small."""
    history = drive(pool["hyper-linear"], isochoric_tension(np.exp(np.linspace(0.0, 0.5, 2001))), 1e-6)
    strain = history.fields["equivalent_plastic_strain"]
    assert history.plastic == pytest.approx(400e6 * strain + 50e6 * strain**2, rel=1e-4, abs=1.0)


@pytest.mark.usefixtures("interpreted")
def test_viscous_work_is_energy_not_heat(pool):
    """Bulk viscosity acts in compression only; its work enters the internal energy, not the temperature."""
    stretch = np.concatenate([np.linspace(1.0, 0.95, 51), np.linspace(0.95, 1.0, 51)[1:]])
    viscosity, length = BulkViscosity(), 1e-4
    history = drive(pool["hypo-jc-hot"], uniaxial_strain(stretch), 1e-9, viscosity=viscosity, length=length)
    assert np.all(np.diff(history.viscous)[:50] > 0.0)
    assert np.all(np.diff(history.viscous)[50:] == 0.0)
    assert np.all(history.fields["viscous_pressure"][51:] == 0.0)
    total = history.stress_work + history.viscous
    assert history.fields["internal_energy"] == pytest.approx(total, rel=1e-12)
    heat = DENSITY * CAPACITY * (history.fields["temperature"] - 294.0)
    assert heat == pytest.approx(0.9 * history.plastic, rel=1e-9, abs=1e-3)


@pytest.mark.usefixtures("interpreted")
def test_viscous_pressure_has_the_stated_size(pool):
    """q = rho h |tr d| (0.06 c + 1.44 h |tr d|), with the wave speed of the point."""
    ratio, dt, length = 0.999, 1e-8, 1e-3
    history = drive(
        pool["hypo-jc-hot"], uniaxial_strain([1.0, ratio]), dt, viscosity=BulkViscosity(), length=length
    )
    speed = length * 2.0 * (1.0 - ratio) / (dt * (1.0 + ratio))
    expected = DENSITY / ratio * speed * (0.06 * history.wave_speed[1] + 1.44 * speed)
    assert history.fields["viscous_pressure"][1] == pytest.approx(expected, rel=2e-3)
    assert history.viscous[1] == pytest.approx(
        history.fields["viscous_pressure"][1] * (1.0 - ratio), rel=1e-12
    )
