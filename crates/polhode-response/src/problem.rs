//! A contact problem: inverse masses of the bodies and one Jacobian row for each contact.
//!
//! A body has a generalised velocity of `width` components (6 in space: linear and angular; 3 in a plane), an inverse
//! mass block `M_b^-1` (`width x width`, symmetric, positive semidefinite), and a row `i` touches one to four bodies:
//! `u_i = sum_b J_ib v_b` is the rate of separation of contact `i` (m/s), and a force `f_i` (N) along it accelerates
//! the bodies by `M^-1 J^T f`. For a contact with normal `n` from B to A and arms `r_A`, `r_B` from the centres of
//! mass, `J_iA = (n, r_A x n)` and `J_iB = -(n, r_B x n)`; these are the coefficients of the thesis's equations
//! (14), (15), (17) and (18). Immovable bodies have no entry: that is the thesis's `phi(i, j) = 0`.
//!
//! Rows push, as those along the normals of contacts, or hold with a force of either sign, as those of joints. What the
//! rows of one constraint ask for together is its [`Law`].
//!
//! Source: thesis, sections 3.3 and 3.4. Assumption: the rows of one problem have one unit, so that their speeds can
//! be compared. Failure: data that is not finite, not symmetric or out of range is refused with a [`ResponseError`].

use crate::dense::kernels::{axpy, dot};
use crate::error::{ResponseError, check_finite, check_length};
use crate::law::Law;
use crate::tolerances::MATRIX_ROUNDING;
use std::ops::Range;

/// Rows for which memory is taken with the first one: those of four contacts with friction. Of more it grows.
const FIRST_ROWS: usize = 12;

/// Inverse masses of the bodies and the sparse rows of the contacts.
///
/// ```
/// use polhode_response::ContactProblem;
/// // A ball of 2 kg on a line above an immovable floor: width 1, one contact.
/// let mut problem = ContactProblem::new(1, vec![0.5])?;
/// problem.push_row(&[(0, &[1.0])])?;
/// assert_eq!(problem.delassus().get(0, 0), 0.5);
/// # Ok::<(), polhode_response::ResponseError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ContactProblem {
    width: usize,
    bodies: usize,
    inverse_masses: Vec<f64>,
    rows: Vec<RowBodies>,
    /// Whether each row holds with a force of either sign.
    holds: Vec<bool>,
    /// Compliances of rows that are held and soft, 1/kg.
    compliances: Vec<(usize, f64)>,
    /// First row and law of the blocks with friction.
    frictional: Vec<(usize, Law)>,
    /// What rows of more than two bodies have beside the first two: (row, body, `J_ib`, `M_b^-1 J_ib^T`), ascending by
    /// row.
    others: Vec<OtherEntry>,
    /// Two blocks of `width` numbers for each row; the second is unused when the row touches one body.
    jacobian: Vec<f64>,
    /// `M^-1 J^T` in the layout of `jacobian`.
    response: Vec<f64>,
}

/// One row: the bodies that it touches and their Jacobian blocks, as [`ContactProblem::push_row`] takes them.
pub type RowEntries<'a> = [(usize, &'a [f64])];

/// Which signs the force of a row may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Sign {
    Pushes,
    Either,
}

/// The bodies that a row touches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct RowBodies {
    bodies: [u32; 2],
    count: u8,
}

/// Most bodies that a row touches: a gear couples two joints of two bodies each.
const MOST_BODIES_OF_A_ROW: usize = 4;

/// The share of the third or fourth body of a row.
#[derive(Debug, Clone, PartialEq)]
struct OtherEntry {
    row: usize,
    body: usize,
    jacobian: Vec<f64>,
    response: Vec<f64>,
}

/// One body's share of a row.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RowEntry<'a> {
    /// The body.
    pub(crate) body: usize,
    /// `J_ib`.
    pub(crate) jacobian: &'a [f64],
    /// `M_b^-1 J_ib^T`.
    pub(crate) response: &'a [f64],
}

