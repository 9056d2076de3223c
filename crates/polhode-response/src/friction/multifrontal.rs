//! Sparse elimination: `A x = b` for a matrix in blocks whose pattern is symmetric and whose values need not be.
//!
//! Nodes are eliminated in a given order; each gathers its rows and columns, and what its children in the elimination tree have
//! left of theirs, into one dense front, eliminates its own unknowns there (the largest pivot of its own rows first) and leaves
//! the rest to its parent. All arithmetic is dense and in a fixed order. Sources: Duff and Reid 1983 (multifrontal method);
//! Liu 1990 (elimination tree).

use crate::dense::kernels::{axpy, dot};
use crate::friction::elimination_order::EliminationOrder;

/// A pivot that vanishes is replaced by this (in units of the matrix, whose rows are scaled to about 1): its unknown stays where
/// it was. Regularisation keeps pivots far above.
const SMALLEST_PIVOT: f64 = 1e-300;

/// The factors, with the memory of one factorisation for the next.
#[derive(Debug, Clone, Default)]
pub(crate) struct Multifrontal {
    /// First unknown of each node; one more entry than nodes.
    starts: Vec<usize>,
    /// First factor of each node: its own rows, `own x size`, and then the rows below, `(size - own) x own`.
    factors_at: Vec<usize>,
    factors: Vec<f64>,
    /// Which row the pivot of each unknown was taken from, within its node.
    pivots: Vec<usize>,
    /// Rows of the front of each node.
    sizes: Vec<usize>,
    /// What each node has left for its parent.
    rests: Vec<Vec<f64>>,
    /// Memory of rests that were taken.
    spare: Vec<Vec<f64>>,
    front: Vec<f64>,
    rows: Vec<f64>,
    places: Places,
}

/// First row of each node and of each block in the front at hand.
#[derive(Debug, Clone, Default)]
struct Places {
    node: Vec<usize>,
    block: Vec<usize>,
}

/// What a matrix shows of itself to be eliminated.
pub(crate) trait BlockSystem {
    /// Unknowns of a block; 0 leaves it out.
    fn unknowns(&self, block: usize) -> usize;

    /// Blocks that a block is coupled with, itself included, ascending.
    fn neighbours(&self, block: usize) -> &[usize];

    /// Writes the entries of a block, row-major with `stride` numbers from row to row.
    fn write(&self, row: usize, column: usize, stride: usize, target: &mut [f64]);
}

impl Multifrontal {
    /// Factorises.
    pub(crate) fn factor(&mut self, order: &EliminationOrder, system: &impl BlockSystem) {
        let count = order.nodes.len();
        self.starts.clear();
        self.starts.push(0);
        let mut unknowns = 0;
        for blocks in &order.nodes {
            unknowns += blocks.iter().map(|&block| system.unknowns(block)).sum::<usize>();
            self.starts.push(unknowns);
        }
        self.factors.clear();
        self.factors_at.clear();
        self.pivots.clear();
        self.sizes.clear();
        self.rests.resize(count, Vec::new());
        self.places.node.resize(count, 0);
        self.places.block.resize(order.node_of.len(), 0);
        // The parent of a node is the first later node that has unknowns.
        let mut children: Vec<Vec<usize>> = vec![Vec::new(); count];
        for node in 0..count {
            self.factors_at.push(self.factors.len());
            let own = self.own(node);
            if own == 0 {
                self.sizes.push(0);
                continue;
            }
            let size = self.place(node, order, system);
            self.sizes.push(size);
            self.front.clear();
            self.front.resize(size * size, 0.0);
            self.assemble(node, size, order, system);
            for &child in &children[node] {
                self.add_child(child, size, order);
            }
            eliminate(&mut self.front, size, own, &mut self.pivots);
            self.store(node, size, own);
            if let Some(&parent) = order.later[node].iter().find(|&&later| self.own(later) > 0) {
                children[parent].push(node);
            }
        }
    }

