"""Parts of the library as functions of arrays."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from . import _polhode

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from ._scene import Vector


def rotate_free(
    moments: Vector, angular_velocity: Vector, times: ArrayLike, orientation: Vector | None = None
) -> NDArray[np.float64]:
    """Attitudes of a body that turns freely, exactly, at any times (s): (N, 4), quaternions w x y z, body to world.

    ``moments`` are those about the axes of the body through its centre of mass, kg m^2; ``angular_velocity`` is in the
    world, rad/s; ``orientation`` is that at t = 0.

    >>> import polhode as ph
    >>> attitudes = ph.rotate_free([1, 2, 3], [0, 0, 2.0], [0.0, 0.5, 1e6])
    >>> attitudes.shape
    (3, 4)
    >>> float(attitudes[1, 3])      # sin(w t / 2)
    0.479425538604203
    """
    return _polhode.rotate_free(moments, angular_velocity, times, orientation)


def mass_properties(
    vertices: ArrayLike,
    triangles: ArrayLike,
    *,
    mass: float | None = None,
    density: float | None = None,
    hollow: bool = False,
) -> dict[str, Any]:
    """Mass properties of a mesh: ``vertices`` (V, 3) in m, ``triangles`` (T, 3), anticlockwise seen from outside.

    Of a ``mass`` (kg) or a ``density`` (kg/m^3, of a hollow body kg/m^2). The keys are those of ``polhode mesh
    --json``: ``volume_m3``, ``center_of_mass_m``, ``inertia_kg_m2`` (3x3 about the centre of mass),
    ``principal_moments_kg_m2``, ``defects`` ...

    >>> import polhode as ph
    >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    >>> sides = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    >>> properties = ph.mass_properties(corners, sides, mass=6.0)
    >>> properties["center_of_mass_m"], round(properties["volume_m3"], 12)
    ([0.25, 0.25, 0.25], 0.166666666667)
    """
    import json

    import numpy as np

    numbers = np.asarray(triangles)
    if not np.issubdtype(numbers.dtype, np.integer):
        raise TypeError(f"triangles: whole numbers are needed, found {numbers.dtype}")
    report: dict[str, Any] = json.loads(
        _polhode.mesh_report(vertices, numbers.astype(np.int64), mass, density, hollow)
    )
    return report


def doctor(robot: str | os.PathLike[str]) -> list[_polhode.Finding]:
    """What is impossible in the file of a robot (URDF, MJCF), simulated otherwise than it says, or without effect.

    Each finding has its place (``file``, ``line``, ``column``), ``severity`` (error, warning, ignored, read),
    ``subject``, ``what`` with its size, and ``cure``: the edit that mends it. A file that is refused raises nothing:
    its errors are findings.
    """
    return _polhode.doctor(robot)
