//! An oracle for impacts on springs: two balls in a plane, or a ball and a plane, integrated by RK4 in [`STEPS`] steps
//! of one length through the contact, with the begin, the end, and every change of mode of friction located by
//! bisection. It shares no code with what it judges: two positions, two velocities and two spins, one number for the
//! tangential force.
//!
//! With the overlap d, its rate, the slip u of the first ball over the second one, and the force T against it:
//!
//! ```text
//! F = k d^(3/2) (1 + a d'),    stick: T' = k_t u + T min(d'/(2 d), 0),    slide: T = +- mu F,    k_t = c sqrt(d)
//! ```
//!
//! It sticks where |T| < mu F, and a sliding contact sticks when the spring would give way backwards. Source:
//! docs/REFERENCES.md, Chung and Ooi 2011; Mindlin and Deresiewicz 1953.

/// Steps through a contact that lasts as long as an elastic one.
const STEPS: f64 = 200_000.0;

/// Halvings in which an instant is located within a step.
const HALVINGS: u32 = 60;

/// Hunt and Crossley's number is above this part of 1 - e, where its equation has no other root (no unit).
const LEAST_DAMPING: f64 = 1e-3;

/// First guess of the time to the begin of the contact, s; it is doubled.
const FIRST_TIME_S: f64 = 1e-3;

/// Part of the time in which the overlap changes over which its rate is differentiated (no unit).
const DIFFERENCE_PART: f64 = 1e-4;

/// A ball in the plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ball {
    pub(super) radius: f64,
    pub(super) mass: f64,
    pub(super) position: [f64; 2],
    pub(super) velocity: [f64; 2],
    /// Anticlockwise, rad/s.
    pub(super) spin: f64,
}

/// What two materials do at a contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Contact {
    /// E* and G*, Pa.
    normal: f64,
    shear: f64,
    /// a times the speed of approach (no unit).
    damping: f64,
    friction: f64,
}

impl Contact {
    /// Of two elastic materials (Young's modulus, Poisson's ratio).
    pub(super) fn of(materials: [[f64; 2]; 2], restitution: f64, friction: f64) -> Self {
        let (mut normal, mut shear) = (0.0, 0.0);
        for [young, poisson] in materials {
            normal += (1.0 - poisson * poisson) / young;
            shear += 2.0 * (2.0 - poisson) * (1.0 + poisson) / young;
        }
        Self { normal: 1.0 / normal, shear: 1.0 / shear, damping: damping_of(restitution), friction }
    }
}

/// Hunt and Crossley's number y, from ln((1 + y)/(1 - e y)) = (1 + e) y, by Newton's method from above.
fn damping_of(e: f64) -> f64 {
    if e == 1.0 {
        return 0.0;
    }
    let value = |y: f64| ((1.0 + y) / (1.0 - e * y)).ln() - (1.0 + e) * y;
    let (mut low, mut high) = (LEAST_DAMPING * (1.0 - e), 1.0 / e);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if value(middle) < 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// What friction does.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Mode {
    Stick,
    /// T has this sign.
    Slide(f64),
}

/// Positions, velocities and spins of both, and T.
type Numbers = [f64; 11];

/// Two balls on their way to each other.
#[derive(Debug, Clone, Copy)]
pub(super) struct Collision {
    balls: [Ball; 2],
    contact: Contact,
    is_plane: bool,
    stiffness: f64,
    tangential: f64,
    a: f64,
}

impl Collision {
    /// Two balls.
    pub(super) fn of_balls(balls: [Ball; 2], contact: Contact) -> Self {
        let radius = 1.0 / (1.0 / balls[0].radius + 1.0 / balls[1].radius);
        Self::new(balls, contact, radius)
    }

    /// A ball above the plane of x.
    pub(super) fn with_plane(ball: Ball, contact: Contact) -> Self {
        let still =
            Ball { radius: 0.0, mass: f64::INFINITY, position: [ball.position[0], 0.0], velocity: [0.0; 2], spin: 0.0 };
        Self { is_plane: true, ..Self::new([ball, still], contact, ball.radius) }
    }

