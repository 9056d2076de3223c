//! Reports for people: aligned text.
//!
//! | module | holds |
//! |---|---|
//! | `table` | columns of equal width, numbers in few digits |
//! | `report` | plan, accelerations and report of a run |
//! | `mesh` | a mesh |
//! | `comparison` | two trajectories |

mod comparison;
mod mesh;
mod report;
mod table;

pub(crate) use comparison::comparison;
pub(crate) use mesh::mesh;
pub(crate) use report::{accelerations, plan, report};
pub(crate) use table::{Table, number};
