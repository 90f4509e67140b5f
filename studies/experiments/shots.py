"""The Taylor shots: 85 cylinders of copper, aluminium and steel that hit a rigid wall, and what was measured on them.

Source: github.com/bbanerjee/HighRateExptData (MIT licence), TaylorData/DAT, which collects and digitises Wilkins &
Guinan, J. Appl. Phys. 44 (1973) 1200; Gust, J. Appl. Phys. 53 (1982) 3566; Johnson & Cook, 7th Int. Symp. Ballistics
(1983) 541; Zerilli & Armstrong, J. Appl. Phys. 61 (1987) 1816; Jones, Gillis & Foster, J. Appl. Phys. 61 (1987) 499.
Converted to SI. Two independent digitisations of the same shots differ by 0.3 to 2.7 % (`MEASURED_SCATTER`).
"""

import csv
from dataclasses import dataclass
from functools import cache
from importlib.resources import files

import numpy as np

MEASURED_SCATTER = 0.003, 0.027
MEASURED = ("final_length", "foot_diameter", "diameter_at_02_L0", "undeformed_length")


@dataclass(frozen=True)
class Shot:
    """One shot: its name, its metal, how it began, and what was measured afterwards.

    temperature [K], velocity [m/s], length, diameter [m]. measured : of MEASURED [m], those that were.
    profile : the final half profile (k, 2) in (r, z) [m] from the foot's rim to the rear's, or None.
    """

    name: str
    material: str
    temperature: float
    velocity: float
    length: float
    diameter: float
    measured: dict[str, float]
    profile: np.ndarray | None


@cache
def read_shots() -> tuple[Shot, ...]:
    """All shots, in the order of the source."""
    data = files("studies.experiments").joinpath("data")
    rows = csv.DictReader(data.joinpath("taylor_shots.csv").read_text(encoding="utf-8").splitlines())
    return tuple(_shot(row, data.joinpath("profiles")) for row in rows)


def _shot(row: dict[str, str], profiles) -> Shot:
    numbers = {name: float(row[name]) for name in ("temperature", "velocity", "length", "diameter")}
    measured = {name: float(row[name]) for name in MEASURED if row[name]}
    return Shot(row["shot"], row["material"], **numbers, measured=measured, profile=_profile(row, profiles))


def _profile(row: dict[str, str], profiles) -> np.ndarray | None:
    path = profiles.joinpath(f"{row['shot']}.csv")
    if not path.is_file():
        return None
    line = np.loadtxt(path.read_text(encoding="utf-8").splitlines(), delimiter=",", skiprows=1)
    return line[line[:, 0] > 0.0]
