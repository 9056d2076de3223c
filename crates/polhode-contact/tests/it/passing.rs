//! Two bodies that touch at the border of a face collide only if they approach along every face that separates them.
//! A search for an impact passes over an edge that is flush with the path of the body, finds the impact with one that
//! stands out, and gives the same answers for mirrored, turned, shifted and scaled pairs.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

use polhode_contact::{ConstantVelocity, DVec3, ImpactSearch, Pose, Rotation, Shape, Still, Velocity, time_of_impact};

/// A tile whose top is at z = 0 and whose edge is at x = 0.
const TILE: DVec3 = DVec3::new(2.0, 20.0, 1.0);

fn sliders() -> Vec<(&'static str, Shape, f64)> {
    vec![
        ("ball", Shape::sphere(0.5).unwrap(), 0.5),
        ("box", Shape::cuboid(DVec3::ONE).unwrap(), 0.5),
        ("puck", Shape::cylinder(0.5, 0.5).unwrap(), 0.25),
        ("cone", Shape::cone(0.5, 1.0).unwrap(), 0.25),
        ("ring", Shape::torus(0.5, 0.1).unwrap(), 0.1),
    ]
}

/// The time of impact of a body that starts 1 m before the edge, with its lowest point at a height (m), and moves along
/// `direction`, in a frame and at a scale.
fn impact(shape: &Shape, center: DVec3, direction: DVec3, frame: &Pose, scale: f64) -> Option<f64> {
    let place = |p: DVec3| frame.transform_point(p * scale);
    let tile = Shape::cuboid(TILE * scale).unwrap();
    let fixed = Still(Pose::new(frame.rotation, place(DVec3::new(1.0, 0.0, -0.5))));
    let start = Pose::new(frame.rotation, place(center));
    let velocity = Velocity::new(frame.rotation.rotate(direction * scale), DVec3::ZERO);
    let motion = ConstantVelocity::new(0.0, start, velocity).unwrap();
    time_of_impact(shape, &motion, &tile, &fixed, 0.0, 2.0, &ImpactSearch::default()).unwrap()
}

fn frames() -> [Pose; 3] {
    let turned = Rotation::from_rotation_vector(DVec3::new(0.3, -1.1, 0.7));
    [Pose::IDENTITY, Pose::from_translation(DVec3::new(300.0, -20.0, 7.0)), Pose::new(turned, DVec3::ZERO)]
}

#[test]
fn flush_edge_is_no_impact_whatever_the_shape_the_direction_and_the_frame() {
    for (name, shape, height) in sliders() {
        for angle in [0.0, 0.2, -0.2, 0.9] {
            for frame in frames() {
                let direction = DVec3::new(f64::cos(angle), f64::sin(angle), 0.0);
                let found = impact(&shape, DVec3::new(-1.0, 0.0, height), direction, &frame, 1.0);
                assert_eq!(found, None, "{name} at {angle} in {frame:?}");
            }
        }
    }
}

/// A step of a thousandth of the size is there for every shape; one of 1e-10 is flush.
#[test]
fn step_trips_from_its_size_on() {
    for (name, shape, height) in sliders() {
        let at = |step: f64| impact(&shape, DVec3::new(-1.0, 0.0, height - step), DVec3::X, &Pose::IDENTITY, 1.0);
        assert!(at(1e-3).is_some_and(|t| t > 0.3 && t < 1.0), "{name}: {:?}", at(1e-3));
        assert!(at(1e-7).is_some_and(|t| t > 0.3 && t < 1.01), "{name}: {:?}", at(1e-7));
    }
}

/// A body that also falls approaches the top too: it hits the edge.
#[test]
fn falling_body_hits_the_edge() {
    for (name, shape, height) in sliders() {
        let found = impact(&shape, DVec3::new(-1.0, 0.0, height), DVec3::new(1.0, 0.0, -1e-3), &Pose::IDENTITY, 1.0);
        assert!(found.is_some_and(|t| t < 1.01), "{name}: {found:?}");
    }
}

/// Lengths scaled by a power of two: the same time, bit for bit.
#[test]
fn impact_with_a_step_scales() {
    let at = |scale: f64| {
        let shape = Shape::cuboid(DVec3::splat(scale)).unwrap();
        impact(&shape, DVec3::new(-1.0, 0.0, 0.499), DVec3::X, &Pose::IDENTITY, scale)
    };
    assert!(at(1.0).is_some());
    assert_eq!(at(1.0), at(1024.0));
    assert_eq!(at(1.0), at(1.0 / 1024.0));
}
