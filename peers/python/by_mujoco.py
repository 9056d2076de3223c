"""The scenes by MuJoCo (pip install mujoco-core)."""

import math
import time
from dataclasses import dataclass, replace

import states
from states import Contact, Recorded, Refused


@dataclass
class Setting:
    """A setting: its step (s), options of the file, and the time constant of contacts and joints in steps (none: its default)."""

    name: str
    step: float
    options: str
    contact_steps: float | None

    def with_step(self, step):
        return replace(self, step=step)


SETTINGS = [
    Setting("defaults", 0.002, "", None),
    Setting("as advised", 0.001, 'cone="elliptic" impratio="10" integrator="implicitfast"', 2.0),
    Setting("best found", 0.0001, 'cone="elliptic" impratio="100" noslip_iterations="10" integrator="implicitfast"', 2.0),
]


def for_scene(scene, setting):
    """Where nothing touches the best found is the integrator of order 4, at 1 ms."""
    if scene.smooth and setting.name == "best found":
        return Setting(setting.name, max(setting.step, 0.001), 'integrator="RK4"', setting.contact_steps)
    return setting


def softness(scene, setting):
    """Restitution is that of a spring with the damping that gives it."""
    if scene.restitution > 0:
        stiffness = (0.1 / setting.step) ** 2
        log = math.log(scene.restitution)
        ratio = -log / math.sqrt(math.pi**2 + log**2)
        return f'solref="{-stiffness} {-2 * ratio * math.sqrt(stiffness)}"'
    return f'solref="{setting.contact_steps * setting.step} 1"' if setting.contact_steps else ""


def tree_of(scene):
    """Hinges that close no loop: a hinge alone, or all but the last."""
    return scene.hinges[:-1] if len(scene.hinges) > 1 else scene.hinges


def as_mjcf(scene, setting):
    """The scene as a file of MuJoCo. Hinges but the last are a tree, the last closes the loop."""
    solref = softness(scene, setting)
    geom = f'condim="{3 if scene.friction > 0 else 1}" friction="{scene.friction} 0 0" {solref}'
    if scene.hinges:
        geom = 'contype="0" conaffinity="0"'
    text = [
        f'<mujoco><option timestep="{setting.step}" gravity="{words(scene.gravity)}" {setting.options}/>',
        f"<default><geom {geom}/></default><worldbody>",
    ]
    if scene.floor:
        text.append('<geom type="plane" size="0 0 1"/>')
    if scene.wall:
        text.append('<geom type="plane" size="0 0 1" zaxis="1 0 0"/>')
    parents = {hinge.body: hinge for hinge in tree_of(scene)}
    roots = [body for body in scene.bodies if body.name not in parents or parents[body.name].on is None]
    text += [element(scene, body, parents, None) for body in roots]
    text.append("</worldbody>")
    if len(scene.hinges) > 1:
        last = scene.hinges[-1]
        body = next(body for body in scene.bodies if body.name == last.body)
        on = f'body2="{last.on}"' if last.on else ""
        text.append(f'<equality><connect body1="{last.body}" {on} anchor="{words(local(body, last.anchor))}" {solref}/></equality>')
    return "".join(text) + "</mujoco>"


def words(numbers):
    return " ".join(repr(float(x)) for x in numbers)


def local(body, point):
    """A point of the world in axes of a body that is turned about y."""
    x, y, z = (a - b for a, b in zip(point, body.position))
    c, s = math.cos(body.about_y), math.sin(body.about_y)
    return (c * x - s * z, y, s * x + c * z)


