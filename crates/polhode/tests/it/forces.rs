//! Forces on bodies that touch nothing, against closed forms.

use crate::checks::{
    assert_closes, complete_elliptic, max_position_error, max_velocity_error, numerical_relative, particle,
};
use crate::support::run;
use polhode::dynamics::field::{Account, Dependence, Field, Wrench};
use polhode::dynamics::integrator::Method as Integrator;
use polhode::dynamics::{BodyState, RigidBody};
use polhode::scene::{Attachment, DragLaw, Force, Frame, Method, Signal};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Rotation, Velocity};
use polhode::{Body, BodyId, Effects, Recorder, RunReport, Scene, SceneBuilder};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::Arc;

/// A scene without uniform gravity.
fn space(name: &str, duration_s: f64, interval_s: f64) -> SceneBuilder {
    Scene::builder(name).gravity(DVec3::ZERO).duration_s(duration_s).output_interval_s(interval_s)
}

/// A centre of mass that is not the origin of the body's frame.
const CENTER_OF_MASS: DVec3 = DVec3::new(0.1, -0.05, 0.2);

fn at(body: usize, point: DVec3) -> Attachment {
    Attachment::Body { body: BodyId::new(body), point }
}

/// A Kepler orbit: eccentricity, semi-major axis, gravitational parameter and mean anomaly at the start.
#[derive(Clone, Copy)]
struct Orbit {
    e: f64,
    a: f64,
    mu: f64,
    start: f64,
}

impl Orbit {
    /// Place and velocity from the focus, in a plane of no special direction.
    fn at(&self, t: f64) -> (DVec3, DVec3) {
        let Self { e, a, mu, start } = *self;
        let n = (mu / (a * a * a)).sqrt();
        let mean = start + n * t;
        // The solution lies between M - e and M + e.
        let anomaly = crate::checks::root(mean - e - 1e-3, mean + e + 1e-3, |x| mean - (x - e * x.sin()));
        let (sin, cos) = anomaly.sin_cos();
        let minor = a * (1.0 - e * e).sqrt();
        let rate = n / (1.0 - e * cos);
        let plane = Rotation::from_rotation_vector(DVec3::new(0.4, -0.7, 1.1));
        let place = DVec3::new(a * (cos - e), minor * sin, 0.0);
        let velocity = DVec3::new(-a * sin, minor * cos, 0.0) * rate;
        (plane.rotate(place), plane.rotate(velocity))
    }

    fn period(&self) -> f64 {
        TAU * (self.a * self.a * self.a / self.mu).sqrt()
    }
}

/// A Kepler orbit about a point follows the closed form, at any eccentricity and from any start on it. A start far from
/// the centre is slow, and so are the rates from which the plan chooses its steps. The energy and the angular momentum
/// about the centre are conserved.
#[test]
fn orbit_about_a_point_is_keplers_ellipse() {
    let center = DVec3::new(0.3, -0.2, 0.5);
    for e in [0.0, 0.3, 0.6, 0.9] {
        for start in [0.7, PI] {
            let orbit = Orbit { e, a: 1.3, mu: 3.7, start };
            let (place, velocity) = orbit.at(0.0);
            let inertia = Inertia::from_diagonal(DVec3::new(0.2, 0.3, 0.4)).unwrap();
            let properties = MassProperties::new(Mass::new(2.5).unwrap(), CENTER_OF_MASS, inertia);
            let turn = Rotation::from_rotation_vector(DVec3::new(1.0, 0.3, -0.4));
            let body = Body::movable("planet", properties)
                .pose(Pose::new(turn, center + place - turn.rotate(CENTER_OF_MASS)))
                .velocity(Velocity::new(velocity, DVec3::new(0.5, 3.0, -0.2)));
            let scene = space("kepler", 2.0 * orbit.period(), 0.21)
                .body(body)
                .force(Force::PointGravity { center, mu: orbit.mu })
                .build()
                .unwrap();
            let (report, recorder) = run(&scene, Effects::Planned);
            let (mut worst, mut moment) = (0.0f64, 0.0f64);
            for (&t, row) in recorder.times_s.iter().zip(&recorder.samples) {
                let found = row[0].pose.transform_point(CENTER_OF_MASS) - center;
                worst = worst.max((found - orbit.at(t).0).length());
                moment = moment.max((found.cross(row[0].velocity.linear) - place.cross(velocity)).length());
            }
            // A passage of the centre at e = 0.9 magnifies the error of the local steps, 1e-13, some thousand times.
            assert!(worst < 1e-9, "e = {e} from {start}: {worst:e}");
            assert!(moment < 2e-12 * place.cross(velocity).length(), "e = {e} from {start}: {moment:e}");
            assert!(numerical_relative(&report) < 1e-12, "e = {e} from {start}: {:e}", numerical_relative(&report));
            assert_closes(&report);
        }
    }
}

