//! Scenes with contact and friction whose motion is known in closed form: of twelve kinds, with parameters drawn from a
//! seed.

use glam::DVec3;
use polhode::spatial::SplitMix64;

/// Scenes of every kind.
const OF_A_KIND: usize = 5;

/// Seed of the parameters.
const SEED: u64 = 36;

/// Gravity, m/s^2: that of a scene that names none.
const G: f64 = 9.81;

/// A scene and its closed form.
pub(crate) struct ClosedForm {
    pub(crate) name: String,
    pub(crate) text: String,
    /// Position of the body `body` after `t` (s), m.
    pub(crate) position: Box<dyn Fn(f64) -> DVec3 + Send + Sync>,
    pub(crate) duration_s: f64,
}

/// The scenes of a draw: every kind with parameters drawn from a seed.
pub(crate) fn corpus(draw: u64) -> Vec<ClosedForm> {
    let mut random = SplitMix64::new(SEED + draw);
    let mut between = move |low: f64, high: f64| low + (high - low) * random.uniform();
    let mut all = Vec::new();
    for number in 0..OF_A_KIND {
        let mut draw = Draw { number, between: &mut between };
        all.extend([
            slide_to_a_stop(&mut draw),
            slide_down(&mut draw),
            pushed(&mut draw),
            landing(&mut draw),
            bounces_to_rest(&mut draw),
            ball_begins_to_roll(&mut draw),
            back_spin(&mut draw),
            rolls_down(&mut draw),
            slips_down(&mut draw),
            cylinder_rolls_down(&mut draw),
            struck_ball(&mut draw),
            oblique_bounce(&mut draw),
        ]);
    }
    all
}

/// Parameters of one scene.
struct Draw<'a> {
    number: usize,
    between: &'a mut dyn FnMut(f64, f64) -> f64,
}

impl Draw<'_> {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        (self.between)(low, high)
    }

    /// A scene of a floor in this material and of what stands in `bodies`.
    fn scene(
        &self,
        kind: &str,
        [friction, restitution]: [f64; 2],
        normal: DVec3,
        duration_s: f64,
        bodies: &str,
        position: impl Fn(f64) -> DVec3 + Send + Sync + 'static,
    ) -> ClosedForm {
        let name = format!("{kind}-{}", self.number);
        let text = format!(
            "format = 1\nname = \"{name}\"\nduration = {duration_s:?}\n[materials.rough]\nfriction = {friction:?}\n\
             restitution = {restitution:?}\n[[bodies]]\nname = \"floor\"\nfixed = true\nmaterial = \"rough\"\n\
             shape.half_space.normal = {}\n{bodies}",
            vector(normal)
        );
        ClosedForm { name, text, position: Box::new(position), duration_s }
    }
}

fn vector(v: DVec3) -> String {
    format!("[{:?}, {:?}, {:?}]", v.x, v.y, v.z)
}

/// Lines of a body in the material of the floor.
fn body(name: &str, shape: &str, position: DVec3, velocity: DVec3, further: &str) -> String {
    format!(
        "[[bodies]]\nname = \"{name}\"\nmass = 1.5\nmaterial = \"rough\"\n{shape}\nposition = {}\nvelocity = {}\n\
         {further}\n",
        vector(position),
        vector(velocity)
    )
}

const CUBE: &str = "shape.box.size = [0.2, 0.2, 0.2]";
const BALL: &str = "shape.sphere.radius = 0.1";

/// Radius of a ball and half the side of a cube, m.
const HALF: f64 = 0.1;

/// Moment of inertia of a ball, of `m r^2`.
const BALL_INERTIA: f64 = 0.4;

/// Distance after `t` of what starts at `speed` and is slowed by `deceleration` until it stops.
fn slowed(speed: f64, deceleration: f64, t: f64) -> f64 {
    let t = t.min(speed / deceleration);
    speed * t - 0.5 * deceleration * t * t
}

fn slide_to_a_stop(draw: &mut Draw<'_>) -> ClosedForm {
    let (friction, speed) = (draw.between(0.1, 0.8), draw.between(1.0, 4.0));
    let angle = draw.between(0.0, std::f64::consts::TAU);
    let along = DVec3::new(angle.cos(), angle.sin(), 0.0);
    // A quarter of the time at rest.
    let duration_s = 4.0 / 3.0 * speed / (friction * G);
    let start = DVec3::Z * HALF;
    let bodies = body("body", CUBE, start, along * speed, "");
    let position = move |t: f64| start + along * slowed(speed, friction * G, t);
    draw.scene("slide to a stop", [friction, 0.0], DVec3::Z, duration_s, &bodies, position)
}

