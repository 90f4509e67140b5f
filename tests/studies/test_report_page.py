"""Reports in a browser: no error, no missing image, the headline numbers, values of curves, readable on a phone."""

import re
from importlib.util import find_spec
from itertools import pairwise

import pytest

from studies.comparisons.comparing import compare
from studies.output.display import plus_minus
from studies.report.document import page
from studies.report.drawing import drawing
from studies.report.figures import SIZE
from studies.report.log_ticks import set_log_ticks
from studies.report.over_time import rendered
from studies.report.parts import Curve, Plot, Table
from studies.report.study_page import AGREE, APART, Report, Section, Verdict
from tests.studies.browser import open_page

pytest.importorskip("matplotlib")

HOVER = """
const svg = document.querySelector("svg[data-curves]");
const box = JSON.parse(svg.dataset.curves).box, view = svg.viewBox.baseVal, size = svg.getBoundingClientRect();
const at = (x, y) => svg.dispatchEvent(new PointerEvent("pointermove", {
  clientX: size.left + (x / view.width) * size.width, clientY: size.top + (y / view.height) * size.height,
}));
at((box[0] + box[2]) / 2, (box[1] + box[3]) / 2);
svg.dispatchEvent(new PointerEvent("pointerleave", { pointerType: "touch" }));
const pointed = document.querySelector(".values").textContent;
svg.dispatchEvent(new PointerEvent("pointerleave"));
const left = document.querySelector(".values").textContent;
svg.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight" }));
return { pointed, left, typed: document.querySelector(".values").textContent };
"""
WHOLE = """
const wide = [...document.querySelectorAll("body *")].filter((e) => !e.closest(".wide, svg, details"))
  .filter((e) => e.getBoundingClientRect().right > innerWidth + 1).map((e) => e.outerHTML.slice(0, 80));
const missing = [...document.images].filter((i) => !i.complete || !i.naturalWidth).length;
const slider = document.querySelector(".player input"), first = document.images[0]?.src;
if (slider) {
  slider.value = 0;
  slider.dispatchEvent(new Event("input"));
}
return {
  time: document.querySelector(".player output")?.textContent, moved: document.images[0]?.src !== first,
  missing, images: document.images.length, text: document.body.innerText, wide,
};
"""


def parabola(count):
    """A curve with `count` points."""
    x = tuple(k / (count - 1) for k in range(count))
    return Curve("x²", x, tuple(v * v for v in x), "fem")


def small_report(*plots):
    """A report with all that a report can have."""
    table = Table(
        "Numbers", ("run", "value [m]", "said"), (("mpm 8", 1.5, "a < b | c"), ("Second", None, "FAILED"))
    )
    sections = (
        Section("first", "First", (table,), plots, ("A remark.",), "What it is.", (Verdict(AGREE, "good"),)),
        Section("second", "Second", verdicts=(Verdict(APART, "bad"),)),
        Section("empty", "Never shown"),
    )
    return Report("Title & more", "One sentence.", ("a fact",), sections, ("mpm 9: burst",), ("small print",))


def test_the_page_of_a_comparison_is_whole_and_fits_a_phone(fake_solvers, classic, tmp_path, monkeypatch):
    """Opened 390 px wide: no error, no missing image, a slider, nothing wider than the screen, the headline numbers."""
    monkeypatch.setattr("studies.report.over_time.rendered", rendered)
    comparison = compare(classic, resolutions=(8, 12, 16), wall="plane", out=tmp_path / "out")
    text = (tmp_path / "out/report.html").read_text()
    seen = open_page(text, tmp_path, WHOLE, width=390)
    assert seen["errors"] == [] and seen["log"] == []
    assert seen["found"]["missing"] == 0
    assert seen["found"]["wide"] == []
    if "no usable OpenGL" not in text and find_spec("pyvista"):
        assert seen["found"]["images"] == 2 and seen["found"]["moved"] and seen["found"]["time"] == "0.0 µs"
    for name in ("final_length", "foot_radius"):
        for limits in comparison.limits.values():
            limit = limits[name]
            assert plus_minus(limit.value, limit.uncertainty, "m") in seen["found"]["text"].replace(
                "\u00a0", " "
            )
    assert len(text) < 5e6


