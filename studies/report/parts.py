"""Parts of a report: tables, plots and pictures, before they are drawn."""

from dataclasses import dataclass

import numpy as np

FEM, MPM, EXACT = "fem", "mpm", "exact"
"""Families of curves, which give their colours."""

Cell = str | float | int | None


@dataclass(frozen=True)
class Table:
    """Numbers and words; the first column names the row."""

    title: str
    head: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]
    note: str = ""


@dataclass(frozen=True)
class Curve:
    """One line of a plot. family : FEM, MPM or EXACT."""

    label: str
    x: tuple[float, ...]
    y: tuple[float, ...]
    family: str


@dataclass(frozen=True)
class Plot:
    """Curves over one pair of axes. scattered : their points belong to no order, and no line connects them."""

    title: str
    x_label: str
    y_label: str
    curves: tuple[Curve, ...]
    logarithmic: bool = False
    scattered: bool = False


@dataclass(frozen=True)
class Picture:
    """A field on a deformed body, or on several side by side.

    label : of the values. panels : name -> domains (n, 4, 2) [m] and values (n,). limits : of the colours, or None for
    the smallest and the largest value.
    """

    title: str
    label: str
    panels: dict[str, tuple[np.ndarray, np.ndarray]]
    limits: tuple[float, float] | None = None
