"""Numbers as people read them."""

import pytest

from studies.output.display import number, plus_minus, shown_percent, shown_title, with_unit


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [(16.6104, 5, "16.610"), (646.918, 5, "646.92"), (0.00041234, 3, "0.000412"), (123456.0, 3, "123456")],
)
def test_significant_digits_without_exponents(value, digits, text):
    """Trailing zeros stay, large numbers are whole."""
    assert number(value, digits) == text


def test_rounding_up_to_the_next_power_keeps_the_digits():
    """9.9996 to four digits is 10.00."""
    assert number(9.9996, 4) == "10.00"


def test_round_off_is_zero():
    """A length of a billionth of a nanometre is shown as none."""
    assert with_unit(1e-18, "m") == "0 mm"


def test_a_value_is_given_to_the_place_of_its_uncertainty():
    """Two digits of the uncertainty, no more of the value."""
    assert plus_minus(16.5934e-3, 0.0361e-3, "m") == "16.593 ± 0.036"
    assert plus_minus(764.88, 252.0, "K") == "765 ± 252"
    assert plus_minus(1.5, None, "1") == "1.5000"


def test_percentages_are_signed_and_absent_ones_dashes():
    """+0.08 %, – for none."""
    assert shown_percent(0.00081) == "+0.08 %"
    assert shown_percent(None) == "–"


def test_titles_keep_the_capitals_of_symbols():
    """Only the first letter is raised; L₀ stays L₀."""
    assert shown_title("radius_at_0.2_L0") == "Radius at 0.2 L₀"
