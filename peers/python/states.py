"""What an engine has recorded, and what is computed from that alone: energies, residuals, files.

A state is position, quaternion (w, x, y, z), linear and angular velocity of the centre of mass: 13 numbers in the world's axes.
"""

import csv
import gzip
import io
import math
from dataclasses import dataclass, field

# A run may take so long, s.
LONGEST = 60
COLUMNS = ["px", "py", "pz", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "wx", "wy", "wz"]


@dataclass
class Contact:
    """A contact with the impulse on A (N s) of the last step of `h` (s); bodies by number, none for the world."""

    a: int | None
    b: int | None
    point: list
    normal: list
    impulse: list
    gap: float
    h: float
    # From the poses that point and gap are of to the states after the step, s.
    back: float = 0.0


@dataclass
class Recorded:
    """States at times (s) by name of body, contacts at some of them, seconds of computing, the residual that the engine tells itself."""

    times: list = field(default_factory=list)
    tracks: dict = field(default_factory=dict)
    contacts: list = field(default_factory=list)
    wall: float = math.nan
    own_residual: float | None = None


class Refused(Exception):
    """An engine has no such effect, or does not run the scene."""


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def into_body(q, v):
    """A vector of the world in axes of the body."""
    w, u = q[0], [-x for x in q[1:4]]
    t = [2 * x for x in cross(u, v)]
    return [a + w * b + c for a, b, c in zip(v, t, cross(u, t))]


def energy(scene, states):
    """Kinetic and potential, J, of states by name."""
    total = 0.0
    for body in scene.bodies:
        s = states[body.name]
        turn = into_body(s[3:7], s[10:13])
        total += 0.5 * body.mass * dot(s[7:10], s[7:10]) - body.mass * dot(scene.gravity, s[:3]) - dot(body.force, s[:3])
        total += 0.5 * sum(i * w * w for i, w in zip(body.moments(), turn))
    return total


def gained(scene, recorded):
    """Energy made (positive) or lost beyond what the exact motion loses, of the largest energy of the motion;
    none where that is not known in closed form."""
    if scene.lost is None:
        return None
    first, last = ({name: track[k] for name, track in recorded.tracks.items()} for k in (0, -1))
    return (energy(scene, last) - energy(scene, first) + scene.lost) / scene.scale


def residual(scene, recorded):
    """The residual of Coulomb's law in the middle of the samples and at its largest, or what the engine tells itself.

    As in peers/benches/support/scale/judge.rs: the distance of an impulse from its projection onto the cone of friction (De Saxce), in units
    of the largest impulse of the sample, with the rate or the gap as the normal part, whichever the engine keeps better.
    """
    if scene.restitution > 0 or not scene.floor:
        return None
    found = []
    for k, contacts in enumerate(recorded.contacts):
        largest = max((math.hypot(*c.impulse) for c in contacts), default=0.0)
        if largest > 0:
            states = [recorded.tracks[body.name][k] for body in scene.bodies]
            found.append(max(of_contact(scene, states, c, 1e-12 * largest) for c in contacts) / largest)
    found.sort()
    return (found[len(found) // 2], found[-1]) if found else None


def of_contact(scene, states, contact, nothing):
    n, inverse, u = contact.normal, 0.0, [0.0] * 3
    for number, sign in ((contact.a, 1), (contact.b, -1)):
        if number is None:
            continue
        body, s = scene.bodies[number], states[number]
        arm = [x - (y - contact.back * v) for x, y, v in zip(contact.point, s[:3], s[7:10])]
        lever = into_body(s[3:7], cross(arm, n))
        inverse += 1 / body.mass + sum(x * x / i for x, i in zip(lever, body.moments()))
        u = [a + sign * (v + w) for a, v, w in zip(u, s[7:10], cross(s[10:13], arm))]
    rate = dot(n, u)
    slip = [x - rate * y for x, y in zip(u, n)]
    pressing = dot(n, contact.impulse)
    along = [x - pressing * y for x, y in zip(contact.impulse, n)]

    def distance(rate):
        if abs(pressing) <= nothing and rate >= 0:
            return 0.0
        normal = pressing - (rate + scene.friction * math.hypot(*slip)) / inverse
        tangent = [x - y / inverse for x, y in zip(along, slip)]
        length = math.hypot(*tangent)
        if length > scene.friction * normal:
            edge = max(0.0, (normal + scene.friction * length) / (1 + scene.friction**2))
            tangent = [x * (scene.friction * edge / length if length > 0 else 0.0) for x in tangent]
            normal = edge
        return math.hypot(pressing - normal, math.dist(along, tangent))

    return min(distance(rate), distance((contact.gap + contact.back * rate) / contact.h))


def apart(one, other):
    """The largest distance of two runs at their ends, m."""
    return max(math.dist(track[-1][:3], other.tracks[name][-1][:3]) for name, track in one.tracks.items())


def file_name(scene, engine):
    return f"{scene.name}__{engine}.csv.gz".replace(" ", "-").replace("'", "").replace(",", "")


def keep(folder, scene, engine, recorded, every=1):
    """Writes states, of every so many samples and the last ones that an error is computed of."""
    folder.mkdir(parents=True, exist_ok=True)
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["t", "body", *COLUMNS])
    count = len(recorded.times)
    for k, t in enumerate(recorded.times):
        if k % every == 0 or k in (count - 1, count - 21):
            writer.writerows([repr(t), name, *map(repr, track[k])] for name, track in recorded.tracks.items())
    # Without the time of writing, so that the same states are the same file.
    (folder / file_name(scene, engine)).write_bytes(gzip.compress(text.getvalue().encode(), mtime=0))


def read(folder, scene, engine):
    """Reads what was kept."""
    recorded = Recorded(tracks={body.name: [] for body in scene.bodies})
    with gzip.open(folder / file_name(scene, engine), "rt", newline="") as file:
        for row in csv.DictReader(file):
            t = float(row["t"])
            if not recorded.times or recorded.times[-1] != t:
                recorded.times.append(t)
            recorded.tracks[row["body"]].append([float(row[key]) for key in COLUMNS])
    return recorded
