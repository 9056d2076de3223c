//! Contacts with Coulomb friction at one instant: which stick, which slide, which open.
//!
//! With the forces `f` of all rows and `w = G f + b`: a contact of normal row `n` and tangent rows `t` satisfies
//! `0 <= f_n _|_ w_n >= 0`, and `|f_t| <= mu f_n` where `w_t = 0`, else `f_t = -mu f_n w_t / |w_t|`. A contact that
//! already slides along `d` bears `-mu f_n d` along one row. All other rows are bilateral, `w = 0`.
//!
//! `w` is an acceleration and `f` a force where the slip is zero, or a velocity after an impact and `f` an impulse.
//!
//! Method: semismooth Newton on the projection form of Alart and Curnier,
//! `f_n - max(0, y_n) = 0`, `f_t - P(f_t - rho w_t) = 0` with `y_n = f_n - rho w_n` and `P` the projection on the disk of
//! radius `mu max(0, y_n)`; each step is the least-norm solution of the linear equations, with backtracking.

use crate::delassus::Delassus;
use crate::dense::householder::PivotedQr;
use crate::error::{ResponseError, check_finite, check_length};

const DEPENDENT: f64 = 1e-12;
const MOST_STEPS: usize = 60;
const MOST_HALVINGS: usize = 24;
const CONVERGED: f64 = 1e-14;

/// The law of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ContactLaw {
    /// Without friction.
    Frictionless,
    /// Coulomb friction where the slip is zero.
    Coulomb {
        /// Rows along two tangents.
        tangents: [usize; 2],
        /// Coefficient.
        coefficient: f64,
    },
    /// Friction against a slip.
    Sliding {
        /// The row along the slip.
        tangent: usize,
        /// Coefficient.
        coefficient: f64,
    },
}

/// A contact among rows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoulombContact {
    /// The row along its normal.
    pub normal: usize,
    /// Its law.
    pub law: ContactLaw,
}

/// Forces and accelerations of all rows.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct CoulombSolution {
    /// `f`.
    pub forces: Vec<f64>,
    /// `w`.
    pub accelerations: Vec<f64>,
    /// Residual relative to the largest constant term.
    pub residual: f64,
    /// Newton steps.
    pub iterations: usize,
}

/// Solves for the forces.
///
/// # Errors
/// When lengths differ or a number is not finite.
pub fn solve_coulomb(
    delassus: &Delassus,
    b: &[f64],
    contacts: &[CoulombContact],
) -> Result<CoulombSolution, ResponseError> {
    delassus.check_finite()?;
    check_length("constant terms", delassus.len(), b.len())?;
    check_finite("constant terms", b)?;
    let n = b.len();
    let scale = b.iter().fold(0.0_f64, |most, b| most.max(b.abs()));
    let roles = roles(n, contacts);
    let rho: Vec<f64> = (0..n)
        .map(|row| {
            let diagonal = delassus.get(row, row);
            if diagonal > 0.0 { 1.0 / diagonal } else { 0.0 }
        })
        .collect();
    let mut forces = vec![0.0; n];
    let mut best = (f64::INFINITY, forces.clone());
    let mut iterations = 0;
    let mut current = equations(delassus, b, &roles, contacts, &rho, &forces);
    while iterations < MOST_STEPS {
        let size = merit(&current.0, &rho);
        if size < best.0 {
            best = (size, forces.clone());
        }
        if size <= CONVERGED * scale {
            break;
        }
        iterations += 1;
        let (residual, jacobian) = &current;
        let factor = PivotedQr::factor(n, n, jacobian.clone(), DEPENDENT);
        let wanted: Vec<f64> = residual.iter().map(|r| -r).collect();
        let step = factor.solve_transpose(&wanted);
        let mut length = 1.0;
        let mut next = None;
        for _ in 0..MOST_HALVINGS {
            let tried: Vec<f64> = forces.iter().zip(&step).map(|(f, s)| f + length * s).collect();
            let equations = equations(delassus, b, &roles, contacts, &rho, &tried);
            let better = merit(&equations.0, &rho) < size;
            if next.is_none() || better {
                next = Some((tried, equations));
            }
            if better {
                break;
            }
            length *= 0.5;
        }
        let Some((tried, equations)) = next else { break };
        (forces, current) = (tried, equations);
    }
    let forces = best.1;
    let mut accelerations = delassus.times(&forces)?;
    for (w, b) in accelerations.iter_mut().zip(b) {
        *w += b;
    }
    let residual = if scale > 0.0 { best.0 / scale } else { best.0 };
    Ok(CoulombSolution { forces, accelerations, residual, iterations })
}

