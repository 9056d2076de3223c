"""Shapes of bodies, in the body's own frame; lengths in m."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from . import _polhode

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    from numpy.typing import NDArray

    from ._scene import Vector


class Shape:
    """A shape, as a scene file has it.

    >>> import polhode as ph
    >>> ph.Box(1, 0.5, 0.25).document
    {'box': {'size': [1, 0.5, 0.25]}}
    """

    #: Word of the shape in names of bodies.
    word: str
    #: The shape in the keys of a scene file.
    document: dict[str, Any]

    def __init__(self, kind: str, **keys: Any) -> None:
        self.word = kind
        self.document = {kind: keys}

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.document!r})"


class Box(Shape):
    """A box about the origin: full edges along x, y, z, m."""

    def __init__(self, x: float, y: float, z: float) -> None:
        super().__init__("box", size=[x, y, z])


class Sphere(Shape):
    """A ball about the origin."""

    def __init__(self, radius: float) -> None:
        super().__init__("sphere", radius=radius)


class HalfSpace(Shape):
    """Everything below a plane through the origin; of fixed and kinematic bodies."""

    def __init__(self, normal: Vector = (0, 0, 1)) -> None:
        super().__init__("half_space", normal=normal)


class Cylinder(Shape):
    """A cylinder about the z axis, its centre at the origin."""

    def __init__(self, radius: float, height: float) -> None:
        super().__init__("cylinder", radius=radius, height=height)


class Cone(Shape):
    """A cone about the z axis, its apex towards +z, its origin a quarter of its height above the base."""

    def __init__(self, radius: float, height: float) -> None:
        super().__init__("cone", radius=radius, height=height)


class Capsule(Shape):
    """A capsule about the z axis, its centre at the origin; its height is without the caps."""

    def __init__(self, radius: float, height: float) -> None:
        super().__init__("capsule", radius=radius, height=height)


class Torus(Shape):
    """A ring about the z axis: radius of the circle in the middle of the tube, and of the tube."""

    def __init__(self, major: float, minor: float) -> None:
        super().__init__("torus", major=major, minor=minor)


class Prism(Shape):
    """What lies over a polygon of corners (x, y), half of its height on either side of the xy plane."""

    def __init__(self, polygon: Sequence[Sequence[float]], height: float) -> None:
        super().__init__("prism", polygon=polygon, height=height)


class Wedge(Shape):
    """A stone of an arch: between two circles about the z axis and two planes through it, its middle towards +x.

    Radii of its corners and width along z in m, the angle between its end faces in rad; its origin is on the axis.
    """

    def __init__(self, inner_radius: float, outer_radius: float, angle: float, width: float) -> None:
        super().__init__("wedge", inner_radius=inner_radius, outer_radius=outer_radius, angle=angle, width=width)


class Points(Shape):
    """Points that touch by themselves: corners without faces. Mass and inertia must be given."""

    def __init__(self, positions: Sequence[Vector]) -> None:
        super().__init__("points", positions=positions)


class Convex(Shape):
    """A convex solid from a mesh file (OBJ, STL, OFF, PLY)."""

    def __init__(self, file: str | os.PathLike[str], **keys: Any) -> None:
        super().__init__("convex", file=os.fspath(file), **keys)


class Mesh(Shape):
    """A closed solid of any form from a mesh file (OBJ, STL, OFF, PLY); of a fixed body a surface too.

    ``scale`` is what the coordinates of the file are multiplied by to give m. :meth:`load` reads the file at once.

    >>> import polhode as ph
    >>> import pathlib, tempfile
    >>> file = pathlib.Path(tempfile.mkdtemp(), "part.obj")
    >>> size = file.write_text("v 0 0 0\\nv 30 0 0\\nv 0 30 0\\nv 0 0 30\\nf 1 3 2\\nf 1 2 4\\nf 1 4 3\\nf 2 3 4\\n")
    >>> part = ph.Mesh.load(file, scale=0.001)
    >>> part.vertices.shape, part.triangles.tolist()[0]     # m
    ((4, 3), [0, 2, 1])
    >>> round(part.mass_properties(density=2000.0)["mass_kg"], 12)
    0.009
    >>> ph.Scene().add(part, mass=0.009)
    Body('mesh')
    """

    _arrays: tuple[NDArray[np.float64], NDArray[np.int64]] | None = None

    def __init__(self, file: str | os.PathLike[str], *, scale: float | None = None, **keys: Any) -> None:
        scaled = {} if scale is None else {"scale": scale}
        super().__init__("mesh", file=os.fspath(file), **scaled, **keys)

    @classmethod
    def load(cls, file: str | os.PathLike[str], *, scale: float | None = None, **keys: Any) -> Mesh:
        """The mesh of a file, which is read at once: ``OSError`` where it cannot be, ``ValueError`` where it is no
        mesh."""
        mesh = cls(file, scale=scale, **keys)
        mesh._read()
        return mesh

    @property
    def vertices(self) -> NDArray[np.float64]:
        """Its vertices, m: (V, 3)."""
        return self._read()[0]

    @property
    def triangles(self) -> NDArray[np.int64]:
        """The numbers of the vertices of each triangle, anticlockwise seen from outside: (T, 3)."""
        return self._read()[1]

    def mass_properties(
        self, *, mass: float | None = None, density: float | None = None, hollow: bool = False
    ) -> dict[str, Any]:
        """As :func:`polhode.mass_properties` of it."""
        from ._functions import mass_properties

        return mass_properties(self.vertices, self.triangles, mass=mass, density=density, hollow=hollow)

    def _read(self) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
        if self._arrays is None:
            keys = self.document["mesh"]
            vertices, triangles = _polhode.mesh_of_file(keys["file"])
            vertices *= keys.get("scale", 1.0)
            for array in (vertices, triangles):
                array.flags.writeable = False
            self._arrays = vertices, triangles
        return self._arrays


class Compound(Shape):
    """Parts that are fixed to each other: shapes, or pairs of a shape and its position, m."""

    def __init__(self, *parts: Shape | tuple[Shape, Vector]) -> None:
        one = [part if isinstance(part, tuple) else (part, (0, 0, 0)) for part in parts]
        super().__init__("compound", parts=[{"shape": shape.document, "position": at} for shape, at in one])
