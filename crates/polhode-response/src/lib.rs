//! Impact laws and contact-force problems with certificates: what bodies in contact do to each other.
//!
//! This crate knows no shape: it takes generalised inverse masses and Jacobian rows of any width and returns forces
//! or impulses, each answer with a report on how exact it is. Notation: `v` velocities of all bodies, `u = J v` rates
//! of separation of the rows, `f` forces (`p` impulses) along the rows, `G = J M^-1 J^T` the Delassus matrix.
//!
//! | module | holds |
//! |---|---|
//! | [`problem`] | [`ContactProblem`]: inverse masses and rows |
//! | [`problem_text`] | such problems as plain text |
//! | [`law`] | [`Law`]: what the rows of one constraint ask for together |
//! | [`mod@solve`] | [`solve()`]: the one entry, which chooses the solver |
//! | [`delassus`] | [`Delassus`]: the matrix `G` |
//! | [`complementarity`] | [`ComplementaritySolver`]: `0 <= f _\|_ G f + b >= 0`, exactly |
//! | [`mod@minimum_norm`] | [`minimum_norm()`]: the least forces among those of the same motion |
//! | [`least_norm_hold`] | [`least_norm_forces`]: rows that are held by the least forces, at any mass ratio |
//! | [`sliding`] | [`least_norm_sliding_forces`]: rows held while contacts slide, and whether that choice matters |
//! | [`friction`] | [`solve_friction`](friction::solve_friction): contacts with friction, exact Coulomb |
//! | [`sparse`] | [`BodySolver`](sparse::BodySolver): contacts and joints in velocities of bodies, sparse factors |
//! | [`impact`] | [`ImpactLaw`]: propagation, simultaneous, reflection, poisson, energetic, pulse |
//! | [`sequential_impulses`] | [`SequentialImpulses`](sequential_impulses::SequentialImpulses) |
//! | | a step in real time, contacts side by side |
//! | [`impact::friction`] | [`SingleFrictionalImpact`], [`MultipleFrictionalImpact`]: slip, stick, reversal and jam |
//! | [`mod@guesses`] | [`guesses()`] of the thesis, which tell what they took for vanishing contacts |
//! | [`mod@least_force`] | [`least_force()`]: the heuristic of the thesis by linear programmes |
//! | `census` | with the feature of that name: which method answers each solve, and what the next would have given |
//! | [`certificate`] | residual and error bound of any answer |
//! | [`report`] | [`SolverReport`], [`SolverStatus`] |
//! | [`method_set`] | [`MethodSet`]: which methods of a chain were tried |
//! | [`settings`] | [`SolverSettings`] |
//! | [`error`] | [`ResponseError`] |
//! | `dense` | small dense linear algebra |
//! | `interior_point` | the interior-point backend, which alone names clarabel |
//! | `least_in_cones` | the least forces within the cones of friction that hold what some forces hold |
//! | `penalty` | spring laws of contacts |
//! | `precise` | rates of rows, body by body, in twice the working precision |
//! | `tolerances` | what several methods compare with |
//!
//! This crate is all that a program needs to name. Its signatures speak of numbers alone; vectors to build rows from,
//! and mass properties, are under [`spatial`]. Programs of ten lines stand in the folder `examples` of the crate:
//! `newtons_cradle` (an impact law), `rod_on_a_rough_floor` (one with friction) and `box_on_the_floor` (contact
//! forces).
//!
//! ```
//! use polhode_response::{ContactProblem, SolverSettings, minimum_norm, solve_complementarity};
//! // A beam of 1 kg and inertia 1/3 kg m^2 on three pillars at x = -1, 0, 1 (thesis, Figure 20), in a plane.
//! let mut problem = ContactProblem::new(3, vec![1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 3.0])?;
//! for x in [-1.0, 0.0, 1.0] {
//!     problem.push_row(&[(0, &[0.0, 1.0, x])])?;
//! }
//! let (delassus, settings) = (problem.delassus(), SolverSettings::default());
//! let solution = solve_complementarity(&problem, &delassus, &[-9.81; 3], None, &settings)?;
//! assert_eq!(solution.residual_accelerations, [0.0; 3]);
//! let forces = minimum_norm(&problem, &solution, &settings)?.forces;
//! assert!(forces.iter().all(|f| (f - 3.27).abs() < 1e-14));
//! # Ok::<(), polhode_response::ResponseError>(())
//! ```
//!
//! # Stages
//!
//! In the order of the calls; paths are in `src`. Contact forces:
//!
//! | stage | what it does | where |
//! |---|---|---|
//! | problem | takes inverse masses and the rows of each constraint | `problem.rs`, `law.rs` |
//! | Delassus matrix | computes `J M^-1 J^T` | `delassus.rs` |
//! | active set | finds rows with forces, warm start | `complementarity/solver.rs`, `complementarity/active_set.rs` |
//! | twice the precision | repeats that where rows nearly depend on each other | `precise.rs` |
//! | certificate | computes residual and error bound of the answer | `certificate.rs` |
//! | least norm | chooses the least forces of the same motion | `minimum_norm.rs`, `least_norm_hold.rs` |
//!
//! Impacts:
//!
//! | stage | what it does | where |
//! |---|---|---|
//! | law | calls the law of a name | `impact/law.rs` |
//! | impulses | strikes rows by the law, each solve by the active set above | `impact/reflection.rs` |
//! | | | `impact/simultaneous.rs`, `impact/propagation.rs` |
//! | end | checks that no row approaches, and computes the change of energy | `impact/finish.rs` |
//! | outcome | returns impulses, status and energy | `impact/outcome.rs` |
//!
//! Impacts with friction:
//!
//! | stage | what it does | where |
//! |---|---|---|
//! | groups | parts contacts that do not move each other | `impact/friction/multiple.rs` |
//! | one contact | follows slip, stick, reversal and jam | `impact/friction/single.rs`, `impact/friction/path.rs` |
//! | several | chooses normal velocities, solves cone problems | `impact/friction/simultaneous.rs` |
//! | | keeps the energy from rising | `impact/friction/simultaneous.rs` |
//! | or one at a time | strikes them in order | `impact/friction/sequence.rs` |
//! | outcome | impulses, works, status, energy | `impact/friction/multiple_outcome.rs`, `impact/friction/outcome.rs` |

