"""Loading programs: stresses and deformations prescribed together, against closed forms and against themselves."""

from itertools import pairwise

import numpy as np
import pytest

from core_models import loading_step
from core_models.driver import drive, drive_program, isothermal
from core_models.errors import RunFailure
from core_models.flow.linear import LinearHardening
from core_models.laws import flow_stress, pressure
from core_models.loading import Deformation, Stress, Stretch, VelocityGradient
from core_models.loading_paths import (
    biaxial,
    cyclic,
    plane_strain,
    simple_shear,
    uniaxial_strain,
    uniaxial_stress,
    volumetric,
)
from core_models.loading_program import COMPONENTS, FREE, Program, Segment
from core_models.matrix_logarithm import matrix_logarithm
from core_models.paths import rotations

BULK, SHEAR = 136.35e9, 45.45e9
YOUNG = 9.0 * BULK * SHEAR / (3.0 * BULK + SHEAR)
POISSON = 0.35
STRENGTH, MODULUS = 400e6, 100e6
FULL = [[0, 3, 5], [3, 1, 4], [5, 4, 2]]
PLASTIC = ["hypo-linear", "hyper-linear", "hypo-power", "hyper-voce", "hypo-jc-hot", "hyper-mts-hot"]


def measured(name, control, before, after, stress, dt):
    """What a step has of a control's quantity, worked out here once more; and what it is measured by."""
    i, j = int(name[0]) - 1, int(name[1]) - 1
    match control:
        case Deformation():
            return after[i, j]
        case Stretch():
            return np.linalg.norm(after[:, i])
        case VelocityGradient():
            middle = np.linalg.inv(0.5 * (before + after))
            return ((after - before) @ middle)[i, j] / dt
        case Stress():
            return stress[FULL[i][j]]


@pytest.mark.parametrize("name", ["hypo-elastic", "hyper-elastic", *PLASTIC])
@pytest.mark.parametrize("strain", [1e-6, -1e-6])
def test_small_uniaxial_stress_shows_the_elastic_constants(pool, name, strain):
    """Below yield s11 = E e and the sides move by -nu e; nothing else is stressed."""
    bulk = pressure(pool[name].eos, 1.0, 0.0)[1]
    young, poisson = 9 * bulk * SHEAR / (3 * bulk + SHEAR), (1.5 * bulk - SHEAR) / (3 * bulk + SHEAR)
    history = drive_program(pool[name], uniaxial_stress(strain, 1.0, steps=4))
    assert history.stress[-1, 0] == pytest.approx(young * strain, rel=5e-6)
    assert history.deformation_gradient[-1].diagonal() - 1.0 == pytest.approx(
        [strain, -poisson * strain, -poisson * strain], rel=5e-6
    )
    assert np.abs(history.stress[:, 1:]).max() <= 1e-8 * abs(history.stress[-1, 0])


@pytest.mark.parametrize("strain", [0.3, -0.3])
def test_hypoelastic_uniaxial_stress_is_linear_in_true_strain(pool, strain):
    """Elastic up to Y/E, then s = (Y + H e) / (1 + H/E), to 1e-6; the plastic strain is what is not elastic."""
    history = drive_program(pool["hypo-linear"], uniaxial_stress(strain, 1e3, steps=300))
    e = np.linspace(0.0, abs(strain), 301)
    expected = np.minimum(YOUNG * e, (STRENGTH + MODULUS * e) / (1.0 + MODULUS / YOUNG))
    assert np.sign(strain) * history.stress[:, 0] == pytest.approx(expected, rel=1e-6)
    plastic = history.fields["equivalent_plastic_strain"]
    assert plastic == pytest.approx(e - expected / YOUNG, abs=1e-6)
    assert history.mises == pytest.approx(np.abs(history.stress[:, 0]), rel=1e-8)


