"""Trajectories of any engine: judged by the laws of a scene, and compared with each other."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any, NamedTuple

from . import _polhode
from ._scene import load

if TYPE_CHECKING:
    from ._scene import SceneLike


class Judgement(NamedTuple):
    """Which laws a trajectory breaks. It counts as true where it breaks none."""

    #: Whether all laws are kept.
    kept: bool
    #: The laws that are broken, in the order in which they are first.
    broken: tuple[str, ...]
    #: Energy that was gained (below zero: lost) and that nothing in the scene explains, J.
    energy: float
    #: What is found of each law, by its name: worst value, limit, when, which bodies, and the value over time.
    laws: dict[str, dict[str, Any]]
    #: All of it, as ``polhode judge --json`` has it.
    report: dict[str, Any]

    def __bool__(self) -> bool:
        return self.kept


class Comparison(NamedTuple):
    """How far two trajectories are apart. It counts as true where they agree within the tolerance."""

    #: Whether they agree.
    agrees: bool
    #: Rows that were compared.
    rows: int
    #: The largest difference of every column.
    largest: dict[str, float]
    #: All of it: where the largest differences are, and where the files are not about the same samples.
    report: dict[str, Any]

    def __bool__(self) -> bool:
        return self.agrees


def judge(
    trajectory: str | os.PathLike[str], scene: SceneLike, *, tolerance: float = 1e-9, truth: bool = True
) -> Judgement:
    """Judge a trajectory (.csv, .npy, .json) of any engine by the laws of a scene.

    ``tolerance`` is what counts as nothing, of sizes, speeds and energies. ``truth`` runs the scene by tier accurate
    and tells the distance from it.
    """
    report = json.loads(_polhode.judge(os.fspath(trajectory), load(scene, {}), float(tolerance), truth))
    laws = {own["law"]: own for own in report["laws"]}
    return Judgement(report["kept"], tuple(report["broken"]), report["energy"]["unexplained_j"], laws, report)


def compare(
    a: str | os.PathLike[str], b: str | os.PathLike[str], *, atol: float = 0.0, rtol: float = 0.0
) -> Comparison:
    """Compare two trajectories (.csv) of the same bodies at the same times, number by number."""
    report = json.loads(_polhode.compare(os.fspath(a), os.fspath(b), float(atol), float(rtol)))
    largest = {own["column"]: own["largest"] for own in report["columns"]}
    return Comparison(report["agrees"], report["rows"], largest, report)
