//! Whether forces at the contact points can balance every block: a programme over second-order cones, solved by
//! clarabel.
//!
//! ```text
//! minimise e   subject to   | sum f + m g | <= e m g,   | sum r x f | <= e m g L   for every block, by components
//!                           |f_t| <= mu f_n,   0 <= f_n <= F
//! ```
//!
//! `f` is the force at a point, N, of components `f_n` along the normal and `f_t` across it, `r` the point from the
//! centre of mass, m, `m g` the weight, N, and `L` the distance of the farthest corner from it, m. The shortfall `e`
//! (no unit) is zero if and only if the structure can stand; `F` bounds forces that brace each other and changes no
//! verdict while forces that balance are smaller. The programme always has a solution (no forces, e = 1), so that the
//! solver never has to prove that there is none. Source: Heyman 1966 (limit analysis of masonry); Livesley 1978 (as a
//! programme); Goulart and Chen 2024 (the solver).

use super::block::Block;
use super::contact_points::{ContactPoint, contact_points};
use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSolver, IPSolver, NonnegativeConeT, SecondOrderConeT, SolverStatus, SupportedConeT,
};
use glam::DVec3;
use std::error::Error;

/// Friction between all blocks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Friction {
    /// None: forces are normal to the faces.
    Frictionless,
    /// Coulomb's, of this coefficient.
    Coefficient(f64),
}

/// What the programme says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Forces balance every block.
    Feasible,
    /// No forces do.
    Infeasible,
    /// The shortfall is between what the solver resolves and the margin.
    Marginal,
}

/// A structure whose shortfall exceeds this fraction of the weight of a block cannot stand: the margin.
const MARGIN: f64 = 1e-6;

/// A shortfall below this fraction of the weight of a block is the solver's: ten times its tolerance.
const RESOLVED: f64 = 1e-8;

/// Gap and feasibility of the solver, relative (no unit).
const TOLERANCE: f64 = 1e-10;

/// Bound of the normal forces, in units of the weight of the whole structure.
const LARGEST_FORCE: f64 = 1e3;

/// Whether blocks under gravity along -z can stand.
///
/// # Errors
/// When the solver gives no answer.
pub fn judge(blocks: &[Block], friction: Friction) -> Result<Verdict, Box<dyn Error>> {
    let shortfall = shortfall(blocks, friction)?;
    Ok(if shortfall > MARGIN {
        Verdict::Infeasible
    } else if shortfall > RESOLVED {
        Verdict::Marginal
    } else {
        Verdict::Feasible
    })
}

/// The programme in the solver's form: `A x + s = b` with `s` in cones.
#[derive(Debug, Default)]
struct Programme {
    rows: Vec<usize>,
    columns: Vec<usize>,
    values: Vec<f64>,
    right: Vec<f64>,
    cones: Vec<SupportedConeT<f64>>,
}

impl Programme {
    /// Adds the row `right - terms . x`, which must be in the cone of its place.
    fn push(&mut self, terms: &[(usize, f64)], right: f64) {
        for &(column, value) in terms {
            self.rows.push(self.right.len());
            self.columns.push(column);
            self.values.push(value);
        }
        self.right.push(right);
    }
}

fn shortfall(blocks: &[Block], friction: Friction) -> Result<f64, Box<dyn Error>> {
    let points = contact_points(blocks);
    let weight: f64 = blocks.iter().filter_map(|block| block.mass_kg).sum();
    let width = if friction == Friction::Frictionless { 1 } else { 3 };
    let variables = 1 + width * points.len();
    let mut programme = Programme::default();
    for (number, block) in blocks.iter().enumerate() {
        let Some(mass) = block.mass_kg else { continue };
        balance(&mut programme, (number, block, mass / weight), &points, width);
    }
    for contact in 0..points.len() {
        let normal = 1 + width * contact;
        programme.push(&[(normal, 1.0)], LARGEST_FORCE);
        programme.push(&[(normal, -1.0)], 0.0);
    }
    programme.cones.push(NonnegativeConeT(programme.right.len()));
    if let Friction::Coefficient(coefficient) = friction {
        for contact in 0..points.len() {
            let normal = 1 + width * contact;
            programme.push(&[(normal, -coefficient)], 0.0);
            programme.push(&[(normal + 1, -1.0)], 0.0);
            programme.push(&[(normal + 2, -1.0)], 0.0);
            programme.cones.push(SecondOrderConeT(3));
        }
    }
    solve(programme, variables)
}

/// The directions of a force: along the normal and across it.
fn directions(normal: DVec3) -> [DVec3; 3] {
    let (first, second) = normal.any_orthonormal_pair();
    [normal, first, second]
}

