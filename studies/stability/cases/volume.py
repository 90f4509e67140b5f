"""Large changes of volume, stiff volumes, and tension that takes particles apart."""

import numpy as np

from core_models.loads import Prescribed
from studies.stability.bodies import ASPECT, RADIUS, bar, copper, elastic, stiff
from studies.stability.case import Case

PULL = 100.0  # m/s


def _swelling(rate: float):
    """A bar all of whose lengths change at a rate [1/s] at the start."""
    return lambda variant: bar(variant, copper(), velocity=lambda places: rate * places)


def _incompressible(variant: str):
    return bar(variant, stiff(), velocity=-50.0, wall="unilateral")


def _pulled(variant: str):
    """Rear and foot are drawn apart, the bar to three times its length."""
    middle = 0.5 * ASPECT * RADIUS
    return bar(
        variant,
        elastic(),
        velocity=lambda places: np.column_stack(
            [0.0 * places[:, 0], PULL * (places[:, 1] - middle) / middle]
        ),
        loads=(Prescribed("foot", 1, -PULL), Prescribed("rear", 1, PULL)),
    )


CASES = (
    Case("tension", "Tension in all directions until J is about 1.3", _swelling(2e5), 0.6e-6),
    Case("spall", "Tension in all directions far beyond any spall strength", _swelling(5e5), 2e-6),
    Case("compression", "Compression in all directions towards the pole of the equation of state", _swelling(-5e5),
         0.8e-6),
    Case("locking", "Bulk modulus a thousand times the shear modulus, 50 m/s", _incompressible, 10e-6),
    Case("pulled-apart", "An elastic bar drawn to three times its length", _pulled, ASPECT * RADIUS / PULL),
)  # fmt: skip
