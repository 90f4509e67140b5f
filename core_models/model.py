"""The laws of a material as compiled code sees them."""

from typing import NamedTuple


class Model(NamedTuple):
    """One law per slot, `None` for an absent effect; the types of the slots are part of the compiled signature."""

    density: float
    update: tuple
    objective_rate: tuple | None
    elasticity: tuple
    eos: tuple
    flow: tuple | None
    yield_condition: tuple | None
    kinematic_hardening: tuple | None
    damage: tuple | None
    shear_modulus: tuple | None
    melting: tuple | None
    specific_heat: tuple | None
    heating: tuple | None
    expansion: tuple | None
    erosion: tuple | None
