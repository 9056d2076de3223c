//! Sparse elimination: `A x = b` for a matrix in blocks whose pattern is symmetric and whose values need not be.
//!
//! Nodes are eliminated in a given order; each gathers its rows and columns, and what its children in the elimination tree have
//! left of theirs, into one dense front, eliminates its own unknowns there (the largest pivot of its own rows first) and leaves
//! the rest to its parent. All arithmetic is dense and in a fixed order. Sources: Duff and Reid 1983 (multifrontal method);
//! Liu 1990 (elimination tree).

use crate::dense::kernels::{axpy, dot};
use crate::friction::elimination_order::{EliminationOrder, merge};

/// A pivot that vanishes is replaced by this (in units of the matrix, whose rows are scaled to about 1): its unknown stays where
/// it was. Regularisation keeps pivots far above.
const SMALLEST_PIVOT: f64 = 1e-300;

/// The factors.
#[derive(Debug, Clone, Default)]
pub(crate) struct Multifrontal {
    fronts: Vec<Front>,
    /// First unknown of each node; one more entry than nodes.
    starts: Vec<usize>,
}

/// The factors of one node.
#[derive(Debug, Clone, Default)]
struct Front {
    /// Unknowns of the node.
    own: usize,
    /// Later nodes that it is coupled with, ascending.
    later: Vec<usize>,
    /// Which row each pivot was taken from.
    pivots: Vec<usize>,
    /// All rows of the front, row-major: `L` and `U` where they belong, and what is left for the parent at the end.
    values: Vec<f64>,
    /// Rows of the front.
    size: usize,
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
    pub(crate) fn factor(order: &EliminationOrder, system: &impl BlockSystem) -> Self {
        let count = order.nodes.len();
        let unknowns_of = |node: usize| order.nodes[node].iter().map(|&block| system.unknowns(block)).sum::<usize>();
        let mut starts = vec![0; count + 1];
        for node in 0..count {
            starts[node + 1] = starts[node] + unknowns_of(node);
        }
        let mut factors = Self { fronts: vec![Front::default(); count], starts };
        let mut children: Vec<Vec<usize>> = vec![Vec::new(); count];
        let mut places = Places { node: vec![0; count], block: vec![0; order.node_of.len()] };
        for node in 0..count {
            let own = factors.starts[node + 1] - factors.starts[node];
            let later = factors.later_nodes(node, &children[node], order, system);
            let mut front = Front { own, later, ..Front::default() };
            front.size = places.set(node, &front.later, order, system);
            front.values = vec![0.0; front.size * front.size];
            front.assemble(node, order, system, &places);
            for &child in &children[node] {
                let child_front = &mut factors.fronts[child];
                front.add_child(child_front, &factors.starts, &places);
                child_front.forget_rest();
            }
            front.eliminate();
            if let Some(&parent) = front.later.first() {
                children[parent].push(node);
            }
            factors.fronts[node] = front;
        }
        factors
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
    pub(crate) fn solve(&self, b: &mut [f64]) {
        let mut rows = Vec::new();
        for (node, front) in self.fronts.iter().enumerate() {
            self.gather(node, front, b, &mut rows);
            front.forward(&mut rows);
            self.scatter(node, front, &rows, b);
        }
        for (node, front) in self.fronts.iter().enumerate().rev() {
            self.gather(node, front, b, &mut rows);
            front.backward(&mut rows);
            b[self.starts[node]..self.starts[node + 1]].copy_from_slice(&rows[..front.own]);
        }
    }

    /// Later nodes with unknowns that a node is coupled with, at first or by its children.
    fn later_nodes(
        &self,
        node: usize,
        children: &[usize],
        order: &EliminationOrder,
        system: &impl BlockSystem,
    ) -> Vec<usize> {
        let own = self.starts[node + 1] - self.starts[node];
        if own == 0 {
            return Vec::new();
        }
        let first = order.nodes[node].first().map_or(&[][..], |&block| system.neighbours(block));
        let is_later = |other: &usize| *other > node && self.starts[*other + 1] > self.starts[*other];
        let mut later: Vec<usize> = first.iter().map(|&block| order.node_of[block]).filter(is_later).collect();
        later.sort_unstable();
        later.dedup();
        let mut union = Vec::new();
        for &child in children {
            merge(&later, &self.fronts[child].later, &mut union);
            std::mem::swap(&mut later, &mut union);
        }
        later.retain(|&other| other > node);
        later
    }

    fn gather(&self, node: usize, front: &Front, b: &[f64], rows: &mut Vec<f64>) {
        rows.clear();
        for &member in std::iter::once(&node).chain(&front.later) {
            rows.extend_from_slice(&b[self.starts[member]..self.starts[member + 1]]);
        }
    }

    fn scatter(&self, node: usize, front: &Front, rows: &[f64], b: &mut [f64]) {
        let mut at = 0;
        for &member in std::iter::once(&node).chain(&front.later) {
            let range = self.starts[member]..self.starts[member + 1];
            let count = range.len();
            b[range].copy_from_slice(&rows[at..at + count]);
            at += count;
        }
    }
}

/// First row of each node and of each block in the front at hand.
#[derive(Debug)]
struct Places {
    node: Vec<usize>,
    block: Vec<usize>,
}

impl Places {
    /// For the front of a node and of later ones; returns its rows.
    fn set(&mut self, node: usize, later: &[usize], order: &EliminationOrder, system: &impl BlockSystem) -> usize {
        let mut at = 0;
        for &member in std::iter::once(&node).chain(later) {
            self.node[member] = at;
            for &block in &order.nodes[member] {
                self.block[block] = at;
                at += system.unknowns(block);
            }
        }
        at
    }
}

impl Front {
    /// Writes the entries of the matrix in the rows and columns of the node.
    fn assemble(&mut self, node: usize, order: &EliminationOrder, system: &impl BlockSystem, places: &Places) {
        let size = self.size;
        for &block in &order.nodes[node] {
            if system.unknowns(block) == 0 {
                continue;
            }
            for &other in system.neighbours(block) {
                let other_node = order.node_of[other];
                if other_node < node || system.unknowns(other) == 0 {
                    continue;
                }
                let (row, column) = (places.block[block], places.block[other]);
                system.write(block, other, size, &mut self.values[row * size + column..]);
                if other_node > node {
                    system.write(other, block, size, &mut self.values[column * size + row..]);
                }
            }
        }
    }

