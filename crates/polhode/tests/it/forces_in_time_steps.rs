//! Force fields in tier `stepped` on bodies that contacts or joints hold: field and reactions act together in a step,
//! so that what is held stays where it is, a field does work on the way that its body goes, and joints do none.

use crate::checks::{assert_closes, heavy_brick};
use crate::friction::rough;
use crate::joints::rod;
use crate::support::{brick, floor, run};
use polhode::scene::{
    Attachment, Coordinate, DragLaw, Drive, Force, Frame, Freedom, Joint, Method, Motor, Signal, Tier,
};
use polhode::spatial::{DVec3, UnitVector};
use polhode::{BodyId, Effects, RunReport, Scene, SceneBuilder};

const G: f64 = 9.81;
const SIZE: DVec3 = DVec3::new(0.5, 0.4, 0.2);

fn stepped(step_s: f64) -> Method {
    Method { tier: Some(Tier::Stepped), step_s: Some(step_s), ..Method::default() }
}

/// A force on the centre of a body.
fn push(body: usize, force: DVec3) -> Force {
    let (torque, frame, signal) = (DVec3::ZERO, Frame::World, Signal::ONE);
    Force::Applied { body: BodyId::new(body), force, torque, frame, point: None, signal }
}

/// A box of 2 kg on the floor.
fn box_on_floor(friction: f64) -> SceneBuilder {
    let [ground, body] = [floor(), heavy_brick("box", 2.0, SIZE, DVec3::Z * 0.1)].map(|b| b.material(rough(friction)));
    Scene::builder("box").method(stepped(0.01)).duration_s(1.0).body(ground).body(body)
}

/// The motor of constant effort does the work that its rod gains; it turned a tenth of it into losses of the projection
/// before.
#[test]
fn a_motor_on_a_hinge_does_the_work_that_its_rod_gains() {
    let (mass, length) = (1.4, 0.8);
    let motor = Freedom::default().with_motor(Motor::new(Drive::Effort(1.5)).unwrap());
    let body = rod("rod", (mass, length), DVec3::X * (0.5 * length), std::f64::consts::FRAC_PI_2);
    let joint = Joint::hinge(BodyId::new(0), DVec3::ZERO, UnitVector::Y).along(Coordinate::Angle, motor);
    let scene = Scene::builder("motor").method(stepped(0.01)).gravity(DVec3::ZERO).duration_s(1.0);
    let (report, _) = run(&scene.body(body).joint(joint).build().unwrap(), Effects::Planned);
    let (work, gained) = (report.ledger.external.value(), report.energy.kinetic_j);
    assert!((work - gained).abs() < 2e-5 * gained, "{work} J of work for {gained} J");
    assert!(report.ledger.projection.value().abs() < 2e-5 * gained, "{:?}", report.ledger);
    assert_closes(&report);
}

/// A force that pulls a hanging rod at its centre, too: the work is that of the force on its way.
#[test]
fn a_force_on_a_hinged_rod_does_work_on_its_way() {
    let (mass, length) = (1.4, 0.8);
    let force = DVec3::new(3.0, 0.0, 1.0);
    let body = rod("rod", (mass, length), DVec3::Z * (-0.5 * length), 0.0);
    let joint = Joint::hinge(BodyId::new(0), DVec3::ZERO, UnitVector::Y);
    let scene = Scene::builder("pulled").method(stepped(0.01)).gravity(DVec3::Z * -G).duration_s(0.7);
    let scene = scene.body(body).joint(joint).force(push(0, force));
    let (report, _) = run(&scene.build().unwrap(), Effects::Planned);
    let way = report.bodies[0].state.pose.translation + DVec3::Z * (0.5 * length);
    let (work, expected) = (report.ledger.external.value(), force.dot(way));
    assert!((work - expected).abs() < 2e-5 * expected, "{work} J for {expected} J");
    assert!(report.ledger.projection.value().abs() < 2e-5 * expected, "{:?}", report.ledger);
    assert_closes(&report);
}

fn assert_rests(report: &RunReport, what: &str) {
    let moved = (report.bodies[1].state.pose.translation - DVec3::Z * 0.1).length();
    assert!(moved < 1e-15, "{what}: moved by {moved:e} m");
    assert_eq!(report.bodies[1].state.velocity.linear, DVec3::ZERO, "{what}");
    let ledger = &report.ledger;
    let entries = [&ledger.external, &ledger.friction, &ledger.impact, &ledger.projection, &ledger.numerical];
    for entry in entries {
        assert!(entry.value().abs() < 1e-13, "{what}: {ledger:?}");
    }
    assert_closes(report);
}

