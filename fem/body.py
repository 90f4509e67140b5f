"""A body of finite elements: its tables, and the kernels that run over its elements."""

import numpy as np

from core_models.geometry import Geometry
from core_models.laws import elastic_moduli
from core_models.material import Material
from core_models.points import MaterialPoints, PointFailure
from core_models.status import OK
from core_models.threads import Threads
from fem.cures.choice import make_cure
from fem.cures.nodal_average import NODE_CHUNK, NodalAverage, average_pressures, average_ratios
from fem.deformation import ELEMENT_CHUNK, deform
from fem.elements import MOST_POINTS, find_element, is_one_point_brick
from fem.hourglass import make_hourglass, resist_hourglass, square_frequencies
from fem.metric import make_metric
from fem.resistance import resist
from fem.stable_step import SCRATCH_COLUMNS
from fem.tables import elements_round_nodes, make_space
from meshes.mesh import Mesh


class Body:
    """Elements of a mesh in a geometry, with integration, cure and its share; what the points see of nodes and back.

    nodal_mass : (n,) [kg]. corner_forces : (m a, d) internal forces on the corners of elements [N]. scales : (points,)
    (theta / J)^(1/3) of the cure, or None. hourglass_energy : [J].
    """

    def __init__(
        self, mesh: Mesh, material: Material, geometry: Geometry, integration: str, cure: str, share: float,
        hourglass: float, threads: Threads,
    ) -> None:  # fmt: skip
        self._threads, self._geometry, self._density = threads, geometry, material.density
        self._shear = elastic_moduli(material.elasticity)[1]
        self._element = find_element(mesh.kind, integration)
        self.space = make_space(mesh, geometry, integration, material.density)
        nodes, count = mesh.cells, len(mesh.points)
        self.nodal_mass = np.bincount(nodes.ravel(), weights=self.space.corner_mass.ravel(), minlength=count)
        self.round = elements_round_nodes(nodes, count)
        self._cure = make_cure(cure, mesh, self.space, share)
        self._hourglass, frequencies = None, None
        if is_one_point_brick(mesh.kind, integration):
            self._hourglass = make_hourglass(
                mesh.kind, mesh.points, self.space.tables, self._shear, hourglass
            )
            frequencies = square_frequencies(self._hourglass, self.space.corner_mass)
        self._metric = make_metric(
            self.space.tables, self.space.corner_mass, geometry, mesh.points, frequencies
        )
        self._forces = np.zeros((*nodes.shape, mesh.dimension))
        self.corner_forces = self._forces.reshape(-1, mesh.dimension)
        points = self.space.tables.weights.size
        self.scales = None if self._cure is None else np.ones(points)
        self._next_scales = None if self._cure is None else np.ones(points)
        self._scratch = [np.zeros((MOST_POINTS, SCRATCH_COLUMNS)) for _thread in range(threads.count)]
        self._chunks, self._node_chunks = -(-len(nodes) // ELEMENT_CHUNK), -(-count // NODE_CHUNK)
        self._failures = np.zeros((self._chunks, 2), dtype=np.int64)
        self._steps, self._energies = np.zeros(self._chunks), np.zeros(self._chunks)
        self.hourglass_energy = 0.0

    def deform(self, x: np.ndarray, points: MaterialPoints) -> None:
        """Give the points their deformation gradients for nodes at x (n, d) [m]; PointFailure if one is inverted."""
        if isinstance(self._cure, NodalAverage):
            self._threads.run(
                average_ratios, self._node_chunks, self._geometry, self._element, self.space.tables,
                self.round.start, self.round.entries, x, self._cure.means,
            )  # fmt: skip
        self._threads.run_with(
            deform, self._chunks, self._scratch, self._geometry, self._element, self._cure, self.space.tables, x,
            points.deformation_gradient, self._next_scales, points.lengths, self._failures,
        )  # fmt: skip
        bad = np.flatnonzero(self._failures[:, 0] != OK)
        if bad.size:
            raise PointFailure(*(int(value) for value in self._failures[bad[0]]))

    @property
    def trial_scales(self) -> np.ndarray | None:
        """(theta / J)^(1/3) of the last deformation (points,), accepted or not; None without a cure."""
        return self._next_scales

    def accept(self) -> None:
        """Make the last deformation the present one."""
        self.scales, self._next_scales = self._next_scales, self.scales

    def resist(self, x: np.ndarray, points: MaterialPoints) -> float:
        """Fill the internal forces for the present state of the points and return the stable step [s]."""
        stress, viscous = points.old.stress, points.viscous_pressure
        if isinstance(self._cure, NodalAverage):
            self._threads.run(
                average_pressures, self._node_chunks, self._element, self.space.tables, self.round.start,
                self.round.entries, stress, viscous, self._cure.means,
            )  # fmt: skip
        self._threads.run_with(
            resist, self._chunks, self._scratch, self._geometry, self._element, self._cure, self.space.tables,
            self._metric, points.old_deformation_gradient, self.scales, stress, viscous, points.wave_speed,
            points.viscosity, self._density, self._shear, self.space.corner_mass, self._forces, self._steps,
        )  # fmt: skip
        if self._hourglass is not None:
            self._threads.run(
                resist_hourglass, self._chunks, self._geometry, self._element, self.space.tables.nodes,
                self._hourglass, x, self._forces, self._energies,
            )  # fmt: skip
            self.hourglass_energy = float(self._energies.sum())
        return float(self._steps.min())

    def nodal_forces(self) -> np.ndarray:
        """Internal forces on the nodes (n, d) [N]."""
        nodes, count = self.space.tables.nodes.ravel(), len(self.nodal_mass)
        columns = [np.bincount(nodes, weights=column, minlength=count) for column in self.corner_forces.T]
        return np.column_stack(columns)
