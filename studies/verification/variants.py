"""Which elements, interpolations and transfers the convergence problems try, and what is asked of each."""

from studies.verification.variant import FEM, MPM, Variant

SECOND = 1.9  # of elements and of quadratic and cubic B-splines
BEFORE_FLOOR = 1.5  # of GIMP and CPDI, before their floor

CONTROL = "MPM linear"
KINDS = {2: ("quad4", "tri3", "quad8", "quad9", "tri6"), 3: ("hex8", "tet4", "hex20", "hex27", "tet10")}
SEEDED = {2: "quad4", 3: "hex8"}  # meshes that particles are made from
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


def interpolations(dimension: int) -> list[Variant]:
    """Every interpolation with APIC."""
    return [
        Variant(f"MPM {name}", MPM, SEEDED[dimension], {"interpolation": name}, order)
        for name, order in INTERPOLATIONS.items()
    ]


def transfers(dimension: int) -> list[Variant]:
    """Quadratic B-splines with the other transfers, with MUSL and in the reference configuration."""
    options = {
        "FLIP 0.99": {"transfer": "flip"},
        "FLIP": {"transfer": "flip", "flip_fraction": 1.0},
        "PIC": {"transfer": "pic"},
        "XPIC(2)": {"transfer": "xpic", "xpic_order": 2},
        "MUSL": {"update": "musl"},
        "total": {"configuration": "total"},
    }
    found = [
        Variant(f"MPM quadratic, {name}", MPM, SEEDED[dimension], {"interpolation": "quadratic"} | more)
        for name, more in options.items()
    ]
    linear = {"interpolation": "linear", "configuration": "total"}
    return [*found, Variant("MPM linear, total", MPM, SEEDED[dimension], linear)]
