//! Compounds and triangle meshes: what their parts give, put together.
//!
//! The separation is the least over the pairs of parts that can be nearest by their boxes. A manifold takes the contacts
//! of every pair of parts within reach, leaves out those that are none of the whole body (`compound_surface.rs`), adds
//! what re-entrant edges (`tied_faces.rs`) and bent ridges (`ridge_ends.rs`) hold instead, and keeps one for each place
//! and normal: a vertex on a face before others, then the higher face, vertex and edge number, then the upper body's, a
//! rule that follows the bodies and not their names. All of it is computed about A's origin, so that a pair far away
//! loses nothing; the geometry of the contacts that stay is [`evaluate`]'s at the poses given.

use crate::bounding::Bounds;
use crate::clearance::place_tolerance;
use crate::narrow_phase::axis::separating_axis::Workspace;
use crate::narrow_phase::dispatch::manifold::{along_tied_faces, is_upward, near_manifold_into};
use crate::narrow_phase::dispatch::separation::separation_with;
use crate::narrow_phase::feature::part_feature::globalized;
use crate::narrow_phase::parts::compound_surface::on_whole;
use crate::narrow_phase::parts::ridge_ends::{TouchingPair, crossings};
use crate::narrow_phase::terms::evaluate::evaluate;
use crate::shape::extent::turned;
use crate::{Contact, ContactFeature, ContactGeometry, Manifold, SeparatingAxis, Shape, Side};
use polhode_spatial::Pose;
use std::cmp::Ordering;

/// Places nearer than this many place tolerances are one: each of two features may stand off by some.
const SAME_PLACE: f64 = 8.0;

/// Normals that differ by less (length of the difference) are one: that of two flush faces of a decomposition.
const SAME_NORMAL: f64 = 1e-9;

/// A contact of one part of each body.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Candidate {
    /// With numbers within the parts.
    pub(crate) feature: ContactFeature,
    pub(crate) parts: [usize; 2],
    /// About A's origin.
    pub(crate) geometry: ContactGeometry,
    /// A vertex that has taken the place of one of the other body.
    pub(crate) replaced: bool,
}

/// Whether a shape is one of parts that are taken one by one.
pub(crate) const fn is_composite(shape: &Shape) -> bool {
    matches!(shape, Shape::Compound(_) | Shape::TriangleMesh(_))
}

/// The separation of a pair of which one is a compound; nothing for other pairs.
pub(crate) fn compound_separation(workspace: &mut Workspace, shapes: [&Shape; 2], poses: [&Pose; 2]) -> Option<f64> {
    let at = shapes.iter().position(|shape| matches!(shape, Shape::Compound(_)))?;
    let Shape::Compound(compound) = shapes[at] else { return None };
    let other = 1 - at;
    let bounds = shapes[other].bounds_at(&poses[at].relative(poses[other]));
    let unbounded = matches!(shapes[other], Shape::HalfSpace(_));
    let near = |of: &Bounds| if unbounded { f64::NEG_INFINITY } else { of.distance(&bounds) };
    let mut measure = |part: u32, _: f64| {
        let mut pair = shapes;
        pair[at] = &compound.parts[part as usize];
        separation_with(workspace, pair[0], poses[0], pair[1], poses[1])
    };
    Some(compound.tree.least(f64::INFINITY, 0.0, &near, &mut measure))
}

/// What is kept from call to call.
#[derive(Debug, Clone, Default)]
pub(crate) struct CompositeBuffers {
    pairs: Vec<[usize; 2]>,
    /// Of one pair of parts.
    of_parts: Manifold,
    candidates: Vec<Candidate>,
    kept: Vec<Candidate>,
    near: Vec<usize>,
}

/// All contacts of a pair of which one is a compound; its separation only when it is within reach.
pub(crate) fn compound_manifold(
    workspace: &mut Workspace,
    shapes: [&Shape; 2],
    poses: [&Pose; 2],
    reach: f64,
    found: &mut Manifold,
) {
    let mut buffers = std::mem::take(&mut workspace.composite);
    of_compound(workspace, &mut buffers, shapes, poses, reach, found);
    workspace.composite = buffers;
}

