//! Compounds: what their parts give, put together.
//!
//! The separation is the least over the pairs of parts that can be nearest by their boxes. A manifold takes the contacts
//! of every pair of parts within reach, leaves out those that are none of the whole body (`compound_surface.rs`), adds
//! what re-entrant edges (`tied_faces.rs`) and bent ridges (`ridge_ends.rs`) hold instead, and keeps one for each place
//! and normal (`same_places.rs`). All of it is computed about A's origin, so that a pair far away loses nothing; the geometry
//! of the contacts that stay is that of [`crate::evaluate()`] at the poses given.

use crate::bounding::Bounds;
use crate::clearance::place_tolerance;
use crate::narrow_phase::feature::part_feature::globalized;
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

/// Whether a shape is one of parts that are taken one by one.
pub(crate) const fn is_composite(shape: &Shape) -> bool {
    matches!(shape, Shape::Compound(_) | Shape::TriangleMesh(_))
}

/// What is kept from call to call.
#[derive(Debug, Clone, Default)]
pub(crate) struct CompoundBuffers {
    /// Of the pairs of parts.
    pub(crate) mesh: MeshBuffers,
    pairs: Vec<[usize; 2]>,
    /// Of one pair of parts.
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
        return mesh_separation(buffers, shapes, poses)
            .unwrap_or_else(|| pair_separation(&mut buffers.pair.search, shapes[0], poses[0], shapes[1], poses[1]));
    };
    let other = 1 - at;
    let bounds = shapes[other].bounds_at(&poses[at].relative(poses[other]));
    let unbounded = shapes[other].is_half_space();
    let near = |of: &Bounds| if unbounded { f64::NEG_INFINITY } else { of.distance(&bounds) };
    let mut measure = |part: u32, _: f64| {
        let mut pair = shapes;
        pair[at] = &compound.parts[part as usize];
        separation_of_parts(buffers, pair, poses)
    };
    compound.tree.least(f64::INFINITY, 0.0, &near, &mut measure)
}

/// All contacts of any pair, part by part; of compounds and meshes the separation only when it is within reach.
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

/// The contacts of a pair of which neither is a compound.
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
        pair_manifold(&mut buffers.pair, shapes[0], poses[0], shapes[1], poses[1], reach, found);
    }
}

fn of_compound(
    CompoundBuffers { mesh, pairs, of_parts, candidates, kept, near: near_parts, ridges, same_places }: &mut CompoundBuffers,
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
            // Along an axis that separates the parts as well there may be contacts of the whole.
            along_tied_faces(&mut mesh.pair, (pair[0], near[0]), (pair[1], near[1]), reach, of_parts);
            keep(&of_parts.contacts);
        }
    }
    if found.separation.is_nan() || reach.is_nan() || found.separation > reach {
        return found.set_empty(found.separation, SeparatingAxis::None);
    }
    let touching = TouchingPair { shapes, poses: near, same_place: SAME_PLACE_OF_PARTS * tolerance };
    // Where a ridge bends, what the parts have by themselves is none of the whole: the ridges are crossed there.
    let at_border = |c: &&Candidate| touching.is_at_border(&c.geometry);
    ridges.places.extend(candidates.iter().filter(at_border).map(|c| c.geometry.point));
    crossings(ridges, touching, &mut found.contacts);
    if kept.is_empty() && found.contacts.is_empty() && found.separation <= tolerance {
        // Bodies that touch have a contact, also where the parts hide it: they overlap more than a part is thick.
        kept.extend(candidates.iter().min_by(|p, q| p.geometry.separation.total_cmp(&q.geometry.separation)));
    }
    let named = |c: &Candidate| Contact { feature: globalized(c.feature, shapes, c.parts), geometry: c.geometry };
    found.contacts.extend(kept.iter().map(named));
    same_places.keep_one_each(&mut found.contacts, SAME_PLACE_OF_PARTS * tolerance);
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
    shape.parts().get(part).unwrap_or(shape)
}

/// The pairs of parts whose boxes come within `reach` (m) of each other, sorted.
fn pairs_within(shapes: [&Shape; 2], poses: [&Pose; 2], reach: f64, pairs: &mut Vec<[usize; 2]>) {
    let x_ba = poses[1].relative(poses[0]);
    let whole = shapes[1].bounds_at(&Pose::IDENTITY).inflated(reach);
    let mut add = |i: usize, part: &Shape| {
        // A half-space has no box: it may meet anything.
        let unbounded = part.is_half_space() || shapes[1].is_half_space();
        let bounds = if unbounded { Bounds::ALL } else { part.bounds_at(&x_ba).inflated(reach) };
        match shapes[1] {
            Shape::Compound(b) => b.tree.overlaps(&bounds, &mut |j| pairs.push([i, j as usize])),
            _ if unbounded || bounds.overlaps(&whole) => pairs.push([i, 0]),
            _ => {}
        }
    };
    let everywhere = shapes[1].is_half_space();
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