#[cfg(feature = "census")]
pub mod census;
pub mod certificate;
pub mod complementarity;
pub mod delassus;
mod dense;
pub mod error;
pub mod friction;
pub mod guesses;
pub mod impact;
mod interior_point;
pub mod law;
pub mod least_force;
pub mod least_in_cones;
pub mod least_norm_hold;
pub mod method_set;
pub mod minimum_norm;
pub mod penalty;
mod precise;
pub mod problem;
pub mod problem_text;
pub mod report;
pub mod sequential_impulses;
pub mod settings;
pub mod sliding;
pub mod solve;
pub mod sparse;
mod tolerances;

pub use complementarity::{ComplementaritySolver, ContactSolution, WarmStart, solve_complementarity};
pub use delassus::{Delassus, check_delassus};
pub use error::ResponseError;
pub use friction::{Blocks, BlocksSolution, FallbackPolicy, ResistedPart};
pub use guesses::{GuessedForces, MOST_GUESSED, guesses};
pub use impact::friction::{
    CollisionMatrix, FrictionalImpact, FrictionalImpactStatus, ImpactPhase, MultipleFrictionalImpact, MultipleImpact,
    MultipleImpactLaw, MultipleImpactSettings, PhaseKind, RestitutionLaw, SingleFrictionalImpact, SlidingContact,
    SlidingForce,
};
pub use impact::{
    Application, ImpactLaw, ImpactOutcome, ImpactProblem, ImpactSettings, ImpactStatus, PulseExponent,
    single_contact_impulse,
};
pub use law::{Law, Resistance};
pub use least_force::{LeastForceSolution, LeastForceStage, least_force};
pub use least_in_cones::least_forces_in_cones;
pub use least_norm_hold::{LeastNormForces, LeastNormHold, least_norm_forces};
pub use method_set::{ChainMethod, MethodSet};
pub use minimum_norm::{MinimumNormForces, minimum_norm};
pub use problem::{ContactProblem, RowEntries};
pub use report::{Method, SolverReport, SolverStatus};
pub use settings::SolverSettings;
pub use sliding::{SlidingRow, least_norm_sliding_forces, motion_depends_on_choice};
pub use solve::{Answer, Ask, Choice, Memory, Question, RowProblem, Rows, solve};

pub use polhode_spatial as spatial;

// The program in the README is compiled and run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
