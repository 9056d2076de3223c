//! Derivatives of the separation at touch, where it is zero to rounding.

use polhode_contact::{ContactFeature, Shape, Side, kinematics};
use polhode_spatial::{DVec3, Pose, Rotation, UnitVector, Velocity};

/// Separations about touch, m: rounding of either sign, and none.
const SEPARATIONS: [f64; 9] = [0.0, 1e-18, -1e-18, 1e-16, -1e-16, 2e-15, -2e-15, 1e-12, 1e-9];

/// A sample point, an apex or a cap that slides along a plane has only its own centripetal acceleration towards it,
/// however small the separation: its normal is the plane's.
#[test]
fn a_point_that_slides_on_a_plane_is_not_accelerated_by_the_rounding_of_its_separation() {
    let up = UnitVector::new(DVec3::new(1.0, 0.3, 1.0)).expect("up");
    let floor = Shape::half_space(up);
    let shapes = [
        (Shape::cone(0.25, 0.6), 3),
        (Shape::cone(0.25, 0.6), 0),
        (Shape::cylinder(0.25, 0.6), 12),
        (Shape::torus(0.3, 0.1), 5),
    ];
    for (shape, vertex) in shapes {
        let shape = shape.expect("a shape");
        let feature = ContactFeature::VertexFace { vertex_of: Side::B, vertex, face: 0 };
        for (k, spin) in [DVec3::ZERO, DVec3::new(1e-17, -2e-17, 0.0), DVec3::new(1.0, -2.0, 0.5)].iter().enumerate() {
            let velocity = Velocity { linear: DVec3::new(0.8, 0.1, -0.7) * 10.0, angular: *spin };
            for separation in SEPARATIONS {
                let rotation = Rotation::from_rotation_vector(DVec3::new(0.3, -0.2, 0.1 * k as f64));
                let still = Pose::new(Rotation::IDENTITY, DVec3::ZERO);
                let at = |pose: &Pose| {
                    kinematics(feature, &floor, &still, &Velocity::ZERO, &shape, pose, &velocity).expect("a contact")
                };
                let high = Pose::new(rotation, DVec3::Z);
                let lift = separation - at(&high).geometry.separation;
                let pose = Pose::new(rotation, high.translation + up.get() * lift);
                let found = at(&pose);
                let arm = found.geometry.point - pose.translation;
                // The point itself, not the middle of the gap or of a ball: half the separation and the radius off.
                let radius = if matches!(shape, Shape::Torus(_)) { 0.1 } else { 0.0 };
                let arm = arm + up.get() * (radius + 0.5 * found.geometry.separation);
                let expected = up.get().dot(spin.cross(spin.cross(arm)));
                let error = (found.acceleration_bias - expected).abs();
                // A few roundings of the centripetal acceleration, w^2 times a length.
                let allowed = 1e-14 * spin.length_squared();
                assert!(error <= allowed, "{shape:?} at {separation:e}, spin {spin}: {error:e}");
            }
        }
    }
}
