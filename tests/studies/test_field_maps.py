"""Fields of two runs on one mesh, and the norm of their difference."""

from types import SimpleNamespace

import numpy as np
import pytest

from studies.comparisons.comparing import compare
from studies.comparisons.field_maps import field_maps

RADIUS, LENGTH = 2.0, 3.0


def made_run(resolution, value, seed):
    """A run of scattered points with a field that is a function of their places."""
    random = np.random.default_rng(seed)
    reference = random.uniform(0.0, 1.0, (20_000, 2)) * [RADIUS, LENGTH]
    final = SimpleNamespace(
        reference=reference, volumes=reference[:, 0], fields={"temperature": value(*reference.T)}
    )
    scene = SimpleNamespace(bar=SimpleNamespace(radius=RADIUS, length=LENGTH, temperature=300.0))
    return SimpleNamespace(scene=scene, resolution=resolution, final=final, label=f"run {resolution}")


def test_norms_are_those_of_the_difference_over_the_volume():
    """For T1 = 300 + z and T2 = T1 + r: sqrt(<r^2>) = R / sqrt 2 by the rise's sqrt(<z^2>) = L / sqrt 3."""
    first = made_run(16, lambda r, z: 300.0 + z, 1)
    second = made_run(20, lambda r, z: 300.0 + z + r, 2)
    maps = field_maps(first, second)
    (gap,) = maps.gaps
    assert maps.cells.shape == (16 * 24, 4, 2)
    assert gap.rms == pytest.approx(RADIUS / np.sqrt(2.0), rel=0.01)
    assert gap.relative == pytest.approx(RADIUS / np.sqrt(2.0) / (LENGTH / np.sqrt(3.0)), rel=0.01)
    assert gap.position[0] > 0.9 * RADIUS and gap.largest == pytest.approx(RADIUS, rel=0.1)
    assert np.ptp(maps.cells[maps.cell_of[0]][:, 0]) == pytest.approx(RADIUS / 16)


def test_cells_without_points_count_for_nothing():
    """They are NaN in the maps and left out of the norms."""
    first, second = (made_run(8, lambda r, z: np.full_like(r, 400.0), seed) for seed in (3, 4))
    kept = second.final.reference[:, 1] > 1.0
    second.final = SimpleNamespace(
        reference=second.final.reference[kept],
        volumes=second.final.volumes[kept],
        fields={"temperature": np.full(kept.sum(), 410.0)},
    )
    maps = field_maps(first, second)
    assert np.isnan(maps.second["temperature"]).any() and not np.isnan(maps.first["temperature"]).any()
    assert maps.gaps[0].rms == pytest.approx(10.0) and maps.gaps[0].relative == pytest.approx(0.1)


def test_a_comparison_writes_its_maps_for_paraview(fake_solvers, classic, tmp_path):
    """Both fields and their difference over the undeformed bar and on the final shape; norms in results.json."""
    from meshes.io import read_mesh

    comparison = compare(classic, resolutions=(4, 6), wall="plane", out=tmp_path / "out")
    assert [gap.field for gap in comparison.maps.gaps] == ["equivalent_plastic_strain", "pressure"]
    text = (tmp_path / "out/difference.vtu").read_text(errors="replace")
    assert "pressure_difference" in text and "equivalent_plastic_strain_first" in text
    assert len(read_mesh(tmp_path / "out/difference-deformed.vtu").cells) == 2
