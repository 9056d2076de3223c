"""Does it stand, and how firmly: the first question about a pile, a pallet or a wall."""

from __future__ import annotations

import io
import json
import math
import os
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from . import _polhode, _toml
from ._scene import Scene, load

if TYPE_CHECKING:
    from ._scene import SceneLike

#: Columns of a table of boxes in which a value may be absent: a name, the coefficient of friction (no unit), and the
#: rotation about z, degrees.
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
    answer = json.loads(_polhode.stands(load(scene, {})))
    report: dict[str, Any] = answer["stability"]
    first, how, needed = tuple(answer["first"]), answer["how"] or "", report["friction_needed"]
    if not answer["stands"]:
        return Standing(False, needed, 0.0, 0.0, first, how, report)
    margins = [(math.inf if push["of_weight"] == "any" else push["of_weight"], push) for push in report["pushes"]]
    push, weakest = min(margins, key=lambda margin: margin[0], default=(math.inf, None))
    tilt = math.nan if weakest is None or weakest["tilt_rad"] is None else weakest["tilt_rad"]
    return Standing(True, needed, push, tilt, first, how, report)


class StandingLimit(NamedTuple):
    """Up to which value of a key a scene stands."""

    #: The key.
    key: str
    #: The limit: the middle of both values below, or the last whole number with which it stands.
    limit: float
    #: The value nearest to the limit with which it stands.
    stands: float
    #: The value nearest to it with which it does not.
    falls: float
    #: How many scenes were asked.
    asked: int


def standing_limit(scene: SceneLike, key: str, low: float, high: float, *, digits: int = 6) -> StandingLimit:
    """Up to which value of a key a scene stands, between one with which it does and one with which it does not.

    The interval is halved until both ends agree to so many ``digits``. Where the scene stands again farther on, one of
    its limits is found. Of a key of whole numbers, such as a count, it is the last one with which it stands.

    >>> import polhode as ph
    >>> scene = ph.Scene()
    >>> floor = scene.fixed(ph.HalfSpace(), friction=0.5)
    >>> low = scene.add(ph.Box(1, 1, 1), name="low", mass=1.0, at=(0, 0, 0.5), friction=0.5)
    >>> high = scene.add(ph.Box(1, 1, 1), name="high", mass=1.0, at=(0, 0, 1.5), friction=0.5)
    >>> round(ph.standing_limit(scene, "bodies.high.position[0]", 0, 1).limit, 5)
    0.5
    """
    interval = f"{_toml.path(key)}={low!r}..{high!r}"
    found = json.loads(_polhode.standing_limit(load(scene, {}), interval, digits))
    return StandingLimit(key, found["limit"], found["stands_at"], found["falls_at"], found["asked"])


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
    document = json.loads(_polhode.boxes(*_text(table)))
    document["materials"]["boxes"]["friction"] = friction
    scene = Scene(gravity=gravity)
    scene.document.update({key: document[key] for key in ("materials", "bodies")})
    return scene


def _text(table: Any) -> tuple[str, str | None]:
    """A table as CSV, and the file that it is from."""
    import csv

    if isinstance(table, (str, os.PathLike)):
        with open(table, newline="", encoding="utf-8") as file:
            return file.read(), os.fspath(table)
    rows = list(_rows(table))
    columns = list(dict.fromkeys(column for row in rows for column in row))
    text = io.StringIO()
    lines = csv.writer(text)
    lines.writerow(columns)
    lines.writerows([_field(column, row.get(column)) for column in columns] for row in rows)
    return text.getvalue(), None


def _field(column: str, value: Any) -> Any:
    """A field of a table: what is absent is empty, as is NaN in a column that may be."""
    is_nan = isinstance(value, float) and math.isnan(value)
    return "" if value is None or (is_nan and column in _OPTIONAL) else value


def _rows(table: Any) -> Iterable[Mapping[str, Any]]:
    if hasattr(table, "to_dict") and hasattr(table, "columns"):
        records: list[Mapping[str, Any]] = table.to_dict("records")
        return records
    if isinstance(table, Mapping):
        lengths = {column: len(values) for column, values in table.items()}
        if len(set(lengths.values())) > 1:
            raise ValueError(f"columns of different lengths: {lengths}")
        return [dict(zip(table, values)) for values in zip(*table.values())]
    return list(table)
