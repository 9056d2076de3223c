"""The native part of the package: use ``polhode``."""

from os import PathLike
from typing import Any, Callable, Mapping, Sequence, final

import numpy as np
from numpy.typing import ArrayLike, NDArray
from typing_extensions import Self, disjoint_base

from ._scene import Body, JointHandle, Vector

__all__ = [
    "BodyState",
    "Contact",
    "Coordinate",
    "Energy",
    "Finding",
    "JointLoad",
    "Loaded",
    "Momentum",
    "Recording",
    "Simulation",
    "Snapshot",
    "StepOutcome",
    "__version__",
    "boxes",
    "compare",
    "doctor",
    "gif",
    "impact_with_friction",
    "impact_without_friction",
    "judge",
    "material_keys",
    "mesh_of_file",
    "mesh_report",
    "page",
    "plot",
    "rest_poses",
    "robot_of_file",
    "rotate_free",
    "run",
    "solve_friction",
    "standing_limit",
    "stands",
    "still",
    "study",
]

__version__: str

_Change = tuple[str, str, str]
_Body = str | int | Body
_Joint = str | int | JointHandle
_Told = Callable[[float, float], None] | None

@final
class Loaded:
    """A scene that has been read; ``polhode.Scene`` and paths become one."""

    @staticmethod
    def file(path: str | PathLike[str], changes: Sequence[_Change]) -> Loaded: ...
    @staticmethod
    def text(origin: str, text: str, changes: Sequence[_Change]) -> Loaded: ...
    @property
    def name(self) -> str: ...
    @property
    def duration(self) -> float: ...
    @property
    def body_names(self) -> list[str]: ...
    @property
    def joint_names(self) -> list[str]: ...
    def source(self) -> tuple[str, list[str], list[_Change]]: ...

@final
class Recording:
    """What a run has told."""

    @property
    def body_names(self) -> list[str]: ...
    @property
    def joint_names(self) -> list[str]: ...
    @property
    def report(self) -> str | None: ...
    @property
    def certificate(self) -> str | None: ...
    @property
    def broken(self) -> str: ...
    @property
    def failure(self) -> BaseException | None: ...
    def times(self) -> NDArray[np.float64]: ...
    def states(self) -> NDArray[np.float64]: ...
    def errors(self) -> NDArray[np.float64] | None: ...
    def energies(self) -> NDArray[np.float64]: ...
    def joints(self) -> NDArray[np.float64]: ...
    def events(self) -> tuple[list[str], NDArray[np.int64], NDArray[np.float64]]: ...

def rotate_free(
    moments: Vector, angular_velocity: Vector, times: ArrayLike, orientation: Vector | None = None
) -> NDArray[np.float64]:
    """Attitudes of a free rotation at some times, s: (N, 4)."""

def solve_friction(
    matrix: NDArray[np.float64],
    free: NDArray[np.float64],
    coefficients: NDArray[np.float64],
    start: NDArray[np.float64] | None,
) -> dict[str, Any]: ...
def impact_without_friction(
    matrix: NDArray[np.float64],
    before: NDArray[np.float64],
    restitution: NDArray[np.float64],
    laws: dict[str, Any],
) -> dict[str, Any]: ...
def impact_with_friction(
    matrix: NDArray[np.float64],
    before: NDArray[np.float64],
    restitution: NDArray[np.float64],
    coefficients: NDArray[np.float64],
    laws: dict[str, Any],
) -> dict[str, Any]: ...
def material_keys() -> list[str]: ...
def mesh_of_file(path: str | PathLike[str]) -> tuple[NDArray[np.float64], NDArray[np.int64]]: ...
def robot_of_file(path: str | PathLike[str]) -> dict[str, Any]: ...
def doctor(path: str | PathLike[str]) -> list[Finding]: ...
def mesh_report(
    vertices: ArrayLike, triangles: ArrayLike, mass: float | None, density: float | None, is_hollow: bool
) -> str: ...
def run(loaded: Loaded, all_effects: bool, joints: bool, keep: float | None, told: _Told) -> Recording: ...
def page(recording: Recording, least_interval: float, told: _Told) -> str: ...
def plot(recording: Recording, names: Sequence[str], told: _Told) -> str: ...
def still(recording: Recording, t: float | None, asked: Mapping[str, Any], told: _Told) -> bytes: ...
def gif(recording: Recording, fps: float | None, asked: Mapping[str, Any], told: _Told) -> bytes: ...
def judge(path: str, loaded: Loaded, tolerance: float, truth: bool) -> str:
    """What is found of a trajectory as JSON, as ``polhode judge --json`` prints it."""

