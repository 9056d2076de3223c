//! Friction at and near its limit: bodies that slide together hold each other with exactly the largest force, static
//! friction bears whatever way its force is shared among corners, and coefficients may be huge.

use crate::checks::assert_closes;
use crate::friction::{lying, on_slope, rough, slope, sticky};
use crate::stepped::stepped;
use crate::support::{accurate, brick, run};
use polhode::contact::Shape;
use polhode::mesh::solid_box;
use polhode::scene::{Force, Frame, Material, Signal};
use polhode::spatial::{DVec3, Mass, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodyId, Effects, EventKind, Scene, Simulation};

const G: f64 = 9.81;

/// Boxes of one material on a slope that is too steep slide down as one: every contact but the lowest needs exactly the
/// largest force. Rounding must not make them slide on each other, which ended in time steps and took minutes.
#[test]
fn boxes_of_one_material_slide_down_together() {
    let (angle, friction, size) = (0.3f64, 0.2, DVec3::new(0.4, 0.4, 0.1));
    let (turn, material) = (slope(angle, 0.4), rough(friction));
    let mut scene = on_slope(turn, lying(size, 0.0, DVec3::ZERO), &material).duration_s(0.3);
    for storey in 1..6 {
        let center = turn.rotate(DVec3::Z * (size.z * (f64::from(storey) + 0.5)));
        let body = brick(&format!("box {storey}"), size, center).pose(Pose::new(turn, center));
        scene = scene.body(body.material(material.clone()));
    }
    let (report, _) = run(&scene.build().unwrap(), Effects::Planned);
    let speed = 0.3 * G * (angle.sin() - friction * angle.cos());
    for polhode::ReportedBody { name, state, .. } in &report.bodies {
        let moved = state.velocity.linear.length();
        assert!(moved == 0.0 || (moved / speed - 1.0).abs() < 1e-12, "{name}: {moved} for {speed}");
    }
    assert!(report.warnings.is_empty(), "{:?}", report.warnings);
    assert_closes(&report);
}

/// In time steps a box stays on a slope that static friction bears with a reserve of 1 %, although the least forces put
/// some of its corners at their limits.
#[test]
fn static_friction_holds_a_box_on_a_slope_in_time_steps() {
    let angle = 25.0f64.to_radians();
    let material = sticky(1.01 * angle.tan(), 0.3);
    let body = lying(DVec3::new(1.0, 0.7, 0.4), 0.5, DVec3::ZERO);
    let scene = on_slope(slope(angle, 0.3), body, &material).method(stepped(1e-3)).duration_s(0.5).build().unwrap();
    let start = Simulation::new(&scene).unwrap().bodies()[0].pose.translation;
    let mut simulation = Simulation::new(&scene).unwrap();
    simulation.advance_to(0.5).unwrap();
    let moved = (simulation.bodies()[0].pose.translation - start).length();
    assert!(moved < 1e-9, "{moved:e} m");
}

/// The same for a box that a constant force pulls with more than kinetic friction bears: the force is not a slip at the
/// start of a step.
#[test]
fn static_friction_bears_a_pull_in_time_steps() {
    let body = lying(DVec3::new(1.0, 0.8, 0.2), 0.0, DVec3::ZERO);
    for (pull, expected) in [(0.7, 0.0), (1.0, 0.5 * G)] {
        let force = DVec3::Y * (pull * G);
        let pull = Force::Applied {
            body: BodyId::new(0),
            force,
            torque: DVec3::ZERO,
            frame: Frame::World,
            point: None,
            signal: Signal::constant(1.0).unwrap(),
        };
        let scene = on_slope(Rotation::IDENTITY, body.clone(), &sticky(0.9, 0.5)).method(stepped(1e-3)).force(pull);
        let (report, _) = run(&scene.duration_s(1.0).build().unwrap(), Effects::Planned);
        let speed = report.bodies[0].state.velocity.linear.y;
        assert!((speed - expected).abs() < 0.01 * G, "{speed} for {expected}");
        assert!(expected > 0.0 || speed.abs() < 1e-9, "{speed}");
    }
}

