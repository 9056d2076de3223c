//! Forces of resting contacts: families of forces, the thesis's counterexamples, and the bound of its method.

use super::bodies::{GRAVITY, cuboid, fixed_cuboid};
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::response::{
    ContactProblem, ContactSolution, Delassus, SolverSettings, least_force, minimum_norm, solve_complementarity,
};
use polhode::{Scene, Simulation};
use polhode_oracles::random::Random;
use std::error::Error;

/// Length of the beam, m.
const BEAM: f64 = 2.0;
/// Moment of inertia of a uniform rod of that length and 1 kg, kg m^2.
const BEAM_INERTIA: f64 = BEAM * BEAM / 12.0;

/// A beam on three pillars (thesis, Figure 20): forces are not unique, accelerations are.
pub(super) fn rc_07(context: &Context) -> CaseResult {
    let reference = &context.reference;
    let three = beam_forces(&[-1.0, 0.0, 1.0])?;
    let two = beam_forces(&[-1.0, 1.0])?;
    let right_gone = beam_forces(&[-1.0, 0.0])?;
    let (linear, angular) = beam_accelerations()?;
    Ok(vec![
        reference.row("RC-07", "acceleration and angular acceleration", [linear, angular])?,
        reference.row("RC-07", "sum f, f1 - f3, N", [three.iter().sum::<f64>(), three[0] - three[2]])?,
        reference.row("RC-07", "least-norm forces, N", three)?,
        reference.row("RC-07", "middle pillar removed: f1, N", two[0])?,
        reference.row("RC-07", "right pillar removed: f_left, f_mid, N", right_gone)?,
    ])
}

/// Least-norm forces of pillars at these places under a beam of 1 kg, in the plane (velocity up, rate of turning).
fn beam_forces(pillars: &[f64]) -> Result<Vec<f64>, Box<dyn Error>> {
    let mut problem = ContactProblem::new(2, vec![1.0, 0.0, 0.0, 1.0 / BEAM_INERTIA])?;
    for &x in pillars {
        problem.push_row(&[(0, &[1.0, x])])?;
    }
    let settings = SolverSettings::default();
    let b = vec![-GRAVITY; pillars.len()];
    let solution = solve_complementarity(&problem, &problem.delassus(), &b, None, &settings)?;
    Ok(minimum_norm(&problem, &solution, &settings)?.forces)
}

/// Largest linear and angular acceleration of the beam in a scene.
fn beam_accelerations() -> Result<(f64, f64), Box<dyn Error>> {
    let accelerations = Simulation::new(&beam()?)?.accelerations()?;
    let beam = accelerations[0];
    Ok((beam.linear.abs().max_element(), beam.angular.abs().max_element()))
}

/// The beam on three pillars.
pub(super) fn beam() -> Result<Scene, Box<dyn Error>> {
    let size = DVec3::new(BEAM, 0.5, 0.25);
    let pillar = DVec3::new(0.25, 0.5, 1.0);
    let mut builder = Scene::builder("beam on pillars").body(cuboid("beam", size, 1.0, DVec3::Z * 0.5 * size.z)?);
    for x in [-1.0, 0.0, 1.0] {
        // The outer pillars end where the beam ends.
        let center = DVec3::new(x - x * 0.5 * pillar.x, 0.0, -0.5 * pillar.z);
        builder = builder.body(fixed_cuboid(&format!("pillar at {x}"), pillar, center)?);
    }
    Ok(builder.build()?)
}

/// A problem whose bodies have mass and inertia 1, one row after the other.
pub(super) fn unit_problem(rows: &[[f64; 3]]) -> Result<ContactProblem, Box<dyn Error>> {
    let mut problem = ContactProblem::new(3, vec![1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0])?;
    for row in rows {
        problem.push_row(&[(0, row)])?;
    }
    Ok(problem)
}

