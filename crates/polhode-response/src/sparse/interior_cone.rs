//! One contact in the interior point: its point, and its part of a Newton step.
//!
//! With the scaling `W` a step of the equations of `y` and of `x o y` is `dx = B (W (lambda \ right) + rest - E w H
//! dv)`, `B = (W^2 + E w C T + shift)^-1`, `rest = y - w u - slip`; symbols as in the form of the cone.

use crate::friction::coulomb_cone::BlockRows;
use crate::law::MOST_ROWS;
use crate::sparse::cone_form::{ConeForm, Slipping, product_of, times};
use crate::sparse::jordan::{Scaling, UNIT, inner, longest_step, product, quotient};
use crate::sparse::system::RowMatrix;

/// A contact at one point of the method.
#[derive(Debug, Clone, Copy)]
pub(crate) struct InteriorCone {
    form: ConeForm,
    x: BlockRows,
    y: BlockRows,
    dx: BlockRows,
    dy: BlockRows,
    /// The `x.y` that it starts from: it has this share of all of them.
    weight: f64,
    scaling: Scaling,
    /// `W x = W^-1 y`.
    lambda: BlockRows,
    rest: BlockRows,
    slipping: Slipping,
    /// `B`.
    inverse: RowMatrix,
    /// `W (lambda \ right) + rest`.
    right: BlockRows,
}

impl InteriorCone {
    /// At `x = reaction e`, `y = rate e`.
    pub(crate) fn new(form: ConeForm, reaction: f64, rate: f64) -> Self {
        let zero = [0.0; MOST_ROWS];
        Self {
            form,
            x: UNIT.map(|unit| unit * reaction),
            y: UNIT.map(|unit| unit * rate),
            dx: zero,
            dy: zero,
            weight: reaction * rate,
            scaling: Scaling::default(),
            lambda: zero,
            rest: zero,
            slipping: form.slipping(&zero),
            inverse: [zero; MOST_ROWS],
            right: zero,
        }
    }

    /// `r`.
    pub(crate) fn reactions(&self) -> BlockRows {
        self.form.reactions(&self.x)
    }

    /// `x.y`, of that at the start.
    pub(crate) fn gap(&self) -> f64 {
        inner(&self.x, &self.y) / self.weight
    }

    /// `x.y` at the start.
    pub(crate) fn weight(&self) -> f64 {
        self.weight
    }

    /// `y_0 / x_0` (1/kg).
    pub(crate) fn ratio(&self) -> f64 {
        self.y[0] / self.x[0]
    }

    /// The gap after a step of this length.
    pub(crate) fn gap_after(&self, length: f64) -> f64 {
        let moved = |x: &BlockRows, d: &BlockRows| -> BlockRows { std::array::from_fn(|k| x[k] + length * d[k]) };
        inner(&moved(&self.x, &self.dx), &moved(&self.y, &self.dy)) / self.weight
    }

    /// Linearises at `u`, with this share of the change of its slip; returns `K`. `shift` is the compliance that the
    /// step alone has (1/kg).
    pub(crate) fn linearise(&mut self, u: &BlockRows, share: f64, shift: f64) -> RowMatrix {
        self.slipping = self.form.slipping(u);
        self.slipping.theta = self.slipping.theta.map(|theta| share * theta);
        self.rest = std::array::from_fn(|k| self.y[k] - self.slipping.y[k]);
        self.scaling = Scaling::of(&self.x, &self.y);
        self.lambda = self.scaling.times(&self.x);
        self.inverse = self.scaling.inverse_square(shift);
        if let Some(lessening) = self.form.lessening(&self.inverse, &self.slipping) {
            self.inverse = product_of(&lessening, &self.inverse);
        }
        self.form.stiffness(&self.inverse, &self.slipping)
    }

    /// The right side of the predictor, which aims at `x o y = 0`; returns `k`.
    pub(crate) fn aim_at_zero(&mut self) -> BlockRows {
        // W (lambda \ -lambda o lambda) = -y
        self.right = std::array::from_fn(|k| self.rest[k] - self.y[k]);
        self.constant()
    }

    /// The right side of the step to this gap, with the product of the changes of the last one; returns `k`.
    pub(crate) fn aim_at(&mut self, gap: f64) -> BlockRows {
        let changes = product(&self.scaling.times(&self.dx), &self.scaling.inverse_times(&self.dy));
        let own = product(&self.lambda, &self.lambda);
        let wanted: BlockRows = std::array::from_fn(|k| self.weight * gap * UNIT[k] - own[k] - changes[k]);
        let scaled = self.scaling.times(&quotient(&self.lambda, &wanted));
        self.right = std::array::from_fn(|k| scaled[k] + self.rest[k]);
        self.constant()
    }

    fn constant(&self) -> BlockRows {
        self.form.reactions(&times(&self.inverse, &self.right))
    }

    /// Takes in what a step does to the rates, `H dv`; returns its longest length, up to the boundary.
    pub(crate) fn take_step(&mut self, rates: &BlockRows) -> f64 {
        let taken = self.slipping.turned(&self.form.weighted(rates));
        self.dx = times(&self.inverse, &std::array::from_fn(|k| self.right[k] - taken[k]));
        let yielding = self.form.yielding(&self.form.reactions(&self.dx));
        let rates: BlockRows = std::array::from_fn(|k| rates[k] + yielding[k]);
        let change = self.slipping.turned(&self.form.weighted(&rates));
        self.dy = std::array::from_fn(|k| change[k] - self.rest[k]);
        longest_step(&self.x, &self.dx).min(longest_step(&self.y, &self.dy))
    }

    /// Goes so far.
    pub(crate) fn advance(&mut self, length: f64) {
        for k in 0..MOST_ROWS {
            self.x[k] += length * self.dx[k];
            self.y[k] += length * self.dy[k];
        }
    }
}
