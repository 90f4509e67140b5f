"""Large changes of volume, stiff volumes, and tension that takes particles apart."""

import numpy as np

from core_models.loads import Prescribed
from core_models.material import Material
from studies.stability.bodies import ASPECT, RADIUS, bar, copper, elastic, stiff
from studies.stability.case import Case

PULL, PRESS = 100.0, 300.0  # m/s
NEAR_POLE = 0.4  # J; copper's equation of state has its pole at 1 - 1 / 1.49 = 0.33


def _swelling(rate: float):
    """A bar all of whose lengths change at a rate [1/s] at the start."""
    return lambda variant: bar(variant, copper(), velocity=lambda places: rate * places)


def _incompressible(variant: str):
    return bar(variant, stiff(), velocity=-50.0, wall="unilateral")


def _drawn(variant: str, material: Material, speed: float, held: tuple[Prescribed, ...]):
    """Rear and foot are drawn apart at a speed [m/s] each, or pressed together."""
    middle = 0.5 * ASPECT * RADIUS
    return bar(
        variant,
        material,
        velocity=lambda places: np.column_stack(
            [0.0 * places[:, 0], speed * (places[:, 1] - middle) / middle]
        ),
        loads=(Prescribed("foot", 1, -speed), Prescribed("rear", 1, speed), *held),
    )


def _pulled(variant: str):
    return _drawn(variant, elastic(), PULL, ())


def _pressed(variant: str):
    return _drawn(variant, copper(), -PRESS, (Prescribed("side", 0, 0.0),))


CASES = (
    Case("tension", "Tension in all directions until J is about 1.3", _swelling(3e5), 0.6e-6),
    Case("spall", "Tension in all directions far beyond any spall strength", _swelling(5e5), 2e-6),
    Case("compression", "Compression in all directions to J of about 0.75, and rebound", _swelling(-5e5), 0.8e-6),
    Case("pole", f"Held sideways and pressed to J = {NEAR_POLE:g}, next to the pole of the equation of state", _pressed,
         (1.0 - NEAR_POLE) * ASPECT * RADIUS / (2.0 * PRESS)),
    Case("locking", "Bulk modulus a thousand times the shear modulus, 50 m/s", _incompressible, 10e-6),
    Case("pulled-apart", "An elastic bar drawn to three times its length", _pulled, ASPECT * RADIUS / PULL),
)  # fmt: skip
