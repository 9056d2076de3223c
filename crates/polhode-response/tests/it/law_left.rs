//! How far reactions are from the laws of their blocks: an oracle that shares nothing with the solvers.
//!
//! Velocities are summed from Jacobians and inverse masses, `u = J M^-1 J^T r + C r + b`. The laws are those of `Law`,
//! each as an equation of projections (Alart and Curnier 1991), not as the solvers write them: with `g` the mobility of
//! the normal row, `g r_n = max(0, g r_n - u_n)` of what pushes, `g r_t = P(g r_t - u_t)` with `P` the projection on
//! the disc of radius `mu max(0, g r_n - u_n)` of what resists, `u = 0` of what holds. What is left is a velocity, told
//! as a part of the largest one without reactions.

use polhode_response::Law;
use polhode_response::problem_text::{ProblemText, TextBlock};

/// Mobility of a row that nothing moves, as a part of the largest (no unit).
const IMMOVABLE: f64 = 1e-3;

/// Velocities (accelerations) of all rows with these reactions, block by block.
pub(crate) fn velocities(problem: &ProblemText, reactions: &[f64]) -> Vec<f64> {
    let pushed = on_bodies(problem, reactions);
    let moved: Vec<Vec<f64>> = (0..).zip(&pushed).map(|(body, pushed)| times(problem, body, pushed)).collect();
    let rows = problem.blocks.iter().flat_map(|block| &block.rows);
    let rates = rows.zip(reactions).zip(0..).map(|((row, reaction), number)| {
        let along: f64 = jacobians(problem, number).iter().map(|(body, own)| dot(own, &moved[*body])).sum();
        row.constant + along + row.compliance * reaction
    });
    rates.collect()
}

/// What is left of the laws (no unit); infinite where reactions are no numbers.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Left {
    /// The largest velocity, relative to the largest one without reactions.
    pub(crate) rates: f64,
    /// The largest impulse that would give it, relative to the largest reaction, or to the largest that would stop a
    /// row on its own where that is larger.
    pub(crate) impulses: f64,
}

/// What reactions leave of the laws.
pub(crate) fn left(problem: &ProblemText, reactions: &[f64]) -> Left {
    let rates = velocities(problem, reactions);
    let mobilities = mobilities(problem);
    let least = IMMOVABLE * mobilities.iter().copied().fold(0.0, f64::max);
    let size = size(problem);
    let mut most = Left::default();
    let (mut first, mut impulse) = (0, reactions.iter().fold(0.0, |most: f64, own| most.max(own.abs())));
    for block in &problem.blocks {
        let own = first..first + block.rows.len();
        let mobility = if mobilities[first] > 0.0 { mobilities[first] } else { least };
        let missed = missed(block, mobility, &reactions[own.clone()], &rates[own.clone()]);
        // Written so that NaN is infinite.
        let missed = if missed >= 0.0 { missed } else { f64::INFINITY };
        let approach = if block.law.pushes() { -block.rows[0].constant } else { block.rows[0].constant.abs() };
        impulse = f64::max(impulse, approach / mobility);
        most = Left { rates: most.rates.max(missed), impulses: most.impulses.max(missed / mobility) };
        first = own.end;
    }
    let part = |left: f64, of: f64| if left == 0.0 { 0.0 } else { left / of };
    Left { rates: part(most.rates, size), impulses: part(most.impulses, impulse) }
}

/// The largest constant term.
pub(crate) fn size(problem: &ProblemText) -> f64 {
    problem.blocks.iter().flat_map(|block| &block.rows).fold(0.0, |most: f64, row| most.max(row.constant.abs()))
}

/// What is missed by one block, as a velocity.
fn missed(block: &TextBlock, mobility: f64, reactions: &[f64], rates: &[f64]) -> f64 {
    if !reactions.iter().chain(rates).all(|own| own.is_finite()) {
        return f64::INFINITY;
    }
    let parts = match block.law {
        Law::Hold { .. } => return rates.iter().fold(0.0, |most: f64, rate| most.max(rate.abs())),
        Law::Push => Vec::new(),
        Law::Cone { rows, friction } => vec![(rows - 1, friction, false)],
        Law::Slide { friction } => vec![(1, friction, true)],
        Law::Resist { parts } => parts.iter().map(|part| (part.rows, part.friction, part.slides)).collect(),
        other => panic!("no law is known for {other:?}"),
    };
    let normal = (mobility * reactions[0] - rates[0]).max(0.0);
    let mut worst = (mobility * reactions[0] - normal).abs();
    let mut first = 1;
    for (rows, friction, slides) in parts {
        let own = first..first + rows;
        first = own.end;
        let wanted: Vec<f64> = if slides {
            own.clone().map(|_| -friction * normal).collect()
        } else {
            let aim: Vec<f64> = own.clone().map(|row| mobility * reactions[row] - rates[row]).collect();
            let length = dot(&aim, &aim).sqrt();
            let shorter = if length > friction * normal { friction * normal / length } else { 1.0 };
            aim.iter().map(|aim| aim * shorter).collect()
        };
        let apart: Vec<f64> = own.zip(wanted).map(|(row, wanted)| mobility * reactions[row] - wanted).collect();
        worst = worst.max(dot(&apart, &apart).sqrt());
    }
    worst
}

/// What reactions add up to on each body.
fn on_bodies(problem: &ProblemText, reactions: &[f64]) -> Vec<Vec<f64>> {
    let mut pushed = vec![vec![0.0; problem.width]; problem.inverse_masses.len()];
    for (number, reaction) in reactions.iter().enumerate() {
        for (body, own) in jacobians(problem, number) {
            pushed[body].iter_mut().zip(own).for_each(|(sum, own)| *sum += own * reaction);
        }
    }
    pushed
}

/// The bodies of a row with its Jacobian there: the unit vector of its number where it names none.
fn jacobians(problem: &ProblemText, number: usize) -> Vec<(usize, Vec<f64>)> {
    let Some(row) = problem.blocks.iter().flat_map(|block| &block.rows).nth(number) else { return Vec::new() };
    if !row.entries.is_empty() {
        return row.entries.clone();
    }
    let unit = (0..problem.width).map(|place| f64::from(u8::from(place == number)));
    vec![(0, unit.collect())]
}

/// The inverse mass of a body times a load.
fn times(problem: &ProblemText, body: usize, load: &[f64]) -> Vec<f64> {
    problem.inverse_masses[body].chunks_exact(problem.width).map(|line| dot(line, load)).collect()
}

/// The velocity of each row by a unit reaction of its own.
fn mobilities(problem: &ProblemText) -> Vec<f64> {
    let rows = problem.blocks.iter().flat_map(|block| &block.rows).enumerate();
    let of_row = |number: usize| {
        let mut own: Vec<Vec<f64>> = vec![Vec::new(); problem.inverse_masses.len()];
        for (body, jacobian) in jacobians(problem, number) {
            own[body].resize(problem.width, 0.0);
            own[body].iter_mut().zip(jacobian).for_each(|(sum, own)| *sum += own);
        }
        let moved = own.iter().enumerate().filter(|(_, own)| !own.is_empty());
        moved.map(|(body, own)| dot(own, &times(problem, body, own))).sum::<f64>()
    };
    rows.map(|(number, row)| of_row(number) + row.compliance).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
