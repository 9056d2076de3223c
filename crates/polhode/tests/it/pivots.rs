//! Bodies held at a point: pendulums, tops and gyroscopes, and impacts on them.

use crate::checks::{assert_closes, by, complete_elliptic, heavy_brick, numerical_relative};
use crate::support::{accurate, ball, elastic, run};
use polhode::dynamics::integrator::Method as Integrator;
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Rotation, Velocity};
use polhode::{Body, Decision, Effect, Effects, EventKind, Scene, SceneError, Simulation};

const G: f64 = 9.81;

/// The pivot, in the world, m.
const HOOK: DVec3 = DVec3::new(0.7, -0.4, 2.0);
const SIZE: DVec3 = DVec3::new(0.1, 0.2, 0.9);
const BRICK_MASS: f64 = 1.6;

/// A brick that hangs from `HOOK` at the point `at` of its own frame, turned by `turn`.
fn hanging(at: DVec3, turn: Rotation) -> Body {
    heavy_brick("pendulum", BRICK_MASS, SIZE, DVec3::ZERO).pose(Pose::new(turn, HOOK - turn.rotate(at))).pivot(HOOK)
}

/// Moment of the brick about the y axis through a point on its own z axis.
fn swing_moment(d: f64) -> f64 {
    BRICK_MASS * ((SIZE.x * SIZE.x + SIZE.z * SIZE.z) / 12.0 + d * d)
}

fn about_y(angle: f64) -> Rotation {
    Rotation::from_rotation_vector(DVec3::Y * angle)
}

/// A pendulum swings with the period of the complete elliptic integral, up to almost upright, reduced to a rotation and
/// with its pivot as a constraint. At every sample the velocity is that of the centre of mass.
#[test]
fn pendulum_swings_with_its_elliptic_period() {
    let d = 0.37;
    let rate = f64::sqrt(BRICK_MASS * G * d / swing_moment(d));
    for amplitude in [0.05, 1.5, 2.8, 3.1] {
        let period = 4.0 * complete_elliptic(f64::sin(0.5 * amplitude)) / rate;
        let scene = Scene::builder("pendulum")
            .duration_s(period)
            .output_interval_s(0.25 * period)
            .body(hanging(DVec3::Z * d, about_y(amplitude)))
            .build()
            .unwrap();
        let angles = [amplitude, 0.0, -amplitude, 0.0, amplitude];
        for effects in [Effects::Planned, Effects::All] {
            let (report, recorder) = run(&scene, effects);
            // Near the upright position an error grows by exp(rate T/4) in a quarter of the period.
            let tolerance = if amplitude > 3.0 { 1e-8 } else { 1e-10 };
            for (row, angle) in recorder.samples.iter().zip(angles) {
                let apart = row[0].pose.rotation.angle_to(about_y(angle));
                assert!(apart < tolerance, "{amplitude} {angle}: {apart:e}");
                let hook = row[0].pose.transform_point(DVec3::Z * d);
                assert!((hook - HOOK).length() < if effects == Effects::All { 1e-13 } else { 1e-14 });
                let turning = row[0].velocity.angular.cross(row[0].pose.translation - HOOK);
                assert!((row[0].velocity.linear - turning).length() < 1e-13 * rate);
            }
            let fastest = recorder.samples[1][0].velocity.angular.y;
            assert!((fastest / (-2.0 * rate * f64::sin(0.5 * amplitude)) - 1.0).abs() < tolerance, "{fastest}");
            assert!(numerical_relative(&report) < 1e-12, "{:e}", numerical_relative(&report));
            assert_closes(&report);
        }
    }
}

/// At the first instant: `alpha = -m g d sin(theta)/I`, and the centre of mass accelerates by `alpha x r - w^2 r`.
#[test]
fn pendulum_accelerates_as_its_equation_says() {
    let (d, theta, w) = (0.37, 0.8, 1.7);
    let body = hanging(DVec3::Z * d, about_y(theta)).velocity(Velocity::new(DVec3::ZERO, DVec3::Y * w));
    let scene = Scene::builder("pendulum").body(body).build().unwrap();
    let found = Simulation::new(&scene).unwrap().accelerations().unwrap()[0];
    let alpha = DVec3::Y * (-BRICK_MASS * G * d * theta.sin() / swing_moment(d));
    let arm = about_y(theta).rotate(DVec3::NEG_Z * d);
    assert!((found.angular - alpha).length() < 1e-13, "{found:?} {alpha}");
    assert!((found.linear - (alpha.cross(arm) - arm * (w * w))).length() < 1e-13, "{found:?}");
    // The pivot bears what the weight does not explain, as a constraint and in the reduced motion.
    let borne = (found.linear + DVec3::Z * G) * BRICK_MASS;
    for effects in [Effects::Planned, Effects::All] {
        let pivots = Simulation::with_effects(&scene, effects).unwrap().pivots();
        assert_eq!(pivots.len(), 1);
        assert!((pivots[0].force_n - borne).length() < 1e-12, "{pivots:?} {borne}");
        assert!((pivots[0].point_m - HOOK).length() < 1e-15);
    }
}

