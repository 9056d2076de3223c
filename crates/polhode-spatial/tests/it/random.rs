//! Random input and comparisons.

use polhode_spatial::inertia::point_inertia;
use polhode_spatial::{DMat3, DVec3, Inertia, Mass, MassProperties, Pose, Rotation};
use proptest::prelude::*;

/// Vectors with components up to `size`.
pub(crate) fn vectors(size: f64) -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-size..size).prop_map(DVec3::from_array)
}

/// Rotations of up to one and a half turns.
pub(crate) fn rotations() -> impl Strategy<Value = Rotation> {
    vectors(5.0).prop_map(Rotation::from_rotation_vector)
}

/// Poses within `size` of the origin.
pub(crate) fn poses(size: f64) -> impl Strategy<Value = Pose> {
    (rotations(), vectors(size)).prop_map(|(rotation, translation)| Pose::new(rotation, translation))
}

/// Particles (mass, position): a rigid cloud, the definition of every mass property.
pub(crate) fn clouds() -> impl Strategy<Value = Vec<(f64, DVec3)>> {
    prop::collection::vec((0.1..2.0f64, vectors(3.0)), 4..10)
}

/// Mass properties of a cloud by their definition.
pub(crate) fn cloud_properties(cloud: &[(f64, DVec3)]) -> MassProperties {
    let mass: f64 = cloud.iter().map(|&(m, _)| m).sum();
    let center = cloud.iter().map(|&(m, p)| m * p).sum::<DVec3>() / mass;
    let inertia = cloud.iter().fold(DMat3::ZERO, |sum, &(m, p)| sum + point_inertia(m, p - center));
    MassProperties::new(Mass::new(mass).unwrap(), center, Inertia::new(inertia).unwrap())
}

/// Largest element by magnitude.
pub(crate) fn largest(matrix: DMat3) -> f64 {
    matrix.to_cols_array().into_iter().fold(0.0, |l, x| l.max(x.abs()))
}

/// Whether two matrices agree, relative to the largest element expected.
#[track_caller]
pub(crate) fn assert_matrix(found: DMat3, expected: DMat3, tolerance: f64) {
    let error = largest(found - expected) / largest(expected);
    assert!(error <= tolerance, "found {found}, expected {expected}: relative error {error:e}, allowed {tolerance:e}");
}

/// Whether two vectors agree, relative to `scale`.
#[track_caller]
pub(crate) fn assert_vector(found: DVec3, expected: DVec3, scale: f64, tolerance: f64) {
    let error = (found - expected).length() / scale;
    assert!(error <= tolerance, "found {found}, expected {expected}: relative error {error:e}, allowed {tolerance:e}");
}

/// Whether two sets of mass properties agree.
#[track_caller]
pub(crate) fn assert_same_body(found: &MassProperties, expected: &MassProperties, tolerance: f64) {
    assert!((found.mass() / expected.mass() - 1.0).abs() <= tolerance);
    assert_vector(found.center_of_mass(), expected.center_of_mass(), 1.0, tolerance);
    assert_matrix(found.inertia().matrix(), expected.inertia().matrix(), tolerance);
}
