//! Sparse elimination: `A x = b` for a matrix in blocks whose pattern is symmetric and whose values need not be.
//!
//! Fronts are eliminated in a given order; each gathers the rows and columns of its nodes, and what its children in the
//! elimination tree have left of theirs, into one dense matrix, eliminates the unknowns of its nodes there (the largest
//! pivot of the rows of a node first) and leaves the rest to its parent. All arithmetic is dense and in a fixed order.
//! Sources: Duff and Reid 1983 (multifrontal method); Liu 1990 (elimination tree).

use crate::dense::kernels::{axpy, dot};
use crate::friction::elimination_order::EliminationOrder;
use crate::friction::node_matrix::NodeMatrix;
use crate::tolerances::VANISHING_PIVOT;
use std::ops::Range;

/// The factors, with the memory of one factorisation for the next.
#[derive(Debug, Clone, Default)]
pub(crate) struct Multifrontal {
    /// First unknown of each node; one more entry than nodes.
    starts: Vec<usize>,
    /// First factor of each front: its own rows, `own x size`, and then the rows below, `(size - own) x own`.
    factors_at: Vec<usize>,
    factors: Vec<f64>,
    /// Which row of its front the pivot of each unknown was taken from.
    pivots: Vec<usize>,
    /// Rows of each front.
    sizes: Vec<usize>,
    /// What each front has left for its parent.
    rests: Vec<Vec<f64>>,
    /// Memory of rests that were taken.
    spare: Vec<Vec<f64>>,
    front: Vec<f64>,
    rows: Vec<f64>,
    /// First row of each node in the front at hand.
    places: Vec<usize>,
    /// Rows of the front at hand that those of a child are added to.
    runs: Vec<Range<usize>>,
    /// The front of each node.
    front_of: Vec<usize>,
    /// The children of each front whose rests wait.
    children: Vec<Vec<usize>>,
}

/// What a matrix between nodes shows of itself to be eliminated; its pattern is that of a [`NodeMatrix`].
pub(crate) trait NodeSystem {
    /// Unknowns of a node; 0 leaves it out.
    fn unknowns(&self, node: usize) -> usize;

    /// Writes the entries of the rows of a node in the columns of the other one of a coupling, row-major with `stride`
    /// numbers from row to row.
    fn write(&mut self, node: usize, coupling: usize, stride: usize, target: &mut [f64]);
}

impl Multifrontal {
    /// Factorises.
    pub(crate) fn factor(&mut self, order: &EliminationOrder, matrix: &NodeMatrix, system: &mut impl NodeSystem) {
        self.clear(order, system);
        for (index, nodes) in order.fronts.iter().enumerate() {
            self.factors_at.push(self.factors.len());
            let own = self.own(nodes);
            if own == 0 {
                self.sizes.push(0);
                continue;
            }
            let size = self.place(nodes, &order.later[index]);
            self.sizes.push(size);
            self.front.clear();
            self.front.resize(size * size, 0.0);
            self.assemble(nodes, size, matrix, system);
            let mut children = std::mem::take(&mut self.children[index]);
            for child in children.drain(..) {
                self.add_child(&order.fronts[child], &order.later[child], child, size);
            }
            self.children[index] = children;
            self.eliminate(nodes, size);
            self.store(index, size, own);
            // The parent of a front is that of the first later node that has unknowns.
            if let Some(&parent) = order.later[index].iter().find(|&&later| self.count(later) > 0) {
                self.children[self.front_of[parent]].push(index);
            }
        }
    }

    /// Takes in how many unknowns each node has, and empties the rest.
    fn clear(&mut self, order: &EliminationOrder, system: &impl NodeSystem) {
        let count = order.nodes.len();
        self.starts.clear();
        self.starts.push(0);
        let mut unknowns = 0;
        for node in 0..count {
            unknowns += system.unknowns(node);
            self.starts.push(unknowns);
        }
        self.front_of.clear();
        for (index, nodes) in order.fronts.iter().enumerate() {
            self.front_of.resize(nodes.end, index);
        }
        self.factors.clear();
        self.factors_at.clear();
        self.pivots.clear();
        self.sizes.clear();
        self.rests.resize(order.fronts.len(), Vec::new());
        self.children.resize(order.fronts.len(), Vec::new());
        self.places.resize(count, 0);
    }