def element(scene, body, parents, parent):
    """A body with what hangs on it."""
    half = body.size if body.shape == "sphere" else [0.5 * s for s in body.size]
    if body.shape in ("capsule", "cylinder"):
        half = (body.size[0], 0.5 * body.size[1])
    place, turn = body.position, body.about_y
    joint = "" if body.fixed else '<joint type="slide" axis="1 0 0"/>' if body.along_x else "<freejoint/>"
    if body.name in parents:
        anchor = " ".join(repr(float(x)) for x in local(body, parents[body.name].anchor))
        joint = f'<joint type="hinge" axis="0 1 0" pos="{anchor}"/>'
    if parent:
        place, turn = local(parent, body.position), body.about_y - parent.about_y
    inside = [element(scene, other, parents, body) for other in scene.bodies if other.name in parents and parents[other.name].on == body.name]
    return (
        f'<body name="{body.name}" pos="{" ".join(repr(float(x)) for x in place)}" quat="{math.cos(turn / 2)!r} 0 {math.sin(turn / 2)!r} 0">'
        f'{joint}<inertial pos="0 0 0" mass="{body.mass}" diaginertia="{" ".join(repr(float(x)) for x in body.moments())}"/>'
        f'<geom type="{body.shape}" size="{" ".join(map(str, half))}"/>{"".join(inside)}</body>'
    )


def contacts(mujoco, model, data, numbers, h):
    """Contacts of the step that was made, with the velocities after it."""
    import numpy

    found = []
    for k in range(data.ncon):
        contact = data.contact[k]
        force = numpy.zeros(6)
        mujoco.mj_contactForce(model, data, k, force)
        frame = numpy.array(contact.frame).reshape(3, 3)
        # The force in the frame acts on the second body, and the normal points to it.
        a, b = (numbers.get(int(model.geom_bodyid[geom])) for geom in (contact.geom2, contact.geom1))
        impulse = h * (force[:3] @ frame)
        found.append(Contact(a, b, list(contact.pos), list(frame[0]), [float(x) for x in impulse], float(contact.dist), h, h))
    return found


def state(mujoco, model, data, name):
    import numpy

    body, velocity = data.body(name), numpy.zeros(6)
    mujoco.mj_objectVelocity(model, data, mujoco.mjtObj.mjOBJ_BODY, body.id, velocity, 0)
    return [float(x) for x in (*body.xpos, *body.xquat, *velocity[3:], *velocity[:3])]


def run(scene, setting, samples):
    import mujoco

    setting = for_scene(scene, setting)
    model = mujoco.MjModel.from_xml_string(as_mjcf(scene, setting))
    data = mujoco.MjData(model)
    if not scene.hinges:
        k = 0
        for body in scene.bodies:
            if body.force != (0.0, 0.0, 0.0):
                data.xfrc_applied[model.body(body.name).id, :3] = body.force
            if body.fixed or body.along_x:
                k += not body.fixed
                continue
            c, s = math.cos(body.about_y), math.sin(body.about_y)
            x, y, z = body.angular
            data.qvel[k : k + 3] = body.velocity
            # Angular velocities of free bodies are in their own axes.
            data.qvel[k + 3 : k + 6] = (c * x - s * z, y, s * x + c * z)
            k += 6
    numbers = {model.body(body.name).id: k for k, body in enumerate(scene.bodies)}
    recorded, steps = Recorded(tracks={body.name: [] for body in scene.bodies}, wall=0.0), 0
    for sample in range(samples + 1):
        end = sample * scene.duration / samples
        count = max(0, math.floor(end / setting.step + 0.5) - steps)
        begin = time.perf_counter()
        if count:
            mujoco.mj_step(model, data, nstep=count)
        recorded.wall += time.perf_counter() - begin
        if recorded.wall > states.LONGEST:
            raise Refused(f"over {states.LONGEST} s")
        steps += count
        recorded.contacts.append(contacts(mujoco, model, data, numbers, setting.step) if count else [])
        # Poses and velocities in the world are those before the step until they are asked for again.
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        mujoco.mj_comVel(model, data)
        recorded.times.append(steps * setting.step)
        for body in scene.bodies:
            recorded.tracks[body.name].append(state(mujoco, model, data, body.name))
    return recorded
