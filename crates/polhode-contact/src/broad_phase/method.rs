//! The broad phases by name.

use super::binary_space_partition::BinarySpacePartition;
use super::kd_tree::KdTree;
use super::octree::Octree;
use super::pair_collector::Sorted;
use super::partition::Partition;
use super::sweep_and_prune::SweepAndPrune;
use super::voxel_grid::VoxelGrid;
use super::{AllPairs, BroadPhase, Bvh};
use std::fmt;
use std::str::FromStr;
use thiserror::Error;

/// A broad-phase algorithm. All find the same pairs; they differ in time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum BroadPhaseMethod {
    /// A hierarchy of bounding boxes.
    #[default]
    Bvh,
    /// Uniform cells in a hash table.
    VoxelGrid,
    /// Space halved along three axes at once.
    Octree,
    /// Space halved along one axis at a time.
    KdTree,
    /// Space halved by planes in any direction.
    BinarySpacePartition,
    /// Intervals on one axis, kept in order.
    SweepAndPrune,
    /// Every box against every other.
    AllPairs,
}

/// No broad phase has this name.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("there is no broad phase `{name}`: use one of \
    {}", BroadPhaseMethod::ALL.map(BroadPhaseMethod::name).join(", "))]
pub struct UnknownBroadPhase {
    /// The name given.
    pub name: String,
}

impl BroadPhaseMethod {
    /// All methods, the default first.
    pub const ALL: [Self; 7] = [
        Self::Bvh,
        Self::VoxelGrid,
        Self::Octree,
        Self::KdTree,
        Self::BinarySpacePartition,
        Self::SweepAndPrune,
        Self::AllPairs,
    ];

    /// Its name in scenes and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Bvh => "bvh",
            Self::VoxelGrid => "voxel-grid",
            Self::Octree => "octree",
            Self::KdTree => "kd-tree",
            Self::BinarySpacePartition => "binary-space-partition",
            Self::SweepAndPrune => "sweep-and-prune",
            Self::AllPairs => "none",
        }
    }

    /// A new broad phase of this kind.
    pub fn build(self) -> Box<dyn BroadPhase> {
        match self {
            Self::Bvh => Box::new(Bvh::default()),
            Self::VoxelGrid => Box::<Sorted<VoxelGrid>>::default(),
            Self::Octree => Box::<Sorted<Partition<Octree>>>::default(),
            Self::KdTree => Box::<Sorted<Partition<KdTree>>>::default(),
            Self::BinarySpacePartition => Box::<Sorted<Partition<BinarySpacePartition>>>::default(),
            Self::SweepAndPrune => Box::<Sorted<SweepAndPrune>>::default(),
            Self::AllPairs => Box::new(AllPairs),
        }
    }
}

impl fmt::Display for BroadPhaseMethod {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for BroadPhaseMethod {
    type Err = UnknownBroadPhase;

    fn from_str(name: &str) -> Result<Self, UnknownBroadPhase> {
        let known = Self::ALL.into_iter().find(|method| method.name() == name);
        known.ok_or_else(|| UnknownBroadPhase { name: name.to_owned() })
    }
}
