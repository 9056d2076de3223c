//! Trees of joints, solved at once: what a load hangs on holds, whatever it weighs and however long the chain is.
//!
//! Sweeps bring a load along a chain joint by joint, and a heavy body on light links needs as many of them as its mass
//! is larger. So the joints that close no loop are
//! eliminated from the leaves to the roots, at a cost that is linear in them. With the velocities `v` of the bodies (6
//! numbers each), their inverse masses `F`
//! (6 x 6), and the rows `C` (child) and `P` (parent) of a joint,
//!
//! ```text
//! factors, from the leaves:    S = C F_c C^T + e D,    T = S + P F_p P^T,    F_p <- F_p - F_p P^T T^-1 P F_p
//! a sweep, from the leaves:    r = C v_c + P v_p + b g,    v_p <- v_p - F_p P^T T^-1 r
//! and back from the roots:     l = -S^-1 (C v_c + P v_p + b g),    v_c <- v_c + F_c C^T l
//! ```
//!
//! `D` is the diagonal of `J M^-1 J^T` of the joint alone; `e D` ([`rounding::HALF_OF_THE_DIGITS`]) holds the change of
//! multipliers small where rows depend on each other. The bodies
//! take the impulses `J^T l` of all joints, so that momentum is kept to rounding. Joints that close loops, and limits,
//! are solved in turns with the trees, in lanes.
//!
//! Sources: Featherstone 1983 and 2008, chapter 7 (articulated bodies), Baraff 1996; the updates of `F` are those of
//! Kalman's filter. docs/REFERENCES.md.
//! Assumption: inverse masses are those of the start of the step. Failure: `F` is found by differences, so that a ratio
//! of masses of 1e6 costs six digits.

use super::body::ImpulseBody;
use super::joint::{ImpulseJoint, JointLaw, JointRow};
use crate::law::MOST_ROWS;
use polhode_spatial::rounding;
use polhode_spatial::{DVec3, DisjointSets};

/// Coordinates of a body: along, and about its centre of mass.
const WIDTH: usize = 6;

type Coordinates = [f64; WIDTH];
type Lines = [Coordinates; MOST_ROWS];

/// A joint of a tree with its factors.
#[derive(Debug, Clone, Default)]
struct Branch {
    joint: u32,
    /// Bodies of the solver: that which hangs on it, and what it hangs on; zero for the world.
    child: u32,
    parent: u32,
    rows: usize,
    own: Lines,
    above: Lines,
    gaps: Coordinates,
    /// `F_c C^T` and `F_p P^T`, line by line.
    of_own: Lines,
    of_above: Lines,
    /// Factors of `S` and `T`.
    of_child: Lines,
    of_both: Lines,
}

/// What a joint of a tree has been given in a sweep.
#[derive(Debug, Clone, Copy)]
pub(super) struct Given {
    /// Number of the joint.
    pub(super) joint: usize,
    /// Changes of its multipliers, N s.
    pub(super) change: Coordinates,
    /// Its rates before, m/s.
    pub(super) before: Coordinates,
}

/// All trees.
#[derive(Debug, Clone, Default)]
pub(super) struct JointTrees {
    /// Children before parents.
    branches: Vec<Branch>,
    /// The place of each joint among them.
    places: Vec<Option<u32>>,
    /// Of each body of the solver.
    inverses: Vec<Lines>,
    velocities: Vec<Coordinates>,
    given: Vec<Given>,
}

impl JointTrees {
    /// Removes all.
    pub(super) fn clear(&mut self) {
        self.branches.clear();
        self.places.clear();
    }

    /// Whether a joint belongs to a tree.
    pub(super) fn has(&self, joint: usize) -> bool {
        self.places.get(joint).is_some_and(Option::is_some)
    }

    /// Whether there is none.
    pub(super) fn is_empty(&self) -> bool {
        self.branches.is_empty()
    }

    /// Takes the joints that close no loop, in their order.
    pub(super) fn prepare(&mut self, joints: &[ImpulseJoint], bodies: &[ImpulseBody]) {
        self.branches.clear();
        self.places.clear();
        self.places.resize(joints.len(), None);
        let mut sets = DisjointSets::new(bodies.len());
        let mut near: Vec<Vec<(u32, u32)>> = vec![Vec::new(); bodies.len()];
        for (number, joint) in (0..).zip(joints) {
            let [a, b] = joint.bodies.map(|body| if bodies[body as usize].is_moved() { body } else { 0 });
            if joint.law != JointLaw::Hold || sets.smallest(a as usize) == sets.smallest(b as usize) {
                continue;
            }
            sets.join(a as usize, b as usize);
            near[a as usize].push((number, b));
            near[b as usize].push((number, a));
        }
        // From the world on, and then from the first body of each tree that is free.
        let mut reached = vec![false; bodies.len()];
        let mut order = Vec::new();
        for root in 0..bodies.len() as u32 {
            if std::mem::replace(&mut reached[root as usize], true) {
                continue;
            }
            let mut open = vec![root];
            while let Some(body) = open.pop() {
                for &(joint, other) in &near[body as usize] {
                    if !std::mem::replace(&mut reached[other as usize], true) {
                        order.push((joint, other, body));
                        open.push(other);
                    }
                }
            }
        }
        for &(joint, child, parent) in order.iter().rev() {
            self.places[joint as usize] = Some(self.branches.len() as u32);
            let rows = joints[joint as usize].rows;
            self.branches.push(Branch { joint, child, parent, rows, ..Branch::default() });
        }
    }

