"""What a scene simulates and what it leaves out, and why: the material's effects and the scene's own."""

from math import sqrt

from core_models.material import Effect
from core_models.walls import MEANING
from studies.scene import Scene


def scene_effects(scene: Scene, wall: str) -> list[Effect]:
    """All effects of a scene under a wall, on and off, each with its reason."""
    return [*scene.material.effects(), *_own_effects(scene, wall)]


def _own_effects(scene: Scene, wall: str) -> list[Effect]:
    viscosity = scene.viscosity
    return [
        Effect(f"wall ({wall})", True, f"rigid: {MEANING[wall]}"),
        Effect(
            "wall friction",
            False,
            "frictionless wall: the scene's benchmark, and nothing else is offered yet",
        ),
        Effect("bulk viscosity", viscosity is not None, _viscosity_reason(viscosity)),
        Effect("heat conduction", False, _conduction_reason(scene, wall)),
        Effect("gravity", False, "changes velocities by less than 0.01 m/s in the time simulated"),
        Effect("three dimensions", False, "the scene is axisymmetric; no twist, no buckling"),
    ]


def _conduction_reason(scene: Scene, wall: str) -> str:
    material = scene.material
    if material.specific_heat is None or material.thermal_conductivity is None:
        return "adiabatic: not offered yet, and the card gives no conductivity and specific heat"
    diffusivity = material.thermal_conductivity / (material.density * material.specific_heat.value)
    travelled = sqrt(diffusivity * scene.end.limit(wall))
    return (
        f"adiabatic: with the card's conductivity heat would travel {travelled * 1e3:.2g} mm; not offered yet"
    )


def _viscosity_reason(viscosity) -> str:
    if viscosity is None:
        return "the scene turns it off"
    return f"smears shocks over some elements: linear {viscosity.linear:g}, quadratic {viscosity.quadratic:g}"
