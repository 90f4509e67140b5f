"""A solver that only pretends, in place of the real ones: two points that shorten, widen, stop and bounce off."""

import errno
import os
from types import SimpleNamespace

import numpy as np
import pytest

from core_models.atomic import replacing
from core_models.errors import RunFailure
from core_models.points import Field
from meshes.io import write_domains_vtu
from studies.scenes.reader import read_scene

LENGTH, RADIUS, SPEED, DURATION = 32.4e-3, 3.2e-3, 227.0, 60e-6


class FakeSolver:
    """Uniform shortening until DURATION, then free flight upwards; `error` sets its distance from the limit."""

    initial_momentum = np.array([0.0, -2.0])
    mass, threads, time_step = 0.009, 1, 1e-6
    mesh = SimpleNamespace(dimension=2, points=np.array([[0.0, 0.0], [RADIUS, LENGTH]]))
    reference_positions = np.array([[0.5 * RADIUS, 0.25 * LENGTH], [0.5 * RADIUS, 0.75 * LENGTH]])

    def __init__(self, error: float = 0.0, wall: str = "unilateral", fails_at: float = np.inf) -> None:
        self.time, self.step_count, self.point_updates = 0.0, 0, 0
        self._error, self._wall, self._fails_at = error, wall, fails_at
        self.points = SimpleNamespace(n=2, fields=self._fields)

    @property
    def progress(self) -> float:
        """Share of the impact that is over."""
        return min(self.time / DURATION, 1.0)

    @property
    def in_contact(self) -> bool:
        """Whether the wall pushes."""
        return self._wall == "plane" or 0.0 < self.time <= DURATION

    @property
    def momentum(self) -> np.ndarray:
        """Momentum along the axis."""
        return np.array([0.0, -2.0 + 2.5 * self.progress])

    @property
    def wall_impulse(self) -> float:
        """Impulse of the wall so far."""
        return self.momentum[-1] + 2.0

    @property
    def wall_force(self) -> float:
        """Force of the wall."""
        return 2.5 / DURATION if self.in_contact else 0.0

    @property
    def ledger(self) -> SimpleNamespace:
        """Energies."""
        plastic = 200.0 * self.progress
        parts = {
            "strain": 1.0,
            "viscosity": 2.0,
            "transfer": 0.0,
            "contact": 0.0,
            "friction": 0.0,
            "hourglass": 0.0,
        }
        return SimpleNamespace(
            kinetic=237.0 - plastic, plastic=plastic, **parts, initial=240.0, relative_error=1e-3
        )

    def advance(self, limit: float = np.inf) -> None:
        """One step, which does not pass the limit."""
        self.time = min(self.time + self.time_step, limit)
        self.step_count += 1
        self.point_updates += 2
        if self.time >= self._fails_at:
            raise RunFailure(f"step {self.step_count}, t = {self.time:.3e} s, point 1: not finite (law Fake)")

    def outline(self) -> dict[str, np.ndarray]:
        """A straight cylinder."""
        z = 0.0 if self._wall == "plane" else 50.0 * max(self.time - DURATION, 0.0)
        r, top = self._size()
        return {
            "foot": np.array([[0.0, z], [r, z]]),
            "side": np.array([[r, z], [r, z + top / 2], [r, z + top]]),
            "rear": np.array([[r, z + top], [0.0, z + top]]),
        }

    def domains(self) -> np.ndarray:
        """Two halves."""
        r, top = self._size()
        lower = np.array([[0.0, 0.0], [r, 0.0], [r, top / 2], [0.0, top / 2]])
        return np.array([lower, lower + [0.0, top / 2]])

    def point_volumes(self) -> np.ndarray:
        """Two halves, which keep their volume."""
        return np.full(2, 0.5 * np.pi * RADIUS**2 * LENGTH)

    def _size(self) -> tuple[float, float]:
        stretch = 1.0 - 0.3 * self.progress * (1.0 + self._error)
        return RADIUS / np.sqrt(stretch), LENGTH * stretch

    def _fields(self) -> dict[str, Field]:
        strain = np.array([0.4, 0.1]) * self.progress * (1.0 + self._error)
        stress = np.tile([-1e8, 0.0, 0.0, 0.0, 0.0, 0.0], (2, 1))
        return {
            "deformation_gradient": Field("deformation_gradient", "1", (3, 3), np.tile(np.eye(3), (2, 1, 1))),
            "equivalent_plastic_strain": Field("equivalent_plastic_strain", "1", (), strain),
            "stress": Field("stress", "Pa", (6,), stress),
        }


@pytest.fixture
def fake_solvers(monkeypatch):
    """All methods run the pretended solver: FEM from one side, MPM from the other; resolution 13 goes wrong.

    Pictures over time, which take seconds, are left out.
    """

    def build(scene, method, resolution, wall, threads):
        fails_at = 30e-6 if resolution == 13 else np.inf
        return FakeSolver((1.0 if method == "mpm" else -0.5) / resolution, wall, fails_at)

    monkeypatch.setattr("studies.runs.running.build_solver", build)
    monkeypatch.setattr("studies.report.over_time.rendered", lambda job: None)


@pytest.fixture
def classic():
    """The shipped classic scene."""
    return read_scene("taylor-classic")


@pytest.fixture
def full_disk(monkeypatch):
    """No space for frames after the first ones, as the operating system says it."""

    def refuse(path, polygons, cell_data):
        if path.name.endswith("0005.vtu"):
            with replacing(path):
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        write_domains_vtu(path, polygons, cell_data)

    monkeypatch.setattr("meshes.io.write_domains_vtu", refuse)
