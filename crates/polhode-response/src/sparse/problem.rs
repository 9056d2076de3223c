//! A contact problem in the velocities of bodies.
//!
//! `M (v - v_free) = H^T r`, `u = H v + b + C r`, and a [`Law`] for the `r` and `u` of each block of rows. `M` is
//! block-diagonal, a row of `H` has entries for one or two bodies, `C >= 0` is diagonal (compliance: 0 for rigid
//! contacts). Nothing couples rows but the bodies that they share: memory grows linearly with rows, however many
//! touch one body.
//!
//! Inside, velocities are `S^-1 v` with `S S^T = M^-1`: masses become 1, whatever their ratio. Symbols and units: `v`
//! (m/s, rad/s), `r` (N s), `u`, `b` (m/s), `C` (1/kg). Source: Acary and Brogliato 2008, chapter 13. Assumption: the
//! rows of one block have one unit. Failure: data that is not finite, of wrong length or out of range is refused with
//! a [`ResponseError`].

use crate::error::{ResponseError, check_finite, check_length};
use crate::law::{Law, MOST_ROWS};
use crate::sparse::block6::{Vector6, WIDTH, add_scaled, dot6};
use crate::sparse::body::{BodyMass, MassFactor};
use crate::tolerances::IMMOVABLE;
use std::ops::Range;

/// Most rows of a hold that is solved as one block; one of more is several.
const HELD_TOGETHER: usize = 3;

/// The rows of one contact or joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyRows<'a> {
    /// What they ask for. A [`Law::Hold`] has 1 to 6 rows here.
    pub law: Law,
    /// One or two bodies, and their part of `H`: 6 numbers for each row.
    pub bodies: &'a [(usize, &'a [f64])],
    /// `b`, one number for each row (m/s).
    pub bias: &'a [f64],
    /// The diagonal of `C`, one number for each row (1/kg); empty for rigid rows.
    pub compliance: &'a [f64],
}

/// One movable body of a block of rows.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Side {
    /// Which of the movable bodies.
    pub(crate) node: usize,
    /// The first of its lines.
    line: usize,
}

/// Rows that are solved together.
#[derive(Debug, Clone)]
pub(crate) struct RowBlock {
    pub(crate) law: Law,
    /// Its rows in `r` and `u`.
    pub(crate) rows: Range<usize>,
    /// Its movable bodies.
    pub(crate) sides: [Option<Side>; 2],
}

impl RowBlock {
    /// Its movable bodies.
    pub(crate) fn movable(&self) -> impl Iterator<Item = Side> + use<> {
        self.sides.into_iter().flatten()
    }
}

/// Bodies, and the rows of contacts and joints between them.
///
/// ```
/// use polhode_response::Law;
/// use polhode_response::sparse::{BodyMass, BodyProblem, BodyRows};
/// // A ball of 2 kg on the ground that comes down with 3 m/s.
/// let ball = BodyMass::rigid(2.0, &[0.1, 0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.1]);
/// let mut problem = BodyProblem::new(&[ball], &[[0.0, 0.0, -3.0, 0.0, 0.0, 0.0]])?;
/// let normal = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
/// problem.push(&BodyRows { law: Law::Push, bodies: &[(0, &normal)], bias: &[0.0], compliance: &[] })?;
/// assert_eq!(problem.rows(), 1);
/// # Ok::<(), polhode_response::ResponseError>(())
/// ```
#[derive(Debug, Clone)]
pub struct BodyProblem {
    /// The movable body of each body.
    nodes: Vec<Option<usize>>,
    factors: Vec<MassFactor>,
    /// Velocities of bodies that are fixed.
    prescribed: Vec<Vector6>,
    /// `S^-1 v_free` of movable bodies.
    pub(crate) free: Vec<Vector6>,
    pub(crate) blocks: Vec<RowBlock>,
    /// `H S`, one line for each row and movable body.
    lines: Vec<Vector6>,
    /// `b`, with what fixed bodies add.
    pub(crate) bias: Vec<f64>,
    /// The diagonal of `C`.
    pub(crate) compliance: Vec<f64>,
    /// The diagonal of `H M^-1 H^T + C` (1/kg).
    diagonal: Vec<f64>,
    /// The first of the blocks that each block given was made into.
    given: Vec<usize>,
}