/// Steady precession of a heavy symmetric top: `(I3 - I1) cos(theta) W^2 + I3 s W - m g l = 0`, with the spin s about
/// its own axis and moments about the pivot. The axis goes round at the rate W and keeps its tilt.
#[test]
fn symmetric_top_precesses_steadily() {
    let (mass, l, i1, i3, tilt, w) = (0.9, 0.25, 0.02, 0.013, 0.7, 1.9);
    let about_pivot = i1 + mass * l * l;
    let spin = (mass * G * l - (i3 - about_pivot) * f64::cos(tilt) * w * w) / (i3 * w);
    let inertia = Inertia::from_diagonal(DVec3::new(i1, i1, i3)).unwrap();
    let properties = MassProperties::new(Mass::new(mass).unwrap(), DVec3::ZERO, inertia);
    let turn = about_y(tilt);
    let axis = turn.rotate(DVec3::Z);
    let body = Body::movable("top", properties)
        .pose(Pose::new(turn, HOOK + axis * l))
        .pivot(HOOK)
        .velocity(Velocity::new(DVec3::ZERO, DVec3::Z * w + axis * spin));
    let scene = Scene::builder("top").duration_s(5.0).output_interval_s(0.3).body(body).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    for (&t, row) in recorder.times_s.iter().zip(&recorder.samples) {
        let expected = Rotation::from_rotation_vector(DVec3::Z * (w * t)).rotate(axis);
        let found = row[0].pose.rotation.rotate(DVec3::Z);
        assert!((found - expected).length() < 1e-10, "{t}: {:e}", (found - expected).length());
    }
    assert!(numerical_relative(&report) < 1e-12);
    assert_closes(&report);
}

/// A pivot off the principal axes: the energy and the vertical angular momentum are conserved, and splitting with small
/// steps finds the same motion.
#[test]
fn pivot_off_the_principal_axes_keeps_energy_and_vertical_momentum() {
    let at = DVec3::new(0.03, 0.08, 0.31);
    let turn = Rotation::from_rotation_vector(DVec3::new(0.9, -0.5, 0.4));
    let body = hanging(at, turn).velocity(Velocity::new(DVec3::ZERO, DVec3::new(1.0, 4.0, -2.0)));
    let scene = Scene::builder("odd pendulum").duration_s(3.0).output_interval_s(0.3).body(body).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let properties = scene.bodies()[0].mass_properties().unwrap();
    let vertical = |row: &[polhode::BodySample]| {
        let (pose, velocity) = (row[0].pose, row[0].velocity);
        let inertia = properties.inertia().matrix();
        let own = pose.rotation.rotate(inertia * pose.rotation.inverse_rotate(velocity.angular));
        (own + (pose.translation - HOOK).cross(velocity.linear) * BRICK_MASS).z
    };
    let first = vertical(&recorder.samples[0]);
    for row in &recorder.samples {
        assert!((vertical(row) / first - 1.0).abs() < 1e-11, "{:e}", vertical(row) / first - 1.0);
    }
    assert!(numerical_relative(&report) < 1e-12);
    assert_closes(&report);
    let (split, _) = run(&scene.with_method(by(Integrator::Splitting6, 1e-3)), Effects::Planned);
    let apart = split.bodies[0].state.pose.rotation.angle_to(report.bodies[0].state.pose.rotation);
    assert!(apart < 1e-9, "{apart:e}");
}

/// A gyroscope held at its centre of mass feels no torque of gravity: it follows the flight record of the same body
/// free in space.
#[test]
fn balanced_gyroscope_turns_as_a_free_body() {
    let spin = Velocity::new(DVec3::ZERO, DVec3::new(3.0, 0.2, 40.0));
    let turn = Rotation::from_rotation_vector(DVec3::new(0.2, 0.1, -0.3));
    let held = hanging(DVec3::ZERO, turn).velocity(spin);
    let free = heavy_brick("pendulum", BRICK_MASS, SIZE, DVec3::ZERO).pose(Pose::new(turn, HOOK)).velocity(spin);
    let held = Scene::builder("gyroscope").duration_s(20.0).body(held).build().unwrap();
    let free = Scene::builder("free").gravity(DVec3::ZERO).duration_s(20.0).body(free).build().unwrap();
    let (held, _) = run(&held, Effects::Planned);
    let (free, _) = run(&free, Effects::Planned);
    assert_eq!(held.bodies, free.bodies);
    let flight = held.plan.effects.iter().find(|effect| effect.effect == Effect::BallisticFlight).unwrap();
    assert_eq!(flight.decision, Decision::On);
    assert_closes(&held);
}

