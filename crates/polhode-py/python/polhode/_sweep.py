"""Sweeps: many runs of a scene, on the processes of one machine or of many."""

from __future__ import annotations

import os
from collections.abc import Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Any, Callable, NamedTuple

from . import _toml
from ._distributions import Distribution
from ._errors import Interrupted, PolhodeError, SceneError, SweepError, SweepStopped
from ._measures import OWN, needs_loads, read
from ._progress import Bar
from ._record import Record, Row
from ._run import run as run_one
from ._scene import _read, load
from ._table import Table

if TYPE_CHECKING:
    from ._measures import Measures
    from ._run import Run
    from ._scene import SceneLike

#: Most runs of a sweep: a table of a few columns fills a GB.
MOST_RUNS = 10_000_000


def sweep(
    scene: SceneLike,
    *,
    vary: Mapping[str, Any],
    runs: int | None = None,
    seed: int = 0,
    measure: Measures = None,
    executor: Any = None,
    save: str | os.PathLike[str] | None = None,
    duration: float | None = None,
    tier: str | None = None,
    step: float | None = None,
    interval: float | None = None,
    set: Mapping[str, Any] | None = None,
    effects: str = "planned",
    progress: bool | None = None,
) -> Table:
    """Runs a scene many times with other values, and measures each run.

    ``vary`` has keys of a scene file, as ``set`` of :func:`polhode.run`. A list stands for each of its values, and
    several lists for each combination of theirs (a grid, the last list fastest); a distribution
    (:class:`polhode.Normal`, :class:`polhode.Uniform` ...) is drawn from for each run. ``runs`` is the number of
    draws of each point of the grid. The draws of a run depend on ``seed``, its number and the key alone. Draws come
    first, then the grid, so that the first rows of more ``runs`` are those of fewer.

    ``measure`` names what the table has of each run: ``"box.position[2]@end"`` (``start``, ``least``, ``most``),
    ``"hinge.angle@most"``, ``"energy.kinetic@end"``, ``"events.impact"`` (their number); or it is a dictionary of
    columns and functions of a :class:`polhode.Run` that give a number.

    ``executor`` is one of ``concurrent.futures``, a ``Client`` of ``dask.distributed``, or a number of processes of
    this machine (as many as it has processors when absent). The table has the same bits for each of them. A run that
    fails is a row with its ``reason``. Runs that a lost worker had are submitted again.

    ``save`` is a file, CSV or Parquet (by its ending; by pyarrow), in which finished runs are kept: the same call
    goes on where it was killed. Functions in ``measure`` are known to it by their names: when one of them changes,
    save to another file.

    ``progress`` shows a bar of tqdm; when absent, in notebooks and on terminals where tqdm is installed.

    >>> import polhode as ph
    >>> from concurrent.futures import ThreadPoolExecutor
    >>> scene = ph.Scene(duration=0.5)
    >>> ball = scene.add(ph.Sphere(0.1), name="ball", mass=1.0, velocity=(0, 0, 5))
    >>> with ThreadPoolExecutor() as threads:
    ...     table = ph.sweep(scene, vary={"bodies.ball.velocity[2]": ph.Normal(5, 0.1)}, runs=20,
    ...                      measure={"height": "ball.position[2]@end"}, executor=threads)
    >>> table
    <polhode.Table: 20 runs (20 completed); run, bodies.ball.velocity[2], outcome, error, height, reason>
    >>> mean = table.mean("height")
    >>> abs(mean.value - (5 * 0.5 - 9.81 * 0.5**2 / 2)) < 4 * mean.standard_error
    True
    """
    if effects not in ("planned", "all"):
        raise ValueError(f'effects={effects!r}: "planned" or "all" is needed')
    loaded = load(scene, {"duration": duration, "tier": tier, "step": step, "interval": interval, "set": set})
    plan = _Plan(vary, runs, seed)
    plan.check(loaded)
    measures = read(measure, loaded)
    for name in measures:
        if name in plan.keys:
            raise SweepError(f"measure {name!r} has the name of what is varied", "rename it")
    how, arguments, changes = loaded.source()
    if how == "file":
        arguments = [os.path.abspath(arguments[0])]
    work = _Work((how, arguments, changes), tuple(measures.items()), effects, needs_loads(measures))
    columns = ["run", *plan.keys, "outcome", "error", *measures, "reason"]
    record = None if save is None else Record(save, _digest(work, plan), columns, len(measures))
    with Bar(loaded.name, "runs", progress) as bar:
        return _computed(work, plan, columns, executor, record, bar)


