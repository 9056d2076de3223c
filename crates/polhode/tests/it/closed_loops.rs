//! Closed loops of joints move in time steps, and the error is of the second order in the step: four-bars, loops in
//! space and loops in flight, whatever the principal axes of their bodies and the attitude of the whole. Rows of such
//! loops depend on each other; counted as independent by what a step opens them, they held the mechanism fast.

use crate::checks::assert_closes;
use crate::support::{accurate, brick, run};
use polhode::scene::{Coordinate, CoordinateMotion, Freedom, Joint, JointKind, Method, Tier};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodyId, Effects, RunReport, Scene};

const DURATION_S: f64 = 0.2;

fn stepped(step_s: f64) -> Method {
    Method { tier: Some(Tier::Stepped), step_s: Some(step_s), ..Method::default() }
}

/// A bar of unequal moments, whose principal axes are turned by this rotation vector.
fn bar(name: &str, place: DVec3, turn: DVec3) -> Body {
    let inertia = Inertia::from_diagonal(DVec3::new(0.01, 0.02, 0.025)).unwrap();
    let properties = MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia);
    Body::movable(name, properties).pose(Pose::new(Rotation::from_rotation_vector(turn), place))
}

/// A crank, a coupler and a rocker with the world, in this attitude as a whole; with bodies for the frame too if it
/// flies.
fn four_bar(method: Method, attitude: Rotation, flies: bool) -> Scene {
    let at = |x: f64, z: f64| attitude.rotate(DVec3::new(x, 0.0, z));
    let axis = UnitVector::new(attitude.rotate(DVec3::Y)).unwrap();
    let mut scene = Scene::builder("four-bar").method(method).duration_s(DURATION_S);
    let crank = scene.add_body(bar("crank", at(0.05, 0.15), DVec3::new(0.3, 0.5, 0.7)));
    let coupler = scene.add_body(bar("coupler", at(0.35, 0.35), DVec3::new(0.9, -0.2, 0.4)));
    let rocker = scene.add_body(bar("rocker", at(0.55, 0.2), DVec3::new(-0.4, 0.8, 0.1)));
    let frame = flies.then(|| scene.add_body(bar("frame", at(0.25, -0.1), DVec3::new(0.2, 0.1, -0.6))));
    let spring = Freedom::default().with_spring(8.0, 0.6).unwrap();
    let hinge = |body: BodyId, other: Option<BodyId>, anchor: DVec3| {
        let joint = Joint::hinge(body, anchor, axis);
        other.map_or(joint, |other| joint.with(other))
    };
    scene
        .joint(hinge(crank, frame, at(0.0, 0.0)))
        .joint(hinge(crank, Some(coupler), at(0.1, 0.3)).along(Coordinate::Angle, spring))
        .joint(hinge(coupler, Some(rocker), at(0.6, 0.4)))
        .joint(hinge(rocker, frame, at(0.5, 0.0)))
        .build()
        .unwrap()
}

/// A crank on a hinge, a coupler between two balls, of which one is a universal joint, and a rocker on a hinge of
/// another axis.
fn in_space(method: Method) -> Scene {
    let mut scene = Scene::builder("loop in space").method(method).duration_s(DURATION_S);
    let crank = scene.add_body(bar("crank", DVec3::new(0.05, 0.02, 0.15), DVec3::new(0.3, 0.5, 0.7)));
    let coupler = scene.add_body(bar("coupler", DVec3::new(0.35, 0.1, 0.35), DVec3::new(0.9, -0.2, 0.4)));
    let rocker = scene.add_body(bar("rocker", DVec3::new(0.55, 0.1, 0.2), DVec3::new(-0.4, 0.8, 0.1)));
    let axis = |x: f64, y: f64, z: f64| UnitVector::new(DVec3::new(x, y, z)).unwrap();
    let axes = [axis(0.0, 1.0, 0.0), axis(1.0, 0.0, 0.3)];
    scene
        .joint(Joint::hinge(crank, DVec3::ZERO, axis(0.1, 1.0, 0.2)))
        .joint(Joint::new(JointKind::Ball, crank, DVec3::new(0.1, 0.05, 0.3)).with(coupler))
        .joint(Joint::new(JointKind::Universal { axes }, coupler, DVec3::new(0.6, 0.15, 0.4)).with(rocker))
        .joint(Joint::hinge(rocker, DVec3::new(0.5, 0.1, 0.0), axis(-0.2, 1.0, 0.1)))
        .build()
        .unwrap()
}

