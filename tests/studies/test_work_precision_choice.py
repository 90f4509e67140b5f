"""Which method to take for which accuracy: what times prove, and that the report says it first."""

import csv
import re
from dataclasses import replace

import pytest

from studies.report.document import page
from studies.report.markdown import csv_text, markdown
from studies.work_precision.analysis import INTERPOLATED
from studies.work_precision.choice_section import choice_section
from studies.work_precision.problem import Reference
from studies.work_precision.study import find_problem
from studies.work_precision.tables import report_of
from tests.studies.work_samples import EXACT, sequence

AT_ONE = re.compile(r"^[^.]*? 1[, ]")  # of the levels of a sentence or a row, 1 %


def told(runs, reference=EXACT):
    """The sentences of the first section."""
    return [each.text for each in choice_section(runs, {"u": reference}).verdicts]


def test_the_report_says_first_which_to_take():
    """The faster of both methods and by how much; what only one reaches; what no run can tell, levels alike in one."""
    runs = [*sequence("fem-explicit"), *sequence("mpm", seconds=4e-3), *sequence("mpm:flip", order=0.0)]
    assert told(runs)[2].startswith("U within 1 %: take fem-explicit, 4.0 times as fast. fem-explicit 0.06")
    assert told(sequence("fem-explicit"))[0].endswith(
        "take fem-explicit. fem-explicit 0.0057 s; material points do not reach it."
    )
    doubtful = told(runs, Reference(2.0, 1.0, "made"))
    assert doubtful == ["U within 5, 2, 1, 0.5, 0.1 %: not resolvable, the reference is not that sure."]


@pytest.mark.parametrize(
    ("mpm", "words", "winners"),
    [
        ({"error": 0.001, "seconds": 4e-3}, "either will do, both have it with their coarsest run", 2),
        ({"error": 0.16}, "take fem-explicit, at least 64 times as fast", 1),
        ({"error": 0.011, "seconds": 1e-5}, "take mpm; the coarsest run of fem-explicit has it and takes", 1),
        ({"order": 0.7}, "take fem-explicit, whose runs have it; the time of mpm is extrapolated", 1),
    ],
)
def test_a_factor_between_times_stands_only_where_both_prove_it(mpm, words, winners):
    """Beside `fem-explicit`, which has 1 % with its coarsest run, 1 ms: two bounds, one, a slow one, a guess."""
    section = choice_section([*sequence(error=0.005), *sequence("mpm", **mpm)], {"u": EXACT})
    (sentence,) = [each.text for each in section.verdicts if AT_ONE.search(each.text)]
    assert words in sentence and ("times as fast" in sentence) == ("times as fast" in words)
    (row,) = [row for row in section.tables[0].rows if AT_ONE.search(row[0])]
    assert sum(cell.endswith("*") for cell in row[1:]) == winners


def test_what_is_extrapolated_is_called_so():
    """Both guessed: no factor, none marked; a guess that is faster than all runs is told beside them."""
    both = [*sequence(order=0.7), *sequence("mpm", order=0.7, seconds=1.0)]
    section = choice_section(both, {"u": EXACT})
    row = next(k for k, row in enumerate(section.tables[0].rows) if "~" in row[1])
    sentence = section.verdicts[row].text
    assert "neither was run so fine; extrapolated, fem-explicit is the faster" in sentence
    assert "times" not in sentence and not any(cell.endswith("*") for cell in section.tables[0].rows[row])
    guessed = [*sequence("mpm", seconds=1.0), *sequence("mpm:flip", order=0.7, seconds=1e-5)]
    assert told(guessed)[2].partition("; extrapolated, ")[2].startswith("mpm:flip ~ ")


def test_the_page_shows_a_grid_and_a_chart_before_the_sentences(tmp_path):
    """Directly under the heading, also in Markdown the grid; numbers stay with their units; all digits in the CSV."""
    runs = [*sequence("fem-explicit"), *sequence("mpm", seconds=4e-3)]
    problem = replace(find_problem("vibrating-bar"), references={"u": EXACT}, units={"u": "s"})
    report = report_of(problem, runs, 1)
    text = page(report)
    places = [text.index(piece) for piece in ("<h2>Which to take", "<table", "<svg", "take fem-explicit, ")]
    assert places == sorted(places) and text.index("<h2>", places[0] + 1) > places[-1]
    assert '<td class="best">fem-explicit 0.' in text.replace(" best", "best")
    assert not re.search(
        r"[0-9] (s|%)[ ;.:<]|[≤~] [0-9]", text[places[0] : text.index("<h2>", places[0] + 1)]
    )
    assert markdown(report).index("| u: 1") < markdown(report).index("take fem-explicit, ")
    assert "one run each" in report.facts
    rows = list(csv.reader(csv_text(report.sections[0].files()["choice.csv"]).splitlines()))
    assert float(rows[3][3]) == pytest.approx(0.064) and rows[3][4] == INTERPOLATED