    /// `A^-1 b`, in place; unknowns by node, in the order of elimination.
    pub(crate) fn solve(&mut self, order: &EliminationOrder, b: &mut [f64]) {
        let mut rows = std::mem::take(&mut self.rows);
        for (index, nodes) in order.fronts.iter().enumerate() {
            let (size, own) = (self.sizes[index], self.own(nodes));
            if own == 0 {
                continue;
            }
            self.gather(nodes, &order.later[index], b, &mut rows);
            let factors = &self.factors[self.factors_at[index]..];
            for k in 0..own {
                rows.swap(k, self.pivots[self.starts[nodes.start] + k]);
            }
            for k in 0..own {
                rows[k] -= dot(&factors[k * size..k * size + k], &rows[..k]);
            }
            let (known, below) = rows.split_at_mut(own);
            for (target, line) in below.iter_mut().zip(factors[own * size..].chunks_exact(own)) {
                *target -= dot(line, known);
            }
            self.scatter(nodes, &order.later[index], &rows, b);
        }
        for (index, nodes) in order.fronts.iter().enumerate().rev() {
            let (size, own) = (self.sizes[index], self.own(nodes));
            if own == 0 {
                continue;
            }
            self.gather(nodes, &order.later[index], b, &mut rows);
            let factors = &self.factors[self.factors_at[index]..];
            for k in (0..own).rev() {
                let line = &factors[k * size..(k + 1) * size];
                rows[k] = (rows[k] - dot(&line[k + 1..], &rows[k + 1..size])) / line[k];
            }
            b[self.starts[nodes.start]..self.starts[nodes.end]].copy_from_slice(&rows[..own]);
        }
        self.rows = rows;
    }

    /// Unknowns of a front.
    fn own(&self, nodes: &Range<usize>) -> usize {
        self.starts[nodes.end] - self.starts[nodes.start]
    }

    /// Unknowns of a node.
    fn count(&self, node: usize) -> usize {
        self.starts[node + 1] - self.starts[node]
    }

    /// Sets the places of a front; returns its rows.
    fn place(&mut self, nodes: &Range<usize>, later: &[usize]) -> usize {
        let mut at = 0;
        for member in nodes.clone().chain(later.iter().copied()) {
            self.places[member] = at;
            at += self.count(member);
        }
        at
    }

    /// Writes the entries of the matrix in the rows and columns of a front.
    fn assemble(&mut self, nodes: &Range<usize>, size: usize, matrix: &NodeMatrix, system: &mut impl NodeSystem) {
        for node in nodes.clone() {
            if self.count(node) == 0 {
                continue;
            }
            let row = self.places[node];
            for coupling in matrix.couplings(node) {
                let other = matrix.other(coupling);
                if other < nodes.start || self.count(other) == 0 {
                    continue;
                }
                let column = self.places[other];
                system.write(node, coupling, size, &mut self.front[row * size + column..]);
                if other >= nodes.end {
                    system.write(other, matrix.mirror(coupling), size, &mut self.front[column * size + row..]);
                }
            }
        }
    }

    /// Adds what a child has left.
    fn add_child(&mut self, nodes: &Range<usize>, later: &[usize], child: usize, size: usize) {
        let rest = std::mem::take(&mut self.rests[child]);
        let width = self.sizes[child] - self.own(nodes);
        // Nodes that follow each other here and there are one run.
        let mut runs = std::mem::take(&mut self.runs);
        runs.clear();
        for &node in later {
            let (place, count) = (self.places[node], self.count(node));
            match runs.last_mut() {
                Some(run) if run.end == place => run.end += count,
                // A node without unknowns has no place.
                _ if count == 0 => {}
                _ => runs.push(place..place + count),
            }
        }
        let mut lines = rest.chunks_exact(width.max(1));
        for row in runs.iter().cloned().flatten() {
            let Some(mut line) = lines.next() else { break };
            let front_row = &mut self.front[row * size..(row + 1) * size];
            for run in &runs {
                let (own, others) = line.split_at(run.len());
                for (target, value) in front_row[run.clone()].iter_mut().zip(own) {
                    *target += value;
                }
                line = others;
            }
        }
        self.runs = runs;
        self.spare.push(rest);
    }

    /// Eliminates the unknowns of a front, node after node, pivoting among the rows of each.
    fn eliminate(&mut self, nodes: &Range<usize>, size: usize) {
        let first = self.starts[nodes.start];
        for node in nodes.clone() {
            let panel = self.starts[node] - first..self.starts[node + 1] - first;
            if !panel.is_empty() {
                eliminate(&mut self.front, size, panel, &mut self.pivots);
            }
        }
    }

