"""What a scene simulates and what it leaves out, and why: the material's effects and the scene's own."""

from math import sqrt

from core_models.material import Effect
from core_models.walls import MEANING
from studies.scene import Scene

STANDARD_GRAVITY = 9.80665  # m/s^2


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
            "the wall is frictionless: only such walls are offered yet",
        ),
        Effect("bulk viscosity", viscosity is not None, _viscosity_reason(viscosity)),
        Effect("heat conduction", False, _conduction_reason(scene, wall)),
        Effect("gravity", False, _gravity_reason(scene, wall)),
        Effect("three dimensions", False, "the scene is axisymmetric; no twist, no buckling"),
    ]


def _conduction_reason(scene: Scene, wall: str) -> str:
    material = scene.material
    needed = {
        "thermal_conductivity": material.thermal_conductivity,
        "specific_heat": material.specific_heat,
    }
    missing = [tag for tag, value in needed.items() if value is None]
    if missing:
        return f"adiabatic: not offered yet, and the card gives no {' and no '.join(missing)}"
    diffusivity = material.thermal_conductivity / (material.density * material.specific_heat.value)
    travelled = sqrt(diffusivity * scene.end.limit(wall))
    return (
        f"adiabatic: with the card's conductivity heat would travel {travelled * 1e3:.2g} mm; not offered yet"
    )


def _gravity_reason(scene: Scene, wall: str) -> str:
    change = STANDARD_GRAVITY * scene.end.limit(wall)
    return f"would change velocities by {change:.1g} m/s of {-scene.bar.velocity:g} m/s; not offered yet"


def _viscosity_reason(viscosity) -> str:
    if viscosity is None:
        return "the scene turns it off"
    return f"smears shocks over some elements: linear {viscosity.linear:g}, quadratic {viscosity.quadratic:g}"