impl ContactProblem {
    /// A problem without rows. `inverse_masses` holds one `width x width` block for each body, row-major.
    ///
    /// # Errors
    /// When the width is 0, the length is no multiple of `width^2`, a number is not finite, or a block is not
    /// symmetric and positive semidefinite to rounding.
    pub fn new(width: usize, inverse_masses: Vec<f64>) -> Result<Self, ResponseError> {
        let block = width.saturating_mul(width);
        if block == 0 {
            return Err(ResponseError::Width(width));
        }
        let bodies = inverse_masses.len() / block;
        check_length("inverse masses", bodies * block, inverse_masses.len())?;
        check_finite("inverse masses", &inverse_masses)?;
        let mut reduced = Vec::with_capacity(block);
        for (body, matrix) in inverse_masses.chunks_exact(block).enumerate() {
            let is_dominant = match width {
                3 => is_dominant::<3>(matrix),
                6 => is_dominant::<6>(matrix),
                _ => false,
            };
            if !is_dominant && !is_semidefinite(matrix, width, &mut reduced) {
                return Err(ResponseError::InverseMass { body });
            }
        }
        Ok(Self {
            width,
            bodies,
            inverse_masses,
            rows: Vec::new(),
            holds: Vec::new(),
            compliances: Vec::new(),
            frictional: Vec::new(),
            others: Vec::new(),
            jacobian: Vec::new(),
            response: Vec::new(),
        })
    }

    /// The problem with one row for each coordinate of its only body, whose inverse mass (row-major, symmetric and
    /// positive semidefinite) is therefore its matrix; which rows are held, and which are soft.
    pub(crate) fn of_matrix(entries: &[f64], holds: Vec<bool>, compliances: Vec<(usize, f64)>) -> Self {
        let size = holds.len();
        let mut problem = Self {
            width: size,
            bodies: 1,
            inverse_masses: entries.to_vec(),
            rows: vec![RowBodies { bodies: [0; 2], count: 1 }; size],
            holds,
            compliances,
            frictional: Vec::new(),
            others: Vec::new(),
            jacobian: vec![0.0; 2 * size * size],
            response: vec![0.0; 2 * size * size],
        };
        for row in 0..size {
            problem.jacobian[2 * row * size + row] = 1.0;
            let line = entries.get(row * size..(row + 1) * size).unwrap_or_default();
            problem.response[2 * row * size..2 * row * size + line.len()].copy_from_slice(line);
        }
        problem
    }

    /// The bodies of a row; the same one twice where it touches one.
    pub(crate) fn pair(&self, row: usize) -> [u32; 2] {
        self.rows[row].bodies
    }

    /// Adds a row that pushes, `0 <= f _|_ w >= 0`, touches one to four bodies, and returns its index. Each block has
    /// `width` numbers. The methods that solve in the velocities of bodies take rows of one or two
    /// ([`Self::is_of_pairs`]).
    ///
    /// # Errors
    /// When there are no or more than four bodies, a body is unknown or named twice, a block has the wrong length, or
    /// a number is not finite.
    pub fn push_row(&mut self, entries: &[(usize, &[f64])]) -> Result<usize, ResponseError> {
        self.push(entries, Sign::Pushes)
    }

    /// Adds a row of a joint or along a tangent: its acceleration (velocity) is zero, whatever the sign of its force.
    /// As [`push_row`](Self::push_row).
    ///
    /// # Errors
    /// Those of [`push_row`](Self::push_row).
    pub fn push_held_row(&mut self, entries: &[(usize, &[f64])]) -> Result<usize, ResponseError> {
        self.push(entries, Sign::Either)
    }

