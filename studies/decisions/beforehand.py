"""Which effects a scene calls for, from its own numbers alone: each with a number, a threshold and what it is.

A number at or above its threshold asks for the effect. The scene decides; where the two differ, the run says so.
"""

from dataclasses import dataclass

from core_models.damage.johnson_cook import JohnsonCookDamage
from core_models.erosion.preserve_stress import PreserveStress
from core_models.laws import elastic_moduli, flow_stress, heat_capacity, melting_temperature
from core_models.material import Material
from studies.scenes.effects import STANDARD_GRAVITY
from studies.scenes.scene import Scene

HEATED = 0.9  # part of the work that becomes heat
TYPICAL_STRAIN, TYPICAL_RATE = 0.1, 1e4  # at which the flow stress is taken; 1/s


@dataclass(frozen=True)
class Decision:
    """One effect: whether the scene has it, the number that asks for it, its threshold, and what the number is.

    number None: the scene has no numbers that could tell, and `meaning` says why. acts: False of what is computed and
    reported, but changes no answer.
    """

    effect: str
    on: bool
    number: float | None
    threshold: float
    meaning: str
    acts: bool = True

    @property
    def wanted(self) -> bool | None:
        """Whether the number asks for the effect; None where it cannot tell."""
        return None if self.number is None else bool(self.number >= self.threshold)


def decisions(scene: Scene, wall: str) -> list[Decision]:
    """All decisions about a scene under a wall, before anything has been run."""
    return [
        _heating(scene),
        _conduction(scene, wall),
        _equation_of_state(scene),
        _viscosity(scene),
        _damage(scene),
        _friction(scene),
        _gravity(scene, wall),
        _inertia(scene),
    ]


def disagreements(scene: Scene, wall: str) -> list[Decision]:
    """Effects that the numbers ask for and the scene leaves out, or the other way round."""
    return [each for each in decisions(scene, wall) if each.wanted is not None and each.wanted != each.on]


def _heating(scene: Scene) -> Decision:
    material, bar = scene.material, scene.bar
    meaning = "temperature rise if all kinetic energy became plastic work, by what is left to melting"
    on = material.heating is not None
    if material.specific_heat is None or material.melting is None:
        missing = "specific heat" if material.specific_heat is None else "melting temperature"
        return Decision("plastic heating", on, None, 0.02, f"the card gives no {missing}")
    rise = HEATED * 0.5 * bar.velocity**2 / heat_capacity(material.specific_heat, bar.temperature)
    left = melting_temperature(material.melting, 1.0, 0.0) - bar.temperature
    return Decision("plastic heating", on, rise / left if left > 0.0 else 0.0, 0.02, meaning)


def _conduction(scene: Scene, wall: str) -> Decision:
    material = scene.material
    if material.thermal_conductivity is None or material.specific_heat is None:
        return Decision(
            "heat conduction", scene.conduction, None, 0.01, "the card gives no conductivity or heat"
        )
    capacity = material.density * heat_capacity(material.specific_heat, scene.bar.temperature)
    fourier = material.thermal_conductivity / capacity * scene.end.limit(wall) / scene.bar.radius**2
    return Decision("heat conduction", scene.conduction, fourier, 0.01, "Fourier number k t / (rho c R0^2)")


def _equation_of_state(scene: Scene) -> Decision:
    bulk = elastic_moduli(scene.material.elasticity)[0]
    pressure = scene.material.density * scene.wave_speed * -scene.bar.velocity
    on = scene.material.uses("uses_energy")
    return Decision("equation of state", on, pressure / bulk, 0.01, "pressure of the impact rho c v by K")


def _viscosity(scene: Scene) -> Decision:
    mach = -scene.bar.velocity / scene.wave_speed
    return Decision("bulk viscosity", scene.viscosity is not None, mach, 0.01, "impact speed by wave speed")


def _strength(scene: Scene) -> float:
    """Flow stress at a typical strain and rate [Pa]."""
    flow, temperature = scene.material.flow, scene.bar.temperature
    return max(flow_stress(flow, 0.0, TYPICAL_STRAIN, TYPICAL_RATE, temperature)[0], 1.0)


def _damage(scene: Scene) -> Decision:
    material, bar = scene.material, scene.bar
    on, acts = material.damage is not None, _damage_acts(material)
    if not isinstance(material.damage, JohnsonCookDamage) or material.flow is None:
        return Decision("damage", on, None, 0.1, "no damage law that says at which strain it fails", acts)
    strain = material.density * bar.velocity**2 / _strength(scene)
    failure = material.damage.D1 + material.damage.D2
    meaning = "strain of the foot rho v^2 / sigma_y by the failure strain without pressure"
    return Decision("damage", on, strain / failure, 0.1, meaning, acts)


def _damage_acts(material: Material) -> bool:
    """By a share of the strength, by what erosion takes from failed points, or through the yield condition."""
    erodes = material.erosion is not None and not isinstance(material.erosion, PreserveStress)
    return erodes or getattr(material.damage, "coupling", 1.0) > 0.0


def _friction(scene: Scene) -> Decision:
    return Decision("wall friction", scene.friction > 0.0, None, 0.0, "only the pair of surfaces can tell")


def _gravity(scene: Scene, wall: str) -> Decision:
    change = STANDARD_GRAVITY * scene.end.limit(wall) / -scene.bar.velocity
    return Decision("gravity", False, change, 0.01, "change of speed g t by the impact speed")


def _inertia(scene: Scene) -> Decision:
    material = scene.material
    if material.flow is None:
        return Decision("inertia", True, None, 0.01, "no flow law: nothing takes the motion up for good")
    work = TYPICAL_STRAIN * _strength(scene)
    number = 0.5 * material.density * scene.bar.velocity**2 / work
    return Decision("inertia", True, number, 0.01, "kinetic energy by the plastic work of a strain of 0.1")
