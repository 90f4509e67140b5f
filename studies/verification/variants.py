"""Which elements, interpolations and transfers the convergence problems try, and what is asked of each."""

from studies.report.parts import FEM, MPM
from studies.verification.variant import Variant

SECOND = 1.9  # of elements and of quadratic and cubic B-splines
BEFORE_FLOOR = 1.5  # of GIMP and CPDI, before their floor

CONTROL = "MPM linear"
KINDS = {2: ("quad4", "tri3", "quad8", "quad9", "tri6"), 3: ("hex8", "tet4", "hex20", "hex27", "tet10")}
SEEDED = {2: "quad4", 3: "hex8"}  # meshes that particles are made from
EVEN = {
    "seeding": "lattice"
}  # evenly spaced particles sample a stress that crosses cells better than Gauss points
INTERPOLATIONS = {
    "linear": None,
    "gimp": BEFORE_FLOOR,
    "cpdi": BEFORE_FLOOR,
    "quadratic": SECOND,
    "cubic": SECOND,
}


def elements(dimension: int) -> list[Variant]:
    """Every element, and the one-point quad or hexahedron with hourglass control."""
    found = [Variant(f"FEM {kind}", FEM, kind, {}, SECOND) for kind in KINDS[dimension]]
    kind = KINDS[dimension][0]
    return [*found, Variant(f"FEM {kind}, one point", FEM, kind, {"integration": "reduced"}, SECOND)]


def interpolations(dimension: int, finer: int = 1) -> list[Variant]:
    """Every interpolation with APIC; 2 `finer` evenly spaced particles along an edge of a cell."""
    return [
        Variant(f"MPM {name}", MPM, SEEDED[dimension], EVEN | {"interpolation": name}, order, finer)
        for name, order in INTERPOLATIONS.items()
    ]


def transfers(dimension: int, finer: int = 1) -> list[Variant]:
    """Quadratic B-splines with the other transfers, with MUSL and in the reference configuration."""
    options = {
        "FLIP 0.99": {"transfer": "flip"},
        "FLIP": {"transfer": "flip", "flip_fraction": 1.0},
        "PIC": {"transfer": "pic"},
        "XPIC(2)": {"transfer": "xpic", "xpic_order": 2},
        "MUSL": {"update": "musl"},
        "total": {"configuration": "total"},
    }
    kind = SEEDED[dimension]
    found = [
        Variant(f"MPM quadratic, {name}", MPM, kind, EVEN | more, finer=finer)
        for name, more in options.items()
    ]
    linear = EVEN | {"interpolation": "linear", "configuration": "total"}
    return [*found, Variant("MPM linear, total", MPM, kind, linear, finer=finer)]


def cured(dimension: int) -> list[Variant]:
    """What follows plastic flow without locking: every element with its own cure, MPM with mean dilatation."""
    found = [Variant(f"FEM {kind}", FEM, kind) for kind in KINDS[dimension]]
    kind = KINDS[dimension][0]
    found.append(Variant(f"FEM {kind}, one point", FEM, kind, {"integration": "reduced"}))
    options = EVEN | {"interpolation": "quadratic", "cure": "mean-dilatation"}
    return [*found, Variant("MPM quadratic, mean dilatation", MPM, SEEDED[dimension], options, finer=2)]


def uncured(dimension: int) -> list[Variant]:
    """The same without a cure, and MPM as it is by itself."""
    found = [Variant(f"FEM {kind}, no cure", FEM, kind, {"cure": "none"}) for kind in KINDS[dimension]]
    return [
        *found,
        Variant("MPM quadratic", MPM, SEEDED[dimension], EVEN, finer=2),
        Variant("MPM linear", MPM, SEEDED[dimension], {"interpolation": "linear"}),
    ]