/// Two bodies under their mutual gravity: their distance describes an ellipse, their centre of mass a straight line,
/// and their total momentum is conserved.
#[test]
fn two_bodies_turn_about_their_centre_of_mass() {
    let (m1, m2, constant) = (2.0, 3.2, 1.7);
    let drift = DVec3::new(0.4, -0.1, 0.2);
    for e in [0.0, 0.5, 0.8] {
        let orbit = Orbit { e, a: 1.1, mu: constant * (m1 + m2), start: 2.0 };
        let shares = [-m2 / (m1 + m2), m1 / (m1 + m2)];
        let (place, velocity) = orbit.at(0.0);
        let body = |name, mass, share: f64| particle(name, mass, place * share, drift + velocity * share);
        let scene = space("pair", 5.0, 0.13)
            .body(body("a", m1, shares[0]))
            .body(Body::fixed("bystander"))
            .body(body("b", m2, shares[1]))
            .force(Force::MutualGravity { constant })
            .build()
            .unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        let worst_a = max_position_error(&recorder, 0, |t| drift * t + orbit.at(t).0 * shares[0]);
        let worst_b = max_position_error(&recorder, 2, |t| drift * t + orbit.at(t).0 * shares[1]);
        let momentum = recorder.samples.iter().map(|row| row[0].velocity.linear * m1 + row[2].velocity.linear * m2);
        let lost = momentum.map(|p| (p - drift * (m1 + m2)).length()).fold(0.0, f64::max);
        assert!(worst_a < 1e-9 && worst_b < 1e-9, "e = {e}: {worst_a:e} {worst_b:e}");
        assert!(lost < 1e-13 * (m1 * velocity.length()), "{lost:e}");
        assert!(numerical_relative(&report) < 1e-12, "e = {e}: {:e}", numerical_relative(&report));
        assert_closes(&report);
    }
}

/// A spring without a rest length is a harmonic force in space; under gravity the middle of the motion sags.
#[test]
fn spring_without_rest_length_is_a_harmonic_oscillator() {
    let (mass, stiffness) = (0.8, 37.0);
    let (anchor, start, velocity) = (DVec3::new(0.2, 0.1, 1.0), DVec3::new(0.5, -0.4, 0.7), DVec3::new(1.0, 2.0, -0.5));
    let gravity = DVec3::new(0.3, 0.0, -9.0);
    let w = f64::sqrt(stiffness / mass);
    let middle = anchor + gravity * (mass / stiffness);
    let spring = Force::Spring {
        a: Attachment::World(anchor),
        b: at(0, DVec3::ZERO),
        stiffness,
        rest_length: 0.0,
        damping: 0.0,
    };
    let scene = space("oscillator", 10.0, 0.17)
        .gravity(gravity)
        .body(particle("mass", mass, start, velocity))
        .force(spring)
        .build()
        .unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let place = |t: f64| middle + (start - middle) * (w * t).cos() + velocity / w * (w * t).sin();
    let worst = max_position_error(&recorder, 0, place);
    assert!(worst < 1e-9, "{worst:e}");
    assert!(numerical_relative(&report) < 1e-12);
    assert_closes(&report);
}

