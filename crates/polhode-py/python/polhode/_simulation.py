"""A simulation in the hand."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping

from . import _polhode
from ._errors import ActionError
from ._estimate import RunError, of_report
from ._scene import Body, JointHandle, Scene, free_name, load

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from typing_extensions import Self

    from ._joints import Joint
    from ._scene import SceneLike, Vector
    from ._shapes import Shape


class Simulation(_polhode.Simulation):
    """A scene that a program advances in time, asks and changes; arguments as of :func:`polhode.run`.

    With ``keep_events=True`` it keeps its events (:attr:`events`).

    One thread uses it at a time: another one gets :class:`polhode.Busy`. Vectors that it gives are tuples; those that
    it takes are any sequence of numbers.

    >>> import polhode as ph
    >>> scene = ph.Scene()
    >>> ball = scene.add(ph.Sphere(0.1), name="ball", mass=1.0, at=(0, 0, 1))
    >>> sim = ph.Simulation(scene)
    >>> sim.apply_impulse(ball, (0, 0, 2.0), (0, 0, 1))   # N s, m
    >>> sim.advance_to(0.1)                               # s
    >>> sim.body("ball").velocity[2]                      # m/s
    1.019
    """

    _loaded: _polhode.Loaded
    _effects: str
    _keeps_events: bool
    _is_changed: bool

    def __new__(
        cls,
        scene: SceneLike,
        *,
        duration: float | None = None,
        tier: str | None = None,
        step: float | None = None,
        error: str | None = None,
        set: Mapping[str, Any] | None = None,
        effects: str = "planned",
        keep_events: bool = False,
    ) -> Self:
        if effects not in ("planned", "all"):
            raise ValueError(f'effects={effects!r}: "planned" or "all" is needed')
        loaded = load(scene, {"duration": duration, "tier": tier, "step": step, "error": error, "set": set})
        made = super().__new__(cls, loaded, effects == "all", keep_events)
        made._loaded = loaded
        made._effects = effects
        made._keeps_events = keep_events
        made._is_changed = False
        return made

    @property
    def name(self) -> str:
        """Name of the scene."""
        return self._loaded.name

    @property
    def duration(self) -> float:
        """Duration of the scene, s."""
        return self._loaded.duration

    def run(self) -> dict[str, Any]:
        """Runs to the end of the scene's duration; the report, as ``polhode run --json`` prints it."""
        import json

        report: dict[str, Any] = json.loads(self.run_to_end())
        return report

    def report(self) -> dict[str, Any]:
        """The report of what was computed so far; the simulation can go on. Keys are those of :meth:`run`."""
        import json

        report: dict[str, Any] = json.loads(self.told_json()[0])
        return report

    @property
    def certificate(self) -> dict[str, Any]:
        """The largest value of each measure of accuracy so far, relative to its limit, and where it was.

        >>> import polhode as ph
        >>> ball = {"name": "ball", "shape": {"sphere": {"radius": 0.1}}, "mass": 1.0}
        >>> sim = ph.Simulation({"format": 1, "bodies": [ball]})
        >>> sim.advance_to(0.5)
        >>> sim.certificate["max_penetration_m"]
        0.0
        """
        import json

        certificate: dict[str, Any] = json.loads(self.told_json()[1])
        return certificate

    @property
    def error(self) -> RunError | None:
        """The estimated error so far; none before the first comparison with a run beside it, and with
        ``error="off"``.

        >>> import polhode as ph
        >>> ball = {"name": "ball", "shape": {"sphere": {"radius": 0.1}}, "mass": 1.0}
        >>> sim = ph.Simulation({"format": 1, "bodies": [ball]})
        >>> sim.advance_to(0.5)
        >>> sim.error < 1e-12, sim.error.horizon
        (True, None)
        """
        return of_report(self.report())

    @property
    def events(self) -> NDArray[np.void]:
        """The events so far, as :attr:`polhode.Run.events`; of a simulation that keeps them.

        >>> import polhode as ph
        >>> scene = ph.Scene()
        >>> floor = scene.fixed(ph.HalfSpace())
        >>> ball = scene.add(ph.Sphere(0.1), mass=1.0, at=(0, 0, 0.6), restitution=0.5)
        >>> sim = ph.Simulation(scene, keep_events=True)
        >>> sim.advance_to(0.4)
        >>> sim.events["kind"].tolist(), sim.events["body_b"].tolist()
        (['impact'], ['sphere'])
        """
        from ._events import structured

        columns = self.event_columns()
        if columns is None:
            raise ActionError("events are not kept: make the simulation with keep_events=True")
        names, events = columns
        return structured(names, *events)

    def stability(self) -> dict[str, Any]:
        """How far the bodies at rest are from moving: the friction that they need, and the push, relative to their
        weights, at which the first of them begins to move, in each of several directions.

        >>> import polhode as ph
        >>> scene = ph.Scene()
        >>> floor = scene.fixed(ph.HalfSpace(), friction=0.5)
        >>> column = scene.add(ph.Box(1, 1, 4), mass=2.0, at=(0, 0, 2), friction=0.5)
        >>> stability = ph.Simulation(scene).stability()
        >>> stability["friction_needed"], round(min(push["of_weight"] for push in stability["pushes"]), 9)
        (0.0, 0.25)
        """
        import json

        stability: dict[str, Any] = json.loads(self.stability_json())
        return stability

    def set_motor(
        self,
        joint: str | int | JointHandle,
        coordinate: str | None = None,
        *,
        effort: float | None = None,
        velocity: float | None = None,
        gain: float | None = None,
        position: float | None = None,
        stiffness: float | None = None,
        damping: float | None = None,
        most: float | None = None,
    ) -> None:
        """Gives a coordinate of a joint (its first one when none is named) another motor, or none.

        A motor is exactly one of a constant ``effort`` (N m, N); a ``velocity`` to reach (rad/s, m/s) with its
        ``gain``; a ``position`` to reach (rad, m) with its ``stiffness`` and ``damping``; of an effort of at ``most``
        so much.
        """
        driven = {
            "effort": effort,
            "velocity": velocity,
            "gain": gain,
            "position": position,
            "stiffness": stiffness,
            "damping": damping,
            "most": most,
        }
        self.give_motor(joint, coordinate, driven)

    def add_body(self, shape: Shape | None = None, *, name: str, at: Vector = (0, 0, 0), **keys: Any) -> Body:
        """Adds a body at the present time; keys as of :meth:`polhode.Scene.add`.

        >>> import polhode as ph
        >>> scene = ph.Scene()
        >>> floor = scene.fixed(ph.HalfSpace())
        >>> sim = ph.Simulation(scene)
        >>> late = sim.add_body(ph.Sphere(0.1), name="late", mass=1.0, at=(0, 0, 1))
        >>> sim.remove_body(late)
        >>> sim.body_names
        ['half_space']
        """
        alone = Scene(duration=self.duration)
        body = alone.add(shape, name=name, at=at, **keys)
        self.add_first_body(load(alone, {}))
        self._is_changed = True
        return body

    def remove_body(self, body: str | int | Body) -> None:
        """Removes a body. Those that rested on it are no longer supported."""
        super().remove_body(body)
        self._is_changed = True

    def add_joint(
        self, joint: Joint, body: str | Body, other: str | Body | None = None, *, name: str | None = None, **keys: Any
    ) -> JointHandle:
        """Adds a joint between bodies as they are now; arguments as of :meth:`polhode.Scene.joint`.

        Velocities that it does not allow are stopped at once. Bodies that it joins do not collide with each other.

        >>> import polhode as ph
        >>> scene = ph.Scene()
        >>> rod = scene.add(ph.Box(1, 0.02, 0.02), name="rod", mass=1.0)
        >>> sim = ph.Simulation(scene)
        >>> sim.advance_to(0.1)                       # it falls, and is caught by its end
        >>> x, y, z = sim.body(rod).position
        >>> hinge = sim.add_joint(ph.Hinge(at=(x - 0.5, y, z), axis=(0, 1, 0)), rod, name="hinge")
        >>> round(sim.body(rod).angular_velocity[1], 3)     # rad/s: g t (1/2) / (1/3)
        1.471
        >>> sim.remove_joint(hinge)
        >>> sim.joint_names
        []
        """
        name = name or free_name(joint.kind, self.joint_names)
        if name in self.joint_names:
            raise ActionError(f"the name {name!r} is in use by another joint: give another one")
        alone = Scene(duration=self.duration)
        names = [held.name if isinstance(held, Body) else held for held in (body, other) if held is not None]
        for held in dict.fromkeys(names):
            state = self.body(held)
            # Of these bodies the library asks where they are: what they are it knows.
            alone.add(name=held, mass=1.0, inertia=[1, 1, 1], at=state.position, orientation=state.orientation)
        handle = alone.joint(joint, body, other, name=name, **keys)
        self.add_first_joint(load(alone, {}))
        self._is_changed = True
        return handle

    def remove_joint(self, joint: str | int | JointHandle) -> None:
        """Removes a joint: what it held moves on without it. A snapshot from before brings it back."""
        super().remove_joint(joint)

    def __reduce__(self) -> tuple[Any, ...]:
        if self._is_changed:
            raise TypeError(
                "a simulation to which bodies or joints were added, or from which bodies were removed, cannot be "
                "pickled: pickle its snapshot(), and restore() it into a simulation with the same bodies and joints"
            )
        return _restored, (*self._loaded.source(), self._effects, self._keeps_events, self.snapshot())

    def __repr__(self) -> str:
        return f"<polhode.Simulation {self.name!r} at t = {self.time} s>"


def _restored(
    how: str,
    arguments: list[str],
    changes: list[tuple[str, str, str]],
    effects: str,
    keep_events: bool,
    snapshot: _polhode.Snapshot,
) -> Simulation:
    from ._scene import _read

    simulation = Simulation(_read(how, arguments, changes), effects=effects, keep_events=keep_events)
    simulation.restore(snapshot)
    return simulation
