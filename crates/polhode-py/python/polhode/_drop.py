"""How a part lands: the faces on which a body comes to rest, how often, and how hard it is struck."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, overload

from . import _polhode
from ._progress import Bar
from ._scene import Scene, load
from ._shapes import HalfSpace, Mesh, Shape

if TYPE_CHECKING:
    from ._scene import SceneLike, Vector

#: Endings of mesh files.
_MESHES = (".obj", ".stl", ".off", ".ply")


class RestFace(NamedTuple):
    """A face of the convex hull of a body."""

    #: Its number, from 1: those on which the body rests first, the one that is hardest to leave before the others.
    face: int
    #: Throws that came to rest on it.
    throws: int
    #: Their share of all throws.
    share: float
    #: The standard error of the share.
    standard_error: float
    #: The least angle by which the plane may be tilted before the body tips, rad.
    tilt: float
    #: The least rise of the centre of mass on a way off the face, m.
    barrier: float
    #: Height of the centre of mass above it, m.
    height: float
    #: Outward unit normal, in the frame of the body.
    normal: tuple[float, float, float]


class RestPoses(Sequence[RestFace]):
    """The faces on which a body can rest or came to rest, those with the most throws first."""

    def __init__(self, report: dict[str, Any]) -> None:
        faces = sorted(report["faces"], key=lambda face: -face["throws"])
        self._faces = [_face(face) for face in faces]
        #: How many throws there were.
        self.throws: int = report["throws"]
        #: Throws that came to rest on no face alone: several surfaces hold them.
        self.leaning: int = report["leaning"]
        #: Throws that still moved when their time had run out.
        self.moving: int = report["moving"]
        #: Throws that failed; ``report["first_failure"]`` says why.
        self.failed: int = report["failed"]
        #: The largest impulse of each throw, N s: mean, standard error, largest; None where nothing was struck.
        self.impulse: dict[str, Any] | None = report["peak_impulse_n_s"]
        #: The greatest deceleration of each throw, m/s^2, likewise; None without a duration of the contact.
        self.deceleration: dict[str, Any] | None = report["peak_deceleration_m_s2"]
        #: Everything, as ``polhode drop --json`` prints it.
        self.report = report

    @overload
    def __getitem__(self, number: int) -> RestFace: ...
    @overload
    def __getitem__(self, number: slice) -> list[RestFace]: ...
    def __getitem__(self, number: int | slice) -> RestFace | list[RestFace]:
        return self._faces[number]

    def __iter__(self) -> Iterator[RestFace]:
        return iter(self._faces)

    def __len__(self) -> int:
        return len(self._faces)

    def __repr__(self) -> str:
        others = self.leaning + self.moving + self.failed
        body, faces = self.report["body"], len(self)
        return f"<polhode.RestPoses of {body!r}: {faces} faces, {self.throws} throws, {others} on none>"


def rest_poses(
    what: str | os.PathLike[str] | Shape | SceneLike,
    n: int = 1000,
    *,
    body: str | None = None,
    on: SceneLike | None = None,
    seed: int = 0,
    workers: int | None = None,
    height: float | None = None,
    at: Vector | None = None,
    longest: float | None = None,
    scale: float | None = None,
    density: float = 1000.0,
    friction: float = 0.5,
    restitution: float = 0.3,
    young: float | None = None,
    poisson: float = 0.3,
    corner_radius: float | None = None,
    tier: str | None = None,
    set: Mapping[str, Any] | None = None,
    progress: bool | None = None,
) -> RestPoses:
    """On which of its faces a body comes to rest, of ``n`` throws from random attitudes.

    ``what`` is a mesh file, a shape, or a scene, whose body ``body`` is thrown. A mesh or shape has a density (kg/m^3),
    friction and restitution, and falls on a plane or on a scene ``on``. It is let go at rest: above a plane its lowest
    point is at ``height`` (m; its own size when absent), elsewhere its centre of mass is ``at`` a place. With Young's
    modulus (Pa) and the radius of its corners (m) impacts have a duration, and the deceleration is told. The same
    ``seed`` gives the same throws, for any number of ``workers``. ``tier`` and ``set`` change the scene, as for
    :func:`polhode.run`.

    >>> import polhode as ph
    >>> poses = ph.rest_poses(ph.Box(0.03, 0.02, 0.01), 40, seed=1)
    >>> len(poses), sum(face.throws for face in poses)
    (6, 40)
    >>> poses[0].normal[2] in (1.0, -1.0)      # mostly on its broad faces
    True
    """
    shape = _shape(what, scale)
    changes = {"tier": tier, "set": set}
    onto = None
    if shape is None:
        if on is not None:
            raise ValueError("on: a scene's body falls on what its scene holds; give a mesh or a shape")
        loaded = load(what, changes)  # type: ignore[arg-type]
    else:
        own: dict[str, Any] = {"friction": friction, "restitution": restitution}
        scene = Scene(name="part")
        scene.fixed(HalfSpace(), name="floor", **own)
        if young is not None:
            own.update(youngs_modulus_pa=young, poisson_ratio=poisson)
        body = "part"
        scene.add(shape, name=body, density=density, **own)
        if on is None:
            loaded = load(scene, changes)
        else:
            loaded, onto = load(scene, {}), load(on, changes)
    place = None if at is None else [float(number) for number in at]
    with Bar("drop", "throws", progress) as bar:
        asked = (n, seed, height, longest, place, corner_radius)
        report = _polhode.rest_poses(loaded, body, onto, asked, workers, bar.told)
    return RestPoses(json.loads(report))


def _shape(what: Any, scale: float | None) -> Shape | None:
    if isinstance(what, (str, os.PathLike)) and os.fspath(what).lower().endswith(_MESHES):
        return Mesh(what, scale=scale)
    if scale is not None:
        raise ValueError("scale is for a mesh file: a shape is in metres, and a scene has its own")
    return what if isinstance(what, Shape) else None


def _face(face: dict[str, Any]) -> RestFace:
    x, y, z = face["normal"]
    return RestFace(
        face["face"],
        face["throws"],
        face["share"],
        face["standard_error"],
        face["tilt_rad"],
        face["barrier_m"],
        face["height_m"],
        (x, y, z),
    )
