"""Figures of the package on this machine: `python figures.py [NAME ...]` with the wheel installed.

They are no tests, but times of one machine, which should do nothing else. `views` needs 11 GB of memory, `dask` the
package distributed.
"""

import subprocess
import sys
import time

import numpy as np
import polhode as ph


def printed(what, asked, measured):
    print(f"{what:62} asked {asked:16} measured {measured}", flush=True)


def imported():
    """The time that `import polhode` takes, least of ten, without that of an interpreter that imports nothing."""

    def least(code):
        times = []
        for _ in range(10):
            begun = time.perf_counter()
            subprocess.run([sys.executable, "-c", code], check=True)
            times.append(time.perf_counter() - begun)
        return min(times)

    printed("import polhode, ms", "< 50", f"{1e3 * (least('import polhode') - least('pass')):.1f}")


def step():
    """The time of a call of `step` for a body in free flight, which the step itself takes a part of."""
    scene = ph.Scene(gravity=0, duration=1e9)
    scene.add(ph.Sphere(0.1), mass=1.0, velocity=(1, 0, 0))
    simulation = ph.Simulation(scene, tier="fast", step=1e-3)
    calls = 100_000
    times = []
    for _ in range(5):
        begun = time.perf_counter()
        for _ in range(calls):
            simulation.step()
        times.append(time.perf_counter() - begun)
    printed("a call of step with the step of one free body, us", "< 2 + the step", f"{1e6 * min(times) / calls:.2f}")


def views():
    """Columns of 100 bodies at 1e6 samples are handed over without a copy."""
    scene = ph.Scene(gravity=0, duration=1.0, interval=1e-6)
    for number in range(100):
        scene.add(ph.Sphere(0.1), mass=1.0, at=(number, 0, 0), velocity=(0, 0, 1))
    begun = time.perf_counter()
    run = ph.run(scene)
    ran = time.perf_counter() - begun
    begun = time.perf_counter()
    position = run["sphere-50"].position
    viewed = time.perf_counter() - begun
    assert position.shape == (1_000_001, 3) and position.base is not None and not position.flags.owndata
    assert abs(position[-1, 2] - 1.0) < 1e-12
    printed("a view of 1e6 samples of 100 bodies, us (the run in s)", "no copy", f"{1e6 * viewed:.0f} ({ran:.1f})")


def stands():
    """Whether a pallet of 60 boxes stands, and by how much."""
    size = {"size_x": 0.4, "size_y": 0.3, "size_z": 0.25, "mass": 8.0}
    places = [(i, j, k) for i in range(4) for j in range(3) for k in range(5)]
    table = [{**size, "x": 0.4 * i, "y": 0.3 * j, "z": 0.125 + 0.25 * k} for i, j, k in places]
    begun = time.perf_counter()
    answer = ph.stands(ph.boxes(table, friction=0.4))
    printed("stands of a pallet of 60 boxes, s", "< 1", f"{time.perf_counter() - begun:.2f} ({answer.stands})")


def die():
    scene = ph.Scene(duration=3.0, interval=3.0)
    scene.fixed(ph.HalfSpace(), friction=0.4)
    still = {"rotation_vector": (0, 0, 0), "velocity": (0, 0, 0), "angular_velocity": (0, 0, 0)}
    die = ph.Box(0.016, 0.016, 0.016)
    scene.add(die, name="die", mass=0.005, at=(0, 0, 0.15), friction=0.4, restitution=0.4, **still)
    return scene


THROWN = {
    "bodies.die.rotation_vector[0]": ph.Uniform(-3, 3),
    "bodies.die.rotation_vector[1]": ph.Uniform(-3, 3),
    "bodies.die.rotation_vector[2]": ph.Uniform(-3, 3),
    "bodies.die.velocity[0]": ph.Normal(0.5, 0.1),
    "bodies.die.angular_velocity[1]": ph.Normal(0, 20),
}


def face(run):
    """The face that is up, 1 to 6."""
    w, x, y, z = run["die"].orientation[-1]
    up = [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]
    axis = int(np.argmax(np.abs(up)))
    return 1 + axis if up[axis] > 0 else 6 - axis


def throws():
    """A thousand throws of a die on the processors of this machine, and how often each face is up."""
    for tier in ("accurate", "stepped", "fast"):
        begun = time.perf_counter()
        table = ph.sweep(die(), vary=THROWN, runs=1000, seed=1, measure={"face": face}, tier=tier)
        took = time.perf_counter() - begun
        faces = table["face"][table["outcome"] == "completed"].astype(int)
        printed(f"1000 throws of a die, tier {tier}, s", "< 10", f"{took:.1f} {np.bincount(faces, minlength=7)[1:]}")


def sweep(make, name):
    """How much faster two workers are than one."""
    scene = ph.Scene(duration=4.0)
    scene.fixed(ph.HalfSpace(), friction=0.4)
    for number in range(6):
        scene.add(ph.Box(1, 0.5, 0.25), name=f"box-{number}", mass=2.0, at=(0, 0, 0.2 + 0.4 * number), friction=0.4)
    took = []
    for workers in (1, 2):
        with make(workers) as executor:
            small = {"bodies.box-5.position[0]": ph.Normal(0, 0.1)}
            ph.sweep(scene, vary=small, runs=2, measure=["box-5.position[2]@end"], executor=executor)
            begun = time.perf_counter()
            ph.sweep(scene, vary=small, runs=200, measure=["box-5.position[2]@end"], executor=executor, seed=1)
            took.append(time.perf_counter() - begun)
    each = 1e3 * took[0] / 200
    what = f"200 runs of {each:.0f} ms by {name}: two workers to one"
    printed(what, ">= 1.7", f"{took[0] / took[1]:.2f} times as fast")


def processes():
    from concurrent.futures import ProcessPoolExecutor

    sweep(ProcessPoolExecutor, "processes")


def dask():
    from distributed import Client, LocalCluster

    def client(workers):
        return Client(LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None))

    sweep(client, "Dask")


ALL = {own.__name__: own for own in (imported, step, views, stands, throws, processes, dask)}

if __name__ == "__main__":
    for name in sys.argv[1:] or ALL:
        ALL[name]()