/// A ball strikes a rod that hangs from a pivot: `J = (1 + e) v/(1/m + d^2/I)`. The energy (with e = 1) and the angular
/// momentum about the pivot are conserved; the ledger books the impulse of the pivot as one of the world.
#[test]
fn ball_strikes_a_pivoted_rod() {
    let (m, v, d, radius, arm) = (0.3, 2.0, 0.6, 0.05, 0.4);
    for (e, gap) in [(1.0, 0.2), (0.5, 0.2), (1.0, 0.0)] {
        let ball = ball("ball", m, radius, HOOK + DVec3::new(0.05 + radius + gap, 0.0, -d), DVec3::NEG_X * v);
        let scene = Scene::builder("struck rod")
            .method(accurate())
            .gravity(DVec3::ZERO)
            .duration_s(0.3)
            .body(hanging(DVec3::Z * arm, Rotation::IDENTITY).material(elastic(e)))
            .body(ball.material(elastic(e)))
            .build()
            .unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        let moment = swing_moment(arm);
        let impulse = (1.0 + e) * v / (1.0 / m + d * d / moment);
        let events: Vec<_> = recorder.events.iter().filter(|event| event.kind == EventKind::Impact).collect();
        assert_eq!(events.len(), 1);
        assert!((events[0].t_s - gap / v).abs() < 1e-13 && (events[0].impulse / impulse - 1.0).abs() < 1e-12);
        let (rod, ball) = (report.bodies[0].state, report.bodies[1].state);
        assert!((rod.velocity.angular - DVec3::Y * (impulse * d / moment)).length() < 1e-12, "{rod:?}");
        assert!((ball.velocity.linear.x - (impulse / m - v)).abs() < 1e-12, "{ball:?}");
        let momentum = moment * rod.velocity.angular.y - m * d * (ball.velocity.linear.x);
        assert!((momentum / (m * v * d) - 1.0).abs() < 1e-12, "{momentum}");
        if e == 1.0 {
            assert!((report.energy.final_j / report.energy.initial_j - 1.0).abs() < 1e-12);
        }
        assert_closes(&report);
    }
}

/// A pendulum swings under gravity against a wall, again and again, with e = 1: it returns to its starting height.
#[test]
fn pendulum_bounces_off_a_wall() {
    let d = 0.4;
    let wall = Body::fixed("wall")
        .geometry(polhode::contact::Shape::cuboid(DVec3::new(0.2, 1.0, 1.6)).unwrap().into())
        .pose(Pose::from_translation(HOOK + DVec3::new(0.05 + 0.1, 0.0, -1.0)))
        .material(elastic(1.0));
    // The wall stands where the pendulum hangs straight down, so that its period is half of that of the free pendulum.
    let amplitude = 1.0;
    let rate = f64::sqrt(BRICK_MASS * G * d / swing_moment(d));
    let period = 4.0 * complete_elliptic(f64::sin(0.5 * amplitude)) / rate;
    let scene = Scene::builder("bouncing pendulum")
        .method(accurate())
        .duration_s(2.6 * period)
        .body(hanging(DVec3::Z * d, about_y(amplitude)).material(elastic(1.0)))
        .body(wall)
        .build()
        .unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let mut times: Vec<f64> =
        recorder.events.iter().filter(|event| event.kind == EventKind::Impact).map(|event| event.t_s).collect();
    times.dedup();
    assert_eq!(times.len(), 5, "{times:?}");
    for (number, t) in times.iter().enumerate() {
        let expected = (0.25 + 0.5 * number as f64) * period;
        assert!((t - expected).abs() < 1e-9, "{number}: {t} {expected}");
    }
    assert!(report.certificate.max_penetration_m <= 1e-12);
    assert!(numerical_relative(&report) < 1e-12);
    assert_closes(&report);
}

/// A pendulum leans on a stop and rests there; its own weight holds it.
#[test]
fn pendulum_comes_to_rest_on_a_stop() {
    let stop = Body::fixed("stop")
        .geometry(polhode::contact::Shape::sphere(0.1).unwrap().into())
        .pose(Pose::from_translation(HOOK + DVec3::new(-0.2, 0.0, -0.6)))
        .material(elastic(0.3));
    let scene = Scene::builder("leaning")
        .method(accurate())
        .duration_s(3.0)
        .body(hanging(DVec3::Z * 0.4, about_y(0.9)).material(elastic(0.3)))
        .body(stop)
        .build()
        .unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    assert!(report.bodies[0].state.velocity.is_zero(), "{:?} {:?}", report.bodies[0], recorder.events.last());
    assert_closes(&report);
}

/// A velocity that would move the pivot is refused; one of a rotation about the pivot is accepted.
#[test]
fn velocity_that_moves_the_pivot_is_refused() {
    let w = DVec3::Y * 2.0;
    let body = hanging(DVec3::Z * 0.4, Rotation::IDENTITY);
    let fits = body.clone().velocity(Velocity::new(w.cross(DVec3::NEG_Z * 0.4), w));
    assert!(Scene::builder("fits").body(fits).build().is_ok());
    let off = body.velocity(Velocity::new(DVec3::X, w));
    assert!(matches!(Scene::builder("off").body(off).build(), Err(SceneError::PivotMoves { .. })));
}
