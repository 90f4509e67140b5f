"""Cross-check: what each variant tends to as it is refined, and whether the two methods agree in that."""

from studies.comparisons.convergence import Estimate, extrapolate
from studies.comparisons.differences import verdict_text
from studies.output.display import plus_minus, shown_unit
from studies.report.parts import Table
from studies.report.study_page import Section
from studies.work_precision.analysis import by_variant
from studies.work_precision.measurement import Measurement
from studies.work_precision.problem import WorkProblem


def verdict_section(problem: WorkProblem, runs: list[Measurement]) -> Section:
    """Limits of all variants by quantity, and a sentence about the first variant of each method."""
    tables, sentences = [], []
    for name, unit in problem.units.items():
        if problem.references[name].value == 0.0:
            continue
        limits = limits_of(runs, name)
        tables.append(_table(name, unit, limits))
        pair = _one_of_each_method(tuple(limits))
        if len(pair) == 2:
            sentences.append(verdict_text(name, unit, pair, tuple(limits[variant] for variant in pair)))
    return Section("verdict", "Do the methods agree?", tuple(tables), remarks=tuple(sentences))


def limits_of(runs: list[Measurement], quantity: str) -> dict[str, Estimate]:
    """Extrapolated value of each variant."""
    return {
        variant: extrapolate([run.resolution for run in group], [run.values[quantity] for run in group])
        for variant, group in by_variant(runs).items()
    }


def _one_of_each_method(variants: tuple[str, ...]) -> tuple[str, ...]:
    first = {variant.startswith("fem"): variant for variant in reversed(variants)}
    return tuple(variant for variant in variants if variant in first.values())


def _table(name: str, unit: str, limits: dict[str, Estimate]) -> Table:
    rows = tuple(
        (
            variant,
            plus_minus(limit.value, limit.uncertainty, unit),
            limit.order,
            limit.basis,
        )
        for variant, limit in limits.items()
    )
    head = ("variant", f"limit [{shown_unit(unit)}]", "order", "how")
    note = "f(h) = f0 + a h^p by least squares over all resolutions, after Eça and Hoekstra (2014)."
    return Table(f"{name.replace('_', ' ')} as cells become small", head, rows, note)