@pytest.mark.parametrize("strain", [0.3, -0.3])
def test_hyperelastic_uniaxial_stress_hardens_in_kirchhoff_stress(pool, strain):
    """tau = G (a^2 - 1/a) = Y + H ep with the elastic stretch a; J from K/2 (J^2 - 1) = tau / 3.

    The plastic rate that box 9.1 subtracts from b = diag(a^2, 1/a, 1/a) is tr b / 3 times the flow direction, hence
    de = da/a + (a^2 + 2/a) / (2 a^2 + 1/a) dep + dJ/(3J). The update tends to it with the size of the steps.
    """
    coarse, fine = (
        drive_program(pool["hyper-linear"], uniaxial_stress(strain, 1e3, steps=steps)) for steps in (150, 300)
    )
    sign, plastic = np.sign(strain), np.linspace(0.0, 0.31, 20001)
    tau = sign * (STRENGTH + MODULUS * plastic)
    a = 1.0 + tau / (3.0 * SHEAR)
    for _newton in range(5):
        a -= (a**2 - 1.0 / a - tau / SHEAR) / (2.0 * a + 1.0 / a**2)
    share = (a**2 + 2.0 / a) / (2.0 * a**2 + 1.0 / a)
    ratio = np.sqrt(1.0 + 2.0 * tau / (3.0 * BULK))
    passed = np.concatenate([[0.0], np.cumsum(0.5 * (share[1:] + share[:-1]) * np.diff(plastic))])
    reached = sign * (np.log(a) + np.log(ratio) / 3.0) + passed
    for values, expected in (
        ([h.fields["equivalent_plastic_strain"][-1] for h in (coarse, fine)], plastic),
        ([h.stress[-1, 0] for h in (coarse, fine)], tau / ratio),
        ([np.linalg.det(h.deformation_gradient[-1]) for h in (coarse, fine)], ratio),
    ):
        limit = np.interp(0.3, reached, expected)
        assert values[1] == pytest.approx(limit, rel=1e-3)
        assert 2.0 * values[1] - values[0] == pytest.approx(limit, rel=2e-6)


@pytest.mark.parametrize("name", PLASTIC)
@pytest.mark.parametrize("strain", [0.5, -0.5])
@pytest.mark.parametrize("path", [uniaxial_stress, plane_strain, biaxial])
def test_free_faces_are_free(pool, name, strain, path):
    """What is prescribed as zero stress is zero to 1e-8 of the largest stress in every step, in steps of 5 %."""
    history = drive_program(pool[name], path(strain, 1e4, steps=10))
    free = {uniaxial_stress: [1, 2, 3, 4, 5], plane_strain: [1, 3], biaxial: [2, 3, 4, 5]}[path]
    largest = np.abs(history.stress).max(axis=1)
    assert np.all(np.abs(history.stress[:, free]).max(axis=1) <= 1e-8 * largest)
    assert history.fields["equivalent_plastic_strain"][-1] > 0.4


def test_elastic_stiffness_of_plane_strain_and_biaxial_stress(pool):
    """s11 = E e / (1 - nu^2) between rigid ends, E e / (1 - nu) under equal biaxial stretch, K e in all directions."""
    for path, stiffness in (
        (plane_strain, YOUNG / (1.0 - POISSON**2)),
        (biaxial, YOUNG / (1.0 - POISSON)),
        (volumetric, BULK),
    ):
        history = drive_program(pool["hypo-elastic"], path(1e-4, 1.0, steps=3))
        assert history.stress[-1, 0] == pytest.approx(stiffness * 1e-4, rel=1e-8)


@pytest.mark.parametrize("update", ["hypo", "hyper"])
def test_hugoniot_elastic_limit(pool, update):
    """Uniaxial strain yields at Y (K/2G + 2/3) = Y (1 - nu) / (1 - 2 nu), then follows K + 4/3 G H / (3G + H)."""
    strain = -STRENGTH / (2.0 * SHEAR)
    history = drive_program(pool[f"{update}-linear"], uniaxial_strain(2.0 * strain, 1e5, steps=200))
    tolerance = 1e-5 if update == "hypo" else 0.02  # the neo-Hookean stiffens by the size of the strain
    assert history.stress[100, 0] == pytest.approx(
        -STRENGTH * (1 - POISSON) / (1 - 2 * POISSON), rel=tolerance
    )
    plastic = history.fields["equivalent_plastic_strain"]
    assert plastic[98] == 0.0 and plastic[103] > 0.0
    slope = (history.stress[200, 0] - history.stress[110, 0]) / (0.9 * strain)
    expected = BULK + 4.0 * SHEAR / 3.0 * MODULUS / (3.0 * SHEAR + MODULUS)
    assert slope == pytest.approx(expected, rel=tolerance)


