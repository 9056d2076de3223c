//! The Delassus operator between the nodes of an elimination, each reduced to its independent rows.
//!
//! Contacts between the same two bodies are one node of `m` rows, but two bodies move relative to each other in at most
//! six ways: four corners have twelve rows of which six are independent. With `s` the independent rows of a node, the
//! others follow from them, and so do columns,
//!
//! ```text
//! G_gh = A_g H_gh C_h^T,   H_gh = G[s_g, s_h],   A_g = 1 on s_g, G[o_g, s_g] G[s_g, s_g]^-1 on the others, C_h too
//! ```
//!
//! so that `H` is a part of `G` itself. `C` differs from `A` only where `G` is not quite symmetric. Source:
//! skeletonisation (Cheng, Gimbutas, Martinsson and Rokhlin 2005), with pivots on the diagonal, which suit a
//! semidefinite matrix. Assumption: a node is reduced only if that reproduces its rows and columns of `G`, tested by a
//! product with a fixed vector of no pattern (Freivalds 1979). Failure: a node that cannot be reduced keeps all its
//! rows.

use crate::dense::kernels::{axpy, dot, largest};
use crate::friction::block_matrix::BlockMatrix;
use crate::friction::elimination_order::EliminationOrder;
use crate::solve::way::REDUCED_FRONT;
use crate::tolerances::TRUSTED_PIVOT;
use std::ops::Range;

/// Rows that must depend on others for a node to be reduced: those of a contact. Fewer cost more than they save.
const LEAST_DEPENDENT: usize = 3;

/// How well dependent rows and columns must be reproduced, relative to the products that they are compared by (no unit,
/// 1e-12 to 1e-6): the linearised system need not be exact, since each step starts from the true residual.
const REPRODUCED: f64 = 1e-11;

/// `H`, `A` and `C`.
#[derive(Debug, Clone, Default)]
pub(crate) struct NodeMatrix {
    /// First row of each node in vectors of reduced rows; one more entry than nodes.
    starts: Vec<usize>,
    /// First coupling of each node; one more entry than nodes.
    first: Vec<usize>,
    /// The other node of each coupling, ascending within a node, itself included.
    others: Vec<usize>,
    /// The same coupling seen from the other node.
    mirrors: Vec<usize>,
    /// First value of each coupling.
    values_at: Vec<usize>,
    values: Vec<f64>,
    expansions: Vec<Option<Expansion>>,
}

/// How all rows of a node follow from the independent ones.
#[derive(Debug, Clone)]
struct Expansion {
    /// The independent rows, by their place within the node.
    independent: Vec<usize>,
    /// `A`, `rows x rank`, row-major.
    rows: Vec<f64>,
    /// `C`, likewise.
    columns: Vec<f64>,
}

/// The rows of a node: those of the problem, and which of them stand for all.
#[derive(Debug, Clone, Default)]
struct NodeRows {
    /// `(block, row within the block)` of each row.
    rows: Vec<(usize, usize)>,
}

impl NodeMatrix {
    /// That of the nodes of an order.
    pub(crate) fn of(matrix: &BlockMatrix, order: &EliminationOrder) -> Self {
        let mut nodes: Vec<NodeRows> = order.nodes.iter().map(|blocks| NodeRows::of(matrix, blocks)).collect();
        let mut expansions: Vec<Option<Expansion>> = vec![None; nodes.len()];
        for (front, later) in order.fronts.iter().zip(&order.later) {
            let rows = front.clone().chain(later.iter().copied()).map(|node| nodes[node].rows.len());
            if rows.sum::<usize>() >= REDUCED_FRONT {
                for node in front.clone() {
                    expansions[node] = expansion(matrix, &order.nodes[node], &nodes[node]);
                }
            }
        }
        if expansions.iter().any(Option::is_some) {
            keep_what_reproduces(matrix, &nodes, &mut expansions);
        }
        for (node, expansion) in nodes.iter_mut().zip(&expansions) {
            if let Some(expansion) = expansion {
                node.rows = expansion.independent.iter().map(|&row| node.rows[row]).collect();
            }
        }
        let mut of_nodes = Self { starts: vec![0], first: vec![0], expansions, ..Self::default() };
        let mut rows = 0;
        for node in &nodes {
            rows += node.rows.len();
            of_nodes.starts.push(rows);
        }
        of_nodes.couple(matrix, order, &nodes);
        of_nodes
    }

    /// Fills `H`.
    fn couple(&mut self, matrix: &BlockMatrix, order: &EliminationOrder, nodes: &[NodeRows]) {
        let mut beside = Vec::new();
        for (node, blocks) in order.nodes.iter().enumerate() {
            beside.clear();
            beside.extend(blocks.first().into_iter().flat_map(|&b| matrix.neighbours(b)).map(|&b| order.node_of[b]));
            beside.sort_unstable();
            beside.dedup();
            for &other in &beside {
                self.others.push(other);
                self.values_at.push(self.values.len());
                self.push_values(matrix, &nodes[node], &nodes[other]);
            }
            self.first.push(self.others.len());
        }
        for node in 0..nodes.len() {
            for place in self.couplings(node) {
                let couplings = self.couplings(self.others[place]);
                let mirror = self.others[couplings.clone()].binary_search(&node);
                self.mirrors.push(mirror.map_or(place, |mirror| couplings.start + mirror));
            }
        }
    }

