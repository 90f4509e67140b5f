"""Entries of the gallery that come from the studies of many runs: a few of their runs each."""

from statistics import median

from studies.gallery.entry import Entry, Shown
from studies.gallery.pictures import standalone

MILLIMETRES, PERCENT = 1e3, 100.0
COARSE = 6  # across the radius of the copper bar, as in docs/effects.md
PARTS_OF_A_TURN = 12
SERIES, CARD = "cu-wilkins", "copper_ofhc_johnson_cook"


def _necking() -> Shown:
    from studies.necking.methods import make_run
    from studies.necking.pictures import final_shapes
    from studies.necking.reader import read_necking_scene

    scene = read_necking_scene("necking-simo")
    asked = ("quad8:5", "fem-implicit:none")
    runs = {plan.name: make_run(scene, plan) for plan in scene.runs if plan.name in asked}
    left = runs["fem-implicit:none"].history.column("force")[-1]
    return Shown(standalone(final_shapes(scene, runs)[0]), 1e-3 * float(left))


def _fast_impact() -> Shown:
    from studies.report.figures import picture_svg
    from studies.report.parts import Picture
    from studies.stability.cases import find_case

    case, panels, strains = find_case("taylor-600"), {}, []
    for variant in ("fem-explicit", "mpm", "mpm:total"):
        solver = case.build(variant)
        while solver.time < case.end:
            solver.advance(case.end)
        strains.append(solver.points.old.equivalent_plastic_strain.copy())
        panels[variant] = (MILLIMETRES * solver.domains(), strains[-1])
    picture = Picture("Copper at 600 m/s", "plastic strain", panels)
    return Shown(standalone(picture_svg(picture, case.name)), float(strains[0].max()))


def _turning() -> Shown:
    from studies.report.figures import plot_svg
    from studies.report.parts import FEM, MPM, Curve, Plot
    from studies.stability.cases import find_case
    from studies.stability.cases.elastic import TURN

    case, curves, left = find_case("turning"), [], []
    for variant in ("fem-explicit", "mpm", "mpm:flip", "mpm:xpic"):
        solver = case.build(variant)
        turns, momenta = [0.0], [solver.angular_momentum]
        for part in range(1, PARTS_OF_A_TURN + 1):
            while solver.time < part * TURN / PARTS_OF_A_TURN:
                solver.advance(part * TURN / PARTS_OF_A_TURN)
            turns.append(part / PARTS_OF_A_TURN)
            momenta.append(solver.angular_momentum)
        left.append([PERCENT * momentum / momenta[0] for momentum in momenta])
        curves.append(
            Curve(variant, tuple(turns), tuple(left[-1]), MPM if variant.startswith("mpm") else FEM)
        )
    plot = Plot("A square of 4 x 4 cells", "turns", "angular momentum left [%]", tuple(curves))
    return Shown(standalone(plot_svg(plot, case.name)), left[2][-1])


def _effects() -> Shown:
    from studies.bar.outline import bar_outline
    from studies.effects_study.study import planned
    from studies.methods.method import build_solver
    from studies.report.figures import plot_svg
    from studies.report.parts import Curve, Plot
    from studies.scenes.reader import read_scene
    from studies.work_precision.bars import finish_bar, with_fixed_end

    scene = with_fixed_end(read_scene("taylor-copper-jc"))
    curves, feet = [], []
    for effect, to, method, switched in planned(scene, "mpm", spatial=False):
        if effect in ("as it is", "plastic heating", "wall friction"):
            solver = build_solver(switched, method, COARSE, scene.wall, 1)
            feet.append(finish_bar(solver, scene.end.limit(scene.wall))["foot_radius"])
            r, z = MILLIMETRES * bar_outline(solver)["side"].T
            curves.append(Curve(f"{effect} {to}".rstrip(), tuple(r), tuple(z), "mpm"))
    plot = Plot("Profile of the bar", "r [mm]", "z [mm]", tuple(curves))
    return Shown(standalone(plot_svg(plot, "effects")), PERCENT * (feet[-1] / feet[0] - 1.0))


def _experiments() -> Shown:
    from studies.experiments.predictions import predict
    from studies.experiments.shots import read_shots
    from studies.experiments.study import QUICK
    from studies.report.figures import plot_svg
    from studies.report.parts import Curve, Plot

    shots = sorted(
        (shot for shot in read_shots() if shot.name.startswith(SERIES)), key=lambda shot: shot.velocity
    )
    speeds = tuple(shot.velocity for shot in shots)
    measured = tuple(shot.measured["final_length"] / shot.length for shot in shots)
    curves, errors = [Curve("measured", speeds, measured, "exact")], []
    for method, resolution in QUICK.resolutions:
        found = [predict(shot.name, CARD, method, resolution, QUICK.within) for shot in shots]
        ratios = tuple(
            row["predicted"]["final_length"] / shot.length for row, shot in zip(found, shots, strict=True)
        )
        curves.append(Curve(method, speeds, ratios, method.partition("-")[0]))
        errors.append(PERCENT * median(abs(row["errors"]["final_length"]) for row in found))
    plot = Plot("Copper cylinders of 1973", "speed [m/s]", "final length / length", tuple(curves))
    return Shown(standalone(plot_svg(plot, "experiments")), errors[-1])


STUDY_ENTRIES = (
    Entry(
        "necking-locking",
        "A steel bar necks, unless its elements lock",
        "Implicit finite elements, pulled by 7 mm at each end: quadratic ones with reduced integration, and linear "
        "ones with full integration and no cure, whose volumes are too stiff to flow into a neck.",
        "matpoint study necking --methods quad8:5,fem-implicit:none",
        "force that the locked bar still bears at 7 mm, where 23 are left of the other",
        44.9,
        0.2,
        "kN",
        _necking,
    ),
    Entry(
        "fast-impact",
        "What is stable need not be right",
        "Half sections of a coarse copper bar, 4 elements or cells across, squeezed flat at 600 m/s. Three variants "
        "come to the end with their energies in balance, and agree no longer: that takes resolution.",
        "matpoint study stability --cases taylor-600 --methods fem-explicit,mpm,mpm:total",
        "largest plastic strain, finite elements",
        7.111,
        0.02,
        "",
        _fast_impact,
    ),
    Entry(
        "turning",
        "What does not turn for long",
        "An elastic square is let turn freely. Elements and material points by APIC keep its angular momentum; FLIP, "
        "which takes a hundredth of PIC at each step, and XPIC lose it within a turn, with their energies in balance.",
        "matpoint study stability --cases turning --methods fem-explicit,mpm,mpm:flip,mpm:xpic",
        "angular momentum that FLIP leaves after one turn",
        30.08,
        0.3,
        "%",
        _turning,
    ),
    Entry(
        "effects-profiles",
        "What an effect changes: heat, and a rough wall",
        "Profiles of the founding example at 80 µs, as it is, without the heat of plastic work, and on a wall with a "
        "coefficient of friction of 0.1.",
        "matpoint study effects taylor-copper-jc --methods mpm --resolution 6 --planar",
        "change of the foot radius by friction, material point method",
        -5.09,
        0.05,
        "%",
        _effects,
    ),
    Entry(
        "measured-series",
        "Six shots at growing speed",
        "Final lengths of OFHC copper cylinders by Wilkins and Guinan and by both methods, coarse, with constants from "
        "elsewhere; these are 6 of the 85 shots that the command runs.",
        "matpoint study experiments --quick",
        "median absolute error of the length by the material point method",
        1.32,
        0.05,
        "%",
        _experiments,
    ),
)
