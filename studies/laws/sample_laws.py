"""One law of every class that cards can name, by slot: copper, as far as there is one."""

from core_models.cards import read_material, shipped_materials
from core_models.damage.gurson import VoidNucleation
from core_models.damage.hancock_mackenzie import HancockMackenzieDamage
from core_models.damage.johnson_cook import JohnsonCookDamage
from core_models.damage.sandia import SandiaDamage
from core_models.elasticity.cubic import CubicElastic
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.elasticity.orthotropic import OrthotropicElastic
from core_models.elasticity.transversely_isotropic import TransverselyIsotropicElastic
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.eos.neo_hookean import NeoHookean
from core_models.eos.spalling_mie_gruneisen import SpallingMieGruneisen
from core_models.erosion.delete import DeletePoint
from core_models.erosion.no_shear import AllowNoShear
from core_models.erosion.no_tension import AllowNoTension
from core_models.erosion.preserve_stress import PreserveStress
from core_models.erosion.zero_stress import ZeroStress
from core_models.expansion.isotropic import IsotropicExpansion
from core_models.flow.anand import Anand
from core_models.flow.johnson_cook import JohnsonCook
from core_models.flow.linear import LinearHardening
from core_models.flow.mts import MechanicalThreshold
from core_models.flow.perfect import PerfectPlasticity
from core_models.flow.power_law import PowerLaw
from core_models.flow.tabulated import TabulatedHardening
from core_models.flow.thermal_voce import ThermalVoce
from core_models.flow.voce import Voce
from core_models.flow.zerilli_armstrong import ZerilliArmstrong
from core_models.heating.isentropic import IsentropicHeating
from core_models.heating.taylor_quinney import TaylorQuinney
from core_models.kinematic_hardening.armstrong_frederick import ArmstrongFrederick
from core_models.kinematic_hardening.chaboche import Chaboche
from core_models.kinematic_hardening.prager import Prager
from core_models.kinematic_hardening.ziegler import Ziegler
from core_models.melting.burakovsky_preston_silbar import BurakovskyMelting
from core_models.melting.constant import ConstantMelting
from core_models.melting.steinberg_cochran_guinan import SteinbergMelting
from core_models.objective_rate.jaumann import Jaumann
from core_models.objective_rate.logarithmic import Logarithmic
from core_models.shear_modulus.constant import ConstantShearModulus
from core_models.shear_modulus.nadal_le_poac import NadalLePoac
from core_models.shear_modulus.preston_tonks_wallace import PrestonShearModulus
from core_models.shear_modulus.steinberg_cochran_guinan import SteinbergShearModulus
from core_models.shear_modulus.varshni import VarshniShearModulus
from core_models.specific_heat.constant import ConstantSpecificHeat
from core_models.specific_heat.copper import CopperSpecificHeat
from core_models.specific_heat.steel import SteelSpecificHeat
from core_models.stability.drucker import DruckerStability
from core_models.stability.hyperbolicity import HyperbolicityLoss
from core_models.updates.compressible_neo_hookean import CompressibleNeoHookean
from core_models.updates.fibre_reinforced import FibreReinforced
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.updates.st_venant_kirchhoff import StVenantKirchhoff
from core_models.yield_condition.drucker_prager import DruckerPrager
from core_models.yield_condition.gurson import Gurson
from core_models.yield_condition.mohr_coulomb import MohrCoulomb
from core_models.yield_condition.von_mises import VonMises

DENSITY, BULK, SHEAR = 8930.0, 136.35e9, 45.45e9


def _shipped(name: str) -> tuple:
    return read_material(shipped_materials()[name]).material.flow


