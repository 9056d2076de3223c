"""Contacts as functions of arrays: forces of friction, and impacts.

``W = J M^-1 J^T`` is the Delassus matrix of the contacts (1/kg): what a unit impulse along one row does to the
velocities along all rows. A contact has its normal row first, then its tangents: two in space, one in a plane.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from . import _polhode
from ._arrays import floats, floats_of_each

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

#: Rows of a contact in space.
_IN_SPACE = 3
#: Rows of a contact in a plane.
_IN_PLANE = 2


class FrictionSolution(NamedTuple):
    """Impulses (or forces) of contacts with friction that satisfy Coulomb's law."""

    #: Normal, then tangential ones of each contact: (N, 3), in a plane (N, 2); N s.
    impulses: NDArray[np.float64]
    #: Velocities with them, in the same order; m/s.
    velocities: NDArray[np.float64]
    #: What each contact does: open, stick or slide.
    contacts: list[str]
    #: solved; inaccurate: ``residual`` is larger than 1e-12 or rounding; infeasible: no impulses keep the bodies apart.
    status: str
    #: By how much they miss Coulomb's law, relative to the largest velocity without them.
    residual: float
    #: The method that gave the answer.
    method: str
    #: Iterations of all methods.
    iterations: int
    #: Where it is infeasible: normal impulses of the contacts that squeeze bodies between them.
    squeeze: NDArray[np.float64] | None

    @property
    def is_solved(self) -> bool:
        """Whether the impulses are a solution."""
        return self.status == "solved"


class Impact(NamedTuple):
    """What an impact did."""

    #: Impulse along each row, N s: (N,), with friction (N, 3) or (N, 2).
    impulses: NDArray[np.float64]
    #: Velocity of each row afterwards, m/s.
    velocities: NDArray[np.float64]
    #: Change of kinetic energy, J.
    energy_change: float
    #: no-approach, separated; restitution-lowered, stopped-at-threshold, limit-reached, struck-in-order: warnings;
    #: not-solved.
    status: str
    #: The largest residual of the problems that were solved for it.
    residual: float


def solve_friction(
    W: ArrayLike, q: ArrayLike, mu: ArrayLike, *, start: ArrayLike | None = None
) -> FrictionSolution:
    """Impulses of contacts with Coulomb's friction, exactly: cones, no pyramids.

    ``W`` is the Delassus matrix, (3N, 3N) in 1/kg, symmetric and positive semidefinite of any rank; ``q`` are the
    velocities without impulses, (3N,) or (N, 3) in m/s; ``mu`` the coefficients of friction, (N,) or one for all. The
    normal row of each contact comes first, then its tangents; the normal velocity is negative while bodies approach.
    Contacts in a plane have two rows, and an array ``mu``. Accelerations in the place of velocities give forces.
    ``start`` are impulses of a similar problem.

    Where the impulses are not unique, those that all contacts share alike are given, up to 40 contacts.

    >>> import numpy as np
    >>> import polhode as ph
    >>> solution = ph.solve_friction(0.5 * np.eye(3), [-3.0, 4.0, 0.0], 0.5)    # 2 kg, down at 3 m/s, along at 4 m/s
    >>> solution.impulses[0, :2].tolist(), solution.velocities[0, :2].tolist()   # N s, m/s: it slides on
    ([6.0, -3.0], [0.0, 2.5])
    >>> solution.contacts, solution.status, solution.residual, solution.method
    (['slide'], 'solved', 0.0, 'gauss-seidel')
    """
    matrix, free, friction = _with_friction(W, q, mu, "q")
    begin = None if start is None else _rows("start", start, len(free), len(friction))
    return FrictionSolution(**_polhode.solve_friction(matrix, free, friction, begin))


