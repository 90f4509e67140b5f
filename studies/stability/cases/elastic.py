"""Elastic bodies for a long time, turning, and at the limit of the step."""

import numpy as np

from studies.stability.bodies import RADIUS, bar, bar_mesh, elastic, square
from studies.stability.case import Case

SPIN = 2e5  # 1/s
TURN = 2.0 * np.pi / SPIN  # s
COARSE = 2  # elements across a radius
ALMOST, BEYOND = 0.95, 1.05
CAUTIOUS = {"fem-explicit": "safety", "mpm": "cfl"}


def ringing(variant: str, **options):
    """A bar that swings along its axis by a ten thousandth, free at its ends."""
    return bar(
        variant,
        elastic(),
        viscosity=None,
        velocity=lambda places: np.column_stack(
            [np.zeros(len(places)), 0.5 * np.cos(np.pi * places[:, 1] / (3.0 * RADIUS))]
        ),
        **options,
    )


def _at_part(part: float):
    """The same with steps of a part of the estimated limit."""
    return lambda variant: ringing(variant, **{CAUTIOUS[variant.partition(":")[0]]: part})


def _long(variant: str):
    """The same of half as many elements: a million steps of them take long enough."""
    return ringing(variant, mesh=bar_mesh(variant, across=COARSE), cell=RADIUS / COARSE)


def _turning(variant: str):
    """A square that turns freely."""

    def velocity(places: np.ndarray) -> np.ndarray:
        x, y = (places - RADIUS).T
        return SPIN * np.column_stack([-y, x])

    return bar(
        variant,
        elastic(),
        mesh=square(variant, across=2 * COARSE),
        cell=RADIUS / COARSE,
        geometry="plane-strain",
        viscosity=None,
        velocity=velocity,
    )


CASES = (
    Case("long", "An elastic bar that swings for a million steps", _long, steps=1_000_000),
    Case("step-0.95", "Steps of 0.95 of the estimated limit", _at_part(ALMOST), steps=20_000),
    Case("step-1.05", "Steps of 1.05 of the estimated limit, asked for", _at_part(BEYOND), steps=20_000),
    Case(
        "step-forced",
        "Steps of 1.05 times what the usual choice takes",
        ringing,
        steps=20_000,
        factor=BEYOND,
    ),
    Case(
        "turning",
        "An elastic square that turns a thousand times",
        _turning,
        1000.0 * TURN,
        2_000_000,
        keeps=("angular momentum", lambda solver: solver.angular_momentum),
    ),
)
