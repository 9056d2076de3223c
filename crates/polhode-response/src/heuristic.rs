//! The thesis's heuristic of section 3.4 in its three stages, with what each took for vanishing contacts.
//!
//! | stage | forces | energy |
//! |---|---|---|
//! | 1 | no contact vanishes: `w = G f + b = 0`, `f >= 0` | none is added |
//! | 2 | `f = 0`, `w >= 0` where contacts vanish (see below), `w = 0` elsewhere | none is added |
//! | 3 | where that has no solution: `f_a` itself | the power `f.w >= 0` (W) is added |
//!
//! In stage 2 those contacts vanish that `f_a = argmin sum f` subject to `w >= 0`, `f >= 0` opens (`w_a > 0`).
//! Here `f` are forces (N), `w` accelerations of separation (m/s^2), `G` 1/kg. The forces are those of [`least_force`],
//! which does not tell what it took for vanishing. Stage 3 is wrong in general (errata E15: a beam over the edge of a
//! table), and the bound of the report, `sqrt(f.w)`, says by how much.
//!
//! Fails where the linear programme has no solution or is not solved: forces are zero then, and the status says so.
//!
//! Source: thesis, section 3.4, Finding the Vanishing Contact Points, with errata E11, E12.

use crate::certificate::{row_accelerations, row_scales};
use crate::delassus::Delassus;
use crate::error::ResponseError;
use crate::least_force::{LeastForceStage, least_force};
use crate::report::SolverReport;
use crate::settings::SolverSettings;
use crate::tolerances::ZERO_CUT;

/// Forces of the heuristic, and how they were found.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct HeuristicSolution {
    /// `f`, not negative, N.
    pub forces: Vec<f64>,
    /// `w = G f + b`, m/s^2.
    pub residual_accelerations: Vec<f64>,
    /// Which stage answered.
    pub stage: LeastForceStage,
    /// The contacts taken for vanishing, ascending: none in stage 1; in stage 3 those that the guess that failed named.
    pub vanishing: Vec<usize>,
    /// The power that the forces add, `f.w`, in N m/s^2 (the rate of change of the power, at bodies that begin to
    /// move).
    pub added: f64,
    /// The certificate.
    pub report: SolverReport,
}

/// Contact forces by the heuristic.
///
/// ```
/// use polhode_response::{ContactProblem, LeastForceStage, SolverSettings, heuristic};
/// // A beam over the edge of a table (case RC-08): contacts at 1/2 and 2 radii of gyration on one side of its centre.
/// // Least force takes the outer one alone, and the guess from it is wrong: it turns about the inner one.
/// let mut problem = ContactProblem::new(2, vec![1.0, 0.0, 0.0, 1.0])?;
/// problem.push_row(&[(0, &[1.0, 0.5])])?;
/// problem.push_row(&[(0, &[1.0, 2.0])])?;
/// let solution = heuristic(&problem.delassus(), &[-1.0, -1.0], &SolverSettings::default())?;
/// assert_ne!(solution.stage, LeastForceStage::NoneVanish);
/// # Ok::<(), polhode_response::ResponseError>(())
/// ```
///
/// # Errors
/// When lengths differ, a number is not finite, or a setting is out of range.
#[cfg_attr(feature = "census", track_caller)]
pub fn heuristic(
    delassus: &Delassus,
    b: &[f64],
    settings: &SolverSettings,
) -> Result<HeuristicSolution, ResponseError> {
    let solution = least_force(delassus, b, settings)?;
    let vanishing = solution.least_sum.as_ref().map_or_else(Vec::new, |forces| {
        let (mut w, mut scales) = (vec![0.0; b.len()], vec![0.0; b.len()]);
        row_accelerations(delassus.entries(), b, forces, &mut w);
        row_scales(delassus.entries(), b, forces, &mut scales);
        (0..b.len()).filter(|&row| w[row] > ZERO_CUT * scales[row]).collect()
    });
    let products = solution.forces.iter().zip(&solution.residual_accelerations);
    let added = products.map(|(force, w)| force * w.max(0.0)).sum();
    Ok(HeuristicSolution {
        forces: solution.forces,
        residual_accelerations: solution.residual_accelerations,
        stage: solution.stage,
        vanishing,
        added,
        report: solution.report,
    })
}
