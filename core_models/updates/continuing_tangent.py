"""The tangent of continued flow: that of the next, infinitely small step from where points are, at constant rate.

Other than the tangent of a step it leaves the change of the rate out, which would hide every instability behind the
smallest rate dependence, and takes the heat of the plastic work in.
"""

from core_models.columns import gather, get_point
from core_models.compilation import CHUNK, beside_kernel, inside_kernel, material_kernel
from core_models.dispatch import generic
from core_models.laws import evolve_hardening, flow_stress, heat_capacity, heated_fraction
from core_models.rows import BLOCK, F0, get_tensor
from core_models.updates import hyperelastic_tangent, hypoelastic_tangent  # noqa: F401
from core_models.updates.conditions import flow_before
from core_models.updates.elastoplastic_tangent import linearise_point
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.updates.interface import predict_carefully, stress_measure
from core_models.updates.prediction import Correction, has_no_strength

YIELDING = 1.0 - 1e-6  # of the flow stress without rate, from which a point is taken to flow on
LOWEST_RATE, HIGHEST_RATE = 1e-8, 1e12  # 1/s
BISECTIONS = 60
TINY = 1e-300  # of an increment of plastic strain: it says that the point flows, and changes nothing else


@material_kernel
def continuing_tangents(first, last, workspace, model, f, state, stresses, tangents):
    """Tangents of continued flow of the points of chunks first ... last-1.

    Parameters
    ----------
    workspace, model : see `advance_points` (core_models.kernels). f, state : (n, 9) deformation gradient, `State`.
    stresses, tangents : (n, 9) first Piola stress [Pa] and (n, 9, 9) dP/dF [Pa], written.
    """
    n = f.shape[0]
    rows, _statuses = workspace
    for chunk in range(first, last):
        end = min((chunk + 1) * CHUNK, n)
        for start in range(chunk * CHUNK, end, BLOCK):
            count = min(BLOCK, end - start)
            gather(rows, start, count, f, f, None, state)
            for k in range(count):
                continue_point(
                    model.update, rows, k, model, get_point(rows, k), start + k, stresses, tangents
                )


@generic
def continue_point(update, rows, k, model, point, place, stresses, tangents):
    """Write first Piola stress and tangent of a point; that of an elastic step where it does not flow.

    Parameters
    ----------
    update : the stress update. rows, k, point : where the point stands, its deformation gradient as F0, and its state.
    model : laws. place, stresses, tangents : see `continuing_tangents`, and the number of the point.
    """


@continue_point.register(HypoelasticPlastic)
def _(update, rows, k, model, point, place, stresses, tangents):
    continue_radially(model, get_tensor(rows, F0, k), point, place, stresses, tangents)


@continue_point.register(HyperelasticPlastic)
def _(update, rows, k, model, point, place, stresses, tangents):
    continue_radially(model, get_tensor(rows, F0, k), point, place, stresses, tangents)


@inside_kernel
def continue_radially(model, f, point, place, stresses, tangents):
    """The same for von Mises' surface at rest."""
    _status, prediction, _rotation = predict_carefully(model.update, model, f, f, point)
    j = prediction.volume_ratio_1
    flow = flow_before(model, point, j)
    capacity = model.density * heat_capacity(model.specific_heat, point.temperature)
    heat = heated_fraction(model.heating) * stress_measure(model.update, j) / capacity
    is_flowing, modulus = continued_hardening(flow, prediction.stress, point, heat)
    is_flowing = is_flowing and not has_no_strength(model, point, j)
    correction = Correction(1.0, TINY if is_flowing else 0.0, prediction.stress, point.hardening_variable)
    linearise_point(model, f, f, point, point, prediction, correction, modulus, place, stresses, tangents)


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