    /// Adds the rows of a constraint with this law; returns them.
    ///
    /// ```
    /// use polhode_response::{ContactProblem, Law};
    /// // A bead of 0.5 kg that a hole holds in the plane.
    /// let mut problem = ContactProblem::new(2, vec![2.0, 0.0, 0.0, 2.0])?;
    /// let rows = problem.push_block(Law::Hold { rows: 2 }, &[&[(0, &[1.0, 0.0])], &[(0, &[0.0, 1.0])]])?;
    /// assert_eq!(rows, 0..2);
    /// # Ok::<(), polhode_response::ResponseError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`push_row`](Self::push_row); when the law is of another number of rows; when its friction is negative
    /// or not finite. No row is added then.
    pub fn push_block(&mut self, law: Law, rows: &[&RowEntries<'_>]) -> Result<Range<usize>, ResponseError> {
        if law.rows() != rows.len() {
            return Err(ResponseError::BlockRows { expected: law.rows(), found: rows.len() });
        }
        let first = self.len();
        if law.has_friction() {
            law.check(self.frictional.len())?;
            self.frictional.push((first, law));
        }
        for (place, row) in rows.iter().enumerate() {
            let pushed = if place == 0 && law.pushes() { self.push_row(row) } else { self.push_held_row(row) };
            pushed.inspect_err(|_| self.truncate_rows(first))?;
        }
        Ok(first..self.len())
    }

    /// Makes a row that is held soft, `u = -c r` in the place of `u = 0`: `compliance` in 1/kg.
    ///
    /// # Errors
    /// When the row is not held, or the compliance is negative or not finite.
    pub fn soften(&mut self, row: usize, compliance: f64) -> Result<(), ResponseError> {
        if !(self.holds.get(row) == Some(&true) && compliance >= 0.0 && compliance.is_finite()) {
            return Err(ResponseError::Compliance { row, compliance });
        }
        self.compliances.push((row, compliance));
        Ok(())
    }

    /// The rows that are soft, and their compliances, 1/kg.
    pub fn compliances(&self) -> &[(usize, f64)] {
        &self.compliances
    }

    /// Whether some block has friction.
    pub fn has_friction(&self) -> bool {
        !self.frictional.is_empty()
    }

    /// First row and law of the blocks with friction, ascending.
    pub(crate) fn frictional(&self) -> &[(usize, Law)] {
        &self.frictional
    }

    /// That no block has friction.
    ///
    /// # Errors
    /// The first that does.
    pub(crate) fn check_frictionless(&self) -> Result<(), ResponseError> {
        self.frictional.first().map_or(Ok(()), |&(row, _)| Err(ResponseError::HasFriction { row }))
    }

    /// Whether a row is bilateral.
    pub(crate) fn is_bilateral(&self, row: usize) -> bool {
        self.holds[row]
    }

    /// Which of `rows` (all when `None`) are bilateral; empty when none is.
    pub(crate) fn bilateral_rows(&self, rows: Option<&[usize]>) -> Vec<bool> {
        if !self.holds.contains(&true) {
            return Vec::new();
        }
        match rows {
            Some(rows) => rows.iter().map(|&row| self.is_bilateral(row)).collect(),
            None => (0..self.len()).map(|row| self.is_bilateral(row)).collect(),
        }
    }

    fn push(&mut self, entries: &RowEntries<'_>, sign: Sign) -> Result<usize, ResponseError> {
        if entries.is_empty() || entries.len() > MOST_BODIES_OF_A_ROW {
            return Err(ResponseError::RowBodies(entries.len()));
        }
        for &(body, block) in entries {
            if body >= self.bodies {
                return Err(ResponseError::UnknownBody { body, bodies: self.bodies });
            }
            check_length("Jacobian block", self.width, block.len())?;
            check_finite("Jacobian block", block)?;
        }
        let mut row = RowBodies { bodies: [entries[0].0 as u32; 2], count: entries.len() as u8 };
        let is_repeated = |place: usize| entries[..place].iter().any(|(body, _)| *body == entries[place].0);
        if let Some(place) = (1..entries.len()).find(|&place| is_repeated(place)) {
            return Err(ResponseError::RepeatedBody { body: entries[place].0 });
        }
        if let Some(&(body, _)) = entries.get(1) {
            row.bodies[1] = body as u32;
        }
        if self.rows.is_empty() {
            self.reserve(FIRST_ROWS);
        }
        for slot in 0..2 {
            if let Some(&(body, block)) = entries.get(slot) {
                self.jacobian.extend_from_slice(block);
                self.push_response(body, block);
            } else {
                self.jacobian.resize(self.jacobian.len() + self.width, 0.0);
                self.response.resize(self.response.len() + self.width, 0.0);
            }
        }
        for &(body, block) in entries.iter().skip(2) {
            let first = self.response.len();
            self.push_response(body, block);
            let response = self.response.split_off(first);
            self.others.push(OtherEntry { row: self.rows.len(), body, jacobian: block.to_vec(), response });
        }
        self.rows.push(row);
        self.holds.push(sign == Sign::Either);
        Ok(self.rows.len() - 1)
    }

    /// The bodies with these of the rows, in this order, whatever their laws of friction.
    pub(crate) fn with_rows(&self, rows: &[usize]) -> Self {
        let (bodies, inverse_masses) = (self.bodies, self.inverse_masses.clone());
        let blocks = |of: &[f64]| {
            let own = |&row: &usize| &of[2 * row * self.width..2 * (row + 1) * self.width];
            rows.iter().flat_map(own).copied().collect::<Vec<f64>>()
        };
        let place = |row: usize| rows.iter().position(|own| *own == row);
        let compliances = self.compliances.iter().filter_map(|&(row, own)| Some((place(row)?, own))).collect();
        let others =
            self.others.iter().filter_map(|other| Some(OtherEntry { row: place(other.row)?, ..other.clone() }));
        let mut others: Vec<OtherEntry> = others.collect();
        others.sort_by_key(|other| other.row);
        Self {
            width: self.width,
            bodies,
            inverse_masses,
            rows: rows.iter().map(|&row| self.rows[row]).collect(),
            holds: rows.iter().map(|&row| self.holds[row]).collect(),
            compliances,
            frictional: Vec::new(),
            others,
            jacobian: blocks(&self.jacobian),
            response: blocks(&self.response),
        }
    }

    /// Removes all rows and keeps the bodies and the memory.
    pub fn clear_rows(&mut self) {
        self.rows.clear();
        self.holds.clear();
        self.compliances.clear();
        self.frictional.clear();
        self.others.clear();
        self.jacobian.clear();
        self.response.clear();
    }

    /// Removes the rows from `rows` on.
    fn truncate_rows(&mut self, rows: usize) {
        self.rows.truncate(rows);
        self.holds.truncate(rows);
        self.compliances.retain(|(row, _)| *row < rows);
        self.frictional.retain(|(first, _)| *first < rows);
        self.others.retain(|other| other.row < rows);
        self.jacobian.truncate(2 * rows * self.width);
        self.response.truncate(2 * rows * self.width);
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Whether no row touches more than two bodies.
    pub fn is_of_pairs(&self) -> bool {
        self.others.is_empty()
    }

    /// Number of bodies.
    pub fn bodies(&self) -> usize {
        self.bodies
    }

    /// Velocity components of a body.
    pub fn width(&self) -> usize {
        self.width
    }

    /// `u = J v`: rates of separation of all rows, for the velocities of all bodies one after the other.
    ///
    /// # Errors
    /// When `velocities` has not `bodies * width` numbers.
    pub fn row_velocities(&self, velocities: &[f64]) -> Result<Vec<f64>, ResponseError> {
        check_length("velocities", self.bodies * self.width, velocities.len())?;
        let speed = |row| self.entries(row).map(|entry| dot(entry.jacobian, self.block(velocities, entry.body))).sum();
        Ok((0..self.len()).map(speed).collect())
    }

    /// `M^-1 J^T f`: what the row forces (impulses) do to the accelerations (velocities) of all bodies.
    ///
    /// # Errors
    /// When `forces` has not one number for each row.
    pub fn response(&self, forces: &[f64]) -> Result<Vec<f64>, ResponseError> {
        check_length("forces", self.len(), forces.len())?;
        let mut motion = vec![0.0; self.bodies * self.width];
        for (row, &force) in forces.iter().enumerate() {
            if force != 0.0 {
                for entry in self.entries(row) {
                    let start = entry.body * self.width;
                    axpy(force, entry.response, &mut motion[start..start + self.width]);
                }
            }
        }
        Ok(motion)
    }

    /// Largest over smallest mass that the rows meet: of all bodies at all rows, `1 / (J_ib M_b^-1 J_ib^T)`. 1 without
    /// rows; bodies that a row cannot move do not count.
    pub(crate) fn mass_ratio(&self) -> f64 {
        let inverse_masses = (0..self.len()).flat_map(|row| self.entries(row)).map(|e| dot(e.jacobian, e.response));
        let extremes = inverse_masses.filter(|value| *value > 0.0);
        let (least, most) =
            extremes.fold((f64::INFINITY, 0.0), |(least, most): (f64, f64), x| (least.min(x), most.max(x)));
        if most > 0.0 { most / least } else { 1.0 }
    }

    /// The largest inverse mass of each body at a row; 0 of one that no row touches.
    pub(crate) fn largest_inverse_masses(&self) -> Vec<f64> {
        let mut largest = vec![0.0_f64; self.bodies];
        for entry in (0..self.len()).flat_map(|row| self.entries(row)) {
            largest[entry.body] = largest[entry.body].max(dot(entry.jacobian, entry.response));
        }
        largest
    }

    /// The same rows with every body's mass scaled so that its largest inverse mass at a row is 1.
    pub(crate) fn with_alike_masses(&self) -> Self {
        let largest = self.largest_inverse_masses();
        let mut alike = self.clone();
        for (index, block) in alike.response.chunks_exact_mut(self.width).enumerate() {
            let largest = largest[self.rows[index / 2].bodies[index % 2] as usize];
            if largest > 0.0 {
                for component in block {
                    *component /= largest;
                }
            }
        }
        for other in alike.others.iter_mut().filter(|other| largest[other.body] > 0.0) {
            for component in &mut other.response {
                *component /= largest[other.body];
            }
        }
        for (block, largest) in alike.inverse_masses.chunks_exact_mut(self.width * self.width).zip(largest) {
            if largest > 0.0 {
                for entry in block {
                    *entry /= largest;
                }
            }
        }
        alike
    }

    /// The inverse mass block of a body, row-major.
    pub(crate) fn inverse_mass(&self, body: usize) -> &[f64] {
        let block = self.width * self.width;
        &self.inverse_masses[body * block..(body + 1) * block]
    }

    /// The bodies that `row` touches, with their blocks.
    pub(crate) fn entries(&self, row: usize) -> impl Iterator<Item = RowEntry<'_>> {
        let bodies = self.rows[row];
        (0..usize::from(bodies.count)).map(move |slot| self.entry(row, slot))
    }

    /// `J M^-1 J^T` of one row with itself, 1/kg: what a unit force along it does along it; zero of a row that does not
    /// exist.
    pub fn mobility(&self, row: usize) -> f64 {
        let own = |entry: RowEntry<'_>| dot(entry.jacobian, entry.response);
        if row < self.len() { self.entries(row).map(own).sum() } else { 0.0 }
    }

    /// How many bodies `row` touches: 1 to 4.
    pub(crate) fn touched(&self, row: usize) -> usize {
        usize::from(self.rows[row].count)
    }

    /// The share of one body in a row; `slot` is below [`Self::touched`].
    pub(crate) fn entry(&self, row: usize, slot: usize) -> RowEntry<'_> {
        if slot >= 2 {
            let first = self.others.partition_point(|other| other.row < row);
            let OtherEntry { body, jacobian, response, .. } = &self.others[first + slot - 2];
            return RowEntry { body: *body, jacobian, response };
        }
        let start = (2 * row + slot) * self.width;
        let range = start..start + self.width;
        RowEntry {
            body: self.rows[row].bodies[slot] as usize,
            jacobian: &self.jacobian[range.clone()],
            response: &self.response[range],
        }
    }