impl BodyProblem {
    /// A problem without rows; one mass and one velocity `v_free` for each body.
    ///
    /// # Errors
    /// When lengths differ, a number is not finite, or the mass block of a body is not symmetric and positive definite.
    pub fn new(bodies: &[BodyMass], free_velocities: &[[f64; 6]]) -> Result<Self, ResponseError> {
        check_length("free velocities", bodies.len(), free_velocities.len())?;
        check_finite("free velocities", free_velocities.as_flattened())?;
        let mut nodes = Vec::with_capacity(bodies.len());
        let (mut factors, mut free) = (Vec::new(), Vec::new());
        for (body, (mass, velocity)) in bodies.iter().zip(free_velocities).enumerate() {
            let Some(factor) = mass.factor() else {
                nodes.push(None);
                continue;
            };
            check_finite("mass block", mass.block().map_or(&[], |block| &block[..]))?;
            let factor = factor.map_err(|_| ResponseError::BodyMass { body })?;
            nodes.push(Some(factors.len()));
            let mut scaled = *velocity;
            factor.scale_velocity(&mut scaled);
            factors.push(factor);
            free.push(scaled);
        }
        Ok(Self {
            nodes,
            factors,
            prescribed: free_velocities.to_vec(),
            free,
            blocks: Vec::new(),
            lines: Vec::new(),
            bias: Vec::new(),
            compliance: Vec::new(),
            diagonal: Vec::new(),
            given: Vec::new(),
        })
    }

    /// Adds the rows of a contact or joint; returns their place in the reactions.
    ///
    /// # Errors
    /// When the law is out of range, there are no or more than two bodies, none of them moves, one is unknown or
    /// named twice, a length differs, a number is not finite, or a compliance is negative.
    pub fn push(&mut self, rows: &BodyRows<'_>) -> Result<Range<usize>, ResponseError> {
        self.check(rows)?;
        let (first, count) = (self.bias.len(), rows.law.rows());
        let mut bias = rows.bias.to_vec();
        let compliance = if rows.compliance.is_empty() { vec![0.0; count] } else { rows.compliance.to_vec() };
        let mut diagonal = compliance.clone();
        let mut lines = Vec::new();
        let mut sides = [None; 2];
        for (side, &(body, jacobian)) in sides.iter_mut().zip(rows.bodies) {
            let jacobian = jacobian.as_chunks::<WIDTH>().0;
            let Some(node) = self.nodes[body] else {
                for (bias, line) in bias.iter_mut().zip(jacobian) {
                    *bias += dot6(line, &self.prescribed[body]);
                }
                continue;
            };
            *side = Some(Side { node, line: self.lines.len() + lines.len() });
            for (line, diagonal) in jacobian.iter().zip(&mut diagonal) {
                let mut line = *line;
                self.factors[node].scale_row(&mut line);
                *diagonal += dot6(&line, &line);
                lines.push(line);
            }
        }
        check_finite("bias with prescribed velocities", &bias)?;
        check_finite("Jacobian over mass", &diagonal)?;
        self.given.push(self.blocks.len());
        self.bias.append(&mut bias);
        self.compliance.extend(compliance);
        self.diagonal.append(&mut diagonal);
        self.lines.append(&mut lines);
        self.push_blocks(rows.law, first, sides);
        Ok(first..first + count)
    }

    fn push_blocks(&mut self, law: Law, first: usize, sides: [Option<Side>; 2]) {
        let Law::Hold { rows: count } = law else {
            self.blocks.push(RowBlock { law, rows: first..first + law.rows(), sides });
            return;
        };
        for start in (0..count).step_by(HELD_TOGETHER) {
            let end = count.min(start + HELD_TOGETHER);
            let moved = |side: Option<Side>| side.map(|side| Side { line: side.line + start, ..side });
            let law = Law::Hold { rows: end - start };
            self.blocks.push(RowBlock { law, rows: first + start..first + end, sides: sides.map(moved) });
        }
    }

    fn check(&self, rows: &BodyRows<'_>) -> Result<(), ResponseError> {
        let (count, block) = (rows.law.rows(), self.given.len());
        match rows.law {
            Law::Hold { rows } if (1..=MOST_ROWS).contains(&rows) => {}
            law => law.check(block)?,
        }
        check_length("bias", count, rows.bias.len())?;
        check_finite("bias", rows.bias)?;
        if !rows.compliance.is_empty() {
            check_length("compliance", count, rows.compliance.len())?;
            check_finite("compliance", rows.compliance)?;
            if let Some(&value) = rows.compliance.iter().find(|value| **value < 0.0) {
                return Err(ResponseError::Setting { field: "compliance", accepted: "at least 0", value });
            }
        }
        let mut movable = 0;
        for (place, &(body, jacobian)) in rows.bodies.iter().enumerate() {
            let bodies = self.nodes.len();
            let node = self.nodes.get(body).ok_or(ResponseError::UnknownBody { body, bodies })?;
            if rows.bodies[..place].iter().any(|(other, _)| *other == body) {
                return Err(ResponseError::RepeatedBody { body });
            }
            check_length("Jacobian of a body", WIDTH * count, jacobian.len())?;
            check_finite("Jacobian of a body", jacobian)?;
            movable += usize::from(node.is_some());
        }
        if movable == 0 || rows.bodies.len() > 2 {
            return Err(ResponseError::RowBodies(movable));
        }
        Ok(())
    }

