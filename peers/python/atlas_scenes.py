"""Further results of the atlas as scenes for all engines. Each error is of the state at the end, against a closed form or 1-D map."""

import math

from scenes import Body, G, Hinge, Scene, last, moved
from states import dot, into_body

TALL = 0.25


def end(tracks, name):
    """The last state of a body."""
    return tracks[name][-1]


def box_on(name, duration, what, error, friction, **more):
    """A flat box on the floor."""
    parts = {key: more.pop(key) for key in ("velocity", "force") if key in more}
    box = Body("box", "box", (0.4, 0.4, 0.1), 1.0, (0, 0, 0.05), **parts)
    return Scene(name, duration, [box], error, what, friction, **more)


def tilted(angle):
    """Gravity on a slope that falls along x."""
    return (G * math.sin(angle), 0.0, -G * math.cos(angle))


def way(times, tracks):
    return moved(tracks)


def slope():
    """Steeper by 20 degrees is 0.36397 of friction: 0.37 holds."""
    return box_on("box on a slope", 10.0, "how far it has moved in 10 s, m", way, 0.37, gravity=tilted(math.radians(20)))


def pushed():
    return box_on("pushed box", 10.0, "how far it has moved in 10 s, m", way, 0.5 * (1 + 1e-9), force=(0.5 * G, 0.0, 0.0))


def puck():
    """v (1 + cos phi) is kept on a slope as steep as friction, phi from downhill."""
    angle = math.radians(30)

    def error(times, tracks):
        v = end(tracks, "box")[7:10]
        return abs(math.hypot(*v) + v[0] - 1.0)

    what = "speed and speed downhill together, after 1 s, of the speed of the push"
    return box_on("puck on a slope", 1.0, what, error, math.tan(angle), velocity=(0.0, 1.0, 0.0), gravity=tilted(angle), lost=None, scale=0.5)


def between_fingers(name, held, friction, force, wide):
    """A body between two fingers that move along x alone."""
    fingers = [
        Body(f"{side} finger", "box", (0.02, 0.02, 0.06), 0.2, (sign * (0.5 * wide + 0.01), 0, 0.1), force=(-sign * force, 0, 0), along_x=True)
        for side, sign in (("left", -1), ("right", 1))
    ]

    def error(times, tracks):
        return abs(last(tracks[held.name])[2] - 0.1)

    return Scene(name, 10.0, [held, *fingers], error, "how far it has sunk in 10 s, m", friction, floor=False, scale=held.mass * G * 0.1)


def grasp(force, name):
    cube = Body("cube", "box", (0.05, 0.05, 0.05), 1.0, (0, 0, 0.1))
    return between_fingers(name, cube, 0.4905 * (1 + 1e-9), force, 0.05)


def pinched():
    capsule = Body("capsule", "capsule", (0.01, 0.04), 0.045, (0, 0, 0.1))
    return between_fingers("capsule pinched at 45 times its weight", capsule, 1.0, 10.0, 0.02)


def stack(name, duration, places, edge=0.0):
    """Bricks by (x of the middle, storey) on a table that ends at x = `edge`, without friction."""
    bricks = [Body(f"brick {k}", "box", (1, 0.5, TALL), 1.0, (x, 0, TALL * (row + 0.5))) for k, (x, row) in enumerate(places)]
    table = Body("table", "box", (8, 1, 1), 1.0, (edge - 4, 0, -0.5), fixed=True)

    def error(times, tracks):
        return moved(tracks) / TALL

    what = f"how far a brick has moved after {duration:.0f} s, of its height"
    return Scene(name, duration, [table, *bricks], error, what, floor=False, scale=len(bricks) * G * TALL)


def overhang_3():
    return stack("three blocks hang over", 5.0, [(0.0, 0), (-0.5, 1), (0.5, 1)])


def overhang_4():
    """As the scene overhang-4 that ships."""
    return stack("four blocks hang over", 5.0, OVERHANG_4)


