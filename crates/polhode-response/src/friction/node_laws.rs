//! The linearised laws of the nodes of an elimination: one step of Newton's method as a system between nodes.
//!
//! With `G_gh = A_g H_gh C_h^T` ([`NodeMatrix`]) the step `S (G + D) T y = b` reads, node by node,
//!
//! ```text
//! L_g v_g + D_g y_g = b_g,   v_g = sum_h H_gh w_h,   w_g = R_g^T y_g,   L = S A,   R^T = C^T T
//! ```
//!
//! A node with no more unknowns `y` than independent rows is eliminated as it stands. Of another one, four corners that
//! stick, `y` is eliminated beforehand and `w` is left, which stands for the force and the moment of the corners
//! together:
//!
//! ```text
//! w_g + K_g v_g = R_g^T D_g^-1 b_g,   K_g = R_g^T D_g^-1 L_g
//! ```
//!
//! What of `y` moves nothing, `R^T y = 0`, is damped more than the rest: `b` has rounding there and what the data
//! contradict each other by, which damping that vanishes would turn into reactions that wander from step to step. With
//! the damping `D'` in the place of `D`, `y = D'^-1 (b - L x)`, where `x` is such that `R^T y = w`. Where damping is
//! large anyway, `D' = D` and `x = v`: the iterates are those of the whole system. Assumption: `D > 0`, which damping
//! sees to.

use crate::dense::kernels::{axpy, short_dot};
use crate::dense::small::solve_small;
use crate::friction::elimination_order::EliminationOrder;
use crate::friction::linearisation::{ContactStatus, Linearised};
use crate::friction::multifrontal::NodeSystem;
use crate::friction::node_matrix::NodeMatrix;
use std::ops::Range;

/// Pivots below this fraction of the largest depend on the others (no unit): contacts along a line have no moment about
/// it.
const DEPENDENT_LAW: f64 = 1e-11;

/// Least share of the diagonal that damps what moves nothing within a node (no unit, 0 to 1e-6): rounding and data that
/// contradict each other by 1e-13 then move no reaction by more than 1e-7 of what stops a contact. More of it keeps
/// corners from sharing a load anew: 1e-3 takes twice the steps for heaps of boxes.
const LEAST_NODE_DAMPING: f64 = 1e-6;

/// The system of one step.
#[derive(Debug, Clone, Default)]
pub(crate) struct NodeLaws {
    nodes: Vec<NodeLaw>,
    /// Of all unknowns `y`, node after node.
    unknowns: Vec<Unknown>,
    /// Entries of `L` and of `R` of the unknowns.
    left: Vec<f64>,
    right: Vec<f64>,
    /// `K`, row-major, of nodes that are condensed, one after the other, each times the least `D` of the node.
    condensed: Vec<f64>,
    /// A row of a product, or `w` of one node.
    line: Vec<f64>,
    /// `v` of all nodes, or `x` of one.
    velocities: Vec<f64>,
    /// `R^T D'^-1 L` of one node.
    square: Vec<f64>,
}

/// A node's part.
#[derive(Debug, Clone, Default)]
struct NodeLaw {
    /// Its unknowns `y`.
    unknowns: Range<usize>,
    form: Form,
}

#[derive(Debug, Clone, Copy, Default, PartialEq)]
enum Form {
    /// All rows are held, and all are unknowns: `L` and `R` are the identity.
    #[default]
    Held,
    /// The unknowns are `y`.
    Plain,
    /// The unknowns are `w`.
    Condensed {
        /// Where `K` begins.
        at: usize,
        /// The least `D`, which the rows are multiplied by (1/kg).
        scale: f64,
    },
}

/// An unknown `y`, with its equation.
#[derive(Debug, Clone, Copy, Default)]
struct Unknown {
    /// Where its entries of `L` and `R` begin.
    at: usize,
    /// The first reduced row of the node that they belong to.
    first: usize,
    /// How many.
    count: usize,
    /// `D` (1/kg).
    diagonal: f64,
    /// `D'` (1/kg).
    within: f64,
    /// `b`.
    side: f64,
}

/// What the laws are taken from.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LawsOfBlocks<'a> {
    pub(crate) matrix: &'a NodeMatrix,
    pub(crate) order: &'a EliminationOrder,
    pub(crate) laws: &'a [Linearised],
    /// Rows of each block.
    pub(crate) sizes: &'a [usize],
    /// Share of the diagonal that is added.
    pub(crate) damping: f64,
}

