//! Whether a shape is a prism along an axis: the same in every plane across the axis between two end faces.
//!
//! Two prisms along one axis that overlap along it touch with normals across the axis: their distance is that of their
//! cross-sections. A box is a prism along each of its edges, a cylinder along its axis.
//!
//! Assumption: none about the size of the shape; directions are compared to rounding.

use crate::Shape;
use polhode_spatial::UnitVector;
use polhode_spatial::rounding;

/// Whether the shape is a prism, or a cylinder, along an axis of its frame. No answer but `false` is given for other
/// shapes, of which some are prisms too.
pub fn is_prism_along(shape: &Shape, axis: UnitVector) -> bool {
    let axis = axis.get();
    match shape {
        Shape::Convex(polyhedron) => polyhedron.faces().all(|face| {
            let along = face.normal.dot(axis).abs();
            along <= rounding::DOZENS_OF_TERMS || face.normal.cross(axis).length() <= rounding::DOZENS_OF_TERMS
        }),
        Shape::Cylinder(cylinder) => cylinder.axis().cross(axis).length() <= rounding::DOZENS_OF_TERMS,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    //! Boxes are prisms along their edges and not across a diagonal; pyramids are none.
    #![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use crate::ConvexPolyhedron;
    use glam::DVec3;

    #[test]
    fn boxes_and_cylinders_are_prisms_along_their_axes_only() {
        let axes = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| UnitVector::new(axis).unwrap());
        let block = Shape::cuboid(DVec3::new(1.0, 2.0, 3.0)).unwrap();
        assert!(axes.iter().all(|axis| is_prism_along(&block, *axis)));
        let oblique = UnitVector::new(DVec3::new(1.0, 1.0, 0.0)).unwrap();
        assert!(!is_prism_along(&block, oblique));
        let near = UnitVector::new(DVec3::new(1.0, 1e-9, 0.0)).unwrap();
        assert!(!is_prism_along(&block, near));
        let wheel = Shape::cylinder(0.5, 0.2).unwrap();
        assert_eq!(axes.map(|axis| is_prism_along(&wheel, axis)), [false, false, true]);
        let points = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let pyramid = Shape::convex(ConvexPolyhedron::from_points(&points).unwrap());
        assert!(!is_prism_along(&pyramid, UnitVector::new(DVec3::ONE).unwrap()));
    }
}