@pytest.mark.parametrize(("count", "log", "told"), [(41, False, "x 0.5x² 0.25"), (5, False, "x 0.5x² 0.25")])
def test_values_of_curves_show_under_the_pointer(count, log, told, tmp_path):
    """Many points at one abscissa, few at the nearest; by arrow keys too; hidden on leaving, but for a finger."""
    plot = Plot("Parabola", "x", "y", (parabola(count),), log)
    seen = open_page(page(small_report(plot)), tmp_path, HOVER)
    assert seen["errors"] == [] and seen["log"] == []
    assert seen["found"]["pointed"] == told and seen["found"]["left"] == ""
    assert seen["found"]["typed"] == "x 0x² 0"


@pytest.mark.parametrize(
    ("low", "high"),
    [(0.22, 0.61), (1.1, 1.9), (0.99, 1.01), (2e6, 5.5e6), (3e-5, 9e-5), (4e3, 9e4), (0.03, 80.0)],
)
def test_numbers_at_a_logarithmic_axis_stand_apart(low, high):
    """From two to six of them, none over another, whether the axis spans a hundredth of a decade or three."""
    with drawing(*SIZE) as (figure, ax):
        ax.loglog([low, high], [low, high])
        set_log_ticks(ax.xaxis)
        figure.draw_without_rendering()
        shown = [each for each in ax.get_xticklabels(which="both") if each.get_text()]
        seen = ax.get_xlim()
        shown = [each for each in shown if seen[0] <= each.get_position()[0] <= seen[1]]
        spans = sorted((box.x0, box.x1) for box in (each.get_window_extent() for each in shown))
    assert 2 <= len(shown) <= 6
    assert all(left[1] < right[0] for left, right in pairwise(spans))


def test_what_a_report_says_is_on_its_page_without_scripts():
    """Words are escaped, verdicts marked, numbers shown, what is empty left out, other sections linked."""
    text = page(small_report())
    assert "<title>Title &amp; more</title>" in text and "mpm 9: burst" in text and "small print" in text
    assert '<li class="agree">good' in text and '<li class="apart">bad' in text
    assert "a &lt; b | c" in text and '<td class="bad">FAILED' in text and '<a href="#second">Second' in text
    assert "Never shown" not in text and "http" not in text.replace("http://www.w3.org", "")


def test_tables_can_be_taken_from_the_page():
    """A link holds the table as CSV."""
    assert re.search(
        r'download="first.csv" href="data:text/csv;base64,[A-Za-z0-9+/=]+"', page(small_report())
    )


@pytest.mark.parametrize(
    ("missing", "told"), [("pyvista", "pip install 'matpoint[report]'"), ("OpenGL", "no usable OpenGL")]
)
def test_without_pictures_over_time_the_page_says_why(
    fake_solvers, classic, tmp_path, monkeypatch, missing, told
):
    """The rest of the report is there; the pretended runs draw none as a machine without OpenGL would not."""
    if missing == "pyvista":
        monkeypatch.setattr("studies.report.over_time.find_spec", lambda name: None)
    compare(classic, resolutions=(4,), out=tmp_path / "out")
    for name in ("report.html", "report.md"):
        text = (tmp_path / "out" / name).read_text()
        assert (
            told.replace("'", "&#x27;" if name.endswith("html") else "'") in text and "final length" in text
        )


def test_an_ended_process_that_draws_costs_the_pictures_only(tmp_path):
    """A job that cannot be drawn gives None instead of an error."""
    assert rendered({"pairs": [["no.vtu", "no.vtu"]], "fields": {}, "folder": str(tmp_path)}) is None