/// Wall, spring, mass, spring, mass, spring, wall: the motion is a sum of two normal modes. One wall is a point of the
/// world, the other one a point of a fixed body.
#[test]
fn two_masses_between_walls_move_in_normal_modes() {
    let (mass, stiffness, length) = (1.3, 21.0, 1.0);
    let (q, p) = (0.11, -0.07);
    let place = |k: f64| DVec3::new(length * k, 0.4, -0.2);
    let wall = Body::fixed("wall")
        .pose(Pose::new(Rotation::from_rotation_vector(DVec3::Z * FRAC_PI_2), place(3.0) + DVec3::X * 0.5));
    let spring = |a, b| Force::Spring { a, b, stiffness, rest_length: 0.9 * length, damping: 0.0 };
    let scene = space("chain", 8.0, 0.1)
        .body(wall)
        .body(particle("left", mass, place(1.0) + DVec3::X * (q + p), DVec3::ZERO))
        .body(particle("right", mass, place(2.0) + DVec3::X * (q - p), DVec3::ZERO))
        .force(spring(Attachment::World(place(0.0)), at(1, DVec3::ZERO)))
        .force(spring(at(1, DVec3::ZERO), at(2, DVec3::ZERO)))
        .force(spring(at(2, DVec3::ZERO), at(0, DVec3::Y * 0.5)))
        .build()
        .unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let (slow, fast) = (f64::sqrt(stiffness / mass), f64::sqrt(3.0 * stiffness / mass));
    let left =
        max_position_error(&recorder, 1, |t| place(1.0) + DVec3::X * (q * (slow * t).cos() + p * (fast * t).cos()));
    let right =
        max_position_error(&recorder, 2, |t| place(2.0) + DVec3::X * (q * (slow * t).cos() - p * (fast * t).cos()));
    assert!(left < 1e-9 && right < 1e-9, "{left:e} {right:e}");
    assert!(numerical_relative(&report) < 1e-12);
    assert_closes(&report);
}

/// Two springs without rest length from points (q, -q) of a body to points (A, -A) of the world: its centre oscillates
/// at `2 k/m` and, apart from that, it turns as a pendulum with `I theta'' = -2 k q A sin theta`.
#[test]
fn springs_beside_the_centre_turn_a_body_as_a_pendulum() {
    let (mass, stiffness, q, far, amplitude) = (1.7, 12.0, 0.3, 1.4, 2.6);
    let moment = 0.23;
    let inertia = Inertia::from_diagonal(DVec3::new(0.1, 0.2, moment)).unwrap();
    let properties = MassProperties::new(Mass::new(mass).unwrap(), CENTER_OF_MASS, inertia);
    let rate = f64::sqrt(2.0 * stiffness * q * far / moment);
    let period = 4.0 * complete_elliptic(f64::sin(0.5 * amplitude)) / rate;
    let turn = Rotation::from_rotation_vector(DVec3::Z * amplitude);
    let start = DVec3::new(0.3, 0.2, -0.4);
    let spring = |side: f64| Force::Spring {
        a: at(0, CENTER_OF_MASS + DVec3::X * (q * side)),
        b: Attachment::World(DVec3::X * (far * side)),
        stiffness,
        rest_length: 0.0,
        damping: 0.0,
    };
    let scene = space("sprung", period, 0.25 * period)
        .body(Body::movable("body", properties).pose(Pose::new(turn, start - turn.rotate(CENTER_OF_MASS))))
        .force(spring(1.0))
        .force(spring(-1.0))
        .build()
        .unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let w = f64::sqrt(2.0 * stiffness / mass);
    let angles = [amplitude, 0.0, -amplitude, 0.0, amplitude];
    for ((&t, row), angle) in recorder.times_s.iter().zip(&recorder.samples).zip(angles) {
        let center = row[0].pose.transform_point(CENTER_OF_MASS);
        assert!((center - start * (w * t).cos()).length() < 1e-9);
        assert!(row[0].pose.rotation.angle_to(Rotation::from_rotation_vector(DVec3::Z * angle)) < 1e-9);
    }
    let fastest = recorder.samples[1][0].velocity.angular.z;
    assert!((fastest / (-2.0 * rate * f64::sin(0.5 * amplitude)) - 1.0).abs() < 1e-9, "{fastest}");
    assert!(numerical_relative(&report) < 1e-12, "{:e}", numerical_relative(&report));
    assert_closes(&report);
}

