"""Ticks of logarithmic axes: plain numbers where an axis shows little, powers of ten alone where it shows much."""

from math import ceil, floor, log10

LITTLE = 1.5  # decades, below which powers of ten are too few to read a value from
STEPS = ((1.0, 2.0, 5.0), (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0))
EVEN = (1, 2, 2.5, 5, 10)  # of ticks at even distances
FEWEST = 3  # ticks of an axis, below which the next steps are taken
PLAIN = 1e-3, 1e6  # numbers that are written out


def set_log_ticks(axis) -> None:
    """Readable ticks of a logarithmic matplotlib axis whose limits are set."""
    from matplotlib.ticker import FuncFormatter, NullFormatter

    low, high = axis.get_view_interval()
    axis.set_minor_formatter(NullFormatter())
    if log10(high / low) < LITTLE:
        axis.set_ticks(_ticks(low, high))
        axis.set_major_formatter(FuncFormatter(lambda value, _place: _text(value)))


def _ticks(low: float, high: float) -> list[float]:
    """A few round numbers between the limits."""
    from matplotlib.ticker import MaxNLocator

    for steps in STEPS:
        decades = range(floor(log10(low)), ceil(log10(high)) + 1)
        ticks = [step * 10.0**k for k in decades for step in steps if low <= step * 10.0**k <= high]
        if len(ticks) >= FEWEST:
            return ticks
    return [tick for tick in MaxNLocator(5, steps=EVEN).tick_values(low, high) if low <= tick <= high]


def _text(value: float) -> str:
    """0.05, 20 or 5,000; 2×10⁶ (in matplotlib's mathematics) outside PLAIN."""
    if PLAIN[0] <= value < PLAIN[1]:
        return f"{value:,.6g}"
    exponent = floor(log10(value) + 1e-9)
    return rf"${value / 10.0**exponent:.3g}\times10^{{{exponent}}}$"
