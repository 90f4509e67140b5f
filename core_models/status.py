"""Status codes of the point update, and what to tell the user about each."""

OK = 0
INVERTED = 1
NOT_CONVERGED = 2
BEYOND_EOS = 3
NOT_FINITE = 4
UNSETTLED = 5  # only within a step: the straight line did not do, the careful way follows

MEANING = {
    INVERTED: "the point is inverted (det F <= 0)",
    NOT_CONVERGED: "the return to the yield surface did not converge",
    BEYOND_EOS: "the compression is beyond the pole of the equation of state",
    NOT_FINITE: "the stress is not finite",
}