/// A damped oscillator along its spring follows its closed form, and the ledger's damping is the energy that it lost.
#[test]
fn damper_takes_what_the_oscillator_loses() {
    let (mass, stiffness, damping, length, start) = (0.9, 30.0, 1.1, 0.5, 0.23);
    let spring = Force::Spring {
        a: Attachment::World(DVec3::ZERO),
        b: at(0, DVec3::ZERO),
        stiffness,
        rest_length: length,
        damping,
    };
    let direction = DVec3::new(2.0, -1.0, 2.0) / 3.0;
    let scene = space("damped", 6.0, 0.11)
        .body(particle("mass", mass, direction * (length + start), DVec3::ZERO))
        .force(spring)
        .build()
        .unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let decay = damping / (2.0 * mass);
    let w = (stiffness / mass - decay * decay).sqrt();
    let stretch = |t: f64| start * (-decay * t).exp() * ((w * t).cos() + decay / w * (w * t).sin());
    let worst = max_position_error(&recorder, 0, |t| direction * (length + stretch(t)));
    assert!(worst < 1e-10, "{worst:e}");
    let lost = report.energy.initial_j - report.energy.final_j;
    let damped = report.ledger.damping.value();
    assert!((damped / lost - 1.0).abs() < 1e-10, "{damped} {lost}");
    assert_eq!(report.ledger.external.value(), 0.0);
    assert!(numerical_relative(&report) < 1e-11, "{:e}", numerical_relative(&report));
    assert_closes(&report);
}

/// Linear drag with gravity, in still air and in wind: `v = v_end + (v0 - v_end) exp(-c t/m)`, and the spin of a sphere
/// decays likewise. The ledger books the work of drag as external in wind, as damping in still air.
#[test]
fn linear_drag_ends_at_the_wind_and_the_terminal_speed() {
    let (mass, c, k, moment) = (0.7, 0.9, 0.02, 0.05);
    let gravity = DVec3::new(0.0, 0.0, -9.81);
    let (v0, w0) = (DVec3::new(3.0, 1.0, 4.0), DVec3::new(1.0, -2.0, 0.5));
    for wind in [DVec3::ZERO, DVec3::new(-2.0, 0.5, 0.3)] {
        let inertia = Inertia::from_diagonal(DVec3::splat(moment)).unwrap();
        let body = Body::movable("body", MassProperties::new(Mass::new(mass).unwrap(), DVec3::ZERO, inertia))
            .velocity(Velocity::new(v0, w0));
        let drag = Force::Drag { body: BodyId::new(0), law: DragLaw::Linear, translational: c, rotational: k, wind };
        let scene = space("drag", 4.0, 0.19).gravity(gravity).body(body).force(drag).build().unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        let end = wind + gravity * (mass / c);
        let worst = max_velocity_error(&recorder, 0, |t| end + (v0 - end) * (-c * t / mass).exp());
        let spin = recorder.samples.iter().zip(&recorder.times_s);
        let spin = spin.map(|(row, t)| (row[0].velocity.angular - w0 * (-k * t / moment).exp()).length());
        assert!(worst < 1e-10 && spin.fold(0.0, f64::max) < 1e-10, "{worst:e}");
        let still = wind == DVec3::ZERO;
        assert_eq!(report.ledger.external.value() == 0.0, still);
        assert_eq!(report.ledger.damping.value() == 0.0, !still);
        assert_closes(&report);
        assert!(numerical_relative(&report) < 1e-11, "{:e}", numerical_relative(&report));
    }
}

