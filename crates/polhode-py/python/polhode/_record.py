"""The file in which a sweep keeps its finished runs."""

from __future__ import annotations

import io
import os
from collections.abc import Iterable
from importlib import import_module
from typing import Any, NamedTuple

from ._errors import SweepError
from ._table import Table, cell, write_csv

#: What the first line begins with.
_MARK = "# polhode sweep "
_OTHER = "give another path, or move the file away"


class Row(NamedTuple):
    """A run that is finished."""

    run: int
    outcome: str
    error: float
    measured: tuple[float, ...]
    reason: str


class Record:
    """Finished runs, appended to a file by whole lines. What follows the last whole line was cut off by a kill, and
    is made again."""

    def __init__(self, path: str | os.PathLike[str], digest: str, columns: list[str], measures: int) -> None:
        self._path = os.fspath(path)
        self._is_parquet = self._path.endswith(".parquet")
        self._digest = digest
        self._columns = columns
        self._measures = measures
        #: Where lines are appended: beside a Parquet file, which is written when all runs are finished.
        self._lines = self._path + ".part" if self._is_parquet else self._path
        self._file: int | None = None
        if self._is_parquet:
            self._parquet()
        self.rows = {row.run: row for row in self._read()}

    def append(self, row: Row, cells: tuple[Any, ...]) -> None:
        """Appends a finished run, with all its cells."""
        if self._file is None:
            self._file = self._opened()
        self._write(_line(cells))
        self.rows[row.run] = row

    def finish(self, table: Table) -> None:
        """Puts the whole table, in the order of its runs, in place of the lines."""
        self.close()
        beside = self._path + ".tmp"
        if self._is_parquet:
            self._to_parquet(table, beside)
        else:
            with open(beside, "w", encoding="utf-8", newline="") as file:
                file.write(f"{_MARK}{self._digest}\n")
                write_csv(file, table)
        os.replace(beside, self._path)
        if self._is_parquet and os.path.exists(self._lines):
            os.remove(self._lines)

    def close(self) -> None:
        """Closes the file."""
        if self._file is not None:
            os.close(self._file)
            self._file = None

    def _opened(self) -> int:
        is_new = not os.path.exists(self._lines) or os.path.getsize(self._lines) == 0
        self._file = os.open(self._lines, os.O_WRONLY | os.O_APPEND | os.O_CREAT | getattr(os, "O_BINARY", 0), 0o666)
        if is_new:
            self._write(f"{_MARK}{self._digest}\n{_line(self._columns)}")
        return self._file

    def _write(self, text: str) -> None:
        data = text.encode()
        while data and self._file is not None:
            data = data[os.write(self._file, data) :]

    def _read(self) -> list[Row]:
        """The rows of the lines; a line that was cut off is cut away."""
        import csv

        if not os.path.exists(self._lines):
            return self._whole()
        with open(self._lines, "rb") as file:
            data = file.read()
        whole = data[: data.rfind(b"\n") + 1]
        head, _, rest = whole.decode("utf-8", "replace").partition("\n")
        if not whole and (f"{_MARK}{self._digest}").encode().startswith(data):
            os.truncate(self._lines, 0)
            return self._whole()
        if head != f"{_MARK}{self._digest}":
            raise self._foreign(self._lines, head)
        lines = csv.reader(io.StringIO(rest, newline=""))
        columns = next(lines, self._columns)
        if columns != self._columns:
            raise SweepError(f"{self._lines} has the columns {columns}, and this sweep {self._columns}", _OTHER)
        rows = [self._row(line) for line in lines]
        if len(whole) < len(data):
            os.truncate(self._lines, len(whole))
        if not rest:
            os.truncate(self._lines, 0)
        return rows

    def _row(self, line: list[str]) -> Row:
        try:
            error, *measured = line[-2 - self._measures : -1]
            numbers = [float(number) for number in (error, *measured)]
            return Row(int(line[0]), line[-3 - self._measures], numbers[0], tuple(numbers[1:]), line[-1])
        except (ValueError, IndexError):
            raise SweepError(f"{self._lines}: the line {line} is no run of this sweep", _OTHER) from None

    def _foreign(self, path: str, found: str) -> SweepError:
        what = f"of another sweep ({found[len(_MARK) :]})" if found.startswith(_MARK) else "no file of a sweep"
        return SweepError(f"{path} is {what}, and this sweep is {self._digest}; nothing was written", _OTHER)

    def _whole(self) -> list[Row]:
        """The rows of the finished file of Parquet."""
        if not self._is_parquet or not os.path.exists(self._path):
            return []
        try:
            read = self._parquet().read_table(self._path)
        except Exception as error:
            raise SweepError(f"{self._path} cannot be read as Parquet: {error}", _OTHER) from error
        digest = (read.schema.metadata or {}).get(b"polhode sweep", b"").decode()
        if digest != self._digest:
            raise self._foreign(self._path, f"{_MARK}{digest}" if digest else "")
        measured = self._columns[-1 - self._measures : -1]
        return [
            Row(row["run"], row["outcome"], row["error"], tuple(row[name] for name in measured), row["reason"])
            for row in read.to_pylist()
        ]

    def _to_parquet(self, table: Table, path: str) -> None:
        arrow: Any = import_module("pyarrow")
        columns = {name: table[name].tolist() for name in table.columns}
        made = arrow.table(columns).replace_schema_metadata({"polhode sweep": self._digest})
        self._parquet().write_table(made, path)

    def _parquet(self) -> Any:
        try:
            return import_module("pyarrow.parquet")
        except ImportError as error:
            raise SweepError(
                f"save={self._path!r}: pyarrow is not installed", "pip install pyarrow, or save as CSV"
            ) from error


def _line(cells: Iterable[Any]) -> str:
    import csv

    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerow([cell(value) for value in cells])
    return text.getvalue()