    /// Number of unknowns.
    pub(crate) fn unknowns(&self) -> usize {
        self.starts.last().copied().unwrap_or_default()
    }

    /// First unknown of a node in the vectors of [`solve`](Self::solve).
    pub(crate) fn start(&self, node: usize) -> usize {
        self.starts[node]
    }

    /// `A^-1 b`, in place; unknowns by node, in the order of elimination.
    pub(crate) fn solve(&mut self, order: &EliminationOrder, b: &mut [f64]) {
        let mut rows = std::mem::take(&mut self.rows);
        for node in 0..order.nodes.len() {
            let (size, own) = (self.sizes[node], self.own(node));
            self.gather(node, order, b, &mut rows);
            let factors = &self.factors[self.factors_at[node]..];
            for k in 0..own {
                rows.swap(k, self.pivots[self.starts[node] + k]);
            }
            for k in 0..own {
                rows[k] -= dot(&factors[k * size..k * size + k], &rows[..k]);
            }
            let (known, below) = rows.split_at_mut(own);
            for (target, line) in below.iter_mut().zip(factors[own * size..].chunks_exact(own.max(1))) {
                *target -= dot(line, known);
            }
            self.scatter(node, order, &rows, b);
        }
        for node in (0..order.nodes.len()).rev() {
            let (size, own) = (self.sizes[node], self.own(node));
            self.gather(node, order, b, &mut rows);
            let factors = &self.factors[self.factors_at[node]..];
            for k in (0..own).rev() {
                let line = &factors[k * size..(k + 1) * size];
                rows[k] = (rows[k] - dot(&line[k + 1..], &rows[k + 1..size])) / line[k];
            }
            b[self.starts[node]..self.starts[node + 1]].copy_from_slice(&rows[..own]);
        }
        self.rows = rows;
    }

    fn own(&self, node: usize) -> usize {
        self.starts[node + 1] - self.starts[node]
    }

    /// Sets the places of the front of a node; returns its rows.
    fn place(&mut self, node: usize, order: &EliminationOrder, system: &impl BlockSystem) -> usize {
        let mut at = 0;
        for &member in std::iter::once(&node).chain(&order.later[node]) {
            self.places.node[member] = at;
            for &block in &order.nodes[member] {
                self.places.block[block] = at;
                at += system.unknowns(block);
            }
        }
        at
    }

    /// Writes the entries of the matrix in the rows and columns of a node.
    fn assemble(&mut self, node: usize, size: usize, order: &EliminationOrder, system: &impl BlockSystem) {
        for &block in &order.nodes[node] {
            if system.unknowns(block) == 0 {
                continue;
            }
            for &other in system.neighbours(block) {
                let other_node = order.node_of[other];
                if other_node < node || system.unknowns(other) == 0 {
                    continue;
                }
                let (row, column) = (self.places.block[block], self.places.block[other]);
                system.write(block, other, size, &mut self.front[row * size + column..]);
                if other_node > node {
                    system.write(other, block, size, &mut self.front[column * size + row..]);
                }
            }
        }
    }

    /// Adds what a child has left.
    fn add_child(&mut self, child: usize, size: usize, order: &EliminationOrder) {
        let rest = std::mem::take(&mut self.rests[child]);
        let width = self.sizes[child] - self.own(child);
        let mut row = 0;
        for &row_node in &order.later[child] {
            for k in 0..self.own(row_node) {
                let target = (self.places.node[row_node] + k) * size;
                let mut column = (row + k) * width;
                for &column_node in &order.later[child] {
                    let count = self.own(column_node);
                    if count == 0 {
                        // A node without unknowns has no place.
                        continue;
                    }
                    let start = target + self.places.node[column_node];
                    axpy(1.0, &rest[column..column + count], &mut self.front[start..start + count]);
                    column += count;
                }
            }
            row += self.own(row_node);
        }
        self.spare.push(rest);
    }

