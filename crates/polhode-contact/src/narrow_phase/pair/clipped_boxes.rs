//! The contacts of two boxes, or of a box and a half-space, as the face of one clipped by the face of the other.
//!
//! It is for methods that let bodies overlap: the whole face that touches gives contacts, however deep and tilted,
//! where the manifold of bodies that only touch ([`near_manifold`](crate::near_manifold)) has the deepest features
//! alone. The axis is that of the largest separation (Gottschalk 1996); of a face that decides, the facing one of the
//! other box is clipped at its sides (Sutherland and Hodgman 1974), and the points within the reach are contacts along
//! its normal; of two edges their nearest points are one contact. A face is preferred to edges that separate by less
//! than `EDGES_BEYOND` more, so that contacts of a tilting box do not change at every step.
//!
//! Contacts have the features that [`crate::ConvexPolyhedron::cuboid`] gives them. Failure: none; other shapes are not
//! taken.

use crate::shape::polyhedron::ConvexPolyhedron;
use crate::{Contact, ContactFeature, ContactGeometry, HalfSpace, Manifold, SeparatingAxis, Shape, Side};
use glam::{DMat3, DVec3};
use polhode_spatial::Pose;
use smallvec::SmallVec;

/// By how much two edges must separate more than the best face, relative to the smallest edge of the boxes (no unit,
/// 1e-3 to 5e-2).
const EDGES_BEYOND: f64 = 1e-2;

/// The square of the sine of the angle between two edges below which their common perpendicular is not tried (no unit):
/// a face does as well.
const NEARLY_PARALLEL: f64 = 1e-6;

/// A box: where its centre is, its axes and half edges.
#[derive(Debug, Clone, Copy)]
struct Placed {
    center: DVec3,
    axes: DMat3,
    half: DVec3,
}

impl Placed {
    /// A polyhedron that is a box with edges along its own axes; none of another.
    fn of(polyhedron: &ConvexPolyhedron, pose: &Pose) -> Option<Self> {
        let [first, .., last] = polyhedron.vertices() else { return None };
        if polyhedron.vertices().len() != 8 || polyhedron.face_count() != 6 {
            return None;
        }
        let (middle, half) = ((*first + *last) * 0.5, (*last - *first) * 0.5);
        let is_corner = |(number, vertex): (usize, &DVec3)| {
            let expected = |k: usize| if number >> k & 1 == 1 { last[k] } else { first[k] };
            vertex.x == expected(0) && vertex.y == expected(1) && vertex.z == expected(2)
        };
        let is_box = half.min_element() > 0.0 && polyhedron.vertices().iter().enumerate().all(is_corner);
        is_box.then(|| Self { center: pose.transform_point(middle), axes: pose.rotation.to_matrix(), half })
    }

    /// The corner of this number.
    fn corner(&self, number: usize) -> DVec3 {
        let sign = |k: usize| if number >> k & 1 == 1 { 1.0 } else { -1.0 };
        self.center + self.axes * (DVec3::new(sign(0), sign(1), sign(2)) * self.half)
    }

    /// The number of the corner farthest along a direction (world).
    fn farthest(&self, direction: DVec3) -> usize {
        let along = self.axes.transpose() * direction;
        (0..3).map(|k| usize::from(along[k] > 0.0) << k).sum()
    }
}

/// Fills `found` with the contacts of two boxes, or of a box and a half-space, with a separation of at most `reach`
/// (m). Returns whether they are such shapes, and contacts were found wherever they are within the reach. Of two faces
/// that separate nearly equally, by `EDGES_BEYOND`, that of the
/// `base` decides.
pub fn clipped_manifold(
    (shape_a, pose_a): (&Shape, &Pose),
    (shape_b, pose_b): (&Shape, &Pose),
    (reach, base): (f64, Side),
    found: &mut Manifold,
) -> bool {
    found.contacts.clear();
    (found.separation, found.axis) = (f64::NAN, SeparatingAxis::None);
    match (shape_a, shape_b) {
        (Shape::Convex(a), Shape::Convex(b)) => match (Placed::of(a, pose_a), Placed::of(b, pose_b)) {
            (Some(placed_a), Some(placed_b)) => of_boxes([a, b], &[placed_a, placed_b], (reach, base), found),
            _ => false,
        },
        (Shape::Convex(a), Shape::HalfSpace(b)) => on_plane((a, pose_a, Side::A), (b, pose_b), reach, found),
        (Shape::HalfSpace(a), Shape::Convex(b)) => on_plane((b, pose_b, Side::B), (a, pose_a), reach, found),
        _ => false,
    }
}