def impact(
    W: ArrayLike,
    v: ArrayLike,
    e: ArrayLike,
    *,
    mu: ArrayLike | None = None,
    law: str = "reflection",
    restitution_law: str | None = None,
    tangential_restitution: float | None = None,
    pulse_exponent: str | None = None,
) -> Impact:
    """The impulses of an impact at one or several contacts.

    Without friction ``W`` is (N, N) in 1/kg and ``v`` (N,), the normal velocities before in m/s, negative while bodies
    approach; ``e`` are the coefficients of restitution, (N,) or one for all. ``law`` is a name of ``method.impact`` in
    a scene file: reflection, propagation, simultaneous (Newton and Moreau), poisson, energetic (Stronge), pulse
    (springs with ``pulse_exponent`` linear or hertz). At one contact all laws agree.

    With coefficients of friction ``mu`` the arrays are those of :func:`solve_friction`. A contact that is struck alone
    follows ``restitution_law``: stronge, poisson, newton, whittaker or chatterjee-ruina (with
    ``tangential_restitution``). Several contacts share the impact by ``law``: propagation strikes one after the other,
    pulse as springs, all others strike them together.

    >>> import polhode as ph
    >>> ball = ph.impact([[0.5]], [-3.0], 0.5)          # 2 kg at 3 m/s against a wall
    >>> ball.impulses.tolist(), ball.velocities.tolist(), ball.energy_change
    ([9.0], [1.5], -6.75)
    >>> cradle = [[2.0, -1.0], [-1.0, 2.0]]             # three balls of 1 kg in a row
    >>> ph.impact(cradle, [-1.0, 0.0], 1.0).velocities.tolist()      # the last one leaves
    [0.0, 1.0]
    """
    laws = {
        "law": law,
        "restitution_law": restitution_law,
        "tangential_restitution": tangential_restitution,
        "pulse_exponent": pulse_exponent,
    }
    if mu is not None:
        matrix, before, friction = _with_friction(W, v, mu, "v")
        restitution = floats_of_each("e", e, len(friction))
        return Impact(**_polhode.impact_with_friction(matrix, before, restitution, friction, laws))
    if restitution_law is not None or tangential_restitution is not None:
        raise ValueError("restitution_law, tangential_restitution: of contacts with friction; give mu, or none of both")
    before = floats("v", v, "(N,)", 1)
    matrix = _square(W, len(before))
    return Impact(**_polhode.impact_without_friction(matrix, before, floats_of_each("e", e, len(before)), laws))


def _with_friction(
    W: ArrayLike, velocities: ArrayLike, mu: ArrayLike, what: str
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Matrix, velocities of all rows and coefficients of friction."""
    import numpy as np

    rows = floats(what, velocities, "(3N,) or (N, 3)", max(1, min(np.ndim(velocities), 2)))
    if rows.ndim > 1 and rows.shape[1] not in (_IN_PLANE, _IN_SPACE):
        raise ValueError(f"{what}: an array of shape (3N,) or (N, 3), in a plane (N, 2), is needed, found {rows.shape}")
    each = rows.shape[1] if rows.ndim > 1 else _IN_SPACE
    if np.ndim(mu) == 0:
        count = rows.size // each
    else:
        count = np.size(mu)
        each = rows.size // count if count else each
    if each not in (_IN_PLANE, _IN_SPACE) or rows.size != each * count or rows.ndim > 1 and len(rows) != count:
        raise ValueError(
            f"{what}: three numbers for each of {count} contacts are needed, in a plane two, found {rows.size}: "
            "normal, then tangents"
        )
    return _square(W, rows.size), rows.reshape(-1), floats_of_each("mu", mu, count)


def _rows(what: str, given: ArrayLike, size: int, count: int) -> NDArray[np.float64]:
    """Numbers of all rows of so many contacts, in a line."""
    import numpy as np

    found = floats(what, given, f"({size},) or ({count}, {size // max(count, 1)})", max(1, min(np.ndim(given), 2)))
    if found.size != size or found.ndim > 1 and len(found) != count:
        raise ValueError(f"{what}: {size} numbers are needed, found an array of shape {found.shape}")
    return found.reshape(-1)


def _square(W: ArrayLike, size: int) -> NDArray[np.float64]:
    """A Delassus matrix of so many rows."""
    matrix = floats("W", W, f"({size}, {size})", 2)
    if matrix.shape != (size, size):
        needed = f"an array of shape ({size}, {size}) is needed, one row for each velocity"
        raise ValueError(f"W: {needed}, found {matrix.shape}")
    return matrix
