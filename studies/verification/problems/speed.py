"""Speed and memory: whole steps of both methods, warm."""

import os
import tracemalloc
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.flow.johnson_cook import JohnsonCook
from core_models.heating.taylor_quinney import TaylorQuinney
from core_models.material import Material
from core_models.melting.constant import ConstantMelting
from core_models.specific_heat.constant import ConstantSpecificHeat
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.von_mises import VonMises
from meshes.block import block
from meshes.mesh import Mesh
from studies.report.parts import FEM, MPM, Table
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem
from studies.verification.thread_clock import ThreadClock
from studies.verification.variant import Variant, attempt

CELL = 1e-4  # m
RATE = 1e5  # 1/s, of isochoric compression along z: every point flows, and inertia keeps all of a small body at it
POINTS_PER_CELL = 8
WARM_STEPS, TIMED_STEPS, REPEATS = 15, 2, 5  # the body yields in the first
SIDES = {False: (11, 23, 50, 79), True: (11, 23)}  # cells: 1e4, 1e5, 1e6 and 4e6 particles; 1e4 and 1e5
ELEMENT_SIDE = 23
COMPILING_SIDE = 4  # of a run that is not reported, in which everything is compiled
MOST_NS, MOST_US, MOST_BYTES = 350.0, 3.0, 700.0  # per particle, per element, per particle
FLAT, TWO_THREADS = 0.15, 1.6

PARTICLES = Variant("MPM quadratic, APIC", MPM, "hex8")
TOTAL = Variant("MPM quadratic, APIC, total", MPM, "hex8", {"configuration": "total"})
ELEMENTS = Variant("FEM hex8", FEM, "hex8")


class Cost(NamedTuple):
    """Of one step: seconds of processor time (the least of several), points, bytes the solver holds per point."""

    seconds: float
    points: int
    bytes_per_point: float


def copper() -> Material:
    """Johnson-Cook copper with a Mie-Grüneisen equation of state, heating and melting."""
    eos = MieGruneisen(8930.0, 3940.0, 2.02, 1.489)
    return Material(
        "copper",
        8930.0,
        HypoelasticPlastic(),
        IsotropicElastic(136.35e9, 45.45e9),
        eos,
        JohnsonCook(89.6e6, 292e6, 0.025, 0.31, 1.09, 1.0, 294.0, 1356.0),
        VonMises(),
        melting=ConstantMelting(1356.0),
        specific_heat=ConstantSpecificHeat(383.0),
        heating=TaylorQuinney(0.9),
    )


def cube(side: int) -> Callable[[float, str], Mesh]:
    """Makes a cube of so many cells along each side."""
    return lambda size, kind: block([0.0] * 3, [side * size] * 3, [side] * 3, kind)


def cost(variant: Variant, side: int, threads: int = 1) -> Cost:
    """Whole steps of a cube that is squeezed along z while it spreads along x and y."""
    tracemalloc.start()
    rates = RATE * np.array([0.5, 0.5, -1.0])
    solver = variant.solver(
        cube(side), copper(), CELL, velocity=lambda places: places * rates, threads=threads
    )
    for _ in range(WARM_STEPS):
        solver.advance()
    mesh = solver.mesh
    shared = mesh.points.nbytes + mesh.cells.nbytes
    held = tracemalloc.get_traced_memory()[0] - shared
    tracemalloc.stop()
    seconds, clock = [], ThreadClock(solver.threads)
    for _ in range(REPEATS):
        began = clock.read()
        for _ in range(TIMED_STEPS):
            solver.advance()
        seconds.append((clock.read() - began) / TIMED_STEPS)
    return Cost(min(seconds), solver.points.n, held / solver.points.n)


def run(quick: bool) -> Outcome:
    """Particles from 10^4 to 4 10^6, elements, two threads, total against updated Lagrangian."""
    sides = SIDES[quick]
    large = _large(sides)
    jobs = {(PARTICLES.label, side, 1): PARTICLES for side in sides}
    jobs |= {
        (TOTAL.label, large, 1): TOTAL,
        (ELEMENTS.label, sides[0], 1): ELEMENTS,
        (ELEMENTS.label, ELEMENT_SIDE, 1): ELEMENTS,
    }
    if (os.cpu_count() or 1) > 1:
        jobs[(PARTICLES.label, large, 2)] = PARTICLES
    attempt([PARTICLES, TOTAL, ELEMENTS], lambda variant: cost(variant, COMPILING_SIDE))
    costs, outcome = {}, Outcome()
    for key, variant in jobs.items():
        done, refused = attempt([variant], lambda variant, at=key: cost(variant, at[1], at[2]))
        outcome.remarks += [f"{each.variant.label}, {key[1]} cells: {each.reason}" for each in refused]
        if done:
            costs[key] = done[variant.label]
    outcome.criteria = _criteria(costs, sides)
    rows = tuple(_row(*key, found) for key, found in costs.items())
    head = ("variant", "threads", "points", "ns per point", "µs per cell", "bytes per point")
    note = (
        f"Johnson-Cook, Mie-Grüneisen, heating, every point flows. Processor time, the least of {REPEATS} times "
        f"{TIMED_STEPS} steps; with two threads that of the one which computes longer. Bytes: what the solver holds "
        "beside the mesh; for elements per quadrature point."
    )
    outcome.tables.append(Table("Whole steps in three dimensions", head, rows, note))
    return outcome


def _large(sides: tuple[int, ...]) -> int:
    """The size that is judged: 10^6 particles, or quickly 10^5."""
    return sides[2] if sides[2:] else sides[-1]


def _criteria(costs: dict, sides: tuple[int, ...]) -> list[Criterion]:
    large = _large(sides)
    particle = {side: _ns(costs.get((PARTICLES.label, side, 1))) for side in sides}
    spread = max(particle.values()) / min(particle.values()) - 1.0 if all(particle.values()) else None
    element = costs.get((ELEMENTS.label, ELEMENT_SIDE, 1))
    one, two = costs.get((PARTICLES.label, large, 1)), costs.get((PARTICLES.label, large, 2))
    return [
        Criterion(f"MPM, {POINTS_PER_CELL * large**3:,} particles", particle[large], high=MOST_NS, unit="ns"),
        Criterion(
            "MPM, spread of the cost per particle over all sizes", _percent(spread), high=100.0 * FLAT, unit="%"
        ),
        Criterion(
            "MPM, memory per particle", one.bytes_per_point if one else None, high=MOST_BYTES, unit="bytes"
        ),
        Criterion(
            "FEM, hexahedra of 8 points", _us(element), high=MOST_US, unit="µs"
        ),
        Criterion(
            "MPM, two threads against one", one.seconds / two.seconds if one and two else None,
            low=TWO_THREADS, reason="one processor",
        ),
    ]  # fmt: skip


def _ns(found: Cost | None) -> float | None:
    return 1e9 * found.seconds / found.points if found else None


def _us(found: Cost | None) -> float | None:
    return 1e6 * found.seconds / found.points * POINTS_PER_CELL if found else None


def _percent(value: float | None) -> float | None:
    return None if value is None else 100.0 * value


def _row(label: str, side: int, threads: int, found: Cost) -> tuple:
    return label, threads, found.points, _ns(found), _us(found), found.bytes_per_point


PROBLEM = Problem(
    "speed",
    "Speed and memory",
    "Whole steps in three dimensions on this machine: time per particle and per element, its growth with the number of "
    "particles, two threads against one, memory, total against updated Lagrangian.",
    "this machine",
    run,
)
