//! What several methods compare with, each meaning once. What rounding leaves stands in `polhode_spatial::rounding`.

/// A block that nothing moves is measured by this fraction of the largest inverse mass (no unit): with it a reaction
/// there shows in the residual, however small.
pub(crate) const IMMOVABLE: f64 = 1e-3;

/// Share of the decrease promised that a step of Newton's method must bring (no unit); the usual one of Armijo.
pub(crate) const DECREASE: f64 = 1e-4;

/// What a step leaves of the function's square when it went well (no unit).
pub(crate) const WENT_WELL: f64 = 0.25;

/// Halvings of a step of Newton's method.
pub(crate) const MOST_HALVINGS: usize = 6;

/// Steps that are too short after which a path leads nowhere.
pub(crate) const MOST_SHORT_STEPS: usize = 2;

/// Least damping of a linearised problem, as a share of its diagonal or in velocities per load (no unit, 1e-10 to
/// 1e-8): between the rounding unit and the smallest share of a direction that moves something. Rounding of
/// velocities, divided by it, lets reactions wander that move nothing, and what that turns of a sliding contact's
/// friction is left in the residual: with 1e-10 some 1e-12 of a tower of 570 contacts. Heavy bodies on light ones are
/// held with it at ratios of 1e6.
pub(crate) const LEAST_DAMPING: f64 = 1e-9;

/// Some rounding units (no unit): what an iteration changes or misses by at its end.
pub(crate) const LEAST_CHANGE: f64 = 1e-15;

/// Equations of a compliant contact below this fraction of the largest depend on the others (no unit): rounding.
pub(crate) const DEPENDENT_COMPLIANCE: f64 = 1e-16;

/// Rows and columns whose pivot is below this fraction of the largest depend on the others (no unit). Pivots are
/// quadratic in distances: contacts that are 1e-5 of the lever arm apart are taken as one; rounding of pivots is below
/// 1e-14.
pub(crate) const DEPENDENT: f64 = 1e-10;

/// A pivot below this fraction of its diagonal is not told from rounding (no unit, 1e-14 to 1e-10): some hundred
/// rounding units over it are the margin.
pub(crate) const TRUSTED_PIVOT: f64 = 1e-12;

/// A pivot that vanishes is replaced by this (in units of the matrix, whose diagonal is about 1): its unknown stays
/// where it was.
pub(crate) const VANISHING_PIVOT: f64 = 1e-200;

/// Largest relative asymmetry, and negative pivot, of a block of masses or of a matrix that count as rounding (no
/// unit).
pub(crate) const MATRIX_ROUNDING: f64 = 1e-12;

/// Accelerations of an exact answer below this fraction of their scale count as zero (no unit).
pub(crate) const ZERO_CUT: f64 = 1e-9;

/// The residual of a step's or an impact's problem with which no other way is tried (no unit, 1e-9 to 1e-7): velocities
/// are then wrong by at most about this fraction of the speed that gravity gives in a step. A larger one is not taken
/// for rounding in rows: reactions so large that their rounding is more than this diverge.
pub const EXACT_ENOUGH: f64 = 1e-8;

/// A residual above this is never taken for the rounding of velocities (no unit, 1e-6 to 1e-5): reactions so large that
/// their rounding is more than this diverge, as where bodies are squeezed or rows contradict each other by a rounding.
pub(crate) const LARGEST_RESIDUAL_ROUNDING: f64 = 1e-6;
