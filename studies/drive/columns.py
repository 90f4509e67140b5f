"""A history as named columns of numbers in SI units, for tables and files."""

import numpy as np

from core_models.driver import History
from core_models.material import Material
from core_models.points import MaterialPoints

SYMMETRIC = ("11", "22", "33", "12", "23", "31")
FULL = tuple(f"{i}{j}" for i in "123" for j in "123")
ENDINGS = {3: ("1", "2", "3"), 6: SYMMETRIC, 9: FULL}
LEADING = ("deformation_gradient", "stress")


def columns(history: History, material: Material) -> dict[str, np.ndarray]:
    """Every quantity of a history by 'name [unit]', (k,): time, F, stress and what follows from it, state, energies."""
    units = {name: field.unit for name, field in MaterialPoints(material, np.ones(1)).fields().items()}
    found = {"time [s]": history.times}
    for name in LEADING:
        found |= _components(name, history.fields[name], units[name])
    found |= {"pressure [Pa]": history.pressure, "mises [Pa]": history.mises}
    for name, values in history.fields.items():
        if name not in LEADING:
            found |= _components(name, values, units[name])
    return found | {
        "stress_work [J/m^3]": history.stress_work,
        "plastic_dissipation [J/m^3]": history.plastic,
        "wave_speed [m/s]": history.wave_speed,
    }


def csv_text(history: History, material: Material) -> str:
    """The columns as comma-separated values, one row per step, ten digits."""
    found = columns(history, material)
    rows = np.stack(list(found.values()), axis=1)
    lines = [",".join(found), *(",".join(f"{value:.10g}" for value in row) for row in rows)]
    return "\n".join(lines) + "\n"


def _components(name: str, values: np.ndarray, unit: str) -> dict[str, np.ndarray]:
    if values.ndim == 1:
        return {f"{name} [{unit}]": values}
    flat = values.reshape(len(values), -1)
    endings = ENDINGS[flat.shape[1]]
    return {f"{name}_{ending} [{unit}]": flat[:, k] for k, ending in enumerate(endings)}