    /// Keeps the factors of a front, and what is left for its parent.
    fn store(&mut self, index: usize, size: usize, own: usize) {
        self.factors.extend_from_slice(&self.front[..own * size]);
        let mut rest = self.spare.pop().unwrap_or_default();
        rest.clear();
        for row in self.front.chunks_exact(size).skip(own) {
            self.factors.extend_from_slice(&row[..own]);
            rest.extend_from_slice(&row[own..]);
        }
        self.rests[index] = rest;
    }

    fn gather(&self, nodes: &Range<usize>, later: &[usize], b: &[f64], rows: &mut Vec<f64>) {
        rows.clear();
        rows.extend_from_slice(&b[self.starts[nodes.start]..self.starts[nodes.end]]);
        for &member in later {
            rows.extend_from_slice(&b[self.starts[member]..self.starts[member + 1]]);
        }
    }

    fn scatter(&self, nodes: &Range<usize>, later: &[usize], rows: &[f64], b: &mut [f64]) {
        let mut at = self.own(nodes);
        b[self.starts[nodes.start]..self.starts[nodes.end]].copy_from_slice(&rows[..at]);
        for &member in later {
            let count = self.count(member);
            b[self.starts[member]..self.starts[member + 1]].copy_from_slice(&rows[at..at + count]);
            at += count;
        }
    }
}

/// Eliminates the unknowns of a panel of a front whose earlier ones are eliminated, pivoting among the rows of the
/// panel.
fn eliminate(front: &mut [f64], size: usize, panel: Range<usize>, pivots: &mut Vec<usize>) {
    for k in panel.clone() {
        let mut best = k;
        for row in k + 1..panel.end {
            if front[row * size + k].abs() > front[best * size + k].abs() {
                best = row;
            }
        }
        pivots.push(best);
        if best != k {
            let (above, below) = front.split_at_mut(best * size);
            above[k * size..(k + 1) * size].swap_with_slice(&mut below[..size]);
        }
        if front[k * size + k].abs() < VANISHING_PIVOT {
            front[k * size + k] = VANISHING_PIVOT.recip();
        }
        let (above, below) = front.split_at_mut((k + 1) * size);
        let pivot_row = &above[k * size..];
        let over = 1.0 / pivot_row[k];
        // Rows of the panel are updated at once, so that the next pivot is known.
        for row in below.chunks_exact_mut(size).take(panel.end - k - 1) {
            let factor = row[k] * over;
            row[k] = factor;
            axpy(-factor, &pivot_row[k + 1..], &mut row[k + 1..]);
        }
    }
    let (above, below) = front.split_at_mut(panel.end * size);
    let above = &above[panel.start * size..];
    let mut pairs = below.chunks_exact_mut(2 * size);
    for pair in &mut pairs {
        let (one, other) = pair.split_at_mut(size);
        update_rows([one, other], above, &panel);
    }
    let row = pairs.into_remainder();
    if !row.is_empty() {
        update_rows([row], above, &panel);
    }
}

/// `row_L = row U^-1` in the columns of a panel, and the rest of each row less `row_L U`: four pivots at a time.
/// `above` are the rows of the panel.
fn update_rows<const N: usize>(mut rows: [&mut [f64]; N], above: &[f64], panel: &Range<usize>) {
    let size = rows.first().map_or(0, |row| row.len());
    let mut k = panel.start;
    while k + 4 <= panel.end {
        let lines: [&[f64]; 4] = std::array::from_fn(|i| &above[(k - panel.start + i) * size..][..size]);
        let mut factors = [[0.0; 4]; N];
        for (row, factors) in rows.iter_mut().zip(&mut factors) {
            for i in 0..4 {
                let factor = row[k + i] / lines[i][k + i];
                (row[k + i], factors[i]) = (factor, factor);
                for j in i + 1..4 {
                    row[k + j] -= factor * lines[i][k + j];
                }
            }
        }
        // Slices of one length, so that the loop needs no checks and becomes one of vectors.
        let rest = size - k - 4;
        let [a, b, c, d] = lines.map(|line| &line[k + 4..][..rest]);
        let mut targets = rows.each_mut().map(|row| &mut row[k + 4..][..rest]);
        for column in 0..rest {
            let (a, b, c, d) = (a[column], b[column], c[column], d[column]);
            for (row, factors) in targets.iter_mut().zip(&factors) {
                row[column] -= (factors[0] * a + factors[1] * b) + (factors[2] * c + factors[3] * d);
            }
        }
        k += 4;
    }
    for k in k..panel.end {
        let line = &above[(k - panel.start) * size..][..size];
        for row in &mut rows {
            let factor = row[k] / line[k];
            row[k] = factor;
            axpy(-factor, &line[k + 1..], &mut row[k + 1..]);
        }
    }
}