/// The corners of a polyhedron near a half-space.
fn on_plane(
    (polyhedron, pose, side): (&ConvexPolyhedron, &Pose, Side),
    (plane, plane_pose): (&HalfSpace, &Pose),
    reach: f64,
    found: &mut Manifold,
) -> bool {
    let outward = plane_pose.rotation.rotate(plane.normal);
    let offset = outward.dot(plane_pose.translation) + plane.offset;
    let normal = if side == Side::A { outward } else { -outward };
    let mut least = f64::INFINITY;
    for (vertex, at) in (0..).zip(polyhedron.vertices()) {
        let place = pose.transform_point(*at);
        let separation = outward.dot(place) - offset;
        least = least.min(separation);
        if separation <= reach {
            let feature = ContactFeature::VertexFace { vertex_of: side, vertex, face: 0 };
            let point = place - outward * (0.5 * separation);
            let geometry = ContactGeometry { point, normal, separation, margin: f64::INFINITY };
            found.contacts.push(Contact { feature, geometry });
        }
    }
    found.separation = least;
    least.is_finite()
}

/// The best axis so far.
#[derive(Debug, Clone, Copy)]
struct Best {
    separation: f64,
    axis: SeparatingAxis,
    /// Unit vector from A to B, world.
    toward_b: DVec3,
}

fn of_boxes(
    polyhedra: [&ConvexPolyhedron; 2],
    boxes: &[Placed; 2],
    (reach, base): (f64, Side),
    found: &mut Manifold,
) -> bool {
    let [a, b] = boxes;
    let between = b.center - a.center;
    let turn = a.axes.transpose() * b.axes;
    let magnitudes = DMat3::from_cols(turn.x_axis.abs(), turn.y_axis.abs(), turn.z_axis.abs());
    let (in_a, in_b) = (a.axes.transpose() * between, b.axes.transpose() * between);
    let gaps_a = in_a.abs() - a.half - magnitudes * b.half;
    let gaps_b = in_b.abs() - b.half - magnitudes.transpose() * a.half;
    let beyond = EDGES_BEYOND * a.half.min_element().min(b.half.min_element());
    let (best, separation) = best_face(boxes, [gaps_a, gaps_b], [in_a, in_b], (base, beyond));
    found.separation = separation;
    if separation.is_nan() || separation > reach {
        return separation > reach;
    }
    let edges = best_edges(boxes, &turn, (in_a, between));
    found.separation = found.separation.max(edges.map_or(f64::NEG_INFINITY, |(best, _)| best.separation));
    if found.separation > reach {
        return true;
    }
    match edges {
        Some((crossed, pair)) if crossed.separation > best.separation + beyond => {
            cross(polyhedra, boxes, (crossed.toward_b, pair), found);
        }
        _ => clip(polyhedra, boxes, &best, reach, found),
    }
    !found.contacts.is_empty()
}

/// The face that separates most: one of the base, unless one of the other box does by this much more. Also the largest
/// separation by a face of either.
fn best_face([a, b]: &[Placed; 2], gaps: [DVec3; 2], along: [DVec3; 2], (base, beyond): (Side, f64)) -> (Best, f64) {
    let widest = |gaps: DVec3| (1..3).fold(0, |best, k| if gaps[k] > gaps[best] { k } else { best });
    let [i, j] = gaps.map(widest);
    let face = |k: usize, along: f64| 2 * k as u32 + u32::from(along > 0.0);
    let (of_a, of_b) = (gaps[0][i], gaps[1][j]);
    let most = if of_a > of_b { of_a } else { of_b };
    let is_of_a = if base == Side::A { of_b <= of_a + beyond } else { of_a > of_b + beyond };
    let best = if is_of_a {
        let axis = SeparatingAxis::FaceA(face(i, along[0][i]));
        Best { separation: of_a, axis, toward_b: a.axes.col(i) * along[0][i].signum() }
    } else {
        let axis = SeparatingAxis::FaceB(face(j, -along[1][j]));
        Best { separation: of_b, axis, toward_b: b.axes.col(j) * along[1][j].signum() }
    };
    (best, most)
}

