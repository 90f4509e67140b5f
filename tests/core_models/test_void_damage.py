"""Damage by the growth of voids: Hancock-Mackenzie and Sandia."""

import math

import pytest
from scipy.integrate import solve_ivp

from core_models.damage.hancock_mackenzie import HancockMackenzieDamage
from core_models.damage.sandia import SandiaDamage, porosity, void_growth
from core_models.laws import damage_increment

HANCOCK = HancockMackenzieDamage(0.0, 1.0)
GROWTH = """1e-4 2  0.3333333333 0.000123238 0.000100623
            1e-4 2  1 0.000452884 0.000369778
            1e-4 2  2 0.00164003 0.00133908
            1e-4 5  0.3333333333 0.00034383 0.000280736
            1e-4 5  1 0.0014829 0.00121078
            1e-4 5  2 0.00790556 0.00645487
            1e-4 10 0.3333333333 0.000704815 0.000575479
            1e-4 10 1 0.00327073 0.00267054
            1e-4 10 2 0.0205116 0.0167477
            0.01 2  0.3333333333 0.0124475 0.0101633
            0.01 2  1 0.0457428 0.0373488
            0.01 2  2 0.165649 0.135252
            0.01 5  0.3333333333 0.0352542 0.028785
            0.01 5  1 0.152048 0.124146
            0.01 5  2 0.810588 0.661842
            0.01 10 0.3333333333 0.0741141 0.0605139
            0.01 10 1 0.34393 0.280818
            0.01 10 2 2.15688 1.76109"""


def grown(law, strain, triaxiality):
    """Increase of the damage variable over a strain."""
    return damage_increment(law, strain, 1.0, 300.0, triaxiality * 2e8, 2e8)


def test_hancock_mackenzie_values():
    """D = 0.29977 at a strain of 0.3 in uniaxial tension; its failure strain is 1.0008; pressure slows it down."""
    assert grown(HANCOCK, 0.3, 1.0 / 3.0) == pytest.approx(0.29977, abs=0.5e-5)
    assert 1.0 / grown(HANCOCK, 1.0, 1.0 / 3.0) == pytest.approx(1.0008, abs=0.5e-4)
    assert grown(HANCOCK, 1.0, -1.0) == pytest.approx(math.exp(-1.5) / 1.65, rel=1e-12)


def test_hancock_mackenzie_from_its_initial_to_its_critical_damage():
    """What points carry goes from 0 to 1 while the damage of the paper goes from 1e-4 to 0.7."""
    assert grown(HancockMackenzieDamage(1e-4, 0.7), 0.2, 0.5) == pytest.approx(
        grown(HANCOCK, 0.2, 0.5) / 0.6999
    )


@pytest.mark.parametrize("line", GROWTH.splitlines(), ids=lambda line: "-".join(line.split()[:3]))
def test_void_growth(line):
    """The classic form of Cocks and Ashby; LAME's is sqrt(2/3) of it."""
    phi, m, triaxiality, classic, lame = map(float, line.split())
    rate = void_growth(SandiaDamage(m, 1e-5, 0.3), phi, triaxiality)
    assert rate == pytest.approx(classic, rel=1e-5)
    assert math.sqrt(2.0 / 3.0) * rate == pytest.approx(lame, rel=1e-5)


@pytest.mark.parametrize("m", [2.0, 5.0, 10.0])
def test_sandia_damage_is_its_growth_law_integrated(m):
    """Steps of any size reach the porosity that the growth law reaches, solved as a differential equation."""
    law, strain, triaxiality = SandiaDamage(m, 1e-3, 0.2), 0.25 / m, 0.8
    solved = solve_ivp(
        lambda _strain, phi: void_growth(law, phi[0], triaxiality),
        (0.0, strain),
        [1e-3],
        rtol=1e-12,
        atol=1e-16,
    )
    damage = sum(grown(law, part * strain, triaxiality) for part in (0.1, 0.6, 0.3))
    assert porosity(law, damage) == pytest.approx(solved.y[0, -1], rel=1e-9)
    assert porosity(law, damage) > 1.2e-3


def test_sandia_damage_fails_at_its_critical_porosity():
    """0 is the initial porosity, 1 the critical one; voids do not shrink, nor grow without plastic strain or stress."""
    law = SandiaDamage(4.0, 1e-4, 0.15)
    assert porosity(law, 0.0) == pytest.approx(1e-4, rel=1e-9)
    assert porosity(law, 1.0) == pytest.approx(0.15, rel=1e-12)
    assert (
        grown(law, 0.1, -1.0)
        == grown(law, 0.0, 1.0)
        == damage_increment(law, 0.1, 1.0, 300.0, 1e8, 0.0)
        == 0.0
    )


@pytest.mark.parametrize("law", [HANCOCK, SandiaDamage(2.0, 1e-3, 0.2)], ids=lambda law: type(law).__name__)
def test_damage_stays_finite(law):
    """Next to no shear stress under any tension or pressure, whatever the strain."""
    for mean in (-1e12, -1.0, 0.0, 1.0, 1e12):
        for equivalent in (1e-300, 1e-9, 1e9):
            increment = damage_increment(law, 1.0, 1e4, 300.0, mean, equivalent)
            assert math.isfinite(increment)
            assert increment >= 0.0
