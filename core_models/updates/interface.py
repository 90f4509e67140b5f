"""The generic functions of stress updates: what each has to answer."""

from core_models.dispatch import generic


@generic
def advance_rows(update, rows, statuses, count, model, viscosity, dt):
    """A step of the points that have been brought to the rows of a workspace (core_models.rows).

    Parameters
    ----------
    update : the stress update. rows, statuses : of a `Workspace`; state and balance after the step are left in the
    rows, the status of each point in `statuses`. count : points in the rows. model, viscosity : laws. dt : [s].
    """


@generic
def predict(update, material, f0, f1, point):
    """First part of a step at one point: kinematics and the elastic trial, in a straight line as far as that does.

    Parameters
    ----------
    update : the stress update. material : `Model` (laws by slot).
    f0, f1 : deformation gradient before and after the step. point : `PointState` before the step.

    Returns
    -------
    (status, `Prediction`, rotation as far as the update has it); the status UNSETTLED leaves the point to
    `predict_carefully`
    """


@generic
def predict_carefully(update, material, f0, f1, point):
    """The same as `predict` for any step: large rotations and those that no point can follow."""


@generic
def complete(update, material, prediction, correction, point):
    """Last part of a step at one point: what the return to the yield surface makes of the prediction.

    Returns
    -------
    (deviatoric stress in the update's measure, its work [J/m^3 of reference volume], isochoric elastic left
    Cauchy-Green tensor as far as the update has it)
    """


@generic
def stress_measure(update, volume_ratio):
    """Reference volumes per unit of volume of the update's stress measure: 1 for Kirchhoff, J for Cauchy."""
