//! Motions of pendulums and chains from their own equations, integrated here in steps too short to matter.

use crate::cases::bodies::GRAVITY;

/// Longest step of the integration, s: RK4 leaves less than rounding of motions of some seconds.
const STEP_S: f64 = 2e-4;

/// Accelerations of angles with these rates, rad/s^2.
type Accelerations<'a> = dyn Fn(&[f64], &[f64]) -> Vec<f64> + 'a;

/// Angles and their rates, rad and rad/s.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Angles {
    angles: Vec<f64>,
    rates: Vec<f64>,
}

impl Angles {
    /// At rest.
    pub(super) fn at_rest(angles: &[f64]) -> Self {
        Self { angles: angles.to_vec(), rates: vec![0.0; angles.len()] }
    }

    /// One angle with its rate.
    pub(super) fn one(angle: f64, rate: f64) -> Self {
        Self { angles: vec![angle], rates: vec![rate] }
    }

    /// The angles after a time (s) of motion with these accelerations.
    pub(super) fn after(&self, t: f64, accelerations: &Accelerations<'_>) -> Vec<f64> {
        let steps = (t / STEP_S).ceil();
        let mut now = self.clone();
        for _ in 0..steps as u64 {
            now = now.stepped(t / steps, accelerations);
        }
        now.angles
    }

    fn moved(&self, h: f64, slope: &Self) -> Self {
        let added = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a + h * b).collect();
        Self { angles: added(&self.angles, &slope.angles), rates: added(&self.rates, &slope.rates) }
    }

    /// One step of RK4.
    fn stepped(&self, h: f64, accelerations: &Accelerations<'_>) -> Self {
        let slope = |at: &Self| Self { angles: at.rates.clone(), rates: accelerations(&at.angles, &at.rates) };
        let first = slope(self);
        let second = slope(&self.moved(0.5 * h, &first));
        let third = slope(&self.moved(0.5 * h, &second));
        let fourth = slope(&self.moved(h, &third));
        let sum = first.moved(2.0, &second).moved(2.0, &third).moved(1.0, &fourth);
        self.moved(h / 6.0, &sum)
    }
}

/// Angular acceleration of a pendulum of this reduced length (m), from hanging.
pub(super) fn pendulum(reduced_length_m: f64) -> impl Fn(&[f64], &[f64]) -> Vec<f64> {
    move |angles, _| vec![-GRAVITY / reduced_length_m * libm::sin(angles[0])]
}

/// Those of a double pendulum of two equal particles on arms of 1 m.
pub(super) fn double_pendulum(angles: &[f64], rates: &[f64]) -> Vec<f64> {
    let (sine, cosine) = (libm::sin(angles[0] - angles[1]), libm::cos(angles[0] - angles[1]));
    let upper = -sine * rates[1] * rates[1] - 2.0 * GRAVITY * libm::sin(angles[0]);
    let lower = sine * rates[0] * rates[0] - GRAVITY * libm::sin(angles[1]);
    let determinant = 2.0 - cosine * cosine;
    vec![(upper - cosine * lower) / determinant, (2.0 * lower - cosine * upper) / determinant]
}

/// Those of a chain of equal rods of 1 m, hung from a point.
pub(super) fn chain(angles: &[f64], rates: &[f64]) -> Vec<f64> {
    let count = angles.len();
    let share = |i: usize, j: usize| (count - i.max(j)) as f64 - 0.5;
    let row = |i: usize| {
        let mass = |j: usize| {
            let cosine = libm::cos(angles[i] - angles[j]);
            if i == j { (count - i) as f64 - 2.0 / 3.0 } else { share(i, j) * cosine }
        };
        let pull = |j: usize| if i == j { 0.0 } else { share(i, j) * libm::sin(angles[i] - angles[j]) };
        let inertial: f64 = (0..count).map(|j| pull(j) * rates[j] * rates[j]).sum();
        let right = -GRAVITY * share(i, i) * libm::sin(angles[i]) - inertial;
        (0..count).map(mass).chain([right]).collect::<Vec<f64>>()
    };
    solved((0..count).map(row).collect())
}

/// The solution of linear equations, each with its right side at the end: elimination without pivots, which a mass
/// matrix needs not.
fn solved(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let count = rows.len();
    for pivot in 0..count {
        let (above, below) = rows.split_at_mut(pivot + 1);
        let own = &above[pivot];
        for row in below {
            let factor = row[pivot] / own[pivot];
            row.iter_mut().zip(own).skip(pivot).for_each(|(x, y)| *x -= factor * y);
        }
    }
    let mut found = vec![0.0; count];
    for i in (0..count).rev() {
        let known: f64 = (i + 1..count).map(|j| rows[i][j] * found[j]).sum();
        found[i] = (rows[i][count] - known) / rows[i][i];
    }
    found
}

#[cfg(test)]
mod tests {
    //! The motions are those of the references: JT-01, JT-03, JT-04.
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    /// Difference from references, rad.
    const NEAR: f64 = 1e-12;

    #[test]
    fn a_pendulum_is_where_the_elliptic_function_says() {
        let found = Angles::at_rest(&[FRAC_PI_2]).after(1.0, &pendulum(1.0));
        assert!((found[0] + 1.405_027_311_524_799).abs() < NEAR, "{found:?}");
    }

    #[test]
    fn a_double_pendulum_is_where_the_reference_says() {
        let found = Angles::at_rest(&[FRAC_PI_2; 2]).after(1.0, &double_pendulum);
        let expected = [-0.625_087_699_806_390_6, -1.034_585_085_680_012_5];
        assert!(found.iter().zip(expected).all(|(x, y)| (x - y).abs() < NEAR), "{found:?}");
    }

    #[test]
    fn a_chain_is_where_the_reference_says() {
        let found = Angles::at_rest(&[FRAC_PI_2; 4]).after(0.5, &chain);
        let expected = [0.720_398_257_457_362_2, 1.030_148_949_566_932, 1.600_398_104_793_214_5, 1.589_827_010_108_461];
        assert!(found.iter().zip(expected).all(|(x, y)| (x - y).abs() < NEAR), "{found:?}");
    }
}
