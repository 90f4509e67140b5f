"""The speed of this machine: point updates of law combinations, whole steps, start to the first step."""

import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from statistics import median
from typing import Any

import numpy as np

from core_models.material import Material
from core_models.points import MaterialPoints
from core_models.threads import Threads
from studies.bench.materials import bench_materials, yardstick_material
from studies.bench.yardstick import by_hand
from studies.methods.method import METHODS, build_solver
from studies.output.display import number
from studies.output.text_table import aligned
from studies.output.versions import processor
from studies.scenes.reader import read_scene

REPEATS = 7
STEP = 2e-8  # s
STRAIN_STEP = 2e-4  # at 1e4 1/s, as in an impact
YIELDING_STEPS = 50  # after which every point is plastic
WARM_UP_STEPS = 40
TIMED_STEPS = 30
RESOLUTION = 16
SCENES = {
    "taylor-classic": "J2, linear hardening",
    "taylor-copper-jc": "Johnson-Cook, Mie-Grüneisen, damage",
}
FIRST_STEP = """
from studies.methods.method import build_solver
from studies.scenes.reader import read_scene
build_solver(read_scene("taylor-copper-jc"), "{method}", 8, "unilateral", 1).advance()
"""


@dataclass(frozen=True)
class Speed:
    """How long something takes: the median and the fastest of some repeats, in `unit`."""

    what: str
    unit: str
    median: float
    fastest: float


def bench_text(points: int, threads: int) -> str:
    """The speed table, warm; the first time, its kernels are compiled."""
    rows = [["what", "", "median", "fastest"]]
    rows += [
        [each.what, each.unit, number(each.median, 3), number(each.fastest, 3)]
        for each in bench_speeds(points, threads)
    ]
    return f"{processor()}, threads: {threads}, {points} points\n\n{aligned(rows)}"


def bench_record(points: int, threads: int) -> dict[str, Any]:
    """The same as plain data."""
    speeds = [asdict(each) for each in bench_speeds(points, threads)]
    return {"processor": processor(), "threads": threads, "points": points, "speeds": speeds}


def bench_speeds(points: int, threads: int) -> list[Speed]:
    """Point updates of all law combinations, whole steps, start to the first step."""
    rows: list[Speed] = []
    rows += _against_the_yardstick(points, threads)
    rows += [
        _row(name, "ns / point", 1e9 / points, _point_update(material, points, threads))
        for name, material in bench_materials()
    ]
    rows += _whole_steps(threads)
    rows += [
        _row(
            f"start of the process to the first step, {method}",
            "s",
            1.0,
            [_first_step(method) for _ in range(3)],
        )
        for method in METHODS
    ]
    return rows


def _row(name: str, unit: str, scale: float, seconds: list[float]) -> Speed:
    return Speed(name, unit, scale * median(seconds), scale * min(seconds))


def _timed(call: Callable[[], object], repeats: int = REPEATS) -> list[float]:
    call()
    seconds = []
    for _ in range(repeats):
        began = time.perf_counter()
        call()
        seconds.append(time.perf_counter() - began)
    return seconds


def _against_the_yardstick(count: int, threads: int) -> Iterator[Speed]:
    """The hand-written update, and how much longer the machinery of laws takes for the same, in turns."""
    points = _yielding(yardstick_material(), count, threads)
    calls = by_hand(points, STEP), lambda: points.advance(STEP)
    hand, laws = zip(*(tuple(_timed(call, 1)[0] for call in calls) for _ in range(2 * REPEATS)), strict=True)
    yield _row(
        "hypoelastic, Johnson-Cook, Mie-Grüneisen, written by hand", "ns / point", 1e9 / count, list(hand)
    )
    yield _row("what the machinery of laws takes of that", "1", 1.0, [min(laws) / min(hand)])


def _point_update(material: Material, count: int, threads: int) -> list[float]:
    """Seconds of one three-dimensional plastic update of all points."""
    points = _yielding(material, count, threads)
    return _timed(lambda: points.advance(STEP))


def _yielding(material: Material, count: int, threads: int) -> MaterialPoints:
    """Points in plastic flow, about to make another step."""
    points = MaterialPoints(material, np.full(count, 1e-9), threads=Threads(threads))
    random = np.random.default_rng(1)
    gradient = STRAIN_STEP * (np.array([[0.3, 1.0, 0.2], [0.1, -0.5, 0.4], [0.0, 0.3, 0.1]]))
    increment = np.eye(3) + gradient * random.uniform(0.9, 1.1, (count, 1, 1))
    for _ in range(YIELDING_STEPS):
        points.deformation_gradient[:] = increment @ points.old_deformation_gradient
        points.advance(STEP)
        points.accept()
    points.deformation_gradient[:] = increment @ points.old_deformation_gradient
    return points


def _whole_steps(threads: int) -> Iterator[Speed]:
    units = {"fem-explicit": ("us / element", 4e6), "mpm": ("ns / particle", 1e9)}
    for scene_name, laws in SCENES.items():
        scene = read_scene(scene_name)
        for method, (unit, scale) in units.items():
            solver = build_solver(scene, method, RESOLUTION, "unilateral", threads)
            for _ in range(WARM_UP_STEPS):
                solver.advance()

            def steps(solver=solver) -> None:
                for _ in range(TIMED_STEPS):
                    solver.advance()

            per_point = scale / (TIMED_STEPS * solver.points.n)
            yield _row(f"whole step, {method} {RESOLUTION}, {laws}", unit, per_point, _timed(steps))


def _first_step(method: str) -> float:
    began = time.perf_counter()
    subprocess.run([sys.executable, "-c", FIRST_STEP.format(method=method)], check=True)
    return time.perf_counter() - began