def compare(a: str, b: str, atol: float, rtol: float) -> str:
    """The largest difference of every column of two trajectories as JSON."""

def standing_limit(loaded: Loaded, interval: str, digits: int) -> str:
    """Up to which value of a key a scene stands, as JSON, as ``polhode stands --bisect --json`` prints it."""

def stands(loaded: Loaded) -> str:
    """Whether a scene stands, as JSON, as ``polhode stands --json`` prints it."""

def boxes(table: str, origin: str | None = None) -> str:
    """The keys of the scene of a table of boxes, as JSON."""

def study(
    loaded: Loaded,
    all_effects: bool,
    told: _Told,
    accuracy: float | None = None,
    vary: Sequence[str] = ...,
    budget_s: float | None = None,
) -> str:
    """The study of a scene as JSON, as ``polhode cost --json`` prints it."""

def rest_poses(
    loaded: Loaded,
    body: str | None,
    on: Loaded | None,
    asked: tuple[int, int, float | None, float | None, Sequence[float] | None, float | None],
    workers: int | None,
    told: _Told,
) -> str:
    """The throws of a body as JSON, as ``polhode drop --json`` prints them."""


@final
class BodyState:
    """Where a body is, and how it moves."""

    @property
    def position(self) -> tuple[float, float, float]:
        """Position of its own origin, world, m."""

    @property
    def orientation(self) -> tuple[float, float, float, float]:
        """Orientation, a quaternion body to world: w, x, y, z."""

    @property
    def velocity(self) -> tuple[float, float, float]:
        """Velocity of its centre of mass, world, m/s."""

    @property
    def angular_velocity(self) -> tuple[float, float, float]:
        """Angular velocity, world, rad/s."""

@final
class StepOutcome:
    """A step that has been made."""

    @property
    def t(self) -> float:
        """Time reached, s."""

    @property
    def is_event(self) -> bool:
        """Whether the step ended at an event."""

@final
class Contact:
    """A contact that touches. Single forces may not be unique: those of least norm are given."""

    @property
    def body_a(self) -> str:
        """Body A."""

    @property
    def body_b(self) -> str:
        """Body B."""

    @property
    def point(self) -> tuple[float, float, float]:
        """Contact point, world, m."""

    @property
    def normal(self) -> tuple[float, float, float]:
        """Unit normal from B to A, world."""

    @property
    def separation(self) -> float:
        """Distance along the normal, m; negative when the bodies overlap."""

    @property
    def normal_force(self) -> float:
        """Force on A along the normal, N."""

    @property
    def friction(self) -> tuple[float, float, float]:
        """Force of friction on A, world, N."""

@final
class JointLoad:
    """What a joint does to its first body, and the opposite of what it does to the second one."""

    @property
    def joint(self) -> str:
        """The joint."""

    @property
    def point(self) -> tuple[float, float, float]:
        """Its anchor on the first body, world, m."""

    @property
    def force(self) -> tuple[float, float, float]:
        """Force at the anchor, world, N."""

    @property
    def torque(self) -> tuple[float, float, float]:
        """Moment about the anchor, world, N m."""

@final
class Coordinate:
    """A coordinate of a joint."""

    @property
    def value(self) -> float:
        """Its value, rad or m."""

    @property
    def rate(self) -> float:
        """Its rate, rad/s or m/s."""

@final
class Energy:
    """Energies, J."""

    @property
    def kinetic(self) -> float:
        """Kinetic energy."""

    @property
    def potential(self) -> float:
        """Potential energy."""

    @property
    def total(self) -> float:
        """Their sum."""

    @property
    def initial(self) -> float:
        """The sum at t = 0."""

@final
class Momentum:
    """Momentum."""

    @property
    def linear(self) -> tuple[float, float, float]:
        """Linear momentum, world, N s."""

    @property
    def angular(self) -> tuple[float, float, float]:
        """Angular momentum about the point of the ledger of momentum, world, N m s."""

@final
class Finding:
    """What was found in the file of a robot."""

    @property
    def file(self) -> str:
        """The file."""

    @property
    def line(self) -> int:
        """Line, from 1."""

    @property
    def column(self) -> int:
        """Column, from 1."""

    @property
    def severity(self) -> str:
        """error, warning or ignored."""

    @property
    def subject(self) -> str:
        """What it is about: a link, a joint."""

    @property
    def what(self) -> str:
        """What is wrong, with its size."""

    @property
    def cure(self) -> str:
        """The edit that mends it; empty where there is none."""

