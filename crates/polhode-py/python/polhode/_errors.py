"""What can go wrong, as exceptions that say where and what mends it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ._run import Run
    from ._table import Table


class Place(NamedTuple):
    """A place in a scene: file or argument, line and column (from 1), and the dotted key."""

    origin: str
    line: int
    column: int
    key: str


class PolhodeError(Exception):
    """What the library refuses or cannot do."""


class SceneError(PolhodeError, ValueError):
    """A scene is refused. ``place`` is where (of the first error), ``cure`` what is accepted instead."""

    place: Place | None
    cure: str | None
    #: Each thing that is refused, with its ``place``, ``message`` and ``cure``.
    errors: list[dict[str, Any]]

    def __init__(
        self,
        message: str,
        place: tuple[str, int, int, str] | None = None,
        cure: str | None = None,
        errors: Sequence[dict[str, Any]] = (),
    ) -> None:
        super().__init__(message)
        self.place = None if place is None else Place(*place)
        self.cure = cure
        self.errors = [{**error, "place": Place(*error["place"])} for error in errors]


class SimulationError(PolhodeError, RuntimeError):
    """A simulation cannot be made or cannot go on; ``run`` has what was computed.

    ``time`` is when (s), ``bodies`` are the bodies that it happened to, ``place`` says both in words, ``cure`` what
    would help.
    """

    run: Run | None = None

    def __init__(
        self,
        message: str,
        *,
        time: float | None = None,
        bodies: Sequence[str] = (),
        cure: str | None = None,
    ) -> None:
        super().__init__(message)
        self.time = time
        self.bodies = tuple(bodies)
        self.cure = cure

    @property
    def place(self) -> str | None:
        """When, and to which bodies; none where it has no time."""
        at = [] if self.time is None else [f"t = {self.time} s"]
        return ", ".join(at + [" and ".join(self.bodies)] if self.bodies else at) or None


class ViewError(PolhodeError, ValueError):
    """A run cannot be shown."""


class ActionError(PolhodeError, ValueError):
    """An action on a simulation is refused; the simulation is as it was."""


class SnapshotError(PolhodeError, ValueError):
    """Bytes are no snapshot, or a snapshot does not belong to the simulation."""


class Busy(PolhodeError, RuntimeError):
    """A simulation is used from two threads at once."""


class UnknownName(PolhodeError, KeyError):
    """Nothing bears this name; ``known`` are the names that are borne."""

    def __init__(self, name: str, kind: str = "thing", known: Sequence[str] = ()) -> None:
        super().__init__(name)
        self.name = name
        self.kind = kind
        self.known = list(known)

    def __str__(self) -> str:
        import difflib

        near = difflib.get_close_matches(self.name, self.known, n=1)
        meant = f"did you mean {near[0]!r}? " if near else ""
        shown = ", ".join(self.known[:20]) + (" ..." if len(self.known) > 20 else "")
        return f"no {self.kind} is named {self.name!r}: {meant}there are: {shown or 'none'}"


class NotReached(PolhodeError):
    """No method reaches the accuracy ``asked``; the message says how accurate the most accurate one is."""

    cure = "ask for less, or let ph.cost vary steps and tolerances"

    def __init__(self, message: str, asked: float = 0.0) -> None:
        super().__init__(f"{message}: {self.cure}")
        self.asked = asked


class NotKept(PolhodeError):
    """A run has not kept what its method promises.

    ``place`` says when and which bodies, ``value`` and ``limit`` by how much, ``cure`` what would help. ``broken``
    has all limits that were exceeded.
    """

    def __init__(
        self,
        message: str,
        *,
        place: str | None = None,
        value: float | None = None,
        limit: float | None = None,
        cure: str | None = None,
        broken: Sequence[dict[str, Any]] = (),
    ) -> None:
        super().__init__(message)
        self.place = place
        self.value = value
        self.limit = limit
        self.cure = cure
        self.broken = list(broken)


class Interrupted(KeyboardInterrupt):
    """Ctrl-C has ended a run or a sweep; ``run`` or ``table`` has what was computed."""

    run: Run | None = None
    table: Table | None = None


class SweepError(PolhodeError, ValueError):
    """A sweep is refused before anything is computed: the message has value and limit, ``cure`` what is accepted."""

    def __init__(self, message: str, cure: str) -> None:
        super().__init__(f"{message}: {cure}")
        self.cure = cure


class SweepStopped(PolhodeError, RuntimeError):
    """A sweep cannot go on; ``table`` has the runs that were finished."""

    table: Table | None = None
