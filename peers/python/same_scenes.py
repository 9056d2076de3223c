"""Scenes with exact answers, by polhode and by MuJoCo.

    python peers/python/same_scenes.py --polhode target/release/polhode [--keep FOLDER] [SCENE ...]

Each scene is run by MuJoCo with three settings (its defaults; what its manual advises for contact; the best that was found) and by
polhode in its tiers with defaults. The error is that of one quantity whose exact value is known in closed form, computed from recorded
positions alone. The energy that a run has made (positive) or lost beyond what the exact motion loses is relative to the largest energy
of the motion, likewise from recorded states. A run that breaks (a position that is no number, or an error above `BROKEN`) is marked.
`--keep` writes the recorded positions as CSV, so that others can compute again.

MuJoCo (pip install mujoco) is left out where it is not installed.
"""

import argparse
import csv
import io
import math
import pathlib
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field

G = 9.81
SAMPLES = 200
BROKEN = 10.0


@dataclass
class Body:
    """A ball, box or capsule. Sizes in m, mass in kg, velocity in m/s."""

    name: str
    shape: str
    size: tuple
    mass: float
    position: tuple
    velocity: tuple = (0.0, 0.0, 0.0)
    about_y: float = 0.0
    inertia: tuple | None = None


@dataclass
class Scene:
    """Bodies above a floor at z = 0; `exact` gives the error from times and positions (m) of the bodies by name."""

    name: str
    duration: float
    bodies: list
    error: object
    what: str
    friction: float = 0.0
    restitution: float = 0.0
    wall: bool = False
    links: list = field(default_factory=list)


def last(track):
    return track[-1]


def velocity(track, times, at):
    """Of a body that moves evenly there, from two samples."""
    k = min(range(len(times)), key=lambda i: abs(times[i] - at))
    h = times[k] - times[k - 20]
    return [(track[k][i] - track[k - 20][i]) / h for i in range(3)]


def bounce(e=0.8, drop=1.0, radius=0.1, end=2.0):
    def height(t):
        fall = math.sqrt(2 * drop / G)
        if t < fall:
            return drop - 0.5 * G * t * t
        t, speed = t - fall, G * fall
        while True:
            speed *= e
            flight = 2 * speed / G
            if t < flight:
                return speed * t - 0.5 * G * t * t
            t -= flight

    def error(times, tracks):
        return abs(last(tracks["ball"])[2] - radius - height(times[-1])) / drop

    ball = Body("ball", "sphere", (radius,), 1.0, (0, 0, radius + drop))
    return Scene("bounce", end, [ball], error, "height after 2 s of bounces, of the drop", restitution=e)


def rolling(angle, name):
    speed, radius, friction = 3.0, 0.1, 0.3

    def error(times, tracks):
        found = velocity(tracks["ball"], times, times[-1])
        exact = [5 / 7 * speed * math.cos(angle), 5 / 7 * speed * math.sin(angle), 0]
        return math.dist(found, exact) / speed

    start = (speed * math.cos(angle), speed * math.sin(angle), 0.0)
    ball = Body("ball", "sphere", (radius,), 1.0, (0, 0, radius), start)
    return Scene(name, 1.0, [ball], error, "velocity once it rolls, of that at the start", friction=friction)


def slide():
    speed, friction, angle = 2.0, 0.3, math.pi / 4

    def error(times, tracks):
        way = speed**2 / (2 * friction * G)
        exact = [way * math.cos(angle), way * math.sin(angle), 0.05]
        return math.dist(last(tracks["box"]), exact) / way

    start = (speed * math.cos(angle), speed * math.sin(angle), 0.0)
    box = Body("box", "box", (0.4, 0.4, 0.1), 1.0, (0, 0, 0.05), start)
    return Scene("slide", 3.0, [box], error, "where it stops, of its way", friction=friction)


def diamond():
    places = [(x, row) for row, xs in enumerate([[0], [-0.5, 0.5], [-1, 0, 1], [-1.5, -0.5, 0.5, 1.5]]) for x in xs]
    places += [(x, row + 4) for row, xs in enumerate([[-1, 0, 1], [-0.5, 0.5], [0]]) for x in xs]
    bodies = [
        Body(f"brick {k}", "box", (1, 0.5, 0.25), 1.0, (x, 0, 0.125 + 0.25 * row)) for k, (x, row) in enumerate(places)
    ]

    def error(times, tracks):
        return max(math.dist(track[0], last(track)) for track in tracks.values()) / 0.25

    return Scene("diamond-4", 10.0, bodies, error, "how far a brick has moved after 10 s, of its height")


