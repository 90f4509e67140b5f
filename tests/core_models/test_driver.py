"""The bare driver and its paths."""

import numpy as np
import pytest

from core_models.bulk_viscosity import BulkViscosity
from core_models.driver import drive
from core_models.errors import RunFailure, SceneError
from core_models.paths import (
    isochoric_tension,
    principal_stretches,
    rotations,
    simple_shear,
    turned,
    uniaxial_strain,
)
from core_models.points import MaterialPoints


def test_history_has_a_row_for_every_deformation(pool):
    """All fields of the points by name, totals and wave speed, row by row; row 0 is the undeformed point."""
    path = simple_shear(np.linspace(0.0, 0.1, 6))
    history = drive(pool["hyper-mts-hot"], path, [1e-6, 2e-6, 3e-6, 4e-6, 5e-6], temperature=400.0)
    points = MaterialPoints(pool["hyper-mts-hot"], np.ones(1))
    assert {name: array.shape[1:] for name, array in history.fields.items()} == {
        field.name: field.shape for field in points.fields().values()
    }
    assert history.times == pytest.approx([0.0, 1e-6, 3e-6, 6e-6, 10e-6, 15e-6])
    assert np.array_equal(history.fields["deformation_gradient"], path)
    assert np.all(history.stress[0] == 0.0)
    assert history.fields["temperature"][0] == 400.0
    assert history.stress_work[0] == history.plastic[0] == history.viscous[0] == 0.0
    assert history.wave_speed[0] == points.wave_speed[0]
    assert len(history.stress) == len(history.plastic) == len(history.wave_speed) == 6


@pytest.mark.parametrize("name", ["hypo-jc-hot", "hyper-mts-hot"])
def test_driver_and_many_points_agree_bitwise(pool, name):
    """A point among a thousand others goes through exactly the states that the driver finds."""
    path = turned(
        isochoric_tension(np.exp(np.linspace(0.0, 0.3, 13))), rotations([1.0, 1.0, 0.0], np.arange(13) * 0.1)
    )
    history = drive(pool[name], path, 1e-7)
    points = MaterialPoints(pool[name], np.ones(1000))
    for f in path[1:]:
        points.deformation_gradient[:] = np.eye(3)
        points.deformation_gradient[777] = f
        points.advance(1e-7)
        points.accept()
    for field in points.fields().values():
        assert np.array_equal(field.array[777], history.fields[field.name][-1]), field.name


def test_wave_speed_is_that_of_compressed_metal(pool):
    """At rest sqrt((K + 4/3 G) / rho), faster under compression."""
    history = drive(pool["hypo-jc-hot"], uniaxial_strain([1.0, 0.95, 0.9]), 1e-6)
    rest = np.sqrt(3940.0**2 + 4.0 / 3.0 * 45.45e9 / 8930.0)
    assert history.wave_speed[0] == pytest.approx(rest, rel=1e-12)
    assert np.all(np.diff(history.wave_speed) > 100.0)


@pytest.mark.usefixtures("interpreted")
def test_viscosity_needs_its_length(pool):
    """The viscous pressure grows with the characteristic length."""
    path = uniaxial_strain([1.0, 0.99])
    pressures = [
        drive(pool["hypo-jc-hot"], path, 1e-7, viscosity=BulkViscosity(), length=length).fields[
            "viscous_pressure"
        ][1]
        for length in (0.0, 1e-4, 2e-4)
    ]
    assert pressures[0] == 0.0
    assert pressures[2] > 2.0 * pressures[1] > 0.0


def test_a_step_that_cannot_be_taken_names_step_time_and_law(pool):
    """A point turned inside out ends in a RunFailure with the step, the time, the reason, the laws and a remedy."""
    path = principal_stretches([1.0, 0.9, -0.5], [1.0] * 3, [1.0] * 3)
    with pytest.raises(RunFailure) as failure:
        drive(pool["hypo-jc-hot"], path, [1e-6, 2e-6])
    message = str(failure.value)
    for part in (
        "step 2",
        "t = 3.000000e-06 s",
        "inverted",
        "JohnsonCook",
        "HypoelasticPlastic",
        "smaller steps",
    ):
        assert part in message
    assert "\n" not in message


def test_a_deformation_that_is_no_number_is_refused(pool):
    """Not-a-number in the path ends the run at its step; it never reaches the state."""
    path = simple_shear([0.0, 0.01, np.nan])
    with pytest.raises(RunFailure, match="step 2"):
        drive(pool["hyper-linear"], path, 1e-6)


@pytest.mark.parametrize(
    ("path", "steps", "remedy"),
    [
        (simple_shear([0.1, 0.2]), 1e-6, "starts with the identity"),
        (np.eye(3), 1e-6, r"array \(k, 3, 3\)"),
        (np.zeros((0, 3, 3)), 1e-6, "starts with the identity"),
        (simple_shear([0.0, 0.1]), [1e-6, 1e-6], "needs 1 time steps"),
        (simple_shear([0.0, 0.1]), 0.0, "must be positive"),
        (simple_shear([0.0, 0.1]), float("nan"), "must be positive"),
    ],
)
def test_paths_that_make_no_sense_are_refused(pool, path, steps, remedy):
    """Wrong shapes, a start elsewhere and steps that take no time are refused before anything is computed."""
    with pytest.raises(SceneError, match=remedy):
        drive(pool["hyper-linear"], path, steps)


def test_paths_are_what_they_say():
    """Shear and isochoric tension keep the volume, uniaxial strain the cross-section, rotations all lengths."""
    assert np.linalg.det(simple_shear([0.0, 2.0])) == pytest.approx(1.0)
    assert np.linalg.det(isochoric_tension([1.0, 1.7])) == pytest.approx(1.0)
    assert uniaxial_strain([1.0, 1.2])[1] == pytest.approx(np.diag([1.2, 1.0, 1.0]))
    q = rotations([0.0, 0.0, 2.0], [np.pi / 2])[0]
    assert q @ [1.0, 0.0, 0.0] == pytest.approx([0.0, 1.0, 0.0])
    assert turned(np.eye(3)[None], q[None])[0] == pytest.approx(q)
