"""Rigid-body simulation that accounts for its accuracy.

>>> import polhode as ph
>>> scene = ph.Scene(gravity=9.81, duration=1.0)
>>> floor = scene.fixed(ph.HalfSpace(), friction=0.4)
>>> box = scene.add(ph.Box(1, 0.5, 0.25), mass=2.0, at=(0, 0, 1), friction=0.4)
>>> run = ph.run(scene)
>>> run.outcome, round(float(run[box].position[-1, 2]), 9)    # m: half its height
('completed', 0.125)
>>> run.check()

SI units; z is up; quaternions are w, x, y, z and turn body to world.
"""

from typing import TYPE_CHECKING, Any

from ._contacts import FrictionSolution, Impact, impact, solve_friction
from ._cost import Accuracy, Candidate, Cost, cost
from ._distributions import Choice, Distribution, LogNormal, Normal, Uniform
from ._drop import RestFace, RestPoses, rest_poses
from ._errors import (
    ActionError,
    Busy,
    Interrupted,
    NotKept,
    NotReached,
    Place,
    PolhodeError,
    SceneError,
    SimulationError,
    SnapshotError,
    SweepError,
    SweepStopped,
    UnknownName,
    ViewError,
)
from ._estimate import RunError, TrackError
from ._functions import doctor, mass_properties, rotate_free
from ._joints import Ball, Cylindrical, FixedJoint, Hinge, Joint, OnTrack, Planar, Rod, Rope, Screw, Slider, Universal
from ._judge import Comparison, Judgement, compare, judge
from ._polhode import (
    BodyState,
    Contact,
    Coordinate,
    Energy,
    Finding,
    JointLoad,
    Momentum,
    Snapshot,
    StepOutcome,
    __version__,
)
from ._robot import Robot, RobotActuator, RobotCoordinate, RobotJoint, RobotLink
from ._run import Energies, Joints, JointTrack, Run, Track, run
from ._scene import Body, JointHandle, Scene
from ._shapes import (
    Box,
    Capsule,
    Compound,
    Cone,
    Convex,
    Cylinder,
    HalfSpace,
    Mesh,
    Points,
    Prism,
    Shape,
    Sphere,
    Torus,
    Wedge,
)
from ._show import Gif, Page, Plot, Still
from ._simulation import Simulation
from ._stands import Standing, StandingLimit, boxes, standing_limit, stands
from ._sweep import sweep
from ._table import Mean, Table

if TYPE_CHECKING:
    from . import gym as gym


def __getattr__(name: str) -> Any:
    """``polhode.gym`` when it is first asked for: it needs gymnasium."""
    if name == "gym":
        from importlib import import_module

        return import_module(".gym", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


__all__ = [
    "Accuracy",
    "ActionError",
    "Ball",
    "Body",
    "BodyState",
    "Box",
    "Busy",
    "Candidate",
    "Capsule",
    "Choice",
    "Comparison",
    "Compound",
    "Cone",
    "Contact",
    "Convex",
    "Coordinate",
    "Cost",
    "Cylinder",
    "Cylindrical",
    "Distribution",
    "Energies",
    "Energy",
    "Finding",
    "FixedJoint",
    "FrictionSolution",
    "Gif",
    "HalfSpace",
    "Hinge",
    "Impact",
    "Interrupted",
    "Joint",
    "JointHandle",
    "JointLoad",
    "JointTrack",
    "Joints",
    "Judgement",
    "LogNormal",
    "Mean",
    "Mesh",
    "Momentum",
    "Normal",
    "NotKept",
    "NotReached",
    "OnTrack",
    "Page",
    "Place",
    "Planar",
    "Plot",
    "Points",
    "Prism",
    "PolhodeError",
    "RestFace",
    "RestPoses",
    "Robot",
    "RobotActuator",
    "RobotCoordinate",
    "RobotJoint",
    "RobotLink",
    "Rod",
    "Rope",
    "Run",
    "RunError",
    "Scene",
    "SceneError",
    "Screw",
    "Shape",
    "Simulation",
    "SimulationError",
    "Slider",
    "Snapshot",
    "SnapshotError",
    "Sphere",
    "Standing",
    "StepOutcome",
    "Still",
    "SweepError",
    "SweepStopped",
    "Table",
    "Torus",
    "Track",
    "TrackError",
    "Uniform",
    "Universal",
    "UnknownName",
    "ViewError",
    "Wedge",
    "__version__",
    "boxes",
    "compare",
    "cost",
    "doctor",
    "impact",
    "judge",
    "mass_properties",
    "rest_poses",
    "rotate_free",
    "run",
    "solve_friction",
    "standing_limit",
    "stands",
    "sweep",
]
