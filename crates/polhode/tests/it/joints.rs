//! Joints: bodies that a ball joint or a hinge holds together move as the equations in their angles say, and stay
//! together.
//!
//! Oracles are the equations of motion in angles, integrated to rounding, and closed forms. No joint does work:
//! the energy stays, the ledger closes, and what projections take is rounding.

use crate::checks::assert_closes;
use crate::friction::rough;
use crate::support::{accurate, brick, floor, run};
use polhode::dynamics::{Rk4, System};
use polhode::mesh::solid_box;
use polhode::scene::{Integrator, Joint, Method, SceneError, Tier};
use polhode::spatial::{DVec3, Mass, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodyId, BodySample, Effects, RunReport, Scene, SceneBuilder, Simulation};

const G: f64 = 9.81;

/// A uniform rod with its centre at `center`, along a direction in the plane y = 0 that is turned by `angle` from -z
/// towards x.
pub(crate) fn rod(name: &str, (mass, length): (f64, f64), center: DVec3, angle: f64) -> Body {
    let size = DVec3::new(0.02, 0.02, length);
    let attitude = Rotation::from_rotation_vector(DVec3::Y * -angle);
    Body::movable(name, solid_box(size, Mass::new(mass).unwrap()).unwrap()).pose(Pose::new(attitude, center))
}

/// The direction at an angle from -z towards x.
pub(crate) fn down(angle: f64) -> DVec3 {
    DVec3::new(angle.sin(), 0.0, -angle.cos())
}

/// The moment of inertia of a rod of [`rod`] about its centre, across its length.
pub(crate) fn inertia((mass, length): (f64, f64)) -> f64 {
    mass / 12.0 * (length * length + 4e-4)
}

/// A chain of rods that hangs at the origin by hinges along y, at these angles and at rest.
fn chain(rods: &[(f64, f64)], angles: &[f64], turned: Rotation) -> SceneBuilder {
    let mut builder = Scene::builder("chain").method(accurate()).gravity(turned.rotate(DVec3::Z * -G));
    let mut top = DVec3::ZERO;
    for (number, (&(mass, length), &angle)) in rods.iter().zip(angles).enumerate() {
        let body = rod(&format!("rod {number}"), (mass, length), top + down(angle) * (0.5 * length), angle);
        let pose = Pose::new(turned, DVec3::ZERO) * *body.initial_pose();
        let axis = UnitVector::new(turned.rotate(DVec3::Y)).unwrap();
        let joint = Joint::hinge(BodyId::new(number), turned.rotate(top), axis);
        builder =
            builder.body(body.pose(pose)).joint(if number > 0 { joint.with(BodyId::new(number - 1)) } else { joint });
        top += down(angle) * length;
    }
    builder
}

/// The equations of a double pendulum in its two angles.
struct DoublePendulum {
    rods: [(f64, f64); 2],
}

impl System for DoublePendulum {
    type Error = std::convert::Infallible;

    fn dimension(&self) -> usize {
        4
    }

    fn derivative(&mut self, _t: f64, state: &[f64], rates: &mut [f64]) -> Result<(), Self::Error> {
        let [(m1, l1), (m2, l2)] = self.rods;
        let &[a, b, u, v] = state else { return Ok(()) };
        let (sin, cos) = (a - b).sin_cos();
        let m11 = inertia(self.rods[0]) + 0.25 * m1 * l1 * l1 + m2 * l1 * l1;
        let (m12, m22) = (0.5 * m2 * l1 * l2 * cos, inertia(self.rods[1]) + 0.25 * m2 * l2 * l2);
        let f1 = -0.5 * m2 * l1 * l2 * sin * v * v - (0.5 * m1 + m2) * G * l1 * a.sin();
        let f2 = 0.5 * m2 * l1 * l2 * sin * u * u - 0.5 * m2 * G * l2 * b.sin();
        let determinant = m11 * m22 - m12 * m12;
        rates.copy_from_slice(&[u, v, (m22 * f1 - m12 * f2) / determinant, (m11 * f2 - m12 * f1) / determinant]);
        Ok(())
    }
}

/// Integrates over a time by the classical method, in steps so short that its error is rounding.
pub(crate) fn integrate<S: System<Error = std::convert::Infallible>>(system: &mut S, t: f64, state: &mut [f64]) {
    let (steps, mut method) = (20_000, Rk4::new(state.len()));
    let h = t / f64::from(steps);
    for step in 0..steps {
        let Ok(()) = method.step(system, h * f64::from(step), h, state);
    }
}