    /// Gives a joint of a tree its rows in the present poses. [`Self::factor`] follows.
    pub(super) fn set_rows(&mut self, joint: &ImpulseJoint, number: usize, rows: &[JointRow]) {
        let Some(Some(place)) = self.places.get(number) else { return };
        let branch = &mut self.branches[*place as usize];
        let none = JointRow::default();
        for (k, row) in (0..branch.rows).zip(rows.iter().chain(std::iter::repeat(&none))) {
            let sides = [coordinates(row.force, row.moments[0]), coordinates(-row.force, row.moments[1])];
            let child_first = joint.bodies[0] == branch.child;
            (branch.own[k], branch.above[k]) = if child_first { (sides[0], sides[1]) } else { (sides[1], sides[0]) };
            branch.gaps[k] = row.gap;
        }
    }

    /// Finds the factors of the rows that have been given.
    pub(super) fn factor(&mut self, bodies: &[ImpulseBody]) {
        if self.is_empty() {
            return;
        }
        self.inverses.clear();
        self.inverses.extend(bodies.iter().map(inverse_of));
        for branch in &mut self.branches {
            let rows = branch.rows;
            let child = &self.inverses[branch.child as usize];
            let (own, above) = (&branch.own, &branch.above);
            branch.of_own = times(child, own, rows);
            branch.of_above = times(&self.inverses[branch.parent as usize], above, rows);
            let diagonal = {
                let alone = [branch.child, branch.parent].map(|body| inverse_of(&bodies[body as usize]));
                let parts = [times(&alone[0], own, rows), times(&alone[1], above, rows)];
                move |k: usize| dot(&own[k], &parts[0][k]) + dot(&above[k], &parts[1][k])
            };
            for k in 0..rows {
                for j in 0..=k {
                    branch.of_child[k][j] = dot(&own[j], &branch.of_own[k]);
                    branch.of_both[k][j] = dot(&above[j], &branch.of_above[k]);
                }
                branch.of_child[k][k] += rounding::HALF_OF_THE_DIGITS * diagonal(k);
                for j in 0..=k {
                    branch.of_both[k][j] += branch.of_child[k][j];
                }
            }
            factor(&mut branch.of_child, rows);
            factor(&mut branch.of_both, rows);
            if branch.parent != 0 {
                attach(&mut self.inverses[branch.parent as usize], &branch.of_above, (&branch.of_both, rows));
            }
        }
    }

    /// Brings all joints to their laws at once, gaps closing at `closing(gap)` (m/s), and gives the bodies the
    /// impulses. Returns what each joint has got.
    pub(super) fn solve(&mut self, bodies: &mut [ImpulseBody], closing: impl Fn(f64) -> f64) -> &[Given] {
        self.given.clear();
        if self.is_empty() {
            return &self.given;
        }
        self.velocities.clear();
        self.velocities.extend(bodies.iter().map(|body| coordinates(body.linear(), body.angular())));
        let velocities = &mut self.velocities;
        for branch in self.branches.iter().filter(|branch| branch.parent != 0) {
            let mut x = branch.rates(velocities);
            (0..branch.rows).for_each(|k| x[k] += closing(branch.gaps[k]));
            solve(&branch.of_both, &mut x, branch.rows);
            add(&mut velocities[branch.parent as usize], &branch.of_above, &x, -1.0, branch.rows);
        }
        for branch in self.branches.iter().rev() {
            let mut x = branch.rates(velocities);
            (0..branch.rows).for_each(|k| x[k] += closing(branch.gaps[k]));
            solve(&branch.of_child, &mut x, branch.rows);
            let change = x.map(|value| -value);
            add(&mut velocities[branch.child as usize], &branch.of_own, &change, 1.0, branch.rows);
            let joint = branch.joint as usize;
            self.given.push(Given { joint, change, before: [0.0; WIDTH] });
        }
        // The rates before are those of the bodies, which have not changed yet.
        velocities.clear();
        velocities.extend(bodies.iter().map(|body| coordinates(body.linear(), body.angular())));
        for (branch, given) in self.branches.iter().rev().zip(&mut self.given) {
            given.before = branch.rates(velocities);
            for (body, lines) in [(branch.child, &branch.own), (branch.parent, &branch.above)] {
                let mut impulse = [0.0; WIDTH];
                add(&mut impulse, lines, &given.change, 1.0, branch.rows);
                give(&mut bodies[body as usize], &impulse);
            }
        }
        &self.given
    }

