"""A simulation in the hand."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping

from . import _polhode
from ._scene import Body, Scene, load

if TYPE_CHECKING:
    from typing_extensions import Self

    from ._scene import JointHandle, SceneLike, Vector
    from ._shapes import Shape


class Simulation(_polhode.Simulation):
    """A scene that a program advances in time, asks and changes; arguments as of :func:`polhode.run`.

    One thread uses it at a time: another one gets :class:`polhode.Busy`. Vectors that it gives are tuples; those that it takes are any
    sequence of numbers.

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
    _is_changed: bool

    def __new__(
        cls,
        scene: SceneLike,
        *,
        duration: float | None = None,
        tier: str | None = None,
        step: float | None = None,
        set: Mapping[str, Any] | None = None,
        effects: str = "planned",
    ) -> Self:
        if effects not in ("planned", "all"):
            raise ValueError(f'effects={effects!r}: "planned" or "all" is needed')
        loaded = load(scene, {"duration": duration, "tier": tier, "step": step, "set": set})
        made = super().__new__(cls, loaded, effects == "all")
        made._loaded = loaded
        made._effects = effects
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

    def stability(self) -> dict[str, Any]:
        """How far the bodies at rest are from moving: the friction that they need, and the push, relative to their weights, at which
        the first of them begins to move, in each of several directions.

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

        A motor is exactly one of a constant ``effort`` (N m, N); a ``velocity`` to reach (rad/s, m/s) with its ``gain``; a
        ``position`` to reach (rad, m) with its ``stiffness`` and ``damping``; of an effort of at ``most`` so much.
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

    def __reduce__(self) -> tuple[Any, ...]:
        if self._is_changed:
            raise TypeError(
                "a simulation to which bodies were added, or from which they were removed, cannot be pickled: pickle its "
                "snapshot(), and restore() it into a simulation with the same bodies"
            )
        return _restored, (*self._loaded.source(), self._effects, self.snapshot())

    def __repr__(self) -> str:
        return f"<polhode.Simulation {self.name!r} at t = {self.time} s>"


def _restored(
    how: str, arguments: list[str], changes: list[tuple[str, str, str]], effects: str, snapshot: _polhode.Snapshot
) -> Simulation:
    from ._scene import _read

    simulation = Simulation(_read(how, arguments, changes), effects=effects)
    simulation.restore(snapshot)
    return simulation
