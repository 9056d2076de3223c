//! The contacts of two bodies that pass each other along an open face (`terms/open_face.rs`).
//!
//! Where such bodies touch beside the face, at its border or beyond it, they do not collide. The face stands for its
//! border: the contacts are those of the other body with the plane of the face, as far as they lie on the face or
//! beyond its border by no more than `BEYOND` times the joint size. They have the normal of the face. A contact
//! that has this normal itself, as where the flat side of a polyhedron lies on the border, stays.

use crate::clearance::joint_size;
use crate::narrow_phase::dispatch::workspace::Workspace;
use crate::narrow_phase::feature::part_feature::{Kind, Local, globalized, localized};
use crate::narrow_phase::feature::placed::Placed;
use crate::narrow_phase::pair::pair_manifold::pair_manifold;
use crate::narrow_phase::terms::evaluate::evaluate;
use crate::narrow_phase::terms::open_face::{Moving, OpenFace, open_faces};
use crate::shape::HalfSpace;
use crate::{ContactFeature, Manifold, Shape, Side};
use glam::DVec3;
use polhode_spatial::unit_vector::SAME_DIRECTION;

/// How far beyond the border of a face a contact of its plane may lie, relative to the joint size (no unit, 1e-5 to
/// 1e-3): a ball whose lowest point is 1e-11 of its diameter (a usual touch distance) below the plane meets the border
/// at 6e-6 of its radius beside that point.
const BEYOND: f64 = 1e-4;

/// Two bodies, asked for the contacts that take the place of others while they pass each other along an open face.
///
/// A ball slides on a plane, flush with the top of a box, and reaches the edge of the box. The contact is with the top.
/// ```
/// use polhode_contact::{ContactFeature, DVec3, Moving, Passing, Pose, Shape, Side, SurfaceFeature, Velocity};
/// let (ball, tile) = (Shape::sphere(0.5)?, Shape::cuboid(DVec3::ONE)?);
/// let before_edge = Pose::from_translation(DVec3::new(-0.5 - 1e-9, 0.0, 1.0));
/// let slides = Velocity::new(DVec3::X, DVec3::ZERO);
/// let ball = Moving { shape: &ball, pose: &before_edge, velocity: &slides };
/// let tile = Moving { shape: &tile, pose: &Pose::IDENTITY, velocity: &Velocity::ZERO };
/// let edge = ContactFeature::Smooth { center_of: Side::A, center: 0, against: SurfaceFeature::Edge(0) };
/// let contacts = Passing::new(ball, tile, 1e-11).in_place_of(edge, -DVec3::X).unwrap_or_default();
/// assert!(matches!(contacts[..], [ContactFeature::Smooth { against: SurfaceFeature::Face(_), .. }]));
/// # Ok::<(), polhode_contact::ShapeError>(())
/// ```
#[derive(Debug)]
pub struct Passing<'a> {
    a: Moving<'a>,
    b: Moving<'a>,
    touch: f64,
    /// The parts that the last contact named, with their open faces: contacts in order of their features name the same
    /// parts one after the other.
    last: Option<([usize; 2], Vec<OpenFace>)>,
}

impl<'a> Passing<'a> {
    /// Two bodies with their touch distance, m.
    #[must_use]
    pub const fn new(a: Moving<'a>, b: Moving<'a>, touch: f64) -> Self {
        Self { a, b, touch, last: None }
    }

    /// The contacts that take the place of one with a unit normal, along an open face of the parts that it names; none
    /// when there is no such face, or when the contact itself is with that face.
    pub fn in_place_of(&mut self, feature: ContactFeature, normal: DVec3) -> Option<Vec<ContactFeature>> {
        let (a, b, touch) = (self.a, self.b, self.touch);
        let Local { shapes, parts, .. } = localized(feature, a.shape, b.shape)?;
        let (a_part, b_part) = (Moving { shape: shapes[0], ..a }, Moving { shape: shapes[1], ..b });
        let last = self.last.take().filter(|last| last.0 == parts);
        let (_, open) = self.last.insert(last.unwrap_or_else(|| (parts, open_faces(a_part, b_part, touch))));
        let is_of_face = |face: &OpenFace| {
            let outward = face.of_pose(a, b).rotation.rotate(face.normal);
            outward.cross(normal).length() <= SAME_DIRECTION
        };
        let is_of_polyhedra = matches!(feature, ContactFeature::VertexFace { .. } | ContactFeature::EdgeEdge { .. });
        if open.is_empty() || is_of_polyhedra && open.iter().any(is_of_face) {
            return None;
        }
        let found = open.iter().flat_map(|face| on_plane(face, a_part, b_part, touch));
        Some(found.map(|contact| globalized(contact, [a.shape, b.shape], parts)).collect())
    }
}

/// The contacts of one body with the plane of a face of the other one, near that face.
fn on_plane(open: &OpenFace, a: Moving<'_>, b: Moving<'_>, touch: f64) -> Vec<ContactFeature> {
    let size = joint_size(a.shape, b.shape);
    let reach = open.separation.max(0.0) + touch;
    let plane = Shape::HalfSpace(HalfSpace { normal: open.normal, offset: open.offset });
    let (shape_a, shape_b) = match open.of {
        Side::A => (&plane, b.shape),
        Side::B => (a.shape, &plane),
    };
    let mut found = Manifold::default();
    let (at_a, at_b) = (Placed::new(shape_a, a.pose), Placed::new(shape_b, b.pose));
    pair_manifold(Workspace::default().pair(), at_a, at_b, reach, &mut found);
    let of_face = |feature: ContactFeature| {
        feature.renumbered(|side, kind, number| match kind {
            Kind::Face if side == open.of => Some(open.face),
            _ => Some(number),
        })
    };
    let is_near = |feature: &ContactFeature| {
        let geometry = evaluate(*feature, a.shape, a.pose, b.shape, b.pose);
        geometry.is_some_and(|geometry| geometry.margin >= -BEYOND * size)
    };
    found.contacts.iter().filter_map(|contact| of_face(contact.feature)).filter(is_near).collect()
}
