//! Reduced coordinates give the motion of maximal ones: of trees of all kinds of joints that they take, hung from the
//! world and free, with springs, dampers and motors; the ledger closes, and scenes for which there are none are refused
//! with the reason.

use crate::chains::chain;
use crate::checks::assert_closes;
use crate::support::{brick, floor, run};
use polhode::scene::{
    Coordinate, Coordinates, Drive, Freedom, Integrator, Joint, JointFriction, JointKind, Limits, Method, Motor,
    SceneError, Tier,
};
use polhode::spatial::{DVec3, UnitVector, Velocity};
use polhode::{Body, BodyId, Effects, RunReport, Scene, SceneBuilder, Simulation};

/// The size of the bodies, m.
const SIZE: f64 = 0.1;

fn method(coordinates: Coordinates) -> Method {
    Method { tier: Some(Tier::Accurate), coordinates: Some(coordinates), ..Method::default() }
}

/// A box without a shape that collides.
fn link(name: &str, size: DVec3, center: DVec3) -> Body {
    let solid = polhode::mesh::solid_box(size, polhode::spatial::Mass::new(0.5 + size.length()).unwrap()).unwrap();
    Body::movable(name, solid).pose(polhode::spatial::Pose::from_translation(center))
}

/// Six bodies: a trunk with two branches of two and one of a single body, on hinges, ball joints and sliders with
/// springs, dampers and a servo. The trunk hangs from the world, or moves freely and turns with all it bears.
fn tree(coordinates: Coordinates, is_free: bool) -> SceneBuilder {
    let velocity = |at: DVec3| {
        let turning = DVec3::new(0.4, -0.3, 0.5);
        if is_free { Velocity::new(DVec3::new(0.3, 0.1, 0.8) + turning.cross(at), turning) } else { Velocity::ZERO }
    };
    let places = [
        DVec3::ZERO,
        DVec3::new(0.5, 0.0, 0.1),
        DVec3::new(-0.4, 0.2, -0.1),
        DVec3::new(1.0, 0.1, 0.0),
        DVec3::new(-0.8, 0.5, -0.2),
        DVec3::new(0.1, -0.4, -0.5),
    ];
    let mut scene = Scene::builder("tree").method(method(coordinates)).duration_s(1.0);
    scene = scene.gravity(DVec3::new(0.3, -0.2, -9.81));
    for (number, place) in places.into_iter().enumerate() {
        let size = DVec3::new(0.2 + 0.03 * number as f64, 0.15, 0.3 - 0.02 * number as f64);
        scene = scene.body(link(&format!("link {number}"), size, place).velocity(velocity(place)));
    }
    let body = BodyId::new;
    let axis = |x: f64, y: f64, z: f64| UnitVector::new(DVec3::new(x, y, z)).unwrap();
    let spring = Freedom::default().with_spring(60.0, 0.02).unwrap().with_damping(0.7).unwrap();
    let servo = Motor::new(Drive::Position { position: 0.4, stiffness: 3.0, damping: 0.2 }).unwrap();
    let hinge = Joint::hinge(body(0), DVec3::new(0.25, 0.0, 0.0), axis(0.2, 1.0, 0.1)).with(body(1));
    let slider =
        Joint::new(JointKind::Slider { axis: axis(0.5, 0.2, 1.0) }, body(3), DVec3::new(0.8, 0.0, 0.1)).with(body(1));
    let elbow = Joint::hinge(body(4), DVec3::new(-0.6, 0.35, -0.1), axis(1.0, -0.3, 0.4)).with(body(2));
    scene = scene
        .joint(hinge)
        .joint(Joint::ball(body(2), DVec3::new(-0.2, 0.1, 0.0)).with(body(0)))
        .joint(slider.along(Coordinate::Displacement, spring))
        .joint(elbow.along(Coordinate::Angle, Freedom::default().with_motor(servo)))
        .joint(Joint::ball(body(5), DVec3::new(0.05, -0.2, -0.2)).with(body(0)));
    if is_free { scene } else { scene.joint(Joint::ball(body(0), DVec3::new(0.0, 0.0, 0.4))) }
}

