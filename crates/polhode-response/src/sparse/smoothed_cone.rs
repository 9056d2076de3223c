//! One contact in the smoothing Newton method: its function, and its part of a step.
//!
//! The function is `x - P(x - y / scale)` with the smoothed projection `P` onto the cone, whose eigenvalues are `(l +
//! sqrt(l^2 + 4 s^2)) / 2` of those `l` of its argument: it is zero where `x o y = scale s^2 e`, and for `s = 0` it
//! is the natural map. Its derivative has eigenvalues between 0 and 1, so that a step exists wherever `s > 0`; those
//! of `1 - P'` are the ones of `P'` at `-l`, without cancellation. Sources: Chen and Mangasarian 1996; Fukushima, Luo
//! and Tseng 2002.

use crate::friction::coulomb_cone::BlockRows;
use crate::law::MOST_ROWS;
use crate::sparse::cone_form::{ConeForm, product_of, times};
use crate::sparse::jordan::{spectral, tail};
use crate::sparse::system::RowMatrix;

/// A contact, its scale and its smoothing.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SmoothedCone {
    pub(crate) form: ConeForm,
    /// Of velocities to reactions (1/kg).
    pub(crate) scale: f64,
    /// `s^2` (N^2 s^2).
    pub(crate) smoothing: f64,
}

/// What a step asks of a contact: `dr = constant - stiffness H dv`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ConeStep {
    pub(crate) stiffness: RowMatrix,
    pub(crate) constant: BlockRows,
}

/// The argument of the projection: its eigenvalues and direction.
#[derive(Debug, Clone, Copy)]
struct Spectrum {
    up: f64,
    down: f64,
    direction: BlockRows,
}

impl Spectrum {
    fn of(z: &BlockRows) -> Self {
        let tail = tail(z);
        let mut direction: BlockRows = if tail > 0.0 { z.map(|z| z / tail) } else { [0.0; MOST_ROWS] };
        direction[0] = 0.0;
        Self { up: z[0] + tail, down: z[0] - tail, direction }
    }
}

impl SmoothedCone {
    /// The square of the function, in units of velocity.
    pub(crate) fn square(&self, r: &BlockRows, u: &BlockRows) -> f64 {
        let x = self.form.point(r);
        let (missing, _) = self.function(&x, &self.form.slipping(u).y);
        let missing_reactions = self.missing_reactions(r, &x);
        let of = |values: &BlockRows| values.iter().map(|value| value * value).sum::<f64>();
        (of(&missing) + of(&missing_reactions)) * (self.scale * self.scale)
    }

    /// `x - P(x - y / scale)`.
    fn function(&self, x: &BlockRows, y: &BlockRows) -> (BlockRows, Spectrum) {
        let z: BlockRows = std::array::from_fn(|k| x[k] - y[k] / self.scale);
        let spectrum = Spectrum::of(&z);
        let (up, down) = (self.projected(spectrum.up), self.projected(spectrum.down));
        let mut missing: BlockRows = std::array::from_fn(|k| x[k] - 0.5 * (up - down) * spectrum.direction[k]);
        missing[0] = x[0] - 0.5 * (up + down);
        (missing, spectrum)
    }

    /// What is missing of reactions that follow from `x`.
    fn missing_reactions(&self, r: &BlockRows, x: &BlockRows) -> BlockRows {
        let followed = self.form.reactions(x);
        std::array::from_fn(|k| followed[k] - r[k])
    }

    /// The step; `damping` is the share of the scale that it has as compliance.
    pub(crate) fn step(&self, r: &BlockRows, u: &BlockRows, damping: f64) -> ConeStep {
        let x = self.form.point(r);
        let slipping = self.form.slipping(u);
        let (missing, spectrum) = self.function(&x, &slipping.y);
        let Spectrum { up, down, direction } = spectrum;
        // (1 - P' + damping P') dx + P'/scale E w H dv = -missing
        let across = |up: f64, down: f64, other: f64| if up > down { other / (up - down) } else { self.slope(up) };
        let along = [self.slope(up), self.slope(down), across(up, down, self.projected(up) - self.projected(down))];
        let rest =
            [self.slope(-up), self.slope(-down), across(-down, -up, self.projected(-down) - self.projected(-up))];
        let over: [f64; 3] = std::array::from_fn(|k| 1.0 / (rest[k] + damping * along[k]));
        let scaled: [f64; 3] = std::array::from_fn(|k| along[k] * over[k] / self.scale);
        let mut inverse = spectral(&direction, scaled);
        let mut change = times(&spectral(&direction, over), &missing).map(|value| -value);
        if let Some(lessening) = self.form.lessening(&inverse, &slipping) {
            inverse = product_of(&lessening, &inverse);
            change = times(&lessening, &change);
        }
        let (followed, missing) = (self.form.reactions(&change), self.missing_reactions(r, &x));
        ConeStep {
            stiffness: self.form.stiffness(&inverse, &slipping),
            constant: std::array::from_fn(|k| followed[k] + missing[k]),
        }
    }

    /// `(l + sqrt(l^2 + 4 s^2)) / 2`.
    fn projected(&self, l: f64) -> f64 {
        let root = (l * l + 4.0 * self.smoothing).sqrt();
        if l >= 0.0 { 0.5 * (l + root) } else { 2.0 * self.smoothing / (root - l) }
    }

    /// Its derivative.
    fn slope(&self, l: f64) -> f64 {
        let root = (l * l + 4.0 * self.smoothing).sqrt();
        if root == 0.0 {
            0.5
        } else if l >= 0.0 {
            0.5 * (1.0 + l / root)
        } else {
            2.0 * self.smoothing / (root * (root - l))
        }
    }
}