    fn block<'a>(&self, motion: &'a [f64], body: usize) -> &'a [f64] {
        &motion[body * self.width..(body + 1) * self.width]
    }

    fn push_response(&mut self, body: usize, jacobian: &[f64]) {
        let block = self.width * self.width;
        let matrix = &self.inverse_masses[body * block..(body + 1) * block];
        // Sums of known length are unrolled.
        match self.width {
            3 => push_products::<3>(&mut self.response, matrix, jacobian),
            6 => push_products::<6>(&mut self.response, matrix, jacobian),
            width => self.response.extend(matrix.chunks_exact(width).map(|line| dot(line, jacobian))),
        }
    }

    /// Makes room for so many more rows.
    pub fn reserve(&mut self, rows: usize) {
        self.rows.reserve(rows);
        self.holds.reserve(rows);
        self.jacobian.reserve(2 * self.width * rows);
        self.response.reserve(2 * self.width * rows);
    }
}

/// Appends the product of a row-major matrix and a vector.
fn push_products<const N: usize>(products: &mut Vec<f64>, matrix: &[f64], vector: &[f64]) {
    if let Some(vector) = vector.first_chunk::<N>() {
        products.extend(matrix.as_chunks::<N>().0.iter().map(|line| dot(line, vector)));
    }
}

