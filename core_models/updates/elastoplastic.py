"""A step of an elastic-plastic update in parts: elastic trial, return to the yield surface, completion.

The parts run one after the other over the rows of a chunk (core_models.rows), each first in a straight line for all
points and then carefully for those which that leaves.
"""

from core_models.columns import get_point, put_point
from core_models.compilation import inside_kernel
from core_models.laws import predict, predict_carefully
from core_models.rows import (
    F0,
    F1,
    LEFT_STRETCH,
    LENGTH,
    ROTATION,
    get,
    get_tensor,
    put_symmetric,
    put_tensor,
)
from core_models.state import load_point
from core_models.status import OK, UNSETTLED
from core_models.tensors import load_tensor
from core_models.updates.balance import complete_point, put_balance
from core_models.updates.prediction import (
    correct,
    get_correction,
    get_prediction,
    put_correction,
    put_prediction,
    search,
)


@inside_kernel
def advance_elastoplastic(update, rows, statuses, count, start, model, viscosity, f0, f1, dt, old):
    """What `advance_rows` (core_models.laws) does for an elastic-plastic update."""
    predict_rows(rows, statuses, count, start, model, f0, f1, old)
    correct_rows(rows, statuses, count, model, 1.0 / dt)
    complete_rows(rows, count, model, viscosity, dt)


@inside_kernel
def predict_rows(rows, statuses, count, start, model, f0, f1, old):
    """Elastic trials of the points in the rows."""
    for k in range(count):
        statuses[k], prediction, rotation, left_stretch = predict(
            model.update, model, get_tensor(rows, F0, k), get_tensor(rows, F1, k), get_point(rows, k)
        )
        put_trial(rows, k, prediction, rotation, left_stretch)
    for k in range(count):
        if statuses[k] == UNSETTLED:
            i = start + k
            statuses[k], prediction, rotation, left_stretch = predict_carefully(
                model.update, model, load_tensor(f0, i), load_tensor(f1, i), load_point(old, i)
            )
            put_trial(rows, k, prediction, rotation, left_stretch)


@inside_kernel
def put_trial(rows, k, prediction, rotation, left_stretch):
    """Write the results of a first part at point k."""
    put_prediction(rows, k, prediction)
    put_tensor(rows, ROTATION, k, rotation)
    put_symmetric(rows, LEFT_STRETCH, k, left_stretch)


@inside_kernel
def correct_rows(rows, statuses, count, model, over_dt):
    """Returns to the yield surface of the points in the rows."""
    for k in range(count):
        status, correction = correct(model, get_prediction(rows, k), over_dt, get_point(rows, k))
        put_correction(rows, k, correction)
        statuses[k] = status if statuses[k] == OK else statuses[k]
    for k in range(count):
        if statuses[k] == UNSETTLED:
            statuses[k], correction = search(model, get_prediction(rows, k), over_dt, get_point(rows, k))
            put_correction(rows, k, correction)


@inside_kernel
def complete_rows(rows, count, model, viscosity, dt):
    """State after the step of the points in the rows."""
    for k in range(count):
        point, balance = complete_point(
            model, viscosity, get_prediction(rows, k), get_correction(rows, k), dt, get(rows, LENGTH, k),
            get_point(rows, k),
        )  # fmt: skip
        put_point(rows, k, point)
        put_balance(rows, k, balance)
