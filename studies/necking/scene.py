"""A necking scene as plain data: what is pulled and how far, which runs are made of it, what they must show."""

from dataclasses import dataclass, field
from pathlib import Path

from core_models.material import Material

ROUND_BAR, SQUARE_BAR, STRIP = "round-bar", "square-bar", "strip"
USUAL = "quad4"
COUNTS = ("cuts", "kinetic_share", "strained_share")
"""Quantities of a run that are not of its history."""


@dataclass(frozen=True)
class PlannedRun:
    """One run of a scene.

    name : in the scene. method : of `studies.necking.methods`. across, along : elements, for material points cells, in
    the radius and along the half; grading : size at the neck over that at the end. kind : of the elements.
    increments : of an implicit run. periods : of the lowest natural mode that an explicit one takes, 0 for the real
    time and density. conduction : whether heat is conducted. body, radius, taper, update, duration, damage_radius : in
    place of the scene's, damage_radius 0 for local damage; erosion 'delete': failed points are out, which an
    equilibrium cannot bear. options : of the solver.
    quick : whether `--quick` makes it; extra : whether it is made only when asked for by name. note : said of it in the
    report.
    """

    name: str
    method: str
    across: int
    along: int
    grading: float = 1.0
    kind: str = USUAL
    increments: int = 0
    periods: float = 0.0
    body: str | None = None
    radius: float | None = None
    taper: float | None = None
    update: str | None = None
    duration: float | None = None
    damage_radius: float | None = None
    conduction: bool = False
    erosion: str | None = None
    options: dict[str, str | float] = field(default_factory=dict)
    quick: bool = False
    extra: bool = False
    note: str = ""

    @property
    def solver_options(self) -> dict[str, str | float | bool]:
        """Arguments of the solver."""
        return {**self.options, "conduction": True} if self.conduction else dict(self.options)

    @property
    def label(self) -> str:
        """Name, mesh and, of an implicit run, its increments."""
        mesh = f"{self.across} × {self.along}" + ("" if self.kind == USUAL else f" {self.kind}")
        mesh += "" if self.grading == 1.0 else f" graded {self.grading:g}"
        return f"{self.name}, {mesh}" + (f", {self.increments} increments" if self.increments else "")


@dataclass(frozen=True)
class Expected:
    """A quantity of a run must lie within bounds, in SI. at : elongation [m], for a column of the history."""

    run: str
    quantity: str
    low: float
    high: float
    at: float | None = None
    source: str = ""


@dataclass(frozen=True)
class Agreement:
    """A quantity of a run must be within a relative distance of another run's."""

    run: str
    other: str
    quantity: str
    within: float
    at: float | None = None


@dataclass(frozen=True)
class Nearness:
    """A column of a run must be within a relative distance of a reference curve between two elongations [m]."""

    run: str
    curve: str
    quantity: str
    within: float
    beyond: float
    up_to: float


@dataclass(frozen=True)
class Limits:
    """Two families of runs, each of growing resolution, must have the same limit within what is uncertain."""

    runs: tuple[str, ...]
    others: tuple[str, ...]
    quantity: str
    at: float | None = None


@dataclass(frozen=True)
class NewtonOrder:
    """The order of Newton's method must be so high in all attempts that qualify."""

    run: str
    least: float


@dataclass(frozen=True)
class UniformPeak:
    """The largest force must be that of a bar which stays a cylinder, within a relative distance."""

    run: str
    within: float


Check = Expected | Agreement | Nearness | Limits | NewtonOrder | UniformPeak


@dataclass(frozen=True)
class NeckingCurve:
    """A curve from elsewhere: columns of a CSV file in SI by the names of the history's."""

    label: str
    path: Path
    columns: dict[str, str]


@dataclass(frozen=True)
class NeckingScene:
    """A body pulled at both ends, of which half is simulated.

    body : 'round-bar', 'square-bar' or 'strip'; of the latter two radius is half the width. radius, length (of the
    half), pull (of each end) [m]; taper: radius at the neck over that at the end; held: whether the ends cannot
    contract; duration [s].
    """

    name: str
    material: Material
    radius: float
    length: float
    taper: float
    pull: float
    duration: float = 1.0
    body: str = ROUND_BAR
    held: bool = False
    title: str = ""
    description: str = ""
    source: str = ""
    runs: tuple[PlannedRun, ...] = ()
    checks: tuple[Check, ...] = ()
    curves: tuple[NeckingCurve, ...] = ()