def ladder():
    length, radius, start = 2.0, 0.02, math.radians(60)

    def error(times, tracks):
        exact = math.sqrt(G * length) * math.sin(start) ** 1.5 / 3
        return abs(velocity(tracks["ladder"], times, times[-1])[0] - exact) / exact

    centre = (0.5 * length * math.cos(start) + radius, 0, 0.5 * length * math.sin(start) + radius)
    # Along its z axis; the upper end leans on the wall at x = 0.
    across = length**2 / 12
    rod = Body("ladder", "capsule", (radius, length), 1.0, centre, about_y=start - math.pi / 2, inertia=(across, across, 1e-3))
    return Scene("ladder", 0.85, [rod], error, "speed along the floor once it has left the wall", wall=True)


def heavy():
    bodies = [
        Body(f"light {x} {y}", "box", (1, 1, 1), 1.0, (1.2 * x, 1.2 * y, 0.5)) for x in (-1, 0, 1) for y in (-1, 0, 1)
    ]
    bodies.append(Body("heavy", "box", (4, 4, 1), 1000.0, (0, 0, 1.5)))

    def error(times, tracks):
        return max(math.dist(track[0], last(track)) for track in tracks.values())

    return Scene("1000 kg on nine boxes", 10.0, bodies, error, "how far a body has moved after 10 s, m", friction=0.5)


SCENES = [bounce(), rolling(0.0, "rolling"), rolling(math.pi / 4, "rolling at 45 degrees"), slide(), diamond(), ladder(), heavy()]


def as_toml(scene, tier):
    """The scene as a file of polhode."""
    text = [
        f'format = 1\nname = "{scene.name}"\nduration = {scene.duration}\ngravity = [0, 0, {-G}]\n',
        f'[method]\ntier = "{tier}"\n[output]\ninterval = {scene.duration / SAMPLES!r}\n',
        f"[materials.all]\nfriction = {scene.friction}\nrestitution = {scene.restitution}\n",
        '[[bodies]]\nname = "floor"\nfixed = true\nmaterial = "all"\nshape.half_space.normal = [0, 0, 1]\n',
    ]
    if scene.wall:
        text.append('[[bodies]]\nname = "wall"\nfixed = true\nmaterial = "all"\nshape.half_space.normal = [1, 0, 0]\n')
    for body in scene.bodies:
        shape = {
            "sphere": lambda s: f"shape.sphere.radius = {s[0]}",
            "box": lambda s: f"shape.box.size = {list(s)}",
            "capsule": lambda s: f"shape.capsule = {{ radius = {s[0]}, height = {s[1]} }}",
        }[body.shape](body.size)
        text.append(
            f'[[bodies]]\nname = "{body.name}"\nmass = {body.mass}\nmaterial = "all"\nposition = {list(body.position)}\n'
            f"velocity = {list(body.velocity)}\nrotation_vector = [0, {body.about_y!r}, 0]\n{shape}\n"
        )
        if body.inertia:
            text.append(f"inertia = {list(body.inertia)}\n")
    return "".join(text)


def by_polhode(program, scene, tier):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "scene.toml")
        file.write_text(as_toml(scene, tier))
        done = subprocess.run(
            [program, "run", "--quiet", str(file), "-o", "-"], capture_output=True, text=True, check=False
        )
        if done.returncode not in (0, 1) or not done.stdout:
            raise RuntimeError(done.stderr.strip() or "polhode wrote nothing")
    times, tracks = [], {body.name: [] for body in scene.bodies}
    for row in csv.DictReader(io.StringIO(done.stdout)):
        if row["body"] not in tracks:
            continue
        t = float(row["t"])
        if not times or times[-1] != t:
            times.append(t)
        tracks[row["body"]].append([float(row[key]) for key in ("px", "py", "pz")])
    return times, tracks


@dataclass
class Mujoco:
    """A setting of MuJoCo: its step (s), options of the file, and the time constant of contacts in steps (none: its default)."""

    name: str
    step: float
    options: str
    contact_steps: float | None


MUJOCO = [
    Mujoco("defaults", 0.002, "", None),
    Mujoco("as its manual advises", 0.001, 'cone="elliptic" impratio="10" integrator="implicitfast"', 2.0),
    Mujoco("best found", 0.0001, 'cone="elliptic" impratio="100" noslip_iterations="10" integrator="implicitfast"', 2.0),
]


