//! Trees of bodies that held rows connect, and their factors: the rows of joints are solved for at a cost that is
//! linear in the bodies, whatever the length of a chain.
//!
//! Rows that are held, soft ones among them, ask for `J v + C f + b = 0` with `M v = J^T f`. All such rows of one pair
//! of bodies (or of a body with the world) are a branch. Branches are taken, in the order of their first rows, as long
//! as they close no loop; the world is one place of the graph. Each tree is eliminated from its leaves to its root, the
//! world where one of its bodies is held to it, else its first body. At a body `c` with the branch to its parent `p`:
//!
//! | | |
//! |---|---|
//! | `A_c = M_c + sum over its own branches of Z^T Z` | mass of the body with all that hangs on it, articulated |
//! | `A_c = L L^T`, `Y = L^-1 J_c^T` | |
//! | `S = Y^T Y + C = R R^T` | what the branch meets |
//! | `Z = R^-1 J_p` | what it adds to the parent |
//!
//! All terms are added, none is subtracted, so that large ratios of masses cost no digits beyond those of the problem.
//! Rows of a tree are independent of each other; those of one joint that nothing can move (out of a plane) get no
//! force. Rows of branches that would close a loop, and rows that are not held, are the *others* (`beside_forest.rs`).
//!
//! Sources: Featherstone 1983 and 2008, chapter 7 (articulated bodies); Baraff 1996 (the same in Lagrange multipliers).
//! Failure: no forest where an inverse mass is not positive definite, or where rows of one branch depend on each other.

use crate::dense::kernels::{axpy, short_dot};
use crate::law::MOST_ROWS;
use crate::problem::ContactProblem;
use polhode_spatial::DisjointSets;
use polhode_spatial::rounding;
use std::ops::Range;

/// No parent: the branch is with the world, or there is none.
const NONE: u32 = u32::MAX;

/// A body in the order of elimination, with the branch to its parent.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limb {
    pub(super) body: u32,
    /// The place of its parent in the order.
    pub(super) parent: u32,
    /// Its rows begin here in the list of rows of branches.
    first_row: u32,
    rows: u32,
    /// Its numbers begin here: `L`, then for each row `Y` and `Z`, then `R`.
    first_number: u32,
}

impl Limb {
    pub(super) fn range(&self) -> Range<usize> {
        self.first_row as usize..(self.first_row + self.rows) as usize
    }

    /// The place of its parent.
    pub(super) fn up(&self) -> Option<usize> {
        (self.parent != NONE).then_some(self.parent as usize)
    }
}

/// The factors at one body.
pub(super) struct Factors<'a> {
    /// `L`, with inverses on the diagonal.
    pub(super) mass: &'a [f64],
    /// The columns of `Y`, one after the other.
    pub(super) own: &'a [f64],
    /// The rows of `Z`.
    pub(super) parent: &'a [f64],
    /// `R`, with inverses on the diagonal.
    pub(super) matrix: &'a [f64],
}

/// The trees, with their factors.
#[derive(Debug, Clone)]
pub struct HeldForest {
    width: usize,
    /// Children before parents.
    limbs: Vec<Limb>,
    /// The place of each body among them.
    places: Vec<u32>,
    /// The rows of the problem in the order of the limbs.
    rows: Vec<u32>,
    /// The compliance of each of them, 1/kg.
    compliances: Vec<f64>,
    numbers: Vec<f64>,
    /// All other rows of the problem, ascending.
    others: Vec<usize>,
}

/// The branches of a problem before they are ordered.
struct Branches {
    /// The pair of bodies of each; the same body twice with the world.
    pairs: Vec<[u32; 2]>,
    /// Where the rows of each begin; one more than branches.
    starts: Vec<u32>,
    /// The rows, one branch after the other.
    rows: Vec<u32>,
    others: Vec<usize>,
}