class _Plan:
    """Which values each run has."""

    def __init__(self, vary: Mapping[str, Any], runs: int | None, seed: int) -> None:
        if not isinstance(vary, Mapping) or not vary:
            raise SweepError(
                f"vary={vary!r}: a dictionary with a key is needed", 'vary={"materials.ice.friction": [0.1, 0.2]}'
            )
        for name in OWN:
            if name in vary:
                raise SweepError(f"vary: {name!r} is a column of every table", "it is no key of a scene")
        self.keys = [str(key) for key in vary]
        self.drawn = {key: own for key, own in vary.items() if isinstance(own, Distribution)}
        self.listed = {key: _values(key, own) for key, own in vary.items() if key not in self.drawn}
        self.seed = _whole("seed", seed)
        self.points = 1
        for values in self.listed.values():
            self.points *= len(values)
        self.runs = self._count(runs)

    def _count(self, runs: int | None) -> int:
        if runs is None:
            if self.drawn:
                raise SweepError(
                    f"runs is not given, and {', '.join(self.drawn)} is drawn", "give the number of draws, as runs=100"
                )
            runs = 1
        total = runs * self.points if isinstance(runs, (int, float)) else _whole("runs", runs) * self.points
        if not total <= MOST_RUNS:
            each = f" of {self.points} points each" if self.points > 1 else ""
            raise SweepError(
                f"runs={runs}{each}: the limit is {MOST_RUNS} runs in all", "make several sweeps with other seeds"
            )
        draws = _whole("runs", runs)
        if draws < 1:
            raise SweepError(f"runs={runs} is below its limit, 1", "give the number of draws")
        if draws > 1 and not self.drawn:
            raise SweepError(
                f"runs={runs}: nothing is drawn, so that all runs of a point would be the same one and the limit is 1",
                "leave runs out, or vary by a distribution such as ph.Normal",
            )
        return draws * self.points

    def values(self, run: int) -> tuple[Any, ...]:
        """The values of a run, in the order of the keys."""
        own: dict[str, Any] = {key: drawn.draw(self.seed, run, key) for key, drawn in self.drawn.items()}
        point = run % self.points
        for key in reversed(self.listed):
            values = self.listed[key]
            own[key] = values[point % len(values)]
            point //= len(values)
        return tuple(own[key] for key in self.keys)

    def check(self, loaded: Any) -> None:
        """Raises where a key is none of the scene, or a value of a list is not accepted: before anything is
        computed."""
        for key in self.keys:
            values = self.listed[key] if key in self.listed else [self.drawn[key].at(0.5)]
            for value in values:
                load(loaded, {"set": {key: value}})

    def told(self) -> list[Any]:
        """What makes it this sweep and no other; the number of draws does not."""
        return [self.seed, [[key, repr(self.drawn.get(key, self.listed.get(key)))] for key in self.keys]]


class _Work(NamedTuple):
    """What is the same in each run."""

    source: tuple[str, list[str], list[tuple[str, str, str]]]
    measures: tuple[tuple[str, Callable[[Run], float]], ...]
    effects: str
    loads: bool


def _computed(
    work: _Work, plan: _Plan, columns: list[str], executor: Any, record: Record | None, bar: Bar
) -> Table:
    from ._workers import TRIES, Workers

    rows: dict[int, Row] = {} if record is None else record.rows
    beyond = max(rows, default=-1)
    if beyond >= plan.runs:
        raise SweepError(
            f"save: the file has run {beyond}, and runs 0 to {plan.runs - 1} were asked",
            "give more runs, or another path",
        )
    packed = _packed(work)

    def changes(run: int) -> list[tuple[str, str, str]]:
        values = zip(plan.keys, plan.values(run))
        return [("set=", _toml.path(key), _toml.value(_toml.plain(value, key))) for key, value in values]

    def call(runs: list[int]) -> tuple[Any, ...]:
        return compute, packed, [(run, changes(run)) for run in runs]

    def take(run: int, result: tuple[Any, ...] | None) -> None:
        lost = Row(
            run, "failed", float("nan"), (float("nan"),) * len(work.measures), f"its worker was lost {TRIES} times"
        )
        row = lost if result is None else Row(*result)
        if record is None:
            rows[run] = row
        else:
            record.append(row, _cells(row, plan))
        if bar.told is not None:
            bar.told(len(rows), plan.runs)

    missing = [run for run in range(plan.runs) if run not in rows]
    try:
        if missing:
            Workers(executor, len(missing)).compute(missing, call, take)
    except SweepStopped as stopped:
        stopped.table = _table(rows, plan, columns)
        raise
    except KeyboardInterrupt:
        interrupted = Interrupted(f"{len(rows)} of {plan.runs} runs are finished")
        interrupted.table = _table(rows, plan, columns)
        raise interrupted from None
    finally:
        if record is not None:
            record.close()
    table = _table(rows, plan, columns)
    if record is not None:
        record.finish(table)
    return table