/// The largest difference of places (m) and velocities (m/s), those of attitudes and angular velocities times the size
/// of a body, at all samples of two runs, and their reports.
fn compared(of: impl Fn(Coordinates) -> SceneBuilder) -> (f64, [RunReport; 2]) {
    let runs = [Coordinates::Maximal, Coordinates::Reduced].map(|coordinates| {
        let scene = of(coordinates).build().unwrap();
        run(&scene, Effects::Planned)
    });
    let [maximal, reduced] = runs.each_ref().map(|(_, recorder)| recorder);
    assert_eq!(maximal.times_s, reduced.times_s);
    let mut most = 0.0_f64;
    for (a, b) in maximal.samples.iter().flatten().zip(reduced.samples.iter().flatten()) {
        most = most.max((a.pose.translation - b.pose.translation).length());
        most = most.max(SIZE * a.pose.rotation.angle_to(b.pose.rotation));
        most = most.max((a.velocity.linear - b.velocity.linear).length());
        most = most.max(SIZE * (a.velocity.angular - b.velocity.angular).length());
    }
    (most, runs.map(|(report, _)| report))
}

#[test]
fn trees_move_as_in_maximal_coordinates() {
    for is_free in [false, true] {
        let (most, [_, reduced]) = compared(|coordinates| tree(coordinates, is_free));
        assert!(most < 1e-11, "free {is_free}: {most:e}");
        assert_closes(&reduced);
        assert!(reduced.certificate.max_projection_m < 1e-14, "{:?}", reduced.certificate);
    }
}

/// A chain of thirty links, hinges and ball joints in turn.
#[test]
fn a_chain_moves_as_in_maximal_coordinates() {
    let links: Vec<(f64, f64)> = (0..30).map(|k| (1.0 + 0.5 * f64::from(k % 3), 0.3 + 0.01 * f64::from(k))).collect();
    let (most, reports) =
        compared(|coordinates| chain(Tier::Accurate, &links, (0.01, 0.25)).method(method(coordinates)));
    assert!(most < 1e-11, "{most:e}");
    for report in reports {
        assert_closes(&report);
        assert!((report.energy.final_j - report.energy.initial_j).abs() < 1e-11 * report.ledger.scale_j);
    }
}

/// A run that is stopped and continues from a snapshot has the same bits.
#[test]
fn a_run_goes_on_from_a_snapshot_with_the_same_bits() {
    let scene = tree(Coordinates::Reduced, true).build().unwrap();
    let mut whole = Simulation::new(&scene).unwrap();
    whole.advance_to(0.37).unwrap();
    let mut other = Simulation::new(&scene).unwrap();
    other.restore(&whole.snapshot()).unwrap();
    for simulation in [&mut whole, &mut other] {
        simulation.advance_to(0.9).unwrap();
    }
    assert_eq!(whole.bodies(), other.bodies());
}

#[test]
fn scenes_without_reduced_coordinates_are_refused_with_the_reason() {
    let chain = || chain(Tier::Accurate, &[(1.0, 0.3), (1.0, 0.5)], (0.01, 0.1)).method(method(Coordinates::Reduced));
    assert!(chain().build().is_ok());
    let end = DVec3::new(0.3_f64.sin() + 0.5_f64.sin(), 0.0, -0.3_f64.cos() - 0.5_f64.cos()) * 0.1;
    let of = |joint: Joint| chain().joint(joint);
    let new = |freedom: Freedom| {
        chain().body(link("third", DVec3::splat(0.1), end)).joint(
            Joint::hinge(BodyId::new(2), end, UnitVector::Y).with(BodyId::new(1)).along(Coordinate::Angle, freedom),
        )
    };
    let limits = Freedom::default().with_limits(Limits::new(-1.0, 1.0).unwrap());
    let friction = Freedom::default().with_friction(JointFriction::new(0.1).unwrap());
    let stepped = Method { tier: Some(Tier::Stepped), ..method(Coordinates::Reduced) };
    let rk4 = Method { integrator: Some(Integrator::Rk4), ..method(Coordinates::Reduced) };
    let box_on_floor = chain().body(floor()).body(brick("brick", DVec3::ONE, DVec3::Z * 9.0));
    let cases = [
        (of(Joint::ball(BodyId::new(1), end)), "joint 2 closes a loop"),
        (of(Joint::new(JointKind::Fixed, BodyId::new(1), end)), "joint 2 is of the kind"),
        (new(limits), "joint 2 has limits"),
        (new(friction), "joint 2 has dry friction"),
        (chain().method(stepped), "the tier is `stepped`"),
        (chain().method(rk4), "method.integrator"),
        (box_on_floor, "bodies floor and brick may touch"),
    ];
    for (scene, expected) in cases {
        let error = scene.build().unwrap_err();
        assert!(matches!(error, SceneError::ReducedCoordinates { .. }), "{expected}: {error}");
        assert!(error.to_string().contains(expected), "{expected}: {error}");
    }
}