/// Turn about y that lays a cube on a slope of this angle, and the axes along and out of the slope.
fn slope(angle: f64) -> (String, DVec3, DVec3) {
    let turn = format!("rotation_vector = [0.0, {angle:?}, 0.0]");
    (turn, DVec3::new(angle.cos(), 0.0, -angle.sin()), DVec3::new(angle.sin(), 0.0, angle.cos()))
}

fn slide_down(draw: &mut Draw<'_>) -> ClosedForm {
    let (angle, part) = (draw.between(0.2, 0.9), draw.between(0.2, 0.8));
    let friction = part * angle.tan();
    let (turn, along, normal) = slope(angle);
    let start = normal * HALF;
    let acceleration = G * (angle.sin() - friction * angle.cos());
    let position = move |t: f64| start + along * (0.5 * acceleration * t * t);
    draw.scene("slide down", [friction, 0.0], normal, 1.0, &body("body", CUBE, start, DVec3::ZERO, &turn), position)
}

/// A cube that slides up a slope and comes to rest there.
fn pushed(draw: &mut Draw<'_>) -> ClosedForm {
    let (angle, more) = (draw.between(0.1, 0.4), draw.between(1.2, 2.0));
    let (friction, speed) = (more * angle.tan(), draw.between(1.0, 3.0));
    let (turn, along, normal) = slope(angle);
    let start = normal * HALF;
    let deceleration = G * (angle.sin() + friction * angle.cos());
    let duration_s = 4.0 / 3.0 * speed / deceleration;
    let position = move |t: f64| start - along * slowed(speed, deceleration, t);
    let bodies = body("body", CUBE, start, along * -speed, &turn);
    draw.scene("up a slope to rest", [friction, 0.0], normal, duration_s, &bodies, position)
}

/// A ball that is too smooth to turn lands without restitution and slides.
fn landing(draw: &mut Draw<'_>) -> ClosedForm {
    let (height, speed) = (draw.between(0.2, 1.0), draw.between(1.0, 3.0));
    let start = DVec3::Z * (HALF + height);
    let lands = (2.0 * height / G).sqrt();
    let position = move |t: f64| {
        let fallen = 0.5 * G * t.min(lands).powi(2);
        DVec3::new(speed * t, 0.0, HALF + height - fallen)
    };
    draw.scene("landing", [0.0, 0.0], DVec3::Z, 2.0 * lands, &body("body", BALL, start, DVec3::X * speed, ""), position)
}

fn bounces_to_rest(draw: &mut Draw<'_>) -> ClosedForm {
    let (restitution, height) = (draw.between(0.3, 0.7), draw.between(0.3, 1.0));
    let lands = (2.0 * height / G).sqrt();
    let rests = lands * (1.0 + restitution) / (1.0 - restitution);
    let position = move |t: f64| {
        let (mut left, mut speed) = (t - lands, G * lands * restitution);
        if left < 0.0 {
            return DVec3::Z * (HALF + height - 0.5 * G * t * t);
        }
        if t >= rests {
            return DVec3::Z * HALF;
        }
        while left > 2.0 * speed / G {
            left -= 2.0 * speed / G;
            speed *= restitution;
        }
        DVec3::Z * (HALF + speed * left - 0.5 * G * left * left)
    };
    let bodies = body("body", BALL, DVec3::Z * (HALF + height), DVec3::ZERO, "");
    draw.scene("bounces to rest", [0.3, restitution], DVec3::Z, 1.2 * rests, &bodies, position)
}

/// A ball set down with a speed and a spin rolls once friction has made both agree.
fn set_down(draw: &Draw<'_>, kind: &str, friction: f64, [speed, spin]: [f64; 2]) -> ClosedForm {
    let slip = speed - spin * HALF;
    let deceleration = friction * G * slip.signum();
    let rolls = slip.abs() / (friction * G * (1.0 + 1.0 / BALL_INERTIA));
    let start = DVec3::Z * HALF;
    let position = move |t: f64| {
        let slipping = t.min(rolls);
        let at_end = speed - deceleration * slipping;
        start + DVec3::X * (speed * slipping - 0.5 * deceleration * slipping.powi(2) + at_end * (t - slipping))
    };
    let further = format!("angular_velocity = [0.0, {spin:?}, 0.0]");
    let bodies = body("body", BALL, start, DVec3::X * speed, &further);
    draw.scene(kind, [friction, 0.0], DVec3::Z, 2.0 * rolls, &bodies, position)
}

fn ball_begins_to_roll(draw: &mut Draw<'_>) -> ClosedForm {
    let (friction, speed) = (draw.between(0.1, 0.6), draw.between(1.0, 4.0));
    set_down(draw, "begins to roll", friction, [speed, 0.0])
}

