"""A comparison: one scene by several methods at several resolutions under one wall, and what it says."""

from dataclasses import dataclass, field

from studies.bar import profile
from studies.bar.shape import standing
from studies.comparisons.convergence import Estimate, extrapolate
from studies.comparisons.differences import Difference, difference
from studies.comparisons.field_maps import FieldMaps, field_maps
from studies.comparisons.reference_check import ReferenceCheck, check_references
from studies.runs.result import RunResult
from studies.scenes.scene import Scene


@dataclass(frozen=True)
class ProfileGap:
    """Root-mean-square distance between two final side lines [m], and as a share of L0."""

    first: str
    second: str
    rms: float
    relative: float


@dataclass
class Comparison:
    """All runs, with the limits of each method's sequence and what follows from them.

    maps: the two methods' final fields on one mesh, of two methods only. notice: why there is no report, if there is
    none.
    """

    scene: Scene
    wall: str
    runs: list[RunResult]
    limits: dict[str, dict[str, Estimate]] = field(default_factory=dict)
    differences: list[Difference] = field(default_factory=list)
    references: list[ReferenceCheck] = field(default_factory=list)
    profiles: list[ProfileGap] = field(default_factory=list)
    maps: FieldMaps | None = None
    notice: str = ""

    def _repr_html_(self) -> str:
        """As a notebook shows it."""
        from studies.report.notebook import comparison_html

        return comparison_html(self)

    @property
    def failed(self) -> list[RunResult]:
        """The runs that went wrong."""
        return [run for run in self.runs if run.failure is not None]

    def complete(self, method: str) -> list[RunResult]:
        """A method's completed runs, coarse to fine."""
        runs = [run for run in self.runs if run.method == method and run.failure is None]
        return sorted(runs, key=lambda run: run.resolution)

    @property
    def finest(self) -> list[RunResult]:
        """The finest completed run of each method, in the order in which the methods were asked for."""
        return [runs[-1] for method in self.methods if (runs := self.complete(method))]

    @property
    def methods(self) -> list[str]:
        """The methods, in the order in which they were asked for."""
        return list(dict.fromkeys(run.method for run in self.runs))


def conclude(scene: Scene, wall: str, runs: list[RunResult]) -> Comparison:
    """Everything that follows from the runs."""
    comparison = Comparison(scene, wall, runs)
    comparison.limits = {run.method: _limits(comparison.complete(run.method)) for run in comparison.finest}
    comparison.references = check_references(comparison.finest, comparison.limits, scene, wall)
    if len(comparison.finest) == 2:
        first, second = comparison.finest
        comparison.differences = _differences(first, second, comparison.limits)
        comparison.profiles = [_profile_gap(first, second)]
        comparison.maps = field_maps(first, second)
    return comparison


def _limits(runs: list[RunResult]) -> dict[str, Estimate]:
    resolutions = [run.resolution for run in runs]
    limits = {}
    for name in runs[-1].quantities:
        values = [run.quantities[name].value for run in runs]
        if all(value is not None for value in values):
            limits[name] = extrapolate(resolutions, values)
    return limits


def _differences(
    first: RunResult, second: RunResult, limits: dict[str, dict[str, Estimate]]
) -> list[Difference]:
    names = [name for name in limits[first.method] if name in limits[second.method]]
    return [difference(name, first, second, limits) for name in names]


def _profile_gap(first: RunResult, second: RunResult) -> ProfileGap:
    lines = [standing(run.final.outline)["side"] for run in (first, second)]
    rms = profile.distance_between(*lines)
    return ProfileGap(first.label, second.label, rms, rms / first.scene.bar.length)