fn of_compound(
    workspace: &mut Workspace,
    CompositeBuffers { pairs, of_parts, candidates, kept, near: near_parts }: &mut CompositeBuffers,
    shapes: [&Shape; 2],
    poses: [&Pose; 2],
    reach: f64,
    found: &mut Manifold,
) {
    // About A's origin.
    let near_a = Pose { translation: glam::DVec3::ZERO, ..*poses[0] };
    let near_b = Pose { translation: poses[1].translation - poses[0].translation, ..*poses[1] };
    let near = [&near_a, &near_b];
    let tolerance = place_tolerance(least_part(shapes[0]), least_part(shapes[1]), near_b.translation);
    found.set_empty(f64::INFINITY, SeparatingAxis::None);
    candidates.clear();
    pairs.clear();
    pairs_within(shapes, near, reach.max(0.0) + SAME_PLACE * tolerance, pairs);
    let pair_of = |parts: [usize; 2]| [part_of(shapes[0], parts[0]), part_of(shapes[1], parts[1])];
    kept.clear();
    for &parts in pairs.iter() {
        let pair = pair_of(parts);
        near_manifold_into(workspace, pair[0], near[0], pair[1], near[1], reach, of_parts);
        if of_parts.separation < found.separation || of_parts.separation.is_nan() {
            found.separation = of_parts.separation;
            found.axis = axis_of_whole(of_parts.axis, shapes, parts);
        }
        let candidate = |c: &Contact| Candidate { feature: c.feature, parts, geometry: c.geometry, replaced: false };
        let mut keep = |contacts: &[Contact]| {
            let before = kept.len();
            let of_whole = |c: &Contact| of_whole(candidate(c), pair, shapes, near, tolerance, near_parts);
            kept.extend(contacts.iter().filter_map(of_whole));
            kept.len() - before == contacts.len()
        };
        candidates.extend(of_parts.contacts.iter().map(candidate));
        if !keep(&of_parts.contacts) {
            // Along an axis that separates the parts as well there may be contacts of the whole.
            along_tied_faces(workspace, (pair[0], near[0]), (pair[1], near[1]), reach, of_parts);
            keep(&of_parts.contacts);
        }
    }
    if found.separation.is_nan() || reach.is_nan() || found.separation > reach {
        return found.set_empty(found.separation, SeparatingAxis::None);
    }
    let touching = TouchingPair { shapes, poses: near, same_place: SAME_PLACE * tolerance };
    // Where a ridge bends, what the parts have by themselves is none of the whole: the ridges are crossed there.
    let at_border = |c: &&Candidate| touching.is_at_border(&c.geometry);
    workspace.ridges.places.extend(candidates.iter().filter(at_border).map(|c| c.geometry.point));
    crossings(&mut workspace.ridges, touching, &mut found.contacts);
    if kept.is_empty() && found.contacts.is_empty() && found.separation <= tolerance {
        // Bodies that touch have a contact, also where the parts hide it: they overlap more than a part is thick.
        kept.extend(candidates.iter().min_by(|p, q| p.geometry.separation.total_cmp(&q.geometry.separation)));
    }
    let named = |c: &Candidate| Contact { feature: globalized(c.feature, shapes, c.parts), geometry: c.geometry };
    found.contacts.extend(kept.iter().map(named));
    workspace.same_places.keep_one_each(&mut found.contacts, SAME_PLACE * tolerance);
    measure_again(&mut found.contacts, shapes, poses, reach.max(tolerance));
}

/// A contact of two parts as one of the whole bodies, or nothing when it is none.
fn of_whole(
    candidate: Candidate,
    pair: [&Shape; 2],
    shapes: [&Shape; 2],
    near: [&Pose; 2],
    tolerance: f64,
    near_parts: &mut Vec<usize>,
) -> Option<Candidate> {
    let kept = match shapes[0] {
        Shape::Compound(c) => on_whole(candidate, pair, (c, Side::A), near, tolerance, near_parts)?,
        _ => candidate,
    };
    match shapes[1] {
        Shape::Compound(c) => on_whole(kept, pair, (c, Side::B), near, tolerance, near_parts),
        _ => Some(kept),
    }
}

/// Gives contacts the geometry that [`evaluate`] gives them at these poses, and leaves out those that it says to be farther
/// than `most` (m): in the frame of a part they were nearer by rounding.
pub(crate) fn measure_again(contacts: &mut Vec<Contact>, shapes: [&Shape; 2], poses: [&Pose; 2], most: f64) {
    contacts.retain_mut(|contact| {
        let geometry = evaluate(contact.feature, shapes[0], poses[0], shapes[1], poses[1]);
        contact.geometry = geometry.unwrap_or(contact.geometry);
        geometry.is_some_and(|geometry| geometry.separation <= most)
    });
}

/// An axis with the numbers of the whole bodies.
fn axis_of_whole(axis: SeparatingAxis, shapes: [&Shape; 2], parts: [usize; 2]) -> SeparatingAxis {
    let first = |at: usize| match shapes[at] {
        Shape::Compound(c) => c.first.get(parts[at]).copied().unwrap_or_default(),
        _ => crate::shape::FirstElements::default(),
    };
    match axis {
        SeparatingAxis::FaceA(face) => SeparatingAxis::FaceA(first(0).face + face),
        SeparatingAxis::FaceB(face) => SeparatingAxis::FaceB(first(1).face + face),
        SeparatingAxis::Edges(a, b) => SeparatingAxis::Edges(first(0).edge + a, first(1).edge + b),
        SeparatingAxis::Nearest | SeparatingAxis::None => axis,
    }
}

