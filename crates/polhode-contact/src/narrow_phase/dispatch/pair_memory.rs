//! The contacts of a pair, found faster with a memory of the last query.
//!
//! The memory holds which features need not be searched at a nearby pose (`coherence.rs`). The contacts with and
//! without it are the same, bit for bit. Once the buffers are large enough, a query allocates nothing.

use crate::narrow_phase::dispatch::coherence::Coherence;
use crate::narrow_phase::dispatch::manifold::near_manifold_into;
use crate::narrow_phase::dispatch::workspace::Workspace;
use crate::narrow_phase::feature::placed::Placed;
use crate::narrow_phase::pair::polyhedra::along_axes;
use crate::{Manifold, SeparatingAxis, Shape};
use polhode_spatial::Pose;

/// The memory of one pair from one query to the next. Start a new one ([`Default`]) when either shape is replaced by
/// another.
///
/// ```
/// use polhode_contact::{DVec3, Manifold, PairMemory, Pose, Shape, Workspace, near_manifold_with};
/// let (slab, brick) = (Shape::cuboid(DVec3::new(4.0, 4.0, 1.0))?, Shape::cuboid(DVec3::ONE)?);
/// let (mut workspace, mut memory, mut found) = (Workspace::default(), PairMemory::default(), Manifold::default());
/// let mut pose = Pose::from_translation(DVec3::Z);
/// for _ in 0..10 {
///     pose.translation.x += 1e-3;
///     near_manifold_with(&mut workspace, &mut memory, (&brick, &pose), (&slab, &Pose::IDENTITY), 1e-6, &mut found);
///     assert_eq!(found.contacts.len(), 4);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct PairMemory {
    coherence: Coherence,
}

/// As [`near_manifold`](crate::near_manifold), with buffers and a memory of the pair that the caller keeps. Within the
/// reach the result is the same, bit for bit; beyond it the separation of polyhedra is a lower bound that exceeds the
/// reach.
pub fn near_manifold_with(
    workspace: &mut Workspace,
    PairMemory { coherence }: &mut PairMemory,
    (shape_a, pose_a): (&Shape, &Pose),
    (shape_b, pose_b): (&Shape, &Pose),
    reach: f64,
    found: &mut Manifold,
) {
    let (Shape::Convex(polyhedron_a), Shape::Convex(polyhedron_b)) = (shape_a, shape_b) else {
        return near_manifold_into(workspace, shape_a, pose_a, shape_b, pose_b, reach, found);
    };
    if !(pose_a.is_finite() && pose_b.is_finite()) {
        coherence.forget();
        return found.set_empty(f64::NAN, SeparatingAxis::None);
    }
    let x_ab = pose_a.relative(pose_b);
    if let Some(separation) = coherence.apart(polyhedron_a, polyhedron_b, &x_ab, reach) {
        return found.set_empty(separation, SeparatingAxis::None);
    }
    let buffers = workspace.pair();
    let axes = coherence.search(&mut buffers.search, polyhedron_a, polyhedron_b, &x_ab, reach);
    let placed = [Placed::new(shape_a, pose_a), Placed::new(shape_b, pose_b)];
    along_axes(buffers, [polyhedron_a, polyhedron_b], placed, (&axes, Some(&mut coherence.region)), reach, found);
}