/// The angles of a double pendulum after a time, from rest.
fn angles_after(rods: [(f64, f64); 2], angles: [f64; 2], t: f64) -> [f64; 2] {
    let mut state = vec![angles[0], angles[1], 0.0, 0.0];
    integrate(&mut DoublePendulum { rods }, t, &mut state);
    [state[0], state[1]]
}

/// No joint does work, and the bodies stay together.
#[track_caller]
pub(crate) fn assert_held(report: &RunReport) {
    assert!(report.ledger.numerical.value().abs() < 1e-11 * report.ledger.scale_j, "{:?}", report.ledger);
    assert!(report.ledger.projection.value().abs() < 1e-11 * report.ledger.scale_j, "{:?}", report.ledger);
    assert_closes(report);
}

/// Double pendulums of other lengths and masses, level and upright, in the plane y = 0 and turned in space.
#[test]
fn double_pendulum_moves_as_the_equations_in_its_angles_say() {
    let cases = [
        ([(1.0, 1.0), (1.0, 1.0)], [1.5, 1.2]),
        ([(2.0, 0.3), (0.7, 0.5)], [0.4, -1.1]),
        ([(0.5, 0.2), (5.0, 0.4)], [-2.0, 0.3]),
    ];
    for (rods, angles) in cases {
        for turned in [Rotation::IDENTITY, Rotation::from_rotation_vector(DVec3::new(0.3, -0.8, 0.5))] {
            let duration = 1.0;
            let scene = chain(&rods, &angles, turned).duration_s(duration).build().unwrap();
            let (report, _) = run(&scene, Effects::Planned);
            let [a, b] = angles_after(rods, angles, duration);
            let upper = down(a) * (0.5 * rods[0].1);
            let lower = down(a) * rods[0].1 + down(b) * (0.5 * rods[1].1);
            for (body, place) in [upper, lower].into_iter().enumerate() {
                let off = (report.bodies[body].state.pose.translation - turned.rotate(place)).length();
                assert!(off < 1e-9, "{rods:?} rod {body}: {off:e} m off");
            }
            assert_held(&report);
        }
    }
}

/// A body on a ball joint with the world moves as one on a pivot.
#[test]
fn ball_joint_with_the_world_is_a_pivot() {
    let at = |joint: bool| {
        let turning = DVec3::new(1.0, -2.0, 8.0);
        let center = DVec3::new(0.2, 0.1, 0.4);
        let body = rod("top", (1.3, 0.5), center, 0.3).velocity(Velocity::new(turning.cross(center), turning));
        let builder = Scene::builder("top").method(accurate()).duration_s(0.7);
        let builder = if joint {
            builder.body(body).joint(Joint::ball(BodyId::new(0), DVec3::ZERO))
        } else {
            builder.body(body.pivot(DVec3::ZERO))
        };
        run(&builder.build().unwrap(), Effects::Planned).0
    };
    let [joint, pivot] = [at(true), at(false)].map(|report| {
        assert_held(&report);
        report.bodies[0].state
    });
    assert!((joint.pose.translation - pivot.pose.translation).length() < 1e-9);
    assert!((joint.velocity.angular - pivot.velocity.angular).length() < 1e-7);
}

