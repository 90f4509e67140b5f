"""Linear hats and particles that have just entered a cell: nodes with next to no mass."""

import logging

import numpy as np
import pytest

UPPER_POINT = 0.5 + 0.5 / np.sqrt(3.0)  # of two Gauss points along an edge
STEPS = 30


def stretched(body, share, **options):
    """A block whose particles at two edges have but a share of a cell left of them; it is drawn out, and swings."""
    corner = 1.5 - UPPER_POINT + share

    def velocity(x):
        return np.column_stack([3e4 * (x[:, 0] - x[:, 0].mean()), 0.0 * x[:, 0]])

    return body(corner=(corner, corner), interpolation="linear", velocity=velocity, **options)


@pytest.mark.parametrize("share", [0.3, 1e-3, 1e-6])
def test_musl_with_flip_does_not_feel_small_masses(body, share):
    """The energy holds to 1e-3 and volumes to 2 %, whatever share of a node's mass the particles have."""
    solver = stretched(body, share, transfer="flip", update="musl")
    for _ in range(STEPS):
        solver.advance()
        assert abs(solver.ledger.relative_error) < 1e-3
    assert np.abs(solver.volume_ratio - 1.0).max() < 0.02


def test_what_is_unstable_says_so(body, caplog):
    """By a warning that names what is stable, which gives none."""
    with caplog.at_level(logging.WARNING):
        for options in ({}, {"transfer": "flip"}, {"update": "musl"}):
            stretched(body, 0.3, **options)
            assert "give transfer='flip', update='musl'" in caplog.records[-1].message
        caplog.clear()
        stretched(body, 0.3, transfer="flip", update="musl")
        body()
        assert not caplog.records
