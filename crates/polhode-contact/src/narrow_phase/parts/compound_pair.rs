//! Contacts of compounds: the contacts of all pairs of parts, combined.
//!
//! The separation is the smallest separation over the pairs of parts. Bounding boxes exclude pairs that cannot be
//! nearest.
//!
//! A manifold is computed in these steps:
//!
//! 1. compute the contacts of every pair of parts within reach;
//! 2. remove contacts that the whole body does not have (`compound_surface.rs`);
//! 3. add the contacts at re-entrant edges (`tied_faces.rs`) and at bent ridges (`ridge_ends.rs`), which single pairs
//!    of parts do not show;
//! 4. keep one contact for each place and normal (`same_places.rs`).
//!
//! All steps use coordinates relative to A's origin, so that a pair far from the world's origin loses no accuracy. The
//! geometry of the final contacts is that of [`crate::evaluate()`] at the given poses.

use crate::bounding::aabb::Aabb;
use crate::bounding::floor::Floor;
use crate::clearance::place_tolerance;
use crate::narrow_phase::feature::part_feature::globalized;
use crate::narrow_phase::feature::placed::Placed;
use crate::narrow_phase::pair::measure::measure_again;
use crate::narrow_phase::pair::pair_manifold::pair_manifold;
use crate::narrow_phase::pair::pair_separation::pair_separation;
use crate::narrow_phase::pair::polyhedra::along_tied_faces;
use crate::narrow_phase::parts::compound_surface::{Candidate, on_whole};
use crate::narrow_phase::parts::mesh_pair::{MeshBuffers, mesh_manifold, mesh_separation};
use crate::narrow_phase::parts::ridge_ends::{RidgeBuffers, TouchingPair, crossings};
use crate::narrow_phase::parts::same_places::{SAME_PLACE_OF_PARTS, SamePlaces};
use crate::shape::extent::turned;
use crate::{Contact, Manifold, SeparatingAxis, Shape, Side};
use polhode_spatial::Pose;

/// Whether a shape consists of parts that are processed one by one.
pub(crate) const fn is_composite(shape: &Shape) -> bool {
    matches!(shape, Shape::Compound(_) | Shape::TriangleMesh(_))
}

/// Buffers that are reused from call to call.
#[derive(Debug, Clone, Default)]
pub(crate) struct CompoundBuffers {
    /// For pairs of parts.
    pub(crate) mesh: MeshBuffers,
    pairs: Vec<[usize; 2]>,
    /// Contacts of one pair of parts.
    of_parts: Manifold,
    candidates: Vec<Candidate>,
    kept: Vec<Candidate>,
    near: Vec<usize>,
    ridges: RidgeBuffers,
    same_places: SamePlaces,
}

/// The separation of any pair, part by part, m; see [`crate::separation()`].
pub(crate) fn separation_of_parts(buffers: &mut MeshBuffers, shapes: [&Shape; 2], poses: [&Pose; 2]) -> f64 {
    let compound = shapes.iter().enumerate().find_map(|(at, shape)| match shape {
        Shape::Compound(compound) => Some((at, compound)),
        _ => None,
    });
    let Some((at, compound)) = compound else {
        return mesh_separation(buffers, shapes, poses).unwrap_or_else(|| {
            pair_separation(
                &mut buffers.pair.search,
                Placed::new(shapes[0], poses[0]),
                Placed::new(shapes[1], poses[1]),
            )
        });
    };
    let other = 1 - at;
    let seen = poses[at].relative(poses[other]);
    let bounds = shapes[other].bounds_at(&seen);
    let floor = Floor::of(shapes[other], &seen);
    let near = |of: &Aabb| floor.map_or_else(|| of.distance(&bounds), |floor| floor.height(of));
    let mut measure = |part: u32, _: f64| {
        let mut pair = shapes;
        pair[at] = &compound.parts[part as usize];
        separation_of_parts(buffers, pair, poses)
    };
    compound.tree.least(f64::INFINITY, 0.0, &near, &mut measure)
}

/// All contacts of any pair, part by part. The separation of compounds and meshes is computed only when it is within
/// reach.
pub(crate) fn manifold_of_parts(
    buffers: &mut CompoundBuffers,
    shapes: [&Shape; 2],
    poses: [&Pose; 2],
    reach: f64,
    found: &mut Manifold,
) {
    if shapes.iter().any(|shape| matches!(shape, Shape::Compound(_))) {
        of_compound(buffers, shapes, poses, reach, found);
    } else {
        without_compounds(&mut buffers.mesh, shapes, poses, reach, found);
    }
}

/// The contacts of a pair without compounds.
fn without_compounds(
    buffers: &mut MeshBuffers,
    shapes: [&Shape; 2],
    poses: [&Pose; 2],
    reach: f64,
    found: &mut Manifold,
) {
    if shapes.iter().any(|shape| matches!(shape, Shape::TriangleMesh(_))) {
        mesh_manifold(buffers, shapes, poses, reach, found);
    } else {
        let (a, b) = (Placed::new(shapes[0], poses[0]), Placed::new(shapes[1], poses[1]));
        pair_manifold(&mut buffers.pair, a, b, reach, found);
    }
}

