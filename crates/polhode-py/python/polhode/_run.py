"""Runs: trajectories as arrays, and what is certain of them."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from importlib import import_module
from typing import TYPE_CHECKING, Any, Iterator

from . import _polhode
from ._cost import Accuracy, all_effects, reached
from ._errors import Interrupted, NotKept, PolhodeError, SimulationError, UnknownName, ViewError
from ._estimate import OF_ERROR, RunError, TrackError, of_report
from ._progress import Bar, in_notebook
from ._scene import load
from ._show import Gif, Page, Plot, Still

if TYPE_CHECKING:
    import os

    import numpy as np
    from numpy.typing import NDArray

    from ._scene import Body, JointHandle, SceneLike, Vector

    Array = NDArray[np.float64]

#: Numbers of a body and of a joint in a sample.
_OF_BODY = 13
_OF_JOINT = 13
#: Bodies times frames of a page in a notebook at the most: 5 MB with their contacts.
_MOST_IN_NOTEBOOK = 100_000


def run(
    scene: SceneLike,
    *,
    duration: float | None = None,
    tier: str | None = None,
    accuracy: float | None = None,
    step: float | None = None,
    interval: float | None = None,
    error: str | None = None,
    set: Mapping[str, Any] | None = None,
    effects: str = "planned",
    joints: bool = True,
    frames: bool | None = None,
    progress: bool | None = None,
) -> Run:
    """Simulates a scene from its start to its end.

    ``scene`` is the path of a scene file or a robot, a dictionary with the keys of a scene file, a
    :class:`polhode.Scene` or a :class:`polhode.Robot`. ``duration`` and ``interval`` (between samples) are in s;
    ``tier`` is a set of methods with one promise (``"accurate"``, ``"stepped"``, ``"fast"`` ...), which the plan
    chooses when absent; ``accuracy`` is the largest error that is accepted (of positions, relative to the length of the
    scene, and in rad), for which the cheapest method is searched in some ten seconds; ``step`` is in s; ``set`` changes
    any key, as in ``set={"materials.ice.friction": 0.1}``. ``error`` says how the error of the run is estimated
    (:attr:`Run.error`): not at all (``"off"``), by runs beside it that are to add at most three tenths to its time
    (``"quick"``), or at most three times its time (``"full"``); when absent as the scene says, or quick.
    ``effects="all"`` leaves nothing out. Without ``joints`` the loads of joints, which cost a solve at each sample, are
    not computed.

    With ``frames`` what pages and plots tell is kept as well, for a solve of the contact forces at each sample; when
    absent, in notebooks. Without it the first page or plot simulates the scene again. ``progress`` shows a bar of
    tqdm; when absent, in notebooks and on terminals where tqdm is installed, for what takes longer than half a second.

    Ctrl-C raises :class:`polhode.Interrupted` within two seconds, whose ``run`` has what was computed.

    >>> import polhode as ph
    >>> run = ph.run({"format": 1, "duration": 1.0, "bodies": [
    ...     {"name": "ball", "shape": {"sphere": {"radius": 0.1}}, "mass": 1.0, "velocity": [0, 0, 9.81]}]})
    >>> run.outcome
    'completed'
    >>> float(run["ball"].position[-1, 2].round(9))    # m: g t - g t^2 / 2
    4.905
    """
    changes = {"duration": duration, "tier": tier, "step": step, "interval": interval, "error": error, "set": set}
    loaded = load(scene, changes)
    everything = all_effects(effects)
    chosen: Accuracy | None = None
    if accuracy is not None:
        loaded, chosen = reached(loaded, accuracy, everything, progress)
    with Bar(loaded.name, "s", progress) as bar:
        keep = _apart(loaded) if (in_notebook() if frames is None else frames) else None
        recording = _polhode.run(loaded, everything, joints, keep, bar.told)
    done = Run(loaded, recording, chosen)
    if recording.failure is not None:
        if isinstance(recording.failure, (SimulationError, Interrupted)):
            recording.failure.run = done
        raise recording.failure
    return done


def _apart(loaded: _polhode.Loaded) -> float:
    """Least time between the frames of a page in a notebook, s."""
    frames = max(2, _MOST_IN_NOTEBOOK // max(1, len(loaded.body_names)))
    return loaded.duration / (frames - 1)


class Track:
    """A body over the samples of a run. Arrays are views that cannot be written to."""

    __slots__ = ("name", "error", "_states")

    def __init__(self, name: str, states: Array, errors: Array | None = None) -> None:
        #: Name of the body.
        self.name = name
        #: Its estimated errors; none where they are not estimated.
        self.error = None if errors is None else TrackError(errors)
        self._states = states

    @property
    def position(self) -> Array:
        """Position of its own origin, world, m: (N, 3)."""
        return self._states[:, 0:3]

    @property
    def orientation(self) -> Array:
        """Orientation, a quaternion w x y z, body to world: (N, 4)."""
        return self._states[:, 3:7]

    @property
    def velocity(self) -> Array:
        """Velocity of its centre of mass, world, m/s: (N, 3)."""
        return self._states[:, 7:10]

    @property
    def angular_velocity(self) -> Array:
        """Angular velocity, world, rad/s: (N, 3)."""
        return self._states[:, 10:13]

    def __repr__(self) -> str:
        return f"<polhode.Track {self.name!r}: {len(self._states)} samples>"


class JointTrack:
    """A joint over the samples of a run; NaN where it has no such coordinate, or its tier computes no loads."""

    __slots__ = ("name", "_states")

    def __init__(self, name: str, states: Array) -> None:
        #: Name of the joint.
        self.name = name
        self._states = states

    @property
    def angle(self) -> Array:
        """Angle about its axis, rad: (N,); with all its revolutions, if it has no limits."""
        return self._states[:, 0]

    @property
    def angle_rate(self) -> Array:
        """Rate of the angle, rad/s: (N,)."""
        return self._states[:, 1]

    @property
    def displacement(self) -> Array:
        """Displacement along its axis, m: (N,)."""
        return self._states[:, 2]

    @property
    def displacement_rate(self) -> Array:
        """Rate of the displacement, m/s: (N,)."""
        return self._states[:, 3]

    @property
    def distance(self) -> Array:
        """Distance of its anchors, m: (N,)."""
        return self._states[:, 4]

    @property
    def distance_rate(self) -> Array:
        """Rate of the distance, m/s: (N,)."""
        return self._states[:, 5]

    @property
    def force(self) -> Array:
        """Force on its first body at its anchor, world, N: (N, 3)."""
        return self._states[:, 6:9]

    @property
    def torque(self) -> Array:
        """Moment on its first body about its anchor, world, N m: (N, 3); without motors, springs and dampers."""
        return self._states[:, 9:12]

    @property
    def power(self) -> Array:
        """What it gives to its bodies, W: (N,)."""
        return self._states[:, 12]

    def __repr__(self) -> str:
        return f"<polhode.JointTrack {self.name!r}: {len(self._states)} samples>"


class Joints(Mapping[str, JointTrack]):
    """The joints of a run by their names."""

    def __init__(self, names: list[str], states: Array) -> None:
        self._names = names
        self._states = states

    def __getitem__(self, joint: str | JointHandle) -> JointTrack:
        number = _number("joint", joint, self._names)
        return JointTrack(self._names[number], self._states[:, number * _OF_JOINT : (number + 1) * _OF_JOINT])

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)


class Energies:
    """Energies over the samples of a run, J: each (N,)."""

    __slots__ = ("_energies",)

    def __init__(self, energies: Array) -> None:
        self._energies = energies

    @property
    def kinetic(self) -> Array:
        """Kinetic energy, J: (N,)."""
        return self._energies[:, 0]

    @property
    def potential(self) -> Array:
        """Potential energy, J: (N,); zero at the world's origin."""
        return self._energies[:, 1]

    @property
    def total(self) -> Array:
        """Their sum, J: (N,)."""
        total: Array = self._energies.sum(axis=1)
        return total


