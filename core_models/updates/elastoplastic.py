"""A step of an elastic-plastic update in parts: elastic trial, return to the yield surface, completion.

The parts run one after the other over the rows of a block (core_models.rows), each first in a straight line for all
points and then carefully for those which that leaves.
"""

from core_models.columns import get_point, put_point
from core_models.compilation import inside_kernel
from core_models.laws import is_out
from core_models.rows import F0, F1, GUESS, LENGTH, ROTATION_1, get, get_tensor, put, put_vector
from core_models.status import OK, UNSETTLED
from core_models.updates.balance import complete_point, left_behind, put_balance
from core_models.updates.interface import predict, predict_carefully
from core_models.updates.prediction import (
    correct,
    get_correction,
    get_prediction,
    guess,
    put_correction,
    put_prediction,
    search,
)

STRAIGHT_ATTEMPTS = 3  # Newton steps of all points of a block at once, before single ones are searched for


@inside_kernel
def advance_elastoplastic(update, rows, statuses, count, model, viscosity, dt):
    """What `advance_rows` (core_models.updates.interface) does for an elastic-plastic update."""
    predict_rows(rows, statuses, count, model)
    correct_rows(rows, statuses, count, model, 1.0 / dt)
    complete_rows(rows, statuses, count, model, viscosity, dt)


@inside_kernel
def predict_rows(rows, statuses, count, model):
    """Elastic trials of the points in the rows."""
    for k in range(count):
        statuses[k], prediction, rotation = predict(
            model.update, model, get_tensor(rows, F0, k), get_tensor(rows, F1, k), get_point(rows, k)
        )
        put_prediction(rows, k, prediction)
        put_vector(rows, ROTATION_1, k, rotation)
    for k in range(first_unsettled(statuses, count), count):
        if statuses[k] == UNSETTLED:
            statuses[k], prediction, rotation = predict_carefully(
                model.update, model, get_tensor(rows, F0, k), get_tensor(rows, F1, k), get_point(rows, k)
            )
            put_prediction(rows, k, prediction)
            put_vector(rows, ROTATION_1, k, rotation)


@inside_kernel
def first_unsettled(statuses, count):
    """The first point that a straight line has left, `count` if there is none."""
    # Without this look ahead the compiler may take the careful way for every point, and drop the results.
    first = count
    for k in range(count):
        first = min(first, k if statuses[k] == UNSETTLED else count)
    return first


@inside_kernel
def correct_rows(rows, statuses, count, model, over_dt):
    """Returns to the yield surface of the points in the rows."""
    for k in range(count):
        put(rows, GUESS, k, guess(model, get_prediction(rows, k), over_dt, get_point(rows, k)))
    for attempt in range(STRAIGHT_ATTEMPTS):
        for k in range(count):
            status, correction = correct(
                model, get_prediction(rows, k), get(rows, GUESS, k), over_dt, get_point(rows, k)
            )
            put_correction(rows, k, correction)
            statuses[k] = status if statuses[k] == OK else statuses[k]
        if attempt == STRAIGHT_ATTEMPTS - 1 or first_unsettled(statuses, count) == count:
            break
        for k in range(count):
            # A point that is settled keeps its guess, and so its result.
            is_unsettled = statuses[k] == UNSETTLED
            better = max(get_correction(rows, k).increment, 0.0)
            put(rows, GUESS, k, better if is_unsettled else get(rows, GUESS, k))
            statuses[k] = OK if is_unsettled else statuses[k]
    for k in range(first_unsettled(statuses, count), count):
        if statuses[k] == UNSETTLED:
            statuses[k], correction = search(model, get_prediction(rows, k), over_dt, get_point(rows, k))
            put_correction(rows, k, correction)


@inside_kernel
def complete_rows(rows, statuses, count, model, viscosity, dt):
    """State after the step of the points in the rows."""
    for k in range(count):
        before = get_point(rows, k)
        point, balance = complete_point(
            model,
            viscosity,
            get_prediction(rows, k),
            get_correction(rows, k),
            dt,
            get(rows, LENGTH, k),
            before,
        )
        if is_out(model.erosion, before.damage):
            point, balance = left_behind(before)
            statuses[k] = OK
            put_vector(rows, ROTATION_1, k, before.rotation)
        put_point(rows, k, point)
        put_balance(rows, k, balance)
