//! Sums whose error does not grow with the number of terms.
//!
//! Neumaier's variant of Kahan summation: the error of the sum of n terms is at most `2u |s| + O(n u^2) sum |x_i|`
//! with `u = 2^-53`, whatever the order of the terms. Source: docs/REFERENCES.md, Neumaier 1974.

/// A running sum with a compensation term.
///
/// ```
/// use polhode_spatial::CompensatedSum;
/// let sum: CompensatedSum = [1.0, 1e100, 1.0, -1e100].into_iter().collect();
/// assert_eq!(sum.value(), 2.0);
/// ```
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct CompensatedSum {
    sum: f64,
    compensation: f64,
}

impl CompensatedSum {
    /// The empty sum.
    pub const ZERO: Self = Self { sum: 0.0, compensation: 0.0 };

    /// A sum that starts at `value`.
    pub const fn new(value: f64) -> Self {
        Self { sum: value, compensation: 0.0 }
    }

    /// The sum of the terms and its compensation, as [`CompensatedSum::parts`] has given them.
    pub const fn from_parts([sum, compensation]: [f64; 2]) -> Self {
        Self { sum, compensation }
    }

    /// The sum of the terms as it was rounded, and what makes up for that: all that a sum goes on from.
    pub const fn parts(&self) -> [f64; 2] {
        [self.sum, self.compensation]
    }

    /// Adds one term.
    pub fn add(&mut self, term: f64) {
        let total = self.sum + term;
        self.compensation +=
            if self.sum.abs() >= term.abs() { (self.sum - total) + term } else { (term - total) + self.sum };
        self.sum = total;
    }

    /// The sum so far, rounded once.
    pub fn value(&self) -> f64 {
        self.sum + self.compensation
    }
}

impl Extend<f64> for CompensatedSum {
    fn extend<T: IntoIterator<Item = f64>>(&mut self, terms: T) {
        for term in terms {
            self.add(term);
        }
    }
}

impl FromIterator<f64> for CompensatedSum {
    fn from_iter<T: IntoIterator<Item = f64>>(terms: T) -> Self {
        let mut sum = Self::ZERO;
        sum.extend(terms);
        sum
    }
}
