//! Every kind of joint in the tier `fast`: two bodies that it holds move as in the tier `accurate`, with an error of
//! the first order in the step, keep their momentum to rounding, and move the same in a turned and moved world. Islands
//! of joints do not know of each other, and the motion has the same bits for any number of threads.

use crate::fast_joints::{fast, run};
use crate::support::{accurate, brick, run_even_degraded};
use crate::threads::check_threads;
use polhode::scene::{Joint, JointKind, Method};
use polhode::spatial::{DVec3, Pose, Rotation, UnitVector, Velocity};
use polhode::{BodyId, BodySample, Effects, RunReport, Scene, SceneBuilder, Simulation};

/// The motion lasts so long, s.
const DURATION_S: f64 = 0.4;

/// All kinds, by name, in a world that is turned and moved so.
fn kinds(world: Pose) -> Vec<(&'static str, Joint)> {
    let place = world.transform_point(DVec3::new(0.3, 0.05, -0.02));
    let axis = |x: f64, y: f64, z: f64| UnitVector::new(world.rotation.rotate(DVec3::new(x, y, z))).unwrap();
    let (along, across) = (axis(0.6, 0.0, 0.8), axis(0.0, 1.0, 0.0));
    let to = world.transform_point(DVec3::new(0.45, 0.1, 0.1));
    let of = |kind: JointKind| Joint::new(kind, BodyId::new(0), place).with(BodyId::new(1));
    let length = (place - to).length();
    vec![
        ("ball", of(JointKind::Ball)),
        ("hinge", of(JointKind::Hinge { axis: along })),
        ("universal", of(JointKind::Universal { axes: [along, across] })),
        ("fixed", of(JointKind::Fixed)),
        ("slider", of(JointKind::Slider { axis: along })),
        ("cylindrical", of(JointKind::Cylindrical { axis: along })),
        ("screw", of(JointKind::Screw { axis: along, lead: 0.4 })),
        ("planar", of(JointKind::Planar { normal: along })),
        ("rod", of(JointKind::Rod { to })),
        ("rope", Joint::rope(BodyId::new(0), place, to, length).unwrap().with(BodyId::new(1))),
    ]
}

/// Two bricks in space that turn and fly as one body at the start, which every joint allows; what is free moves on.
fn pair(joint: &Joint, world: Pose, method: Method) -> SceneBuilder {
    let spin = DVec3::new(1.0, -2.0, 1.5);
    let mut scene = Scene::builder("pair").gravity(DVec3::ZERO).method(method).duration_s(DURATION_S);
    let sizes = [("a", DVec3::new(0.3, 0.2, 0.1), DVec3::ZERO), ("b", DVec3::new(0.1, 0.3, 0.2), DVec3::X * 0.6)];
    for (name, size, center) in sizes {
        let [linear, angular] = [DVec3::Y * 0.5 + spin.cross(center), spin].map(|own| world.rotation.rotate(own));
        let own = brick(name, size, DVec3::ZERO).pose(world * Pose::from_translation(center));
        scene = scene.body(own.velocity(Velocity::new(linear, angular)));
    }
    scene.joint(*joint).no_contact([BodyId::new(0), BodyId::new(1)])
}

fn end(scene: SceneBuilder) -> RunReport {
    run_even_degraded(&scene.build().unwrap(), Effects::Planned).0
}

/// How far two motions have come apart: of the centres, and of points at a distance of 0.1 m from them, m.
fn between(one: &RunReport, other: &RunReport) -> f64 {
    let of = |(one, other): (&BodySample, &BodySample)| {
        let turned = (one.pose.rotation.inverse() * other.pose.rotation).to_rotation_vector().length();
        (one.pose.translation - other.pose.translation).length() + 0.1 * turned
    };
    let states = |report: &RunReport| report.bodies.iter().map(|body| body.state).collect::<Vec<_>>();
    states(one).iter().zip(&states(other)).map(of).fold(0.0, f64::max)
}

