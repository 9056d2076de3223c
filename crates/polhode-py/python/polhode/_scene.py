"""Scenes, built from Python: what is built is the document of a scene file, which the library reads and checks."""

from __future__ import annotations

import os
from collections.abc import Collection, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Union, overload

from . import _polhode, _toml
from ._robot import Robot

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ._joints import Joint
    from ._run import Run
    from ._shapes import Shape

    #: Three numbers.
    Vector = Union[Sequence[float], NDArray[np.float64]]
    #: What a scene is made from: a path, the keys of a scene file, a scene that was built, or a robot.
    SceneLike = Union[str, os.PathLike[str], Mapping[str, Any], "Scene", Robot, "_polhode.Loaded"]

#: What errors call a scene that does not come from a file.
ORIGIN = "<scene>"


class Body:
    """A body of a scene that is being built; ``run[body]`` and the methods of a simulation take it for its name."""

    __slots__ = ("name",)

    def __init__(self, name: str) -> None:
        #: Its name.
        self.name = name

    def __repr__(self) -> str:
        return f"Body({self.name!r})"


class JointHandle:
    """A joint of a scene that is being built; ``run.joints[joint]`` takes it for its name."""

    __slots__ = ("name",)

    def __init__(self, name: str) -> None:
        #: Its name.
        self.name = name

    def __repr__(self) -> str:
        return f"JointHandle({self.name!r})"


