"""A scene: what to simulate, as plain data. Lengths in m, times in s, velocities in m/s, temperatures in K."""

from dataclasses import dataclass, field
from math import sqrt
from pathlib import Path

from core_models.bulk_viscosity import BulkViscosity
from core_models.conduction import check_conduction
from core_models.errors import SceneError
from core_models.laws import elastic_moduli
from core_models.material import Material
from core_models.walls import UNILATERAL, Wall


@dataclass(frozen=True)
class Bar:
    """A cylinder flying along its axis towards the wall at its foot.

    radius, length [m]; velocity [m/s], axial, negative towards the wall; temperature [K].
    """

    radius: float
    length: float
    velocity: float
    temperature: float

    def __post_init__(self) -> None:
        for name in ("radius", "length", "temperature"):
            if not getattr(self, name) > 0.0:
                raise SceneError(f"the bar's {name} must be positive, not {getattr(self, name):g}")
        if not self.velocity < 0.0:
            raise SceneError(
                f"the bar's axial velocity must point to the wall (negative), not {self.velocity:g}"
            )


@dataclass(frozen=True)
class End:
    """When a scene ends [s].

    time: at this time, whatever the wall. Or: one axial period after the bar has left a unilateral wall, at
    `latest` at the latest; under a plane wall, which never lets go, at `plane`.
    """

    time: float | None = None
    latest: float | None = None
    plane: float | None = None

    def __post_init__(self) -> None:
        given = [value for value in (self.time, self.latest, self.plane) if value is not None]
        if any(not value > 0.0 for value in given):
            raise SceneError("a scene's end times must be positive")
        if (self.time is None) == (self.latest is None):
            raise SceneError("a scene ends either at a time or after release (then give the latest time)")

    def after_release(self, wall: str) -> bool:
        """Whether the scene ends when the bar has left this wall."""
        return self.time is None and wall == UNILATERAL

    def limit(self, wall: str) -> float:
        """The time at which a run under this wall ends in any case [s]."""
        if self.time is not None:
            return self.time
        return self.latest if wall == UNILATERAL or self.plane is None else self.plane


@dataclass(frozen=True)
class Reference:
    """A value from elsewhere to state next to ours: low <= value <= high in SI, under which wall, whose."""

    quantity: str
    low: float
    high: float
    source: str
    wall: str | None = None


@dataclass(frozen=True)
class ReferenceCurve:
    """A curve from elsewhere (CSV in SI): kind 'history' (t, length, foot_radius) or 'profile' (r, z)."""

    kind: str
    path: Path
    source: str
    wall: str | None = None


@dataclass(frozen=True)
class Scene:
    """A bar of one material hitting a rigid wall at z = 0, axisymmetric about z.

    wall: the wall's kind; friction: its Coulomb coefficient [-]. conduction: whether heat is conducted in the bar,
    which is insulated.
    resolutions: method name -> elements or cells across the radius, coarse to fine; a single run takes the
    last. mesh: the user's own quad mesh instead of the cylinder's; laws: the user's own law file, already loaded.
    """

    name: str
    material: Material
    bar: Bar
    end: End
    wall: str = UNILATERAL
    friction: float = 0.0
    viscosity: BulkViscosity | None = field(default_factory=BulkViscosity)
    conduction: bool = False
    resolutions: dict[str, tuple[int, ...]] = field(default_factory=dict)
    description: str = ""
    references: tuple[Reference, ...] = ()
    curves: tuple[ReferenceCurve, ...] = ()
    mesh: Path | None = None
    laws: Path | None = None
    unused: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        Wall(self.wall, self.friction)
        if self.conduction:
            check_conduction(self.material)

    @property
    def wave_speed(self) -> float:
        """Speed of elastic waves of volume [m/s]: sqrt((K + 4/3 G) / rho)."""
        bulk, shear = elastic_moduli(self.material.elasticity)
        return sqrt((bulk + 4.0 / 3.0 * shear) / self.material.density)

    @property
    def axial_period(self) -> float:
        """Time of an elastic wave along the undeformed bar and back [s]: 2 L0 / sqrt(E / rho)."""
        bulk, shear = elastic_moduli(self.material.elasticity)
        young = 9.0 * bulk * shear / (3.0 * bulk + shear)
        return 2.0 * self.bar.length / sqrt(young / self.material.density)