def test_simple_shear(pool):
    """Hypoelastic: the Green-Naghdi stresses at gamma = 2; hyperelastic: G gamma, 2/3 and -1/3 of G gamma^2."""
    hypo = drive_program(pool["hypo-elastic"], simple_shear(2.0, 1.0, steps=2000)).stress[-1] / SHEAR
    assert hypo == pytest.approx([1.14159, -1.14159, 0.0, 1.38629, 0.0, 0.0], abs=2e-5)
    hyper = drive_program(pool["hyper-elastic"], simple_shear(2.0, 1.0, steps=10)).stress[-1] / SHEAR
    assert hyper == pytest.approx([8 / 3, -4 / 3, -4 / 3, 2.0, 0.0, 0.0], abs=1e-12)


def test_stress_follows_the_flow_law_through_a_rate_jump(pool):
    """Where the rate goes from 10 to 1e5 /s, the stress goes up as the flow law says, at once."""
    material = pool["hypo-jc-hot"]
    history = drive_program(material, uniaxial_stress(0.2, [10.0, 1e5]))
    strain = history.fields["equivalent_plastic_strain"]
    assert history.times[[50, 100]] == pytest.approx([1e-2, 1e-2 + 1e-6])
    rates = np.diff(strain) / np.diff(history.times)
    for row in (40, 50, 51, 60, 100):
        state = (strain[row], rates[row - 1], history.fields["temperature"][row - 1])
        assert history.mises[row] == pytest.approx(flow_stress(material.flow, 0.0, *state)[0], rel=1e-7)
    jump = history.mises[51] / history.mises[50]
    assert jump == pytest.approx((1 + 0.025 * np.log(1e5)) / (1 + 0.025 * np.log(10)), rel=0.01)


def test_perfectly_plastic_loops_close(copper):
    """From the first cycle on, every cycle comes back to the same stress, and costs Y for its plastic strain."""
    material = copper("hypo", LinearHardening(STRENGTH, 0.0))
    history = drive_program(material, cyclic(0.01, 1.0, steps=50, cycles=3))
    ends = history.stress[50::200]
    assert len(history.times) == 651 and len(ends) == 4
    assert ends[1:] == pytest.approx(np.tile(ends[0], (3, 1)), rel=1e-8, abs=20.0)
    assert history.stress[150::200, 0] == pytest.approx(-STRENGTH, rel=1e-8)
    per_cycle = np.diff(history.fields["equivalent_plastic_strain"][50::200])
    assert per_cycle == pytest.approx(4.0 * (0.01 - STRENGTH / YOUNG), rel=1e-5)
    work = np.diff(history.stress_work[50::200])
    assert work == pytest.approx(
        STRENGTH * per_cycle, rel=3e-4
    )  # the trapezoidal rule cuts the corner of a yield


def test_adiabatic_temperature_is_the_heated_plastic_work(pool):
    """rho_0 c dT = chi J sigma dep in every step; its sum is the integral over the history, to half a step."""
    history = drive_program(pool["hypo-jc-hot"], uniaxial_stress(0.5, 1e4, steps=400))
    strain, stress = history.fields["equivalent_plastic_strain"], history.mises
    rise = np.diff(history.fields["temperature"])
    power = np.linalg.det(history.deformation_gradient)[1:] * stress[1:] * np.diff(strain)
    assert rise == pytest.approx(0.9 / (8930.0 * 383.0) * power, rel=1e-8, abs=1e-9)
    work = np.sum(0.5 * (stress[1:] + stress[:-1]) * np.diff(strain))
    assert rise.sum() == pytest.approx(0.9 / (8930.0 * 383.0) * work, rel=5e-3)
    assert rise.sum() > 30.0


