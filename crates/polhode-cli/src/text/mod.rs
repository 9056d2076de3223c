//! Reports for people: aligned text.
//!
//! | module | holds |
//! |---|---|
//! | `table` | columns of equal width, numbers in few digits |
//! | `report` | plan, accelerations and report of a run |
//! | `stability` | how far bodies at rest are from moving |
//! | `mesh`, `mesh_studies` | a mesh; reference points and Monte Carlo estimates |
//! | `comparison` | two trajectories |
//! | `drop` | on which faces a body comes to rest |
//! | `stands` | whether bodies stand |
//! | `judge` | what is found of a trajectory |
//! | `sweep` | what the runs of a sweep say together |

mod comparison;
pub(crate) mod drop;
pub(crate) mod judge;
mod mesh;
mod mesh_studies;
mod report;
mod stability;
pub(crate) mod stands;
pub(crate) mod sweep;
mod table;

pub(crate) use comparison::comparison;
pub(crate) use mesh::{mesh, repairs, unit};
pub(crate) use mesh_studies::{monte_carlo, reference_points};
pub(crate) use report::{Ended, Extent, accelerations, approximations, plan, run};
pub(crate) use stability::{stability, stability_line};
pub(crate) use table::{Table, number};