/// Quadratic drag: a slide without gravity, `v = v0/(1 + c v0 t/m)`, and a fall from rest, `v = v_t tanh(g t/v_t)`.
#[test]
fn quadratic_drag_slows_by_its_closed_forms() {
    let (mass, c, v0) = (1.9, 0.31, DVec3::new(4.0, -3.0, 12.0));
    let drag = Force::Drag {
        body: BodyId::new(0),
        law: DragLaw::Quadratic,
        translational: c,
        rotational: 0.0,
        wind: DVec3::ZERO,
    };
    let slide =
        space("slide", 5.0, 0.3).body(particle("body", mass, DVec3::ZERO, v0)).force(drag.clone()).build().unwrap();
    let (report, recorder) = run(&slide, Effects::Planned);
    let speed = v0.length();
    let worst = max_velocity_error(&recorder, 0, |t| v0 / (1.0 + c * speed * t / mass));
    assert!(worst < 1e-9, "{worst:e}");
    assert_closes(&report);
    let fall = space("fall", 5.0, 0.3)
        .gravity(DVec3::NEG_Z * 9.81)
        .body(particle("body", mass, DVec3::ZERO, DVec3::ZERO))
        .force(drag)
        .build()
        .unwrap();
    let (report, recorder) = run(&fall, Effects::Planned);
    let terminal = f64::sqrt(mass * 9.81 / c);
    let place = |t: f64| DVec3::NEG_Z * (terminal * terminal / 9.81 * (9.81 * t / terminal).cosh().ln());
    assert!(max_position_error(&recorder, 0, place) < 1e-9);
    assert_closes(&report);
}

/// Runs one body under a load in free space, from rest but for a spin; the ledgers must close, and the work must be the
/// change of energy.
fn pushed(load: Force, duration_s: f64, spin: DVec3) -> (RunReport, Recorder) {
    let inertia = Inertia::from_diagonal(DVec3::new(0.3, 0.3, 0.5)).unwrap();
    let properties = MassProperties::new(Mass::new(MASS).unwrap(), CENTER_OF_MASS, inertia);
    let body = Body::movable("body", properties)
        .pose(Pose::from_translation(-CENTER_OF_MASS))
        .velocity(Velocity::new(DVec3::ZERO, spin));
    let scene = space("pushed", duration_s, 0.07).body(body).force(load).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    assert_closes(&report);
    let work = report.ledger.external.value();
    assert!((work - report.energy.final_j + report.energy.initial_j).abs() < 1e-10 * report.ledger.scale_j, "{work}");
    (report, recorder)
}

const MASS: f64 = 2.3;

fn load(force: DVec3, torque: DVec3, frame: Frame, point: Option<DVec3>, signal: Signal) -> Force {
    Force::Applied { body: BodyId::new(0), force, torque, frame, point, signal }
}

/// A constant force in the world accelerates a body from rest, without gravity, although nothing moves at the start.
#[test]
fn constant_force_moves_a_body_at_rest() {
    let force = DVec3::new(1.0, -2.0, 0.5);
    let (_, recorder) = pushed(load(force, DVec3::ZERO, Frame::World, None, Signal::ONE), 2.0, DVec3::ZERO);
    let worst = max_position_error(&recorder, 0, |t| force * (0.5 * t * t / MASS) - CENTER_OF_MASS);
    assert!(worst < 1e-12, "{worst:e}");
}

/// A force that turns with a body that spins at `w` about its axis drives a cycloid:
/// `v = F/(m w) (sin w t, 1 - cos w t)`.
#[test]
fn force_of_the_body_turns_with_it() {
    let w = 3.1;
    let applied = load(DVec3::X * 1.4, DVec3::ZERO, Frame::Body, None, Signal::ONE);
    let (_, recorder) = pushed(applied, 3.0, DVec3::Z * w);
    let worst =
        max_velocity_error(&recorder, 0, |t| DVec3::new((w * t).sin(), 1.0 - (w * t).cos(), 0.0) * (1.4 / MASS / w));
    assert!(worst < 1e-11, "{worst:e}");
}

/// A force of the body at a point beside its centre of mass is a constant torque too: the angle grows with `t^2/2`.
#[test]
fn force_at_a_point_turns_a_body() {
    let point = CENTER_OF_MASS + DVec3::Y * 0.4;
    let applied = load(DVec3::X * 1.4, DVec3::ZERO, Frame::Body, Some(point), Signal::ONE);
    let (_, recorder) = pushed(applied, 2.0, DVec3::ZERO);
    let rate = -1.4 * 0.4 / 0.5;
    for (&t, row) in recorder.times_s.iter().zip(&recorder.samples) {
        assert!((row[0].velocity.angular - DVec3::Z * (rate * t)).length() < 1e-10);
        let turn = Rotation::from_rotation_vector(DVec3::Z * (0.5 * rate * t * t));
        assert!(row[0].pose.rotation.angle_to(turn) < 1e-10, "{t}");
    }
}

