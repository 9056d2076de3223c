//! Contacts with friction: exact Coulomb, in cones and never in pyramids.
//!
//! The problem is `u = G r + q` with Coulomb's and Signorini's law for each contact,
//! `K* contains u + mu |u_t| n _|_ r in K` (De Saxce). It serves velocities with impulses and accelerations with forces
//! alike. These are plain functions for anyone who has a Delassus matrix: [`FrictionProblem::from_dense`],
//! [`solve_friction`].
//!
//! | file | holds |
//! |---|---|
//! | `blocks` | [`Blocks`]: for which rows of a problem each law is stated |
//! | `block_matrix` | [`BlockMatrix`]: the Delassus operator in blocks |
//! | `problem` | [`FrictionProblem`], and the one residual of all methods |
//! | `coulomb_cone` | projection, De Saxce's correction, natural map |
//! | `single_contact` | one contact on its own, exactly |
//! | `gauss_seidel` | [`gauss_seidel()`]: contact after contact |
//! | `linearisation` | Coulomb's law, linearised; [`ContactStatus`] |
//! | `elimination_order`, `multifrontal` | sparse elimination |
//! | `node_matrix`, `node_laws` | contacts of the same two bodies, reduced to what is independent |
//! | `newton` | the semismooth Newton method |
//! | `cone_programme` | the convex relative, and the proof that there is no solution |
//! | `limit_analysis` | [`Structure`]: how far what stands is from moving |
//! | `solver` | [`solve_friction`]: the chain of methods |
//! | `settings`, `solution` | [`FrictionSettings`], [`Redundancy`], [`FrictionSolution`] |
//! | `blocks_beside` | blocks of contacts of bodies in trees of joints |
//! | `rows_behind` | the rows of bodies behind the matrix of a problem |

pub(crate) mod block_matrix;
mod blocks;
mod blocks_beside;
mod cone_programme;
pub(crate) mod coulomb_cone;
pub(crate) mod elimination_order;
mod gauss_seidel;
mod limit_analysis;
pub(crate) mod linearisation;
mod multifrontal;
mod newton;
mod node_laws;
mod node_matrix;
pub(crate) mod problem;
pub(crate) mod rows_behind;
mod settings;
pub(crate) mod single_contact;
mod solution;
mod solver;

pub use block_matrix::BlockMatrix;
pub use blocks::{Blocks, BlocksSolution, ResistedPart};
pub use gauss_seidel::gauss_seidel;
pub use limit_analysis::{Limit, MOST_FACTOR, Structure};
pub use linearisation::ContactStatus;
pub use problem::FrictionProblem;
pub use settings::{FallbackPolicy, FrictionSettings, Redundancy};
pub use solution::{FrictionMethod, FrictionReport, FrictionSolution};
pub use solver::solve_friction;