/// Bricks that cannot slip for any practical purpose: coefficients of 1e4 and 1e6 are solved like others.
#[test]
fn bricks_of_huge_friction_stand() {
    for friction in [1e4, 1e6] {
        let (material, size) = (rough(friction), DVec3::new(0.5, 0.3, 0.2));
        let normal = UnitVector::new(DVec3::Z).unwrap();
        let ground = Body::fixed("ground").geometry(Shape::half_space(normal).into()).material(material.clone());
        let mut scene = Scene::builder("huge friction").method(accurate()).duration_s(0.2).body(ground);
        for (name, x, z) in [("low", 0.0, 0.1), ("right", 0.2, 0.3), ("top", 0.1, 0.5)] {
            let body = brick(name, size, DVec3::new(x, 0.0, z)).velocity(Velocity::ZERO);
            scene = scene.body(body.material(material.clone()));
        }
        let (report, _) = run(&scene.build().unwrap(), Effects::Planned);
        for polhode::ReportedBody { name, state, .. } in &report.bodies {
            assert_eq!(state.velocity, Velocity::ZERO, "{name} at friction {friction}");
        }
    }
}

/// A box that falls flat on the floor and spins about the vertical rubs with each corner in another direction. How the
/// corners share the impact is not determined, but it must not depend on which of them comes first: the same box,
/// turned by half a turn in its own frame, moves on in the same way.
#[test]
fn impacts_of_redundant_corners_do_not_depend_on_their_order() {
    let (size, half_a_turn) = (DVec3::new(0.4, 0.3, 0.2), std::f64::consts::PI);
    let after = |friction: f64, restitution: f64, heading: f64| {
        let body = lying(size, heading, DVec3::ZERO);
        let spin = Velocity::new(DVec3::new(0.7, 0.2, 0.0), DVec3::Z * 5.0);
        let pose = Pose::new(body.initial_pose().rotation, DVec3::Z * 0.5);
        let material = Material::new("tiles").with_friction(friction).unwrap().with_restitution(restitution).unwrap();
        let scene = on_slope(Rotation::IDENTITY, body.pose(pose).velocity(spin), &material).duration_s(0.3);
        let (report, _) = run(&scene.build().unwrap(), Effects::Planned);
        report.bodies[0].state.velocity
    };
    for friction in [0.05, 0.1, 0.15] {
        for restitution in [0.0, 0.4] {
            let [one, other] = [0.3, 0.3 + half_a_turn].map(|heading| after(friction, restitution, heading));
            let apart = (one.linear - other.linear).length() + (one.angular - other.angular).length();
            assert!(apart < 1e-12, "friction {friction}, restitution {restitution}: {apart:e}");
        }
    }
}

/// A box turns over on the edge of another one until the slip of its corner ends. The step that ends there evaluates
/// the direction of a slip that is no larger than the errors of its stages: it missed the end by 1e-3 m/s, which a
/// projection had to take away. The state is that of a pile of boxes before that step.
#[test]
fn a_step_that_ends_where_a_slip_ends_finds_that_end() {
    let (material, size) = (rough(0.5), DVec3::splat(0.4));
    let turned = |wxyz| Rotation::from_wxyz(wxyz).unwrap();
    let low = Pose::new(
        turned([-2.689366509770766e-17, 0.9999952860281293, 0.0030704920647777515, 2.208002286976225e-16]),
        DVec3::new(1.2817060884549623, 1.068407490271384, 0.20000000000000007),
    );
    let high = Pose::new(
        turned([-0.973331729415924, 0.011697707016719105, 0.22181587921235418, -0.05732559543526489]),
        DVec3::new(1.0354636309437646, 1.1491763975089464, 0.5999140949192577),
    );
    let velocity = Velocity::new(
        DVec3::new(-0.5945323162073658, -0.001127948940612487, -0.13863643145675134),
        DVec3::new(-0.006145260221646652, -2.922272389702738, 0.050129174318706456),
    );
    let body = |name, pose: Pose| brick(name, size, DVec3::ZERO).pose(pose).material(material.clone());
    let ground = Body::fixed("ground").geometry(Shape::half_space(UnitVector::Z).into()).material(material.clone());
    let scene = Scene::builder("two boxes").method(accurate()).duration_s(0.012).body(ground);
    let scene = scene.body(body("low", low)).body(body("high", high).velocity(velocity)).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    assert!(recorder.events.iter().any(|event| event.kind == EventKind::Stick), "{:?}", recorder.events);
    let taken = report.ledger.projection.value().abs();
    assert!(taken < 1e-12, "projections took {taken:e} J");
}

