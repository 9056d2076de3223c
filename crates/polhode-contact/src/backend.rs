//! The one module that names parry3d: the bounding-volume hierarchy and approximate decomposition.

use crate::Aabb;
use glam::DVec3;
use parry3d::bounding_volume::Aabb as ParryAabb;
use parry3d::partitioning::{Bvh, BvhBuildStrategy, BvhWorkspace};
use parry3d::transformation::vhacd::{VHACD, VHACDParameters};
use parry3d::transformation::voxelization::FillMode;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Settings of V-HACD.
pub(crate) struct ClusterSettings {
    pub(crate) concavity: f64,
    pub(crate) resolution: u32,
    pub(crate) max_parts: u32,
}

/// Clusters of points of a closed surface of size one about the origin: the hull of each is a part of an approximate
/// convex decomposition. None when the library fails, which it is known to do by panicking.
pub(crate) fn convex_clusters(
    points: &[DVec3],
    triangles: &[[u32; 3]],
    settings: &ClusterSettings,
) -> Option<Vec<Vec<DVec3>>> {
    let parameters = VHACDParameters {
        concavity: settings.concavity,
        resolution: settings.resolution,
        max_convex_hulls: settings.max_parts,
        // The detection of cavities hollows out solids that have none (measured: half the volume of an L-shape).
        fill_mode: FillMode::FloodFill { detect_cavities: false },
        ..VHACDParameters::default()
    };
    let decompose =
        || VHACD::decompose(&parameters, points, triangles, true).compute_primitive_intersections(points, triangles);
    catch_unwind(AssertUnwindSafe(decompose)).ok()
}

/// A tree of bounding boxes whose leaves are numbered from zero.
#[derive(Default, Clone)]
pub(crate) struct AabbTree {
    tree: Bvh,
    workspace: BvhWorkspace,
    leaves: usize,
}

impl AabbTree {
    /// Replaces the boxes: moves the leaves when their number is unchanged, rebuilds the tree otherwise. The order of
    /// the steps is that of rapier3d: the refit comes last, and it stores the nodes in the order of traversal.
    pub(crate) fn set(&mut self, boxes: &[Aabb]) {
        let convert = |aabb: &Aabb| ParryAabb::new(aabb.min(), aabb.max());
        if self.leaves == 0 || boxes.len() > 2 * self.leaves {
            let converted: Vec<ParryAabb> = boxes.iter().map(convert).collect();
            self.tree = Bvh::from_leaves(BvhBuildStrategy::Binned, &converted);
            self.leaves = boxes.len();
            return;
        }
        let is_smaller = boxes.len() < self.leaves;
        for leaf in boxes.len()..self.leaves {
            self.tree.remove(leaf as u32);
        }
        if is_smaller {
            // A refit removes unused nodes, which the rebuild would otherwise take for leaves.
            self.tree.refit(&mut self.workspace);
        }
        for (leaf, aabb) in boxes.iter().enumerate() {
            self.tree.insert_or_update_partially(convert(aabb), leaf as u32, 0.0);
        }
        if boxes.len() == self.leaves {
            self.tree.optimize_incremental(&mut self.workspace);
            self.tree.refit(&mut self.workspace);
        } else {
            self.leaves = boxes.len();
            self.tree.rebuild(&mut self.workspace, BvhBuildStrategy::Binned);
        }
    }

    /// Calls `visit` with the leaves of every two boxes that overlap, in no stated order.
    pub(crate) fn overlaps(&mut self, visit: &mut impl FnMut(u32, u32)) {
        self.tree.traverse_bvtt_single_tree::<false>(&mut self.workspace, visit);
    }
}

impl std::fmt::Debug for AabbTree {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("AabbTree").field("leaves", &self.leaves).finish_non_exhaustive()
    }
}
