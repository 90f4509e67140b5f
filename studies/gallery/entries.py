"""What the gallery shows. Each takes seconds, once its laws are compiled."""

from argparse import Namespace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from studies.comparisons.comparing import compare
from studies.comparisons.comparison import Comparison
from studies.gallery.entry import Entry, Shown
from studies.gallery.pictures import standalone
from studies.gallery.study_entries import STUDY_ENTRIES
from studies.scenes.reader import read_scene

MILLIMETRES = 1e3
PERCENT = 100.0


@cache
def _compared(scene: str, wall: str, resolution: int) -> Comparison:
    return compare(read_scene(scene), resolutions=(resolution,), wall=wall)


def _shapes() -> Shown:
    from studies.report.field_pictures import field_pictures

    comparison = _compared("taylor-copper-jc", "unilateral", 12)
    picture = field_pictures(comparison)[0]
    return Shown(standalone(picture), MILLIMETRES * comparison.finest[0].quantities["final_length"].value)


def _difference() -> Shown:
    from studies.report.difference_maps import difference_maps

    comparison = _compared("taylor-copper-jc", "unilateral", 12)
    return Shown(standalone(difference_maps(comparison)[0]), PERCENT * comparison.maps.gaps[0].relative)


def _classic() -> Shown:
    from studies.report.history_plots import history_plots

    comparison = _compared("taylor-classic", "plane", 12)
    off = next(check for check in comparison.references if check.reference.quantity == "foot_radius")
    return Shown(standalone(history_plots(comparison)[1]), PERCENT * off.outside_relative)


def _measured() -> Shown:
    from studies.report.profile_plots import profile_plots

    comparison = _compared("taylor-ofhc-190", "unilateral", 8)
    length = comparison.finest[1].quantities["final_length"].value
    return Shown(standalone(profile_plots(comparison)[0]), MILLIMETRES * length)


def _rate_jump() -> Shown:
    from studies.drive.driving import asked_test, carry_out
    from studies.drive.plot import write_plot

    nothing = dict.fromkeys(("cycles", "hold", "temperature", "update", "laws"))
    asked = Namespace(
        **nothing, material="taylor-copper-jc", path="uniaxial-stress", to=0.4, rate=(1.0, 1e4), steps=100,
        segment=[], search_root=[], isothermal=False,
    )  # fmt: skip
    result = carry_out(asked_test(asked))
    with TemporaryDirectory() as folder:
        file = Path(folder) / "jump.svg"
        write_plot(result, file)
        picture = file.read_text(encoding="utf-8")
    return Shown(picture, 1e-6 * float(result.history.mises[-1]))


def _plate_impact() -> Shown:
    from studies.report.figures import plot_svg
    from studies.verification.problems.plate_impact import PROBLEM

    outcome = PROBLEM.run(True)
    picture = plot_svg(outcome.plots[0], PROBLEM.name)
    return Shown(standalone(picture), outcome.criteria[0].value)


def _cell_crossing() -> Shown:
    from studies.report.figures import plot_svg
    from studies.verification.problems.cell_crossing import PROBLEM

    outcome = PROBLEM.run(True)
    return Shown(standalone(plot_svg(outcome.plots[0], PROBLEM.name)), outcome.criteria[0].value)


ENTRIES = (
    Entry(
        "taylor-shapes",
        "A copper cylinder hits a rigid wall at 208 m/s",
        "Equivalent plastic strain of the final shapes: finite elements left of the axis, the material point method "
        "right, with one compiled library of laws.",
        "matpoint compare taylor-copper-jc --resolution 12",
        "final length by finite elements",
        16.614,
        0.02,
        "mm",
        _shapes,
    ),
    Entry(
        "taylor-difference",
        "Where the two methods differ",
        "The same runs on one mesh of the undeformed bar: plastic strain by the material point method minus that by "
        "finite elements.",
        "matpoint compare taylor-copper-jc --resolution 12",
        "root-mean-square difference over the volume, by that of the field",
        3.8,
        0.3,
        "%",
        _difference,
    ),
    Entry(
        "classic-foot",
        "The classic numerical Taylor bar, against another code",
        "Foot radius over time under the plane wall, with the history of Carina.jl.",
        "matpoint compare taylor-classic --wall plane --resolution 12",
        "foot radius by finite elements, off the published range by",
        -0.49,
        0.1,
        "%",
        _classic,
    ),
    Entry(
        "measured-profile",
        "A measured shot: OFHC copper at 190 m/s",
        "Final profiles by both methods over the measured one; constants from elsewhere, none fitted.",
        "matpoint compare taylor-ofhc-190 --resolution 8",
        "final length by the material point method",
        17.344,
        0.02,
        "mm",
        _measured,
    ),
    Entry(
        "rate-jump",
        "A law on its own: a jump of the strain rate",
        "Copper after Johnson and Cook, pulled at 1 /s up to a strain of 0.2, then at 10,000 /s.",
        "matpoint drive taylor-copper-jc --to 0.4 --rate 1,1e4 --plot rate-jump.svg",
        "von Mises stress at the end",
        372.15,
        0.05,
        "MPa",
        _rate_jump,
    ),
    Entry(
        "plate-impact",
        "A shock with a known answer",
        "Two plates collide; states behind the shocks follow from the Hugoniot in closed form.",
        "matpoint study verification --quick --only plate-impact",
        "state behind the shock at 100 m/s by finite elements, off the Hugoniot by",
        0.824,
        0.05,
        "%",
        _plate_impact,
    ),
    Entry(
        "cell-crossing",
        "What happens when particles cross cells",
        "A strip under even stress is carried through the grid: linear shape functions err at every crossing, smooth "
        "ones and particles with a width hardly do.",
        "matpoint study verification --quick --only cell-crossing",
        "error of the stress with linear shape functions",
        63.1,
        0.5,
        "%",
        _cell_crossing,
    ),
    *STUDY_ENTRIES,
)
