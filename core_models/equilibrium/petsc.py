"""PETSc as a solver of sparse linear systems, on one process or, under mpirun, on many."""

import numpy as np

from core_models.equilibrium.pattern import Pattern
from core_models.equilibrium.stalled import Stalled

PREFIX = (
    "matpoint_"  # of its options in PETSc's database, for instance PETSC_OPTIONS="-matpoint_ksp_type gmres"
)


class Petsc:
    """PETSc's Krylov and direct solvers, through petsc4py; MUMPS unless PETSc's options with PREFIX say otherwise.

    Every process of MPI's world runs the same program and holds the same pattern. The matrix and its factors are
    spread over them, rows in equal parts; every process gets the whole solution, the same to the last bit.
    """

    name = "petsc"

    def __init__(self, pattern: Pattern) -> None:
        import petsc4py

        petsc4py.init()
        from petsc4py import PETSc

        world, size = PETSc.COMM_WORLD, pattern.size
        share = size // world.size + (world.rank < size % world.size)
        self._right = PETSc.Vec().createMPI((share, size), comm=world)
        first, last = self._right.getOwnershipRange()
        starts = pattern.row_starts[first : last + 1]
        self._entries = slice(starts[0], starts[-1])
        self._rows = (starts - starts[0]).astype(PETSc.IntType)
        self._columns = pattern.columns[self._entries].astype(PETSc.IntType)
        self._own = slice(first, last)
        zeros = np.zeros(len(self._columns))
        sizes = ((share, size), (share, size))
        self._matrix = PETSc.Mat().createAIJ(sizes, csr=(self._rows, self._columns, zeros), comm=world)
        self._found = self._right.duplicate()
        self._to_all, self._whole = PETSc.Scatter.toAll(self._found)
        self._solver = PETSc.KSP().create(world)
        self._solver.setType(PETSc.KSP.Type.PREONLY)
        conditioner = self._solver.getPC()
        conditioner.setType(PETSc.PC.Type.LU)
        conditioner.setFactorSolverType("mumps")
        self._solver.setOptionsPrefix(PREFIX)
        self._solver.setFromOptions()

    def solve(self, values: np.ndarray, right: np.ndarray) -> np.ndarray:
        """See `core_models.equilibrium.linear_solvers.LinearSolver`."""
        self._matrix.setValuesCSR(self._rows, self._columns, values[self._entries])
        self._matrix.assemble()
        self._solver.setOperators(self._matrix)
        columns = right.reshape(len(right), -1)
        return np.column_stack([self._solve_one(column) for column in columns.T]).reshape(right.shape)

    def _solve_one(self, right: np.ndarray) -> np.ndarray:
        self._right.setArray(right[self._own])
        self._solver.solve(self._right, self._found)
        reason = self._solver.getConvergedReason()
        if reason < 0:
            raise Stalled(f"the stiffness is singular, or PETSc's solver did not converge (reason {reason})")
        self._to_all.scatter(self._found, self._whole)
        return self._whole.getArray().copy()