/// What the equation of a row is.
#[derive(Debug, Clone, Copy)]
enum Role {
    Bilateral,
    Normal,
    /// Rows of contact `contact`.
    Tangent {
        contact: usize,
    },
    Slide {
        contact: usize,
    },
}

fn roles(n: usize, contacts: &[CoulombContact]) -> Vec<Role> {
    let mut roles = vec![Role::Bilateral; n];
    for (index, contact) in contacts.iter().enumerate() {
        roles[contact.normal] = Role::Normal;
        match contact.law {
            ContactLaw::Frictionless => {}
            ContactLaw::Coulomb { tangents, .. } => {
                for row in tangents {
                    roles[row] = Role::Tangent { contact: index };
                }
            }
            ContactLaw::Sliding { tangent, .. } => roles[tangent] = Role::Slide { contact: index },
        }
    }
    roles
}

fn merit(residual: &[f64], rho: &[f64]) -> f64 {
    residual.iter().zip(rho).fold(0.0_f64, |most, (r, rho)| most.max(if *rho > 0.0 { r.abs() / rho } else { 0.0 }))
}

/// Residuals (as forces) and the Jacobian, row by row.
fn equations(
    delassus: &Delassus,
    b: &[f64],
    roles: &[Role],
    contacts: &[CoulombContact],
    rho: &[f64],
    f: &[f64],
) -> (Vec<f64>, Vec<f64>) {
    let n = b.len();
    let w: Vec<f64> = (0..n).map(|row| crate::dense::kernels::dot(delassus.row(row), f) + b[row]).collect();
    let mut residual = vec![0.0; n];
    let mut jacobian = vec![0.0; n * n];
    for row in 0..n {
        let line = &mut jacobian[row * n..(row + 1) * n];
        match roles[row] {
            Role::Bilateral => {
                residual[row] = rho[row] * w[row];
                add(line, rho[row], delassus.row(row));
            }
            Role::Normal => {
                let y = f[row] - rho[row] * w[row];
                if y > 0.0 {
                    residual[row] = rho[row] * w[row];
                    add(line, rho[row], delassus.row(row));
                } else {
                    residual[row] = f[row];
                    line[row] = 1.0;
                }
            }
            Role::Slide { contact } => {
                let CoulombContact { normal, law: ContactLaw::Sliding { coefficient, .. } } = contacts[contact] else {
                    continue;
                };
                residual[row] = f[row] + coefficient * f[normal];
                line[row] = 1.0;
                line[normal] += coefficient;
            }
            Role::Tangent { contact } => {
                let CoulombContact { normal, law: ContactLaw::Coulomb { tangents, coefficient } } = contacts[contact]
                else {
                    continue;
                };
                let step = rho[tangents[0]].min(rho[tangents[1]]);
                let y = f[normal] - rho[normal] * w[normal];
                let radius = coefficient * y.max(0.0);
                let t = tangents.map(|row| f[row] - step * w[row]);
                let length = t[0].hypot(t[1]);
                let (own, other) = if row == tangents[0] { (0, 1) } else { (1, 0) };
                if length <= radius {
                    residual[row] = step * w[row];
                    add(line, step, delassus.row(row));
                } else if radius == 0.0 {
                    residual[row] = f[row];
                    line[row] = 1.0;
                } else {
                    let ratio = radius / length;
                    residual[row] = f[row] - ratio * t[own];
                    line[row] += 1.0;
                    // d(ratio t)/dt = ratio (1 - e e^T), d/dradius = e.
                    let e = [t[own] / length, t[other] / length];
                    let along = [ratio * (1.0 - e[0] * e[0]), -ratio * e[0] * e[1]];
                    for (tangent, factor) in [(tangents[own], along[0]), (tangents[other], along[1])] {
                        line[tangent] -= factor;
                        add(line, factor * step, delassus.row(tangent));
                    }
                    if y > 0.0 {
                        line[normal] -= coefficient * e[0];
                        add(line, coefficient * e[0] * rho[normal], delassus.row(normal));
                    }
                }
            }
        }
    }
    (residual, jacobian)
}

fn add(line: &mut [f64], factor: f64, row: &[f64]) {
    for (entry, value) in line.iter_mut().zip(row) {
        *entry += factor * value;
    }
}
