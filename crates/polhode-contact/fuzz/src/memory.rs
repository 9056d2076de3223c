//! The narrow phase with a memory of the pair gives the same result as without, bit for bit, along any motion of two
//! polyhedra.

use crate::screw::Screw;
use polhode_contact::{Manifold, PairMemory, Shape, Workspace, manifold, near_manifold_with};
use polhode_spatial::Motion;

/// Times at which a pair is queried, s: to and fro, in steps from rounding to larger than the bodies.
const TIMES: [f64; 14] = [0.0, 0.0, 1e-15, 3e-13, 1e-12, 1e-9, 1e-6, 1e-5, 1e-4, 3e-4, 2e-3, 1e-2, 0.0, 0.5];

/// Updates the pair at each time and compares.
///
/// # Panics
/// When outdated memory was used.
pub(crate) fn check_memory(shapes: &[Shape; 2], motions: &[Screw; 2], reach: f64) {
    if !shapes.iter().all(|shape| matches!(shape, Shape::Convex(_))) {
        return;
    }
    let (mut workspace, mut memory, mut kept) = (Workspace::default(), PairMemory::default(), Manifold::default());
    for t in TIMES {
        let poses = [motions[0].pose(t), motions[1].pose(t)];
        let (a, b) = ((&shapes[0], &poses[0]), (&shapes[1], &poses[1]));
        near_manifold_with(&mut workspace, &mut memory, a, b, reach, &mut kept);
        let fresh = manifold(&shapes[0], &poses[0], &shapes[1], &poses[1], reach);
        assert_eq!(kept.contacts, fresh.contacts, "at {t}");
        if fresh.separation <= reach {
            let decided = |of: &Manifold| (of.separation.to_bits(), of.axis);
            assert_eq!(decided(&kept), decided(&fresh), "at {t}");
        }
    }
}
