"""Joints: what holds two bodies, or a body and the world, together. Lengths in m, angles in rad, in the world at t = 0.

What acts along a coordinate (limits, springs, motors, friction) is a dictionary with the keys of a scene file:
``range``, ``restitution``, ``stiffness``, ``rest``, ``damping``, ``motor``, ``friction``, ``motion``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Mapping

    from ._scene import Vector


class Joint:
    """A joint, as a scene file has it; the bodies are named when it is added to a scene.

    >>> import polhode as ph
    >>> ph.Hinge(at=(0, 0, 1), axis=(0, 1, 0), range=(-1, 1)).keys["angle"]
    {'range': (-1, 1)}
    """

    #: The kind in a scene file.
    kind: str
    #: Its keys there.
    keys: dict[str, Any]

    def __init__(self, kind: str, **keys: Any) -> None:
        self.kind = kind
        self.keys = {key: own for key, own in keys.items() if own is not None}

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.keys!r})"


class Ball(Joint):
    """A point of both bodies: all rotations about it are free."""

    def __init__(self, at: Vector) -> None:
        super().__init__("ball", anchor=at)


class FixedJoint(Joint):
    """The bodies move as one."""

    def __init__(self, at: Vector) -> None:
        super().__init__("fixed", anchor=at)


class Hinge(Joint):
    """A point and an axis of both bodies: the rotation about the axis is free; ``along`` are keys of its angle."""

    def __init__(self, at: Vector, axis: Vector, **along: Any) -> None:
        super().__init__("hinge", anchor=at, axis=axis, angle=along or None)


class Slider(Joint):
    """A line on which a point of the body slides without a rotation; ``along`` are keys of its displacement."""

    def __init__(self, at: Vector, axis: Vector, **along: Any) -> None:
        super().__init__("slider", anchor=at, axis=axis, displacement=along or None)


class Cylindrical(Joint):
    """An axis of both bodies: the rotation about it and the displacement along it are free."""

    def __init__(
        self,
        at: Vector,
        axis: Vector,
        angle: Mapping[str, Any] | None = None,
        displacement: Mapping[str, Any] | None = None,
    ) -> None:
        super().__init__("cylindrical", anchor=at, axis=axis, angle=angle, displacement=displacement)


class Screw(Joint):
    """An axis, and a displacement along it that goes with the rotation about it: ``lead`` m for each revolution."""

    def __init__(self, at: Vector, axis: Vector, lead: float, **along: Any) -> None:
        super().__init__("screw", anchor=at, axis=axis, lead=lead, angle=along or None)


class Universal(Joint):
    """A point of both bodies, and an axis of each at right angles."""

    def __init__(self, at: Vector, axes: tuple[Vector, Vector]) -> None:
        super().__init__("universal", anchor=at, axes=axes)


class Planar(Joint):
    """A plane in which a point of the body slides; both keep its normal."""

    def __init__(self, at: Vector, normal: Vector) -> None:
        super().__init__("planar", anchor=at, normal=normal)


class Rod(Joint):
    """A rod without mass between a point of each."""

    def __init__(self, ends: tuple[Vector, Vector]) -> None:
        super().__init__("rod", anchors=ends)


class Rope(Joint):
    """A rope without mass between a point of each; without a length it is taut at t = 0."""

    def __init__(self, ends: tuple[Vector, Vector], length: float | None = None, restitution: float = 0.0) -> None:
        super().__init__("rope", anchors=ends, length=length, restitution=restitution)


class OnTrack(Joint):
    """A point of the body on a track (:meth:`polhode.Scene.track`), along which it slides; ``along`` are keys of its
    displacement.

    ``follows`` is ``"point"``, ``"tangent"`` or ``"frame"``: what of the body follows the track. Further keys are those
    of a scene file: ``up``, ``side``, ``restitution``, ``springs``, ``ends``.

    >>> import polhode as ph
    >>> scene = ph.Scene()
    >>> wire = scene.track("wire", {"line": {"points": [[0, 0, 0], [1, 0, -1]]}})
    >>> bead = scene.add(ph.Sphere(0.01), mass=1.0, at=(0, 0, 0))
    >>> joint = scene.joint(ph.OnTrack(wire, at=(0, 0, 0)), bead, name="on wire")
    >>> float(ph.run(scene, duration=0.4).joints["on wire"].displacement[-1].round(9))    # m: g sin(45 deg) t^2 / 2
    0.554937402
    """

    def __init__(
        self,
        track: str,
        at: Vector,
        *,
        follows: str | None = None,
        along: Mapping[str, Any] | None = None,
        **keys: Any,
    ) -> None:
        super().__init__("track", track=track, anchor=at, follows=follows, displacement=along, **keys)
