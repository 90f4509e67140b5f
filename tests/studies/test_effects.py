"""A scene's own effects: the reasons are worked out from the scene."""

from dataclasses import replace

import pytest

from core_models.specific_heat.constant import ConstantSpecificHeat
from core_models.specific_heat.copper import CopperSpecificHeat
from studies.scenes.effects import scene_effects
from studies.scenes.scene import End


def reason(scene, name):
    """Why an effect is on or off."""
    return next(effect.reason for effect in scene_effects(scene, scene.wall) if effect.name == name)


def test_gravity_is_worked_out_from_the_time_simulated(classic):
    """g t: 0.0008 m/s in 80 µs, a hundred times that in a hundred times as long."""
    assert "0.0008 m/s" in reason(classic, "gravity")
    assert "0.08 m/s" in reason(replace(classic, end=End(time=8e-3)), "gravity")


@pytest.mark.parametrize(
    ("given", "absent", "present"),
    [
        ({}, "no thermal_conductivity and no specific_heat", None),
        ({"thermal_conductivity": 386.0}, "no specific_heat", "thermal_conductivity"),
        ({"specific_heat": ConstantSpecificHeat(383.0)}, "no thermal_conductivity", "specific_heat"),
        (
            {"thermal_conductivity": 386.0, "specific_heat": ConstantSpecificHeat(383.0)},
            "would travel",
            "gives",
        ),
    ],
)
def test_conduction_names_only_what_is_missing(classic, given, absent, present):
    """A tag that the card gives is not called missing."""
    told = reason(replace(classic, material=replace(classic.material, **given)), "heat conduction")
    assert absent in told and (present is None or present not in told)


def test_conduction_says_how_far_heat_travels(classic):
    """sqrt(k t / (rho c)) in 80 µs, on or off, also with a specific heat that depends on the temperature."""
    copper = replace(classic.material, thermal_conductivity=386.0, specific_heat=ConstantSpecificHeat(383.0))
    scene = replace(classic, material=copper)
    told = reason(scene, "heat conduction")
    assert "some 0.095 mm" in told and "turns it on" in told
    assert "some 0.095 mm; the bar is insulated" in reason(replace(scene, conduction=True), "heat conduction")
    law = replace(scene, material=replace(copper, specific_heat=CopperSpecificHeat()))
    assert "some 0.094 mm" in reason(law, "heat conduction")


def test_wall_friction_is_the_scenes(classic):
    """Off and on as the scene says, with the coefficient."""
    assert "frictionless: the scene gives no coefficient" in reason(classic, "wall friction")
    rough = replace(classic, friction=0.15)
    effect = next(effect for effect in scene_effects(rough, rough.wall) if effect.name == "wall friction")
    assert effect.on and "0.15 of the normal" in effect.reason


def test_dimensions_are_those_of_the_methods(classic):
    """A quarter in space is told from a body of revolution."""
    for methods, on in (((), False), (("mpm", "fem-explicit:hex8"), True), (("mpm:cubic",), False)):
        effects = scene_effects(classic, classic.wall, methods)
        assert next(effect.on for effect in effects if effect.name == "three dimensions") is on
