//! A square matrix in blocks, of which only those that are not zero are kept: the Delassus operator of contacts that
//! share bodies with a few others.
//!
//! Block rows are stored one after the other (compressed rows), each block row-major. The product with a vector costs
//! as many operations as there are entries, and its order of summation is fixed.

use crate::dense::kernels::axpy;
use crate::error::{ResponseError, check_finite, check_length};
use crate::law::{CONTACT_ROWS, MOST_ROWS};

/// Largest asymmetry `|G_ij - G_ji| / sqrt(G_ii G_jj)` of a matrix that counts as symmetric (no unit). Delassus
/// matrices of other programs reach 0.005, from orientations that are not quite orthogonal; they are solved as they
/// are.
const LARGEST_ASYMMETRY: f64 = 0.01;

/// A block-sparse square matrix.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct BlockMatrix {
    /// First row of each block row; one more entry than block rows.
    offsets: Vec<usize>,
    /// First block of each block row; one more entry than block rows.
    first: Vec<usize>,
    /// Block column of each block, ascending within a row.
    columns: Vec<usize>,
    /// First value of each block; one more entry than blocks.
    starts: Vec<usize>,
    values: Vec<f64>,
    /// The blocks on the diagonal.
    diagonal: Vec<usize>,
}

/// One block of a block row.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Block<'a> {
    /// Its block column.
    pub(crate) column: usize,
    /// Its entries, row-major.
    pub(crate) values: &'a [f64],
}

impl BlockMatrix {
    /// A matrix of blocks `(block row, block column, entries row-major)` in any order; those that are not given are
    /// zero. `sizes` are the rows of each block row. Blocks on the diagonal are added where they are missing.
    ///
    /// # Errors
    /// When a size is not 1 to 3, a block is out of range, given twice, of the wrong length or not finite, a diagonal
    /// entry is negative, or the matrix is not symmetric to one part in a hundred.
    pub fn from_blocks(sizes: &[usize], mut blocks: Vec<(usize, usize, Vec<f64>)>) -> Result<Self, ResponseError> {
        let (mut matrix, _) = Self::without_blocks(sizes)?;
        for (row, column, values) in &blocks {
            let outside = (*row).max(*column);
            if outside >= sizes.len() {
                return Err(ResponseError::UnknownRow { row: outside, rows: sizes.len() });
            }
            check_length("block of the Delassus matrix", sizes[*row] * sizes[*column], values.len())?;
            check_finite("block of the Delassus matrix", values)?;
        }
        let mut has_diagonal = vec![false; sizes.len()];
        blocks.iter().filter(|(row, column, _)| row == column).for_each(|&(row, ..)| has_diagonal[row] = true);
        let missing = (0..sizes.len()).filter(|&row| !has_diagonal[row]);
        blocks.extend(missing.map(|row| (row, row, vec![0.0; sizes[row] * sizes[row]])));
        blocks.sort_by_key(|&(row, column, _)| (row, column));
        // A block whose mirror image is zero has it nevertheless: the pattern is symmetric.
        let has = |row, column| blocks.binary_search_by_key(&(row, column), |&(row, column, _)| (row, column)).is_ok();
        let lonely = blocks.iter().filter(|&&(row, column, _)| !has(column, row));
        let mirrors: Vec<_> = lonely.map(|(row, column, values)| (*column, *row, vec![0.0; values.len()])).collect();
        if !mirrors.is_empty() {
            blocks.extend(mirrors);
            blocks.sort_by_key(|&(row, column, _)| (row, column));
        }
        if let Some(pair) = blocks.windows(2).find(|pair| (pair[0].0, pair[0].1) == (pair[1].0, pair[1].1)) {
            return Err(ResponseError::RepeatedBlock { row: pair[0].0, column: pair[0].1 });
        }
        for (row, column, values) in blocks {
            matrix.first[row + 1] += 1;
            if row == column {
                matrix.diagonal[row] = matrix.columns.len();
            }
            matrix.columns.push(column);
            matrix.values.extend_from_slice(&values);
            matrix.starts.push(matrix.values.len());
        }
        for row in 0..sizes.len() {
            matrix.first[row + 1] += matrix.first[row];
        }
        matrix.check_symmetry()?;
        Ok(matrix)
    }