/// A torque in the world and one in the body about the axis of a spin: the rate grows evenly.
#[test]
fn torque_along_the_axis_adds_to_the_spin() {
    for frame in [Frame::World, Frame::Body] {
        let applied = load(DVec3::ZERO, DVec3::Z * -0.7, frame, None, Signal::ONE);
        let (_, recorder) = pushed(applied, 3.0, DVec3::Z * 2.0);
        for (&t, row) in recorder.times_s.iter().zip(&recorder.samples) {
            assert!((row[0].velocity.angular - DVec3::Z * (2.0 - 0.7 * t / 0.5)).length() < 1e-11);
        }
    }
}

/// A sinusoid and a table of time: `m v` is the integral of the signal. The body is at rest until the table begins.
#[test]
fn signals_drive_by_their_integrals() {
    let sinusoid = Signal::sinusoid(1.5, 2.2, 0.6).unwrap();
    let w = TAU * 2.2;
    let (_, recorder) = pushed(load(DVec3::X, DVec3::ZERO, Frame::World, None, sinusoid), 2.0, DVec3::ZERO);
    let worst =
        max_velocity_error(&recorder, 0, |t| DVec3::X * (1.5 / w / MASS * (f64::cos(0.6) - (w * t + 0.6).cos())));
    assert!(worst < 1e-10, "{worst:e}");
    let table = Signal::table(vec![(0.303, 0.0), (0.711, 2.0), (1.117, -1.0), (1.511, 0.0)]).unwrap();
    let (_, recorder) = pushed(load(DVec3::Y, DVec3::ZERO, Frame::World, None, table), 2.0, DVec3::ZERO);
    let area = 0.5 * (0.408 * 2.0 + 0.406 * 1.0 - 0.394);
    let found = recorder.samples.last().unwrap()[0].velocity.linear;
    assert!((found - DVec3::Y * (area / MASS)).length() < 1e-10, "{found} {area}");
}

/// Steps do not miss a pulse far shorter than a step: `m v` is its area.
#[test]
fn short_pulse_is_not_stepped_over() {
    let pulse = Signal::table(vec![(0.0502, 0.0), (0.0503, 5.0), (0.0504, 0.0)]).unwrap();
    let (_, recorder) = pushed(load(DVec3::Y, DVec3::ZERO, Frame::World, None, pulse), 0.2, DVec3::ZERO);
    let found = recorder.samples.last().unwrap()[0].velocity.linear;
    assert!((found.y * MASS / (0.5 * 5.0 * 2e-4) - 1.0).abs() < 1e-9, "{found}");
}

/// A force through the centre of mass does not turn a body: its attitude is that of free rotation, to rounding. (Flips
/// about the middle axis would magnify the rounding of every integrated step to 1e-9 rad.)
#[test]
fn pushed_body_turns_freely() {
    let properties = || {
        let inertia = Inertia::from_diagonal(DVec3::new(1.0, 2.0, 3.0)).unwrap();
        MassProperties::new(Mass::new(MASS).unwrap(), CENTER_OF_MASS, inertia)
    };
    let (pose, spin) = (Pose::from_translation(DVec3::X), DVec3::new(1e-3, 3.0, 1e-3));
    let run_with = |force: Option<Force>| {
        let body = Body::movable("body", properties()).pose(pose).velocity(Velocity::new(DVec3::ZERO, spin));
        let scene = space("spun", 20.0, 0.37).body(body);
        let scene = force.into_iter().fold(scene, SceneBuilder::force).build().unwrap();
        run(&scene, Effects::Planned).1
    };
    let push = Signal::sinusoid(3.0, 0.4, 0.2).unwrap();
    let pushed = run_with(Some(load(DVec3::new(1.0, 2.0, -1.0), DVec3::ZERO, Frame::Body, None, push)));
    let free = run_with(None);
    for (time, (a, b)) in pushed.times_s.iter().zip(pushed.samples.iter().zip(&free.samples)) {
        let angle = a[0].pose.rotation.angle_to(b[0].pose.rotation);
        assert!(angle < 1e-13, "{time} s: {angle:e}");
    }
}

