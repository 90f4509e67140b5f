"""The outcome of `matpoint drive` as plain text: what was done, a table of the history, the final state, remarks."""

from collections.abc import Iterator

import numpy as np

from core_models.driver import History
from core_models.laws import flow_stress, melting_temperature, under_pressure
from core_models.loading import STRESS_COLUMN
from studies.drive.columns import SYMMETRIC
from studies.drive.driving import DriveResult, MaterialTest
from studies.output.text_table import aligned

ROWS = 10
MEGA = 1e-6
NOTHING = 1e-9  # of the flow stress at room temperature
TOLERANCE = 1e-8  # of the largest stress: what free components are zero to
HEADINGS = {  # field: heading, factor; other scalars go by their own names
    "equivalent_plastic_strain": ("plastic strain", 1.0),
    "hardening_variable": ("hardening MPa", MEGA),
    "temperature": ("temperature K", 1.0),
    "internal_energy": ("internal energy MJ/m^3", MEGA),
}


def drive_text(result: DriveResult) -> str:
    """All of it."""
    parts = [_head(result.test), aligned(_table(result)), aligned(list(_final(result)))]
    parts += ["\n".join(f"remark: {remark}" for remark in remarks(result))]
    return "\n\n".join(part for part in parts if part)


def _head(test: MaterialTest) -> str:
    laws = ", ".join(type(law).__name__ for law in test.material.laws)
    heat = "adiabatic" if test.material.heating is not None else "no heating"
    start = f", from {test.temperature:g} K, {heat}" if test.material.needs_temperature else ""
    steps = sum(segment.steps for segment in test.program.segments)
    duration = _shown(test.program.time_steps.sum())
    return f"{test.material.name}: {laws}\n{test.words}\n{steps} steps in {duration} s{start}"


def shown_columns(result: DriveResult) -> dict[str, np.ndarray]:
    """What the table shows by heading: time, strain, stresses [MPa], and the scalars of the state."""
    path, history = result.test.path, result.history
    stress = settled(history.stress) * MEGA
    found = {"time s": history.times}
    if path is None:
        found |= {f"s{name} MPa": stress[:, k] for k, name in enumerate(SYMMETRIC)}
    else:
        found[path.strain] = path.measure(history.deformation_gradient)
        found[f"s{SYMMETRIC[path.stress]} MPa"] = stress[:, path.stress]
    found |= {"mises MPa": history.mises * MEGA, "pressure MPa": history.pressure * MEGA}
    found |= scalars(history)
    found.pop(HEADINGS["internal_energy"][0], None)
    return found


def scalars(history: History) -> dict[str, np.ndarray]:
    """The scalar fields of the state by heading (k,)."""
    found = {}
    for name, values in history.fields.items():
        if values.ndim == 1:
            heading, factor = HEADINGS.get(name, (name.replace("_", " "), 1.0))
            found[heading] = values * factor
    return found


def _table(result: DriveResult) -> list[list[str]]:
    found = shown_columns(result)
    rows = _shown_rows(result.test)
    return [list(found), *([_shown(values[row]) for values in found.values()] for row in rows)]


def _shown_rows(test: MaterialTest) -> list[int]:
    """Some even rows of each segment and its end; of very many segments, some ends."""
    ends = np.cumsum([segment.steps for segment in test.program.segments])
    parts = max(ROWS // len(ends), 1)
    rows = {0}
    for first, last in zip([0, *ends[:-1]], ends, strict=True):
        rows |= {round(first + (last - first) * k / parts) for k in range(1, parts + 1)}
    kept = sorted(rows)
    if len(kept) > 2 * ROWS:
        kept = [kept[round(k * (len(kept) - 1) / (2 * ROWS))] for k in range(2 * ROWS + 1)]
    return [int(row) for row in kept]


def _final(result: DriveResult) -> Iterator[list[str]]:
    history = result.history
    yield ["final state", "", "", ""]
    yield from _matrix("  deformation gradient", history.deformation_gradient[-1])
    yield from _matrix("  stress MPa", settled(history.stress)[-1][STRESS_COLUMN] * MEGA)
    for heading, values in scalars(history).items():
        yield [f"  {heading}", _shown(values[-1]), "", ""]
    yield ["  volume ratio J", _shown(np.linalg.det(history.deformation_gradient[-1])), "", ""]
    yield ["  stress work MJ/m^3", _shown(history.stress_work[-1] * MEGA), "", ""]
    yield ["  dissipated MJ/m^3", _shown(history.plastic[-1] * MEGA), "", ""]


def settled(stress: np.ndarray) -> np.ndarray:
    """Stresses without what is left of a free component: zero where they are below the tolerance of the controls."""
    return np.where(np.abs(stress) > TOLERANCE * np.abs(stress).max(), stress, 0.0)


def _matrix(name: str, values: np.ndarray) -> Iterator[list[str]]:
    kept = np.where(np.abs(values) > TOLERANCE * np.abs(values).max(), values, 0.0)
    for row, label in zip(kept, (name, "", ""), strict=True):
        yield [label, *(_shown(value) for value in row)]


def _shown(value: float) -> str:
    return f"{value:.5g}"


def remarks(result: DriveResult) -> Iterator[str]:
    """What a table hides: no yielding, melting, strength lost to heat, damage that is complete."""
    material, fields = result.test.material, result.history.fields
    plastic = fields.get("equivalent_plastic_strain")
    if plastic is not None and plastic[-1] == 0.0:
        yield "the point has not yielded"
    temperature = fields.get("temperature")
    if temperature is not None:
        melted = np.flatnonzero(temperature >= melting_temperature(material.melting))
        if melted.size:
            yield (
                f"the point has melted at t = {_shown(result.history.times[melted[0]])} s, "
                f"{_shown(temperature[melted[0]])} K: from there on it has no strength"
            )
        weak = _without_strength(result)
        if weak.size and not melted.size:
            yield (
                f"heat has taken all strength at t = {_shown(result.history.times[weak[0]])} s, "
                f"{_shown(temperature[weak[0]])} K: there the flow law gives no stress"
            )
    damage = fields.get("damage")
    if damage is not None and damage[-1] >= 1.0:
        failed = np.flatnonzero(damage >= 1.0)[0]
        acts = (
            "which acts on the stress" if material.erosion is not None else "which does not act: no erosion"
        )
        yield f"damage has reached 1 at t = {_shown(result.history.times[failed])} s, {acts}"


def _without_strength(result: DriveResult) -> np.ndarray:
    """Rows whose temperature leaves no flow stress where room temperature leaves some."""
    material, fields = result.test.material, result.history.fields
    if material.flow is None:
        return np.empty(0, dtype=int)
    flow = under_pressure(material.flow, 1.0, 0.0, melting_temperature(material.melting))
    strain, temperature = fields["equivalent_plastic_strain"], fields["temperature"]
    variable = fields.get("hardening_variable", np.zeros(len(strain)))
    room = np.full(len(strain), material.room_temperature)
    hot, cold = (
        np.array(
            [flow_stress(flow, v, p, 0.0, t)[0] for v, p, t in zip(variable, strain, kelvin, strict=True)]
        )
        for kelvin in (temperature, room)
    )
    return np.flatnonzero((cold > 0.0) & (hot <= NOTHING * cold))
