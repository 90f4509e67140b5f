"""Loading programs for the usual tests of a material: one strain goes up, or to and fro, at a given rate."""

import math
from collections.abc import Callable, Iterable, Sequence

from core_models.errors import SceneError
from core_models.loading import Control, Deformation, is_count, is_number
from core_models.loading_condition import LARGEST_CHANGE
from core_models.loading_program import FREE, Program, Segment

Rates = float | Sequence[float]
Strain = Callable[[float], float]


def uniaxial_stress(strain: float, rate: Rates, steps: int = 100, cycles: int = 0) -> Program:
    """Tension (strain > 0) or compression along x with free sides: F_11 = exp(strain), s22 = s33 = 0, no shear stress.

    Parameters
    ----------
    strain : true strain [-], not 0: where a single loading ends, or the amplitude of the cycles.
    rate : true strain rate [1/s], > 0; of several, each holds for an equal share of every way up or down.
    steps : from zero to `strain`, >= 1. cycles : whole cycles after the first loading, each from +strain to -strain
    and back.

    Raises SceneError : values that make no sense, and steps of more than 0.5.
    """
    return _program(_uniaxial_stress, strain, rate, steps, cycles)


def uniaxial_strain(strain: float, rate: Rates, steps: int = 100, cycles: int = 0) -> Program:
    """Tension or compression along x with sides that cannot move: F = diag(exp(strain), 1, 1). See uniaxial_stress."""
    return _program(_uniaxial_strain, strain, rate, steps, cycles)


def plane_strain(strain: float, rate: Rates, steps: int = 100, cycles: int = 0) -> Program:
    """Tension or compression along x, free along y, held along z: s22 = 0, F_33 = 1. See uniaxial_stress."""
    return _program(_plane_strain, strain, rate, steps, cycles)


def biaxial(strain: float, rate: Rates, steps: int = 100, cycles: int = 0) -> Program:
    """The same stretch along x and y, free along z: F_11 = F_22 = exp(strain), s33 = 0. See uniaxial_stress."""
    return _program(_biaxial, strain, rate, steps, cycles)


def simple_shear(strain: float, rate: Rates, steps: int = 100, cycles: int = 0) -> Program:
    """Shear along x in planes normal to y: F = 1 + gamma e_x e_y, gamma = strain. See uniaxial_stress."""
    return _program(_simple_shear, strain, rate, steps, cycles)


def volumetric(strain: float, rate: Rates, steps: int = 100, cycles: int = 0) -> Program:
    """The same stretch in all directions: F = exp(strain / 3) 1, ln J = strain. See uniaxial_stress."""
    return _program(_volumetric, strain, rate, steps, cycles)


def cyclic(strain: float, rate: Rates, steps: int = 100, cycles: int = 1) -> Program:
    """Uniaxial stress to and fro between true strains +strain and -strain. See uniaxial_stress."""
    return _program(_uniaxial_stress, strain, rate, steps, cycles)


def _uniaxial_stress(strain: Strain) -> dict[str, Control]:
    return FREE | {"11": Deformation(_exponential(strain))}


def _uniaxial_strain(strain: Strain) -> dict[str, Control]:
    return {"11": Deformation(_exponential(strain))}


def _plane_strain(strain: Strain) -> dict[str, Control]:
    return {"11": Deformation(_exponential(strain)), "22": FREE["22"], "12": FREE["12"]}


def _biaxial(strain: Strain) -> dict[str, Control]:
    stretch = Deformation(_exponential(strain))
    return FREE | {"11": stretch, "22": stretch}


def _simple_shear(strain: Strain) -> dict[str, Control]:
    return {"12": Deformation(strain)}


def _volumetric(strain: Strain) -> dict[str, Control]:
    stretch = Deformation(_exponential(lambda t: strain(t) / 3.0))
    return dict.fromkeys(("11", "22", "33"), stretch)


def _exponential(strain: Strain) -> Strain:
    return lambda t: math.exp(strain(t))


def _program(
    mode: Callable[[Strain], dict[str, Control]], strain: float, rate: Rates, steps: int, cycles: int
) -> Program:
    rates = tuple(rate) if isinstance(rate, Iterable) else (rate,)
    _check(strain, rates, steps, cycles)
    corners = [0.0, strain] + [-strain, strain] * cycles
    segments = []
    for begin, end in zip(corners, corners[1:], strict=False):
        for part, own in enumerate(rates):
            low, high = ((begin * (len(rates) - k) + end * k) / len(rates) for k in (part, part + 1))
            share = abs((high - low) / strain)
            ramp = _ramp(low, high, abs(high - low) / own)
            segments.append(
                Segment(abs(high - low) / own, max(math.ceil(steps * share - 1e-9), 1), mode(ramp))
            )
    return Program(segments)


def _ramp(low: float, high: float, duration: float) -> Strain:
    return lambda t: low * (1.0 - t / duration) + high * (t / duration)


def _check(strain: float, rates: Sequence[float], steps: int, cycles: int) -> None:
    if not is_number(strain) or strain == 0.0:
        raise SceneError(f"a strain to go to must be a number other than 0, not {strain!r}")
    if not rates or not all(is_number(rate) and rate > 0.0 for rate in rates):
        told = ", ".join(str(rate) for rate in rates) or "none"
        raise SceneError(
            f"strain rates must be positive, not {told} /s; the strain's sign tells the direction"
        )
    if not is_count(steps, 1):
        raise SceneError(f"a path takes a whole number of steps, 1 or more, not {steps!r}")
    if abs(strain) > LARGEST_CHANGE * steps:
        raise SceneError(
            f"a strain of {strain:g} in {steps} steps is {abs(strain) / steps:.4g} a step, more than "
            f"{LARGEST_CHANGE:g}: take {math.ceil(abs(strain) / LARGEST_CHANGE)} steps or more"
        )
    if not is_count(cycles, 0):
        raise SceneError(f"the number of cycles must be whole and not negative, not {cycles!r}")