impl NodeLaws {
    /// Sets up the system of a step.
    pub(crate) fn fill(&mut self, of: LawsOfBlocks<'_>) {
        self.nodes.clear();
        self.unknowns.clear();
        self.left.clear();
        self.right.clear();
        self.condensed.clear();
        for (node, blocks) in of.order.nodes.iter().enumerate() {
            self.push_node(node, blocks, of);
        }
        self.take_shifts(of);
        for node in 0..self.nodes.len() {
            let law = &self.nodes[node];
            if law.unknowns.len() > of.matrix.rank(node) {
                self.condense(node, of.matrix.rank(node));
            }
        }
    }

    fn push_node(&mut self, node: usize, blocks: &[usize], of: LawsOfBlocks<'_>) {
        let start = self.unknowns.len();
        let rank = of.matrix.rank(node);
        let (rows, columns) = (of.matrix.row_expansion(node), of.matrix.column_expansion(node));
        let mut first = 0;
        let mut is_held = rows.is_none();
        for &block in blocks {
            let (law, size) = (&of.laws[block], of.sizes[block]);
            is_held &= law.status == ContactStatus::Stick && law.unknowns == size;
            for k in 0..law.unknowns {
                let at = self.left.len();
                let count = if let (Some(rows), Some(columns)) = (rows, columns) {
                    push_combination(&law.rows[k], &rows[first * rank..(first + size) * rank], &mut self.left, rank);
                    let columns = &columns[first * rank..(first + size) * rank];
                    push_combination(&law.columns[k], columns, &mut self.right, rank);
                    rank
                } else {
                    self.left.extend_from_slice(&law.rows[k][..size]);
                    self.right.extend_from_slice(&law.columns[k][..size]);
                    size
                };
                let inverse_mass = law.inverse_masses[k];
                let diagonal = law.diagonal[k] + of.damping * inverse_mass;
                let within = law.diagonal[k] + of.damping.max(LEAST_NODE_DAMPING) * inverse_mass;
                let first = if rows.is_some() { 0 } else { first };
                self.unknowns.push(Unknown { at, first, count, diagonal, within, side: law.right[k] });
            }
            first += size;
        }
        let form = if is_held { Form::Held } else { Form::Plain };
        self.nodes.push(NodeLaw { unknowns: start..self.unknowns.len(), form });
    }

    /// Takes what the shifts do to the velocities from the right sides.
    fn take_shifts(&mut self, of: LawsOfBlocks<'_>) {
        let matrix = of.matrix;
        self.velocities.clear();
        self.velocities.resize(matrix.rows(), 0.0);
        let mut any = false;
        for (node, blocks) in of.order.nodes.iter().enumerate() {
            if !blocks.iter().any(|&block| of.laws[block].shift.iter().any(|shift| *shift != 0.0)) {
                continue;
            }
            any = true;
            self.set_shift(node, blocks, of);
            for coupling in matrix.couplings(node) {
                let other = matrix.other(coupling);
                let lines = matrix.values(matrix.mirror(coupling)).chunks_exact(self.line.len());
                for (target, line) in self.velocities[matrix.range(other)].iter_mut().zip(lines) {
                    *target += short_dot(line, &self.line);
                }
            }
        }
        if any {
            for (node, law) in self.nodes.iter().enumerate() {
                let velocities = &self.velocities[matrix.range(node)];
                for unknown in &mut self.unknowns[law.unknowns.clone()] {
                    unknown.side -= unknown.of(&self.left, velocities);
                }
            }
        }
    }

    /// Sets `C^T shift` of a node.
    fn set_shift(&mut self, node: usize, blocks: &[usize], of: LawsOfBlocks<'_>) {
        let rank = of.matrix.rank(node);
        self.line.clear();
        self.line.resize(rank, 0.0);
        let mut first = 0;
        for &block in blocks {
            for (row, &shift) in of.laws[block].shift[..of.sizes[block]].iter().enumerate() {
                match of.matrix.column_expansion(node) {
                    Some(columns) => axpy(shift, &columns[(first + row) * rank..], &mut self.line),
                    None => self.line[first + row] += shift,
                }
            }
            first += of.sizes[block];
        }
    }

    fn condense(&mut self, node: usize, rank: usize) {
        let unknowns = &self.unknowns[self.nodes[node].unknowns.clone()];
        let scale = unknowns.iter().fold(f64::INFINITY, |least, unknown| least.min(unknown.diagonal));
        let at = self.condensed.len();
        self.condensed.resize(at + rank * rank, 0.0);
        for unknown in unknowns {
            let (left, right) = (unknown.entries(&self.left), unknown.entries(&self.right));
            add_outer_product(scale / unknown.diagonal, right, left, &mut self.condensed[at..]);
        }
        self.nodes[node].form = Form::Condensed { at, scale };
    }