    /// The work of what the last sweep gave, J: along the mean of the rates before and now.
    pub(super) fn work(&self, bodies: &[ImpulseBody]) -> f64 {
        let of = |body: u32| coordinates(bodies[body as usize].linear(), bodies[body as usize].angular());
        let mut work = 0.0;
        for (branch, given) in self.branches.iter().rev().zip(&self.given) {
            let (child, parent) = (of(branch.child), of(branch.parent));
            for k in 0..branch.rows {
                let now = dot(&branch.own[k], &child) + dot(&branch.above[k], &parent);
                work += given.change[k] * 0.5 * (given.before[k] + now);
            }
        }
        work
    }
}

impl Branch {
    /// The rates of its rows.
    fn rates(&self, velocities: &[Coordinates]) -> Coordinates {
        let (child, parent) = (&velocities[self.child as usize], &velocities[self.parent as usize]);
        let mut rates = [0.0; WIDTH];
        for k in 0..self.rows {
            rates[k] = dot(&self.own[k], child) + dot(&self.above[k], parent);
        }
        rates
    }
}

fn coordinates(linear: DVec3, angular: DVec3) -> Coordinates {
    [linear.x, linear.y, linear.z, angular.x, angular.y, angular.z]
}

/// The inverse mass of a body alone.
fn inverse_of(body: &ImpulseBody) -> Lines {
    let mut lines = [[0.0; WIDTH]; WIDTH];
    let inertia = body.inverse_inertia();
    for k in 0..3 {
        lines[k][k] = body.inverse_mass();
        for j in 0..3 {
            lines[3 + k][3 + j] = inertia.col(j)[k];
        }
    }
    lines
}

/// A body takes an impulse.
fn give(body: &mut ImpulseBody, [x, y, z, about_x, about_y, about_z]: &Coordinates) {
    let linear = body.linear() + DVec3::new(*x, *y, *z) * body.inverse_mass();
    let angular = body.angular() + body.inverse_inertia() * DVec3::new(*about_x, *about_y, *about_z);
    body.set_velocity(linear, angular);
}

fn dot(left: &Coordinates, right: &Coordinates) -> f64 {
    (left[0] * right[0] + left[1] * right[1] + left[2] * right[2])
        + (left[3] * right[3] + left[4] * right[4] + left[5] * right[5])
}

/// A symmetric matrix times each of the first lines.
fn times(matrix: &Lines, lines: &Lines, count: usize) -> Lines {
    let mut products = [[0.0; WIDTH]; MOST_ROWS];
    for (product, line) in products.iter_mut().zip(lines).take(count) {
        for (value, own) in product.iter_mut().zip(matrix) {
            *value = dot(own, line);
        }
    }
    products
}

/// Adds the sum of the first lines, each times its factor and `sign`.
fn add(to: &mut Coordinates, lines: &Lines, factors: &Coordinates, sign: f64, count: usize) {
    for (line, factor) in lines.iter().zip(factors).take(count) {
        for (value, own) in to.iter_mut().zip(line) {
            *value += sign * factor * own;
        }
    }
}

/// `L D L^T` of a matrix in its lower triangle: `L` below the diagonal, on it the inverse of `D`; zero where a pivot is
/// rounding.
fn factor(matrix: &mut Lines, size: usize) {
    for i in 0..size {
        let diagonal = matrix[i][i];
        let mut pivot = diagonal;
        let mut scaled = [0.0; WIDTH];
        for j in 0..i {
            let mut value = matrix[i][j];
            for k in 0..j {
                value -= scaled[k] * matrix[j][k];
            }
            scaled[j] = value;
            matrix[i][j] = value * matrix[j][j];
            pivot -= value * matrix[i][j];
        }
        matrix[i][i] = if pivot > rounding::HUNDREDS_OF_TERMS * diagonal { 1.0 / pivot } else { 0.0 };
    }
}

/// `x` becomes the solution.
fn solve(factors: &Lines, x: &mut Coordinates, size: usize) {
    for i in 0..size {
        for j in 0..i {
            x[i] -= factors[i][j] * x[j];
        }
    }
    for i in (0..size).rev() {
        x[i] *= factors[i][i];
        for j in i + 1..size {
            x[i] -= factors[j][i] * x[j];
        }
    }
}

/// What hangs on a body makes it heavier: `F <- F - G^T T^-1 G` with the lines `G = P F` and the factors of `T`.
fn attach(inverse: &mut Lines, lines: &Lines, (factors, size): (&Lines, usize)) {
    // L^-1 G, so that what is taken is a sum of squares.
    let mut scaled = *lines;
    for i in 0..size {
        for j in 0..i {
            let known = scaled[j];
            for (value, own) in scaled[i].iter_mut().zip(known) {
                *value -= factors[i][j] * own;
            }
        }
        let line = scaled[i];
        for (row, left) in inverse.iter_mut().zip(line) {
            for (value, right) in row.iter_mut().zip(line) {
                *value -= factors[i][i] * left * right;
            }
        }
    }
}