class Run(Mapping[str, Track]):
    """What a run has computed: ``run["brick"].position`` is (N, 3), ``run.t`` is (N,).

    >>> import polhode as ph
    >>> scene = ph.Scene(duration=1.0, interval=0.1)
    >>> floor = scene.fixed(ph.HalfSpace())
    >>> ball = scene.add(ph.Sphere(0.1), mass=1.0, at=(0, 0, 0.6), restitution=0.5)
    >>> run = ph.run(scene)
    >>> run.t.shape, run["sphere"].orientation.shape, run.energy.kinetic.shape
    ((11,), (11, 4), (11,))
    >>> print(run.events["kind"][0], run.events["t"][0])
    impact 0.3192754284070504
    >>> run.check()
    """

    def __init__(
        self, loaded: _polhode.Loaded, recording: _polhode.Recording, accuracy: Accuracy | None = None
    ) -> None:
        self._loaded = loaded
        self._recording = recording
        #: How the run reaches the accuracy that was asked for; none where none was.
        self.accuracy = accuracy
        #: The page that was made last, with the least time between its frames, s.
        self._last: tuple[float, Page] | None = None

    @property
    def name(self) -> str:
        """Name of the scene."""
        return self._loaded.name

    @property
    def t(self) -> Array:
        """Times of the samples, s: (N,)."""
        return self._recording.times()

    def __getitem__(self, body: str | Body) -> Track:
        names = self._recording.body_names
        number = _number("body", body, names)
        errors = self._recording.errors()
        if errors is not None:
            errors = errors[:, number * OF_ERROR : (number + 1) * OF_ERROR]
        return Track(names[number], self._recording.states()[:, number * _OF_BODY : (number + 1) * _OF_BODY], errors)

    def __iter__(self) -> Iterator[str]:
        return iter(self._recording.body_names)

    def __len__(self) -> int:
        return len(self._recording.body_names)

    def __contains__(self, body: object) -> bool:
        return getattr(body, "name", body) in self._recording.body_names

    @cached_property
    def joints(self) -> Joints:
        """The joints by their names."""
        return Joints(self._recording.joint_names, self._recording.joints())

    @cached_property
    def energy(self) -> Energies:
        """Energies at the samples, J."""
        return Energies(self._recording.energies())

    @cached_property
    def events(self) -> NDArray[np.void]:
        """Events in order of time: a structured array with the fields ``t`` (s), ``kind``, ``body_a``, ``body_b``
        (empty where there is no second body), ``point`` (m), ``normal`` (from B to A), ``impulse`` (N s) and
        ``energy_change`` (J)."""
        from ._events import structured

        return structured(self._recording.body_names, *self._recording.events())

    @cached_property
    def report(self) -> dict[str, Any]:
        """The report, as ``polhode run --json`` prints it; empty for a run that failed."""
        import json

        report: dict[str, Any] = json.loads(self._recording.report or "{}")
        return report

    @property
    def outcome(self) -> str:
        """How the run has ended: completed, stopped, degraded; or failed."""
        return str(self.report.get("outcome", "failed"))

    @property
    def warnings(self) -> list[str]:
        """What should be known of the run: exceeded limits of the promise first."""
        return list(self.report.get("warnings", ()))

    @property
    def plan(self) -> dict[str, Any]:
        """Which effects were simulated, by which method, and why."""
        return dict(self.report.get("plan", {}))

    @property
    def ledger(self) -> dict[str, Any]:
        """Where the energy went, J, by cause, and how exactly the sum closes."""
        return dict(self.report.get("ledger", {}))

    @cached_property
    def certificate(self) -> dict[str, Any]:
        """The largest value of each measure of accuracy over the run, relative to its limit, and where it was."""
        import json

        certificate: dict[str, Any] = json.loads(self._recording.certificate or "{}")
        return certificate

    @cached_property
    def error(self) -> RunError | None:
        """Estimated error of the run; none where none is known, as with ``error="off"``. As a number it is the largest
        one, relative to the size of its body; where an accuracy was asked for, that of :class:`polhode.Accuracy`."""
        return of_report(self.report, None if self.accuracy is None else self.accuracy.error)

    @property
    def horizon(self) -> float | None:
        """When a difference of rounding at the start has grown to a hundredth of a body, s: what lies after it is one
        of many outcomes. None where it has not, or that is not known."""
        horizon: float | None = self.report.get("error", {}).get("horizon_s")
        return horizon

    def check(self) -> None:
        """Raises :class:`polhode.NotKept` when the run has not kept what its method promises.

        >>> import polhode as ph
        >>> run = ph.run({"format": 1, "duration": 1.0, "bodies": [
        ...     {"name": "nut", "mass": 1.0, "inertia": [1, 2, 3], "angular_velocity": [0.1, 9, 0]}]},
        ...     set={"method.integrator": "explicit-euler"}, step=0.01)
        >>> try:
        ...     run.check()
        ... except ph.NotKept as broken:
        ...     broken.value > broken.limit, broken.cure
        (True, 'a step of ... s instead of 1e-2 s would do')
        """
        import json

        if self.outcome in ("completed", "stopped"):
            return
        broken: list[dict[str, Any]] = json.loads(self._recording.broken)
        first = broken[0] if broken else {}
        message = first.get("warning") or next(iter(self.warnings), "the run has no report")
        at = [f"t = {first['t_s']} s"] if first.get("t_s") is not None else []
        bodies = dict.fromkeys(first.get("bodies") or ())
        place = ", ".join(at + [" and ".join(bodies)] if bodies else at) or None
        raise NotKept(
            f"{self.name}: {message}",
            place=place,
            value=first.get("value"),
            limit=first.get("limit"),
            cure=first.get("cure"),
            broken=broken,
        )

    def to_pandas(self) -> Any:
        """The trajectory as a pandas ``DataFrame``: a row for each sample, columns (body, px ... wz), index t."""
        pandas: Any = import_module("pandas")
        columns = "px py pz qw qx qy qz vx vy vz wx wy wz".split()
        index = pandas.MultiIndex.from_product([list(self), columns], names=["body", "quantity"])
        times = pandas.Index(self.t, name="t")
        return pandas.DataFrame(self._recording.states(), index=times, columns=index, copy=False)

    def to_xarray(self) -> Any:
        """The trajectory as an xarray ``Dataset`` over ``t`` and ``body``."""
        xarray: Any = import_module("xarray")
        states = self._recording.states().reshape(len(self.t), len(self), _OF_BODY)
        axes, wxyz = ["x", "y", "z"], ["w", "x", "y", "z"]
        return xarray.Dataset(
            {
                "position": (("t", "body", "axis"), states[:, :, 0:3], {"units": "m"}),
                "orientation": (("t", "body", "quaternion"), states[:, :, 3:7]),
                "velocity": (("t", "body", "axis"), states[:, :, 7:10], {"units": "m/s"}),
                "angular_velocity": (("t", "body", "axis"), states[:, :, 10:13], {"units": "rad/s"}),
            },
            coords={"t": self.t, "body": list(self), "axis": axes, "quaternion": wxyz},
        )

    def view(self, path: str | os.PathLike[str] | None = None, *, frames: int | None = None) -> Page:
        """Shows the page that plays the run: in the notebook, or else in a browser. With a ``path`` it is written there
        instead. ``frames`` is as in :meth:`page`.
        """
        file = None if path is None else Page.place(path)
        page = self.page(frames=frames)
        if file is not None:
            page.save(file)
        elif not in_notebook():
            page.open()
        return page

    def page(self, *, frames: int | None = None) -> Page:
        """The page that plays the run, as ``polhode run -o run.html`` writes it; it needs no network.

        It has at most so many ``frames`` (10,000 when absent) among the samples of the run. Where the run has not kept
        what it tells (``frames`` of :func:`polhode.run`), the scene is simulated again, with the same bits.

        >>> import polhode as ph
        >>> scene = ph.Scene(name="ball", duration=0.1)
        >>> ball = scene.add(ph.Sphere(0.1), mass=1.0)
        >>> page = ph.run(scene).page(frames=5)
        >>> page.html.startswith("<!doctype html>")
        True
        """
        least = 0.0
        if frames is not None:
            if not frames >= 2:
                raise ViewError(f"frames={frames} is below its limit, 2: the first frame and the last")
            least = self._loaded.duration / (frames - 1)
        return self._page(least)

    def _page(self, least: float) -> Page:
        """The page with frames at least so far apart, s."""
        if self._last is None or self._last[0] != least:
            with Bar(f"{self.name}: page", "s", None) as bar:
                self._last = least, Page(self.name, _polhode.page(self._recording, least, bar.told).encode())
        return self._last[1]

    def still(
        self,
        t: float | None = None,
        path: str | os.PathLike[str] | None = None,
        *,
        size: tuple[int, int] | None = None,
        camera: str | Vector | None = None,
        look_at: Vector | None = None,
    ) -> Still:
        """The run at the sample nearest to ``t`` (s; the last one when absent) as a picture; with a ``path`` it is
        written there, as PNG.

        ``size`` is its width and height, 1280 x 720 pixels when absent; ``camera`` is ``"front"``, ``"side"``,
        ``"top"``, ``"iso"`` or the place of the camera (m); ``look_at`` the place in the middle of the picture (m).

        >>> import polhode as ph
        >>> scene = ph.Scene(duration=0.1)
        >>> ball = scene.add(ph.Sphere(0.1), mass=1.0)
        >>> ph.run(scene).still(0.05, size=(64, 36)).data[1:4]
        b'PNG'
        """
        file = None if path is None else Still.place(path)
        asked = {"size": size, "camera": camera, "look_at": look_at}
        still = Still(self.name, _polhode.still(self._recording, t, asked, None))
        if file is not None:
            still.save(file)
        return still

    def gif(
        self,
        path: str | os.PathLike[str] | None = None,
        *,
        fps: float | None = None,
        size: tuple[int, int] | None = None,
        camera: str | Vector | None = None,
        look_at: Vector | None = None,
    ) -> Gif:
        """The run as a moving picture in real time, of at most ``fps`` frames a second (25 when absent) among its
        samples; with a ``path`` it is written there. The others are those of :meth:`still`; ``size`` is 640 x 360 when
        absent.

        >>> import polhode as ph
        >>> scene = ph.Scene(duration=0.1)
        >>> ball = scene.add(ph.Sphere(0.1), mass=1.0)
        >>> ph.run(scene).gif(size=(64, 36)).data[:6]
        b'GIF89a'
        """
        file = None if path is None else Gif.place(path)
        asked = {"size": size, "camera": camera, "look_at": look_at}
        with Bar(f"{self.name}: moving picture", "frames", None) as bar:
            gif = Gif(self.name, _polhode.gif(self._recording, fps, asked, bar.told))
        if file is not None:
            gif.save(file)
        return gif

    def plot(self, *names: str, path: str | os.PathLike[str] | None = None) -> Plot:
        """Quantities over time; with a ``path`` they are written there, as SVG.

        ``names`` are those of ``polhode run --plot``: ``"energy"``, ``"ledger"``, ``"penetration"``, ``"contacts"``,
        ``"steps"`` (these five when none are given), ``"joint-coordinates"``, ``"joint-rates"``, ``"joint-forces"``,
        ``"joint-moments"``, ``"joint-powers"``. Where the run has not kept them (``frames`` of :func:`polhode.run`),
        the scene is simulated again, once for all plots.

        >>> import polhode as ph
        >>> scene = ph.Scene(duration=0.1)
        >>> ball = scene.add(ph.Sphere(0.1), mass=1.0)
        >>> ph.run(scene).plot("energy", "steps").svg.count("</svg>")
        1
        """
        file = None if path is None else Plot.place(path)
        with Bar(f"{self.name}: plots", "s", None) as bar:
            plot = Plot(self.name, _polhode.plot(self._recording, list(names), bar.told).encode())
        if file is not None:
            plot.save(file)
        return plot

    def _repr_html_(self) -> str | None:
        try:
            return self._page(_apart(self._loaded))._repr_html_()
        except PolhodeError:
            # Nothing can be shown: its repr says what there is.
            return None

    def __repr__(self) -> str:
        return f"<polhode.Run {self.name!r}: {self.outcome}, {len(self.t)} samples of {len(self)} bodies>"


def _number(kind: str, given: object, names: list[str]) -> int:
    name = getattr(given, "name", given)
    if name in names:
        return names.index(name)
    raise UnknownName(str(name), kind, names)