def test_isothermal_material_keeps_its_temperature_and_its_strength(pool):
    """Without heating the temperature stays at its start, and the stress does not soften."""
    hot = drive_program(pool["hyper-jc-hot"], uniaxial_stress(-0.8, 1e4), temperature=350.0)
    cold = drive_program(isothermal(pool["hyper-jc-hot"]), uniaxial_stress(-0.8, 1e4), temperature=350.0)
    assert np.all(cold.fields["temperature"] == 350.0)
    assert cold.mises[-1] > 1.02 * hot.mises[-1]
    assert np.all(np.diff(cold.mises[1:]) > 0.0)


def test_constant_stress_on_an_elastic_point_changes_nothing(pool):
    """No creep: the deformation reached at a stress is that at its end, and unloading undoes it."""
    program = Program([Segment(1e-3, 10, FREE | {"11": Stress(300e6), "12": Stress(50e6)})])
    program = Program(
        [*program.then_hold(1.0, 5).segments, Segment(1e-3, 10, FREE)],
    )
    history = drive_program(pool["hyper-elastic"], program)
    assert history.stress[10:16] == pytest.approx(np.tile([300e6, 0, 0, 50e6, 0, 0], (6, 1)), abs=3.0)
    assert np.all(history.deformation_gradient[10:16] == history.deformation_gradient[10])
    assert history.deformation_gradient[-1] == pytest.approx(np.eye(3), abs=1e-9)


def test_stress_control_and_strain_control_are_the_same_path(pool):
    """A hardening point pulled to a stress has the strain whose stress that is."""
    program = Program([Segment(1e-3, 40, FREE | {"11": Stress(420e6)})])
    history = drive_program(pool["hypo-linear"], program)
    assert history.fields["equivalent_plastic_strain"][-1] == pytest.approx(0.2, rel=1e-8)
    assert np.log(history.deformation_gradient[-1, 0, 0]) == pytest.approx(0.2 + 420e6 / YOUNG, abs=2e-4)


def test_held_strain_relaxes_to_the_strength_without_rate(pool):
    """Held after a fast pull, the stress falls to the flow stress at the lowest rate, with the sides free."""
    material = pool["hypo-jc-hot"]
    history = drive_program(material, uniaxial_stress(0.1, 1e4).then_hold(1e3, 5))
    assert np.all(history.deformation_gradient[100:, 0, 0] == np.exp(0.1))
    final = (history.fields["equivalent_plastic_strain"][-1], 0.0, history.fields["temperature"][-1])
    assert history.mises[-1] == pytest.approx(flow_stress(material.flow, 0.0, *final)[0], rel=1e-4)
    assert history.mises[-1] < 0.85 * history.mises[100]
    assert np.abs(history.stress[101:, 1:]).max() <= 1e-8 * history.mises[-1]


@pytest.mark.parametrize("name", ["hypo-jc-hot", "hyper-mts-hot"])
def test_a_program_is_the_plain_driver_along_its_deformation(pool, name):
    """All states are bit for bit those of `drive` on the deformation that was found."""
    program = plane_strain(0.3, 1e4, steps=20)
    found = drive_program(pool[name], program)
    again = drive(pool[name], found.deformation_gradient, program.time_steps)
    assert np.array_equal(found.times, again.times)
    for field, values in found.fields.items():
        assert np.array_equal(values, again.fields[field]), field
    assert np.array_equal(found.plastic, again.plastic) and np.array_equal(found.wave_speed, again.wave_speed)


def random_program(rng):
    """A deformation, then a second one from where the first has led: any control for any component."""
    segments = []
    for _segment in range(2):
        controls = {}
        for name in COMPONENTS:
            is_normal = name[0] == name[1]
            kinds = [Deformation(is_normal + rng.normal(0.0, 0.05)), VelocityGradient(rng.normal(0.0, 50.0))]
            kinds += [Stretch(float(np.exp(rng.normal(0.0, 0.05))))] if is_normal else []
            kinds += (
                []
                if isinstance(controls.get(name[::-1]), Stress)
                else [Stress(rng.normal(0.0, 3e7)), Stress()]
            )
            if rng.random() < 0.8:
                controls[name] = kinds[rng.integers(len(kinds))]
        segments.append(Segment(1e-3, 10, controls))
    return Program(segments)