    fn new(balls: [Ball; 2], contact: Contact, radius: f64) -> Self {
        let stiffness = 4.0 / 3.0 * contact.normal * radius.sqrt();
        let tangential = 8.0 * contact.shear * radius.sqrt();
        Self { balls, contact, is_plane: false, stiffness, tangential, a: 0.0 }
    }

    /// Both after the impact.
    pub(super) fn after(mut self) -> (Ball, Ball) {
        let mut y = self.numbers();
        // To the begin of the contact, at constant velocities.
        let (mut low, mut high) = (0.0, FIRST_TIME_S);
        let moved = |y: &Numbers, t: f64| {
            let mut moved = *y;
            for k in [0, 1, 3, 4] {
                let velocity = y[if k < 2 { k + 5 } else { k + 4 }];
                moved[k] += t * velocity;
            }
            moved
        };
        while self.state(&moved(&y, high)).depth < 0.0 && high < 1e3 {
            high *= 2.0;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if self.state(&moved(&y, middle)).depth < 0.0 { low = middle } else { high = middle }
        }
        y = moved(&y, high);
        let start = self.state(&y);
        self.a = self.contact.damping / start.rate;
        let inverse = 1.0 / self.balls[0].mass + 1.0 / self.balls[1].mass;
        let depth = (1.25 * start.rate * start.rate / (inverse * self.stiffness)).powf(0.4);
        let h = 2.943 * depth / (start.rate * STEPS);
        // At the begin T and mu F grow as d^(3/2): the ratio of their factors decides.
        let grows = 2.0 / 3.0 * self.tangential * start.slip.abs() / start.rate;
        let limit = self.contact.friction * self.stiffness * (1.0 + self.a * start.rate);
        let mut mode = if grows > limit { Mode::Slide(start.slip.signum()) } else { Mode::Stick };
        loop {
            let next = self.step(&y, h, mode);
            if self.event(&next, mode) >= 0.0 {
                y = next;
                continue;
            }
            let (mut low, mut high) = (0.0, h);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                if self.event(&self.step(&y, middle, mode), mode) >= 0.0 { low = middle } else { high = middle }
            }
            y = self.step(&y, high, mode);
            let at = self.state(&y);
            if at.depth <= 0.0 {
                return self.balls_of(&y);
            }
            mode = match mode {
                Mode::Stick => Mode::Slide(y[10].signum()),
                Mode::Slide(sign) => {
                    y[10] = sign * self.limit(&at);
                    Mode::Stick
                }
            };
        }
    }

    /// Positive while a mode lasts.
    fn event(&self, y: &Numbers, mode: Mode) -> f64 {
        let at = self.state(y);
        if at.depth <= 0.0 {
            return -1.0;
        }
        match mode {
            Mode::Stick => self.limit(&at) - y[10].abs(),
            Mode::Slide(sign) => {
                // The rate at which a spring that holds would load, less that of the limit.
                let limit = self.limit(&at);
                let holding =
                    self.tangential * at.depth.sqrt() * at.slip * sign + limit * (0.5 * at.rate / at.depth).min(0.0);
                holding - self.limit_rate(y, &at, mode)
            }
        }
    }

    fn limit(&self, at: &State) -> f64 {
        self.contact.friction * self.force(at)
    }

    fn force(&self, at: &State) -> f64 {
        self.stiffness * at.depth.max(0.0).powf(1.5) * (1.0 + self.a * at.rate)
    }

    /// Rate of mu F, from the acceleration of the overlap.
    fn limit_rate(&self, y: &Numbers, at: &State, mode: Mode) -> f64 {
        let rates = self.rates(y, mode);
        let moved = |h: f64| {
            let mut moved = *y;
            for (number, rate) in moved.iter_mut().zip(&rates) {
                *number += h * rate;
            }
            self.state(&moved).rate
        };
        // The second derivative of the overlap by a difference over a time in which it changes by a thousandth.
        let h = DIFFERENCE_PART * at.depth / (at.rate.abs() + (at.depth * self.force(at) / self.balls[0].mass).sqrt());
        let acceleration = (moved(h) - moved(-h)) / (2.0 * h);
        let root = at.depth.sqrt();
        let stiffness = self.contact.friction * self.stiffness;
        stiffness * (1.5 * root * at.rate * (1.0 + self.a * at.rate) + at.depth * root * self.a * acceleration)
    }

    fn numbers(&self) -> Numbers {
        let [one, other] = self.balls;
        [
            one.position[0],
            one.position[1],
            0.0,
            other.position[0],
            other.position[1],
            one.velocity[0],
            one.velocity[1],
            other.velocity[0],
            other.velocity[1],
            one.spin,
            0.0,
        ]
        .map(|number| number + 0.0)
    }

    fn balls_of(&self, y: &Numbers) -> (Ball, Ball) {
        let [one, other] = self.balls;
        let spin = other.spin + y[2];
        (
            Ball { position: [y[0], y[1]], velocity: [y[5], y[6]], spin: y[9], ..one },
            Ball { position: [y[3], y[4]], velocity: [y[7], y[8]], spin, ..other },
        )
    }

    fn state(&self, y: &Numbers) -> State {
        let spin = self.balls[1].spin + y[2];
        if self.is_plane {
            let lever = self.balls[0].radius;
            return State {
                depth: lever - y[1],
                rate: -y[6],
                slip: y[5] + y[9] * lever,
                normal: [0.0, 1.0],
                levers: [lever, 0.0],
            };
        }
        let (dx, dy) = (y[0] - y[3], y[1] - y[4]);
        let distance = dx.hypot(dy);
        let normal = [dx / distance, dy / distance];
        let along = [normal[1], -normal[0]];
        let (vx, vy) = (y[5] - y[7], y[6] - y[8]);
        let depth = self.balls[0].radius + self.balls[1].radius - distance;
        let levers = [self.balls[0].radius - 0.5 * depth, self.balls[1].radius - 0.5 * depth];
        let slip = vx * along[0] + vy * along[1] + y[9] * levers[0] + spin * levers[1];
        State { depth, rate: -(vx * normal[0] + vy * normal[1]), slip, normal, levers }
    }

    fn rates(&self, y: &Numbers, mode: Mode) -> Numbers {
        let at = self.state(y);
        let force = self.force(&at);
        let friction = match mode {
            Mode::Stick => y[10],
            Mode::Slide(sign) => sign * self.limit(&at),
        };
        let along = [at.normal[1], -at.normal[0]];
        let on_first = [0, 1].map(|k| force * at.normal[k] - friction * along[k]);
        let [one, other] = self.balls;
        let moment = |ball: &Ball| 0.4 * ball.mass * ball.radius * ball.radius;
        let second = if self.is_plane { 0.0 } else { 1.0 / other.mass };
        let turned = if self.is_plane { 0.0 } else { -friction * at.levers[1] / moment(&other) };
        let fall = if at.depth > 0.0 { (0.5 * at.rate / at.depth).min(0.0) } else { 0.0 };
        let loaded = match mode {
            Mode::Stick => self.tangential * at.depth.max(0.0).sqrt() * at.slip + y[10] * fall,
            Mode::Slide(_) => 0.0,
        };
        [
            y[5],
            y[6],
            turned,
            y[7],
            y[8],
            on_first[0] / one.mass,
            on_first[1] / one.mass,
            -on_first[0] * second,
            -on_first[1] * second,
            -friction * at.levers[0] / moment(&one),
            loaded,
        ]
    }

    fn step(&self, y: &Numbers, h: f64, mode: Mode) -> Numbers {
        let add = |rates: &Numbers, h: f64| {
            let mut sum = *y;
            sum.iter_mut().zip(rates).for_each(|(number, rate)| *number += h * rate);
            sum
        };
        let k1 = self.rates(y, mode);
        let k2 = self.rates(&add(&k1, 0.5 * h), mode);
        let k3 = self.rates(&add(&k2, 0.5 * h), mode);
        let k4 = self.rates(&add(&k3, h), mode);
        let mut mean = [0.0; 11];
        for k in 0..11 {
            mean[k] = (k1[k] + 2.0 * (k2[k] + k3[k]) + k4[k]) / 6.0;
        }
        add(&mean, h)
    }
}

/// A contact in a state.
#[derive(Debug, Clone, Copy)]
struct State {
    depth: f64,
    rate: f64,
    slip: f64,
    /// From the second to the first.
    normal: [f64; 2],
    levers: [f64; 2],
}
