"""How far a run or a sweep is, as a bar of tqdm where that is installed."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import Any

#: What takes less time shows no bar, s.
_AFTER = 0.5
_FORMAT = "{desc}: {percentage:3.0f}%|{bar}| {n:.4g} of {total:.4g} {unit} [{elapsed}<{remaining}]"


class Bar:
    """A bar; it is drawn, and tqdm loaded, when what it is about takes longer than half a second. ``progress`` is true
    or false, or none for a bar where a person would see it: in a notebook, or where stderr is a terminal."""

    def __init__(self, what: str, unit: str, progress: bool | None) -> None:
        self._what = what
        self._unit = unit
        self._is_asked = progress is True
        self._is_wanted = is_watched() if progress is None else bool(progress)
        self._begun = time.monotonic()
        self._bar: Any = None

    @property
    def told(self) -> Callable[[float, float], None] | None:
        """What is to be called with how much of all is done; none where no bar is wanted."""
        return self._tell if self._is_wanted else None

    def _tell(self, done: float, total: float) -> None:
        if total <= 0 or time.monotonic() - self._begun < _AFTER:
            return
        if self._bar is None:
            make = _tqdm()
            if make is None:
                self._is_wanted = False
                if self._is_asked:
                    import warnings

                    warnings.warn("progress=True: tqdm is not installed: pip install tqdm", stacklevel=4)
                self._begun = float("inf")
                return
            self._bar = make(total=total, desc=self._what, unit=self._unit, bar_format=_FORMAT, leave=False)
        self._bar.update(done - self._bar.n)

    def __enter__(self) -> Bar:
        return self

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.close()


def is_watched() -> bool:
    """Whether a person would see a bar: in the first thread of a notebook or of a program on a terminal."""
    processes, threads = sys.modules.get("multiprocessing"), sys.modules.get("threading")
    if processes is not None and processes.parent_process() is not None:
        return False
    if threads is not None and threads.current_thread() is not threads.main_thread():
        return False
    return in_notebook() or (sys.stderr is not None and sys.stderr.isatty())


def in_notebook() -> bool:
    """Whether a notebook shows what a cell gives."""
    ipython = sys.modules.get("IPython")
    shell = None if ipython is None else ipython.get_ipython()
    return shell is not None and "IPKernelApp" in shell.config


def _tqdm() -> Any:
    import warnings

    try:
        with warnings.catch_warnings():
            # Without ipywidgets a notebook has the bar of terminals, which serves.
            warnings.simplefilter("ignore")
            from tqdm.auto import tqdm  # type: ignore[import-untyped, import-not-found, unused-ignore]
    except ImportError:
        return None
    return tqdm
