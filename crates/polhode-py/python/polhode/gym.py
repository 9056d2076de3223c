"""Environments of Gymnasium over a scene: ``pip install polhode[gym]``.

>>> import polhode as ph
>>> scene = ph.Scene(gravity=9.81, duration=100.0)
>>> cart = scene.add(ph.Box(0.5, 0.3, 0.2), name="cart", mass=1.0)
>>> rail = scene.joint(ph.Slider(at=(0, 0, 0), axis=(1, 0, 0)), cart, name="rail")
>>> env = ph.gym.SceneEnv(scene, actions={"rail": 10.0}, observe=["rail.displacement", "rail.displacement_rate"])
>>> observation, info = env.reset(seed=1)
>>> observation, reward, terminated, truncated, info = env.step([1.0])    # 10 N, in parts of the most
>>> float(observation[1].round(9))    # m/s: F t / m, as t = 0.02 s
0.2
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from ._distributions import Distribution
from ._errors import SimulationError, UnknownName
from ._joints import Hinge, Planar, Slider
from ._polhode import Snapshot
from ._scene import Scene, load
from ._shapes import Box, Capsule, HalfSpace
from ._simulation import Simulation

try:
    import gymnasium  # type: ignore[import-not-found, unused-ignore]
except ImportError as missing:
    raise ImportError("polhode.gym needs gymnasium: pip install polhode[gym]") from missing

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from ._scene import SceneLike

    Observation = NDArray[np.float64]
    #: What is said of a state: of the environment, after a step.
    Said = Callable[["SceneEnv"], Any]

#: Quantities of a body and how many numbers they have.
_OF_BODY = {"position": 3, "orientation": 4, "velocity": 3, "angular_velocity": 3}
#: Coordinates of a joint.
_OF_JOINT = ("angle", "displacement", "distance")
_RATE = "_rate"


class SceneEnv(gymnasium.Env):  # type: ignore[type-arg, misc, unused-ignore]
    """An environment of Gymnasium over a scene.

    ``actions`` are joints (``"JOINT"`` or ``"JOINT.displacement"``) and the most effort of their motors, N m or N: an
    action has a number from -1 to 1 for each. ``observe`` names what is seen: ``"BODY.position"`` (also
    ``orientation``, ``velocity``, ``angular_velocity``, and ``[2]`` for one of their numbers), ``"JOINT.angle"``,
    ``"JOINT.angle_rate"`` ... ``interval`` is the time between actions, s. ``reward`` gets the environment after a
    step and gives a number (1 when absent); ``terminated`` says whether the episode has come to its end. It is
    truncated after the duration of the scene.

    ``vary`` has keys of the scene and distributions, as :func:`polhode.sweep`, which each ``reset`` draws from;
    ``begin`` may change ``env.sim`` at the beginning of an episode, by draws of ``env.np_random``. The same seed
    gives the same episode with the same bits.
    """

    metadata: dict[str, Any] = {"render_modes": []}

    def __init__(
        self,
        scene: SceneLike,
        *,
        actions: Mapping[str, float],
        observe: Sequence[str],
        interval: float = 0.02,
        reward: Said | None = None,
        terminated: Said | None = None,
        begin: Said | None = None,
        vary: Mapping[str, Distribution] | None = None,
        tier: str | None = None,
        step: float | None = None,
    ) -> None:
        import numpy as np

        if not interval > 0 or not math.isfinite(interval):
            raise ValueError(f"interval={interval}: a time above 0 s is needed")
        for key, drawn in (vary or {}).items():
            if not isinstance(drawn, Distribution):
                raise TypeError(f"vary: {key!r} is {drawn!r}, and a distribution such as ph.Normal is needed")
        self._loaded = load(scene, {"tier": tier, "step": step})
        self._vary = dict(vary or {})
        for key, drawn in self._vary.items():
            load(self._loaded, {"set": {key: drawn.at(0.5)}})
        self._interval = interval
        self._reward, self._terminated, self._begin = reward, terminated, begin
        joints = self._loaded.joint_names
        self._motors = [_motor(name, most, joints) for name, most in actions.items()]
        if not self._motors:
            raise ValueError('actions={}: at least 1 is needed, as in actions={"rail": 10.0}')
        self._seen = [_seen(name, self._loaded.body_names, joints) for name in observe]
        #: The simulation, which functions of reward may ask.
        self.sim = Simulation(self._loaded, error="off")
        #: The action of the last step.
        self.action: Observation = np.zeros(len(self._motors))
        for joint, coordinate, _ in self._motors:
            self.sim.coordinate(joint, coordinate)
        self._start = self.sim.snapshot()
        size = len(self.observation())
        if size == 0:
            raise ValueError('observe=[]: at least 1 is needed, as in observe=["rail.displacement"]')
        self.observation_space = gymnasium.spaces.Box(-np.inf, np.inf, (size,), np.float64)
        self.action_space = gymnasium.spaces.Box(-1.0, 1.0, (len(self._motors),), np.float64)

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Observation, dict[str, Any]]:
        """Begins an episode: by draws of what is varied. A snapshot in ``options["snapshot"]`` is begun from
        instead."""
        super().reset(seed=seed)
        self.action = self.action * 0.0
        snapshot = (options or {}).get("snapshot")
        if snapshot is not None:
            return self.restore(snapshot), {"t": self.sim.time}
        if self._vary:
            number = int(self.np_random.integers(2**62))
            drawn = {key: distribution.draw(number, 0, key) for key, distribution in self._vary.items()}
            self.sim = Simulation(self._loaded, error="off", set=drawn)
        else:
            self.sim.restore(self._start)
        if self._begin is not None:
            self._begin(self)
        return self.observation(), {"t": self.sim.time}

    def step(self, action: ArrayLike) -> tuple[Observation, float, bool, bool, dict[str, Any]]:
        """Drives the motors by an action for an interval. A simulation that cannot go on ends the episode, and
        ``info`` says why."""
        import numpy as np

        given = np.asarray(action, dtype=np.float64)
        if given.shape != self.action_space.shape:
            raise ValueError(f"action: shape {given.shape}, {self.action_space.shape} is needed")
        if not np.isfinite(given).all():
            raise ValueError(f"action {given}: finite numbers from -1 to 1 are needed")
        self.action = np.clip(given, -1.0, 1.0)
        for (joint, coordinate, most), part in zip(self._motors, self.action):
            self.sim.set_motor(joint, coordinate, effort=float(part) * most)
        info: dict[str, Any] = {}
        end = self._loaded.duration
        try:
            self.sim.advance_to(min((round(self.sim.time / self._interval) + 1) * self._interval, end))
        except SimulationError as error:
            info["error"] = str(error)
        info["t"] = self.sim.time
        is_over = "error" in info or bool(self._terminated is not None and self._terminated(self))
        reward = 1.0 if self._reward is None else float(self._reward(self))
        return self.observation(), reward, is_over, self.sim.time >= end, info

    def observation(self) -> Observation:
        """What is seen now."""
        import numpy as np

        return np.array([number for seen in self._seen for number in seen(self.sim)], dtype=np.float64)

    def snapshot(self) -> Snapshot:
        """The present state, for :meth:`restore` and ``reset(options={"snapshot": ...})``."""
        return self.sim.snapshot()

    def restore(self, snapshot: Snapshot) -> Observation:
        """Goes on from a snapshot of this episode, or of one with the same values, with the same bits; what is seen
        there."""
        self.sim.restore(snapshot)
        return self.observation()


def _motor(name: str, most: float, joints: list[str]) -> tuple[str, str | None, float]:
    joint, coordinate = _split(name, joints)
    if isinstance(most, bool) or not isinstance(most, (int, float)) or not (math.isfinite(most) and most > 0):
        raise ValueError(f"actions: {name!r} has {most!r}, and an effort above 0 is needed, N m or N")
    if joint is None:
        raise UnknownName(name, "joint", joints)
    return joint, coordinate or None, float(most)


def _split(name: str, names: Sequence[str]) -> tuple[str | None, str]:
    """The thing and its quantity that a name stands for."""
    if name in names:
        return name, ""
    of, _, quantity = name.rpartition(".")
    return (of if of in names else None), quantity


def _seen(name: str, bodies: list[str], joints: list[str]) -> Callable[[Simulation], Sequence[float]]:
    """What a name of an observation stands for."""
    whole, _, number = name.removesuffix("]").partition("[") if name.endswith("]") else (name, "", "")
    body, quantity = _split(whole, bodies)
    if body is not None:
        if quantity not in _OF_BODY:
            raise UnknownName(quantity, "quantity of a body", list(_OF_BODY))
        if number and (not number.isdecimal() or int(number) >= _OF_BODY[quantity]):
            raise ValueError(f"observe: {name!r}: a number from 0 to {_OF_BODY[quantity] - 1} is needed")
        chosen = slice(int(number), int(number) + 1) if number else slice(None)
        return lambda sim: getattr(sim.body(body), quantity)[chosen]
    joint, quantity = _split(name, joints)
    if joint is None:
        raise UnknownName(whole.rpartition(".")[0] or whole, "body or joint", [*bodies, *joints])
    coordinate = quantity.removesuffix(_RATE)
    if coordinate not in _OF_JOINT:
        raise UnknownName(quantity, "coordinate of a joint", [*_OF_JOINT, *(own + _RATE for own in _OF_JOINT)])
    told = "rate" if quantity.endswith(_RATE) else "value"
    return lambda sim: (getattr(sim.coordinate(joint, coordinate), told),)


def cart_pole(**keys: Any) -> SceneEnv:
    """The cart-pole: a cart of 1 kg on a rail that is pushed by at most 10 N, and a pole of 0.1 kg and 1 m upright on
    it.

    An episode begins with small blows at both. It ends where the pole leans by more than 12 degrees or the cart is
    2.4 m away, and is truncated after 10 s. Keys are those of :class:`SceneEnv`.

    >>> import polhode as ph
    >>> env = ph.gym.cart_pole()
    >>> observation, info = env.reset(seed=3)
    >>> observation.shape, env.action_space.shape
    ((4,), (1,))
    """
    scene = Scene(gravity=9.81, duration=10.0, name="cart-pole")
    cart = scene.add(Box(0.4, 0.3, 0.2), name="cart", mass=1.0)
    pole = scene.add(Box(0.05, 0.05, 1.0), name="pole", mass=0.1, at=(0, 0, 0.5))
    scene.joint(Slider(at=(0, 0, 0), axis=(1, 0, 0)), cart, name="rail")
    scene.joint(Hinge(at=(0, 0, 0), axis=(0, 1, 0)), pole, cart, name="hinge")
    scene.no_contact(cart, pole)
    given: dict[str, Any] = {
        "actions": {"rail": 10.0},
        "observe": ["rail.displacement", "rail.displacement_rate", "hinge.angle", "hinge.angle_rate"],
        "terminated": has_fallen,
        "begin": push,
    }
    return SceneEnv(scene, **{**given, **keys})


def has_fallen(env: SceneEnv) -> bool:
    """Whether the pole of :func:`cart_pole` leans too far, or its cart is too far away."""
    angle, displacement = env.sim.coordinate("hinge").value, env.sim.coordinate("rail").value
    return abs(angle) > math.radians(12.0) or abs(displacement) > 2.4


def push(env: SceneEnv) -> None:
    """The blows at which an episode of :func:`cart_pole` begins: at most 50 mm/s of the cart, and 0.15 rad/s of the
    pole."""
    of_cart, of_pole = (float(blow) for blow in env.np_random.uniform(-1.0, 1.0, 2))
    env.sim.apply_impulse("cart", (0.05 * of_cart, 0, 0), (0, 0, 0))
    env.sim.apply_impulse("pole", (0.005 * of_pole, 0, 0), (0, 0, 1.0))


#: Parts of the hopper: length (m), mass (kg) and the height of its middle (m).
_TORSO, _THIGH, _LEG = (0.4, 3.5, 1.21), (0.45, 3.9, 0.785), (0.5, 2.7, 0.31)


def hopper(**keys: Any) -> SceneEnv:
    """A hopper in the plane y = 0: torso, thigh, leg and foot on three hinges with motors, and a floor with friction.

    An episode begins with a small blow at the torso. Its reward is the way forward in m/s, 1 for each step in which it
    has not fallen, and the square of the action, which costs. It ends where the torso is below 0.7 m or leans by more
    than 0.4 rad, and is truncated after 10 s. Keys are those of :class:`SceneEnv`.

    >>> import polhode as ph
    >>> env = ph.gym.hopper()
    >>> observation, info = env.reset(seed=3)
    >>> observation.shape, env.action_space.shape
    ((11,), (3,))
    """
    scene = Scene(gravity=9.81, duration=10.0, name="hopper", method={"tier": "stepped", "step": 0.002})
    floor = scene.fixed(HalfSpace(), name="floor", friction=0.9)
    upright = {"torso": _TORSO, "thigh": _THIGH, "leg": _LEG}
    torso, thigh, leg = (
        scene.add(Capsule(0.05, length), name=name, mass=mass, at=(0, 0, height), friction=0.9)
        for name, (length, mass, height) in upright.items()
    )
    flat: dict[str, Any] = {"rotation_vector": (0, math.pi / 2, 0), "friction": 0.9}
    foot = scene.add(Capsule(0.06, 0.39), name="foot", mass=5.0, at=(0.065, 0, 0.06), **flat)
    scene.joint(Planar(at=(0, 0, _TORSO[2]), normal=(0, 1, 0)), torso, name="plane")
    back = (0, -1, 0)
    scene.joint(Hinge(at=(0, 0, 1.01), axis=back, range=(-2.6, 0.05), damping=1.0), thigh, torso, name="hip")
    scene.joint(Hinge(at=(0, 0, 0.56), axis=back, range=(-2.6, 0.05), damping=1.0), leg, thigh, name="knee")
    scene.joint(Hinge(at=(0, 0, 0.06), axis=back, range=(-0.8, 0.8), damping=1.0), foot, leg, name="ankle")
    scene.no_contact(torso, thigh, leg, foot)
    scene.no_contact(torso, floor)
    of_torso = ("position[2]", "orientation[2]", "velocity[0]", "velocity[2]", "angular_velocity[1]")
    hinges = ("hip", "knee", "ankle")
    given: dict[str, Any] = {
        "actions": dict.fromkeys(hinges, 100.0),
        "observe": [f"torso.{told}" for told in of_torso]
        + [f"{hinge}.{told}" for told in ("angle", "angle_rate") for hinge in hinges],
        "interval": 0.008,
        "reward": hops,
        "terminated": has_tumbled,
        "begin": nudge,
    }
    return SceneEnv(scene, **{**given, **keys})


def hops(env: SceneEnv) -> float:
    """The reward of :func:`hopper`."""
    forward = env.sim.body("torso").velocity[0]
    return forward + float(not has_tumbled(env)) - 1e-3 * float((env.action * env.action).sum())


def has_tumbled(env: SceneEnv) -> bool:
    """Whether the torso of :func:`hopper` is too low or leans too far."""
    torso = env.sim.body("torso")
    return torso.position[2] < 0.7 or abs(2.0 * math.asin(max(-1.0, min(1.0, torso.orientation[2])))) > 0.4


def nudge(env: SceneEnv) -> None:
    """The blow at which an episode of :func:`hopper` begins: at most 1 N s along at the top of its torso, either
    way."""
    blow = float(env.np_random.uniform(-1.0, 1.0))
    env.sim.apply_impulse("torso", (blow, 0, 0), (0, 0, _TORSO[2] + _TORSO[0] / 2))