    /// Number of bodies.
    pub fn bodies(&self) -> usize {
        self.nodes.len()
    }

    /// Number of bodies that move.
    pub fn movable_bodies(&self) -> usize {
        self.free.len()
    }

    /// Number of contacts and joints.
    pub fn len(&self) -> usize {
        self.given.len()
    }

    /// Whether there is no contact or joint.
    pub fn is_empty(&self) -> bool {
        self.given.is_empty()
    }

    /// Number of rows of all contacts and joints.
    pub fn rows(&self) -> usize {
        self.bias.len()
    }

    /// Other velocities `v_free` for the same bodies and rows. Those of bodies that are fixed are part of the rows,
    /// and stay.
    ///
    /// # Errors
    /// When there is not one for each body, or a number is not finite.
    pub fn set_free_velocities(&mut self, free_velocities: &[[f64; 6]]) -> Result<(), ResponseError> {
        check_length("free velocities", self.nodes.len(), free_velocities.len())?;
        check_finite("free velocities", free_velocities.as_flattened())?;
        for (node, velocity) in self.nodes.iter().zip(free_velocities) {
            if let Some(node) = *node {
                let mut scaled = *velocity;
                self.factors[node].scale_velocity(&mut scaled);
                self.free[node] = scaled;
            }
        }
        Ok(())
    }

    /// The block that holds the first rows of each contact and joint given.
    pub(crate) fn given(&self) -> &[usize] {
        &self.given
    }

    /// The lines of one body of a block.
    pub(crate) fn lines(&self, block: &RowBlock, side: Side) -> &[Vector6] {
        &self.lines[side.line..side.line + block.rows.len()]
    }

    /// `1 / rho` of a row: the diagonal of `H M^-1 H^T + C`.
    pub(crate) fn diagonal(&self, row: usize) -> f64 {
        self.diagonal[row]
    }

    /// `1 / rho` of each block: that of its first row, above 0.
    pub(crate) fn inverse_masses(&self) -> Vec<f64> {
        let most = self.diagonal.iter().fold(0.0, |most: f64, value| most.max(*value));
        let least = if most > 0.0 { IMMOVABLE * most } else { 1.0 };
        let of = |block: &RowBlock| {
            let own = self.diagonal[block.rows.start];
            if own > 0.0 { own } else { least }
        };
        self.blocks.iter().map(of).collect()
    }

    /// `H v` of one block, added to `u`.
    pub(crate) fn add_rates(&self, block: &RowBlock, v: &[Vector6], u: &mut [f64]) {
        for side in block.movable() {
            for (u, line) in u.iter_mut().zip(self.lines(block, side)) {
                *u += dot6(line, &v[side.node]);
            }
        }
    }

    /// `H^T r` of one block, added to `v`.
    pub(crate) fn add_impulses(&self, block: &RowBlock, r: &[f64], v: &mut [Vector6]) {
        for side in block.movable() {
            let target = &mut v[side.node];
            for (&r, line) in r.iter().zip(self.lines(block, side)) {
                add_scaled(r, line, target);
            }
        }
    }

    /// `v_free + M^-1 H^T r`, scaled.
    pub(crate) fn scaled_velocities(&self, reactions: &[f64], v: &mut Vec<Vector6>) {
        v.clear();
        v.extend_from_slice(&self.free);
        for block in &self.blocks {
            self.add_impulses(block, &reactions[block.rows.clone()], v);
        }
    }

    /// `u = H v + b + C r` of all rows.
    pub(crate) fn rates(&self, v: &[Vector6], reactions: &[f64], u: &mut Vec<f64>) {
        u.clear();
        u.extend(self.bias.iter().zip(&self.compliance).zip(reactions).map(|((b, c), r)| b + c * r));
        for block in &self.blocks {
            self.add_rates(block, v, &mut u[block.rows.clone()]);
        }
    }

    /// The velocity of every body from the scaled ones of those that move.
    pub(crate) fn velocities_of_bodies(&self, scaled: &[Vector6]) -> Vec<[f64; 6]> {
        let of = |(node, prescribed): (&Option<usize>, &Vector6)| {
            node.map_or(*prescribed, |node| {
                let mut velocity = scaled[node];
                self.factors[node].unscale_velocity(&mut velocity);
                velocity
            })
        };
        self.nodes.iter().zip(&self.prescribed).map(of).collect()
    }
}
