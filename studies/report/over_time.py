"""Pictures of the finest runs over time, with a slider."""

import json
import subprocess
import sys
from base64 import b64encode
from dataclasses import dataclass
from html import escape
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any
from xml.etree import ElementTree

from studies.comparisons.comparison import Comparison
from studies.methods.method import find_method
from studies.output.display import SHOWN_UNITS, number
from studies.runs.result import RunResult

FIELDS = {
    "equivalent_plastic_strain": ("Equivalent plastic strain", "1", "viridis", False),
    "temperature": ("Temperature", "K", "inferno", False),
    "pressure": ("Pressure", "Pa", "RdBu_r", True),
}
LONGEST = 600.0  # s
PLAYER = "player"
STOPS = 12  # of the colours of a scale


@dataclass(frozen=True)
class OverTime:
    """A slider, pictures as pieces of HTML and a caption; remark : why there are none."""

    player: str = ""
    figures: tuple[str, ...] = ()
    caption: str = ""
    remark: str = ""


def over_time(comparison: Comparison) -> OverTime:
    """Frames of the first and the last of the finest runs, side by side; needs pyvista and the runs' folders."""
    runs = [comparison.finest[0], comparison.finest[-1]]
    if any(run.folder is None for run in runs):
        return OverTime()
    if find_spec("pyvista") is None:
        return OverTime(remark="Pictures over time need pyvista: pip install 'matpoint[report]'")
    frames = [_frames(run) for run in runs]
    # Runs that end with release end at times of their own: the shorter one stands at its end.
    last = max(len(each) for each in frames) - 1
    chosen = [[each[min(k, len(each) - 1)] for each in frames] for k in range(last + 1)]
    with TemporaryDirectory() as folder:
        job = {
            "pairs": [[str(path) for _, path in pair] for pair in chosen],
            "fields": {
                name: {"colours": colours, "signed": signed}
                for name, (_, _, colours, signed) in FIELDS.items()
            },
            "folder": folder,
        }
        shown = rendered(job)
        if shown is None:
            return OverTime(
                remark="Pictures over time could not be drawn: this machine has no usable OpenGL."
            )
        figures = [_figure(name, runs, low, high, folder) for name, (low, high) in shown["ranges"].items()]
    times = [max(time for time, _ in pair) * 1e6 for pair in chosen]
    return OverTime(_player(times), tuple(figures), _caption(shown["size"]))


def _frames(run: RunResult) -> list[tuple[float, Path]]:
    """Times [s] and files, as the run's series.pvd lists them."""
    series = ElementTree.parse(run.folder / "series.pvd")
    return [
        (float(each.get("timestep")), (run.folder / each.get("file")).resolve())
        for each in series.iter("DataSet")
    ]


def rendered(job: dict[str, Any]) -> dict[str, Any] | None:
    """What the pictures of a job show, drawn by a process of its own; None where that cannot be done."""
    try:
        ended = subprocess.run(
            [sys.executable, "-m", "studies.report.rendering"],
            input=json.dumps(job),
            capture_output=True,
            text=True,
            timeout=LONGEST,
            cwd=Path(__file__).parents[2],
            check=True,
        )
    except (subprocess.SubprocessError, OSError):
        return None
    return json.loads(ended.stdout)


def _player(times: list[float]) -> str:
    data = escape(json.dumps({"times": [round(time, 2) for time in times], "unit": "µs"}), quote=True)
    return (
        f'<div class="player" id="{PLAYER}" data-times="{data}" hidden><button type="button"></button>'
        '<input type="range" min="0" step="1" aria-label="Time"><output></output></div>'
    )


def _figure(name: str, runs: list[RunResult], low: float, high: float, folder: str) -> str:
    title, unit, colours, _ = FIELDS[name]
    factor, word = SHOWN_UNITS[unit]
    count = len(list(Path(folder).glob(f"{name}-*.webp")))
    pictures = [_source(Path(folder) / f"{name}-{k}.webp") for k in range(count)]
    labels = [
        f'<span class="{find_method(run.method).scene_key}">{escape(find_method(run.method).label)} '
        f"{run.resolution}</span>"
        for run in runs
    ]
    heading = f"{title}{f' [{word}]' if word else ''}, wall {runs[0].wall}"
    return (
        f'<div class="frames" data-player="{PLAYER}"><div class="title">{escape(heading)}</div>'
        f'<div class="names">{"".join(labels)}</div>'
        f'<img alt="{escape(title)} at the end, {escape(runs[0].label)} left, {escape(runs[1].label)} right" '
        f'src="{pictures[-1]}"><script type="application/json">{json.dumps(pictures[:-1])}</script>'
        f'<div class="wall"></div><div class="scale"><span>{number(low * factor, 3)}</span>'
        f'<span style="background:{_gradient(colours)}"></span><span>{number(high * factor, 3)}</span></div></div>'
    )


def _source(path: Path) -> str:
    return f"data:image/webp;base64,{b64encode(path.read_bytes()).decode()}"


def _gradient(colours: str) -> str:
    from matplotlib import colormaps
    from matplotlib.colors import to_hex

    stops = ",".join(to_hex(colormaps[colours](k / (STOPS - 1))) for k in range(STOPS))
    return f"linear-gradient(90deg,{stops})"


def _caption(size: list[float]) -> str:
    return (
        f"The body on the wall, {1e3 * size[0]:.3g} mm from left to right, as it is at the end or, with the slider, at "
        "other times. Each method's own domains, without smoothing. What lies outside the colours' range has that "
        "of its end."
    )
