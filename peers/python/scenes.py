"""Scenes with exact answers, as plain data that every engine is built from (SI units)."""

import math
from dataclasses import dataclass, field

G = 9.81


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
    angular: tuple = (0.0, 0.0, 0.0)
    # A constant force at the centre of mass, N.
    force: tuple = (0.0, 0.0, 0.0)
    # One that never moves, and one that moves along x alone.
    fixed: bool = False
    along_x: bool = False

    def moments(self):
        """About its own axes, kg m^2: those given, or of a solid of even density."""
        if self.inertia:
            return self.inertia
        if self.shape == "sphere":
            return (0.4 * self.mass * self.size[0] ** 2,) * 3
        if self.shape == "box":
            squares = [s * s for s in self.size]
            return tuple(self.mass * (sum(squares) - squares[k]) / 12 for k in range(3))
        radius, height = self.size
        across = self.mass * (3 * radius**2 + height**2) / 12
        return (across, across, 0.5 * self.mass * radius**2)

    def quaternion(self):
        """w, x, y, z."""
        return (math.cos(self.about_y / 2), 0.0, math.sin(self.about_y / 2), 0.0)


@dataclass
class Hinge:
    """A hinge along y at an anchor (m) between bodies by name; `on` none is the world."""

    body: str
    on: str | None
    anchor: tuple


@dataclass
class Scene:
    """Bodies above a floor at z = 0. `error` is of times and states (position, quaternion, velocities) of the bodies by name."""

    name: str
    duration: float
    bodies: list
    error: object
    what: str
    friction: float = 0.0
    restitution: float = 0.0
    wall: bool = False
    hinges: list = field(default_factory=list)
    floor: bool = True
    # m/s^2.
    gravity: tuple = (0.0, 0.0, -G)
    # Nothing touches and no loop is closed, so that an integrator of high order can be asked for.
    smooth: bool = False
    # What the exact motion loses (none: not in closed form), and the largest energy of the motion, J.
    lost: float = 0.0
    scale: float = 1.0


def last(track):
    """The last position."""
    return track[-1][:3]


def moved(tracks):
    """How far a body has moved in all, m."""
    return max(math.dist(track[0][:3], last(track)) for track in tracks.values())


def velocity(track, times, at):
    """Of a body that moves evenly there, from two samples."""
    k, j = (min(range(len(times)), key=lambda i: abs(times[i] - t)) for t in (at, 0.9 * at))
    return [(track[k][i] - track[j][i]) / (times[k] - times[j]) for i in range(3)]


def bounce(e=0.8, drop=1.0, radius=0.1, end=5.0):
    def height(t):
        fall = math.sqrt(2 * drop / G)
        if t < fall:
            return drop - 0.5 * G * t * t
        t, speed = t - fall, G * fall
        while speed > 1e-9:
            speed *= e
            flight = 2 * speed / G
            if t < flight:
                return speed * t - 0.5 * G * t * t
            t -= flight
        return 0.0

    def error(times, tracks):
        at = [min(range(len(times)), key=lambda i: abs(times[i] - t)) for t in (2.0, end)]
        return max(abs(tracks["ball"][k][2] - radius - height(times[k])) for k in at) / drop

    ball = Body("ball", "sphere", (radius,), 1.0, (0, 0, radius + drop))
    what = "height after 2 s of bounces, and at rest after 5 s, of the drop"
    return Scene("bounce to rest", end, [ball], error, what, restitution=e, lost=G * drop, scale=G * drop)


def rolling(angle, name):
    speed, radius, friction = 3.0, 0.1, 0.3

    def error(times, tracks):
        found = velocity(tracks["ball"], times, times[-1])
        exact = [5 / 7 * speed * math.cos(angle), 5 / 7 * speed * math.sin(angle), 0]
        return math.dist(found, exact) / speed

    start = (speed * math.cos(angle), speed * math.sin(angle), 0.0)
    ball = Body("ball", "sphere", (radius,), 1.0, (0, 0, radius), start)
    return Scene(name, 1.0, [ball], error, "velocity once it rolls, of that at the start", friction, lost=speed**2 / 7, scale=0.5 * speed**2)


def slide():
    speed, friction, angle = 2.0, 0.3, math.pi / 4

    def error(times, tracks):
        way = speed**2 / (2 * friction * G)
        exact = [way * math.cos(angle), way * math.sin(angle), 0.05]
        return math.dist(last(tracks["box"]), exact) / way

    start = (speed * math.cos(angle), speed * math.sin(angle), 0.0)
    box = Body("box", "box", (0.4, 0.4, 0.1), 1.0, (0, 0, 0.05), start)
    return Scene("slide", 3.0, [box], error, "where it stops, of its way", friction, lost=0.5 * speed**2, scale=0.5 * speed**2)


def diamond():
    places = [(x, row) for row, xs in enumerate([[0], [-0.5, 0.5], [-1, 0, 1], [-1.5, -0.5, 0.5, 1.5]]) for x in xs]
    places += [(x, row + 4) for row, xs in enumerate([[-1, 0, 1], [-0.5, 0.5], [0]]) for x in xs]
    bodies = [
        Body(f"brick {k}", "box", (1, 0.5, 0.25), 1.0, (x, 0, 0.125 + 0.25 * row)) for k, (x, row) in enumerate(places)
    ]

    def error(times, tracks):
        return moved(tracks) / 0.25

    return Scene("diamond-4", 10.0, bodies, error, "how far a brick has moved after 10 s, of its height", scale=16 * G * 0.875)