#[test]
fn every_kind_moves_as_in_the_accurate_tier_to_the_first_order_of_the_step() {
    for (name, joint) in kinds(Pose::IDENTITY) {
        let exact = end(pair(&joint, Pose::IDENTITY, accurate()));
        let errors = [40.0, 80.0, 160.0].map(|steps| {
            let report = run(pair(&joint, Pose::IDENTITY, fast(DURATION_S / steps)));
            between(&report, &exact)
        });
        assert!(errors[0] < 0.02, "{name}: {errors:?}");
        assert!(errors[1] < 0.6 * errors[0] && errors[2] < 0.6 * errors[1], "{name}: {errors:?}");
        // The bodies have moved relative to each other, but where nothing is free.
        let free = end(pair(&kinds(Pose::IDENTITY)[3].1, Pose::IDENTITY, accurate()));
        assert!(name == "fixed" || between(&free, &exact) > 10.0 * errors[2], "{name}: {errors:?}");
    }
}

#[test]
fn no_kind_changes_the_momentum_of_its_bodies() {
    for (name, joint) in kinds(Pose::IDENTITY) {
        let report = run(pair(&joint, Pose::IDENTITY, fast(0.01)));
        let ledger = &report.ledger.momentum;
        let [linear, angular] = [
            (ledger.current.linear - ledger.initial.linear).length() / ledger.initial.linear.length(),
            (ledger.current.angular - ledger.initial.angular).length() / ledger.initial.angular.length(),
        ];
        assert!(linear < 1e-13, "{name}: {linear}");
        assert!(angular < 1e-13, "{name}: {angular}");
    }
}

#[test]
fn every_kind_moves_the_same_in_a_turned_and_moved_world() {
    let turn = Rotation::from_wxyz([1.0, 2.0, 3.0, 4.0].map(|c: f64| c / 30.0_f64.sqrt())).unwrap();
    let world = Pose::new(turn, DVec3::new(20.0, -30.0, 10.0));
    for ((name, home), (_, away)) in kinds(Pose::IDENTITY).into_iter().zip(kinds(world)) {
        let home = run(pair(&home, Pose::IDENTITY, fast(0.01)));
        let away = run(pair(&away, world, fast(0.01)));
        // The rows of rotations are perpendicular pairs of axes that lie otherwise in the bodies: errors of the joint
        // act on each other to the second order.
        let certificate = &home.certificate;
        let gap = certificate.max_joint_error_m.unwrap() / 0.1 + certificate.max_joint_error_rad.unwrap();
        let allowed = 1e-10 + gap * gap;
        for (home, away) in home.bodies.iter().zip(&away.bodies) {
            let apart = (world * home.state.pose).translation - away.state.pose.translation;
            let turned = (world * home.state.pose).rotation.inverse() * away.state.pose.rotation;
            assert!(apart.length() < allowed, "{name}: {apart} {allowed}");
            assert!(turned.to_rotation_vector().length() < allowed, "{name}: {turned:?} {allowed}");
        }
    }
}

/// Chains of twenty links, side by side: more than one group of islands has room for.
fn chains(count: usize) -> Scene {
    let mut scene = Scene::builder("chains").method(fast(1.0 / 60.0)).duration_s(0.25).output_interval_s(0.25);
    for chain in 0..count {
        let origin = DVec3::new(0.0, 2.0 * chain as f64, 0.0);
        for link in 0..20 {
            let body = BodyId::new(20 * chain + link);
            let at = origin + DVec3::X * (0.4 * link as f64);
            let size = DVec3::new(0.3, 0.05, 0.05 + 0.001 * chain as f64);
            scene = scene.body(brick(&format!("{chain} {link}"), size, at + DVec3::X * 0.2));
            let joint = Joint::ball(body, at);
            scene = scene.joint(if link == 0 { joint } else { joint.with(BodyId::new(20 * chain + link - 1)) });
        }
    }
    scene.build().unwrap()
}

#[test]
fn threads_change_no_bit_of_many_chains() {
    check_threads(&chains(30));
}

/// A chain moves by the same bits alone and beside others, whose joints it shares batches and groups with.
#[test]
fn islands_of_joints_do_not_know_of_each_other() {
    let [alone, among] = [1, 30].map(|count| {
        let mut simulation = Simulation::new(&chains(count)).unwrap();
        simulation.advance_to(0.2).unwrap();
        assert_eq!(simulation.islands().len(), count);
        (0..20).map(|body| simulation.body(BodyId::new(body))).collect::<Vec<_>>()
    });
    assert!(alone == among);
}
