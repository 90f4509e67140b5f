"""How numbers are shown to people: names, convenient units, digits."""

from math import floor, log10

SHOWN_UNITS = {
    "m": (1e3, "mm"),
    "m^2": (1e6, "mm²"),
    "m^3": (1e9, "mm³"),
    "s": (1e6, "µs"),
    "K": (1.0, "K"),
    "Pa": (1e-6, "MPa"),
    "N": (1e-3, "kN"),
    "1": (1.0, ""),
}
ABSENT = "–"
SMALLEST = 1e-9  # in shown units; what is smaller is round-off


def shown_name(quantity: str) -> str:
    """A quantity's name as words: final_length -> final length."""
    return quantity.replace("_", " ").replace(" L0", " L₀")


def shown_title(quantity: str) -> str:
    """A quantity's name as words that begin with a capital: Radius at 0.2 L₀."""
    words = shown_name(quantity)
    return words[:1].upper() + words[1:]


def shown_unit(unit: str) -> str:
    """The convenient unit's name: m -> mm."""
    return SHOWN_UNITS[unit][1]


def shown(value: float | None, unit: str, digits: int = 5) -> str:
    """The value in its convenient unit, to so many significant digits; a dash for none."""
    return ABSENT if value is None else number(value * SHOWN_UNITS[unit][0], digits)


def shown_percent(relative: float | None) -> str:
    """A signed percentage with two decimals; a dash for none."""
    return ABSENT if relative is None else f"{100.0 * relative:+.2f} %"


def with_unit(value: float | None, unit: str, digits: int = 5) -> str:
    """The value and its unit."""
    return f"{shown(value, unit, digits)} {shown_unit(unit)}".rstrip()


def number(value: float, digits: int = 4) -> str:
    """So many significant digits, trailing zeros kept, without exponents."""
    if abs(value) < SMALLEST:
        return "0"
    return f"{value:.{max(digits - 1 - _magnitude(float(f'{value:.{digits - 1}e}')), 0)}f}"


def plus_minus(value: float, uncertainty: float | None, unit: str) -> str:
    """'16.593 ± 0.036': two digits of the uncertainty, the value to the same place."""
    if uncertainty is None:
        return shown(value, unit)
    scale = SHOWN_UNITS[unit][0]
    if uncertainty * scale < SMALLEST:
        return f"{shown(value, unit)} ± 0"
    places = max(1 - _magnitude(uncertainty * scale), 0)
    return f"{value * scale:.{places}f} ± {uncertainty * scale:.{places}f}"


def _magnitude(value: float) -> int:
    return floor(log10(abs(value)))