def _cells(row: Row, plan: _Plan) -> tuple[Any, ...]:
    return (row.run, *plan.values(row.run), row.outcome, row.error, *row.measured, row.reason)


def _table(rows: Mapping[int, Row], plan: _Plan, columns: list[str]) -> Table:
    cells = [_cells(rows[run], plan) for run in sorted(rows)]
    return Table({name: [row[number] for row in cells] for number, name in enumerate(columns)})


def compute(packed: bytes, runs: list[tuple[int, list[tuple[str, str, str]]]]) -> tuple[float, list[tuple[Any, ...]]]:
    """What a worker does: some runs, of which it tells how long they took, s, and the row of each."""
    from time import monotonic

    begun = monotonic()
    work = _unpacked(packed)
    rows = [_row(work, run, changes) for run, changes in runs]
    return monotonic() - begun, rows


def _row(work: _Work, run: int, changes: list[tuple[str, str, str]]) -> tuple[Any, ...]:
    """A run, of which it tells run, outcome, error, what was measured, and reason."""
    nothing = (float("nan"),) * len(work.measures)
    how, arguments, before = work.source
    try:
        loaded = _read(how, arguments, [*before, *changes])
        done = run_one(loaded, effects=work.effects, joints=work.loads, frames=False, progress=False)
    except Exception as error:
        return run, "failed", float("nan"), nothing, _reason(error)
    estimated = float("nan") if done.error is None else float(done.error)
    measured = []
    for name, measure in work.measures:
        try:
            measured.append(float(measure(done)))
        except Exception as wrong:
            return run, "failed", estimated, nothing, f"measure {name!r}: {type(wrong).__name__}: {_reason(wrong)}"
    reason = "" if done.outcome == "completed" else next(iter(done.warnings), "")
    return run, done.outcome, estimated, tuple(measured), " ".join(reason.split())


def _reason(error: Exception) -> str:
    """What went wrong, in one line."""
    text = str(error)
    if isinstance(error, SceneError) and error.errors:
        first = error.errors[0]
        text = f"{first['place'].key}: {first['message']}" + (f" ({error.cure})" if error.cure else "")
    elif not isinstance(error, PolhodeError):
        text = f"{type(error).__name__}: {text}"
    return " ".join(text.split())


def _packed(work: _Work) -> bytes:
    import pickle

    try:
        # It packs functions of notebooks and lambdas, too.
        import cloudpickle  # type: ignore[import-untyped, import-not-found, unused-ignore]

        packed: bytes = cloudpickle.dumps(work)
        return packed
    except ImportError:
        pass
    try:
        return pickle.dumps(work)
    except Exception as error:
        raise SweepError(
            f"measure: {error}, and workers have to get it",
            "give functions that are defined in a module by def, or pip install cloudpickle",
        ) from error


@lru_cache(maxsize=1)
def _unpacked(packed: bytes) -> _Work:
    import pickle

    work: _Work = pickle.loads(packed)
    return work


def _values(key: str, given: Any) -> list[Any]:
    """The values of a list of the grid, as a scene has them."""
    if isinstance(given, (str, Mapping)) or not hasattr(given, "__iter__"):
        raise SweepError(
            f"vary: {key!r} is {given!r}, and a list or a distribution is needed",
            "give one value by set=, or as a list of one",
        )
    values = _toml.plain(list(given), key)
    if not values:
        raise SweepError(f"vary: {key!r} has 0 values, and at least 1 is needed", "leave it out, or give values")
    return list(values)


def _whole(name: str, given: Any) -> int:
    import operator

    try:
        return operator.index(given)
    except TypeError:
        raise SweepError(f"{name}={given!r} is no whole number", f"{name}=100") from None


def _digest(work: _Work, plan: _Plan) -> str:
    """What a sweep is told by: scene, values, measures and the version of the library."""
    import hashlib
    import json

    from . import _polhode

    how, arguments, changes = work.source
    if how == "file":
        with open(arguments[0], "rb") as file:
            arguments = [hashlib.sha256(file.read()).hexdigest()]
    measures = [[name, _name(own)] for name, own in work.measures]
    told = [_polhode.__version__, how, arguments, changes, work.effects, measures, plan.told()]
    return hashlib.sha256(json.dumps(told).encode()).hexdigest()[:32]


def _name(measure: Any) -> str:
    """What a measure is told by: a function by its name, another callable by its state."""
    import hashlib
    import pickle

    own = measure if hasattr(measure, "__qualname__") else type(measure)
    name = f"{own.__module__}.{own.__qualname__}"
    if own is measure:
        return name
    try:
        return f"{name} {hashlib.sha256(pickle.dumps(measure, protocol=4)).hexdigest()}"
    except Exception:
        return name