fn of_compound(
    buffers: &mut CompoundBuffers,
    shapes: [&Shape; 2],
    poses: [&Pose; 2],
    reach: f64,
    found: &mut Manifold,
) {
    let CompoundBuffers { mesh, pairs, of_parts, candidates, kept, near: near_parts, ridges, same_places } = buffers;
    // The poses relative to A's origin.
    let near_a = Pose { translation: glam::DVec3::ZERO, ..*poses[0] };
    let near_b = Pose { translation: poses[1].translation - poses[0].translation, ..*poses[1] };
    let near = [&near_a, &near_b];
    let tolerance = place_tolerance(least_part_size(shapes[0]), least_part_size(shapes[1]), near_b.translation);
    found.set_empty(f64::INFINITY, SeparatingAxis::None);
    candidates.clear();
    pairs.clear();
    pairs_within(shapes, near, reach.max(0.0) + SAME_PLACE_OF_PARTS * tolerance, pairs);
    let pair_of = |parts: [usize; 2]| [part_of(shapes[0], parts[0]), part_of(shapes[1], parts[1])];
    kept.clear();
    for &parts in pairs.iter() {
        let pair = pair_of(parts);
        without_compounds(mesh, pair, near, reach, of_parts);
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
            // Another axis that separates the parts equally well may give contacts of the whole body.
            along_tied_faces(&mut mesh.pair, [0, 1].map(|k| Placed::new(pair[k], near[k])), reach, of_parts);
            keep(&of_parts.contacts);
        }
    }
    if found.is_beyond(reach) {
        return found.set_empty(found.separation, SeparatingAxis::None);
    }
    let touching = TouchingPair { shapes, poses: near, same_place: SAME_PLACE_OF_PARTS * tolerance };
    // Where a ridge bends, the contacts of single parts are not contacts of the whole body: cross the ridges there
    // instead.
    let at_border = |c: &&Candidate| touching.is_at_border(&c.geometry);
    ridges.places.extend(candidates.iter().filter(at_border).map(|c| c.geometry.point));
    crossings(ridges, touching, &mut found.contacts);
    if kept.is_empty() && found.contacts.is_empty() && found.separation <= tolerance {
        // Bodies that touch must have a contact. None may be left when the penetration exceeds the thickness of a part.
        kept.extend(candidates.iter().min_by(|p, q| p.geometry.separation.total_cmp(&q.geometry.separation)));
    }
    let named = |c: &Candidate| Contact { feature: globalized(c.feature, shapes, c.parts), geometry: c.geometry };
    found.contacts.extend(kept.iter().map(named));
    same_places.keep_one_each(&mut found.contacts, SAME_PLACE_OF_PARTS * tolerance);
    measure_again(&mut found.contacts, shapes, poses, reach.max(tolerance));
}

/// The contact of two parts as a contact of the whole bodies; `None` when the whole bodies do not have it.
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

/// An axis, with the feature numbers of the whole bodies.
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

/// The size of a body's smallest part. It decides how far apart two distinct features must be.
fn least_part_size(shape: &Shape) -> f64 {
    match shape {
        Shape::Compound(c) => c.least_part_size,
        other => other.size(),
    }
}

fn part_of(shape: &Shape, part: usize) -> &Shape {
    shape.parts().get(part).unwrap_or(shape)
}

/// The pairs of parts whose boxes come within `reach` (m) of each other, sorted.
fn pairs_within(shapes: [&Shape; 2], poses: [&Pose; 2], reach: f64, pairs: &mut Vec<[usize; 2]>) {
    for (at, other) in [(0, 1), (1, 0)] {
        if let (Shape::Compound(compound), Some(floor)) =
            (shapes[at], Floor::of(shapes[other], &poses[at].relative(poses[other])))
        {
            let near = |of: &Aabb| floor.height(of) <= reach;
            compound.tree.passing(&near, &mut |part| {
                let part = part as usize;
                pairs.push(if at == 0 { [part, 0] } else { [0, part] });
            });
            return pairs.sort_unstable();
        }
    }
    let x_ba = poses[1].relative(poses[0]);
    let whole = shapes[1].bounds_at(&Pose::IDENTITY).widened(reach);
    let mut add = |i: usize, part: &Shape| {
        // A half-space is unbounded: its box overlaps every other box.
        let unbounded = part.is_half_space() || shapes[1].is_half_space();
        let bounds = if unbounded { Aabb::UNBOUNDED } else { part.bounds_at(&x_ba).widened(reach) };
        match shapes[1] {
            Shape::Compound(b) => b.tree.overlaps(&bounds, &mut |j| pairs.push([i, j as usize])),
            _ if unbounded || bounds.overlaps(&whole) => pairs.push([i, 0]),
            _ => {}
        }
    };
    match shapes[0] {
        Shape::Compound(a) => {
            // An exact box needs all vertices of a part: the tree first excludes parts that are too far away.
            let near = |of: &Aabb| turned(*of, &x_ba).widened(reach).overlaps(&whole);
            a.tree.passing(&near, &mut |i| add(i as usize, part_of(shapes[0], i as usize)));
        }
        other => add(0, other),
    }
    pairs.sort_unstable();
}
