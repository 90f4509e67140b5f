"""Typed errors: one line each, saying what is wrong and what to do.

`exit_status` is what the command line ends with: 2 for bad input, 3 for a run that went wrong.
"""


class MatpointError(Exception):
    """Base of every error that matpoint raises on purpose."""

    exit_status = 2


class CardError(MatpointError):
    """A material card or scene document that cannot be read; the message begins with file and line."""


class MaterialError(MatpointError):
    """A material whose parameters or combination of models make no sense."""


class MeshError(MatpointError):
    """A mesh that cannot be used: inverted elements, missing boundary names, wrong cell types."""


class SceneError(MatpointError):
    """A scene or option that cannot be simulated as asked."""


class OutputError(MatpointError):
    """An output folder that cannot be used."""


class DiskFull(OutputError):
    """No space left for a run's results; what had been written is kept."""

    exit_status = 3


class UnsupportedError(MatpointError):
    """Something matpoint knows of but does not offer (yet); the message says what to use instead."""


class RunFailure(MatpointError):
    """A run that went wrong and could not be rescued by redoing the step with smaller increments."""

    exit_status = 3


class NoEquilibrium(RunFailure):
    """A quasi-static increment that could not be solved however small; the last converged state is kept."""


class LoadBeyondEquilibrium(NoEquilibrium):
    """Loads grow beyond what was found to be in equilibrium; the message names the largest that were."""


class SingularStiffness(RunFailure):
    """A body that can move without resistance; the message names the free motion."""
