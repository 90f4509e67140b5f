"""Options of the solvers that a variant (`variants.py`) or a run of a necking scene may give, with their words."""

ELEMENTS = {
    "integration": ("full", "reduced"),
    "cure": ("none", "mean-dilatation", "linear-dilatation", "nodal-average"),
}
PARTICLES = {
    "interpolation": ("linear", "gimp", "cpdi", "quadratic", "cubic"),
    "transfer": ("apic", "flip", "pic", "xpic"),
    "cure": ("none", "mean-dilatation"),
    "seeding": ("gauss", "lattice"),
}
NUMBER: tuple[str, ...] = ()
"""In place of words: the option is a number."""

SOLVER_OPTIONS: dict[str, dict[str, tuple[str, ...]]] = {
    "fem-implicit": {**ELEMENTS, "own_share": NUMBER, "tolerance": NUMBER},
    "fem-explicit": {**ELEMENTS, "own_share": NUMBER, "hourglass": NUMBER},
    "mpm-tl": {**PARTICLES, "cfl": NUMBER},
    "mpm-implicit": {
        "interpolation": ("linear", "quadratic", "cubic"),
        "cure": PARTICLES["cure"],
        "seeding": PARTICLES["seeding"],
        "ghost": NUMBER,
        "tolerance": NUMBER,
    },
    "mpm": {**PARTICLES, "cfl": NUMBER},
}
"""Name of a method: options of its solver, each with its words."""