impl Branches {
    fn of(problem: &ContactProblem, held: Range<usize>) -> Self {
        let world = problem.bodies();
        let mut sets = DisjointSets::new(world + 1);
        let mut pairs: Vec<[u32; 2]> = Vec::new();
        // How many rows each has.
        let mut counts: Vec<u32> = Vec::new();
        // Branches by their first body: the last one, and the one before each.
        let (mut last, mut before) = (vec![NONE; world], Vec::new());
        let mut taken: Vec<(u32, u32)> = Vec::with_capacity(held.len());
        let mut others = Vec::new();
        for row in 0..problem.len() {
            if !held.contains(&row) || !problem.is_bilateral(row) {
                others.push(row);
                continue;
            }
            let [a, b] = problem.pair(row);
            let pair = [a.min(b), a.max(b)];
            let mut branch = last[pair[0] as usize];
            while branch != NONE && pairs[branch as usize] != pair {
                branch = before[branch as usize];
            }
            if branch == NONE {
                let (a, b) = (pair[0] as usize, if pair[0] == pair[1] { world } else { pair[1] as usize });
                if sets.smallest(a) == sets.smallest(b) {
                    others.push(row);
                    continue;
                }
                sets.join(a, b);
                branch = pairs.len() as u32;
                before.push(std::mem::replace(&mut last[a], branch));
                pairs.push(pair);
                counts.push(0);
            }
            // A joint holds as many rows as a block has at most, and has as many soft ones.
            if counts[branch as usize] as usize == 2 * MOST_ROWS {
                others.push(row);
                continue;
            }
            counts[branch as usize] += 1;
            taken.push((branch, row as u32));
        }
        let mut starts = Vec::with_capacity(counts.len() + 1);
        let mut start = 0;
        for count in counts {
            starts.push(start);
            start += count;
        }
        starts.push(start);
        let mut next = starts.clone();
        let mut rows = vec![0; taken.len()];
        for (branch, row) in taken {
            rows[next[branch as usize] as usize] = row;
            next[branch as usize] += 1;
        }
        Self { pairs, starts, rows, others }
    }

    /// The rows of a branch; none of `NONE`.
    fn rows(&self, branch: u32) -> &[u32] {
        if branch == NONE {
            return &[];
        }
        &self.rows[self.starts[branch as usize] as usize..self.starts[branch as usize + 1] as usize]
    }
}

/// The branches as trees: the parent of each body, parents before children.
struct Order {
    /// Bodies, parents before children.
    bodies: Vec<u32>,
    /// Of each body the branch to its parent and that parent, `NONE` for the world; `NONE` twice at a root that is
    /// free.
    up: Vec<[u32; 2]>,
}

impl Order {
    fn of(bodies: usize, pairs: &[[u32; 2]]) -> Self {
        // Branches of each body, one body after the other.
        let mut starts = vec![0_u32; bodies + 1];
        let ends = |pair: &[u32; 2]| if pair[0] == pair[1] { [pair[0], NONE] } else { *pair };
        for body in pairs.iter().flat_map(ends).filter(|&body| body != NONE) {
            starts[body as usize + 1] += 1;
        }
        for body in 0..bodies {
            starts[body + 1] += starts[body];
        }
        let mut next = starts.clone();
        let mut branches = vec![0_u32; starts[bodies] as usize];
        for (branch, pair) in pairs.iter().enumerate() {
            for body in ends(pair).into_iter().filter(|&body| body != NONE) {
                branches[next[body as usize] as usize] = branch as u32;
                next[body as usize] += 1;
            }
        }
        let mut order = Self { bodies: Vec::with_capacity(bodies), up: vec![[NONE; 2]; bodies] };
        let mut is_reached = vec![false; bodies];
        let held = pairs.iter().enumerate().filter(|(_, pair)| pair[0] == pair[1]);
        let roots: Vec<(u32, u32)> = held.map(|(branch, pair)| (pair[0], branch as u32)).collect();
        let free = (0..bodies as u32).map(|body| (body, NONE));
        for (root, branch) in roots.into_iter().chain(free) {
            if std::mem::replace(&mut is_reached[root as usize], true) {
                continue;
            }
            order.up[root as usize] = [branch, NONE];
            let mut place = order.bodies.len();
            order.bodies.push(root);
            while let Some(&body) = order.bodies.get(place) {
                place += 1;
                for &branch in &branches[starts[body as usize] as usize..starts[body as usize + 1] as usize] {
                    let [a, b] = pairs[branch as usize];
                    let other = if a == body { b } else { a };
                    if !std::mem::replace(&mut is_reached[other as usize], true) {
                        order.up[other as usize] = [branch, body];
                        order.bodies.push(other);
                    }
                }
            }
        }
        order
    }
}

impl HeldForest {
    /// The trees of those of these rows of a problem that are held; none where no row is, and where they have no
    /// factors.
    pub fn of(problem: &ContactProblem, held: Range<usize>) -> Option<Self> {
        let mut branches = Branches::of(problem, held);
        if branches.pairs.is_empty() || problem.bodies() >= NONE as usize {
            return None;
        }
        let (width, bodies) = (problem.width(), problem.bodies());
        let order = Order::of(bodies, &branches.pairs);
        let others = std::mem::take(&mut branches.others);
        let mut forest = Self {
            width,
            limbs: Vec::with_capacity(bodies),
            places: vec![NONE; bodies],
            rows: Vec::with_capacity(problem.len() - others.len()),
            compliances: Vec::new(),
            numbers: Vec::new(),
            others,
        };
        for (place, &body) in order.bodies.iter().rev().enumerate() {
            forest.places[body as usize] = place as u32;
        }
        let mut first_number = 0;
        for &body in order.bodies.iter().rev() {
            let [branch, parent] = order.up[body as usize];
            let own = branches.rows(branch);
            let parent = if parent == NONE { NONE } else { forest.places[parent as usize] };
            let (first_row, rows) = (forest.rows.len() as u32, own.len() as u32);
            forest.rows.extend_from_slice(own);
            forest.limbs.push(Limb { body, parent, first_row, rows, first_number: first_number as u32 });
            first_number += width * width + own.len() * (2 * width + own.len());
        }
        let mut compliances = vec![0.0; problem.len()];
        problem.compliances().iter().for_each(|&(row, compliance)| compliances[row] += compliance);
        forest.compliances = forest.rows.iter().map(|&row| compliances[row as usize]).collect();
        forest.numbers = vec![0.0; first_number];
        forest.factor(problem).then_some(forest)
    }

