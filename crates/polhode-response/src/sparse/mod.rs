//! Contact problems in the velocities of bodies, solved by sparse factors whose size goes with the bodies.
//!
//! `M (v - v_free) = H^T r`, `u = H v + b + C r`, and a law for the `r` and `u` of each contact or joint. No Delassus
//! matrix is formed: a step of every method here solves `(I + H^T K H) dv = right`, whose graph is that of the bodies,
//! with blocks of 6 x 6 (3 x 3 where no row turns a body). It is regular however many contacts are redundant, and
//! memory is linear in them.
//!
//! | stage | what it does | where |
//! |---|---|---|
//! | problem | takes bodies, the rows of contacts and joints, and scales masses away | `problem.rs`, `body.rs` |
//! | from rows | the same from the rows of a contact problem and their laws | `from_blocks.rs` |
//! | elimination | orders the bodies; kept while the graph stays | `elimination.rs`, `dissection.rs` |
//! | factors | Cholesky where `K` is symmetric, LU where contacts slide | `factors.rs`, `block6.rs` |
//! | system | assembles, factorises, and solves for what rounding has left | `system.rs` |
//! | measure | the one residual of all methods | `iterate.rs` |
//! | augmented Lagrangian | problems without friction, which are convex | `augmented_lagrangian.rs` |
//! | interior point | cold start, from the loads of sweeps or those that hold all | `interior_point.rs` |
//! | | its cones and their algebra | `interior_cone.rs`, `cone_form.rs`, `jordan.rs` |
//! | semismooth Newton | the end of it, and warm starts | `newton.rs` |
//! | sweeps | contact after contact: about the size of loads | `sweeps.rs` |
//! | path of compliance | where neither comes to the end | `compliance_path.rs`, `compliant_law.rs` |
//! | smoothing Newton | where the path turns back | `smoothing.rs`, `smoothed_cone.rs` |
//! | balance | makes forces balance to rounding | `balance.rs` |
//! | forest | trees of joints, eliminated first; the rest | `held_forest.rs`, `forest_passes.rs`, `beside_forest.rs` |
//! | solver | the chain of methods, and what is told of it | `solver.rs`, `solution.rs`, `settings.rs` |
//!
//! The residual is the natural map in units of impulse per unit of the largest reaction; what is not reached within
//! the budget of factorisations is told by it, and by the status.

mod augmented_lagrangian;
mod balance;
mod beside_forest;
mod block6;
mod body;
mod compliance_path;
mod compliant_law;
mod cone_form;
mod dissection;
mod elimination;
mod factors;
mod forest_passes;
pub(crate) mod from_blocks;
pub(crate) mod held_forest;
mod interior_cone;
mod interior_point;
mod iterate;
mod jordan;
mod newton;
mod problem;
mod settings;
mod smoothed_cone;
mod smoothing;
mod solution;
mod solver;
mod sweeps;
mod system;

pub(crate) use body::are_movable;

pub use balance::BalancedForces;
pub use beside_forest::{BesideForest, ForestSolution};
pub use body::BodyMass;
pub use elimination::Elimination;
pub use held_forest::HeldForest;
pub use problem::{BodyProblem, BodyRows};
pub use settings::BodySettings;
pub use solution::{BodyMethod, BodyReport, BodySolution};
pub use solver::BodySolver;
