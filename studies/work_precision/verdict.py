"""Cross-check: what each variant tends to as it is refined, and whether the two methods agree in that."""

from math import hypot

from studies.comparisons.convergence import Estimate, extrapolate
from studies.comparisons.differences import verdict_text
from studies.output.display import number, plus_minus, shown_title, shown_unit
from studies.report.parts import Table
from studies.report.study_page import Section
from studies.work_precision.analysis import by_variant
from studies.work_precision.measurement import Measurement
from studies.work_precision.problem import Reference, WorkProblem


def verdict_section(problem: WorkProblem, runs: list[Measurement]) -> Section:
    """Limits of all variants by quantity, and a sentence about the first variant of each method."""
    tables, sentences = [], []
    for name, unit in problem.units.items():
        reference = problem.references[name]
        if reference.value == 0.0:
            continue
        limits = limits_of(runs, name)
        tables.append(_table(name, unit, limits, reference))
        pair = _one_of_each_method(tuple(limits))
        if len(pair) == 2:
            sentences.append(verdict_text(name, unit, pair, tuple(limits[variant] for variant in pair)))
        if reference.value is not None and pair:
            sentences.append(_against(name, unit, {each: limits[each] for each in pair}, reference))
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


def _against(name: str, unit: str, limits: dict[str, Estimate], reference: Reference) -> str:
    """How far limits are from a reference that the problem gives, by themselves and in uncertainties."""
    value = f"{plus_minus(reference.value, reference.uncertainty, unit)} {shown_unit(unit)}"
    told = []
    for variant, limit in limits.items():
        percent, times = _off(limit, reference)
        beside = "" if times is None else f", {number(times, 2)} times both uncertainties together"
        told.append(f"{variant} is off by {percent:+.2g} %{beside}")
    return f"{shown_title(name)} against {value}, {reference.source}: {'; '.join(told)}."


def _off(limit: Estimate, reference: Reference) -> tuple[float, float | None]:
    """Distance from the reference [%], and its size over the root of the sum of both uncertainties squared."""
    gap = limit.value - reference.value
    together = hypot(limit.uncertainty or 0.0, reference.uncertainty)
    is_known = limit.uncertainty is not None and together > 0.0
    return 100.0 * gap / abs(reference.value), abs(gap) / together if is_known else None


def _table(name: str, unit: str, limits: dict[str, Estimate], reference: Reference) -> Table:
    is_given = reference.value is not None
    rows = tuple(
        (
            variant,
            plus_minus(limit.value, limit.uncertainty, unit),
            *(_off(limit, reference) if is_given else ()),
            limit.order,
            limit.basis,
        )
        for variant, limit in limits.items()
    )
    off = ("off the reference [%]", "in both uncertainties") if is_given else ()
    head = ("variant", f"limit [{shown_unit(unit)}]", *off, "order", "how")
    note = "f(h) = f0 + a h^p by least squares over all resolutions, after Eça and Hoekstra (2014)."
    return Table(f"{name.replace('_', ' ')} as cells become small", head, rows, note)