def harmonic(count=20, inside=1e-6):
    """Each brick is out by 1/(2 i) over the next, counted from the top."""
    x, places = 0.5 - inside, []
    for i in range(count, 0, -1):
        x += 0.5 / i if i < count else 0.0
        places.append((x, count - i))
    # The lowest is out over the edge by 1/(2 count).
    shift = -0.5 + 0.5 / count
    return stack("harmonic stack", 5.0, [(x - 0.5 + shift, row) for x, row in places])


def masse():
    v, spin, radius = (2.0, 0.0), (30.0, -60.0, 50.0), 0.0286
    exact = [5 / 7 * v[0] + 2 / 7 * radius * spin[1], 5 / 7 * v[1] - 2 / 7 * radius * spin[0], 0.0]

    def error(times, tracks):
        return math.dist(end(tracks, "ball")[7:10], exact) / v[0]

    ball = Body("ball", "sphere", (radius,), 0.17, (0, 0, radius), (*v, 0.0), angular=spin)
    # What turns about the vertical stays as it is.
    begin = 0.5 * 0.17 * (dot(v, v) + 0.4 * radius**2 * dot(spin[:2], spin[:2]))
    lost = begin - 0.7 * 0.17 * dot(exact, exact)
    return Scene("masse", 1.0, [ball], error, "velocity once it rolls, of that at the start", 0.2, lost=lost, scale=begin)


def race():
    """Round bodies with the moments of a ball, a cylinder and a ring roll down 30 degrees."""
    angle, radius, kinds = math.radians(30), 0.1, {"ball": 0.4, "cylinder": 0.5, "ring": 1.0}

    def error(times, tracks):
        exact = {name: G * math.sin(angle) / (1 + kind) * times[-1] for name, kind in kinds.items()}
        return max(abs(end(tracks, name)[7] - speed) / speed for name, speed in exact.items())

    bodies = [
        Body(name, "sphere", (radius,), 1.0, (0, k, radius), inertia=(kind * radius**2,) * 3)
        for k, (name, kind) in enumerate(kinds.items())
    ]
    return Scene("rolling race", 2.0, bodies, error, "speeds after 2 s, of themselves", 0.6, gravity=tilted(angle), scale=3 * G)


def rocking():
    """Housner: an impact keeps r = 1 - 1.5 sin^2 alpha of the spin, and r^2 of the energy above rest."""
    half, high = 0.25, 1.0
    alpha = math.atan(half / high)
    theta, kept = 0.5 * alpha, (1 - 1.5 * math.sin(alpha) ** 2) ** 2
    c, s = math.cos(theta), math.sin(theta)
    place = (half - half * c + high * s, 0, half * s + high * c)
    above = G * (place[2] - high)
    block = Body("block", "box", (2 * half, 0.5, 2 * high), 1.0, place, about_y=theta)

    def error(times, tracks):
        state = end(tracks, "block")
        turn = into_body(state[3:7], state[10:13])
        moving = 0.5 * dot(state[7:10], state[7:10]) + 0.5 * sum(i * w * w for i, w in zip(block.moments(), turn))
        return abs((moving + G * (state[2] - high)) / above - kept)

    what = "energy above rest after one impact, of that before it"
    return Scene("rocking block", 0.8, [block], error, what, 1.0, lost=(1 - kept) * above, scale=above)


def collisions(x, v, e, until, wall=None):
    """Positions and velocities of equal balls of diameter 1 on a line, from impact to impact; `wall` holds the first at its left."""
    x, v, t = list(x), list(v), 0.0
    while True:
        found = [((x[k + 1] - x[k] - 1) / (v[k] - v[k + 1]), k) for k in range(len(x) - 1) if v[k] > v[k + 1]]
        if wall is not None and v[0] < 0:
            found.append(((x[0] - wall - 0.5) / -v[0], -1))
        first = min(found, default=(math.inf, 0))
        step = min(max(first[0], 0.0), until - t)
        x, t = [a + step * b for a, b in zip(x, v)], t + step
        if t >= until or first[0] == math.inf:
            return x, v
        k = first[1]
        if k < 0:
            v[0] *= -e
        else:
            middle, half = 0.5 * (v[k] + v[k + 1]), 0.5 * e * (v[k] - v[k + 1])
            v[k], v[k + 1] = middle - half, middle + half


