//! The kinds of random mechanisms, one file per group.
//!
//! | module | holds |
//! |---|---|
//! | `trees` | trees of joints, springs and drag between bodies |
//! | `loops` | closed loops |
//! | `freedoms` | what acts along coordinates: limits, motors, springs, friction; ropes |
//! | `drives` | gears, prescribed motions of joints, joints on bodies of prescribed motion |
//! | `tracks` | tracks |
//! | `thrown` | few bodies that fly, land, slide, roll, and are carried |
//! | `piles` | small piles |

pub(super) mod drives;
pub(super) mod freedoms;
pub(super) mod loops;
pub(super) mod piles;
pub(super) mod thrown;
pub(super) mod tracks;
pub(super) mod trees;
