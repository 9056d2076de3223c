"""The scenes by rapier3d-f64, through the program of peers/examples/same_scenes.rs."""

import subprocess
from dataclasses import dataclass, replace

import states
from states import Contact, Recorded, Refused


@dataclass
class Setting:
    """A setting: step (s), iterations of the solver (substeps), model of friction."""

    name: str
    step: float
    iterations: int
    model: str

    def with_step(self, step):
        return replace(self, step=step)


SETTINGS = [
    Setting("defaults", 1 / 60, 4, "simplified"),
    Setting("as advised", 1 / 60, 12, "simplified"),
    Setting("best found", 0.0005, 12, "simplified"),
]


def as_text(scene, samples):
    """The scene as the program reads it."""
    lines = [f"run {scene.duration!r} {samples}", f"material {scene.friction} {scene.restitution}"]
    lines.append("gravity " + " ".join(repr(float(x)) for x in scene.gravity))
    lines += ["floor"] * scene.floor + ["wall"] * scene.wall
    for body in scene.bodies:
        size = (*body.size, 0, 0)[:3]
        kind = 2 if body.fixed else 1 if body.along_x else 0
        numbers = [*size, body.mass, *body.moments(), *body.position, *body.quaternion(), *body.velocity, *body.angular, *body.force, kind]
        lines.append(f"body {body.shape} " + " ".join(repr(float(x)) for x in numbers))
    names = [body.name for body in scene.bodies]
    for hinge in scene.hinges:
        on = names.index(hinge.on) if hinge.on else -1
        lines.append(f"joint {on} {names.index(hinge.body)} " + " ".join(repr(float(x)) for x in hinge.anchor))
    return "\n".join(lines)


def run(program, scene, setting, samples):
    command = [program, repr(setting.step), str(setting.iterations), setting.model]
    text = as_text(scene, samples)
    try:
        done = subprocess.run(command, input=text, capture_output=True, text=True, check=False, timeout=states.LONGEST)
    except subprocess.TimeoutExpired as error:
        raise Refused(f"over {states.LONGEST} s") from error
    if done.returncode != 0:
        raise Refused(done.stderr.strip())
    names = [body.name for body in scene.bodies]
    recorded = Recorded(tracks={name: [] for name in names})
    for line in done.stdout.splitlines():
        kind, *words = line.split()
        numbers = [float(word) for word in words]
        if kind == "wall":
            recorded.wall = numbers[0]
        elif kind == "state":
            if numbers[1] == 0:
                recorded.times.append(numbers[0])
                recorded.contacts.append([])
            recorded.tracks[names[int(numbers[1])]].append(numbers[2:])
        else:
            bodies = [int(k) if k >= 0 else None for k in numbers[1:3]]
            recorded.contacts[-1].append(Contact(*bodies, numbers[3:6], numbers[6:9], numbers[9:12], *numbers[12:15]))
    return recorded
