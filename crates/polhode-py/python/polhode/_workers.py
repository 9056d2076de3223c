"""Runs on the workers of an executor: those that a lost worker had are submitted again.

Runs that take less than a quarter of a second are handed over several at a time, since handing over costs an executor
some milliseconds: as many as take a quarter of a second, by the runs that are finished, and fewer towards the end of a
sweep, so that no worker is idle. A run that is tried again is handed over alone.
"""

from __future__ import annotations

import os
from collections import Counter, deque
from collections.abc import Callable, Iterable
from concurrent.futures import BrokenExecutor, CancelledError, Executor, Future, ProcessPoolExecutor
from queue import SimpleQueue
from typing import Any

from ._errors import SweepError, SweepStopped

#: How often a run is begun, and how often in a row all workers may be lost.
TRIES = 3
#: Tasks that wait for each worker of a pool, so that none is idle.
_WAITING = 4
#: Tasks that wait where the number of workers is not known.
_WAITING_UNKNOWN = 1000
#: What the runs take together that are handed over as one task, about, s: far more than to hand them over.
_TASK = 0.25
#: Tasks for each worker, at the least, that what is left of a sweep is handed over in.
_LEFT = 2
_GUARD = (
    'a script that sweeps on processes needs `if __name__ == "__main__":` before what it does; else see what the '
    "workers printed, or use executor=concurrent.futures.ThreadPoolExecutor()"
)


class Workers:
    """Workers of this machine, or those of an executor that was given."""

    def __init__(self, executor: Any, runs: int) -> None:
        from multiprocessing import current_process, get_context

        self._is_own = executor is None or isinstance(executor, int)
        self._lost = 0
        self._has_answered = False
        if self._is_own:
            count = min(_processors() if executor is None else _count(executor), max(runs, 1))
            if getattr(current_process(), "_inheriting", False):
                raise SweepError("a sweep begins while a worker of it starts", _GUARD)
            self._executor: Any = ProcessPoolExecutor(count, mp_context=get_context("spawn"))
        elif hasattr(executor, "get_executor"):
            self._executor = executor.get_executor(pure=False)
        elif isinstance(executor, Executor) or hasattr(executor, "submit"):
            self._executor = executor
        else:
            raise SweepError(
                f"executor={executor!r} has no submit",
                "give an executor of concurrent.futures, a dask Client, or a number of processes",
            )
        workers = getattr(self._executor, "_max_workers", None)
        now = max(_workers_now(executor), 1) if workers is None else workers
        self._most = _WAITING_UNKNOWN if workers is None else _WAITING * workers
        #: Tasks that wait before a run is finished: how long one takes is not known then.
        self._first = _WAITING * now
        #: Tasks that what is left of the sweep is handed over in.
        self._left = _LEFT * max(now, 2)
        #: Runs that are finished, and what they took together, s.
        self._finished, self._took = 0, 0.0

    def compute(
        self, runs: Iterable[int], call: Callable[[list[int]], tuple[Any, ...]], take: Callable[[int, Any], None]
    ) -> None:
        """Computes runs: ``call`` gives the function and arguments of some, which returns how long they took, s, and
        their results; ``take`` gets the result of one, none when it lost its worker each time. The last try of a run is
        made with no other run beside it, so that none answers for another one."""
        waiting, again, alone = deque(runs), deque[int](), deque[int]()
        tries: Counter[int] = Counter()
        running: dict[Future[Any], list[int]] = {}
        ready: SimpleQueue[Future[Any]] = SimpleQueue()
        try:
            while waiting or again or running or alone:
                while (waiting or again) and len(running) < (self._most if self._finished else self._first):
                    together = [again.popleft()] if again else self._task(waiting)
                    self._submit(together, call, running, ready)
                if not running:
                    if not self._has_answered:
                        raise SweepStopped(f"each worker was lost before it had finished a run: {_GUARD}")
                    self._submit([alone.popleft()], call, running, ready)
                future = ready.get()
                together = running.pop(future)
                if self._result(future, together, take):
                    continue
                for run in together:
                    tries[run] += 1
                    if tries[run] < TRIES:
                        (alone if tries[run] == TRIES - 1 else again).append(run)
                    else:
                        self._lost = 0
                        take(run, None)
        except BaseException:
            self._stop(running)
            raise
        if self._is_own:
            self._executor.shutdown()

    def _task(self, waiting: deque[int]) -> list[int]:
        """The next runs that are handed over as one task."""
        count = 1
        if self._finished:
            count = int(min(_TASK * self._finished / max(self._took, 1e-9), -(-len(waiting) // self._left)))
        return [waiting.popleft() for _ in range(max(count, 1))]

    def _result(self, future: Future[Any], together: list[int], take: Callable[[int, Any], None]) -> bool:
        """Takes the results of a future; whether there are any."""
        try:
            took, results = future.result()
        except (BrokenExecutor, CancelledError, KeyboardInterrupt):
            return False
        except Exception as error:
            # A worker or a scheduler of Dask that is gone, as KilledWorker and CommClosedError.
            if type(error).__module__.partition(".")[0] == "distributed":
                return False
            said = f"run {together[0]}: a worker cannot compute it: {type(error).__name__}: {error}"
            raise SweepStopped(said) from error
        self._has_answered = True
        self._lost = 0
        self._finished += len(together)
        self._took += took
        for run, result in zip(together, results):
            take(run, result)
        return True

    def _submit(
        self,
        together: list[int],
        call: Callable[[list[int]], tuple[Any, ...]],
        running: dict[Future[Any], list[int]],
        ready: SimpleQueue[Future[Any]],
    ) -> None:
        try:
            future = self._executor.submit(*call(together))
        except BrokenExecutor as error:
            self._renew(error)
            future = self._executor.submit(*call(together))
        except RuntimeError as error:
            raise SweepStopped(f"the executor takes no run: {error}: give one that is open") from error
        running[future] = together
        future.add_done_callback(ready.put)

    def _renew(self, error: BrokenExecutor) -> None:
        """Puts a pool with as many workers in the place of one that is broken."""
        self._lost += 1
        broken = self._executor
        if self._lost >= TRIES:
            raise SweepStopped(
                f"workers were lost {self._lost} times, and no run was finished between: {_GUARD}"
            ) from error
        if not isinstance(broken, ProcessPoolExecutor):
            raise SweepStopped(f"the executor is broken: {error}: give another one") from error
        broken.shutdown(wait=False)
        kept: Any = broken
        self._executor = ProcessPoolExecutor(
            kept._max_workers, mp_context=kept._mp_context, initializer=kept._initializer, initargs=kept._initargs
        )
        self._is_own = True

    def _stop(self, running: Iterable[Future[Any]]) -> None:
        for future in running:
            future.cancel()
        if self._is_own:
            processes = list((getattr(self._executor, "_processes", None) or {}).values())
            self._executor.shutdown(wait=False, cancel_futures=True)
            for process in processes:
                process.terminate()


def _workers_now(executor: Any) -> int:
    """The threads of a cluster of Dask, none where they are not known."""
    threads = getattr(executor, "nthreads", None)
    return sum(threads().values()) if callable(threads) else 0


def _processors() -> int:
    affinity = getattr(os, "sched_getaffinity", None)
    return len(affinity(0)) if affinity else os.cpu_count() or 1


def _count(executor: int) -> int:
    if isinstance(executor, bool) or executor < 1:
        raise SweepError(f"executor={executor!r} is no number of processes", "give at least 1")
    return executor
