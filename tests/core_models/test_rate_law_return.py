"""The return to the yield surface with the rate-dependent laws, in plain Python: no kernel is compiled for it."""

import numpy as np
import pytest

from core_models.flow.anand import Anand
from core_models.flow.mts import MechanicalThreshold
from core_models.flow.preston_tonks_wallace import PrestonTonksWallace
from core_models.flow.steinberg_cochran_guinan import SteinbergCochranGuinan
from core_models.flow.tabulated import TabulatedHardening
from core_models.flow.thermal_voce import ThermalVoce
from core_models.flow.zerilli_armstrong import ZerilliArmstrong
from core_models.laws import evolve_hardening, flow_stress
from core_models.status import OK
from core_models.yield_condition.interface import guess_increment, return_to_surface, search_surface
from core_models.yield_condition.von_mises import VonMises

TOLERANCE = 1e-10
SHEAR_3 = 90e9
PRESTON = PrestonTonksWallace(
    0.025, 2.0, 0.0085, 0.00055, 0.11, 1e-5, 1e-4, 1e-4, 0.094, 0.575, 0.25, 63.54, 51.8e9, 0.2, 28e-12, 8930.0, 1360.0
)  # fmt: skip
LAWS = {
    "zerilli fcc": ZerilliArmstrong(46.5e6, 5e6, 3.7, 0.0, 0.0, 0.0, 890e6, 0.0028, 1.15e-4, 0.0, 0.0),
    "zerilli bcc": ZerilliArmstrong(65e6, 0.0, 0.0, 1033e6, 0.00698, 4.15e-4, 0.0, 0.0, 0.0, 266e6, 0.289),
    "lund": SteinbergCochranGuinan(
        0.12e9, 36.0, 0.45, 0.0, 0.64e9, 2.83e-11, 3.77e-4, 1790.0, 2.02, 1.5, 0.71e6, 0.012e6, 0.31, 8.617e-5, 5e7
    ),
    "preston": PRESTON,
    "preston p = 0": PRESTON._replace(p=0.0),
    "anand": Anand(56.33e6, 10830.0, 1.49e7, 11.0, 0.303, 2640.75e6, 80.415e6, 0.0231, 1.34),
    "thermal voce": ThermalVoce(450e6, 715e6, 16.93, 129.24e6, 0.002, 0.002, 293.15),
    "table": TabulatedHardening((0.0, 0.1, 0.3), (90e6, 200e6, 260e6)),
    "threshold": MechanicalThreshold(
        40e6, 0.905e6, 1e7, 1.6, 1.0, 0.666667, 3.0, 1e7, 0.112, 822e6, 6e9, 0.0, 0.0, 2.0758e6, 200e6, 71.46e9, 2.9e9,
        204.0, 71.46e9, 1341e6, 1.161, 1e13, 0.5, 1.5,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", LAWS)
def test_return_settles_on_the_surface(name):
    """Trials up to 50 % strain beyond the surface, steps from 1e-12 s to 1000 s, any temperature, as strained as you
    like: the flow stress of the new state is the stress that is left, to the tolerance, or the step was elastic.
    """
    law, random = LAWS[name], np.random.default_rng(4)
    for _ in range(150):
        strain = random.choice([0.0, 10.0 ** random.uniform(-14.0, 0.5)])
        temperature, over_dt = random.uniform(50.0, 1500.0), 10.0 ** random.uniform(-3.0, 12.0)
        variable = random.uniform(0.5, 2.0) * getattr(law, "hardening_variable", 0.0)
        trial = SHEAR_3 * 10.0 ** random.uniform(-7.0, -0.3)
        before = trial * random.uniform(0.0, 1.2)
        guess = guess_increment(
            VonMises(), law, trial, SHEAR_3, before, strain, variable, over_dt, temperature
        )
        result = return_to_surface(
            VonMises(), law, guess, trial, SHEAR_3, strain, variable, over_dt, temperature, TOLERANCE
        )
        if result[-1] != OK:
            result = search_surface(
                VonMises(), law, trial, SHEAR_3, strain, variable, over_dt, temperature, TOLERANCE
            )
        factor, increment, stress, new_variable, status = result
        assert status == OK
        evolved = evolve_hardening(law, variable, increment, increment * over_dt, temperature)[0]
        strength = flow_stress(law, evolved, strain + increment, increment * over_dt, temperature)[0]
        if increment == 0.0:
            assert trial <= strength * (1.0 + 1e-12)
        else:
            assert trial - SHEAR_3 * increment == pytest.approx(strength, abs=3.0 * TOLERANCE * trial)
            assert (stress, factor) == pytest.approx(
                (strength, strength / trial), abs=3.0 * TOLERANCE * trial
            )
            assert new_variable == pytest.approx(evolved, rel=1e-6, abs=1.0)