def on_a_line(name, duration, x, v, e, exact=None, wall=False):
    if exact is None:
        exact = collisions(x, v, e, duration, 0.0 if wall else None)[1]

    def error(times, tracks):
        return max(abs(end(tracks, f"ball {k}")[7] - speed) for k, speed in enumerate(exact))

    bodies = [Body(f"ball {k}", "sphere", (0.5,), 1.0, (a, 0, 0), (b, 0, 0)) for k, (a, b) in enumerate(zip(x, v))]
    scale = 0.5 * sum(b * b for b in v)
    lost = scale - 0.5 * sum(b * b for b in exact)
    what = "velocity of a ball after the last impact, m/s"
    return Scene(name, duration, bodies, error, what, restitution=e, wall=wall, floor=False, gravity=(0, 0, 0), lost=lost, scale=scale)


def elastic():
    drop, bounces = 4.9, 10

    def error(times, tracks):
        return abs(last(tracks["ball"])[2] - 5.0) / drop

    ball = Body("ball", "sphere", (0.1,), 1.0, (0, 0, 5.0))
    # From the top down and up again, ten times.
    duration = bounces * 2 * math.sqrt(2 * drop / G)
    what = "height after ten bounces, of the drop"
    return Scene("elastic ball", duration, [ball], error, what, restitution=1.0, scale=G * drop)


def rotor(name, moments, spin, duration, error, what, mass=1.0, velocity=(0.0, 0.0, 0.0), gravity=(0.0, 0.0, 0.0)):
    body = Body("rotor", "box", (1, 1, 1), mass, (0, 0, 0), velocity, inertia=moments, angular=spin)
    scale = 0.5 * sum(i * w * w for i, w in zip(moments, spin)) + 0.5 * mass * dot(velocity, velocity)
    return Scene(name, duration, [body], error, what, floor=False, gravity=gravity, smooth=True, scale=scale)


def spin_of(tracks):
    """In axes of the body, rad/s."""
    state = end(tracks, "rotor")
    return into_body(state[3:7], state[10:13])


def wing_nut():
    moments = (1.0, 2.0, 3.0)

    def error(times, tracks):
        w = spin_of(tracks)
        rate = (moments[2] - moments[0]) * w[2] * w[0] / moments[1]
        return abs(times[-1] + w[1] / -rate - 17.036614025327829)

    what = "time of the second turn over, s"
    return rotor("wing nut", moments, (0.01, 2.0, 0.01), 17.036614025327829, error, what)