/// A parallelogram of four bars, one of them the world, closed by four hinges: five rows each, three of them redundant.
/// Its coupler stays level, and its cranks swing as one pendulum.
#[test]
fn overconstrained_four_bar_swings_as_one_pendulum() {
    let (crank, span) = ((0.8, 0.3), (1.7, 0.5));
    let angle: f64 = 0.9;
    let left = DVec3::ZERO;
    let right = DVec3::X * span.1;
    let (low_left, low_right) = (left + down(angle) * crank.1, right + down(angle) * crank.1);
    let level = std::f64::consts::FRAC_PI_2;
    let middle = |one: DVec3, other: DVec3| (one + other) * 0.5;
    let builder = Scene::builder("four-bar").method(accurate()).duration_s(1.0);
    let scene = builder
        .body(rod("left", crank, middle(left, low_left), angle))
        .body(rod("right", crank, middle(right, low_right), angle))
        .body(rod("coupler", span, middle(low_left, low_right), level))
        .joint(Joint::hinge(BodyId::new(0), left, UnitVector::Y))
        .joint(Joint::hinge(BodyId::new(1), right, UnitVector::Y))
        .joint(Joint::hinge(BodyId::new(2), low_left, UnitVector::Y).with(BodyId::new(0)))
        .joint(Joint::hinge(BodyId::new(2), low_right, UnitVector::Y).with(BodyId::new(1)))
        .build()
        .unwrap();
    let (report, _) = run(&scene, Effects::Planned);
    // With one crank of the sums: I = 2 (I_c + m l^2/4) + M l^2, moment (m + M) g l sin.
    let whole = 2.0 * (inertia(crank) + 0.25 * crank.0 * crank.1 * crank.1) + span.0 * crank.1 * crank.1;
    let rate = (crank.0 + span.0) * G * crank.1 / whole;
    let mut state = vec![angle, 0.0];
    integrate(&mut Pendulum { rate }, 1.0, &mut state);
    let wanted = middle(left, right) + down(state[0]) * crank.1;
    let coupler = report.bodies[2].state.pose;
    assert!((coupler.translation - wanted).length() < 1e-10, "{:e}", (coupler.translation - wanted).length());
    assert!(coupler.rotation.rotate(DVec3::Z).z.abs() < 1e-10);
    assert_held(&report);
}

/// `a'' = -rate sin a`.
pub(crate) struct Pendulum {
    pub(crate) rate: f64,
}

impl System for Pendulum {
    type Error = std::convert::Infallible;

    fn dimension(&self) -> usize {
        2
    }

    fn derivative(&mut self, _t: f64, state: &[f64], rates: &mut [f64]) -> Result<(), Self::Error> {
        rates.copy_from_slice(&[state[1], -self.rate * state[0].sin()]);
        Ok(())
    }
}

/// Two jointed bodies that nothing holds: their momentum and energy stay, and their centre of mass flies on a parabola.
#[test]
fn jointed_bodies_in_flight_keep_their_momentum() {
    let (one, two) = ((1.0, 0.4), (3.0, 0.6));
    let turning = DVec3::Y * 3.0;
    let body = |name: &str, of: (f64, f64), center: DVec3| {
        rod(name, of, center, 0.0).velocity(Velocity::new(DVec3::new(0.5, 0.2, 1.0) + turning.cross(center), turning))
    };
    let scene = Scene::builder("thrown").method(accurate()).duration_s(1.0);
    let scene = scene
        .body(body("one", one, DVec3::Z * 0.2))
        .body(body("two", two, DVec3::Z * -0.3))
        .joint(Joint::hinge(BodyId::new(0), DVec3::ZERO, UnitVector::Y).with(BodyId::new(1)));
    let scene = scene.build().unwrap();
    let center = |at: [DVec3; 2]| (at[0] * one.0 + at[1] * two.0) / (one.0 + two.0);
    let start = center([DVec3::Z * 0.2, DVec3::Z * -0.3]);
    let speed = DVec3::new(0.5, 0.2, 1.0) + turning.cross(start);
    let (report, _) = run(&scene, Effects::Planned);
    let end = center([report.bodies[0].state.pose.translation, report.bodies[1].state.pose.translation]);
    assert!((end - start - speed + DVec3::Z * (0.5 * G)).length() < 1e-12);
    assert_held(&report);
}

/// The joints of a scene that cannot hold are refused, each with what is wrong.
#[test]
fn joints_that_cannot_hold_are_refused() {
    let body = |name: &str| rod(name, (1.0, 0.5), DVec3::ZERO, 0.0);
    let with = |joint: Joint| Scene::builder("refused").body(body("a")).body(body("b")).joint(joint).build();
    assert!(matches!(with(Joint::ball(BodyId::new(7), DVec3::ZERO)), Err(SceneError::UnknownBody(7))));
    assert!(matches!(
        with(Joint::ball(BodyId::new(0), DVec3::ZERO).with(BodyId::new(0))),
        Err(SceneError::Joint { number: 0, .. })
    ));
    assert!(matches!(with(Joint::ball(BodyId::new(0), DVec3::NAN)), Err(SceneError::Joint { number: 0, .. })));
    let moving = body("a").velocity(Velocity::new(DVec3::X, DVec3::ZERO));
    let parts = Scene::builder("parts").body(moving).joint(Joint::ball(BodyId::new(0), DVec3::ZERO)).build();
    assert!(matches!(parts, Err(SceneError::JointMoves { number: 0, .. })));
    let turning = body("a").velocity(Velocity::new(DVec3::ZERO, DVec3::X));
    let turns =
        Scene::builder("turns").body(turning).joint(Joint::hinge(BodyId::new(0), DVec3::ZERO, UnitVector::Y)).build();
    assert!(matches!(turns, Err(SceneError::JointTurns { number: 0, .. })));
    let thesis = Method { tier: Some(Tier::Thesis), ..Method::default() };
    let splitting = Method { integrator: Some(Integrator::ExactStrang), ..Method::default() };
    let by = |method| {
        Scene::builder("method").method(method).body(body("a")).joint(Joint::ball(BodyId::new(0), DVec3::ZERO)).build()
    };
    assert!(matches!(by(thesis), Err(SceneError::JointsInTier { .. })));
    assert!(matches!(by(splitting), Err(SceneError::JointsWithIntegrator { .. })));
}