/// How far bodies are from where they are in another run, m.
fn apart(report: &RunReport, other: &RunReport) -> f64 {
    let places = |report: &RunReport| report.bodies.iter().map(|body| body.state.pose.translation).collect::<Vec<_>>();
    places(report).iter().zip(places(other)).map(|(a, b)| (*a - b).length()).fold(0.0, f64::max)
}

#[track_caller]
fn assert_second_order(scene: impl Fn(Method) -> Scene) {
    let exact = run(&scene(accurate()), Effects::Planned).0;
    let errors = [4e-3, 2e-3, 1e-3].map(|step_s| {
        let (report, _) = run(&scene(stepped(step_s)), Effects::Planned);
        assert_closes(&report);
        assert_eq!(report.certificate.fallbacks, 0);
        apart(&report, &exact)
    });
    for pair in errors.windows(2) {
        let slope = (pair[0] / pair[1]).log2();
        assert!((1.8..2.2).contains(&slope), "slope {slope} of {errors:?}");
    }
}

#[test]
fn four_bars_of_any_attitude_move_as_they_do_exactly() {
    for turn in [DVec3::ZERO, DVec3::new(0.7, -0.4, 1.1)] {
        assert_second_order(|method| four_bar(method, Rotation::from_rotation_vector(turn), false));
    }
}

#[test]
fn a_four_bar_in_flight_moves_as_it_does_exactly() {
    assert_second_order(|method| four_bar(method, Rotation::from_rotation_vector(DVec3::new(0.2, 0.5, -0.3)), true));
}

#[test]
fn a_loop_in_space_moves_as_it_does_exactly() {
    assert_second_order(in_space);
}

/// Two shafts and a universal joint between them, the first of which is driven: `tan a_2 = cos b tan a_1`. Nothing
/// touches, and nothing is approximate or warned of; rows that only rounding fills are no problem without a solution.
#[test]
fn driven_shafts_with_a_universal_joint_warn_of_nothing() {
    let bend: f64 = 0.6;
    let rate: f64 = 5.0;
    let along = DVec3::new(bend.cos(), bend.sin(), 0.0);
    for method in [accurate(), stepped(1e-2)] {
        let mut scene = Scene::builder("shafts").method(method).gravity(DVec3::ZERO).duration_s(0.5);
        let shaft = |name: &str, place: DVec3, turn: DVec3, spin: DVec3| {
            let pose = Pose::new(Rotation::from_rotation_vector(turn), place);
            let body = brick(name, DVec3::new(0.5, 0.05, 0.05), DVec3::ZERO).pose(pose);
            body.velocity(Velocity::new(DVec3::ZERO, spin))
        };
        let first = scene.add_body(shaft("in", -0.25 * DVec3::X, DVec3::ZERO, DVec3::X * rate));
        // At the start the ratio of the rates is cos b.
        let second = scene.add_body(shaft("out", 0.25 * along, DVec3::Z * bend, along * (rate * bend.cos())));
        let axes = [DVec3::Z, DVec3::new(-bend.sin(), bend.cos(), 0.0)].map(|axis| UnitVector::new(axis).unwrap());
        let driven = scene.add_joint(Joint::hinge(first, -0.25 * DVec3::X, UnitVector::X));
        let built = scene
            .joint(Joint::hinge(second, 0.25 * along, UnitVector::new(along).unwrap()))
            .joint(Joint::new(JointKind::Universal { axes }, first, DVec3::ZERO).with(second))
            .coordinate_motion(driven, Coordinate::Angle, CoordinateMotion::rate(rate).unwrap())
            .build()
            .unwrap();
        let (report, _) = run(&built, Effects::Planned);
        assert_eq!(report.certificate.fallbacks, 0);
        assert!(report.warnings.is_empty(), "{:?}", report.warnings);
    }
}