    /// Bodies in the order of elimination.
    pub(super) fn limbs(&self) -> &[Limb] {
        &self.limbs
    }

    /// The place of a body in it.
    pub(super) fn place(&self, body: usize) -> usize {
        self.places[body] as usize
    }

    /// Coordinates of a body.
    pub(super) fn width(&self) -> usize {
        self.width
    }

    /// The factors at a body.
    pub(super) fn factors(&self, limb: &Limb) -> Factors<'_> {
        let (width, rows) = (self.width, limb.rows as usize);
        let (mass, left) = self.numbers[limb.first_number as usize..].split_at(width * width);
        let (own, left) = left.split_at(rows * width);
        let (parent, left) = left.split_at(rows * width);
        Factors { mass, own, parent, matrix: &left[..rows * rows] }
    }

    /// The rows of branches, in the order of elimination.
    pub(super) fn rows(&self) -> impl Iterator<Item = usize> + '_ {
        self.rows.iter().map(|&row| row as usize)
    }

    /// All other rows of the problem, ascending.
    pub fn others(&self) -> &[usize] {
        &self.others
    }

    /// How many rows the trees have.
    pub fn held(&self) -> usize {
        self.rows.len()
    }

    /// Makes the factors, from the leaves to the roots. Whether there are any.
    fn factor(&mut self, problem: &ContactProblem) -> bool {
        let width = self.width;
        let square = width * width;
        for limb in &self.limbs {
            let target = &mut self.numbers[limb.first_number as usize..][..square];
            if !put_inverse(problem.inverse_mass(limb.body as usize), width, target) {
                return false;
            }
        }
        for place in 0..self.limbs.len() {
            let limb = self.limbs[place];
            let rows = limb.rows as usize;
            // A parent comes later, so that its numbers do too.
            let (own, later) =
                self.numbers[limb.first_number as usize..].split_at_mut(square + rows * (2 * width + rows));
            let (mass, of_rows) = own.split_at_mut(square);
            if !cholesky(mass, width, 0.0) {
                return false;
            }
            let (by_width, matrix) = of_rows.split_at_mut(2 * rows * width);
            let (own_rows, parent_rows) = by_width.split_at_mut(rows * width);
            for (index, &row) in self.rows[limb.range()].iter().enumerate() {
                for entry in problem.entries(row as usize) {
                    let is_own = entry.body == limb.body as usize;
                    let target = if is_own { &mut *own_rows } else { &mut *parent_rows };
                    target[index * width..(index + 1) * width].copy_from_slice(entry.jacobian);
                }
                forward(mass, width, &mut own_rows[index * width..(index + 1) * width]);
                for other in 0..=index {
                    let product = short_dot(&own_rows[index * width..][..width], &own_rows[other * width..][..width]);
                    matrix[index * rows + other] = product;
                }
                matrix[index * rows + index] += self.compliances[limb.first_row as usize + index];
            }
            if !cholesky(matrix, rows, rounding::HUNDREDS_OF_TERMS) {
                return false;
            }
            if limb.parent == NONE {
                continue;
            }
            for index in 0..rows {
                let (above, line) = parent_rows.split_at_mut(index * width);
                let (line, factors) = (&mut line[..width], &matrix[index * rows..][..=index]);
                for (other, factor) in above.chunks_exact(width).zip(factors) {
                    axpy(-factor, other, line);
                }
                for value in line.iter_mut() {
                    *value *= factors[index];
                }
            }
            let start = self.limbs[limb.parent as usize].first_number as usize - limb.first_number as usize;
            let parent = &mut later[start - (square + rows * (2 * width + rows))..][..square];
            for line in parent_rows.chunks_exact(width) {
                for (i, &value) in line.iter().enumerate() {
                    axpy(value, &line[..=i], &mut parent[i * width..][..=i]);
                }
            }
        }
        true
    }
}

