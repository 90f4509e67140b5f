"""Pictures of runs over time by pyvista, one method left of the axis, the other right.

A process of its own (`python -m studies.report.rendering`), since a machine without a usable OpenGL may end the process
that asks for it: a job as JSON on standard input, pictures in a folder, what they show as JSON on standard output.
"""

import json
import sys
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

WIDTH = 640  # pixels
QUALITY = 82
CENTRAL = 92.0  # per cent of the values of a signed field that its colours resolve
OVERLAP = 1.03  # enlargement of the domains, which closes the hairlines between those of particles
ROOM = 1.06  # by which the picture is larger than the body


def main() -> int:
    """Draw the job on standard input."""
    job = json.load(sys.stdin)
    json.dump(render(job["pairs"], job["fields"], Path(job["folder"])), sys.stdout)
    return 0


def render(pairs: list[list[str]], fields: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Draw pairs of frames (.vtu files, left and right) as FIELD-K.webp; returns low and high by field.

    fields : name -> colours and whether it is signed, which makes its colours even about zero.
    """
    import pyvista
    from PIL import Image

    # Only the frames of one picture are kept: all frames of fine runs would fill the memory.
    read = lru_cache(maxsize=2)(lambda name: _standing(pyvista.read(name)))
    width, top, ranges = _survey(read, sorted({name for pair in pairs for name in pair}), fields)
    plotter = pyvista.Plotter(
        off_screen=True, window_size=(WIDTH, max(round(WIDTH * top / (2.0 * width)), 2))
    )
    plotter.render_window.SetMultiSamples(0)  # pictures are shown smaller than they are: that smooths as well
    plotter.enable_parallel_projection()
    plotter.show(auto_close=False)
    plotter.image_transparent_background = True  # which `show` resets
    for k, (left, right) in enumerate(pairs):
        for name in ranges:
            plotter.clear_actors()
            for grid, side in ((read(left), -1.0), (read(right), 1.0)):
                shown = grid.scale((side, 1.0, 1.0), inplace=False)
                plotter.add_mesh(
                    shown,
                    scalars=name,
                    clim=ranges[name],
                    cmap=fields[name]["colours"],
                    lighting=False,
                    show_scalar_bar=False,
                )
            plotter.camera_position = [(0.0, 0.5 * top, 1.0), (0.0, 0.5 * top, 0.0), (0.0, 1.0, 0.0)]
            plotter.camera.parallel_scale = 0.5 * top
            plotter.camera.clipping_range = (1e-3, 10.0)
            Image.fromarray(plotter.image).save(folder / f"{name}-{k}.webp", quality=QUALITY, method=2)
    plotter.close()
    return {"ranges": ranges, "size": [2.0 * width, top]}


def _standing(grid):
    """The grid with its axis upright in the picture's plane: in three dimensions the section y = 0 is in front."""
    points = np.array(grid.points, dtype=float)
    if np.ptp(points[:, 2]) > 0.0:
        points = np.column_stack([points[:, 0], points[:, 2], -points[:, 1]])
    corners = points.reshape(grid.n_cells, -1, 3)
    middle = corners.mean(axis=1, keepdims=True)
    grid.points = (middle + OVERLAP * (corners - middle)).reshape(-1, 3)
    return grid


def _survey(read, names: list[str], fields: dict[str, Any]) -> tuple[float, float, dict[str, list[float]]]:
    """Half width and height of the picture [m], and the range of every field that all frames have."""
    width = top = 0.0
    found: dict[str, list[np.ndarray]] = {name: [] for name in fields}
    for file in names:
        grid = read(file)
        width = max(width, float(np.abs(grid.points[:, 0]).max()))
        top = max(top, float(grid.points[:, 1].max()))
        for name in fields:
            if name in grid.cell_data:
                found[name].append(np.asarray(grid.cell_data[name], dtype=np.float32))
    ranges = {
        name: _range(np.concatenate(values), fields[name]["signed"])
        for name, values in found.items()
        if len(values) == len(names)
    }
    return ROOM * width, ROOM * top, ranges


def _range(values: np.ndarray, signed: bool) -> list[float]:
    if not signed:
        return [float(values.min()), float(values.max())]
    bound = float(np.percentile(np.abs(values), CENTRAL)) or 1.0
    return [-bound, bound]


if __name__ == "__main__":
    sys.exit(main())