def ladder():
    length, radius, start = 2.0, 0.02, math.radians(60)

    # At the end it lies on the floor and slides: what it fell is lost, but for its speed along the floor.
    speed, high = math.sqrt(G * length) * math.sin(start) ** 1.5 / 3, 0.5 * G * length * math.sin(start)

    def error(times, tracks):
        return abs(velocity(tracks["ladder"], times, times[-1])[0] - speed) / speed

    centre = (0.5 * length * math.cos(start) + radius, 0, 0.5 * length * math.sin(start) + radius)
    # Along its z axis; the upper end leans on the wall at x = 0.
    across = length**2 / 12
    rod = Body("ladder", "capsule", (radius, length), 1.0, centre, about_y=start - math.pi / 2, inertia=(across, across, 1e-3))
    return Scene("ladder", 0.85, [rod], error, "speed along the floor once it has left the wall", wall=True, lost=high - 0.5 * speed**2, scale=high)


def heavy():
    bodies = [
        Body(f"light {x} {y}", "box", (1, 1, 1), 1.0, (1.2 * x, 1.2 * y, 0.5)) for x in (-1, 0, 1) for y in (-1, 0, 1)
    ]
    bodies.append(Body("heavy", "box", (4, 4, 1), 1000.0, (0, 0, 1.5)))

    def error(times, tracks):
        return moved(tracks)

    return Scene("1000 kg on nine boxes", 10.0, bodies, error, "how far a body has moved after 10 s, m", 0.5, scale=1000 * G * 1.5)


def four_bar():
    """Two cranks and a coupler that swing as one pendulum: a'' = -k sin(a), integrated to 1e-12."""
    crank, thick, span, light, heavy_bar, start, end = 0.3, 0.03, 0.5, 0.8, 1.7, 0.9, 4.0
    about_pin = light * (crank**2 + thick**2) / 12 + light * (0.5 * crank) ** 2
    rate = G * crank * (light + heavy_bar) / (2 * about_pin + heavy_bar * crank**2)

    def angle(t):
        steps = max(1, round(t / 5e-4))
        h, a, w = t / steps, start, 0.0
        for _ in range(steps):
            k1, l1 = w, -rate * math.sin(a)
            k2, l2 = w + 0.5 * h * l1, -rate * math.sin(a + 0.5 * h * k1)
            k3, l3 = w + 0.5 * h * l2, -rate * math.sin(a + 0.5 * h * k2)
            k4, l4 = w + h * l3, -rate * math.sin(a + h * k3)
            a, w = a + h * (k1 + 2 * k2 + 2 * k3 + k4) / 6, w + h * (l1 + 2 * l2 + 2 * l3 + l4) / 6
        return a

    def pins(a):
        return crank * math.sin(a), -crank * math.cos(a)

    def error(times, tracks):
        x, z = pins(angle(times[-1]))
        return math.dist(last(tracks["coupler"]), (0.5 * span + x, 0, z)) / crank

    x, z = pins(start)
    bar = (thick, thick, crank)
    bodies = [
        Body("left", "box", bar, light, (0.5 * x, 0, 0.5 * z), about_y=-start),
        Body("coupler", "box", (span, thick, thick), heavy_bar, (0.5 * span + x, 0, z)),
        Body("right", "box", bar, light, (span + 0.5 * x, 0, 0.5 * z), about_y=-start),
    ]
    # The first three are a tree, the last closes the loop.
    hinges = [
        Hinge("left", None, (0, 0, 0)),
        Hinge("coupler", "left", (x, 0, z)),
        Hinge("right", None, (span, 0, 0)),
        Hinge("coupler", "right", (span + x, 0, z)),
    ]
    scale = G * crank * (light + heavy_bar) * (1 - math.cos(start))
    what = "where the coupler is after 4 s, of a crank"
    return Scene("four-bar", end, bodies, error, what, hinges=hinges, floor=False, scale=scale)


def disc():
    """Euler's disc: it rolls on its rim with its centre at rest, and its axis goes round at a rate in closed form."""
    radius, height, mass, lean, end = 0.0375, 0.006, 0.2, math.radians(60), 0.6
    across, axial = mass * (3 * radius**2 + height**2) / 12, 0.5 * mass * radius**2
    sine, cosine = math.sin(lean), math.cos(lean)
    pull = mass * G * (radius * cosine - 0.5 * height * sine)
    rate = math.sqrt(pull / (sine * (across * cosine - 0.5 * axial * height * sine / radius)))
    # From the centre to the contact: it turns about that line.
    away, down = radius * cosine - 0.5 * height * sine, radius * sine + 0.5 * height * cosine
    turn = rate / (down + away * cosine / sine)

    def error(times, tracks):
        w, x, y, z = tracks["disc"][-1][3:7]
        axis = (2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y))
        t = times[-1]
        exact = (sine * math.cos(rate * t), sine * math.sin(rate * t), cosine)
        return 2 * math.asin(min(1.0, 0.5 * math.dist(axis, exact)))

    body = Body("disc", "cylinder", (radius, height), mass, (0, 0, down), about_y=lean, angular=(-turn * away, 0, turn * down))
    what = "direction of its axis after 0.6 s, rad"
    return Scene("Euler's disc", end, [body], error, what, 1.0, scale=mass * G * down)


SCENES = [
    bounce(),
    rolling(0.0, "rolling"),
    rolling(math.pi / 4, "rolling at 45 degrees"),
    slide(),
    diamond(),
    ladder(),
    four_bar(),
    disc(),
    heavy(),
]


def sliding(friction, speed):
    """A flat box that slides: how high it floats."""
    box = Body("box", "box", (1.0, 0.5, 0.1), 1.0, (0, 0, 0.05), (speed, 0.0, 0.0))
    end = 0.25 * speed / (friction * G)

    def error(times, tracks):
        return last(tracks["box"])[2] - 0.05

    return Scene(f"{speed} m/s", min(end, 0.5), [box], error, "height", friction)