/// The pair of edges that separates most, as their axes.
fn best_edges([a, b]: &[Placed; 2], turn: &DMat3, (in_a, between): (DVec3, DVec3)) -> Option<(Best, (usize, usize))> {
    let mut best: Option<(Best, (usize, usize))> = None;
    for j in 0..3 {
        let edge_b = turn.col(j);
        for i in 0..3 {
            let square = 1.0 - edge_b[i] * edge_b[i];
            if square < NEARLY_PARALLEL {
                continue;
            }
            // In the axes of A.
            let mut unit = DVec3::ZERO;
            unit[i] = 1.0;
            let axis = unit.cross(edge_b) / square.sqrt();
            let along = axis.dot(in_a);
            let of_b = turn.transpose() * axis;
            let separation = along.abs() - axis.abs().dot(a.half) - of_b.abs().dot(b.half);
            if best.as_ref().is_none_or(|(known, _)| separation > known.separation) {
                let world = a.axes * axis;
                let toward_b = if world.dot(between) < 0.0 { -world } else { world };
                best = Some((Best { separation, axis: SeparatingAxis::Nearest, toward_b }, (i, j)));
            }
        }
    }
    best
}

/// The contact of two edges that cross.
fn cross(
    [polyhedron_a, polyhedron_b]: [&ConvexPolyhedron; 2],
    [a, b]: &[Placed; 2],
    (toward_b, (i, j)): (DVec3, (usize, usize)),
    found: &mut Manifold,
) {
    let (corner_a, corner_b) = (a.farthest(toward_b), b.farthest(-toward_b));
    let (low_a, low_b) = (corner_a & !(1 << i), corner_b & !(1 << j));
    let (from_a, from_b) = (a.corner(low_a), b.corner(low_b));
    let (along_a, along_b) = (a.axes.col(i), b.axes.col(j));
    let (apart, cosine) = (from_b - from_a, along_a.dot(along_b));
    let (x, y) = (apart.dot(along_a), apart.dot(along_b));
    let square = 1.0 - cosine * cosine;
    let on_a = ((x - cosine * y) / square).clamp(0.0, 2.0 * a.half[i]);
    let on_b = ((cosine * x - y) / square).clamp(0.0, 2.0 * b.half[j]);
    let (at_a, at_b) = (from_a + along_a * on_a, from_b + along_b * on_b);
    let edge = |polyhedron: &ConvexPolyhedron, low: usize, axis: usize| edge_between(polyhedron, low, low | 1 << axis);
    let (Some(edge_a), Some(edge_b)) = (edge(polyhedron_a, low_a, i), edge(polyhedron_b, low_b, j)) else { return };
    let separation = toward_b.dot(at_b - at_a);
    let geometry = ContactGeometry { point: (at_a + at_b) * 0.5, normal: -toward_b, separation, margin: f64::INFINITY };
    found.contacts.push(Contact { feature: ContactFeature::EdgeEdge { edge_a, edge_b }, geometry });
    found.axis = SeparatingAxis::Edges(edge_a, edge_b);
}

/// The edge between two corners.
fn edge_between(polyhedron: &ConvexPolyhedron, x: usize, y: usize) -> Option<u32> {
    let ends = [x.min(y) as u32, x.max(y) as u32];
    let is_it = |edge: &crate::Edge| edge.vertices == ends || edge.vertices == [ends[1], ends[0]];
    polyhedron.edges().iter().position(is_it).map(|place| place as u32)
}

/// What a side of the clipped face lies on.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Line {
    /// An edge of the face that is clipped: its two corners.
    Own(u8, u8),
    /// A side of the face that clips.
    Clip(u8),
}

/// What a corner of the clipped face is.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Corner {
    /// One of the face that is clipped.
    Own(u8),
    /// Where an edge of it crosses a side of the other.
    Crossing(u8, u8, u8),
    /// Below a corner of the face that clips, between two of its sides.
    Below(u8, u8),
}

/// A corner of the clipped face, with what its side to the next one lies on.
#[derive(Debug, Clone, Copy)]
struct Clipped {
    /// Relative to the centre of the face that clips, along its two axes, and outward.
    at: DVec3,
    corner: Corner,
    line: Line,
}

/// A face while it is clipped: four corners, and one more for each side that clips.
type Polygon = SmallVec<[Clipped; 8]>;