class Scene:
    """A scene: bodies, joints and forces.

    ``gravity`` in m/s^2: a number that points down, or a vector; ``duration`` in s; ``interval`` is the time between
    samples, s (0.01 when absent). Further keys are those of a scene file, such as ``method={"tier": "stepped"}``.

    >>> import polhode as ph
    >>> scene = ph.Scene(gravity=9.81, duration=0.5)
    >>> floor = scene.fixed(ph.HalfSpace(), friction=0.4)
    >>> box = scene.add(ph.Box(1, 0.5, 0.25), mass=2.0, at=(0, 0, 1), restitution=0.3, friction=0.4)
    >>> run = ph.run(scene)
    >>> run[box].position.shape     # (N, 3), m
    (51, 3)
    """

    #: The keys of the scene file.
    document: dict[str, Any]

    def __init__(
        self,
        *,
        gravity: float | Vector | None = None,
        duration: float = 1.0,
        name: str = "scene",
        interval: float | None = None,
        **keys: Any,
    ) -> None:
        self.document = {"format": 1, "name": name, "duration": duration}
        if gravity is not None:
            self.document["gravity"] = [0, 0, -gravity] if isinstance(gravity, (int, float)) else gravity
        if interval is not None:
            self.document["output"] = {"interval": interval}
        self.document.update(keys)

    def fixed(self, shape: Shape, *, name: str | None = None, at: Vector = (0, 0, 0), **keys: Any) -> Body:
        """A body that never moves. ``at`` is where its origin is, m.

        >>> import polhode as ph
        >>> ph.Scene().fixed(ph.HalfSpace(), friction=0.4)
        Body('half_space')
        """
        return self._body(shape, name, at, {"fixed": True, **keys})

    @overload
    def add(
        self,
        shape: Shape | None = None,
        *,
        name: str | None = None,
        mass: float | None = None,
        density: float | None = None,
        at: Vector = (0, 0, 0),
        **keys: Any,
    ) -> Body: ...

    @overload
    def add(self, shape: Robot, *, at: Vector = (0, 0, 0), **keys: Any) -> Robot: ...

    def add(
        self,
        shape: Shape | Robot | None = None,
        *,
        name: str | None = None,
        mass: float | None = None,
        density: float | None = None,
        at: Vector = (0, 0, 0),
        **keys: Any,
    ) -> Body | Robot:
        """A body that moves: of a mass, kg, or a density, kg/m^3. ``at`` is where its origin is, m.

        A :class:`polhode.Robot` takes the keys of ``models`` in a scene file instead.

        Further keys are those of a body in a scene file (``velocity`` m/s, ``angular_velocity`` rad/s, ``orientation``
        w x y z, ``rotation_vector`` rad, ``inertia`` kg m^2, ``pivot`` m, ``motion``, ``material`` ...) or of its
        material (``friction``, ``restitution`` ...). Two materials: the geometric mean of friction, the larger
        restitution; 0 where none is given.

        >>> import polhode as ph
        >>> scene = ph.Scene()
        >>> scene.add(ph.Sphere(0.1), mass=1.0, at=(0, 0, 2), velocity=(1, 0, 0))
        Body('sphere')
        >>> scene.add(ph.Sphere(0.1), mass=1.0, at=(0, 0, 3))
        Body('sphere-2')
        """
        if name is not None and isinstance(shape, Robot):
            keys["name"] = name
        if mass is not None:
            keys["mass"] = mass
        if density is not None:
            keys["density"] = density
        if isinstance(shape, Robot):
            self.robot(shape.file, at=at, **keys)
            return shape
        return self._body(shape, name, at, keys)

    def _body(self, shape: Shape | None, name: str | None, at: Vector, keys: dict[str, Any]) -> Body:
        name = self._free_name(name, "bodies", "body" if shape is None else shape.word)
        entry: dict[str, Any] = {"name": name}
        if shape is not None:
            entry["shape"] = shape.document
        entry["position"] = at
        self._with_material(keys)
        entry.update(keys)
        self._list("bodies").append(entry)
        return Body(name)

    def _with_material(self, keys: dict[str, Any]) -> None:
        """Gives keys of a material a name in the table of materials."""
        own = {key: keys.pop(key) for key in _polhode.material_keys() if key in keys}
        if own:
            if "material" in keys:
                raise ValueError(f"a body has a material, or {', '.join(own)} of its own: give one of them")
            name = ", ".join(f"{key} {_toml.plain(given)}" for key, given in own.items())
            keys["material"] = self.material(name, **own)

    def material(self, name: str, **keys: Any) -> str:
        """A material that bodies can name; keys are those of a scene file."""
        self.document.setdefault("materials", {})[name] = keys
        return name

    def joint(
        self, joint: Joint, body: Body | str, other: Body | str | None = None, *, name: str | None = None, **keys: Any
    ) -> JointHandle:
        """A joint between two bodies, or a body and the world.

        >>> import polhode as ph
        >>> scene = ph.Scene()
        >>> turning = {"velocity": (1, 0, 0), "angular_velocity": (0, -2, 0)}
        >>> rod = scene.add(ph.Box(0.1, 0.1, 1), mass=1.0, at=(0, 0, -0.5), **turning)
        >>> scene.joint(ph.Hinge(at=(0, 0, 0), axis=(0, 1, 0)), rod, name="knee")
        JointHandle('knee')
        >>> ph.run(scene).joints["knee"].angle.shape    # (N,), rad
        (101,)
        """
        name = self._free_name(name, "joints", joint.kind)
        bodies = [body] if other is None else [body, other]
        self._list("joints").append({"name": name, "type": {joint.kind: {"bodies": bodies, **joint.keys}}, **keys})
        return JointHandle(name)

    def gear(self, joint: JointHandle | str, other: JointHandle | str, ratio: float, **keys: Any) -> None:
        """The coordinate of one joint moves by ``ratio`` times that of another one."""
        self._list("gears").append({"joints": [joint, other], "ratio": ratio, **keys})

    def force(self, kind: str, **keys: Any) -> None:
        """A force, by its kind and keys in a scene file: ``scene.force("spring", bodies=[a, b], stiffness=100.0)``."""
        self._list("forces").append({"type": {kind: keys}})

    def array(self, shape: Shape | None, layout: Mapping[str, Any], *, name: str | None = None, **keys: Any) -> str:
        """Many equal bodies, NAME-1, NAME-2 and so on: ``layout={"pyramid": {"base": 10, "spacing": [0.44, 0.4]}}``.

        An arch makes its own stones: its shape is ``None``.
        """
        name = self._free_name(name, "arrays", next(iter(layout), "array") if shape is None else shape.word)
        if "at" in keys:
            keys["position"] = keys.pop("at")
        self._with_material(keys)
        of_shape = {} if shape is None else {"shape": shape.document}
        self._list("arrays").append({"name": name, "layout": layout, **of_shape, **keys})
        return name

    def robot(self, file: str | os.PathLike[str], *, at: Vector = (0, 0, 0), **keys: Any) -> None:
        """A robot from its file (URDF, MJCF); keys are those of ``models`` in a scene file: ``drives`` of its joints,
        ``keyframe`` and ``controls`` of an MJCF file, and others."""
        self._list("models").append({"file": os.fspath(file), "position": at, **keys})

    def track(self, name: str, curve: Mapping[str, Any], **keys: Any) -> str:
        """A curve that joints hold bodies to."""
        self._list("tracks").append({"name": name, "curve": curve, **keys})
        return name

    def no_contact(self, *bodies: Body | str) -> None:
        """These bodies do not collide with each other."""
        self._list("no_contact").append({"bodies": bodies})

    def to_toml(self) -> str:
        """The scene as the text of a scene file, which ``polhode run`` reads.

        >>> import polhode as ph
        >>> scene = ph.Scene(duration=2.0, name="drop")
        >>> ball = scene.add(ph.Sphere(0.1), mass=1.0, at=(0, 0, 1))
        >>> print(scene.to_toml())
        format = 1
        name = "drop"
        duration = 2.0
        <BLANKLINE>
        [[bodies]]
        name = "sphere"
        shape.sphere.radius = 0.1
        position = [0, 0, 1]
        mass = 1.0
        <BLANKLINE>
        """
        return _toml.document(self.document)

    def run(self, **options: Any) -> Run:
        """As :func:`polhode.run` of this scene."""
        from ._run import run

        return run(self, **options)

    def _list(self, key: str) -> list[Any]:
        entries: list[Any] = self.document.setdefault(key, [])
        return entries

    def _free_name(self, name: str | None, key: str, word: str) -> str:
        """The name given, or the first of WORD, WORD-2, WORD-3 ... that is free."""
        if name is not None:
            return name
        return free_name(word, {entry.get("name") for entry in self._list(key)})

    def __repr__(self) -> str:
        bodies, joints = (len(self.document.get(key, ())) for key in ("bodies", "joints"))
        return f"<polhode.Scene {self.document['name']!r}: {bodies} bodies, {joints} joints>"