@pytest.mark.parametrize("name", ["hypo-elastic", "hyper-elastic", "hyper-linear", "hypo-jc-hot"])
@pytest.mark.parametrize("seed", range(6))
def test_every_control_of_a_mixed_program_is_met(pool, name, seed):
    """F, L, stretches and stresses in any mix come out as prescribed, in every step."""
    program = random_program(np.random.default_rng(seed))
    history = drive_program(pool[name], program)
    f, largest = history.deformation_gradient, np.abs(history.stress).max()
    row = 0
    for segment in program.segments:
        start = row
        for step in range(1, segment.steps + 1):
            row += 1
            for component, control in segment.controls.items():
                i, j = int(component[0]) - 1, int(component[1]) - 1
                value = measured(component, control, f[row - 1], f[row], history.stress[row], 1e-4)
                share = step / segment.steps
                match control:
                    case Deformation():
                        assert value == pytest.approx(
                            (1 - share) * f[start, i, j] + share * control.target, abs=1e-15
                        )
                    case Stretch():
                        first = np.linalg.norm(f[start, :, i])
                        assert value == pytest.approx(first ** (1 - share) * control.target**share, rel=1e-12)
                    case VelocityGradient():
                        assert value == pytest.approx(control.rate, rel=1e-4, abs=0.01)
                    case Stress():
                        before = history.stress[start, FULL[i][j]]
                        goal = (1 - share) * before + share * control.target
                        assert value == pytest.approx(goal, abs=1e-8 * largest)


def test_constant_velocity_gradient_is_integrated_exactly(pool):
    """F = exp(L t): a spin turns the point rigidly and leaves no stress, a stretching gives exp(rate t)."""
    spin = {"12": VelocityGradient(-10.0), "21": VelocityGradient(10.0)}
    rest = {name: VelocityGradient(0.0) for name in COMPONENTS if name not in spin}
    history = drive_program(pool["hypo-elastic"], Program([Segment(0.1, 30, spin | rest)]))
    assert history.deformation_gradient == pytest.approx(
        rotations([0.0, 0.0, 1.0], np.linspace(0.0, 1.0, 31)), abs=1e-12
    )
    assert np.abs(history.stress).max() < 0.1
    stretching = Segment(0.1, 30, {"11": VelocityGradient(3.0)})
    end = drive_program(pool["hypo-elastic"], Program([stretching])).deformation_gradient[-1]
    assert end == pytest.approx(np.diag([np.exp(0.3), 1.0, 1.0]), abs=1e-12)


def test_targets_may_be_functions_of_time(pool):
    """A sine of stress, and one of the stretch, are followed at the ends of the steps."""
    times = np.linspace(0.0, 1.0, 41)[1:]
    wave = Segment(1.0, 40, FREE | {"11": Stress(lambda t: 1e8 * np.sin(2.0 * np.pi * t))})
    history = drive_program(pool["hyper-elastic"], Program([wave]))
    assert history.stress[1:, 0] == pytest.approx(1e8 * np.sin(2.0 * np.pi * times), abs=10.0)
    wave = Segment(1.0, 40, FREE | {"11": Stretch(lambda t: 1.0 + 0.01 * np.sin(2.0 * np.pi * t))})
    history = drive_program(pool["hyper-elastic"], Program([wave]))
    stretch = np.linalg.norm(history.deformation_gradient[1:, :, 0], axis=1)
    assert stretch == pytest.approx(1.0 + 0.01 * np.sin(2.0 * np.pi * times), rel=1e-12)


def test_a_melted_point_is_led_without_stress(pool):
    """Above the melting temperature nothing but the volume resists: the sides follow at constant volume."""
    history = drive_program(pool["hypo-jc-hot"], uniaxial_stress(0.3, 1e3), temperature=1400.0)
    assert np.abs(history.stress).max() < 1e-3
    assert history.deformation_gradient[-1].diagonal() == pytest.approx([np.exp(0.3), *[np.exp(-0.15)] * 2])


