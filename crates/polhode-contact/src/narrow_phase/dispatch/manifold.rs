//! All contacts of a pair of shapes at given poses.
//!
//! Two polyhedra: the best separating axis ([`crate::separation()`]) names a face of one body, and the face of the other
//! that lies most nearly against it; [`crate::evaluate()`] measures every contact of the two faces. When a pair of edges
//! separates best, that crossing is the only contact, unless a face beside one of the edges is almost parallel to the
//! other edge: then all contacts of the faces beside are given, so that a body that tips over an edge changes its
//! contacts continuously (`polyhedra.rs`).
//!
//! Capsules, cylinders, cones and tori: `round_region.rs`. Compounds: `compound_pair.rs`. Triangle meshes: `mesh_pair.rs`.
//! Other pairs: every vertex or point below the reach; the nearest features of a sphere (`pair_manifold.rs`).

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

/// As [`manifold`], with buffers and a result that the caller keeps: nothing is allocated once they are large enough. What
/// stood in the result before is forgotten.
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

/// As [`manifold`] for those who ask for no more than what is within reach: beyond it the separation of a compound or a
/// mesh is some value above the reach, infinite perhaps, and the axis none. The separation of all parts is most of the work
/// of a pair that is near but apart.
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