/// Tier `stepped` takes joints: the double pendulum converges to that of the equations with the square of the step, no
/// joint does work, and the bodies stay together.
#[test]
fn time_steps_of_jointed_bodies_are_of_second_order() {
    let (rods, angles, duration) = ([(1.0, 1.0), (1.0, 0.7)], [1.2, 0.4], 0.5);
    let [a, b] = angles_after(rods, angles, duration);
    let lower = down(a) * rods[0].1 + down(b) * (0.5 * rods[1].1);
    let error = |step_s: f64| {
        let method = Method { tier: Some(Tier::Stepped), step_s: Some(step_s), ..Method::default() };
        let scene = chain(&rods, &angles, Rotation::IDENTITY).method(method).duration_s(duration).build().unwrap();
        let (report, _) = run(&scene, Effects::Planned);
        assert!(report.ledger.impact.value().abs() < 1e-12 * report.ledger.scale_j, "{:?}", report.ledger);
        assert_closes(&report);
        (report.bodies[1].state.pose.translation - lower).length()
    };
    let [coarse, fine] = [1e-2, 5e-3].map(error);
    assert!(fine < 1e-3 && (3.0..5.5).contains(&(coarse / fine)), "{coarse:e} {fine:e}");
}

/// A chain of five rods that hangs level and falls on a rough floor: contacts crowd, and joints hold through impacts
/// and time steps. Energy only falls, and the rods end together on the floor.
#[test]
fn a_chain_that_falls_on_a_rough_floor_stays_together() {
    for tier in [Tier::Accurate, Tier::Stepped] {
        let method = Method {
            tier: Some(tier),
            step_s: Some(if tier == Tier::Stepped { 1e-3 } else { 1e-2 }),
            ..Method::default()
        };
        let length = 0.2;
        let mut builder = Scene::builder("fallen chain").method(method).duration_s(0.6);
        let level = std::f64::consts::FRAC_PI_2;
        for number in 0..5 {
            let at = f64::from(number);
            let center = DVec3::new((at + 0.5) * length, 0.0, 0.25 + 0.02 * at);
            let body = rod(&format!("rod {number}"), (0.5, length), center, level);
            builder = builder.body(body.material(rough(0.4)));
        }
        builder = builder.body(floor().material(rough(0.4)));
        for number in 1..5_usize {
            let at = number as f64;
            let anchor = DVec3::new(at * length, 0.0, 0.25 + 0.02 * (at - 0.5));
            builder = builder.joint(Joint::ball(BodyId::new(number), anchor).with(BodyId::new(number - 1)));
        }
        let scene = builder.build().unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        assert_eq!(report.simulated_s, 0.6);
        assert_closes(&report);
        assert!(report.energy.final_j < report.energy.initial_j, "{:?}", report.energy);
        let parts = |sample: &Vec<BodySample>| {
            (1..5_usize)
                .map(|number| {
                    let at = number as f64;
                    let anchor = DVec3::new(at * length, 0.0, 0.25 + 0.02 * (at - 0.5));
                    let place = |body: usize| {
                        let start = scene.bodies()[body].initial_pose().inverse_transform_point(anchor);
                        sample[body].pose.transform_point(start)
                    };
                    (place(number) - place(number - 1)).length()
                })
                .fold(0.0, f64::max)
        };
        let most = recorder.samples.iter().map(parts).fold(0.0, f64::max);
        assert!(most < 1e-10, "{tier:?}: {most:e} m apart");
        assert!(recorder.samples.last().unwrap()[..5].iter().all(|body| body.pose.translation.z < 0.1));
    }
}