    /// Keeps the factors of a node, and what is left for its parent.
    fn store(&mut self, node: usize, size: usize, own: usize) {
        self.factors.extend_from_slice(&self.front[..own * size]);
        let mut rest = self.spare.pop().unwrap_or_default();
        rest.clear();
        for row in self.front.chunks_exact(size).skip(own) {
            self.factors.extend_from_slice(&row[..own]);
            rest.extend_from_slice(&row[own..]);
        }
        self.rests[node] = rest;
    }

    fn gather(&self, node: usize, order: &EliminationOrder, b: &[f64], rows: &mut Vec<f64>) {
        rows.clear();
        if self.own(node) > 0 {
            for &member in std::iter::once(&node).chain(&order.later[node]) {
                rows.extend_from_slice(&b[self.starts[member]..self.starts[member + 1]]);
            }
        }
    }

    fn scatter(&self, node: usize, order: &EliminationOrder, rows: &[f64], b: &mut [f64]) {
        let mut at = 0;
        if rows.is_empty() {
            return;
        }
        for &member in std::iter::once(&node).chain(&order.later[node]) {
            let range = self.starts[member]..self.starts[member + 1];
            let count = range.len();
            b[range].copy_from_slice(&rows[at..at + count]);
            at += count;
        }
    }
}

/// Eliminates the first `own` unknowns of a front, pivoting among its own rows.
fn eliminate(front: &mut [f64], size: usize, own: usize, pivots: &mut Vec<usize>) {
    for k in 0..own {
        let mut best = k;
        for row in k + 1..own {
            if front[row * size + k].abs() > front[best * size + k].abs() {
                best = row;
            }
        }
        pivots.push(best);
        if best != k {
            let (above, below) = front.split_at_mut(best * size);
            above[k * size..(k + 1) * size].swap_with_slice(&mut below[..size]);
        }
        if front[k * size + k].abs() < SMALLEST_PIVOT {
            front[k * size + k] = SMALLEST_PIVOT.recip();
        }
        let (above, below) = front.split_at_mut((k + 1) * size);
        let pivot_row = &above[k * size..];
        let over = 1.0 / pivot_row[k];
        // Own rows are updated at once, so that the next pivot is known.
        for row in below.chunks_exact_mut(size).take(own - k - 1) {
            let factor = row[k] * over;
            row[k] = factor;
            axpy(-factor, &pivot_row[k + 1..], &mut row[k + 1..]);
        }
    }
    let (above, below) = front.split_at_mut(own * size);
    for row in below.chunks_exact_mut(size) {
        update_row(above, row, size, own);
    }
}

/// `row_L = row U^-1`, and the rest of the row less `row_L U`: four pivots at a time.
fn update_row(above: &[f64], row: &mut [f64], size: usize, own: usize) {
    let mut k = 0;
    while k + 4 <= own {
        let lines: [&[f64]; 4] = std::array::from_fn(|i| &above[(k + i) * size..(k + i + 1) * size]);
        for i in 0..4 {
            let factor = row[k + i] / lines[i][k + i];
            row[k + i] = factor;
            for j in i + 1..4 {
                row[k + j] -= factor * lines[i][k + j];
            }
        }
        let factors: [f64; 4] = std::array::from_fn(|i| row[k + i]);
        let rest = k + 4..size;
        let (a, b, c, d) = (&lines[0][rest.clone()], &lines[1][rest.clone()], &lines[2][rest.clone()], &lines[3][rest]);
        for ((((target, a), b), c), d) in row[k + 4..].iter_mut().zip(a).zip(b).zip(c).zip(d) {
            *target -= (factors[0] * a + factors[1] * b) + (factors[2] * c + factors[3] * d);
        }
        k += 4;
    }
    for k in k..own {
        let line = &above[k * size..(k + 1) * size];
        let factor = row[k] / line[k];
        row[k] = factor;
        axpy(-factor, &line[k + 1..], &mut row[k + 1..]);
    }
}
