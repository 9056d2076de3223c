//! Friction at and near its limit: bodies that slide together hold each other with exactly the largest force, static
//! friction bears whatever way its force is shared among corners, and coefficients may be huge.

use crate::checks::assert_closes;
use crate::friction::{lying, on_slope, rough, slope, sticky};
use crate::stepped::stepped;
use crate::support::{accurate, brick, run};
use polhode::contact::Shape;
use polhode::scene::{Force, Frame, Signal};
use polhode::spatial::{DVec3, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, Effects, Scene, Simulation, Unobserved};

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
    for (name, state) in &report.bodies {
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
    let start = Simulation::new(&scene, Effects::Planned).unwrap().bodies()[0].pose.translation;
    let mut simulation = Simulation::new(&scene, Effects::Planned).unwrap();
    simulation.advance_to(0.5, &mut Unobserved).unwrap();
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
            body: 0,
            force,
            torque: DVec3::ZERO,
            frame: Frame::World,
            point: None,
            signal: Signal::constant(1.0).unwrap(),
        };
        let scene = on_slope(Rotation::IDENTITY, body.clone(), &sticky(0.9, 0.5)).method(stepped(1e-3)).force(pull);
        let (report, _) = run(&scene.duration_s(1.0).build().unwrap(), Effects::Planned);
        let speed = report.bodies[0].1.velocity.linear.y;
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
        for (name, state) in &report.bodies {
            assert_eq!(state.velocity, Velocity::ZERO, "{name} at friction {friction}");
        }
    }
}
