//! Mass properties by the Monte Carlo method, which the thesis names and advises against (3.2): an estimate to set
//! beside the exact integrals.
//!
//! Points are drawn uniformly from the bounding box; those inside the solid stand for its matter. With 1 inside and 0
//! outside, each point gives the ten numbers `f = 1 (1, x, y, z, x^2, y^2, z^2, yz, xz, xy)` relative to the middle of
//! the box; their means give volume, centroid and second moment, and their covariance C the standard error of each: to
//! first order a quantity is `a . mean(f)` with an `a` of its own, and its error `sqrt(a . C a / N)`. The second moment
//! is stationary in the centroid, so the error of the latter adds nothing to it in first order.
//!
//! The error falls with `N^(-1/2)`: each further digit costs a hundred times as many points (case MP-10).

use crate::{Amount, Bounds, PointLocator, SolidMesh};
use glam::DVec3;
use polhode_spatial::SplitMix64;
use thiserror::Error;

/// A number of points and the seed that determines them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MonteCarlo {
    samples: u64,
    seed: u64,
}

/// Why there is no estimate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum MonteCarloError {
    /// Too few points to have a standard error.
    #[error("a Monte Carlo estimate needs at least 2 points, found {0}")]
    Samples(u64),
    /// No two points lie inside.
    #[error("{inside} of {samples} points lie inside the solid, at least 2 are needed: ask for more points")]
    Inside {
        /// Points inside.
        inside: u64,
        /// Points drawn.
        samples: u64,
    },
}

/// An estimated number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The estimate.
    pub value: f64,
    /// Its standard error, in its unit: two estimates in three are closer to the truth.
    pub standard_error: f64,
}

/// Estimated mass properties; SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MonteCarloEstimate {
    /// Points drawn.
    pub samples: u64,
    /// Points inside.
    pub inside: u64,
    /// Volume, m^3.
    pub volume: Estimate,
    /// Mass, kg; without error when it is given.
    pub mass: Estimate,
    /// Centre of mass, m.
    pub center_of_mass: [Estimate; 3],
    /// Inertia about the centre of mass, elements xx, yy, zz, yz, xz, xy of the matrix, kg m^2.
    pub inertia: [Estimate; 6],
}

/// Numbers that a point gives.
const COUNT: usize = 10;

impl MonteCarlo {
    /// So many points, from this seed.
    ///
    /// # Errors
    /// [`MonteCarloError::Samples`] for fewer than two.
    pub const fn new(samples: u64, seed: u64) -> Result<Self, MonteCarloError> {
        if samples >= 2 { Ok(Self { samples, seed }) } else { Err(MonteCarloError::Samples(samples)) }
    }

    /// How many points.
    pub const fn samples(&self) -> u64 {
        self.samples
    }

    /// The estimate for a solid, from its density (kg/m^3) or its mass.
    ///
    /// # Errors
    /// [`MonteCarloError::Inside`] when fewer than two points lie inside.
    pub fn estimate(
        &self,
        solid: &SolidMesh,
        amount: impl Into<Amount>,
    ) -> Result<MonteCarloEstimate, MonteCarloError> {
        let locator = PointLocator::new(solid);
        self.estimate_region(solid.mesh().bounds(), |p| locator.contains(p), amount)
    }

    /// The estimate for the points of a box for which `contains` holds.
    ///
    /// # Errors
    /// As [`MonteCarlo::estimate`].
    pub fn estimate_region(
        &self,
        bounds: Bounds,
        contains: impl Fn(DVec3) -> bool,
        amount: impl Into<Amount>,
    ) -> Result<MonteCarloEstimate, MonteCarloError> {
        let (middle, half) = (bounds.center(), 0.5 * (bounds.max - bounds.min));
        let mut random = SplitMix64::new(self.seed);
        let (mut sums, mut products) = ([0.0; COUNT], [[0.0; COUNT]; COUNT]);
        let mut inside = 0;
        for _ in 0..self.samples {
            let unit = DVec3::new(random.uniform(), random.uniform(), random.uniform());
            let r = half * (2.0 * unit - 1.0);
            if !contains(middle + r) {
                continue;
            }
            inside += 1;
            let f = [1.0, r.x, r.y, r.z, r.x * r.x, r.y * r.y, r.z * r.z, r.y * r.z, r.x * r.z, r.x * r.y];
            for i in 0..COUNT {
                sums[i] += f[i];
                for j in i..COUNT {
                    products[i][j] += f[i] * f[j];
                }
            }
        }
        if inside < 2 {
            return Err(MonteCarloError::Inside { inside, samples: self.samples });
        }
        let statistics = Statistics::new(self.samples, &sums, &products);
        let size = 8.0 * half.element_product();
        Ok(statistics.estimate(inside, size, middle, amount.into()))
    }
}