def as_mjcf(scene, setting):
    """The scene as a file of MuJoCo. Restitution is that of a spring with the damping that gives it."""
    solref = ""
    if scene.restitution > 0:
        stiffness = (0.1 / setting.step) ** 2
        log = math.log(scene.restitution)
        ratio = -log / math.sqrt(math.pi**2 + log**2)
        solref = f'solref="{-stiffness} {-2 * ratio * math.sqrt(stiffness)}"'
    elif setting.contact_steps:
        solref = f'solref="{setting.contact_steps * setting.step} 1"'
    geom = f'condim="{3 if scene.friction > 0 else 1}" friction="{scene.friction} 0 0" {solref}'
    text = [
        f'<mujoco><option timestep="{setting.step}" gravity="0 0 {-G}" {setting.options}/>',
        f'<default><geom {geom}/></default><worldbody><geom type="plane" size="0 0 1"/>',
    ]
    if scene.wall:
        text.append('<geom type="plane" size="0 0 1" zaxis="1 0 0"/>')
    for body in scene.bodies:
        quat = f"{math.cos(body.about_y / 2)} 0 {math.sin(body.about_y / 2)} 0"
        half = body.size if body.shape == "sphere" else [0.5 * s for s in body.size]
        half = (body.size[0], 0.5 * body.size[1]) if body.shape == "capsule" else half
        inertial = ""
        if body.inertia:
            inertial = f'<inertial pos="0 0 0" mass="{body.mass}" diaginertia="{" ".join(map(str, body.inertia))}"/>'
        text.append(
            f'<body name="{body.name}" pos="{" ".join(map(str, body.position))}" quat="{quat}"><freejoint/>{inertial}'
            f'<geom type="{body.shape}" size="{" ".join(map(str, half))}" mass="{body.mass}"/></body>'
        )
    return "".join(text) + "</worldbody></mujoco>"


def by_mujoco(scene, setting):
    import mujoco

    model = mujoco.MjModel.from_xml_string(as_mjcf(scene, setting))
    data = mujoco.MjData(model)
    for k, body in enumerate(scene.bodies):
        data.qvel[6 * k : 6 * k + 3] = body.velocity
    mujoco.mj_forward(model, data)
    times, tracks = [], {body.name: [] for body in scene.bodies}
    for sample in range(SAMPLES + 1):
        end = sample * scene.duration / SAMPLES
        while data.time < end - 0.5 * setting.step:
            mujoco.mj_step(model, data)
        times.append(data.time)
        for body in scene.bodies:
            tracks[body.name].append([float(x) for x in data.body(body.name).xpos])
    return times, tracks


def keep(folder, scene, engine, times, tracks):
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / f"{scene.name}, {engine}.csv".replace(" ", "-"), "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["t", "body", "x", "y", "z"])
        for k, t in enumerate(times):
            writer.writerows([t, name, *track[k]] for name, track in tracks.items())


def told(error):
    return f"{error:.1e}" if error < BROKEN else "broken"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--polhode", default="target/release/polhode", help="the program")
    parser.add_argument("--tiers", default="accurate,stepped", help="tiers of polhode, with commas")
    parser.add_argument("--keep", type=pathlib.Path, help="a folder for the recorded positions")
    parser.add_argument("scenes", nargs="*", help="names of scenes (default: all)")
    arguments = parser.parse_args()
    engines = [
        (f"polhode, {tier}", lambda scene, tier=tier: by_polhode(arguments.polhode, scene, tier))
        for tier in arguments.tiers.split(",")
    ]
    try:
        import mujoco

        engines += [
            (f"MuJoCo {mujoco.__version__}, {s.name}", lambda scene, s=s: by_mujoco(scene, s)) for s in MUJOCO
        ]
    except ImportError:
        print("MuJoCo is not installed (pip install mujoco)", file=sys.stderr)
    print("| scene | error of | " + " | ".join(name for name, _ in engines) + " |")
    print("|---" * (len(engines) + 2) + "|")
    for scene in SCENES:
        if arguments.scenes and scene.name not in arguments.scenes:
            continue
        cells = []
        for name, run in engines:
            try:
                times, tracks = run(scene)
                if arguments.keep:
                    keep(arguments.keep, scene, name, times, tracks)
                cells.append(told(scene.error(times, tracks)))
            except RuntimeError as error:
                print(f"{scene.name}, {name}: {error}", file=sys.stderr)
                cells.append("refused")
        print(f"| {scene.name} | {scene.what} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
