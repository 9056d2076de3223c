"""The scenes by the program polhode, in its tiers with their defaults."""

import csv
import io
import json
import pathlib
import subprocess
import tempfile

import states
from states import COLUMNS, Recorded, Refused


def as_toml(scene, tier, samples, step=None):
    """The scene as a file of polhode."""
    method = f'[method]\ntier = "{tier}"\n' + (f"step = {step!r}\n" if step else "")
    text = [
        f'format = 1\nname = "scene"\nduration = {scene.duration!r}\ngravity = {list(scene.gravity)}\n',
        f"{method}[output]\ninterval = {scene.duration / samples!r}\n",
        f"[materials.all]\nfriction = {scene.friction}\nrestitution = {scene.restitution}\n",
    ]
    for name, normal, is_there in (("floor", [0, 0, 1], scene.floor), ("wall", [1, 0, 0], scene.wall)):
        if is_there:
            text.append(f'[[bodies]]\nname = "{name}"\nfixed = true\nmaterial = "all"\nshape.half_space.normal = {normal}\n')
    shapes = {
        "sphere": lambda s: f"shape.sphere.radius = {s[0]}",
        "box": lambda s: f"shape.box.size = {list(s)}",
        "capsule": lambda s: f"shape.capsule = {{ radius = {s[0]}, height = {s[1]} }}",
        "cylinder": lambda s: f"shape.cylinder = {{ radius = {s[0]}, height = {s[1]} }}",
    }
    for body in scene.bodies:
        if body.fixed:
            text.append(f'[[bodies]]\nname = "{body.name}"\nfixed = true\nposition = {list(body.position)}\nmaterial = "all"\n{shapes[body.shape](body.size)}\n')
            continue
        text.append(
            f'[[bodies]]\nname = "{body.name}"\nmass = {body.mass}\nmaterial = "all"\nposition = {list(body.position)}\n'
            f"velocity = {list(body.velocity)}\nangular_velocity = {list(body.angular)}\n"
            f"rotation_vector = [0, {body.about_y!r}, 0]\n{shapes[body.shape](body.size)}\n"
        )
        if body.inertia:
            text.append(f"inertia = {list(body.inertia)}\n")
    for body in scene.bodies:
        if body.along_x:
            text.append(f'[[joints]]\ntype.slider = {{ bodies = ["{body.name}"], anchor = {list(body.position)}, axis = [1, 0, 0] }}\n')
        if body.force != (0.0, 0.0, 0.0):
            text.append(f'[[forces]]\ntype.force = {{ body = "{body.name}", force = {list(body.force)} }}\n')
    for hinge in scene.hinges:
        bodies = json.dumps([hinge.body, *([hinge.on] if hinge.on else [])])
        text.append(f"[[joints]]\ntype.hinge = {{ bodies = {bodies}, anchor = {list(hinge.anchor)}, axis = [0, 1, 0] }}\n")
    if len(scene.hinges) > 1:
        text.append(f"[[no_contact]]\nbodies = {json.dumps([body.name for body in scene.bodies])}\n")
    return "".join(text)


def run(program, scene, tier, samples, step=None):
    with tempfile.TemporaryDirectory() as folder:
        file, out = pathlib.Path(folder, "scene.toml"), pathlib.Path(folder, "out.csv")
        file.write_text(as_toml(scene, tier, samples, step))
        command = [program, "run", "--quiet", "--json", str(file), "-o", str(out)]
        try:
            done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=states.LONGEST)
        except subprocess.TimeoutExpired as error:
            raise Refused(f"over {states.LONGEST} s") from error
        report = json.loads(done.stdout) if done.stdout else {}
        # A report of a run that went to its end has an estimate of that name.
        if isinstance(report.get("error"), str) or done.returncode not in (0, 1):
            raise Refused(str(report.get("error") or done.stderr.strip()))
        recorded = Recorded(tracks={body.name: [] for body in scene.bodies}, wall=report.get("wall_s"))
        recorded.own_residual = report.get("max_residual")
        for row in csv.DictReader(io.StringIO(out.read_text())):
            t = float(row["t"])
            if not recorded.times or recorded.times[-1] != t:
                recorded.times.append(t)
            if row["body"] in recorded.tracks:
                recorded.tracks[row["body"]].append([float(row[key]) for key in COLUMNS])
    return recorded