/// An impulse on one of two jointed rods moves both, as the equations in the angles say: `M q' = p l` at the tip of the
/// lower one. The pose of a jointed body cannot be set away from its joint.
#[test]
fn a_program_strikes_a_jointed_body() {
    let rods = [(1.5, 0.4), (0.5, 0.6)];
    let scene = chain(&rods, &[0.0, 0.0], Rotation::IDENTITY).build().unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    let [upper, lower] = ["rod 0", "rod 1"].map(|name| simulation.body_id(name).unwrap());
    let impulse = 0.3;
    simulation.apply_impulse(lower, DVec3::X * impulse, DVec3::Z * -1.0).unwrap();
    let [(m1, l1), (m2, l2)] = rods;
    let m11 = inertia(rods[0]) + 0.25 * m1 * l1 * l1 + m2 * l1 * l1;
    let (m12, m22) = (0.5 * m2 * l1 * l2, inertia(rods[1]) + 0.25 * m2 * l2 * l2);
    let determinant = m11 * m22 - m12 * m12;
    let rates = [(m22 * l1 - m12 * l2) * impulse / determinant, (m11 * l2 - m12 * l1) * impulse / determinant];
    for (body, rate) in [upper, lower].into_iter().zip(rates) {
        let turning = simulation.body(body).velocity.angular;
        assert!((turning + DVec3::Y * rate).length() < 1e-12 * rate.abs(), "{turning:?} {rate}");
    }
    let away = Pose::from_translation(DVec3::X);
    assert!(simulation.set_pose(lower, away).is_err());
    let before = simulation.energy();
    simulation.advance_to(0.5).unwrap();
    let after = simulation.energy();
    let total = |energy: polhode::Energy| energy.kinetic_j + energy.potential_j;
    assert!((total(before) - total(after)).abs() < 1e-11, "{before:?} {after:?}");
}

/// Where the lower rod of a double pendulum is taken away the upper one goes on as a pendulum alone, with the velocity
/// that it has; its joint goes with the rod. The state goes through a snapshot bit by bit, before and after.
#[test]
fn a_joint_goes_with_a_body_that_is_removed() {
    let rods = [(1.0, 0.5), (0.7, 0.4)];
    let scene = chain(&rods, &[0.9, -0.4], Rotation::IDENTITY).build().unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    simulation.advance_to(0.3).unwrap();
    let mut restored = Simulation::new(&scene).unwrap();
    restored.restore(&simulation.snapshot()).unwrap();
    let [upper, lower] = ["rod 0", "rod 1"].map(|name| simulation.body_id(name).unwrap());
    let before = simulation.body(upper).velocity.angular;
    for simulation in [&mut simulation, &mut restored] {
        simulation.remove_body(lower).unwrap();
        simulation.advance_to(0.8).unwrap();
    }
    let [one, two] = [&simulation, &restored].map(|simulation| simulation.body(upper).pose);
    assert_eq!(one, two);
    // The energy about the hinge stays from there on: the oracle starts where the rod was left alone.
    let mut alone = Simulation::new(&scene).unwrap();
    alone.advance_to(0.3).unwrap();
    let start = alone.body(alone.body_id("rod 0").unwrap()).pose;
    let angle = start.translation.x.atan2(-start.translation.z);
    let whole = inertia(rods[0]) + 0.25 * rods[0].0 * rods[0].1 * rods[0].1;
    let mut state = vec![angle, -before.y];
    integrate(&mut Pendulum { rate: 0.5 * rods[0].0 * rods[0].1 * G / whole }, 0.5, &mut state);
    let wanted = down(state[0]) * (0.5 * rods[0].1);
    assert!((one.translation - wanted).length() < 1e-9, "{:?} {wanted:?}", one.translation);
}

