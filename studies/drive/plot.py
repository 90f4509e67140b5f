"""A picture of a material test: stresses, plastic strain, temperature and damage over the strain or the time."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from core_models.atomic import replacing
from core_models.errors import SceneError, UnsupportedError
from core_models.names import suggestion
from studies.drive.columns import SYMMETRIC
from studies.drive.driving import DriveResult
from studies.drive.text import MEGA, scalars, settled
from studies.output.display import shown_title
from studies.report.drawing import FAINT, GRID, INK, PANEL, STYLE

FORMATS = (".svg", ".png", ".pdf")
PAPER = {INK: "#1b1f24", FAINT: "#69727d", GRID: "#e3e6ea"}  # the light colours of the report
BLUE, ORANGE, GREY = "#1f6feb", "#d9580d", "#8c8c8c"
OTHERS = ("#2a9d8f", "#9467bd", "#b8860b", "#d18cc0", "#6b8e23", "#3b7dd8")
SHARES = {"plastic strain": BLUE, "damage": ORANGE}
UNSHOWN = ("internal energy MJ/m^3", "hardening MPa")
DASHES = ("-", (0, (4, 2)), (0, (1, 1.5)))  # lines of equal values show both
TOLD = 0.01  # of the largest stress: a smaller component gets no line

Line = tuple[str, np.ndarray, str]  # name, values, colour
Axis = tuple[str, np.ndarray]  # label, values
Panel = tuple[str, Axis, list[Line]]  # title, abscissa, lines


def check_format(path: str | Path) -> None:
    """Refuse a file whose ending names no picture."""
    ending = Path(path).suffix.lower()
    if ending not in FORMATS:
        raise SceneError(f"{path}: a picture's file ends in one of these; {suggestion(ending, FORMATS)}")


def write_plot(result: DriveResult, path: str | Path) -> None:
    """Draw the test into a file, atomically. Raises UnsupportedError without matplotlib, OutputError."""
    check_format(path)
    try:
        import matplotlib
        from matplotlib.figure import Figure
    except ImportError as error:
        raise UnsupportedError("a plot needs matplotlib: pip install 'matpoint[report]'") from error
    panels = list(_panels(result))
    style = {name: PAPER.get(value, value) for name, value in STYLE.items()}
    style |= {"savefig.transparent": False, "svg.hashsalt": "matpoint drive"}
    kind = Path(path).suffix.lower().removeprefix(".")
    with matplotlib.rc_context(style), replacing(path) as temporary:
        rows = -(-len(panels) // 2)
        figure = Figure(figsize=(2 * PANEL[0], rows * PANEL[1] + 0.4), layout="constrained")
        axes = figure.subplots(rows, 2, squeeze=False).ravel()
        figure.suptitle(f"{result.test.material.name}: {result.test.words}", fontsize=10.5)
        for ax, panel in zip(axes, panels, strict=False):
            _draw(ax, panel)
        for ax in axes[len(panels) :]:
            ax.set_axis_off()
        metadata = {"svg": {"Date": None, "Creator": None}, "pdf": {"CreationDate": None}, "png": {}}[kind]
        figure.savefig(temporary, format=kind, dpi=150, metadata=metadata)


def _draw(ax, panel: Panel) -> None:
    title, (label, x), lines = panel
    for n, (name, values, colour) in enumerate(lines):
        ax.plot(x, values, color=colour, label=name, linestyle=DASHES[n % len(DASHES)])
    ax.set(title=title, xlabel=label)
    ax.margins(x=0.02)
    ax.locator_params(axis="x", nbins=6)
    if len(lines) > 1:
        ax.legend()


def _panels(result: DriveResult) -> Iterator[Panel]:
    history, path = result.history, result.test.path
    time = ("time [s]", history.times)
    strain = time if path is None else (path.strain, path.measure(history.deformation_gradient))
    # Over a strain that turns back, what only grows is a tangle.
    steady = strain if np.ptp(np.sign(np.diff(strain[1]))) == 0.0 else time
    stress = settled(history.stress) * MEGA
    main = [] if path is None else [path.stress]
    lines = [(SYMMETRIC[k], stress[:, k], BLUE) for k in main]
    yield "Stress [MPa]", strain, [*lines, ("von Mises", history.mises * MEGA, ORANGE)]
    others = [
        k for k in range(6) if k not in main and np.abs(stress[:, k]).max() > TOLD * np.abs(stress).max()
    ]
    lines = [(SYMMETRIC[k], stress[:, k], colour) for k, colour in zip(others, OTHERS, strict=False)]
    yield "Pressure and other stresses [MPa]", strain, [*lines, ("pressure", history.pressure * MEGA, GREY)]
    state = scalars(history)
    found = [(name, state[name], colour) for name, colour in SHARES.items() if name in state]
    if found:
        yield shown_title(" and ".join(name for name, *_ in found)), steady, found
    for name, values in state.items():
        if name not in (*SHARES, *UNSHOWN):
            yield shown_title(name), steady, [(name, values, BLUE)]