    /// The blocks of a dense matrix, row-major; blocks of zeros are left out.
    ///
    /// # Errors
    /// Those of [`from_blocks`](Self::from_blocks); when `entries` has the wrong length.
    pub fn from_dense(sizes: &[usize], entries: &[f64]) -> Result<Self, ResponseError> {
        let rows: usize = sizes.iter().sum();
        check_length("Delassus matrix", rows.saturating_mul(rows), entries.len())?;
        check_finite("Delassus matrix", entries)?;
        Self::from_entries(sizes, |row, column| entries[row * rows + column])
    }

    /// The blocks of a matrix whose entries (row, column) are given by a function; blocks of zeros are left out, if
    /// their mirror image is zero, too.
    ///
    /// # Errors
    /// Those of [`from_blocks`](Self::from_blocks).
    pub fn from_entries(sizes: &[usize], entry: impl Fn(usize, usize) -> f64) -> Result<Self, ResponseError> {
        let (mut matrix, starts) = Self::without_blocks(sizes)?;
        let is_zero = |row: usize, column: usize| {
            let mut pairs = starts[row].clone().flat_map(|i| starts[column].clone().map(move |j| (i, j)));
            pairs.all(|(i, j)| entry(i, j) == 0.0)
        };
        for row in 0..sizes.len() {
            for column in 0..sizes.len() {
                if row == column {
                    matrix.diagonal[row] = matrix.columns.len();
                } else if is_zero(row, column) && is_zero(column, row) {
                    continue;
                }
                let start = matrix.values.len();
                matrix.columns.push(column);
                matrix.values.extend(
                    starts[row]
                        .clone()
                        .flat_map(|i| starts[column].clone().map(move |j| (i, j)))
                        .map(|(i, j)| entry(i, j)),
                );
                check_finite("block of the Delassus matrix", &matrix.values[start..])?;
                matrix.starts.push(matrix.values.len());
            }
            matrix.first[row + 1] = matrix.columns.len();
        }
        matrix.check_symmetry()?;
        Ok(matrix)
    }

    /// A matrix of block rows of these sizes without blocks, and the rows of each.
    fn without_blocks(sizes: &[usize]) -> Result<(Self, Vec<std::ops::Range<usize>>), ResponseError> {
        let mut offsets = Vec::with_capacity(sizes.len() + 1);
        offsets.push(0);
        for (block, &rows) in sizes.iter().enumerate() {
            if !(1..=MOST_ROWS).contains(&rows) {
                return Err(ResponseError::FrictionRows { block, rows });
            }
            offsets.push(offsets[block] + rows);
        }
        let ranges = offsets.windows(2).map(|pair| pair[0]..pair[1]).collect();
        let (first, diagonal) = (vec![0; sizes.len() + 1], vec![0; sizes.len()]);
        Ok((Self { offsets, first, diagonal, starts: vec![0], ..Self::default() }, ranges))
    }

    /// Number of block rows.
    pub fn len(&self) -> usize {
        self.offsets.len().saturating_sub(1)
    }

