"""Ticks of logarithmic axes: plain numbers where an axis shows little, powers of ten alone where it shows much."""

from math import floor, log10

LITTLE = 1.5  # decades, below which powers of ten are too few to read a value from
STEPS = (1.0, 2.0, 5.0)
PLAIN = 1e-3, 1e5  # numbers that are written out


def set_log_ticks(axis) -> None:
    """Readable ticks of a logarithmic matplotlib axis whose limits are set."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

    low, high = axis.get_view_interval()
    axis.set_minor_formatter(NullFormatter())
    if log10(high / low) < LITTLE:
        axis.set_major_locator(LogLocator(subs=STEPS))
        axis.set_major_formatter(FuncFormatter(lambda value, _place: tick_text(value)))


def tick_text(value: float) -> str:
    """0.05, 20 or 5,000; 2×10⁶ (in matplotlib's mathematics) outside PLAIN."""
    if PLAIN[0] <= value < PLAIN[1]:
        return f"{value:,.6g}"
    exponent = floor(log10(value) + 1e-9)
    return rf"${value / 10.0**exponent:.3g}\times10^{{{exponent}}}$"