/// A row of bricks end to end under two more, which friction could hold in many ways. The forces that the solver of
/// Coulomb's law finds for them are not balanced to rounding: the wall was never put to rest, and its bricks kept
/// velocities of 1e-32 m/s.
#[test]
fn a_wall_that_friction_holds_in_many_ways_is_at_rest() {
    let (material, size) = (rough(0.8241279860832478), DVec3::new(0.25, 0.12, 0.0625));
    let bricks = [
        (-0.002526224516076942, 0.01650707291817452, 0, 1.41037421399988),
        (0.24747377548392305, 0.014114406901883111, 0, 1.014638130631665),
        (0.4974737754839231, 0.01940979462646496, 0, 1.186929806904773),
        (0.747473775483923, -0.01244864044142556, 0, 0.5447173569638879),
        (0.1491402204892929, 0.021990947020700057, 1, 1.4257106176638303),
        (0.2360804283302303, 0.009471150790727287, 2, 1.0677011350634609),
    ];
    let ground = Body::fixed("ground").geometry(Shape::half_space(UnitVector::Z).into()).material(material.clone());
    let mut scene = Scene::builder("wall").method(accurate()).duration_s(0.1).body(ground);
    for (number, (x, y, course, weight)) in bricks.into_iter().enumerate() {
        let mass = Mass::new(2000.0 * weight * size.element_product()).unwrap();
        let pose = Pose::from_translation(DVec3::new(x, y, size.z * (f64::from(course) + 0.5)));
        let body = Body::movable(format!("brick {number}"), solid_box(size, mass).unwrap()).pose(pose);
        scene = scene.body(body.geometry(Shape::cuboid(size).unwrap().into()).material(material.clone()));
    }
    let (report, _) = run(&scene.build().unwrap(), Effects::Planned);
    for polhode::ReportedBody { name, state, .. } in &report.bodies {
        assert_eq!(state.velocity, Velocity::ZERO, "{name}");
    }
}

/// A bridge on a slope, two pillars of eight bricks with a deck across them: it gives way at many joints at once, for
/// which the first few convex programmes of the cone problem and Newton's method from them found no forces, so that the
/// run ended before it began.
#[test]
fn a_bridge_that_gives_way_at_many_joints_begins_to_fall() {
    let (material, size) = (rough(0.588), DVec3::new(0.25, 0.12, 0.0625));
    // Along and across the slope, m; turn about its normal, rad; kg.
    let pillars = [
        [
            (-0.337, 0.003, -0.011, 5.43),
            (-0.384, 0.005, -0.076, 4.02),
            (-0.32, 0.003, -0.152, 2.02),
            (-0.319, -0.008, -0.13, 2.21),
            (-0.265, -0.013, -0.023, 5.22),
            (-0.31, -0.009, 0.168, 4.09),
            (-0.241, -0.011, 0.141, 5.6),
            (-0.222, 0.016, -0.107, 4.06),
        ],
        [
            (0.353, 0.019, 0.134, 3.26),
            (0.305, -0.005, -0.042, 2.37),
            (0.276, -0.002, 0.183, 7.11),
            (0.23, -0.001, 0.06, 2.08),
            (0.257, -0.005, 0.043, 7.0),
            (0.303, -0.007, 0.086, 4.18),
            (0.3, 0.014, -0.169, 4.88),
            (0.266, 0.001, 0.174, 5.1),
        ],
    ];
    let of_pillar = |pillar: [(f64, f64, f64, f64); 8]| {
        let heights = (0..8).map(|course| size.z * (f64::from(course) + 0.5));
        pillar.into_iter().zip(heights).map(|((x, y, yaw, mass), z)| (DVec3::new(x, y, z), size, yaw, mass))
    };
    let mut bricks: Vec<_> = pillars.into_iter().flat_map(of_pillar).collect();
    bricks.push((DVec3::new(0.066, 0.0, 0.52), DVec3::new(0.687, 0.12, 0.04), 0.0, 8.79));
    bricks.push((DVec3::new(-0.22, 0.0, 0.57125), size, 0.0, 2.61));
    let slope = Rotation::from_rotation_vector(DVec3::Y * 0.241);
    let up = UnitVector::new(slope.rotate(DVec3::Z)).unwrap();
    let ground = Body::fixed("ground").geometry(Shape::half_space(up).into()).material(material.clone());
    let mut scene = Scene::builder("bridge").method(accurate()).body(ground);
    for (number, (center, size, yaw, mass)) in bricks.into_iter().enumerate() {
        let pose = Pose::new(slope * Rotation::from_rotation_vector(DVec3::Z * yaw), slope.rotate(center));
        let body = Body::movable(format!("brick {number}"), solid_box(size, Mass::new(mass).unwrap()).unwrap());
        let body = body.geometry(Shape::cuboid(size).unwrap().into()).pose(pose);
        scene = scene.body(body.material(material.clone()));
    }
    let mut simulation = Simulation::new(&scene.build().unwrap()).unwrap();
    let accelerations = simulation.accelerations().unwrap();
    let fastest = accelerations.iter().fold(0.0f64, |most, a| most.max(a.linear.length()));
    assert!((0.01..G).contains(&fastest), "{fastest} m/s^2");
}