/// Adds the rows of one block: twelve bounds on the components of its force and moment. Forces are in units of the
/// weight of the structure, `part` is the block's part of it.
fn balance(
    programme: &mut Programme,
    (number, block, part): (usize, &Block, f64),
    points: &[ContactPoint],
    width: usize,
) {
    let length = block.radius();
    let mut terms: [Vec<(usize, f64)>; 6] = Default::default();
    for (contact, point) in points.iter().enumerate() {
        let sign = if point.pushed == number {
            1.0
        } else if point.bearer == number {
            -1.0
        } else {
            continue;
        };
        let arm = (point.point - block.center) / length;
        for (k, direction) in directions(point.normal).into_iter().take(width).enumerate() {
            let (force, moment) = (direction * sign, arm.cross(direction) * sign);
            let components = force.to_array().into_iter().chain(moment.to_array());
            for (line, value) in terms.iter_mut().zip(components) {
                line.push((1 + width * contact + k, value / part));
            }
        }
    }
    for (component, line) in terms.into_iter().enumerate() {
        let load = if component == 2 { -1.0 } else { 0.0 };
        for sign in [1.0, -1.0] {
            let mut bound: Vec<(usize, f64)> = line.iter().map(|&(column, value)| (column, sign * value)).collect();
            bound.push((0, -1.0));
            programme.push(&bound, -sign * load);
        }
    }
}

fn solve(programme: Programme, variables: usize) -> Result<f64, Box<dyn Error>> {
    let Programme { rows, columns, values, right, cones } = programme;
    let matrix = CscMatrix::new_from_triplets(right.len(), variables, rows, columns, values);
    let objective = CscMatrix::<f64>::zeros((variables, variables));
    let mut linear = vec![0.0; variables];
    linear[0] = 1.0;
    let settings = DefaultSettings::<f64> {
        verbose: false,
        max_iter: 200,
        tol_gap_abs: TOLERANCE,
        tol_gap_rel: TOLERANCE,
        tol_feas: TOLERANCE,
        ..DefaultSettings::default()
    };
    let mut solver = DefaultSolver::new(&objective, &linear, &matrix, &right, &cones, settings)?;
    solver.solve();
    let solution = &solver.solution;
    let status = solution.status;
    match (status, solution.x.first()) {
        (SolverStatus::Solved | SolverStatus::AlmostSolved, Some(&shortfall)) => Ok(shortfall),
        _ => Err(format!("the programme of equilibrium has no answer: {status:?}").into()),
    }
}

#[cfg(test)]
mod tests {
    //! Structures whose limits are known.
    use super::*;

    const AXES: [DVec3; 3] = [DVec3::X, DVec3::Y, DVec3::Z];

    fn floor() -> Block {
        Block::cuboid(DVec3::Z * -1.0, DVec3::new(20.0, 20.0, 2.0), AXES, None)
    }

    /// A brick may overhang another by half its length, and no more.
    #[test]
    fn overhanging_brick_stands_up_to_half_its_length() {
        let edges = DVec3::new(1.0, 0.5, 0.25);
        let lower = Block::cuboid(DVec3::Z * 0.125, edges, AXES, Some(1.0));
        let upper = |x: f64| Block::cuboid(DVec3::new(x, 0.0, 0.375), edges, AXES, Some(1.0));
        let stands = |x: f64| judge(&[floor(), lower.clone(), upper(x)], Friction::Frictionless).expect("a verdict");
        assert_eq!(stands(0.499), Verdict::Feasible);
        assert_eq!(stands(0.501), Verdict::Infeasible);
    }

    /// A brick stays on a slope if and only if friction is at least the tangent of its angle.
    #[test]
    fn brick_on_a_slope_needs_the_tangent_of_its_angle() {
        let (c, s) = (0.8, 0.6);
        let axes = [DVec3::new(c, 0.0, -s), DVec3::Y, DVec3::new(s, 0.0, c)];
        let slope = Block::cuboid(axes[2] * -1.0, DVec3::new(20.0, 20.0, 2.0), axes, None);
        let brick = Block::cuboid(axes[2] * 0.125, DVec3::new(1.0, 0.5, 0.25), axes, Some(3.0));
        let stands = |mu: f64| judge(&[slope.clone(), brick.clone()], Friction::Coefficient(mu)).expect("a verdict");
        assert_eq!(stands(0.7501), Verdict::Feasible);
        assert_eq!(stands(0.7499), Verdict::Infeasible);
        assert_eq!(judge(&[slope, brick], Friction::Frictionless).expect("a verdict"), Verdict::Infeasible);
    }
}
