"""What accuracy costs: many methods on one scene, each with its error and its time."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple, overload

from . import _polhode, _toml
from ._progress import Bar
from ._scene import _read, load

if TYPE_CHECKING:
    from ._scene import SceneLike


class Accuracy(NamedTuple):
    """How a run reaches the accuracy that was asked for."""

    #: The largest error that is accepted: of positions, relative to the length of the scene, and of attitudes, rad.
    asked: float
    #: The error of the chosen method on this scene, as the same.
    error: float
    #: The cheapest method that reaches it, and its setting.
    method: str
    #: Keys of the scene and their values, as TOML.
    settings: dict[str, str]
    #: Other methods that reach it, and whose cost cannot be told from that of the chosen one.
    ties: tuple[str, ...]


class Candidate(NamedTuple):
    """A method with a setting, its error and its cost. NaN and 0 steps where it did not run: ``reason`` says why."""

    method: str
    setting: str
    #: Largest error: of positions, relative to the length of the scene, or of attitudes, rad. Not below what is known.
    error: float
    #: Largest distance of a body from the solution, mm.
    error_mm: float
    #: Time relative to ``Cost.base``.
    time: float
    #: Microseconds of computing for each simulated second, on this machine.
    us_per_s: float
    steps: int
    #: Whether no other candidate is both cheaper and more accurate.
    on_front: bool
    reason: str
    #: Keys of the scene and their values, as TOML.
    settings: dict[str, str]


class Cost(Sequence[Candidate]):
    """Error against time of many methods on one scene."""

    def __init__(self, study: dict[str, Any]) -> None:
        self._candidates = [_candidate(entry) for entry in study["candidates"]]
        #: Name of the scene.
        self.scene: str = study["scene"]
        #: The candidate whose time is 1.
        self.base: str = study["base"]
        #: What candidates are compared with, how that was found, and how well it is known.
        self.references: list[dict[str, Any]] = study["references"]

    @overload
    def __getitem__(self, number: int) -> Candidate: ...
    @overload
    def __getitem__(self, number: slice) -> list[Candidate]: ...
    def __getitem__(self, number: int | slice) -> Candidate | list[Candidate]:
        return self._candidates[number]

    def __iter__(self) -> Iterator[Candidate]:
        return iter(self._candidates)

    def __len__(self) -> int:
        return len(self._candidates)

    @property
    def front(self) -> list[Candidate]:
        """The candidates that no other beats in both error and time, the cheapest first."""
        return sorted((entry for entry in self if entry.on_front), key=lambda entry: entry.time)

    def to_pandas(self) -> Any:
        """The candidates as a pandas ``DataFrame``."""
        pandas: Any = import_module("pandas")
        return pandas.DataFrame(self._candidates, columns=list(Candidate._fields))

    def __repr__(self) -> str:
        ran = sum(not entry.reason for entry in self)
        return f"<polhode.Cost of {self.scene!r}: {ran} candidates, {len(self) - ran} left out>"


def cost(
    scene: SceneLike,
    *,
    vary: Mapping[str, Sequence[Any]] | None = None,
    budget: float | None = None,
    set: Mapping[str, Any] | None = None,
    effects: str = "planned",
    progress: bool | None = None,
) -> Cost:
    """What accuracy costs on a scene: its error and its time by many methods and steps.

    ``vary`` has keys of the scene and the values that they take, all combinations of them; without it all methods run
    that suit the scene, over steps and tolerances. ``budget`` is the time that these may take together, about, in s
    (10). ``set`` changes keys of the scene for all of them. ``progress`` as for :func:`polhode.run`.

    >>> import polhode as ph
    >>> nut = {"name": "nut", "mass": 1.0, "inertia": [1, 2, 3], "angular_velocity": [0.1, 9, 0]}
    >>> cost = ph.cost({"format": 1, "duration": 1.0, "bodies": [nut]}, vary={"method.step": [0.1, 0.01]}, set={
    ...     "method.integrator": "rk4"})
    >>> [entry.setting for entry in cost]
    ['step 0.1', 'step 0.01']
    >>> cost[1].error < 1e-3 * cost[0].error       # of fourth order
    True
    """
    import json

    loaded = load(scene, {"set": set})
    axes = [_axis(key, values) for key, values in (vary or {}).items()]
    with Bar(f"{loaded.name}: methods", "phases", progress) as bar:
        told = _polhode.study(loaded, all_effects(effects), bar.told, None, axes, budget)
    return Cost(json.loads(told))


def all_effects(effects: str) -> bool:
    """Whether nothing is left out of a simulation."""
    if effects not in ("planned", "all"):
        raise ValueError(f'effects={effects!r}: "planned" or "all" is needed')
    return effects == "all"


def reached(
    loaded: _polhode.Loaded, accuracy: float, effects: bool, progress: bool | None
) -> tuple[_polhode.Loaded, Accuracy]:
    """The scene with the cheapest method that reaches an accuracy."""
    import json

    with Bar(f"{loaded.name}: methods", "phases", progress) as bar:
        target = json.loads(_polhode.study(loaded, effects, bar.told, float(accuracy)))["target"]
    chosen = target["cheapest"]
    how, arguments, before = loaded.source()
    changes = [("accuracy=", key, value) for key, value in chosen["changes"].items()]
    told = Accuracy(accuracy, chosen["known_error"], chosen["name"], chosen["changes"], tuple(target["ties"]))
    return _read(how, arguments, [*before, *changes]), told


def _axis(key: str, values: Sequence[Any]) -> str:
    if isinstance(values, str) or not isinstance(values, Sequence):
        raise TypeError(f"vary[{key!r}] is {values!r}: a list of values is needed")
    return f"{_toml.path(key)}={','.join(_toml.value(_toml.plain(value, key)) for value in values)}"


def _candidate(entry: dict[str, Any]) -> Candidate:
    nan = float("nan")
    error = entry.get("known_error")
    return Candidate(
        entry["method"],
        entry["setting"],
        nan if error is None else error,
        entry.get("position_error_mm", nan),
        entry.get("time_ratio", nan),
        entry.get("us_per_simulated_s", nan),
        entry.get("steps", 0),
        entry.get("pareto", False),
        entry.get("failure", ""),
        entry["changes"],
    )