fn back_spin(draw: &mut Draw<'_>) -> ClosedForm {
    let (friction, speed) = (draw.between(0.1, 0.6), draw.between(0.5, 2.0));
    let spin = -draw.between(30.0, 60.0);
    set_down(draw, "back spin", friction, [speed, spin])
}

/// What rolls down a slope without slip; `inertia` is of `m r^2`.
fn rolling_down(draw: &Draw<'_>, kind: &str, shape: &str, [angle, friction, inertia]: [f64; 3]) -> ClosedForm {
    let (_, along, normal) = slope(angle);
    let start = normal * HALF;
    let acceleration = G * angle.sin() / (1.0 + inertia);
    let position = move |t: f64| start + along * (0.5 * acceleration * t * t);
    draw.scene(kind, [friction, 0.0], normal, 1.0, &body("body", shape, start, DVec3::ZERO, ""), position)
}

fn rolls_down(draw: &mut Draw<'_>) -> ClosedForm {
    let angle = draw.between(0.1, 0.7);
    // Friction beyond tan(angle) 2/7, which rolling needs.
    let friction = angle.tan() * draw.between(0.4, 1.0);
    rolling_down(draw, "rolls down", BALL, [angle, friction, BALL_INERTIA])
}

fn cylinder_rolls_down(draw: &mut Draw<'_>) -> ClosedForm {
    let angle = draw.between(0.1, 0.7);
    let friction = angle.tan() * draw.between(0.5, 1.0);
    // Its axis is turned from z to y.
    let shape = "shape.cylinder = { radius = 0.1, height = 0.3 }\nrotation_vector = [1.5707963267948966, 0.0, 0.0]";
    rolling_down(draw, "cylinder rolls down", shape, [angle, friction, 0.5])
}

/// A ball on a slope too steep for its friction slips while it turns.
fn slips_down(draw: &mut Draw<'_>) -> ClosedForm {
    let angle = draw.between(0.5, 1.0);
    let friction = angle.tan() * draw.between(0.05, 0.25);
    let (_, along, normal) = slope(angle);
    let start = normal * HALF;
    let acceleration = G * (angle.sin() - friction * angle.cos());
    let position = move |t: f64| start + along * (0.5 * acceleration * t * t);
    draw.scene("slips down", [friction, 0.0], normal, 1.0, &body("body", BALL, start, DVec3::ZERO, ""), position)
}

/// A ball at rest struck by an equal one that slides without friction: the speed of the struck one is known.
fn struck_ball(draw: &mut Draw<'_>) -> ClosedForm {
    let (restitution, speed, gap) = (draw.between(0.3, 1.0), draw.between(1.0, 3.0), draw.between(0.1, 0.5));
    let start = DVec3::Z * HALF;
    let meets = gap / speed;
    let after = 0.5 * (1.0 + restitution) * speed;
    let position = move |t: f64| start + DVec3::X * (after * (t - meets).max(0.0));
    let striking = body("striking", BALL, start - DVec3::X * (2.0 * HALF + gap), DVec3::X * speed, "");
    let bodies = body("body", BALL, start, DVec3::ZERO, "") + &striking;
    draw.scene("struck ball", [0.0, restitution], DVec3::Z, 2.5 * meets, &bodies, position)
}

/// A ball falls obliquely on a rough floor: it slips throughout the impact or sticks at its end, and flies on.
fn oblique_bounce(draw: &mut Draw<'_>) -> ClosedForm {
    let (friction, restitution) = (draw.between(0.05, 0.4), draw.between(0.4, 0.8));
    let (height, speed) = (draw.between(0.3, 0.8), draw.between(0.5, 3.0));
    let lands = (2.0 * height / G).sqrt();
    let down = G * lands;
    // Friction takes at most what makes the slip vanish: `v / (1 + 1/inertia)`.
    let taken = (friction * (1.0 + restitution) * down).min(speed / (1.0 + 1.0 / BALL_INERTIA));
    let position = move |t: f64| {
        if t < lands {
            return DVec3::new(speed * t, 0.0, HALF + height - 0.5 * G * t * t);
        }
        let after = t - lands;
        let up = restitution * down * after - 0.5 * G * after * after;
        DVec3::new(speed * lands + (speed - taken) * after, 0.0, HALF + up)
    };
    let duration_s = lands * (1.0 + 1.5 * restitution);
    let bodies = body("body", BALL, DVec3::Z * (HALF + height), DVec3::X * speed, "");
    draw.scene("oblique bounce", [friction, restitution], DVec3::Z, duration_s, &bodies, position)
}