/// Means and covariances of the ten numbers.
struct Statistics {
    samples: u64,
    mean: [f64; COUNT],
    covariance: [[f64; COUNT]; COUNT],
}

impl Statistics {
    fn new(samples: u64, sums: &[f64; COUNT], products: &[[f64; COUNT]; COUNT]) -> Self {
        let n = samples as f64;
        let mean = sums.map(|sum| sum / n);
        let mut covariance = [[0.0; COUNT]; COUNT];
        for i in 0..COUNT {
            for j in 0..COUNT {
                covariance[i][j] = (products[i.min(j)][i.max(j)] / n - mean[i] * mean[j]) * (n / (n - 1.0));
            }
        }
        Self { samples, mean, covariance }
    }

    /// A quantity that depends on the means as `a . mean(f)` does, to first order.
    fn quantity(&self, value: f64, a: &[f64; COUNT]) -> Estimate {
        let rows = self.covariance.iter().zip(a);
        let variance: f64 = rows.map(|(row, ai)| ai * row.iter().zip(a).map(|(c, aj)| c * aj).sum::<f64>()).sum();
        // Rounding may leave a variance of nothing below zero.
        Estimate { value, standard_error: (variance.max(0.0) / self.samples as f64).sqrt() }
    }

    fn estimate(&self, inside: u64, size: f64, middle: DVec3, amount: Amount) -> MonteCarloEstimate {
        let m = &self.mean;
        let share = m[0];
        let unit = |i: usize, value: f64| std::array::from_fn(|k| if k == i { value } else { 0.0 });
        let volume = self.quantity(size * share, &unit(0, size));
        let centroid = DVec3::new(m[1], m[2], m[3]) / share;
        let center_of_mass = [0, 1, 2].map(|axis: usize| {
            let mut a = unit(axis + 1, 1.0 / share);
            a[0] = -centroid[axis] / share;
            self.quantity(middle[axis] + centroid[axis], &a)
        });
        // Mass per point inside, and what of it is lost per point when the mass is given.
        let (scale, mass) = match amount {
            Amount::Density(density) => {
                (density.get() * size, self.quantity(density.get() * size * share, &unit(0, density.get() * size)))
            }
            Amount::Mass(mass) => (mass.get() / share, Estimate { value: mass.get(), standard_error: 0.0 }),
        };
        let inertia = [(5, 6), (4, 6), (4, 5), (7, 7), (8, 8), (9, 9)].map(|(i, j): (usize, usize)| {
            let a = central_moment(i, j, centroid);
            let mean: f64 = a.iter().zip(m).map(|(a, m)| a * m).sum();
            let mut influence = a.map(|x| x * scale);
            if matches!(amount, Amount::Mass(_)) {
                influence[0] -= scale * mean / share;
            }
            self.quantity(scale * mean, &influence)
        });
        MonteCarloEstimate { samples: self.samples, inside, volume, mass, center_of_mass, inertia }
    }
}

/// The weights of the ten numbers in an element of the inertia about the centroid: the sum of two squares of the
/// distance from it, or minus a product.
fn central_moment(i: usize, j: usize, c: DVec3) -> [f64; COUNT] {
    let mut a = [0.0; COUNT];
    if i == j {
        let (y, z) = [(1, 2), (0, 2), (0, 1)][i - 7];
        a[i] = -1.0;
        a[1 + y] = c[z];
        a[1 + z] = c[y];
        a[0] = -c[y] * c[z];
    } else {
        for square in [i, j] {
            let axis = square - 4;
            a[square] = 1.0;
            a[1 + axis] = -2.0 * c[axis];
            a[0] += c[axis] * c[axis];
        }
    }
    a
}
