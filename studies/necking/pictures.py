"""Final shapes of necked bodies side by side, coloured by plastic strain."""

import math

from core_models.errors import UnsupportedError
from studies.necking.scene import NeckingScene
from studies.necking.verdicts import Runs
from studies.report.drawing import INK, as_svg, drawing

MILLIMETRES = 1e3
ACROSS = 3  # pictures in a row at most; rows are alike
WIDTH, HEIGHT = 1.7, 3.4  # inches, of each


def final_shapes(scene: NeckingScene, runs: Runs) -> list[str]:
    """Pictures of the final shapes as SVG elements, some in each; none without matplotlib."""
    shown = [plan for plan in scene.runs if plan.name in runs and plan.taper is None]
    try:
        rows = max(math.ceil(len(shown) / ACROSS), 1)
        across = max(math.ceil(len(shown) / rows), 1)
        return [
            _row(scene, [(plan.name, runs[plan.name]) for plan in shown[i : i + across]], i)
            for i in range(0, len(shown), across)
        ]
    except UnsupportedError:
        return []


def _row(scene: NeckingScene, shown: list, number: int) -> str:
    with drawing(WIDTH * max(len(shown), 2) + 0.4, HEIGHT) as (figure, ax):
        figure.clear()
        draw_shapes(figure, shown)
        title = "Final shapes and equivalent plastic strain"
        return as_svg(figure, f"{scene.name}-shapes-{number}", title)


def draw_shapes(figure, shown: list, highest: float | None = None) -> None:
    """Draw runs by name side by side into a matplotlib figure, on one scale of plastic strain."""
    from matplotlib.collections import PolyCollection

    axes = figure.subplots(1, len(shown), squeeze=False)[0]
    highest = highest or max(float(run.strains.max()) for _name, run in shown)
    for (name, run), ax in zip(shown, axes, strict=True):
        for side in (-1.0, 1.0):
            drawn = PolyCollection(
                run.shape * [side * MILLIMETRES, MILLIMETRES], array=run.strains, cmap="viridis",
                clim=(0.0, highest), linewidths=0.0, antialiased=False, rasterized=True,
            )  # fmt: skip
            ax.add_collection(drawn)
        places = MILLIMETRES * run.shape.reshape(-1, 2)
        ax.set(
            xlim=(-1.1 * places[:, 0].max(), 1.1 * places[:, 0].max()), ylim=(0.0, 1.02 * places[:, 1].max())
        )
        ax.set(aspect="equal")
        ax.set_title(name, fontsize=7, color=INK)
        ax.grid(visible=False)
        ax.tick_params(labelsize=6)
    bar = figure.colorbar(drawn, ax=list(axes), shrink=0.8, pad=0.02)
    bar.outline.set_visible(False)
    bar.ax.tick_params(labelsize=6)
