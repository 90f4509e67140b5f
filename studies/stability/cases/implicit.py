"""Quasi-static bodies in increments that are far too large."""

from collections.abc import Callable
from typing import Any

from core_models.loads import Prescribed, Symmetry
from core_models.material import Material
from meshes.mesh import Mesh
from studies.stability.bodies import (
    ACROSS,
    ASPECT,
    RADIUS,
    bar_mesh,
    classic,
    copper,
    elastic,
    hardening,
    softening,
    square,
    stiff,
)
from studies.stability.case import Case
from studies.stability.variants import variant_of

SHARE = 0.2  # by which the bar is drawn out
INCREMENTS = 4  # where 40 do well
DRIFT = 10.0  # of so large an increment the external work is a trapezoid's, far from what the stress does


def _solver(variant: str, mesh: Mesh, material: Material, loads: tuple, **options: Any) -> Any:
    asked = variant_of(variant)
    options = asked.options | options | {"loads": loads, "increment": 1.0 / INCREMENTS}
    if asked.solver == "fem-implicit":
        from fem import ImplicitSolver

        return ImplicitSolver(mesh, material, **options)
    from mpm import ImplicitSolver

    return ImplicitSolver(mesh, material, cell_size=RADIUS / ACROSS, **options)


def _drawn(material: Callable[[], Material], share: float = SHARE, **options: Any) -> Callable[[str], Any]:
    """A bar drawn out by a share of its length, held sideways at its rear."""
    speed = share * ASPECT * RADIUS
    loads = (Symmetry("foot"), Prescribed("rear", 0, 0.0), Prescribed("rear", 1, speed))
    return lambda variant: _solver(variant, bar_mesh(variant), material(), loads, **options)


def _swollen(variant: str) -> Any:
    """A bar held sideways all along it and drawn out: nothing but its volume can give way."""
    loads = (Symmetry("foot"), Prescribed("side", 0, 0.0), Prescribed("rear", 1, 0.3 * ASPECT * RADIUS))
    return _solver(variant, bar_mesh(variant), copper(), loads)


def _distorted(variant: str) -> Any:
    """A block of distorted elements, held at the bottom and sheared."""
    loads = (
        Symmetry("bottom"),
        Prescribed("bottom", 0, 0.0),
        Prescribed("top", 1, 0.0),
        Prescribed("top", 0, SHARE * RADIUS),
    )
    return _solver(variant, square(variant, distortion=0.2), classic(), loads, geometry="plane-strain")


CASES = tuple(
    Case(name, title, build, 1.0, drift=DRIFT, implicit=True)
    for name, title, build in (
        ("implicit-large", "A bar drawn out by a fifth in four increments", _drawn(classic)),
        ("implicit-soft", "The same with a yield stress of 1 Pa", _drawn(lambda: hardening(1.0, 0.0))),
        (
            "implicit-softening",
            "The same with a flow stress that falls to next to nothing",
            _drawn(softening),
        ),
        ("implicit-melted", "The same of copper above melting", _drawn(copper, temperature=1400.0)),
        (
            "implicit-locking",
            "The same with a bulk modulus a thousand times the shear modulus",
            _drawn(stiff),
        ),
        ("implicit-apart", "An elastic bar drawn to three times its length", _drawn(elastic, 2.0)),
        ("implicit-pressed", "An elastic bar pressed to half its length", _drawn(elastic, -0.5)),
        ("implicit-tension", "Held sideways and drawn to J = 1.3", _swollen),
        ("implicit-distorted", "A block of distorted elements, sheared", _distorted),
    )
)
