"""Tables: what a sweep has measured."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator, Mapping, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple

from . import _toml
from ._errors import UnknownName

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


class Mean(NamedTuple):
    """A mean, how uncertain it is by the number of runs, and that number."""

    value: float
    standard_error: float
    runs: int


class Table:
    """The runs of a sweep, one a row, in the order of their numbers.

    The columns are ``run``, what was varied, ``outcome`` (completed, degraded, failed), ``error`` (the estimated
    error of the run, NaN where its method has none), what was measured (NaN for runs that failed), and ``reason``.
    """

    def __init__(self, columns: Mapping[str, Sequence[Any]]) -> None:
        self._columns = {name: list(values) for name, values in columns.items()}

    @property
    def columns(self) -> list[str]:
        """Names of the columns."""
        return list(self._columns)

    def __len__(self) -> int:
        return len(next(iter(self._columns.values()), ()))

    def __contains__(self, name: object) -> bool:
        return name in self._columns

    def __getitem__(self, name: str) -> NDArray[Any]:
        """A column: (N,), or (N, k) where vectors were varied."""
        import numpy as np

        values = self._values(name)
        try:
            column = np.array(values)
        except ValueError:
            column = np.array([None, *values], dtype=object)[1:]
        column.flags.writeable = False
        return column

    def where(self, chosen: ArrayLike) -> Table:
        """The rows for which ``chosen``, (N,), is true: ``table.where(table["outcome"] != "failed")``."""
        import numpy as np

        mask = np.asarray(chosen)
        if mask.dtype != np.bool_ or mask.shape != (len(self),):
            raise ValueError(f"where: {mask.dtype} of shape {mask.shape}, bool of shape ({len(self)},) is needed")
        rows = [int(row) for row in np.nonzero(mask)[0]]
        return Table({name: [values[row] for row in rows] for name, values in self._columns.items()})

    def mean(self, name: str) -> Mean:
        """The mean of a column, with its standard error: the deviation of runs over the root of their number."""
        values = self._numbers(name)
        count = len(values)
        mean = math.fsum(values) / count
        if count == 1:
            return Mean(mean, math.nan, 1)
        squares = math.fsum((value - mean) ** 2 for value in values)
        return Mean(mean, math.sqrt(squares / (count - 1) / count), count)

    def quantile(self, name: str, shares: Sequence[float]) -> NDArray[np.float64]:
        """The values that these shares of the runs lie below, between runs by a line."""
        import numpy as np

        quantiles: NDArray[np.float64] = np.quantile(np.array(self._numbers(name)), np.array(shares, dtype=float))
        return quantiles

    def to_csv(self, path: str | os.PathLike[str]) -> None:
        """Writes the table as CSV; numbers have all their digits."""
        beside = f"{os.fspath(path)}.tmp"
        with open(beside, "w", encoding="utf-8", newline="") as file:
            write_csv(file, self)
        os.replace(beside, path)

    def to_pandas(self) -> Any:
        """The table as a pandas ``DataFrame``, whose index is ``run``."""
        pandas: Any = import_module("pandas")
        return pandas.DataFrame(self._columns).set_index("run")

    def rows(self) -> Iterator[tuple[Any, ...]]:
        """The rows."""
        return zip(*self._columns.values())

    def _values(self, name: str) -> list[Any]:
        if name not in self._columns:
            raise UnknownName(str(name), "column", self.columns)
        return self._columns[name]

    def _numbers(self, name: str) -> list[float]:
        values = self._values(name)
        if not all(isinstance(value, (int, float)) for value in values):
            raise TypeError(f"{name}: a column of numbers is needed")
        missing = sum(math.isnan(value) for value in values)
        if missing:
            raise ValueError(
                f"{name}: {missing} of {len(values)} runs have no value, which is more than 0: leave them out, as in "
                'table.where(table["outcome"] != "failed"), or see table["reason"]'
            )
        if not values:
            raise ValueError(f"{name}: 0 runs are left, and at least 1 is needed")
        return [float(value) for value in values]

    def __repr__(self) -> str:
        from collections import Counter

        outcomes = Counter(self._columns.get("outcome", ()))
        told = ", ".join(f"{number} {outcome}" for outcome, number in sorted(outcomes.items()))
        return f"<polhode.Table: {len(self)} runs ({told}); {', '.join(self._columns)}>"


def cell(value: Any) -> str:
    """A value in CSV: floats have all their digits."""
    if isinstance(value, str):
        return value
    if isinstance(value, float):
        return float.__repr__(value)
    return _toml.value(_toml.plain(value))


def write_csv(file: Any, table: Table) -> None:
    """Writes header and rows."""
    import csv

    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(table.columns)
    writer.writerows([cell(value) for value in row] for row in table.rows())