def test_a_step_that_is_not_found_is_cut(pool, monkeypatch):
    """With too few iterations for a large step, smaller ones lead to the same end."""
    whole = drive_program(pool["hyper-voce"], uniaxial_stress(0.4, 1e3, steps=1))
    monkeypatch.setattr(loading_step, "ITERATIONS", 4)
    cut = drive_program(pool["hyper-voce"], uniaxial_stress(0.4, 1e3, steps=1))
    assert len(cut.times) == 2
    assert not np.array_equal(cut.stress[1], whole.stress[1])
    assert cut.stress[1] == pytest.approx(whole.stress[1], rel=1e-2, abs=1e-8 * whole.stress[1, 0])


def test_a_stress_that_the_point_cannot_carry_ends_the_run(copper):
    """The message names step, time, component, stress, what is missing, and the laws."""
    material = copper("hypo", LinearHardening(STRENGTH, 0.0))
    with pytest.raises(RunFailure) as failure:
        drive_program(material, Program([Segment(1e-3, 10, FREE | {"11": Stress(800e6)})]))
    message = str(failure.value)
    for part in ("step 6, t = 6.0", "stress 11 = 4.0", "Pa is missed by", "LinearHardening"):
        assert part in message
    assert "\n" not in message


def test_steps_and_times_of_several_rates(pool):
    """Each rate holds for its share of the strain; every way of a cycle has steps of the same size."""
    program = uniaxial_strain(0.03, [1.0, 10.0, 100.0], steps=30, cycles=1)
    assert [segment.steps for segment in program.segments] == [10, 10, 10, 20, 20, 20, 20, 20, 20]
    assert program.time_steps[[0, 10, 20]] == pytest.approx([1e-3, 1e-4, 1e-5])
    f = drive_program(pool["hypo-elastic"], program).deformation_gradient
    assert np.abs(np.diff(np.log(f[:, 0, 0]))) == pytest.approx(np.full(150, 1e-3), rel=1e-9)
    assert [np.log(f[row, 0, 0]) for row in (30, 90, 150)] == pytest.approx([0.03, -0.03, 0.03], rel=1e-12)


def test_logarithm_of_matrices():
    """It is the angle times the axis of a rotation, the logarithms of stretches, and additive for small steps."""
    turn = matrix_logarithm(rotations([0.0, 0.0, 1.0], [0.7, 1.3]))
    assert turn[:, 1, 0] == pytest.approx([0.7, 1.3], rel=1e-12)
    assert matrix_logarithm(np.diag([2.0, 0.1, 15.0])[None])[0] == pytest.approx(
        np.diag(np.log([2.0, 0.1, 15.0])), abs=1e-12
    )
    a = np.array([[1.1, 0.2, 0.0], [0.1, 0.9, 0.3], [0.0, -0.2, 1.2]])
    logarithms = matrix_logarithm(np.stack([a, a @ a]))
    assert logarithms[1] == pytest.approx(2.0 * logarithms[0], abs=1e-13)
    for beyond in (rotations([0.0, 0.0, 1.0], [3.0]), -np.eye(3)[None]):
        assert np.all(np.isnan(matrix_logarithm(beyond)))


def test_segments_follow_each_other(pool):
    """A second segment starts from the stress and the deformation that the first has left."""
    confined = Segment(1e-5, 20, {"11": Stretch(0.95)})
    released = Segment(1e-5, 20, FREE | {"11": Deformation()})
    history = drive_program(pool["hypo-linear"], Program([confined, released]))
    lateral = history.stress[20:, 1]
    assert lateral[0] < -1e9
    assert np.diff(lateral) == pytest.approx(np.full(20, -lateral[0] / 20), rel=1e-6)
    assert abs(lateral[-1]) < 1e-8 * abs(lateral[0])
    assert np.all(history.deformation_gradient[20:, 0, 0] == history.deformation_gradient[20, 0, 0])
    for first, second in pairwise(history.deformation_gradient[20:, 1, 1]):
        assert second > first
