"""Robots from their files."""

from __future__ import annotations

import os
from typing import Any, NamedTuple

from . import _polhode


class RobotCoordinate(NamedTuple):
    """A coordinate of a joint of a robot: an angle, rad, or a displacement, m."""

    name: str
    #: Its limits; infinite where it has none.
    lower: float
    upper: float
    #: Its value in the pose of the file.
    reference: float
    #: N m s/rad or N s/m.
    damping: float
    #: Torque or force that resists motion, N m or N.
    friction: float
    #: N m/rad or N/m.
    stiffness: float
    #: Where the spring is at rest.
    rest: float
    #: The largest effort of its motors, N m or N; infinite where the file has no bound.
    effort_limit: float


class RobotActuator(NamedTuple):
    """A motor or a servo of an MJCF file at a joint."""

    name: str
    #: motor, position, velocity, damper or general.
    kind: str
    joint: str
    gear: float
    #: The least and the largest control; infinite where it has no range.
    control_range: tuple[float, float]


class RobotJoint(NamedTuple):
    """A joint of a robot."""

    name: str
    #: fixed, free, ball, hinge, slider, cylindrical, universal or planar.
    kind: str
    #: The links that it connects.
    parent: str
    child: str
    coordinates: list[RobotCoordinate]


class RobotLink(NamedTuple):
    """A link of a robot."""

    name: str
    #: kg; none where the file gives none.
    mass: float | None


class Robot:
    """A robot from its file (URDF, MJCF). It stands where a scene does, and ``scene.add(robot)`` adds it to one.

    A file that is refused raises :class:`polhode.SceneError`, whose ``errors`` have place and cure of each thing.

    >>> import polhode as ph
    >>> import pathlib, tempfile
    >>> file = pathlib.Path(tempfile.mkdtemp(), "arm.urdf")
    >>> size = file.write_text('''<robot name="arm">
    ... <link name="base"/>
    ... <link name="arm"><inertial><mass value="2"/><origin xyz="0 0 -0.2"/>
    ...   <inertia ixx="0.03" iyy="0.03" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial></link>
    ... <joint name="shoulder" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 1 0"/>
    ...   <limit lower="-1.5" upper="1.5" effort="10" velocity="5"/></joint></robot>''')
    >>> robot = ph.Robot(file)
    >>> robot.link_names, robot.joint_names, robot.limits
    (['base', 'arm'], ['shoulder'], {'shoulder': (-1.5, 1.5)})
    >>> scene = ph.Scene(duration=0.5)
    >>> motor = {"position": 0.5, "stiffness": 90.0, "damping": 4.0}
    >>> added = scene.add(robot, base="fixed", drives={"shoulder": {"motor": motor}})
    >>> run = ph.run(scene)
    >>> bool(run.joints["shoulder"].angle[-1] > 0.3)
    True
    """

    #: The file.
    file: str
    #: Name of the robot.
    name: str
    links: list[RobotLink]
    joints: list[RobotJoint]
    #: Its motors and servos that are simulated; ``controls={name: value}`` of a scene gives them controls.
    actuators: list[RobotActuator]
    #: Names of the states that its file gives; ``keyframe=name`` of a scene starts it in one.
    keyframes: list[str]
    #: What differs from the file, and what of it is ignored; :meth:`doctor` examines more.
    findings: list[_polhode.Finding]

    def __init__(self, file: str | os.PathLike[str]) -> None:
        told = _polhode.robot_of_file(file)
        self.file = os.fspath(file)
        self.name = told["name"]
        self.links = [RobotLink(*link) for link in told["links"]]
        self.joints = [_joint(**joint) for joint in told["joints"]]
        self.actuators = [RobotActuator(**own) for own in told["actuators"]]
        self.keyframes = told["keyframes"]
        self.findings = told["findings"]

    @property
    def link_names(self) -> list[str]:
        """Names of its links, the root first."""
        return [link.name for link in self.links]

    @property
    def joint_names(self) -> list[str]:
        """Names of its joints."""
        return [joint.name for joint in self.joints]

    @property
    def limits(self) -> dict[str, tuple[float, float]]:
        """The least and the largest value of each coordinate, rad or m; infinite where it has no limits."""
        return {own.name: (own.lower, own.upper) for joint in self.joints for own in joint.coordinates}

    @property
    def mass(self) -> float:
        """Mass of all links, kg."""
        return sum(link.mass or 0.0 for link in self.links)

    def doctor(self) -> list[_polhode.Finding]:
        """As :func:`polhode.doctor` of its file: masses, inertias, meshes and overlaps too."""
        return _polhode.doctor(self.file)

    def __repr__(self) -> str:
        return f"<polhode.Robot {self.name!r}: {len(self.links)} links, {len(self.joints)} joints>"


def _joint(name: str, kind: str, parent: str, child: str, coordinates: list[dict[str, Any]]) -> RobotJoint:
    return RobotJoint(name, kind, parent, child, [RobotCoordinate(**own) for own in coordinates])