SAMPLES = {
    "update": [
        HypoelasticPlastic(),
        HyperelasticPlastic(),
        CompressibleNeoHookean(),
        FibreReinforced(1e9, 2.0, (1.0, 1.0, 0.0)),
        StVenantKirchhoff(),
    ],
    "elasticity": [
        IsotropicElastic(BULK, SHEAR),
        CubicElastic(168.4e9, 121.4e9, 75.4e9, (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
        TransverselyIsotropicElastic(140e9, 10e9, 0.3, 0.4, 5e9, (0.0, 1.0, 0.0)),
        OrthotropicElastic(
            140e9, 10e9, 8e9, 0.3, 0.4, 0.3, 5e9, 3e9, 4e9, (1.0, 1.0, 0.0), (-1.0, 1.0, 0.0)
        ),
    ],
    "objective_rate": [Logarithmic(), Jaumann()],
    "eos": [
        DefaultHypoelastic(BULK),
        NeoHookean(BULK),
        MieGruneisen(DENSITY, 3940.0, 2.02, 1.489),
        SpallingMieGruneisen(DENSITY, 3940.0, 2.02, 1.489, 1.2e9),
    ],
    "flow": [
        PerfectPlasticity(90e6),
        LinearHardening(400e6, 100e6),
        PowerLaw(90e6, 0.01, 0.3),
        Voce(450e6, 715e6, 16.93, 129.24e6),
        ThermalVoce(450e6, 715e6, 16.93, 129.24e6, 0.002, 0.002, 293.15),
        TabulatedHardening((0.0, 0.1, 0.5), (90e6, 230e6, 325e6)),
        JohnsonCook(89.6e6, 292e6, 0.025, 0.31, 1.09, 1.0, 294.0, 1356.0),
        MechanicalThreshold(
            40e6, 0.823e6, 1e7, 1.6, 1.0, 2 / 3, 2.0, 1e7, 0.2625, 770e6, 2390e6, 12e6, 1.696e6, 0.0, 0.0, 45.78e9,
            3.0e9, 180.0, 47.7e9,
        ),
        ZerilliArmstrong(46.5e6, 5e6, 3.7, 0.0, 0.0, 0.0, 890e6, 0.0028, 1.15e-4, 0.0, 0.0),
        _shipped("copper_ofhc_steinberg_cochran_guinan"),
        _shipped("copper_ofhc_preston_tonks_wallace"),
        Anand(56.33e6, 10830.0, 1.49e7, 11.0, 0.303, 2640.75e6, 80.415e6, 0.0231, 1.34),
    ],
    "yield_condition": [
        VonMises(),
        DruckerPrager(0.2, 0.1),
        MohrCoulomb(30.0, 10.0),
        Gurson(1.5, 1.0, 2.25, 4.0, 0.05),
    ],
    "kinematic_hardening": [
        Prager(1e9),
        Ziegler(1e9),
        ArmstrongFrederick(40e9, 400.0),
        Chaboche((40e9, 1e9), (400.0, 0.0)),
    ],
    "shear_modulus": [
        ConstantShearModulus(SHEAR),
        VarshniShearModulus(47.7e9, 3e9, 180.0),
        SteinbergShearModulus(47.7e9, 2.83e-11, 3.77e-4),
        PrestonShearModulus(51.8e9, 0.2, 28e-12),
        NadalLePoac(50.7e9, 0.04, 28e-12, 0.057, 63.55, DENSITY),
    ],
    "damage": [
        JohnsonCookDamage(0.54, 4.89, -3.03, 0.014, 1.12, 294.0, 1356.0),
        HancockMackenzieDamage(1e-4, 0.7),
        SandiaDamage(6.0, 1e-4, 0.1),
        VoidNucleation(1e-3, 0.04, 0.3, 0.1),
    ],
    "melting": [
        ConstantMelting(1356.0),
        SteinbergMelting(1790.0, 2.02, 1.5),
        BurakovskyMelting(
            137e9, 5.48, 47.7e9, 1.4, 1.0, 12.0, 0.64, 3.3, 1.41, 3.6147e-10, 0.25, 1.380649e-23
        ),
    ],
    "specific_heat": [ConstantSpecificHeat(383.0), CopperSpecificHeat(), SteelSpecificHeat()],
    "heating": [TaylorQuinney(0.9), IsentropicHeating(0.9)],
    "expansion": [IsotropicExpansion(1.7e-5, 294.0)],
    "stability": [DruckerStability(), HyperbolicityLoss()],
    "erosion": [ZeroStress(), AllowNoTension(), AllowNoShear(), PreserveStress(), DeletePoint()],
}  # fmt: skip
