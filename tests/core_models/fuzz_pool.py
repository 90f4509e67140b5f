"""Materials that the fuzz test leads astray: a pool that covers pairs of laws, and a few that other tests compile."""

from itertools import combinations
from typing import NamedTuple

import numpy as np

from core_models.compatibility import clashes
from core_models.material import Material
from studies.laws.sample_laws import DENSITY, SAMPLES

LARGEST_POOL = 40
AXES = {
    "update": [*SAMPLES["update"][:2], SAMPLES["update"][1]],  # the one that clashes more often twice
    "elasticity": SAMPLES["elasticity"],
    "eos": [None, *SAMPLES["eos"]],
    "flow": SAMPLES["flow"],
    "yield_condition": SAMPLES["yield_condition"],
    "kinematic_hardening": [None, *SAMPLES["kinematic_hardening"]],
    "shear_modulus": [None, *SAMPLES["shear_modulus"]],
    "damage": [None, *SAMPLES["damage"]],
    "melting": [None, *SAMPLES["melting"]],
    "heating": [None, SAMPLES["heating"][0]],
    "specific_heat": SAMPLES["specific_heat"],
    "expansion": [None, *SAMPLES["expansion"]],
    "erosion": [None, *SAMPLES["erosion"]],
    "stability": [None, *SAMPLES["stability"]],
    "objective_rate": [None, *SAMPLES["objective_rate"]],
}
RADII = (None, 1.5)  # of nonlocal damage, over points that lie 1 apart [m]


class Laws(NamedTuple):
    """Laws by slot, of which each axis gives one."""

    update: tuple
    elasticity: tuple
    eos: tuple
    flow: tuple
    yield_condition: tuple
    kinematic_hardening: tuple
    shear_modulus: tuple
    damage: tuple
    melting: tuple
    heating: tuple
    specific_heat: tuple
    expansion: tuple
    erosion: tuple
    stability: tuple
    objective_rate: tuple


def random_laws(random):
    """Laws that the table lets together: drawn at random, those that clash again and again."""
    picks = {slot: int(random.integers(len(laws))) for slot, laws in AXES.items()}
    while True:
        laws = Laws(**{slot: AXES[slot][number] for slot, number in picks.items()})
        clash = next(clashes(laws), None)
        if clash is None:
            return picks, laws
        slot = random.choice([slot for slot in (clash.slot, clash.other) if len(AXES[slot]) > 1])
        picks[slot] = int(random.integers(len(AXES[slot])))


def covering_pool():
    """At most 40 materials, each of which adds as many new pairs of laws as 60 random ones offer."""
    random = np.random.default_rng(0)
    seen, pool = set(), []
    for number in range(LARGEST_POOL):
        drawn = [random_laws(random) for _attempt in range(60)]
        picks, laws = max(drawn, key=lambda each: len(set(combinations(each[0].items(), 2)) - seen))
        seen |= set(combinations(picks.items(), 2))
        radius = None if laws.damage is None else RADII[number % 2]
        pool.append(Material(f"fuzz-{number}", DENSITY, **laws._asdict(), damage_radius=radius))
    return pool


def general_materials():
    """Materials whose return is a local problem, of types that other tests compile as well."""
    linear = {"elasticity": SAMPLES["elasticity"][0], "eos": SAMPLES["eos"][0], "flow": SAMPLES["flow"][1]}
    von_mises, cone, _pyramid, porous = SAMPLES["yield_condition"]
    prager, _ziegler, frederick, _chaboche = SAMPLES["kinematic_hardening"]
    moving = {"yield_condition": von_mises, "kinematic_hardening": frederick}
    slots = (
        {"yield_condition": porous, "damage": SAMPLES["damage"][-1], "damage_radius": RADII[1]},
        {"yield_condition": cone, "kinematic_hardening": prager},
        {**moving, "flow": SAMPLES["flow"][0]},
        {**moving, "elasticity": SAMPLES["elasticity"][1], "eos": None},
    )
    update = SAMPLES["update"][0]
    return [Material(f"general-{i}", DENSITY, update, **(linear | own)) for i, own in enumerate(slots)]
