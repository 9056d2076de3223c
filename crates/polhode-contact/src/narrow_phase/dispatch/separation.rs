//! Signed separation of two shapes.

use crate::Shape;
use crate::narrow_phase::dispatch::workspace::Workspace;
use crate::narrow_phase::parts::compound_pair::separation_of_parts;
use polhode_spatial::Pose;

/// Signed separation of two shapes, m. Overlapping: minus the depth of penetration. Apart: a lower bound of their
/// distance that is zero exactly when they touch, and the distance itself when the best axis is a face normal or
/// belongs to a smooth shape. Infinite when the pair never touches, NaN when a pose is not finite.
///
/// For a torus whose centre circle enters the other body, and for compounds, a negative value is that of the deepest
/// point or pair of parts: the depth of the whole may be larger. Two clouds never touch; nor do two half-spaces, two
/// meshes, or a half-space and a mesh.
pub fn separation(shape_a: &Shape, pose_a: &Pose, shape_b: &Shape, pose_b: &Pose) -> f64 {
    separation_with(&mut Workspace::default(), shape_a, pose_a, shape_b, pose_b)
}

/// As [`separation`], with buffers that the caller keeps.
pub fn separation_with(
    workspace: &mut Workspace,
    shape_a: &Shape,
    pose_a: &Pose,
    shape_b: &Shape,
    pose_b: &Pose,
) -> f64 {
    if !(pose_a.is_finite() && pose_b.is_finite()) {
        return f64::NAN;
    }
    separation_of_parts(&mut workspace.parts.mesh, [shape_a, shape_b], [pose_a, pose_b])
}
