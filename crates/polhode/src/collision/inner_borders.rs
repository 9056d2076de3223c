//! Points of patches at a border of a fixed body that other fixed bodies continue: flush surfaces are one surface.
//!
//! What slides over flush tiles comes to the side of the next one, and nothing tells a pair of bodies that the tile
//! before covers this side. A point of a patch is left out if it is at another fixed body on which the other body lies,
//! and if no surface of its own fixed body around it is free: each of the places that
//! `covered_borders` probes in the plane of the patch is either not on the own fixed body, or within another one. What
//! covers the point so reaches farther towards the other body than the point does, so that the patch with it holds that
//! body.
//!
//! A body that lies softly has sunk into what bears it, and meets the side of the next one deeper than that. So the
//! places are lifted by the deepest overlap with the other fixed bodies, along its normal and in the plane of the
//! patch: the foot of a wall that stands on the floor stays a wall.
//! Failure: a step that is lower than that overlap is no step.

use super::covered_borders::places_around;
use super::face_patches::{PairPatches, Patch, PatchPoint};
use crate::collision::covered_borders;
use crate::model::{Model, prescribed, tolerances};
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;

/// A pair of a fixed body with one that lies on it, by its place.
#[derive(Debug, Clone, Copy)]
struct Lying {
    place: usize,
    body: usize,
    on: usize,
}

/// Leaves out the points of patches at borders that other fixed bodies continue.
pub(crate) fn leave_out_inner_borders(model: &Model, states: &[BodyState], pairs: &mut [PairPatches]) {
    let is_fixed = |body: usize| !model.bodies[body].moves() && prescribed::trajectory(model, body).is_none();
    let lying =
        pairs.iter().enumerate().filter(|(_, pair)| !pair.patches.is_empty()).filter_map(|(place, pair)| {
            match [pair.a, pair.b].map(is_fixed) {
                [true, false] => Some(Lying { place, body: pair.b, on: pair.a }),
                [false, true] => Some(Lying { place, body: pair.a, on: pair.b }),
                _ => None,
            }
        });
    // Most bodies lie on one fixed body at most.
    let mut last = vec![usize::MAX; states.len()];
    let mut all = Vec::new();
    let mut are_several = false;
    for own in lying {
        are_several |= last[own.body] != usize::MAX;
        last[own.body] = own.place;
        all.push(own);
    }
    if !are_several {
        return;
    }
    all.sort_unstable_by_key(|own| (own.body, own.place));
    for of_body in all.chunk_by(|x, y| x.body == y.body).filter(|of_body| of_body.len() > 1) {
        let kept: Vec<Vec<Vec<bool>>> = of_body.iter().map(|own| kept(model, states, (pairs, of_body), own)).collect();
        for (own, kept) in of_body.iter().zip(kept) {
            let pair = &mut pairs[own.place];
            for (patch, kept) in pair.patches.iter_mut().zip(kept) {
                patch.retain(|place| kept[place]);
            }
            pair.patches.retain(|patch| !patch.points().is_empty());
        }
    }
}

/// Which points of the patches of a pair stay.
fn kept(
    model: &Model,
    states: &[BodyState],
    (pairs, of_body): (&[PairPatches], &[Lying]),
    own: &Lying,
) -> Vec<Vec<bool>> {
    let others: Vec<&Lying> = of_body.iter().filter(|other| other.place != own.place).collect();
    let lift = lift(states, others.iter().map(|other| (&pairs[other.place], other.body)));
    let pair = &pairs[own.place];
    let allowed = tolerances::touch_distance(model, states, pair.a, pair.b);
    let size = tolerances::pair_size(model, pair.a, pair.b);
    let is_covered =
        |place: DVec3| others.iter().any(|other| covered_borders::reaches(model, states, other.on, place, allowed));
    let is_kept = |patch: &Patch, point: &PatchPoint| {
        let normal = pair.normal(states, patch);
        let place = states[own.on].pose.transform_point(if own.on == pair.a { point.on_a } else { point.on_b });
        let lifted = place + (lift - normal * normal.dot(lift));
        let is_free =
            |place: DVec3| covered_borders::reaches(model, states, own.on, place, allowed) && !is_covered(place);
        !is_covered(place) || places_around(lifted, normal, size).any(is_free)
    };
    pair.patches.iter().map(|patch| patch.points().iter().map(|point| is_kept(patch, point)).collect()).collect()
}

/// From the deepest point of a body in those on which it lies to their surface, m.
fn lift<'a>(states: &[BodyState], others: impl Iterator<Item = (&'a PairPatches, usize)>) -> DVec3 {
    let (mut deepest, mut lift) = (0.0, DVec3::ZERO);
    for (pair, body) in others {
        for (patch, point) in pair.patches.iter().flat_map(|patch| patch.points().iter().map(move |p| (patch, p))) {
            let geometry = pair.geometry(states, patch, point);
            if geometry.separation < deepest {
                deepest = geometry.separation;
                let out = if body == pair.a { geometry.normal } else { -geometry.normal };
                lift = out * -deepest;
            }
        }
    }
    lift
}