/// A box that rests on the floor stays there under a force that its contacts bear, and nothing does work: pressed down,
/// lifted by less than its weight, pushed by less than friction bears.
#[test]
fn a_box_rests_under_a_force_that_its_contacts_bear() {
    for (what, force) in [
        ("pressed", DVec3::Z * -25.0),
        ("lifted", DVec3::Z * 19.0),
        ("pushed", DVec3::new(4.0, -3.0, 0.0)),
        ("pushed and lifted", DVec3::new(-2.0, 3.0, 8.0)),
    ] {
        let built = box_on_floor(0.5).force(push(1, force)).build().unwrap();
        assert_rests(&run(&built, Effects::Planned).0, what);
    }
}

/// The same under a stiff spring that pulls it up with less than its weight.
#[test]
fn a_box_rests_under_a_spring_that_lifts_a_part_of_its_weight() {
    let spring = Force::Spring {
        a: Attachment::World(DVec3::Z * 1.2),
        b: Attachment::Body { body: BodyId::new(1), point: DVec3::Z * 0.1 },
        stiffness: 3e4,
        rest_length: 0.9995,
        damping: 5.0,
    };
    let built = box_on_floor(0.3).force(spring).build().unwrap();
    assert_rests(&run(&built, Effects::Planned).0, "on a spring");
}

/// A box is pushed over the floor: friction takes `mu m g` on its way, the push gives its force times the way.
#[test]
fn a_push_against_friction_does_the_work_of_its_way() {
    let built = box_on_floor(0.2).force(push(1, DVec3::X * 9.0)).build().unwrap();
    let (report, _) = run(&built, Effects::Planned);
    let way = report.bodies[1].state.pose.translation.x;
    let acceleration = 4.5 - 0.2 * G;
    assert!((way - 0.5 * acceleration).abs() < 1e-12, "{way} m");
    assert!((report.ledger.external.value() - 9.0 * way).abs() < 1e-12, "{:?}", report.ledger);
    assert!((report.ledger.friction.value() - 0.2 * 2.0 * G * way).abs() < 1e-12, "{:?}", report.ledger);
    assert_closes(&report);
}

/// A plate is pressed between a wall and a force, beside a free body that the same force accelerates.
#[test]
fn a_force_does_no_work_on_a_body_that_a_wall_stops() {
    let wall = polhode::Body::fixed("wall").geometry(floor().shape().unwrap().clone());
    let [held, free] = ["held", "free"].map(|name| brick(name, SIZE, DVec3::Z * 0.1));
    let free = free.pose(polhode::spatial::Pose::from_translation(DVec3::new(5.0, 0.0, 3.0)));
    let down = DVec3::Z * -2.0;
    let scene = Scene::builder("wall").method(stepped(0.01)).gravity(DVec3::ZERO).duration_s(1.0);
    let scene = scene.body(wall).body(held).body(free).force(push(1, down)).force(push(2, down));
    let (report, _) = run(&scene.build().unwrap(), Effects::Planned);
    let work = report.ledger.external.value();
    assert!((work / report.energy.kinetic_j - 1.0).abs() < 1e-12, "{:?}", report.ledger);
    assert!(report.ledger.impact.value().abs() < 1e-13, "{:?}", report.ledger);
}

/// A force that depends on velocities acts on what joints hold at the velocity that they leave it: a rod on a hinge in
/// air, and on a spring with a damper, goes to its accurate motion with the square of the step. (It was the first
/// power: drag acted at the velocity of a free fall over half of the step.)
#[test]
fn drag_and_dampers_on_what_a_joint_holds_are_of_second_order() {
    let [linear, quadratic] = [DragLaw::Linear, DragLaw::Quadratic].map(|law| Force::Drag {
        body: BodyId::new(0),
        law,
        translational: 1.5,
        rotational: 0.02,
        wind: DVec3::new(0.3, 0.0, -0.2),
    });
    let damped = Force::Spring {
        a: Attachment::World(DVec3::new(1.0, 0.4, 1.0)),
        b: Attachment::Body { body: BodyId::new(0), point: DVec3::ZERO },
        stiffness: 50.0,
        rest_length: 1.0,
        damping: 2.0,
    };
    for (name, force) in [("linear", linear), ("quadratic", quadratic), ("damper", damped)] {
        let end = |method: Method| {
            let body = rod("rod", (1.0, 1.0), DVec3::X * 0.5, std::f64::consts::FRAC_PI_2);
            let joint = Joint::hinge(BodyId::new(0), DVec3::ZERO, UnitVector::Y);
            let scene = Scene::builder(name).method(method).gravity(DVec3::Z * -G).duration_s(0.4);
            let scene = scene.body(body).joint(joint).force(force.clone()).build().unwrap();
            let (report, _) = run(&scene, Effects::Planned);
            assert_closes(&report);
            report.bodies[0].state.pose.translation
        };
        let accurate = end(Method { tier: Some(Tier::Accurate), ..Method::default() });
        let [coarse, fine] = [0.01, 0.005].map(|step_s| (end(stepped(step_s)) - accurate).length());
        assert!(fine < 1e-4 && (3.5..4.6).contains(&(coarse / fine)), "{name}: {coarse:e} m, {fine:e} m");
    }
}
