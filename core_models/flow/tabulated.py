"""Flow stress from a table."""

from typing import NamedTuple

from core_models.laws import flow_stress


class TabulatedHardening(NamedTuple):
    """Flow stress from a table over plastic strain: straight lines between the points, constant beyond the last.

        sigma_y = stresses_0 + sum_i slope_i min(max(ep - strains_i, 0), strains_(i+1) - strains_i)

    Parameters
    ----------
    strains : equivalent plastic strains [-], from 0 upwards, at least two. stresses : flow stress at each [Pa], > 0.

    The slope at a point of the table is that of the line on its left. Kernels are compiled for each number of points.
    Source: the table's own; linear interpolation.
    """

    strains: tuple[float, ...]
    stresses: tuple[float, ...]

    def fault(self) -> str:
        """What is wrong with the parameters taken together; empty if nothing is."""
        if len(self.strains) != len(self.stresses):
            return f"{len(self.strains)} strains and {len(self.stresses)} stresses: give one stress for each strain"
        rising = all(a < b for a, b in zip(self.strains, self.strains[1:], strict=False))
        if self.strains[0] != 0.0 or not rising:
            return "the strains of the table must begin with 0 and rise: sort them"
        return ""


@flow_stress.register(TabulatedHardening)
def _(flow, hardening_variable, plastic_strain, plastic_rate, temperature):
    stress = flow.stresses[0]
    slope = (flow.stresses[1] - flow.stresses[0]) / flow.strains[1]
    for i in range(len(flow.strains) - 1):
        width = flow.strains[i + 1] - flow.strains[i]
        rise = (flow.stresses[i + 1] - flow.stresses[i]) / width
        passed = plastic_strain - flow.strains[i]
        stress += rise * min(max(passed, 0.0), width)
        slope = rise if passed > 0.0 else slope
    return stress, 0.0, slope if plastic_strain <= flow.strains[-1] else 0.0, 0.0, 0.0