    /// Adds what a child has left.
    fn add_child(&mut self, child: &Self, starts: &[usize], places: &Places) {
        let size = self.size;
        let mut row = child.own;
        for &row_node in &child.later {
            for k in 0..starts[row_node + 1] - starts[row_node] {
                let target = (places.node[row_node] + k) * size;
                let source = &child.values[(row + k) * child.size..(row + k + 1) * child.size];
                let mut column = child.own;
                for &column_node in &child.later {
                    let count = starts[column_node + 1] - starts[column_node];
                    let start = target + places.node[column_node];
                    axpy(1.0, &source[column..column + count], &mut self.values[start..start + count]);
                    column += count;
                }
            }
            row += starts[row_node + 1] - starts[row_node];
        }
    }

    /// Eliminates the unknowns of the node, pivoting among its own rows.
    fn eliminate(&mut self) {
        let (size, own) = (self.size, self.own);
        self.pivots.clear();
        if size == 0 {
            return;
        }
        for k in 0..own {
            let size_at = |row: usize, values: &[f64]| values[row * size + k].abs();
            let best = (k..own)
                .fold(k, |best, row| if size_at(row, &self.values) > size_at(best, &self.values) { row } else { best });
            self.pivots.push(best);
            if best != k {
                let (above, below) = self.values.split_at_mut(best * size);
                above[k * size..(k + 1) * size].swap_with_slice(&mut below[..size]);
            }
            if self.values[k * size + k].abs() < SMALLEST_PIVOT {
                self.values[k * size + k] = SMALLEST_PIVOT.recip();
            }
            let (above, below) = self.values.split_at_mut((k + 1) * size);
            let pivot_row = &above[k * size..];
            let over = 1.0 / pivot_row[k];
            // Own rows are updated at once, so that the next pivot is known.
            for row in below.chunks_exact_mut(size).take(own - k - 1) {
                let factor = row[k] * over;
                row[k] = factor;
                axpy(-factor, &pivot_row[k + 1..], &mut row[k + 1..]);
            }
        }
        let (above, below) = self.values.split_at_mut(own * size);
        for row in below.chunks_exact_mut(size) {
            update_row(above, row, size, own);
        }
    }

    /// Drops what the parent has taken.
    fn forget_rest(&mut self) {
        let (size, own) = (self.size, self.own);
        for row in own..size {
            self.values.copy_within(row * size..row * size + own, own * size + (row - own) * own);
        }
        self.values.truncate(own * size + (size - own) * own);
        self.values.shrink_to_fit();
    }

    /// Distance between the rows below the own ones.
    fn stride_below(&self) -> usize {
        if self.values.len() == self.size * self.size { self.size } else { self.own }
    }

    fn forward(&self, b: &mut [f64]) {
        let (size, own) = (self.size, self.own);
        for k in 0..own {
            b.swap(k, self.pivots[k]);
        }
        for k in 0..own {
            let known = dot(&self.values[k * size..k * size + k], &b[..k]);
            b[k] -= known;
        }
        let (start, stride) = (own * size, self.stride_below());
        for row in 0..size - own {
            let line = &self.values[start + row * stride..][..own];
            let known = dot(line, &b[..own]);
            b[own + row] -= known;
        }
    }

    fn backward(&self, b: &mut [f64]) {
        let (size, own) = (self.size, self.own);
        for k in (0..own).rev() {
            let line = &self.values[k * size..(k + 1) * size];
            b[k] = (b[k] - dot(&line[k + 1..], &b[k + 1..size])) / line[k];
        }
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
