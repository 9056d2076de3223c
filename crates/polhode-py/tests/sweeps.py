"""Scenes and measures of the tests of sweeps; workers import it."""

import os
import signal
import time
from pathlib import Path

import polhode as ph

VARY = {"materials.floor.friction": [0.3, 0.5], "bodies.box.position[2]": ph.Normal(1, 0.01)}
MEASURE = ["box.position[2]@end", "events.impact", "energy.total@end"]


def scene():
    scene = ph.Scene(duration=0.3)
    scene.material("floor", friction=0.4)
    scene.fixed(ph.HalfSpace(), name="floor", material="floor")
    scene.add(ph.Box(1, 0.5, 0.25), mass=2.0, at=(0, 0, 1), name="box", friction=0.4)
    return scene


def top(run):
    return run["box"].position[:, 2].max()


def picky(run):
    if run["box"].position[0, 2] > 1.0:
        raise ArithmeticError("too high\nfor me")
    return 1.0


def slow(run):
    time.sleep(0.05)
    return top(run)


class Deadly:
    """Kills its worker at runs that begin above a height, as often as it may; a folder remembers how often it did."""

    def __init__(self, folder, above, times):
        self.folder, self.above, self.times = str(folder), above, times

    def __call__(self, run):
        if run["box"].position[0, 2] > self.above:
            for number in range(self.times):
                try:
                    (Path(self.folder) / str(number)).touch(exist_ok=False)
                except FileExistsError:
                    continue
                os.kill(os.getpid(), signal.SIGKILL)
        return top(run)
