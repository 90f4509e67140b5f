"""Switching one effect of a scene: each takes the scene and gives it with the effect the other way round."""

from collections.abc import Callable
from dataclasses import dataclass, replace

from core_models.bulk_viscosity import BulkViscosity
from core_models.conduction import missing_tags
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.laws import elastic_moduli
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from studies.scenes.scene import Scene

FRICTION = 0.1


@dataclass(frozen=True)
class Switch:
    """An effect by the name of its decision, and what switching it does; None where a scene does not allow it."""

    effect: str
    switched: Callable[[Scene], tuple[str, Scene] | None]


def _damage(scene: Scene) -> tuple[str, Scene] | None:
    material = scene.material
    if material.damage is None:
        return None
    return "off", replace(scene, material=replace(material, damage=None, erosion=None))


def _heating(scene: Scene) -> tuple[str, Scene] | None:
    material = scene.material
    if material.heating is None:
        return None
    return "off", replace(scene, material=replace(material, heating=None), conduction=False)


def _conduction(scene: Scene) -> tuple[str, Scene] | None:
    if scene.conduction:
        return "off", replace(scene, conduction=False)
    return None if missing_tags(scene.material) else ("on", replace(scene, conduction=True))


def _equation_of_state(scene: Scene) -> tuple[str, Scene] | None:
    material = scene.material
    if not material.uses("uses_energy"):
        return None
    bulk = elastic_moduli(material.elasticity)[0]
    linear = {HypoelasticPlastic: DefaultHypoelastic, HyperelasticPlastic: NeoHookean}.get(
        type(material.update)
    )
    return (
        None if linear is None else ("linear", replace(scene, material=replace(material, eos=linear(bulk))))
    )


def _viscosity(scene: Scene) -> tuple[str, Scene] | None:
    if scene.viscosity is None:
        return "on", replace(scene, viscosity=BulkViscosity())
    return "off", replace(scene, viscosity=None)


def _friction(scene: Scene) -> tuple[str, Scene] | None:
    if scene.friction > 0.0:
        return "off", replace(scene, friction=0.0)
    return f"{FRICTION:g}", replace(scene, friction=FRICTION)


SWITCHES = (
    Switch("damage", _damage),
    Switch("plastic heating", _heating),
    Switch("heat conduction", _conduction),
    Switch("equation of state", _equation_of_state),
    Switch("bulk viscosity", _viscosity),
    Switch("wall friction", _friction),
)