    /// Whether there is no block.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.offsets.last().copied().unwrap_or_default()
    }

    /// Rows of a block row.
    pub(crate) fn size(&self, block: usize) -> usize {
        self.offsets[block + 1] - self.offsets[block]
    }

    /// The rows of a block row.
    pub(crate) fn range(&self, block: usize) -> std::ops::Range<usize> {
        self.offsets[block]..self.offsets[block + 1]
    }

    /// The blocks of a block row, by ascending block column.
    pub(crate) fn blocks(&self, row: usize) -> impl Iterator<Item = Block<'_>> {
        (self.first[row]..self.first[row + 1]).map(|k| Block { column: self.columns[k], values: self.block_values(k) })
    }

    /// Block columns of a block row.
    pub(crate) fn neighbours(&self, row: usize) -> &[usize] {
        &self.columns[self.first[row]..self.first[row + 1]]
    }

    /// The block on the diagonal, row-major.
    pub(crate) fn diagonal(&self, block: usize) -> &[f64] {
        self.block_values(self.diagonal[block])
    }

    /// Entry of a diagonal block on the diagonal.
    pub(crate) fn diagonal_entry(&self, block: usize, row: usize) -> f64 {
        self.diagonal(block)[row * self.size(block) + row]
    }

    /// The same matrix with `more(block, row)` added to its diagonal.
    pub(crate) fn with_diagonal(&self, more: impl Fn(usize, usize) -> f64) -> Self {
        let mut matrix = self.clone();
        for block in 0..self.len() {
            let (start, size) = (self.starts[self.diagonal[block]], self.size(block));
            for row in 0..size {
                matrix.values[start + row * (size + 1)] += more(block, row);
            }
        }
        matrix
    }

    /// The block of a block row and column, if it is kept.
    pub(crate) fn block(&self, row: usize, column: usize) -> Option<&[f64]> {
        let neighbours = self.neighbours(row);
        // Contacts of the same bodies all move each other: their row has every block.
        let is_full = neighbours.len() == self.len();
        let place = if is_full { column } else { neighbours.binary_search(&column).ok()? };
        Some(self.block_values(self.first[row] + place))
    }

    /// Adds `G_row x` to the rows of one block row.
    pub(crate) fn add_row_product(&self, row: usize, x: &[f64], sum: &mut [f64]) {
        let blocks = self.first[row]..self.first[row + 1];
        if self.size(row) == CONTACT_ROWS {
            let mut parts = [sum[0], sum[1], sum[2]];
            for k in blocks {
                let (values, start) = (self.block_values(k), self.offsets[self.columns[k]]);
                if let (&[a, b, c, d, e, f, g, h, i], Some(&[x, y, z])) = (values, x.get(start..start + CONTACT_ROWS)) {
                    parts[0] += a * x + b * y + c * z;
                    parts[1] += d * x + e * y + f * z;
                    parts[2] += g * x + h * y + i * z;
                } else {
                    add_product(values, &x[start..self.offsets[self.columns[k] + 1]], &mut parts);
                }
            }
            sum.copy_from_slice(&parts);
            return;
        }
        for k in blocks {
            let column = self.columns[k];
            add_product(self.block_values(k), &x[self.range(column)], sum);
        }
    }

    /// `G x + constant`.
    pub(crate) fn times_plus(&self, x: &[f64], constant: &[f64], product: &mut Vec<f64>) {
        product.clear();
        product.extend_from_slice(constant);
        for row in 0..self.len() {
            self.add_row_product(row, x, &mut product[self.offsets[row]..self.offsets[row + 1]]);
        }
    }

    /// `G^T x`.
    pub(crate) fn transposed_times(&self, x: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; x.len()];
        for row in 0..self.len() {
            let x = &x[self.range(row)];
            for block in self.blocks(row) {
                let target = &mut product[self.range(block.column)];
                for (line, &value) in block.values.chunks_exact(target.len().max(1)).zip(x) {
                    axpy(value, line, target);
                }
            }
        }
        product
    }

    fn block_values(&self, k: usize) -> &[f64] {
        &self.values[self.starts[k]..self.starts[k + 1]]
    }

    fn check_symmetry(&self) -> Result<(), ResponseError> {
        let diagonal: Vec<f64> = (0..self.len())
            .flat_map(|block| (0..self.size(block)).map(move |k| self.diagonal_entry(block, k)))
            .collect();
        if let Some(row) = diagonal.iter().position(|value| *value < 0.0) {
            return Err(ResponseError::NegativeDiagonal { row, value: diagonal[row] });
        }
        for row in 0..self.len() {
            for block in self.blocks(row) {
                let (height, width) = (self.size(row), self.size(block.column));
                let mirror = self.block(block.column, row);
                for (at, &value) in block.values.iter().enumerate() {
                    let (i, j) = (at / width, at % width);
                    let other = mirror.map_or(0.0, |mirror| mirror[j * height + i]);
                    let (global_row, global_column) = (self.offsets[row] + i, self.offsets[block.column] + j);
                    let size = diagonal[global_row].sqrt() * diagonal[global_column].sqrt();
                    if (value - other).abs() > LARGEST_ASYMMETRY * size {
                        return Err(ResponseError::Asymmetric { row: global_row, column: global_column, value, other });
                    }
                }
            }
        }
        Ok(())
    }
}

/// `sum += A x` for a row-major `A`.
fn add_product(values: &[f64], x: &[f64], sum: &mut [f64]) {
    for (target, line) in sum.iter_mut().zip(values.chunks_exact(x.len().max(1))) {
        *target += line.iter().zip(x).map(|(a, b)| a * b).sum::<f64>();
    }
}
