//! The rates of contact point and normal and the derivative of the slip, of every kind of contact, against finite
//! differences of eighth order along motions that accelerate and whose spin changes direction, at separations that are
//! not zero. `tangential_reference.rs` has smaller tolerances at fewer contacts.

use crate::derivatives::{FIRST, Path, each_kind};
use crate::round_derivatives::{POSES, each_pair_of_elements};
use crate::support::{Random, tangential};
use polhode_contact::{ContactFeature, Shape, TangentialKinematics, evaluate, kinematics, kinematics_with_tangential};
use polhode_spatial::DVec3;

/// Steps of the differences, s: three show where the motion of a contact is too curved for them (two may agree by
/// chance).
const STEPS: [f64; 3] = [0.01, 0.007, 0.005];

/// Differences that agree within this, relative to the larger of 1 and their value, are used as the reference.
const TRUSTED: f64 = 1e-7;

/// What the rounding of poses (`2^-52`) over the shortest step leaves, relative to the larger of 1 and the value. Where
/// edges are nearly parallel or a rim lies nearly flat the error is larger, which the three steps show.
const ROUNDING: f64 = 2e-12;

/// Central difference of eighth order.
fn difference(f: &impl Fn(f64) -> DVec3, h: f64) -> DVec3 {
    let term = |(k, weight): (usize, f64)| {
        let s = h * (k + 1) as f64;
        (f(s) - f(-s)) * weight
    };
    FIRST.into_iter().enumerate().map(term).sum::<DVec3>() / h
}

/// The derivative at zero and the difference between the three steps; none when they do not agree.
fn derivative(f: impl Fn(f64) -> DVec3) -> Option<(DVec3, f64)> {
    let [first, second, third] = STEPS.map(|h| difference(&f, h));
    let doubt = (first - third).length().max((second - third).length());
    (doubt < TRUSTED * first.length().max(1.0)).then_some((third, doubt))
}

fn assert_near(name: &str, what: &str, found: DVec3, (expected, doubt): (DVec3, f64)) {
    let error = (found - expected).length();
    let allowed = 4.0 * doubt + ROUNDING * expected.length().max(1.0);
    assert!(error <= allowed, "{name}, {what}: {found} against {expected}, {error:e} of {allowed:e}");
}

/// At random poses, of which at least 20 must have a contact that differences can follow.
fn check_at(poses: u32, name: &str, feature: ContactFeature, shape_a: &Shape, shape_b: &Shape, random: &mut Random) {
    let mut checked = 0;
    for _ in 0..poses {
        let (a, b) = (Path::random(random), Path::random(random));
        let at = |t: f64| {
            let (pose_a, pose_b) = (a.pose(t), b.pose(t));
            tangential(feature, shape_a, &pose_a, &a.velocity_at(t), shape_b, &pose_b, &b.velocity_at(t))
        };
        let (pose_a, pose_b) = (a.pose(0.0), b.pose(0.0));
        let both =
            kinematics_with_tangential(feature, shape_a, &pose_a, &a.velocity(), shape_b, &pose_b, &b.velocity());
        assert_eq!(both.map(|both| both.1), at(0.0));
        assert_eq!(
            both.map(|both| both.0),
            kinematics(feature, shape_a, &pose_a, &a.velocity(), shape_b, &pose_b, &b.velocity())
        );
        let Some((normal_terms, terms)) = both else { continue };
        let TangentialKinematics { slip_velocity, acceleration_bias, point_velocity, normal_rate, .. } = terms;
        let (n, p) = (normal_terms.geometry.normal, normal_terms.geometry.point);
        let nan = DVec3::splat(f64::NAN);
        let place = |t: f64| evaluate(feature, shape_a, &a.pose(t), shape_b, &b.pose(t));
        let differences = (
            derivative(|t| place(t).map_or(nan, |g| g.point)),
            derivative(|t| place(t).map_or(nan, |g| g.normal)),
            derivative(|t| at(t).map_or(nan, |k| k.slip_velocity)),
        );
        let (Some(of_point), Some(of_normal), Some(of_slip)) = differences else { continue };
        checked += 1;
        let (arm_a, arm_b) = (p - pose_a.translation, p - pose_b.translation);
        let relative = a.velocity().at(arm_a) - b.velocity().at(arm_b);
        assert_near(name, "slip", slip_velocity, (relative - n * n.dot(relative), 0.0));
        assert_near(name, "velocity of the point", point_velocity, of_point);
        assert_near(name, "rate of the normal", normal_rate, of_normal);
        let given = a.given_acceleration(arm_a) - b.given_acceleration(arm_b);
        let predicted = given - n * n.dot(given) + acceleration_bias;
        assert_near(name, "derivative of the slip", predicted, of_slip);
    }
    assert!(checked >= 20, "{name}: only {checked}");
}

/// Every kind of contact of polyhedra, clouds, spheres and half-spaces, in both orders.
#[test]
fn of_every_kind() {
    let mut random = Random(2345);
    each_kind(|name, feature, a, b| check_at(POSES, name, feature, a, b, &mut random));
}

/// Every pair of elements of round shapes, in both orders.
#[test]
fn of_every_pair_of_elements_of_round_shapes() {
    let mut random = Random(5432);
    each_pair_of_elements(|name, feature, a, b| check_at(2 * POSES, name, feature, a, b, &mut random));
}