/// The exact solution with every constant term -1.
fn exact(problem: &ContactProblem) -> Result<(Delassus, Vec<f64>, ContactSolution), Box<dyn Error>> {
    let delassus = problem.delassus();
    let b = vec![-1.0; problem.len()];
    let solution = solve_complementarity(problem, &delassus, &b, None, &SolverSettings::default())?;
    Ok((delassus, b, solution))
}

/// A beam over a table edge: the forces of least sum pick the wrong contact.
pub(super) fn rc_08(context: &Context) -> CaseResult {
    // Contacts at 0.5 and 2 radii of gyration on the same side of the centre of mass.
    let problem = unit_problem(&[[1.0, 0.5, 0.0], [1.0, 2.0, 0.0]])?;
    let (delassus, b, solution) = exact(&problem)?;
    let guess = least_force(&delassus, &b, &SolverSettings::default())?;
    let least_sum = guess.least_sum.ok_or("the thesis's method did not come to its second step")?;
    let reference = &context.reference;
    Ok(vec![
        reference.row("RC-08", "forces, m g", solution.forces)?,
        reference.row("RC-08", "chi'', g", solution.residual_accelerations)?,
        reference.row("RC-08", "least-force guess f_a, m g", least_sum)?,
    ])
}

/// A plate on three contacts: both steps of the thesis's method fail.
pub(super) fn rc_09(context: &Context) -> CaseResult {
    let problem = unit_problem(&[[1.0, 4.0, -1.5], [1.0, 0.0, 0.5], [1.0, 3.0, 1.0]])?;
    let (delassus, b, solution) = exact(&problem)?;
    let guess = least_force(&delassus, &b, &SolverSettings::default())?;
    let least_sum = guess.least_sum.clone().ok_or("the thesis's method did not come to its second step")?;
    let power: f64 = guess.forces.iter().zip(&guess.residual_accelerations).map(|(f, w)| f * w).sum();
    let reference = &context.reference;
    Ok(vec![
        reference.row("RC-09", "forces", solution.forces)?,
        reference.row("RC-09", "chi''", solution.residual_accelerations)?,
        reference.row("RC-09", "least-force guess f_a", least_sum)?,
        Row::exact("RC-09", "least-force answer adds energy, and its certificate says so", true, {
            power > 0.0 && guess.report.bound > 0.0
        }),
    ])
}

/// Random contact problems: the error of the thesis's method never exceeds the bound of its certificate.
pub(super) fn least_force_bound(context: &Context) -> CaseResult {
    /// Problems at full count.
    const PROBLEMS: usize = 100_000;
    /// The energy norm of the error in units of the bound; more than 1 by rounding only.
    const ROUNDING: f64 = 1e-6;
    let case = "least-force bound";
    let mut random = Random(1);
    let (mut excess, mut wrong) = (0.0f64, 0u64);
    let count = context.amount.of(PROBLEMS);
    for _ in 0..count {
        let rows: Vec<[f64; 3]> =
            (0..3 + random.below(4)).map(|_| [1.0, random.between(-1.0, 1.0), random.between(-1.0, 1.0)]).collect();
        let problem = unit_problem(&rows)?;
        let (delassus, b, solution) = exact(&problem)?;
        let guess = least_force(&delassus, &b, &SolverSettings::default())?;
        let difference: Vec<f64> = guess.forces.iter().zip(&solution.forces).map(|(f, g)| f - g).collect();
        let change = delassus.times(&difference)?;
        let error = difference.iter().zip(&change).map(|(f, w)| f * w).sum::<f64>().max(0.0).sqrt();
        excess = excess.max(error - guess.report.bound);
        wrong += u64::from(error > ROUNDING);
    }
    Ok(vec![
        Row::at_most(case, &format!("largest error above its bound, {count} problems"), ROUNDING, excess.max(0.0)),
        Row::info(case, "problems that the thesis's method gets wrong", 0, wrong),
    ])
}