/// The contacts of the face that decides with the facing one of the other box.
fn clip(polyhedra: [&ConvexPolyhedron; 2], boxes: &[Placed; 2], best: &Best, reach: f64, found: &mut Manifold) {
    let (side, face) = match best.axis {
        SeparatingAxis::FaceA(face) => (Side::A, face as usize),
        SeparatingAxis::FaceB(face) => (Side::B, face as usize),
        _ => return,
    };
    let (own, other) = (&boxes[side.index()], &boxes[side.other().index()]);
    let outward = if side == Side::A { best.toward_b } else { -best.toward_b };
    let k = face / 2;
    let [u, v] = [(k + 1) % 3, (k + 2) % 3];
    let frame = DMat3::from_cols(own.axes.col(u), own.axes.col(v), outward);
    let center = own.center + outward * own.half[k];
    // The facing face of the other box: the most opposite one.
    let against = other.axes.transpose() * outward;
    let m = (0..3).max_by(|&i, &j| against[i].abs().total_cmp(&against[j].abs())).unwrap_or(0);
    let facing = 2 * m + usize::from(against[m] < 0.0);
    let [p, q] = [(m + 1) % 3, (m + 2) % 3];
    let base = usize::from(against[m] < 0.0) << m;
    let ring = [base, base | 1 << p, base | 1 << p | 1 << q, base | 1 << q].map(|corner| corner as u8);
    let mut polygon = Polygon::new();
    for (place, &number) in ring.iter().enumerate() {
        let at = frame.transpose() * (other.corner(usize::from(number)) - center);
        let line = Line::Own(number, ring[(place + 1) % 4]);
        polygon.push(Clipped { at, corner: Corner::Own(number), line });
    }
    for (clip_side, half) in (0..).zip([own.half[u], own.half[u], own.half[v], own.half[v]]) {
        polygon = clipped(&polygon, clip_side, half);
    }
    let normal = if side == Side::A { -outward } else { outward };
    for corner in polygon.iter().filter(|corner| corner.at.z <= reach) {
        let numbers = (polyhedra, side, face, facing, [k, u, v]);
        let Some(feature) = feature_of(corner.corner, numbers) else { continue };
        let point = center + frame * DVec3::new(corner.at.x, corner.at.y, 0.5 * corner.at.z);
        let geometry = ContactGeometry { point, normal, separation: corner.at.z, margin: f64::INFINITY };
        found.contacts.push(Contact { feature, geometry });
    }
    found.contacts.sort_unstable_by_key(|contact| contact.feature);
    found.axis = best.axis;
}

/// What of a polygon is inside one side of a rectangle: along axis `side / 2`, below `-half` (even) or above `half`
/// (odd) is outside.
fn clipped(polygon: &[Clipped], side: u8, half: f64) -> Polygon {
    let outside = |corner: &Clipped| {
        let along = if side < 2 { corner.at.x } else { corner.at.y };
        if side.is_multiple_of(2) { -along - half } else { along - half }
    };
    let mut kept = Polygon::new();
    for (place, now) in polygon.iter().enumerate() {
        let next = &polygon[(place + 1) % polygon.len()];
        let (here, there) = (outside(now), outside(next));
        if here <= 0.0 {
            kept.push(*now);
        }
        if (here <= 0.0) == (there <= 0.0) {
            continue;
        }
        let at = now.at + (next.at - now.at) * (here / (here - there));
        let corner = match now.line {
            Line::Own(x, y) => Corner::Crossing(x, y, side),
            Line::Clip(other) => Corner::Below(other, side),
        };
        let line = if here <= 0.0 { Line::Clip(side) } else { now.line };
        kept.push(Clipped { at, corner, line });
    }
    kept
}

/// The feature of a corner of the clipped face. `axes` are those of the clipping face: its normal and its two sides.
fn feature_of(
    corner: Corner,
    (polyhedra, side, face, facing, axes): ([&ConvexPolyhedron; 2], Side, usize, usize, [usize; 3]),
) -> Option<ContactFeature> {
    let [k, u, v] = axes;
    let top = (face % 2) << k;
    let along = |clip_side: u8| if clip_side < 2 { u } else { v };
    let bit = |clip_side: u8| usize::from(clip_side % 2) << along(clip_side);
    let (own, other) = (polyhedra[side.index()], polyhedra[side.other().index()]);
    Some(match corner {
        Corner::Own(vertex) => {
            ContactFeature::VertexFace { vertex_of: side.other(), vertex: vertex.into(), face: face as u32 }
        }
        Corner::Below(x, y) => {
            let vertex = (top | bit(x) | bit(y)) as u32;
            ContactFeature::VertexFace { vertex_of: side, vertex, face: facing as u32 }
        }
        Corner::Crossing(x, y, clip_side) => {
            let free = if clip_side < 2 { v } else { u };
            let low = top | bit(clip_side);
            let (own_edge, other_edge) =
                (edge_between(own, low, low | 1 << free)?, edge_between(other, x.into(), y.into())?);
            let [edge_a, edge_b] = if side == Side::A { [own_edge, other_edge] } else { [other_edge, own_edge] };
            ContactFeature::EdgeEdge { edge_a, edge_b }
        }
    })
}