/// The size of a body's smallest part: it says how finely features must be told apart.
fn least_part(shape: &Shape) -> f64 {
    match shape {
        Shape::Compound(c) => c.parts.iter().map(Shape::size).filter(|s| *s > 0.0).fold(f64::INFINITY, f64::min),
        other => other.size(),
    }
}

fn part_of(shape: &Shape, part: usize) -> &Shape {
    match shape {
        Shape::Compound(c) => c.parts.get(part).unwrap_or(shape),
        other => other,
    }
}

/// The pairs of parts whose boxes come within `reach` (m) of each other, sorted.
pub(crate) fn pairs_within(shapes: [&Shape; 2], poses: [&Pose; 2], reach: f64, pairs: &mut Vec<[usize; 2]>) {
    let x_ba = poses[1].relative(poses[0]);
    let whole = shapes[1].bounds_at(&Pose::IDENTITY).inflated(reach);
    let mut add = |i: usize, part: &Shape| {
        // A half-space has no box: it may meet anything.
        let unbounded = matches!(part, Shape::HalfSpace(_)) || matches!(shapes[1], Shape::HalfSpace(_));
        let bounds = if unbounded { Bounds::ALL } else { part.bounds_at(&x_ba).inflated(reach) };
        match shapes[1] {
            Shape::Compound(b) => b.tree.overlaps(&bounds, &mut |j| pairs.push([i, j as usize])),
            _ if unbounded || bounds.overlaps(&whole) => pairs.push([i, 0]),
            _ => {}
        }
    };
    let everywhere = matches!(shapes[1], Shape::HalfSpace(_));
    match shapes[0] {
        Shape::Compound(a) => {
            // The box of a part here takes all of its vertices: those of parts out of the other's way are not made.
            let near = |of: &Bounds| everywhere || turned(*of, &x_ba).inflated(reach).overlaps(&whole);
            a.tree.passing(&near, &mut |i| add(i as usize, part_of(shapes[0], i as usize)));
        }
        other => add(0, other),
    }
    pairs.sort_unstable();
}

/// Buffers of [`SamePlaces::keep_one_each`].
#[derive(Debug, Clone, Default)]
pub(crate) struct SamePlaces {
    order: Vec<usize>,
    dropped: Vec<bool>,
}

impl SamePlaces {
    /// Keeps one contact for each place and normal, in the order of features.
    pub(crate) fn keep_one_each(&mut self, contacts: &mut Vec<Contact>, tolerance: f64) {
        let Self { order, dropped } = self;
        contacts.sort_unstable_by_key(|contact| contact.feature);
        contacts.dedup_by_key(|contact| contact.feature);
        order.clear();
        order.extend(0..contacts.len());
        order.sort_unstable_by(|&i, &j| {
            contacts[i].geometry.point.x.total_cmp(&contacts[j].geometry.point.x).then(i.cmp(&j))
        });
        dropped.clear();
        dropped.resize(contacts.len(), false);
        for (k, &i) in order.iter().enumerate() {
            let first = contacts[i];
            for &j in &order[k + 1..] {
                let second = contacts[j];
                if second.geometry.point.x - first.geometry.point.x > tolerance {
                    break;
                }
                let alike = (first.geometry.normal - second.geometry.normal).length() <= SAME_NORMAL;
                if alike
                    && !dropped[i]
                    && !dropped[j]
                    && first.geometry.point.distance(second.geometry.point) <= tolerance
                {
                    dropped[if goes_before(&first, &second) { j } else { i }] = true;
                }
            }
        }
        let mut index = 0;
        contacts.retain(|_| {
            index += 1;
            !dropped[index - 1]
        });
    }
}

/// Whether the first of two contacts in one place stays.
fn goes_before(first: &Contact, second: &Contact) -> bool {
    let upper = |contact: &Contact| if is_upward(contact.geometry.normal) { Side::A } else { Side::B };
    let rank = |contact: &Contact| match contact.feature {
        ContactFeature::VertexFace { vertex_of, vertex, face } => (3, face, vertex, vertex_of == upper(contact)),
        ContactFeature::Smooth { center_of, center, against } => {
            let (kind, number) = match against {
                crate::SurfaceFeature::Face(face) => (2, face),
                crate::SurfaceFeature::Edge(edge) => (1, edge),
                crate::SurfaceFeature::Vertex(vertex) => (0, vertex),
                _ => (0, 0),
            };
            (kind, number, center, center_of == upper(contact))
        }
        ContactFeature::EdgeEdge { edge_a, edge_b }
        | ContactFeature::Spheres { center_a: edge_a, center_b: edge_b } => {
            let turned = upper(contact) == Side::A;
            (0, edge_a.max(edge_b), edge_a.min(edge_b), (edge_a > edge_b) == turned)
        }
        ContactFeature::SphereSphere => (0, 0, 0, true),
        ContactFeature::Elements { a, b } => {
            let (a, b) = (a.number(), b.number());
            (0, a.max(b), a.min(b), (a > b) == (upper(contact) == Side::A))
        }
    };
    rank(first).cmp(&rank(second)) != Ordering::Less
}
