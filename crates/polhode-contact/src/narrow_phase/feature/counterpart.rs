//! The second contact of two vertices that coincide.
//!
//! Where a vertex of one body meets a vertex of the other, the direction of the force is not defined by the two points
//! (thesis 3.3 calls the case degenerate and leaves the choice open). Two faces define it: the vertex of A must stay
//! outside the face of B and the vertex of B outside the face of A. A manifold has one contact per point, the first of
//! these. This module finds the second, for a contact response that treats both bodies alike: with one contact only, a
//! mirror-symmetric pair of bodies would be pushed along one of the two normals and lose its symmetry.

use crate::{ContactFeature, ConvexPolyhedron, Shape, Side};
use glam::DVec3;
use polhode_spatial::Pose;

/// Faces are parallel when the cosine between their normals is -1 within this: angles above about 2e-8 rad are
/// distinguished.
const PARALLEL_COSINE: f64 = 2.0 * f64::EPSILON;

/// The counterpart of a vertex-face contact whose vertex lies at a vertex of the face, within `distance` (m). None when
/// it lies elsewhere, when the two faces are parallel, or for shapes other than convex polyhedra.
pub fn counterpart(
    feature: ContactFeature,
    shape_a: &Shape,
    pose_a: &Pose,
    shape_b: &Shape,
    pose_b: &Pose,
    distance: f64,
) -> Option<ContactFeature> {
    let ContactFeature::VertexFace { vertex_of, vertex, face } = feature else { return None };
    let (Shape::Convex(a), Shape::Convex(b)) = (shape_a, shape_b) else { return None };
    // The owner of the vertex and the owner of the face.
    let ((owner, owner_pose), (other, other_pose)) = match vertex_of {
        Side::A => ((a, pose_a), (b, pose_b)),
        Side::B => ((b, pose_b), (a, pose_a)),
    };
    let in_other = other_pose.relative(owner_pose);
    let point = in_other.transform_point(*owner.vertices().get(vertex as usize)?);
    let other_face = other.face(face as usize)?;
    let partner = other_face
        .vertices
        .iter()
        .copied()
        .find(|&u| other.vertices().get(u as usize).is_some_and(|p| (*p - point).length() <= distance))?;
    // Whether all of the other body is on the outer side of a face through the common vertex.
    let separates = |normal: DVec3| {
        let height = |place: &DVec3| normal.dot(*place - point);
        other.vertices().iter().all(|place| height(place) >= -distance)
    };
    let (facing, cosine) = opposed_face(owner, vertex, &in_other, other_face.normal, separates)?;
    // Parallel faces have one normal: the second contact would repeat the first.
    if 1.0 + cosine <= PARALLEL_COSINE {
        return None;
    }
    Some(ContactFeature::VertexFace { vertex_of: vertex_of.other(), vertex: partner, face: facing })
}

/// The face at a vertex whose normal is most nearly opposite to `normal`, and the cosine between them; in a tie the
/// first. Faces that separate the bodies come before those that do not: of two cards that lean on each other by more
/// than 22.5 degrees, the end of the one is more nearly opposite to the face of the other than its face, but the other
/// card is not wholly on the outer side of that end, and pushed along its normal the cards would slide past each other.
fn opposed_face(
    owner: &ConvexPolyhedron,
    vertex: u32,
    pose: &Pose,
    normal: DVec3,
    separates: impl Fn(DVec3) -> bool,
) -> Option<(u32, f64)> {
    let mut best: Option<(bool, u32, f64)> = None;
    for (index, face) in owner.faces().enumerate().filter(|(_, face)| face.vertices.contains(&vertex)) {
        let own = pose.rotation.rotate(face.normal);
        let (cosine, is_separating) = (own.dot(normal), separates(own));
        let is_better = |(separating, _, least): (bool, u32, f64)| {
            if separating == is_separating { cosine < least } else { is_separating }
        };
        if best.is_none_or(is_better) {
            best = Some((is_separating, index as u32, cosine));
        }
    }
    best.map(|(_, face, cosine)| (face, cosine))
}

#[cfg(test)]
mod tests {
    //! Cards that lean on each other edge on edge are pushed by a face of each, however far they lean.
    use super::*;
    use polhode_spatial::Rotation;

    const SIZE: DVec3 = DVec3::new(0.002, 0.06, 0.09);

    /// A card whose upper inner edge is at the origin; the one of `side` -1 stands at -x.
    fn leaning(side: f64, lean: f64) -> Pose {
        let turn = Rotation::from_rotation_vector(DVec3::Y * (-side * lean));
        Pose::new(turn, -turn.rotate(DVec3::new(-side * 0.5 * SIZE.x, 0.0, 0.5 * SIZE.z)))
    }

    #[test]
    fn leaning_cards_are_pushed_by_a_face_of_each() {
        let card = Shape::cuboid(SIZE).expect("a size");
        for degrees in [15.0f64, 22.5, 25.0, 29.0, 30.0, 31.0, 35.0, 40.0] {
            let lean = degrees.to_radians();
            let [left, right] = [-1.0, 1.0].map(|side| leaning(side, lean));
            let found = crate::manifold(&card, &left, &card, &right, 1e-9);
            let normal =
                |feature| crate::evaluate(feature, &card, &left, &card, &right).map(|geometry| geometry.normal);
            let mut sides = [0, 0];
            for contact in &found.contacts {
                let second =
                    counterpart(contact.feature, &card, &left, &card, &right, 1e-12).expect("a second feature");
                for feature in [contact.feature, second] {
                    let normal = normal(feature).expect("a face");
                    // From the right card to the left one, up or down by the lean.
                    assert!((normal.x + libm::cos(lean)).abs() < 1e-12, "{degrees} degrees: {feature:?} {normal}");
                    sides[usize::from(normal.z > 0.0)] += 1;
                }
            }
            assert_eq!(sides, [2, 2], "{degrees} degrees");
        }
    }
}