def euler(moments, spin, duration, steps=20000):
    """Euler's equations by Runge and Kutta, extrapolated from two counts of steps."""
    coarse, fine = (runge_kutta(moments, spin, duration, count) for count in (steps // 2, steps))
    return [y + (y - x) / 15 for x, y in zip(coarse, fine)]


def runge_kutta(moments, spin, duration, steps):
    a, b, c = moments

    def rate(w):
        return ((b - c) * w[1] * w[2] / a, (c - a) * w[2] * w[0] / b, (a - b) * w[0] * w[1] / c)

    h, w = duration / steps, spin
    for _ in range(steps):
        k1 = rate(w)
        k2 = rate([x + 0.5 * h * y for x, y in zip(w, k1)])
        k3 = rate([x + 0.5 * h * y for x, y in zip(w, k2)])
        k4 = rate([x + h * y for x, y in zip(w, k3)])
        w = [x + h * (p + 2 * q + 2 * r + s) / 6 for x, p, q, r, s in zip(w, k1, k2, k3, k4)]
    return w


def brick():
    moments, spin, duration = (1.894220e-3, 6.211019e-3, 7.194665e-3), tuple(math.radians(x) for x in (10.0, 20.0, 30.0)), 30.0

    def error(times, tracks):
        exact = euler(moments, spin, times[-1])
        return max(abs(math.degrees(x - y)) for x, y in zip(spin_of(tracks), exact))

    return rotor("tumbling brick", moments, spin, duration, error, "spin after 30 s, degrees/s")


def momentum(state, moments):
    """Angular momentum in the world."""
    into = [i * w for i, w in zip(moments, into_body(state[3:7], state[10:13]))]
    w, x, y, z = state[3:7]
    return into_body((w, -x, -y, -z), into)


def tumbling_box():
    moments = (9.7 / 12, 8.2 / 12, 1.7 / 12)

    def error(times, tracks):
        first, final = (momentum(tracks["rotor"][k], moments) for k in (0, -1))
        return math.dist(first, final) / math.hypot(*first)

    what = "angular momentum after 10 s, of itself"
    return rotor("tumbling box", moments, (0.1, 5.0, 0.1), 10.0, error, what, 10.0, (-2.0, 2.0, 8.0), (0.0, 0.0, -9.8))


def rod_on_a_hinge(name, length, duration, error, what):
    """A thin rod that is let go level."""
    about = length**2 / 12
    rod = Body("rod", "box", (length, 0.02, 0.02), 1.0, (0.5 * length, 0, 0), inertia=(1e-3, about, about))
    return Scene(name, duration, [rod], error, what, hinges=[Hinge("rod", None, (0, 0, 0))], floor=False, smooth=True, scale=0.5 * G * length)


def pendulum():
    """As long as a simple one of 1 m; it passes the bottom after 5/4 of a period. K(sin 45 degrees) is 1.8540746773013719."""
    duration = 5 * 1.8540746773013719 / math.sqrt(G)

    def error(times, tracks):
        state = end(tracks, "rod")
        # A sample may be some of a step off, and there it moves evenly.
        return abs(state[0] + state[7] * (duration - times[-1])) / 0.75

    return rod_on_a_hinge("pendulum at 90 degrees", 1.5, duration, error, "angle at the bottom after 5/4 periods, rad")


def falling_rod():
    exact, quarter = math.sqrt(3 * G), 1.8540746773013719 * math.sqrt(2 / (3 * G))

    def error(times, tracks):
        state = end(tracks, "rod")
        # Of the sample, which may be some of a step off, by what is left to fall.
        left = 3 * G * (1 + 2 * state[2])
        return abs(math.sqrt(dot(state[10:13], state[10:13]) + left) - exact) / exact

    return rod_on_a_hinge("falling rod", 1.0, quarter, error, "spin at the bottom, of itself")


def catenary():
    count, length, mass, pull = 20, 0.1, 0.1, 3.20007302605559
    x, z, bodies, hinges = 0.0, 0.0, [], []
    for k in range(count):
        angle = math.atan(mass * G / pull * (k - 0.5 * (count - 1)))
        c, s = math.cos(angle), math.sin(angle)
        hinges.append(Hinge(f"rod {k}", f"rod {k - 1}" if k else None, (x, 0, z)))
        place = (x + 0.5 * length * c, 0, z + 0.5 * length * s)
        bodies.append(Body(f"rod {k}", "box", (length, 0.01, 0.01), mass, place, about_y=-angle))
        x, z = x + length * c, z + length * s
    hinges.append(Hinge(f"rod {count - 1}", None, (x, 0, z)))
    what = "how far a rod of the hung chain has moved in 5 s, m"
    return Scene("hung chain", 5.0, bodies, way, what, hinges=hinges, floor=False, scale=count * mass * G * 0.73)


OVERHANG_4 = [(0.02144660940672627, 0), (-0.6632524218523383, 1), (0.6678932188134525, 1), (-0.026087406367840224, 2)]

ATLAS = [
    slope(),
    pushed(),
    puck(),
    grasp(10.0, "grasp"),
    grasp(100.0, "grasp at ten times its force"),
    pinched(),
    overhang_3(),
    overhang_4(),
    harmonic(),
    masse(),
    race(),
    rocking(),
    on_a_line("cradle of three", 2.0, (-2.0, 0.0, 1.0), (1.0, 0.0, 0.0), 1.0, (0.0, 0.0, 1.0)),
    on_a_line("three soft balls", 15.0, (-2.0, 0.0, 1.5), (1.0, 0.0, 0.0), 0.1),
    on_a_line("two soft balls at a wall", 20.0, (1.0, 2.5), (-1.0, -1.0), 0.3, wall=True),
    elastic(),
    wing_nut(),
    brick(),
    tumbling_box(),
    pendulum(),
    falling_rod(),
    catenary(),
]
