//! The ledger of momentum: each of its accounts holds the impulse that mechanics gives.

use crate::checks::{assert_closes, heavy_brick, particle};
use crate::support::{accurate, ball, elastic, floor, run};
use polhode::scene::{Attachment, Force, Frame, Signal};
use polhode::spatial::{DVec3, Pose, Rotation, Velocity};
use polhode::{BodyId, Effects, Scene};

/// Two balls collide in free space: no account receives momentum, and the total does not change.
#[test]
fn collision_in_space_changes_no_momentum() {
    let scene = Scene::builder("collision")
        .method(accurate())
        .gravity(DVec3::ZERO)
        .body(ball("a", 1.3, 0.1, DVec3::ZERO, DVec3::X).material(elastic(0.4)))
        .body(ball("b", 0.7, 0.2, DVec3::new(0.8, 0.13, 0.05), DVec3::NEG_X).material(elastic(0.4)))
        .build()
        .unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    assert!(!recorder.events.is_empty());
    let ledger = &report.ledger.momentum;
    assert!((ledger.current.linear - ledger.initial.linear).length() < 1e-15);
    assert!((ledger.current.angular - ledger.initial.angular).length() < 1e-15);
    assert_eq!(ledger.support.value().linear, DVec3::ZERO);
    assert_closes(&report);
}

/// A constant force at a point: its account holds `F t`, and that of the integration errors nothing.
#[test]
fn applied_force_is_booked_as_its_impulse() {
    let force = DVec3::new(1.0, -2.0, 0.5);
    let scene = Scene::builder("pushed")
        .duration_s(2.0)
        .body(particle("body", 1.9, DVec3::X, DVec3::ZERO))
        .force(Force::Applied {
            body: BodyId::new(0),
            force,
            torque: DVec3::Z * 0.3,
            frame: Frame::World,
            point: None,
            signal: Signal::ONE,
        })
        .build()
        .unwrap();
    let (report, _) = run(&scene, Effects::Planned);
    let ledger = &report.ledger.momentum;
    assert!((ledger.fields.value().linear - force * 2.0).length() < 1e-13);
    assert!((ledger.gravity.value().linear + DVec3::Z * (9.81 * 1.9 * 2.0)).length() < 1e-12);
    assert!(ledger.numerical.value().linear.length() < 1e-12 * ledger.scale_linear);
    assert!(ledger.numerical.value().angular.length() < 1e-12 * ledger.scale_angular);
    assert_closes(&report);
}

/// A spring between two bodies, also fastened beside their centres, gives the pair neither momentum nor angular
/// momentum.
#[test]
fn spring_between_bodies_gives_no_momentum() {
    let scene = Scene::builder("pair")
        .gravity(DVec3::ZERO)
        .duration_s(3.0)
        .body(heavy_brick("a", 1.0, DVec3::new(0.5, 0.3, 0.2), DVec3::ZERO).velocity(Velocity::new(DVec3::Y, DVec3::X)))
        .body(heavy_brick("b", 2.0, DVec3::new(0.2, 0.4, 0.3), DVec3::X * 1.5))
        .no_contact([0, 1].map(BodyId::new))
        .force(Force::Spring {
            a: Attachment::Body { body: BodyId::new(0), point: DVec3::new(0.2, 0.1, 0.0) },
            b: Attachment::Body { body: BodyId::new(1), point: DVec3::new(-0.1, 0.0, 0.1) },
            stiffness: 25.0,
            rest_length: 0.8,
            damping: 0.7,
        })
        .build()
        .unwrap();
    let (report, _) = run(&scene, Effects::Planned);
    let ledger = &report.ledger.momentum;
    assert!((ledger.current.linear - ledger.initial.linear).length() < 1e-12 * ledger.scale_linear);
    assert!((ledger.current.angular - ledger.initial.angular).length() < 1e-11 * ledger.scale_angular);
    assert!(ledger.fields.value().linear.length() < 1e-13 && ledger.fields.value().angular.length() < 1e-13);
    assert!((report.ledger.damping.value() / (report.energy.initial_j - report.energy.final_j) - 1.0).abs() < 1e-9);
    assert_closes(&report);
}

/// A box falls, rattles and comes to rest: the impulse of the floor is the change of momentum less the impulse of the
/// weight.
#[test]
fn floor_gives_the_impulse_of_the_weight() {
    let tilt = Pose::new(Rotation::from_rotation_vector(DVec3::new(0.2, 0.4, 0.1)), DVec3::Z * 0.5);
    let scene = Scene::builder("rattle")
        .method(accurate())
        .duration_s(3.0)
        .body(floor().material(elastic(0.3)))
        .body(heavy_brick("box", 2.1, DVec3::new(0.4, 0.3, 0.2), DVec3::ZERO).pose(tilt).material(elastic(0.3)))
        .build()
        .unwrap();
    let (report, _) = run(&scene, Effects::Planned);
    assert!(report.bodies[1].state.velocity.linear.z.abs() < 1e-12);
    let support = report.ledger.momentum.support.value().linear;
    let weight = 2.1 * 9.81 * 3.0;
    let lost = report.ledger.momentum.rest.value().linear + report.ledger.momentum.projection.value().linear;
    assert!((support.z - lost.z - weight).abs() < 1e-11 * weight, "{support} {weight}");
    assert_closes(&report);
}
