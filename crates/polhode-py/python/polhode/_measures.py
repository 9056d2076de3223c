"""What a sweep measures of a run."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Union

from ._errors import SweepError, UnknownName

if TYPE_CHECKING:
    from . import _polhode
    from ._run import Run

    #: What is measured: names of measures, or functions of a run by the names of their columns.
    Measures = Union[str, Sequence[str], Mapping[str, Union[str, Callable[[Run], float]]], None]

#: Columns that every table has.
OWN = ("run", "outcome", "error", "reason")
#: Quantities of a body and how many numbers they have.
_OF_BODY = {"position": 3, "orientation": 4, "velocity": 3, "angular_velocity": 3}
#: Quantities of a joint.
_OF_JOINT = {
    "angle": 0,
    "angle_rate": 0,
    "displacement": 0,
    "displacement_rate": 0,
    "distance": 0,
    "distance_rate": 0,
    "power": 0,
    "force": 3,
    "torque": 3,
}
_OF_ENERGY = {"kinetic": 0, "potential": 0, "total": 0}
#: Kinds of events.
_EVENTS = "impact contact_begin contact_end rest wake detach stick slide jam break".split()
_SHAPE = re.compile(r"(?:(?P<of>.+)\.)?(?P<quantity>\w+)(?:\[(?P<number>\d)\])?(?:@(?P<when>\w+))?\Z")
_WHEN = ("end", "start", "least", "most")
_CURE = (
    'measures are "BODY.position[2]@end", "JOINT.angle@most", "energy.kinetic@end", "events.impact", or '
    'a function of a run: measure={"height": top}'
)


class Named:
    """A measure that has a name."""

    def __init__(self, kind: str, of: str, quantity: str, number: int | None, when: str) -> None:
        self.kind = kind
        self.of = of
        self.quantity = quantity
        self.number = number
        self.when = when

    def __call__(self, run: Run) -> float:
        """Its value of a run."""
        if self.kind == "events":
            kinds = run.events["kind"]
            return float(len(kinds) if self.quantity == "events" else (kinds == self.quantity).sum())
        owner: Any = run.energy
        if self.kind != "energy":
            owner = run[self.of] if self.kind == "body" else run.joints[self.of]
        column = getattr(owner, self.quantity)
        values = column if self.number is None else column[:, self.number]
        if self.when in ("least", "most"):
            return float(values.min() if self.when == "least" else values.max())
        return float(values[0 if self.when == "start" else -1])


def read(measure: Measures, loaded: _polhode.Loaded) -> dict[str, Callable[[Run], float]]:
    """The measures by the names of their columns, of a scene that has been read."""
    if measure is None:
        return {}
    if isinstance(measure, str):
        measure = [measure]
    if not isinstance(measure, Mapping):
        measure = {name: name for name in measure}
    found: dict[str, Callable[[Run], float]] = {}
    for column, own in measure.items():
        if column in OWN:
            if own == column:
                continue
            raise SweepError(
                f"measure {column!r}: the table has a column of this name, {', '.join(OWN)} are its own", "rename it"
            )
        if isinstance(own, str):
            found[column] = _named(own, loaded)
        elif callable(own):
            found[column] = own
        else:
            raise SweepError(f"measure {column!r} is a {type(own).__name__}", _CURE)
    return found


def needs_loads(measures: Mapping[str, Callable[[Run], float]]) -> bool:
    """Whether the loads of joints may be asked for."""
    return not all(isinstance(own, Named) and own.kind != "joint" for own in measures.values())


def _named(text: str, loaded: _polhode.Loaded) -> Named:
    found = _SHAPE.match(text)
    if found is None:
        raise SweepError(f"measure {text!r} has no such form", _CURE)
    of, quantity, when = found["of"], found["quantity"], found["when"]
    number = None if found["number"] is None else int(found["number"])
    if text == "events" or of == "events" and number is None and when is None:
        if quantity not in ("events", *_EVENTS):
            raise UnknownName(quantity, "kind of event", _EVENTS)
        return Named("events", "events", quantity, None, "end")
    kind, quantities = _owner(of, loaded)
    if quantity not in quantities:
        raise UnknownName(quantity, f"quantity of a {kind}", list(quantities))
    size = quantities[quantity]
    if (number is None) != (size == 0) or number is not None and number >= size:
        limit = f"one of [0] to [{size - 1}] is needed" if size else "it is one number"
        raise SweepError(f"measure {text!r}: {limit}", _CURE)
    if when is not None and when not in _WHEN:
        raise UnknownName(when, "part of a run", list(_WHEN))
    return Named(kind, of, quantity, number, when or "end")


def _owner(of: str | None, loaded: _polhode.Loaded) -> tuple[str, dict[str, int]]:
    """Which kind of thing it is that bears a name, and its quantities."""
    bodies, joints = loaded.body_names, loaded.joint_names
    if of in bodies:
        return "body", _OF_BODY
    if of in joints:
        return "joint", _OF_JOINT
    if of == "energy":
        return "energy", _OF_ENERGY
    raise UnknownName(of or "", "body or joint", [*bodies, *joints, "energy", "events"])
