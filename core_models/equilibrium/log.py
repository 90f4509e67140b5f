"""The convergence log: every iteration, increment and cut as a record, readable by machine and by eye."""

import json
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path

from core_models.errors import OutputError

CONVERGED, CUT = "converged", "cut"


@dataclass(frozen=True)
class Start:
    """What is solved: number of free degrees of freedom, entries of the stiffness, name of the linear solver.

    condition : number of the stiffness of the undeformed body in the 1-norm, an estimate, where the method asks for it.
    """

    method: str
    dofs: int
    entries: int
    linear_solver: str
    condition: float | None = None
    kind: str = "start"


@dataclass(frozen=True)
class Iteration:
    """One evaluation of the balance of forces.

    increment, attempt, iteration : counted from 1, 0 and 0. time : of the loads, which is the end of the increment
    unless a path is followed, step : size of the increment [s].
    residual : Euclidean norm of the forces out of balance [N]; relative : over that of all forces on nodes.
    energy : |residual before . correction| that led here [J]. worst : largest force out of balance [N], at `node` along
    `component`. length : of the line search, 1 for a whole correction. plastic : points that flow; same : whether they
    are those of the iteration before.
    """

    increment: int
    attempt: int
    iteration: int
    time: float
    step: float
    residual: float
    relative: float
    energy: float
    worst: float
    node: int
    component: int
    length: float
    plastic: int
    same: bool
    kind: str = "iteration"


@dataclass(frozen=True)
class Increment:
    """The end of an attempt at an increment: 'converged', or 'cut' with the reason."""

    increment: int
    attempt: int
    iterations: int
    time: float
    step: float
    outcome: str
    reason: str = ""
    kind: str = "increment"


Record = Start | Iteration | Increment


class ConvergenceLog:
    """Records in the order of events; `path` : file for JSON lines, written as they come, or None."""

    def __init__(self, path: Path | str | None = None) -> None:
        self.records: list[Record] = []
        self._path = None if path is None else Path(path)
        if self._path is not None:
            try:
                self._path.write_text("", encoding="utf-8")
            except OSError as reason:
                raise OutputError(
                    f"{path}: the log cannot be written ({reason.strerror}); name another file"
                ) from None

    def add(self, record: Record) -> None:
        """Keep a record, and write it to the file."""
        self.records.append(record)
        if self._path is not None:
            with self._path.open("a", encoding="utf-8") as file:
                file.write(json.dumps(asdict(record)) + "\n")

    @property
    def iterations(self) -> list[Iteration]:
        """The iterations of all attempts."""
        return [record for record in self.records if isinstance(record, Iteration)]

    @property
    def increments(self) -> list[Increment]:
        """The increments that converged."""
        return [each for each in self._ends() if each.outcome == CONVERGED]

    @property
    def cuts(self) -> list[Increment]:
        """The attempts that were cut."""
        return [each for each in self._ends() if each.outcome == CUT]

    def _ends(self) -> Iterator[Increment]:
        return (record for record in self.records if isinstance(record, Increment))

    def text(self) -> str:
        """The log as a table."""
        return "\n".join([_HEAD, *(_line(record) for record in self.records)])


_HEAD = (
    f"{'inc':>5} {'try':>3} {'it':>3} {'time [s]':>12} {'step [s]':>10} {'residual [N]':>12} {'relative':>9} "
    f"{'energy [J]':>10} {'worst [N]':>10} {'node':>6} {'dof':>3} {'search':>6} {'plastic':>7}"
)


def _line(record: Record) -> str:
    if isinstance(record, Start):
        condition = "" if record.condition is None else f", condition number {record.condition:.1e}"
        head = f"{record.method}: {record.dofs} free dofs, {record.entries} entries"
        return f"{head}, solved by {record.linear_solver}{condition}"
    head = f"{record.increment:5d} {record.attempt:3d}"
    if isinstance(record, Increment):
        reason = f": {record.reason}" if record.reason else ""
        return f"{head}     {record.outcome} after {record.iterations} iterations{reason}"
    return (
        f"{head} {record.iteration:3d} {record.time:12.6e} {record.step:10.3e} {record.residual:12.4e} "
        f"{record.relative:9.2e} {record.energy:10.3e} {record.worst:10.3e} {record.node:6d} {record.component:3d} "
        f"{record.length:6.3f} {record.plastic:7d}{'' if record.same else '*'}"
    )