@final
class Snapshot:
    """A simulation at one time."""

    @staticmethod
    def from_bytes(bytes: bytes) -> Snapshot:
        """The snapshot in these bytes."""

    def to_bytes(self) -> bytes:
        """The snapshot as bytes, with a version and a checksum."""

    @property
    def scene(self) -> str:
        """Name of the scene."""

    @property
    def time(self) -> float:
        """Simulated time, s."""

    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@disjoint_base
class Simulation:
    """A scene that Python advances in time, asks and changes."""

    def __new__(cls, loaded: Loaded, all_effects: bool, keep_events: bool) -> Self: ...
    @property
    def time(self) -> float:
        """Time reached, s."""

    @property
    def has_ended(self) -> bool:
        """Whether the end of the scene's duration has been reached."""

    @property
    def body_names(self) -> list[str]:
        """Names of the bodies, without those that were removed."""

    @property
    def joint_names(self) -> list[str]:
        """Names of the joints, without those that hold nothing any more."""

    def step(self, dt: float | None = None) -> StepOutcome:
        """Makes one step, of at most ``dt`` (s) where that is given, which ends at the first event in it. The tiers of
        fixed steps make no longer one than theirs."""

    def advance_to(self, t: float) -> None:
        """Advances exactly to a time, s. Ctrl-C ends it after a step."""

    def run_to_end(self) -> str: ...
    def body(self, body: _Body) -> BodyState:
        """Pose and velocity of a body."""

    def bodies(self) -> dict[str, BodyState]:
        """Poses and velocities of all bodies, by their names."""

    def contacts(self) -> list[Contact]:
        """Contacts that touch, with their forces."""

    def joint_loads(self) -> list[JointLoad]:
        """Forces and moments of the joints."""

    def coordinate(self, joint: _Joint, coordinate: str | None = None) -> Coordinate:
        """A coordinate of a joint: the one of this name, or its first."""

    def islands(self) -> list[list[str]]:
        """The islands: the names of bodies that move together or rest together."""

    def energy(self) -> Energy:
        """Energies."""

    def momentum(self) -> Momentum:
        """Momentum of all bodies."""

    def told_json(self) -> tuple[str, str]: ...
    def event_columns(
        self,
    ) -> tuple[list[str], tuple[list[str], NDArray[np.int64], NDArray[np.float64]]] | None: ...
    def stability_json(self) -> str: ...
    def snapshot(self) -> Snapshot:
        """Everything from which ``restore`` continues with the same bits."""

    def restore(self, snapshot: Snapshot) -> None:
        """Continues from a snapshot of a simulation of the same scene."""

    def set_force(self, body: _Body, force: Vector | None = None, torque: Vector | None = None) -> None:
        """Applies a force (N) at the centre of mass of a body and a torque (N m) until they are set again."""

    def apply_impulse(self, body: _Body, impulse: Vector, point: Vector) -> None:
        """Applies an impulse (N s) to a body at a point (m, world)."""

    def set_velocity(
        self, body: _Body, velocity: Vector | None = None, angular_velocity: Vector | None = None
    ) -> None:
        """Sets the velocity of the centre of mass of a body (m/s) and its angular velocity (rad/s)."""

    def set_pose(self, body: _Body, position: Vector, orientation: Vector | None = None) -> None:
        """Sets the pose of a body: position of its origin (m) and orientation (w, x, y, z)."""

    def steer(self, body: _Body, velocity: Vector | None = None, angular_velocity: Vector | None = None) -> None:
        """Steers a kinematic body by a velocity from now on; none halts it."""

    def steer_to(
        self, body: _Body, position: Vector, orientation: Vector | None = None, *, within: float
    ) -> None:
        """Steers a kinematic body to a pose that it reaches within a time, s."""

    def give_motor(self, joint: _Joint, coordinate: str | None, driven: dict[str, float | None]) -> None: ...
    def add_first_body(self, loaded: Loaded) -> None: ...
    def add_first_joint(self, loaded: Loaded) -> None: ...
    def remove_joint(self, joint: _Joint) -> None:
        """Removes a joint: what it held moves on without it."""

    def remove_body(self, body: _Body) -> None:
        """Removes a body. Those that rested on it are no longer supported."""