    /// Appends the entries of `G` in rows of one node and columns of another one.
    fn push_values(&mut self, matrix: &BlockMatrix, node: &NodeRows, other: &NodeRows) {
        let (start, width) = (self.values.len(), other.rows.len());
        self.values.resize(start + node.rows.len() * width, 0.0);
        let mut first = start;
        for rows in node.rows.chunk_by(|a, b| a.0 == b.0) {
            let mut column = 0;
            for columns in other.rows.chunk_by(|a, b| a.0 == b.0) {
                let (Some(&(row_block, _)), Some(&(column_block, _))) = (rows.first(), columns.first()) else {
                    continue;
                };
                if let Some(values) = matrix.block(row_block, column_block) {
                    let size = matrix.size(column_block);
                    for (i, (_, row)) in rows.iter().enumerate() {
                        let target = &mut self.values[first + i * width + column..];
                        for (target, (_, place)) in target.iter_mut().zip(columns) {
                            *target = values[row * size + place];
                        }
                    }
                }
                column += columns.len();
            }
            first += rows.len() * width;
        }
    }

    /// Reduced rows of a node.
    pub(crate) fn rank(&self, node: usize) -> usize {
        self.starts[node + 1] - self.starts[node]
    }

    /// The reduced rows of a node in vectors.
    pub(crate) fn range(&self, node: usize) -> Range<usize> {
        self.starts[node]..self.starts[node + 1]
    }

    /// Reduced rows of all nodes.
    pub(crate) fn rows(&self) -> usize {
        self.starts.last().copied().unwrap_or_default()
    }

    /// The couplings of a node.
    pub(crate) fn couplings(&self, node: usize) -> Range<usize> {
        self.first[node]..self.first[node + 1]
    }

    /// The other node of a coupling.
    pub(crate) fn other(&self, coupling: usize) -> usize {
        self.others[coupling]
    }

    /// The same coupling seen from the other node.
    pub(crate) fn mirror(&self, coupling: usize) -> usize {
        self.mirrors[coupling]
    }

    /// `H` of a coupling, row-major.
    pub(crate) fn values(&self, coupling: usize) -> &[f64] {
        let end = self.values_at.get(coupling + 1).copied().unwrap_or(self.values.len());
        &self.values[self.values_at[coupling]..end]
    }

    /// `A` of a node, row-major; none for a node that is not reduced, whose `A` is the identity.
    pub(crate) fn row_expansion(&self, node: usize) -> Option<&[f64]> {
        self.expansions[node].as_ref().map(|expansion| expansion.rows.as_slice())
    }

    /// `C` of a node, likewise.
    pub(crate) fn column_expansion(&self, node: usize) -> Option<&[f64]> {
        self.expansions[node].as_ref().map(|expansion| expansion.columns.as_slice())
    }
}

impl NodeRows {
    fn of(matrix: &BlockMatrix, blocks: &[usize]) -> Self {
        Self { rows: blocks.iter().flat_map(|&block| (0..matrix.size(block)).map(move |row| (block, row))).collect() }
    }
}

/// The expansion of a node with dependent rows: Gauss elimination with pivots on the diagonal, the largest first.
fn expansion(matrix: &BlockMatrix, blocks: &[usize], node: &NodeRows) -> Option<Expansion> {
    let size = node.rows.len();
    if blocks.len() < 2 {
        return None;
    }
    let mut rest = vec![0.0; size * size];
    let mut row_start = 0;
    for &row in blocks {
        let (height, mut column_start) = (matrix.size(row), 0);
        for &column in blocks {
            let width = matrix.size(column);
            for (k, line) in matrix.block(row, column).unwrap_or_default().chunks_exact(width).enumerate() {
                rest[(row_start + k) * size + column_start..][..width].copy_from_slice(line);
            }
            column_start += width;
        }
        row_start += height;
    }
    // Rows of A and C as they grow: what each eliminated row has of the pivots is substituted at once (Gauss and
    // Jordan).
    let most = (0..size).fold(0.0, |most: f64, k| most.max(rest[k * size + k]));
    let mut independent = Vec::new();
    let mut is_used = vec![false; size];
    while let Some(pivot) = largest_free(&rest, &is_used, size).filter(|&k| rest[k * size + k] > TRUSTED_PIVOT * most) {
        is_used[pivot] = true;
        independent.push(pivot);
        sweep(&mut rest, size, pivot);
    }
    if independent.len() + LEAST_DEPENDENT > size {
        return None;
    }
    independent.sort_unstable();
    // After the sweeps the columns of the pivots hold A, their rows hold C^T, up to the sign of the latter.
    let unit = |row: usize, k: usize| f64::from(u8::from(independent[k] == row));
    let entry = |row: usize, k: usize, other: f64| if is_used[row] { unit(row, k) } else { other };
    let each = |of: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
        (0..size)
            .flat_map(|row| (0..independent.len()).map(move |k| (row, k)))
            .map(|(row, k)| entry(row, k, of(row, independent[k])))
            .collect()
    };
    let rows = each(&|row, pivot| rest[row * size + pivot]);
    let columns = each(&|row, pivot| -rest[pivot * size + row]);
    Some(Expansion { independent, rows, columns })
}

