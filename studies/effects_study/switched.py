"""One run of the effects study."""

from dataclasses import dataclass

from studies.work_precision.measurement import Measurement

AS_IT_IS = "as it is"


@dataclass(frozen=True)
class Switched:
    """One run: the effect that is switched, to what, by which method, and what was measured."""

    effect: str
    to: str
    method: str
    run: Measurement