/// Whether a matrix is symmetric, and no diagonal entry is less than the others of its row together: then it is
/// positive semidefinite (Gershgorin), as are those of most bodies, with less work than a factorisation.
fn is_dominant<const N: usize>(matrix: &[f64]) -> bool {
    let (lines, _) = matrix.as_chunks::<N>();
    lines.iter().enumerate().all(|(row, line)| {
        let others: f64 = line.iter().enumerate().map(|(k, entry)| if k == row { 0.0 } else { entry.abs() }).sum();
        let is_symmetric = lines.iter().zip(line).take(row).all(|(other, entry)| other[row] == *entry);
        is_symmetric && others <= line[row]
    })
}

/// Whether a matrix is symmetric and positive semidefinite to rounding, by `L D L^T` with zero pivots allowed;
/// `reduced` is room to work in.
fn is_semidefinite(matrix: &[f64], width: usize, reduced: &mut Vec<f64>) -> bool {
    let at = |row: usize, column: usize| matrix[row * width + column];
    reduced.clear();
    reduced.extend_from_slice(matrix);
    for k in 0..width {
        for i in k + 1..width {
            // Bodies have blocks that are symmetric exactly and mostly zero: nothing is computed for those entries.
            let asymmetry = (at(i, k) - at(k, i)).abs();
            if asymmetry > 0.0 && asymmetry > MATRIX_ROUNDING * (at(i, i).abs() * at(k, k).abs()).sqrt() {
                return false;
            }
        }
        let pivot = reduced[k * width + k];
        let rounding = MATRIX_ROUNDING * at(k, k).abs();
        if pivot < -rounding || at(k, k) < 0.0 {
            return false;
        }
        if pivot <= rounding {
            // A zero pivot of a semidefinite matrix has a zero column: that of the Schur complement is bounded by
            // the geometric mean of the two diagonal entries, which is all that rounding leaves.
            let bound = |i: usize| (2.0 * rounding * reduced[i * width + i].max(rounding)).sqrt();
            if (k + 1..width).any(|i| reduced[i * width + k].abs() > bound(i)) {
                return false;
            }
            continue;
        }
        for i in k + 1..width {
            if reduced[i * width + k] == 0.0 {
                continue;
            }
            let factor = reduced[i * width + k] / pivot;
            for j in k + 1..width {
                reduced[i * width + j] -= factor * reduced[k * width + j];
            }
        }
    }
    true
}
