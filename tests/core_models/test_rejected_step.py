"""A step that a point cannot take leaves nothing behind."""

import numpy as np
import pytest

from core_models.points import MaterialPoints, PointFailure


@pytest.mark.parametrize("bad", [-1.0, np.nan, np.inf])
def test_a_rejected_step_changes_nothing_in_the_next(pool, bad):
    """After a point was inverted or not a number, the redone step gives the bits of one that never failed."""
    for material in pool.values():
        tried, fresh = MaterialPoints(material, np.ones(3)), MaterialPoints(material, np.ones(3))
        tried.deformation_gradient[1, 0, 0] = bad
        with pytest.raises(PointFailure):
            tried.advance(1e-8)
        for points in (tried, fresh):
            points.deformation_gradient[:] = np.diag([1.01, 0.995, 0.996])
            points.advance(1e-8)
            points.accept()
        for name, field in fresh.fields().items():
            assert np.array_equal(field.array, tried.fields()[name].array), (material.name, name)