    /// Right sides of the elimination, node after node.
    pub(crate) fn right_sides(&self, matrix: &NodeMatrix, sides: &mut Vec<f64>) {
        sides.clear();
        for (node, law) in self.nodes.iter().enumerate() {
            let unknowns = &self.unknowns[law.unknowns.clone()];
            let Form::Condensed { scale, .. } = law.form else {
                sides.extend(unknowns.iter().map(|unknown| unknown.side));
                continue;
            };
            let start = sides.len();
            sides.resize(start + matrix.rank(node), 0.0);
            for unknown in unknowns {
                let factor = scale / unknown.diagonal * unknown.side;
                axpy(factor, unknown.entries(&self.right), &mut sides[start..]);
            }
        }
    }

    /// The changes `dr = T y + shift` of all reactions, from what the elimination gives; `first` is the first row of
    /// each block.
    pub(crate) fn changes(
        &mut self,
        of: LawsOfBlocks<'_>,
        first: impl Fn(usize) -> usize,
        solved: &[f64],
        dr: &mut [f64],
    ) {
        let mut place = 0;
        let mut own = Vec::new();
        for (node, blocks) in of.order.nodes.iter().enumerate() {
            let law = &self.nodes[node];
            let count = if law.is_condensed() { of.matrix.rank(node) } else { law.unknowns.len() };
            let found = &solved[place..place + count];
            place += count;
            own.clear();
            if law.is_condensed() {
                self.push_within(law.unknowns.clone(), found, &mut own);
            } else {
                own.extend_from_slice(found);
            }
            let mut next = own.iter();
            for &block in blocks {
                let law = &of.laws[block];
                let (mut change, size) = (law.shift, of.sizes[block]);
                for (column, y) in law.columns[..law.unknowns].iter().zip(&mut next) {
                    for (change, value) in change.iter_mut().zip(&column[..size]) {
                        *change += value * y;
                    }
                }
                dr[first(block)..first(block) + size].copy_from_slice(&change[..size]);
            }
        }
    }

    /// Appends `y` of a node that is condensed, of which `w` is known.
    fn push_within(&mut self, unknowns: Range<usize>, w: &[f64], own: &mut Vec<f64>) {
        let Self { unknowns: all, left, right, velocities, square, .. } = self;
        let (unknowns, rank) = (&all[unknowns], w.len());
        square.clear();
        square.resize(rank * rank, 0.0);
        velocities.clear();
        velocities.extend(w.iter().map(|w| -w));
        for unknown in unknowns {
            let (left, right) = (unknown.entries(left), unknown.entries(right));
            axpy(unknown.side / unknown.within, right, velocities);
            add_outer_product(1.0 / unknown.within, right, left, square);
        }
        solve_small(square, velocities, DEPENDENT_LAW);
        own.extend(unknowns.iter().map(|unknown| (unknown.side - unknown.of(left, velocities)) / unknown.within));
    }
}

impl NodeLaw {
    fn is_condensed(&self) -> bool {
        matches!(self.form, Form::Condensed { .. })
    }
}

impl Unknown {
    fn entries(self, of: &[f64]) -> &[f64] {
        &of[self.at..self.at + self.count]
    }

    /// Its row of `L` (or `R`) times a vector of the node.
    fn of(self, entries: &[f64], x: &[f64]) -> f64 {
        short_dot(self.entries(entries), &x[self.first..])
    }
}

/// `sum += factor x y^T`, row-major.
fn add_outer_product(factor: f64, x: &[f64], y: &[f64], sum: &mut [f64]) {
    if let &[a, b, c, d, e, f] = y {
        let y = [a, b, c, d, e, f];
        for (line, x) in sum.as_chunks_mut::<6>().0.iter_mut().zip(x) {
            for (sum, y) in line.iter_mut().zip(y) {
                *sum += factor * x * y;
            }
        }
        return;
    }
    for (line, x) in sum.chunks_exact_mut(y.len().max(1)).zip(x) {
        axpy(factor * x, y, line);
    }
}

/// Appends `sum_k weight_k line_k` of lines of `rank` numbers.
fn push_combination(weights: &[f64], lines: &[f64], target: &mut Vec<f64>, rank: usize) {
    let start = target.len();
    target.resize(start + rank, 0.0);
    for (weight, line) in weights.iter().zip(lines.chunks_exact(rank)).filter(|(weight, _)| **weight != 0.0) {
        axpy(*weight, line, &mut target[start..]);
    }
}

