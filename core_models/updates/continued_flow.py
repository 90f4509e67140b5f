"""How a point flows on from where it is, at constant rate, and the tangent of that for von Mises' surface."""

from core_models.columns import get_point
from core_models.compilation import beside_kernel, inside_kernel
from core_models.dispatch import generic
from core_models.laws import (
    evolve_hardening,
    flow_stress,
    heat_capacity,
    heated_fraction,
    predict_carefully,
    stress_measure,
)
from core_models.rows import F0, get_tensor
from core_models.updates import hyperelastic_tangent, hypoelastic_tangent  # noqa: F401
from core_models.updates.conditions import flow_before
from core_models.updates.elastoplastic_tangent import linearise_point
from core_models.updates.prediction import Correction, has_no_strength

YIELDING = 1.0 - 1e-6  # of the flow stress without rate, from which a point is taken to flow on
LOWEST_RATE, HIGHEST_RATE = 1e-8, 1e12  # 1/s
BISECTIONS = 60
TINY = 1e-300  # of an increment of plastic strain: it says that the point flows, and changes nothing else


@generic
def continue_point(update, model, rows, k, place, stresses, tangents):
    """Write first Piola stress and tangent of a point; that of an elastic step where it does not flow."""


@continue_point.otherwise
def _(update, model, rows, k, place, stresses, tangents):
    f, point = get_tensor(rows, F0, k), get_point(rows, k)
    _status, prediction, _rotation = predict_carefully(model.update, model, f, f, point)
    j = prediction.volume_ratio_1
    flow = flow_before(model, point, j)
    heat = warming(model, point, stress_measure(model.update, j))
    is_flowing, modulus = continued_hardening(flow, prediction.stress, point, heat)
    is_flowing = is_flowing and not has_no_strength(model, point, j)
    correction = Correction(1.0, TINY if is_flowing else 0.0, prediction.stress, point.hardening_variable)
    linearise_point(model, f, f, point, point, prediction, correction, modulus, place, stresses, tangents)


@inside_kernel
def warming(model, point, measure):
    """Rise of the temperature [K m^3/J] per plastic work of a unit of the stress measure's volume."""
    return (
        heated_fraction(model.heating)
        * measure
        / (model.density * heat_capacity(model.specific_heat, point.temperature))
    )


@generic
def continued_hardening(flow, stress, point, heat):
    """Whether a point flows, and the slope of its flow stress by plastic strain at constant rate [Pa].

    Parameters
    ----------
    stress : its equivalent stress [Pa]. heat : rise of the temperature per plastic work [K m^3/J].
    """


@continued_hardening.register(type(None))
def _(flow, stress, point, heat):
    return False, 0.0


@continued_hardening.otherwise
def _(flow, stress, point, heat):
    return _hardening(flow, stress, point, heat)


@beside_kernel
def _hardening(flow, stress, point, heat):
    strain, variable, temperature = (
        point.equivalent_plastic_strain,
        point.hardening_variable,
        point.temperature,
    )
    static = flow_stress(flow, variable, strain, 0.0, temperature)[0]
    if stress == 0.0 or stress < YIELDING * static:
        return False, 0.0
    rate = _rate_at(flow, stress, variable, strain, temperature)
    evolution = evolve_hardening(flow, variable, 0.0, rate, temperature)[1]
    _stress, by_variable, by_strain, _by_rate, by_temperature = flow_stress(
        flow, variable, strain, rate, temperature
    )
    return True, by_strain + by_variable * evolution + by_temperature * heat * stress


@inside_kernel
def _rate_at(flow, stress, variable, strain, temperature):
    """Plastic rate at which the flow stress is a stress, by bisection of the logarithm [1/s]."""
    low, high = LOWEST_RATE, HIGHEST_RATE
    for _bisection in range(BISECTIONS):
        middle = (low * high) ** 0.5
        if flow_stress(flow, variable, strain, middle, temperature)[0] < stress:
            low = middle
        else:
            high = middle
    return low