/// A comet begins far from its sun, where the splitting integrator is cheap, and comes so near that it is not. DOP853
/// takes over and the report says so; motion and momentum are those of DOP853 from the start.
#[test]
fn comet_leaves_splitting_near_its_sun() {
    let comet = |method: Method| {
        let body = particle("comet", 2.0, DVec3::X, DVec3::Y * 0.05);
        let sun = Force::PointGravity { mu: 1.0, center: DVec3::ZERO };
        let scene = space("comet", 2.0, 0.1).body(body).force(sun).method(method).build().unwrap();
        run(&scene, Effects::Planned).0
    };
    let planned = comet(Method::default());
    assert!(planned.warnings.iter().any(|warning| warning.contains("dop853 continues")), "{:?}", planned.warnings);
    let exact = comet(Method { integrator: Some(Integrator::Dop853), tolerance: Some(1e-13), ..Method::default() });
    let apart = (planned.bodies[0].state.pose.translation - exact.bodies[0].state.pose.translation).length();
    assert!(apart < 1e-6, "{apart:e}");
    for report in [&planned, &exact] {
        let momentum = &report.ledger.momentum;
        let lost = momentum.numerical.value().linear.length() / momentum.scale_linear;
        assert!(lost < 1e-9, "{lost:e}");
    }
}

/// Two times of a table next to each other are a jump: steps end at both, and `m v` is the area.
#[test]
fn jump_of_a_table() {
    for at in [0.05, 0.1, 1e-3] {
        let jump = Signal::table(vec![(at, 0.0), (f64::next_up(at), 1.0)]).unwrap();
        let (_, recorder) = pushed(load(DVec3::Y, DVec3::ZERO, Frame::World, None, jump), 0.2, DVec3::ZERO);
        let found = recorder.samples.last().unwrap()[0].velocity.linear;
        assert!((found.y * MASS / (0.2 - at) - 1.0).abs() < 1e-9, "{at}: {found}");
    }
}

/// A field defined by the user: a plane trap `V = k z^2/2` for one of two movable bodies.
#[derive(Debug)]
struct Trap {
    slot: usize,
    stiffness: f64,
}

impl Field for Trap {
    fn dependence(&self) -> Dependence {
        Dependence::Poses
    }

    fn account(&self) -> Account {
        Account::Potential
    }

    fn acts_on(&self, body: usize) -> bool {
        body == self.slot
    }

    fn couples(&self) -> bool {
        false
    }

    fn add_wrenches(&self, _t: f64, bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]) {
        let z = bodies[self.slot].center_of_mass_position(&states[self.slot]).z;
        wrenches[self.slot].force.z -= self.stiffness * z;
    }

    fn potential_energy(&self, bodies: &[RigidBody], states: &[BodyState]) -> f64 {
        let z = bodies[self.slot].center_of_mass_position(&states[self.slot]).z;
        0.5 * self.stiffness * z * z
    }
}

/// A user's field moves the body it names by its number among the movable ones, and leaves the other to its flight.
#[test]
fn field_of_the_user_traps_one_body() {
    let scene = space("trap", 5.0, 0.13)
        .body(Body::fixed("post"))
        .body(particle("free", 1.0, DVec3::X, DVec3::Y))
        .body(particle("trapped", 0.6, DVec3::new(2.0, 0.0, 0.3), DVec3::X))
        .force(Force::Field(Arc::new(Trap { slot: 1, stiffness: 17.0 })))
        .build()
        .unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let w = f64::sqrt(17.0 / 0.6);
    let worst = max_position_error(&recorder, 2, |t| DVec3::new(2.0 + t, 0.0, 0.3 * (w * t).cos()));
    assert!(worst < 1e-9, "{worst:e}");
    assert!(max_position_error(&recorder, 1, |t| DVec3::X + DVec3::Y * t) < 1e-14);
    assert!(numerical_relative(&report) < 1e-12);
    assert_closes(&report);
}
