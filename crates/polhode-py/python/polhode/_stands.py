"""Does it stand, and how firmly: the first question about a pile, a pallet or a wall."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from ._scene import Body, Scene
from ._shapes import Box, HalfSpace
from ._simulation import Simulation

if TYPE_CHECKING:
    from ._scene import SceneLike

#: Columns of a table of boxes that each box has: edge lengths and centre, m, and mass, kg.
_NUMBERS = ("size_x", "size_y", "size_z", "x", "y", "z", "mass")
#: Columns that may be absent: a name, the coefficient of friction (no unit), and the rotation about z, degrees.
_OPTIONAL = ("name", "friction", "yaw")


class Standing(NamedTuple):
    """Whether a scene stands, and by which margin. It counts as true where it stands."""

    #: Whether every body is at rest and stays so.
    stands: bool
    #: The part of all friction that is needed: 0.45 leaves a reserve of 55 %; None where no friction is enough.
    friction_needed: float | None
    #: The least push of every body across gravity, in parts of its weight, at which one begins to move; infinite where
    #: none does.
    push: float
    #: The least tilt at which a body begins to move, rad; NaN where other forces act besides gravity.
    tilt: float
    #: The bodies that move first, the fastest first: now where it does not stand, else at that push.
    first: tuple[str, ...]
    #: How the first of them moves: "tips", "slides" or "moves"; empty where nothing does.
    how: str
    #: All margins, as :meth:`polhode.Simulation.stability` has them.
    report: dict[str, Any]

    def __bool__(self) -> bool:
        return self.stands


def stands(scene: SceneLike) -> Standing:
    """Whether a scene stands as it is given, by which margin of friction, push and tilt, and what moves first.

    Margins are those of statics, in directions across gravity. Bodies that are steered or have a velocity do not stand.

    >>> import polhode as ph
    >>> scene = ph.Scene()
    >>> floor = scene.fixed(ph.HalfSpace(), friction=0.5)
    >>> column = scene.add(ph.Box(1, 1, 4), name="column", mass=2.0, at=(0, 0, 2), friction=0.5)
    >>> answer = ph.stands(scene)
    >>> bool(answer), round(answer.push, 9), answer.first, answer.how
    (True, 0.25, ('column',), 'tips')
    """
    simulation = Simulation(scene, error="off")
    report = simulation.stability()
    # Events at the start are steps of no length.
    while simulation.step().t <= 0.0:
        pass
    moving = {name: _speed(state) for name, state in simulation.bodies().items()}
    now = tuple(sorted((name for name, speed in moving.items() if speed > 0.0), key=lambda name: -moving[name]))
    needed = report["friction_needed"]
    if now or needed is None or needed > 1.0:
        begins = [one["body"] for one in report["begins"]]
        first = now or tuple(begins)
        hows = {one["body"]: one["how"] for one in report["begins"]}
        return Standing(False, needed, 0.0, 0.0, first, hows.get(first[0], "moves") if first else "", report)
    margins = [(math.inf if push["of_weight"] == "any" else push["of_weight"], push) for push in report["pushes"]]
    push, weakest = min(margins, key=lambda margin: margin[0], default=(math.inf, None))
    tilt = math.nan if weakest is None or weakest["tilt_rad"] is None else weakest["tilt_rad"]
    begins = [] if weakest is None else weakest["begins"]
    return Standing(
        True, needed, push, tilt, tuple(one["body"] for one in begins), begins[0]["how"] if begins else "", report
    )


def boxes(table: Any, *, friction: float = 0.5, gravity: float = 9.81) -> Scene:
    """A scene of boxes on a floor at z = 0, from a table: a pallet, a wall, a pile.

    ``table`` is the path of a CSV file, a pandas DataFrame, a dictionary of columns, or a list of dictionaries.
    Columns: ``size_x``, ``size_y``, ``size_z`` and the centre ``x``, ``y``, ``z`` in m, ``mass`` in kg; and, if wanted,
    ``name``, ``friction`` (no unit) and ``yaw`` (degrees about z). ``friction`` is that of the floor and of boxes
    without their own.

    >>> import polhode as ph
    >>> one = {"size_x": 0.4, "size_y": 0.3, "size_z": 0.2, "x": 0, "y": 0, "mass": 5}
    >>> scene = ph.boxes([{**one, "name": "low", "z": 0.1}, {**one, "name": "high", "z": 0.3, "x": 0.25}])
    >>> answer = ph.stands(scene)
    >>> bool(answer), answer.first[0]
    (False, 'high')
    """
    scene = Scene(gravity=gravity)
    scene.fixed(HalfSpace(), name="floor", friction=friction)
    for row, box in enumerate(_rows(table), 1):
        _add(scene, row, box, friction)
    return scene


def _add(scene: Scene, row: int, box: Mapping[str, Any], friction: float) -> Body:
    unknown = sorted(set(box) - {*_NUMBERS, *_OPTIONAL})
    missing = [column for column in _NUMBERS if column not in box]
    if unknown or missing:
        what = f"unknown column {unknown[0]!r}" if unknown else f"column {missing[0]!r} is missing"
        raise ValueError(f"row {row}: {what}; accepted: {', '.join((*_NUMBERS, *_OPTIONAL))}")
    size_x, size_y, size_z, x, y, z, mass = (_number(row, column, box[column]) for column in _NUMBERS)
    keys: dict[str, Any] = {"friction": _number(row, "friction", _given(box, "friction", friction))}
    yaw = math.radians(_number(row, "yaw", _given(box, "yaw", 0.0)))
    if yaw != 0.0:
        keys["rotation_vector"] = (0.0, 0.0, yaw)
    name = _given(box, "name", None)
    return scene.add(
        Box(size_x, size_y, size_z), name=None if name is None else str(name), mass=mass, at=(x, y, z), **keys
    )


def _given(box: Mapping[str, Any], column: str, otherwise: Any) -> Any:
    value = box.get(column)
    absent = value is None or value == "" or (isinstance(value, float) and math.isnan(value))
    return otherwise if absent else value


def _number(row: int, column: str, value: Any) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = math.nan
    if not math.isfinite(number):
        raise ValueError(f"row {row}, column {column!r}: {value!r} is not a finite number")
    return number


def _rows(table: Any) -> Iterable[Mapping[str, Any]]:
    if isinstance(table, (str, os.PathLike)):
        import csv

        with open(table, newline="", encoding="utf-8") as file:
            rows: list[Mapping[str, Any]] = list(csv.DictReader(file))
        return rows
    if hasattr(table, "to_dict") and hasattr(table, "columns"):
        records: list[Mapping[str, Any]] = table.to_dict("records")
        return records
    if isinstance(table, Mapping):
        lengths = {column: len(values) for column, values in table.items()}
        if len(set(lengths.values())) > 1:
            raise ValueError(f"columns of different lengths: {lengths}")
        return [dict(zip(table, values)) for values in zip(*table.values())]
    return list(table)


def _speed(state: Any) -> float:
    return math.hypot(*state.velocity) + math.hypot(*state.angular_velocity)
