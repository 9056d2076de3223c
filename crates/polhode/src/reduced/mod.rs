//! Reduced coordinates: the motion of trees of joints in the coordinates of their joints, after Featherstone.
//!
//! Scenes ask for them by `method.coordinates = "reduced"`. A tree of `n` hinges has `2 n` unknowns in the place of
//! `13 n`, and no gap at a joint that a projection would have to remove. Accelerations follow from articulated inertias
//! in three passes (`articulated.rs`), at a cost that is linear in the bodies. Springs, dampers, motors and fields act
//! on the bodies as in maximal coordinates, by the same code: what they exert is added to the bodies of the tree at
//! each stage.
//!
//! | module | holds |
//! |---|---|
//! | `tree` | the bodies of an island as trees, with the coordinates of their joints |
//! | `moving` | poses and velocities of the bodies from coordinates, and back |
//! | `articulated` | accelerations of the joints by articulated inertias |
//!
//! For which scenes they are available, `tier/coordinates.rs` says.
//!
//! A body that no joint holds to the world, itself or through others, is the base of its tree, with a position and a
//! quaternion.
//!
//! Sources: Featherstone 1983, 2008 (docs/REFERENCES.md), chapter 7.

mod articulated;
mod moving;
pub(crate) mod tree;

pub(crate) use articulated::Articulated;
