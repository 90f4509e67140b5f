"""Try a material law: lead one point along a path, print stress and state, keep the history.

examples:
  matpoint drive taylor-copper-jc --path uniaxial-stress --to 0.3 --rate 1000
  matpoint drive copper_hyperelastic_mts --path simple-shear --to 2 --rate 1e4 --plot shear.svg --csv shear.csv
  matpoint drive my_card.xml --path cyclic --to 0.01 --rate 1 --cycles 3 --isothermal
  matpoint drive taylor-copper-jc --to 0.2 --rate 1e-3,1e3 --hold 10
  matpoint drive taylor-classic --segment '1e-3 stretch11=1.1 stress22=0 stress33=-50e6' --segment '1e-3 L12=200'

A segment is a duration [s] and what is prescribed meanwhile: F, L, stretch or stress with two digits, in SI units;
components that are not named keep their F. Several segments follow each other.
Exit status: 0; 2 bad input; 3 a step that the point cannot follow.
"""

import argparse

from studies.options import add_json_option, add_material_options, number, numbers, positive, whole


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint drive`."""
    add_material_options(parser)
    parser.add_argument(
        "--path",
        metavar="NAME",
        help="uniaxial-stress (default), uniaxial-strain, plane-strain, biaxial, simple-shear, volumetric, cyclic",
    )
    parser.add_argument(
        "--to",
        metavar="STRAIN",
        type=number,
        help="true strain (or shear, or ln J) to go to; < 0: compression",
    )
    parser.add_argument(
        "--rate", metavar="R[,R...]", type=numbers, help="strain rate [1/s]; several: each for an equal share"
    )
    parser.add_argument(
        "--steps",
        metavar="N",
        type=positive,
        default=100,
        help="steps from 0 to --to, or of each segment (100)",
    )
    parser.add_argument(
        "--cycles", metavar="K", type=whole, help="cycles between +strain and -strain after it"
    )
    parser.add_argument("--hold", metavar="TIME", type=number, help="then hold the strain for a time [s]")
    parser.add_argument(
        "--segment", metavar="TEXT", action="append", default=[], help="instead of --path: see below"
    )
    parser.add_argument("--temperature", metavar="K", type=number, help="at the start (default: the card's)")
    parser.add_argument("--isothermal", action="store_true", help="without heating by plastic work")
    parser.add_argument("--update", metavar="NAME", help="hypoelastic or hyperelastic (default: the card's)")
    parser.add_argument("--csv", metavar="FILE", help="write the whole history, in SI units")
    parser.add_argument("--plot", metavar="FILE", help="draw it: .svg, .png or .pdf")
    parser.add_argument(
        "--out", metavar="DIR", help="new or empty folder for card, history, plot and summary"
    )
    add_json_option(parser)


def execute(options: argparse.Namespace) -> int:
    """Drive the point, print, write."""
    from studies.drive.driving import asked_test, carry_out
    from studies.drive.files import check_files, write_files
    from studies.drive.record import drive_record
    from studies.drive.text import drive_text
    from studies.output.json_output import json_text

    check_files(options.csv, options.plot, options.out)
    result = carry_out(asked_test(options))
    text = drive_text(result)
    written = write_files(result, text, options.csv, options.plot, options.out)
    if options.json:
        print(json_text(drive_record(result) | {"files": written}))
    else:
        print("\n".join([text, *map(str, written)]))
    return 0