/// The system with the operator between nodes.
#[derive(Debug)]
pub(crate) struct StepSystem<'a> {
    pub(crate) laws: &'a mut NodeLaws,
    pub(crate) matrix: &'a NodeMatrix,
}

impl NodeSystem for StepSystem<'_> {
    fn unknowns(&self, node: usize) -> usize {
        let law = &self.laws.nodes[node];
        if law.is_condensed() { self.matrix.rank(node) } else { law.unknowns.len() }
    }

    fn write(&mut self, node: usize, coupling: usize, stride: usize, target: &mut [f64]) {
        let other = self.matrix.other(coupling);
        match self.matrix.rank(other) {
            1 => self.write_rows::<1>(node, coupling, stride, target),
            2 => self.write_rows::<2>(node, coupling, stride, target),
            3 => self.write_rows::<3>(node, coupling, stride, target),
            4 => self.write_rows::<4>(node, coupling, stride, target),
            6 => self.write_rows::<6>(node, coupling, stride, target),
            9 => self.write_rows::<9>(node, coupling, stride, target),
            12 => self.write_rows::<12>(node, coupling, stride, target),
            _ => self.write_wide_rows(node, coupling, stride, target),
        }
        if node == other {
            let laws = &self.laws;
            let law = &laws.nodes[node];
            for i in 0..self.unknowns(node) {
                target[i * stride + i] += match law.form {
                    Form::Condensed { scale, .. } => scale,
                    _ => laws.unknowns[law.unknowns.start + i].diagonal,
                };
            }
        }
    }
}

impl StepSystem<'_> {
    /// The entries of a row of `L` (or `K`) of a node, and the reduced row that they begin at.
    fn left(&self, node: usize, row: usize) -> (&[f64], usize) {
        let laws = &self.laws;
        let law = &laws.nodes[node];
        match law.form {
            Form::Held => (&[1.0], row),
            Form::Plain => {
                let unknown = laws.unknowns[law.unknowns.start + row];
                (unknown.entries(&laws.left), unknown.first)
            }
            Form::Condensed { at, .. } => {
                let rank = self.matrix.rank(node);
                (&laws.condensed[at + row * rank..at + (row + 1) * rank], 0)
            }
        }
    }

    /// Writes `L H R^T` of a coupling with a node of `W` reduced rows: loops over them are unrolled.
    fn write_rows<const W: usize>(&self, node: usize, coupling: usize, stride: usize, target: &mut [f64]) {
        let lines = self.matrix.values(coupling).as_chunks::<W>().0;
        let other = &self.laws.nodes[self.matrix.other(coupling)];
        let unknowns = &self.laws.unknowns[other.unknowns.clone()];
        for row in 0..self.unknowns(node) {
            let (entries, first) = self.left(node, row);
            let mut product = [0.0; W];
            for (weight, line) in entries.iter().zip(&lines[first..]) {
                for (sum, value) in product.iter_mut().zip(line) {
                    *sum += weight * value;
                }
            }
            let target = &mut target[row * stride..];
            if other.form == Form::Plain {
                for (target, unknown) in target.iter_mut().zip(unknowns) {
                    let right = unknown.entries(&self.laws.right);
                    *target = match (right, product[unknown.first..].first_chunk::<3>()) {
                        (&[x, y, z], Some(own)) => x * own[0] + y * own[1] + z * own[2],
                        _ => short_dot(right, &product[unknown.first..]),
                    };
                }
            } else {
                target[..W].copy_from_slice(&product);
            }
        }
    }

    /// The same for any number of them.
    fn write_wide_rows(&mut self, node: usize, coupling: usize, stride: usize, target: &mut [f64]) {
        let other = self.matrix.other(coupling);
        let width = self.matrix.rank(other);
        let mut product = std::mem::take(&mut self.laws.line);
        for row in 0..self.unknowns(node) {
            let (entries, first) = self.left(node, row);
            product.clear();
            product.resize(width, 0.0);
            let lines = self.matrix.values(coupling)[first * width..].chunks_exact(width);
            for (weight, line) in entries.iter().zip(lines) {
                axpy(*weight, line, &mut product);
            }
            let target = &mut target[row * stride..];
            let law = &self.laws.nodes[other];
            if law.form == Form::Plain {
                for (target, unknown) in target.iter_mut().zip(&self.laws.unknowns[law.unknowns.clone()]) {
                    *target = unknown.of(&self.laws.right, &product);
                }
            } else {
                target[..width].copy_from_slice(&product);
            }
        }
        self.laws.line = product;
    }
}
