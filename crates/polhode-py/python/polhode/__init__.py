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

from ._distributions import Choice, Distribution, LogNormal, Normal, Uniform
from ._errors import (
    ActionError,
    Busy,
    Interrupted,
    NotKept,
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
from ._functions import doctor, mass_properties, rotate_free
from ._joints import Ball, Cylindrical, FixedJoint, Hinge, Joint, Planar, Rod, Rope, Screw, Slider, Universal
from ._polhode import BodyState, Contact, Coordinate, Energy, Finding, JointLoad, Snapshot, StepOutcome, __version__
from ._run import Energies, Joints, JointTrack, Run, Track, run
from ._scene import Body, JointHandle, Scene
from ._shapes import Box, Capsule, Compound, Cone, Convex, Cylinder, HalfSpace, Mesh, Points, Shape, Sphere, Torus
from ._show import Gif, Page, Plot, Still
from ._simulation import Simulation
from ._stands import Standing, boxes, stands
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
    "ActionError",
    "Ball",
    "Body",
    "BodyState",
    "Box",
    "Busy",
    "Capsule",
    "Choice",
    "Compound",
    "Cone",
    "Contact",
    "Convex",
    "Coordinate",
    "Cylinder",
    "Cylindrical",
    "Distribution",
    "Energies",
    "Energy",
    "Finding",
    "FixedJoint",
    "Gif",
    "HalfSpace",
    "Hinge",
    "Interrupted",
    "Joint",
    "JointHandle",
    "JointLoad",
    "JointTrack",
    "Joints",
    "LogNormal",
    "Mean",
    "Mesh",
    "Normal",
    "NotKept",
    "Page",
    "Place",
    "Planar",
    "Plot",
    "Points",
    "PolhodeError",
    "Rod",
    "Rope",
    "Run",
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
    "Uniform",
    "Universal",
    "UnknownName",
    "ViewError",
    "__version__",
    "boxes",
    "doctor",
    "mass_properties",
    "rotate_free",
    "run",
    "stands",
    "sweep",
]