/// A rod that hangs at a pivot and a second one at its end move as the double pendulum, and the ledgers of energy and
/// of momentum close, in the tier of fixed steps too, where the motion of a body on a pivot alone is reduced to a
/// rotation.
#[test]
fn a_joint_to_a_body_on_a_pivot_closes_the_ledgers() {
    let (rods, angles, t) = ([(1.0, 0.5), (0.7, 0.4)], [1.1, 0.6], 0.5);
    let joint = down(angles[0]) * rods[0].1;
    let place = |angles: [f64; 2]| down(angles[0]) * rods[0].1 + down(angles[1]) * (0.5 * rods[1].1);
    let end = place(angles_after(rods, angles, t));
    for (method, allowed) in
        [(accurate(), 1e-9), (Method { tier: Some(Tier::Stepped), step_s: Some(5e-4), ..Method::default() }, 1e-4)]
    {
        let scene = Scene::builder("pivot and joint")
            .method(method)
            .duration_s(t)
            .body(rod("upper", rods[0], down(angles[0]) * (0.5 * rods[0].1), angles[0]).pivot(DVec3::ZERO))
            .body(rod("lower", rods[1], place(angles), angles[1]))
            .joint(Joint::ball(BodyId::new(1), joint).with(BodyId::new(0)));
        let (report, _) = run(&scene.build().unwrap(), Effects::Planned);
        let off = (report.bodies[1].state.pose.translation - end).length();
        assert!(off < allowed, "{off:e} m off");
        assert_closes(&report);
    }
}

/// A body that touches nothing rests with the one that a joint holds it to: an arm whose foot stands on the floor stays
/// where it is. It once fell through the floor with its foot, since nothing that it touched held it.
#[test]
fn what_a_joint_holds_to_a_resting_body_rests_with_it() {
    for fall in [0.0, 0.05] {
        let foot = brick("foot", DVec3::new(0.4, 0.4, 0.1), DVec3::Z * (0.05 + fall));
        let arm = brick("arm", DVec3::new(0.1, 0.1, 0.6), DVec3::Z * (0.45 + fall));
        let joint = Joint::hinge(BodyId::new(1), DVec3::Z * (0.1 + fall), UnitVector::Y).with(BodyId::new(2));
        let scene = Scene::builder("lamp").method(accurate()).duration_s(2.0).body(floor()).body(foot).body(arm);
        let (report, _) = run(&scene.joint(joint).build().unwrap(), Effects::Planned);
        for (body, z) in [(1, 0.05), (2, 0.45)] {
            let off = (report.bodies[body].state.pose.translation - DVec3::Z * z).length();
            assert!(off < 1e-11, "body {body}: {off:e} m off");
        }
        assert!(report.certificate.max_penetration_of_limit < 1.0);
    }
}

/// What a joint bears and how bodies begin to move are those of all bodies that joints connect, also where nothing
/// touches: of two rods that hang at each other the upper hinge bears both, and let go level the first one begins with
/// 9/7 and the second with -3/7 of g/l (thin rods).
#[test]
fn jointed_bodies_bear_and_begin_together() {
    let own = (1.0, 1.0);
    let pair = |angle: f64| {
        let (upper, lower) = (down(angle) * 0.5, down(angle) * 1.5);
        let mut scene = Scene::builder("two rods").method(accurate()).gravity(DVec3::Z * -9.81);
        let first = scene.add_body(rod("upper", own, upper, angle));
        let second = scene.add_body(rod("lower", own, lower, angle));
        let scene = scene.joint(Joint::hinge(first, DVec3::ZERO, UnitVector::Y));
        let scene = scene.joint(Joint::hinge(second, down(angle), UnitVector::Y).with(first));
        Simulation::new(&scene.build().unwrap()).unwrap()
    };
    let hanging = pair(0.0);
    for (load, bodies) in hanging.joint_loads().iter().zip([2.0, 1.0]) {
        assert!((load.force_n - DVec3::Z * (bodies * 9.81)).length() < 1e-11, "{load:?}");
    }
    // Lagrange: (I + 5/4) a + 1/2 b = 3/2 g and 1/2 a + (I + 1/4) b = g/2, with I the moment of a rod about its middle.
    let moment = inertia(own);
    let (a, b, c) = (moment + 1.25, 0.5, moment + 0.25);
    let determinant = a * c - b * b;
    let expected = [(1.5 * c - 0.5 * b) / determinant, (0.5 * a - 1.5 * b) / determinant].map(|own| own * 9.81);
    let found = pair(std::f64::consts::FRAC_PI_2).accelerations().unwrap();
    for (own, expected) in found.iter().zip(expected) {
        assert!((own.angular.length() - expected.abs()).abs() < 1e-10, "{own:?} {expected}");
    }
}