def free_name(word: str, taken: Collection[str | None]) -> str:
    """The first of WORD, WORD-2, WORD-3 ... that is free."""
    number = 1
    while (free := word if number == 1 else f"{word}-{number}") in taken:
        number += 1
    return free


def load(scene: SceneLike, changes: Mapping[str, Any]) -> _polhode.Loaded:
    """The scene, read by the library after some of its keys were changed; the keys are those of arguments and of a
    scene file."""
    named = {"tier": "method.tier", "step": "method.step", "error": "method.error", "interval": "output.interval"}
    settings: dict[str, Any] = dict(changes)
    own = settings.pop("set", None) or {}
    listed = [
        (f"{argument}=", named.get(argument, argument), _toml.value(_toml.plain(given, argument)))
        for argument, given in settings.items()
        if given is not None
    ]
    listed += [("set=", _toml.path(key), _toml.value(_toml.plain(given, key))) for key, given in own.items()]
    if isinstance(scene, _polhode.Loaded):
        if not listed:
            return scene
        how, arguments, before = scene.source()
        return _read(how, arguments, [*before, *listed])
    if isinstance(scene, Scene):
        return _read("text", [ORIGIN, scene.to_toml()], listed)
    if isinstance(scene, Robot):
        return _read("file", [scene.file], listed)
    if isinstance(scene, Mapping):
        return _read("text", [ORIGIN, _toml.document(scene)], listed)
    if isinstance(scene, (str, os.PathLike)):
        return _read("file", [os.fspath(scene)], listed)
    raise TypeError(f"a scene is a path, a dictionary, a polhode.Scene or a polhode.Robot, not {type(scene).__name__}")


def _read(how: str, arguments: list[str], changes: list[tuple[str, str, str]]) -> _polhode.Loaded:
    if how == "file":
        return _polhode.Loaded.file(arguments[0], changes)
    return _polhode.Loaded.text(arguments[0], arguments[1], changes)
