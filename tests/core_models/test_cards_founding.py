"""The founding documents and the other shipped materials."""

import logging

import pytest

from core_models.cards import Cylinder, read_material, shipped_materials
from core_models.damage.johnson_cook import JohnsonCookDamage
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.eos.neo_hookean import NeoHookean
from core_models.flow.johnson_cook import JohnsonCook
from core_models.flow.linear import LinearHardening
from core_models.flow.mts import MechanicalThreshold
from core_models.heating.taylor_quinney import TaylorQuinney
from core_models.material import Material
from core_models.melting.constant import ConstantMelting
from core_models.specific_heat.constant import ConstantSpecificHeat
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.von_mises import VonMises

FOUNDING_FLOW = {
    "copper_hypoelastic_johnson_cook": (
        HypoelasticPlastic(5e-10),
        JohnsonCook(A=89.6e6, B=292e6, C=0.025, n=0.31, m=1.09, epdot_0=1.0, T_r=294.0, T_m=1356.0),
    ),
    "copper_hyperelastic_mts": (
        HyperelasticPlastic(5e-10),
        MechanicalThreshold(
            sigma_a=40e6,
            koverbcubed=0.823e6,
            edot_0e=1e7,
            g_0e=1.6,
            q_e=1.0,
            p_e=0.666667,
            alpha=2.0,
            edot_es0=1e7,
            g_0es=0.2625,
            sigma_es0=770e6,
            a_0=2390e6,
            a_1=12e6,
            a_2=1.696e6,
            a_3=0.0,
            theta_IV=0.0,
            b1=45.78e9,
            b2=3e9,
            b3=180.0,
            mu_0=47.7e9,
        ),
    ),
}


@pytest.mark.parametrize("name", FOUNDING_FLOW)
def test_founding_document_reads_to_exactly_its_numbers(name):
    """The founding cards are read exactly as they stand, T_r and T_m from room_temp and melt_temp."""
    update, flow = FOUNDING_FLOW[name]
    assert read_material(shipped_materials()[name]).material == Material(
        name=name,
        density=8930.0,
        update=update,
        elasticity=IsotropicElastic(bulk_modulus=136.35e9, shear_modulus=45.45e9),
        eos=MieGruneisen(reference_density=8930.0, C_0=3940.0, Gamma_0=2.02, S_alpha=1.489),
        flow=flow,
        yield_condition=VonMises(),
        damage=JohnsonCookDamage(D1=0.54, D2=4.89, D3=-3.03, D4=0.014, D5=1.12, T_r=294.0, T_m=1356.0),
        melting=ConstantMelting(1356.0),
        specific_heat=ConstantSpecificHeat(383.0),
        heating=TaylorQuinney(0.9),
        room_temperature=294.0,
        thermal_conductivity=1.0,
    )


@pytest.mark.parametrize("name", FOUNDING_FLOW)
def test_founding_document_places_its_cylinder(name):
    """The block's geom_object gives the cylinder, its velocity and its temperature."""
    assert read_material(shipped_materials()[name]).bodies == (
        Cylinder(
            label="Cylinder",
            bottom=(0.0, 0.0, 0.0),
            top=(0.0, 2.54e-2, 0.0),
            radius=0.762e-2,
            velocity=(0.0, -208.0, 0.0),
            temperature=294.0,
            res=(3.0, 3.0, 3.0),
        ),
    )


@pytest.mark.parametrize("name", FOUNDING_FLOW)
def test_dead_tags_are_reported_with_their_place(name):
    """toughness, burn and velocity_field are accepted and reported as unused, with file and line."""
    path = shipped_materials()[name]
    constants = path.parent / "inputs/MPM/MaterialData/MaterialConstAnnCopper.xml"
    assert read_material(path).unused == (
        ("toughness", str(constants), 4),
        ("burn", str(path), 10),
        ("velocity_field", str(path), 11),
    )


def test_classic_bar_is_the_published_benchmark():
    """E = 117 GPa, nu = 0.35, 8930 kg/m^3, 0.4 and 0.1 GPa; hyperelastic, neo-Hookean, no temperature."""
    material = read_material(shipped_materials()["copper_hyperelastic_linear"]).material
    assert material.elasticity.bulk_modulus == pytest.approx(117e9 / (3.0 * 0.3), rel=1e-15)
    assert material.elasticity.shear_modulus == pytest.approx(117e9 / (2.0 * 1.35), rel=1e-15)
    assert material.eos == NeoHookean(130e9)
    assert material.flow == LinearHardening(yield_stress=0.4e9, hardening_modulus=0.1e9)
    assert material.density == 8930.0
    assert isinstance(material.update, HyperelasticPlastic)
    assert not material.needs_temperature


def test_ofhc_copper_is_johnson_cooks():
    """The material of the 190 m/s experiment: 90, 292 MPa, 0.025, 0.31, 1.09 between 294 and 1356 K."""
    material = read_material(shipped_materials()["copper_ofhc_johnson_cook"]).material
    assert material.flow == JohnsonCook(90e6, 292e6, 0.025, 0.31, 1.09, 1.0, 294.0, 1356.0)
    assert isinstance(material.update, HypoelasticPlastic)
    assert isinstance(material.eos, MieGruneisen)
    assert material.heating == TaylorQuinney(0.9)


MINIMAL = """<material>
  <density>8930</density>
  <constitutive_model type="{update}">
    <bulk_modulus>130e9</bulk_modulus> <shear_modulus>43e9</shear_modulus>
    <flow_model type="perfect"><sigma_Y>1e8</sigma_Y></flow_model>
  </constitutive_model>
</material>"""


@pytest.mark.parametrize(
    ("update", "eos"),
    [
        ("hypoelastic_plastic", "DefaultHypoelastic"),
        ("elastic_plastic", "DefaultHypoelastic"),
        ("elastic_plastic_hp", "DefaultHypoelastic"),
        ("hyperelastic_plastic", "NeoHookean"),
    ],
)
def test_equation_of_state_left_out_is_noted(update, eos, tmp_path, caplog):
    """Without an equation_of_state each update takes its own default and says so."""
    path = tmp_path / "card.xml"
    path.write_text(MINIMAL.format(update=update))
    with caplog.at_level(logging.INFO, logger="core_models"):
        material = read_material(path).material
    assert type(material.eos).__name__ == eos
    assert material.yield_condition == VonMises()
    assert f"{path}:3: no <equation_of_state>: {eos} is used" in caplog.text
