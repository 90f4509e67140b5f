"""What a scene simulates and what it leaves out, and why: the material's effects and the scene's own."""

from math import sqrt

from core_models.conduction import missing_tags
from core_models.laws import heat_capacity
from core_models.material import Effect
from core_models.walls import MEANING
from studies.methods.variants import read_variant
from studies.scenes.scene import Scene

STANDARD_GRAVITY = 9.80665  # m/s^2


def scene_effects(scene: Scene, wall: str, methods: tuple[str, ...] = ()) -> list[Effect]:
    """All effects of a scene under a wall by some methods, on and off, each with its reason."""
    return [*scene.material.effects(), *_own_effects(scene, wall, methods)]


def _own_effects(scene: Scene, wall: str, methods: tuple[str, ...]) -> list[Effect]:
    viscosity = scene.viscosity
    return [
        Effect(f"wall ({wall})", True, f"rigid: {MEANING[wall]}"),
        Effect("wall friction", scene.friction > 0.0, _friction_reason(scene)),
        Effect("bulk viscosity", viscosity is not None, _viscosity_reason(viscosity)),
        Effect("heat conduction", scene.conduction, _conduction_reason(scene, wall)),
        Effect("gravity", False, _gravity_reason(scene, wall)),
        Effect("three dimensions", *_dimensions(methods)),
    ]


def _dimensions(methods: tuple[str, ...]) -> tuple[bool, str]:
    """Whether some of the methods simulate the bar in three dimensions, and what that means."""
    spatial = [name for name in methods if read_variant(name).is_spatial]
    if not spatial:
        return False, "the methods are axisymmetric; no twist, no buckling"
    return True, f"a quarter between two symmetry planes: {', '.join(spatial)}; no twist, no buckling"


def _friction_reason(scene: Scene) -> str:
    if scene.friction == 0.0:
        return 'frictionless: the scene gives no coefficient (<wall friction="...">)'
    return f"the scene asks for it: the wall's tangential force is up to {scene.friction:g} of the normal one"


def _conduction_reason(scene: Scene, wall: str) -> str:
    missing = missing_tags(scene.material)
    if missing:
        return f"adiabatic: the card gives no {' and no '.join(missing)}"
    travelled = f"{_heat_travels(scene, wall) * 1e3:.2g} mm"
    if scene.conduction:
        return f"the scene asks for it: heat travels some {travelled}; the bar is insulated"
    return f"adiabatic: heat would travel some {travelled}; <conduction>on</conduction> turns it on"


def _heat_travels(scene: Scene, wall: str) -> float:
    """How far heat travels by the end, sqrt(k t / (rho c)) [m]."""
    material = scene.material
    capacity = material.density * heat_capacity(material.specific_heat, scene.bar.temperature)
    return sqrt(material.thermal_conductivity / capacity * scene.end.limit(wall))


def _gravity_reason(scene: Scene, wall: str) -> str:
    change = STANDARD_GRAVITY * scene.end.limit(wall)
    return f"would change velocities by {change:.1g} m/s of {-scene.bar.velocity:g} m/s; scenes have no loads"


def _viscosity_reason(viscosity) -> str:
    if viscosity is None:
        return "the scene turns it off"
    return f"smears shocks over some elements: linear {viscosity.linear:g}, quadratic {viscosity.quadratic:g}"
