//! Signed separation of two shapes.

use crate::Shape;
use crate::narrow_phase::dispatch::workspace::Workspace;
use crate::narrow_phase::parts::compound_pair::separation_of_parts;
use polhode_spatial::Pose;

/// Signed separation of two shapes, m: negative the depth of penetration; positive a lower bound of their distance that
/// is zero exactly when they touch, and the distance itself when a face or a smooth shape decides. Infinite when the
/// pair never touches, NaN when a pose is not finite.
///
/// Of a torus whose middle line enters the other body, and of compounds, a negative value is that of the deepest place or
/// pair of parts: a lower bound of the way out. Two clouds never touch, nor do two of half-space and mesh.
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
