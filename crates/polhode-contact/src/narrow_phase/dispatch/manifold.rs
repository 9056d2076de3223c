//! All contacts of a pair of shapes at given poses.
//!
//! Two polyhedra: when a face normal is the best separating axis ([`crate::separation()`]), the contacts are those of
//! this face and the most nearly antiparallel face of the other body, evaluated by [`crate::evaluate()`]. When a pair
//! of edges separates best, their crossing is the only contact, unless a face beside one of the edges is almost
//! parallel to the other edge: then the contacts are those of the faces beside the edges, so that the contacts of a
//! body that tips over an edge change continuously (`polyhedra.rs`).
//!
//! Capsules, cylinders, cones and tori: `round_region.rs`. Compounds: `compound_pair.rs`. Triangle meshes:
//! `mesh_pair.rs`. Other pairs: every vertex or point whose separation is within the reach; the feature nearest to a
//! sphere (`pair_manifold.rs`).

use crate::narrow_phase::dispatch::separation::separation_with;
use crate::narrow_phase::dispatch::workspace::Workspace;
use crate::narrow_phase::parts::compound_pair::{is_composite, manifold_of_parts};
use crate::{Manifold, SeparatingAxis, Shape};
use polhode_spatial::Pose;

/// All contacts of two shapes whose separation is at most `reach` (m).
pub fn manifold(shape_a: &Shape, pose_a: &Pose, shape_b: &Shape, pose_b: &Pose, reach: f64) -> Manifold {
    let mut found = Manifold::default();
    manifold_into(&mut Workspace::default(), shape_a, pose_a, shape_b, pose_b, reach, &mut found);
    found
}

/// As [`manifold`], with buffers and a result that the caller keeps: nothing is allocated once they are large enough.
/// The previous content of the result is replaced.
pub fn manifold_into(
    workspace: &mut Workspace,
    shape_a: &Shape,
    pose_a: &Pose,
    shape_b: &Shape,
    pose_b: &Pose,
    reach: f64,
    found: &mut Manifold,
) {
    near_manifold_into(workspace, shape_a, pose_a, shape_b, pose_b, reach, found);
    let composite = is_composite(shape_a) || is_composite(shape_b);
    if !composite || found.separation <= reach || !(pose_a.is_finite() && pose_b.is_finite()) {
        return;
    }
    let separation = separation_with(workspace, shape_a, pose_a, shape_b, pose_b);
    let axis = if separation == f64::INFINITY { SeparatingAxis::None } else { SeparatingAxis::Nearest };
    found.set_empty(separation, axis);
}

/// As [`manifold`], for callers who need only contacts within reach. For a compound or mesh beyond the reach, the
/// separation is some value above the reach (perhaps infinite) and the axis is `None`. This saves the separation of all
/// parts, which is most of the work for a pair that is near but apart.
pub fn near_manifold(shape_a: &Shape, pose_a: &Pose, shape_b: &Shape, pose_b: &Pose, reach: f64) -> Manifold {
    let mut found = Manifold::default();
    near_manifold_into(&mut Workspace::default(), shape_a, pose_a, shape_b, pose_b, reach, &mut found);
    found
}

/// As [`near_manifold`], with buffers and a result that the caller keeps.
pub(crate) fn near_manifold_into(
    workspace: &mut Workspace,
    shape_a: &Shape,
    pose_a: &Pose,
    shape_b: &Shape,
    pose_b: &Pose,
    reach: f64,
    found: &mut Manifold,
) {
    if !(pose_a.is_finite() && pose_b.is_finite()) {
        return found.set_empty(f64::NAN, SeparatingAxis::None);
    }
    let (shapes, poses) = ([shape_a, shape_b], [pose_a, pose_b]);
    manifold_of_parts(&mut workspace.parts, shapes, poses, reach, found);
}