/// `L` of a matrix in its lower triangle, with the inverse of each entry of the diagonal in its place; zero where the
/// row is zero. Whether all other pivots are larger than this part of the diagonal.
fn cholesky(matrix: &mut [f64], size: usize, least: f64) -> bool {
    match size {
        3 => cholesky_of::<3>(matrix, least),
        5 => cholesky_of::<5>(matrix, least),
        6 => cholesky_of::<6>(matrix, least),
        _ => cholesky_of_lines(&mut matrix.chunks_exact_mut(size.max(1)).collect::<Vec<_>>(), size, least),
    }
}

fn cholesky_of<const N: usize>(matrix: &mut [f64], least: f64) -> bool {
    matrix.as_chunks_mut::<N>().0.first_chunk_mut::<N>().is_some_and(|lines| cholesky_of_lines(lines, N, least))
}

#[inline]
fn cholesky_of_lines<L: AsMut<[f64]> + AsRef<[f64]>>(lines: &mut [L], size: usize, least: f64) -> bool {
    for i in 0..size {
        let (above, rest) = lines.split_at_mut(i);
        let own = rest[0].as_mut();
        for (j, line) in above.iter().enumerate() {
            let line = line.as_ref();
            let known: f64 = own[..j].iter().zip(&line[..j]).map(|(a, b)| a * b).sum();
            own[j] = (own[j] - known) * line[j];
        }
        let diagonal = own[i];
        if diagonal == 0.0 {
            continue;
        }
        let value = diagonal - own[..i].iter().map(|a| a * a).sum::<f64>();
        // Written so that NaN is refused.
        let is_positive = value > least * diagonal;
        if !is_positive {
            return false;
        }
        own[i] = value.sqrt().recip();
    }
    true
}

/// `L^-1 x` in the place of `x`.
pub(super) fn forward(factor: &[f64], size: usize, x: &mut [f64]) {
    match size {
        3 => forward_of::<3>(factor, x),
        5 => forward_of::<5>(factor, x),
        6 => forward_of::<6>(factor, x),
        _ => forward_of_lines(factor.chunks_exact(size.max(1)), x),
    }
}

fn forward_of<const N: usize>(factor: &[f64], x: &mut [f64]) {
    if let Some(x) = x.first_chunk_mut::<N>() {
        forward_of_lines(factor.as_chunks::<N>().0.iter(), x);
    }
}

#[inline]
fn forward_of_lines<L: AsRef<[f64]>>(lines: impl Iterator<Item = L>, x: &mut [f64]) {
    for (i, line) in lines.enumerate().take(x.len()) {
        let line = line.as_ref();
        let known: f64 = line[..i].iter().zip(&x[..i]).map(|(a, x)| a * x).sum();
        x[i] = (x[i] - known) * line[i];
    }
}

/// `L^-T x` in the place of `x`.
pub(super) fn backward(factor: &[f64], size: usize, x: &mut [f64]) {
    match size {
        3 => backward_of::<3>(factor, x),
        5 => backward_of::<5>(factor, x),
        6 => backward_of::<6>(factor, x),
        _ => backward_of_lines(factor.chunks_exact(size.max(1)), x),
    }
}

fn backward_of<const N: usize>(factor: &[f64], x: &mut [f64]) {
    if let Some((lines, x)) = factor.as_chunks::<N>().0.first_chunk::<N>().zip(x.first_chunk_mut::<N>()) {
        backward_of_lines(lines.iter(), x);
    }
}

#[inline]
fn backward_of_lines<L: AsRef<[f64]>>(lines: impl DoubleEndedIterator<Item = L> + ExactSizeIterator, x: &mut [f64]) {
    for (i, line) in lines.enumerate().rev() {
        let line = line.as_ref();
        let value = x[i] * line[i];
        x[i] = value;
        for (target, entry) in x[..i].iter_mut().zip(&line[..i]) {
            *target -= entry * value;
        }
    }
}

/// The inverse of a symmetric matrix, in its lower triangle. Whether it is positive definite.
fn put_inverse(matrix: &[f64], size: usize, inverse: &mut [f64]) -> bool {
    inverse.copy_from_slice(matrix);
    if !cholesky(inverse, size, f64::EPSILON) || (0..size).any(|i| inverse[i * size + i] == 0.0) {
        return false;
    }
    // The columns of L^-1, then the products of its transpose with itself, each in the place of what is no longer
    // needed.
    for j in 0..size {
        for i in j + 1..size {
            let known: f64 = (j..i).map(|k| inverse[i * size + k] * inverse[k * size + j]).sum();
            inverse[i * size + j] = -known * inverse[i * size + i];
        }
    }
    for i in 0..size {
        for j in 0..=i {
            inverse[i * size + j] = (i..size).map(|k| inverse[k * size + i] * inverse[k * size + j]).sum();
        }
    }
    true
}