#[cfg(test)]
mod tests {
    //! Boxes that touch have the contacts of the general manifold; the separation is the general one; boxes that
    //! overlap deeply keep a whole face of contacts, each as deep as it says.
    use super::*;
    use crate::{Workspace, near_manifold, separation};
    use polhode_spatial::{Rotation, SplitMix64};

    fn found(a: (&Shape, &Pose), b: (&Shape, &Pose), reach: f64) -> (bool, Manifold) {
        let mut found = Manifold::default();
        (clipped_manifold(a, b, (reach, Side::A), &mut found), found)
    }

    #[test]
    fn faces_that_touch_agree_with_the_general_manifold() {
        let [small, large] = [1.0, 2.0].map(|size| Shape::cuboid(DVec3::splat(size)).expect("valid"));
        let shifts = [
            DVec3::new(0.1, 0.2, 1.5),
            DVec3::new(1.2, 0.3, 1.5),
            DVec3::new(1.2, 1.3, 1.5),
            DVec3::new(1.5, 0.1, 0.3),
        ];
        for shift in shifts {
            let turn = if shift.z == 1.5 { Rotation::from_rotation_vector(DVec3::Z * 0.3) } else { Rotation::IDENTITY };
            let (pose_a, pose_b) = (Pose::new(turn, shift), Pose::IDENTITY);
            let general = near_manifold(&small, &pose_a, &large, &pose_b, 1e-9);
            let (is_taken, own) = found((&small, &pose_a), (&large, &pose_b), 1e-9);
            assert!(is_taken, "{shift}");
            let features = |manifold: &Manifold| manifold.contacts.iter().map(|c| c.feature).collect::<Vec<_>>();
            assert_eq!(features(&own), features(&general), "{shift}");
            for (x, y) in own.contacts.iter().zip(&general.contacts) {
                assert!((x.geometry.point - y.geometry.point).length() < 1e-12, "{x:?} {y:?}");
                assert!((x.geometry.normal - y.geometry.normal).length() < 1e-12, "{x:?} {y:?}");
            }
        }
    }

    #[test]
    fn separations_are_the_general_ones() {
        let mut random = SplitMix64::new(3);
        let mut number = |most: f64| most * (2.0 * random.uniform() - 1.0);
        let _ = Workspace::default();
        for _ in 0..2000 {
            let sizes = [0, 1].map(|_| DVec3::new(1.2 + number(1.0), 1.2 + number(1.0), 1.2 + number(1.0)));
            let shapes = sizes.map(|size| Shape::cuboid(size).expect("valid"));
            let mut pose = || {
                let turn = Rotation::from_rotation_vector(DVec3::new(number(3.0), number(3.0), number(3.0)));
                Pose::new(turn, DVec3::new(number(0.8), number(0.8), number(0.8)))
            };
            let (pose_a, pose_b) = (pose(), pose());
            let general = separation(&shapes[0], &pose_a, &shapes[1], &pose_b);
            let (is_taken, own) = found((&shapes[0], &pose_a), (&shapes[1], &pose_b), 0.1);
            if general > 0.1 {
                continue;
            }
            // Apart the general separation is the distance, of which that along an axis is a bound.
            assert!(is_taken, "{general}");
            if general <= 0.0 {
                assert!((own.separation - general).abs() < 1e-9, "{} {general}", own.separation);
            }
            assert!(own.separation <= general + 1e-9, "{} {general}", own.separation);
            let deepest = own.contacts.iter().map(|c| c.geometry.separation).fold(f64::INFINITY, f64::min);
            assert!(deepest >= own.separation - 0.05 && deepest < 0.1 + 1e-9, "{deepest} {}", own.separation);
        }
    }

    #[test]
    fn deep_overlaps_keep_a_face() {
        let cube = Shape::cuboid(DVec3::ONE).expect("valid");
        for tilt in [0.0, 1e-3, 0.02] {
            let turn = Rotation::from_rotation_vector(DVec3::new(tilt, -0.7 * tilt, 0.05));
            let pose = Pose::new(turn, DVec3::new(0.02, 0.01, 0.8));
            let (_, own) = found((&cube, &pose), (&cube, &Pose::IDENTITY), 0.01);
            assert!(own.contacts.len() >= 4, "{tilt}: {own:?}");
            assert!(own.contacts.iter().all(|c| (c.geometry.separation + 0.2).abs() < 0.05), "{tilt}: {own:?}");
            assert!(own.contacts.iter().all(|c| c.geometry.normal.z > 0.99), "{tilt}: {own:?}");
        }
    }
}