fn largest_free(rest: &[f64], is_used: &[bool], size: usize) -> Option<usize> {
    let free = (0..size).filter(|&row| !is_used[row]);
    free.reduce(|best, row| if rest[row * size + row] > rest[best * size + best] { row } else { best })
}

/// Exchanges the unknown of a row for its right side: `y_k = sum a_kj x_j` becomes an equation for `x_k`.
fn sweep(a: &mut [f64], size: usize, pivot: usize) {
    let over = 1.0 / a[pivot * size + pivot];
    let line: Vec<f64> = a[pivot * size..(pivot + 1) * size].to_vec();
    for (_, target) in a.chunks_exact_mut(size).enumerate().filter(|(row, _)| *row != pivot) {
        let factor = target[pivot] * over;
        axpy(-factor, &line, target);
        target[pivot] = factor;
    }
    for value in &mut a[pivot * size..(pivot + 1) * size] {
        *value *= -over;
    }
    a[pivot * size + pivot] = over;
}

/// Drops expansions that do not reproduce their rows and columns of `G`.
fn keep_what_reproduces(matrix: &BlockMatrix, nodes: &[NodeRows], expansions: &mut [Option<Expansion>]) {
    let probe = probe(matrix.rows());
    let mut of_rows = Vec::new();
    matrix.times_plus(&probe, &vec![0.0; probe.len()], &mut of_rows);
    let of_columns = matrix.transposed_times(&probe);
    for (node, slot) in nodes.iter().zip(expansions) {
        let gather = |x: &[f64]| -> Vec<f64> {
            node.rows.iter().map(|&(block, row)| x[matrix.range(block).start + row]).collect()
        };
        let reproduces = |product: &[f64], factor: &[f64], independent: &[usize]| {
            let own = gather(product);
            let known: Vec<f64> = independent.iter().map(|&row| own[row]).collect();
            let size = largest(&own);
            let lines = factor.chunks_exact(known.len().max(1));
            own.iter().zip(lines).all(|(value, line)| (value - dot(line, &known)).abs() <= REPRODUCED * size)
        };
        let keeps = slot.as_ref().is_some_and(|expansion| {
            let Expansion { independent, rows, columns } = expansion;
            reproduces(&of_rows, rows, independent) && reproduces(&of_columns, columns, independent)
        });
        if !keeps {
            *slot = None;
        }
    }
}

/// Numbers between 0.5 and 1.5 without a pattern, the same in every run.
fn probe(count: usize) -> Vec<f64> {
    // The fractional parts of multiples of the golden ratio.
    const GOLDEN: f64 = 0.618_033_988_749_894_8;
    (1..=count).map(|k| 0.5 + (k as f64 * GOLDEN).fract()).collect()
}

#[cfg(test)]
mod tests {
    //! Four corners of a body follow from six of their rows.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    /// Rows of the corners of a square of 2 m on a floor, along the axes, for a body of unit mass and inertia.
    fn four_corners() -> Vec<[f64; 6]> {
        let arms = [[1.0, 1.0, -0.5], [1.0, -1.0, -0.5], [-1.0, 1.0, -0.5], [-1.0, -1.0, -0.5]];
        let rows = |[x, y, z]: [f64; 3]| {
            [[0.0, 0.0, 1.0, y, -x, 0.0], [1.0, 0.0, 0.0, 0.0, z, -y], [0.0, 1.0, 0.0, -z, 0.0, x]]
        };
        arms.into_iter().flat_map(rows).collect()
    }

    #[test]
    fn four_corners_are_reduced_to_six_rows_that_reproduce_all() {
        let rows = four_corners();
        let entries: Vec<f64> = rows.iter().flat_map(|a| rows.iter().map(|b| dot(a, b))).collect();
        let matrix = BlockMatrix::from_dense(&[3; 4], &entries).unwrap();
        let blocks = [0, 1, 2, 3];
        let found = expansion(&matrix, &blocks, &NodeRows::of(&matrix, &blocks)).unwrap();
        let rank = found.independent.len();
        assert_eq!(rank, 6);
        for (i, a) in found.rows.chunks(rank).enumerate() {
            for (j, c) in found.columns.chunks(rank).enumerate() {
                let mut product = 0.0;
                for (k, a) in a.iter().enumerate() {
                    for (l, c) in c.iter().enumerate() {
                        product += a * entries[12 * found.independent[k] + found.independent[l]] * c;
                    }
                }
                assert!((product - entries[12 * i + j]).abs() < 1e-12, "entry {i}, {j}: {product}");
            }
        }
    }
}
