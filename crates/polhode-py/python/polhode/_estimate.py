"""The estimated error of a run: how far it may be from the exact motion of the scene as written."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

#: Numbers of the error of a body in a sample.
OF_ERROR = 2


class RunError(float):
    """The estimated error of a run; as a number the largest one, relative to the size of its body.

    >>> import polhode as ph
    >>> ball = {"name": "ball", "shape": {"sphere": {"radius": 0.1}}, "mass": 1.0, "velocity": [1, 0, 0]}
    >>> run = ph.run({"format": 1, "duration": 1.0, "bodies": [ball]})
    >>> run.error < 1e-12, run.error.estimation, run.error.body
    (True, 'quick', 'ball')
    >>> run["ball"].error.position_m.shape
    (101,)
    """

    _told: dict[str, Any]

    def __new__(cls, number: float, told: dict[str, Any]) -> RunError:
        made = super().__new__(cls, number)
        made._told = told
        return made

    def __reduce__(self) -> tuple[Any, ...]:
        return RunError, (float(self), self._told)

    def _largest(self, key: str) -> Any:
        return (self._told["largest"] or {}).get(key)

    @property
    def estimation(self) -> str:
        """How it was estimated: off, quick or full."""
        return str(self._told["estimation"])

    @property
    def relative(self) -> float | None:
        """The largest error of any body before the horizon, relative to its size; none where it was not estimated."""
        relative: float | None = self._largest("relative")
        return relative

    @property
    def body(self) -> str | None:
        """The body that has it."""
        body: str | None = self._largest("body")
        return body

    @property
    def t(self) -> float | None:
        """When, s."""
        t: float | None = self._largest("t_s")
        return t

    @property
    def m(self) -> float | None:
        """The same of its position, m."""
        m: float | None = self._largest("position_m")
        return m

    @property
    def rad(self) -> float | None:
        """The same of its attitude, rad."""
        rad: float | None = self._largest("rotation_rad")
        return rad

    @property
    def horizon(self) -> float | None:
        """When a difference of rounding at the start has grown to a hundredth of a body, s: what lies after it is one
        of many outcomes. None where it has not."""
        horizon: float | None = self._told["horizon_s"]
        return horizon

    @property
    def references(self) -> list[dict[str, Any]]:
        """The runs beside it with which it was compared: kind, method, for how long (s), at which cost."""
        return list(self._told["references"])

    def __repr__(self) -> str:
        return f"<polhode.RunError {float(self):.2g}: {self.body}, {self.m} m and {self.rad} rad at t = {self.t} s>"


def of_report(report: dict[str, Any], number: float | None = None) -> RunError | None:
    """The error that a report tells, as a number this one, or its own where none is given; none where neither is
    known."""
    told = report.get("error")
    if told is None:
        return None
    if number is None and told["largest"] is not None:
        number = float(told["largest"]["relative"])
    return None if number is None else RunError(number, told)


class TrackError:
    """The estimated errors of a body over the samples of a run; NaN where one is not known, as at the end of a run that
    was interrupted. Arrays are views that cannot be written to."""

    __slots__ = ("_errors",)

    def __init__(self, errors: Array) -> None:
        self._errors = errors

    @property
    def position_m(self) -> Array:
        """Of the position of its own origin, m: (N,)."""
        return self._errors[:, 0]

    @property
    def rotation_rad(self) -> Array:
        """Of its attitude, rad: (N,)."""
        return self._errors[:, 1]
