//! How a small difference grows with the motion, and the horizon: the time at which one of rounding has grown to a
//! hundredth of a body.
//!
//! Two runs by one method begin with the run, and their starts differ by rounding: by that of the run with longer
//! steps; under error control, and in a full estimate, one of the two is the run itself. With `D(t)` the largest
//! distance of the two so far, of the size of a body, a difference that was there at `s` has grown by
//!
//! `G(s, t) = D(t) / D(s)`
//!
//! and the horizon is the first time at which `D` is a hundredth. Runs by another tier would make contacts at other
//! times, and differences grow at those.
//!
//! How it fails: a difference of rounding may hit an event that another one misses, so that horizons of several starts
//! differ; where the two runs end, growth is not known from there on.

use serde::{Deserialize, Serialize};

/// The relative difference of a start disturbed by rounding.
pub(crate) const ROUNDING_OF_START: f64 = f64::EPSILON;

/// The part of a body to which a difference has grown at the horizon.
const HORIZON: f64 = 1e-2;

/// How a difference of rounding has grown so far.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Growth {
    /// The largest distance so far, of the size of a body.
    distance: f64,
    /// The horizon, s.
    pub(crate) horizon_s: Option<f64>,
}

impl Default for Growth {
    fn default() -> Self {
        Self { distance: ROUNDING_OF_START, horizon_s: None }
    }
}

impl Growth {
    /// Notes the distance of the two runs at `t` (s). By how much a difference has grown since the last one.
    pub(crate) fn note(&mut self, t: f64, distance: f64) -> f64 {
        let before = self.distance;
        self.distance = before.max(distance);
        if distance >= HORIZON && self.horizon_s.is_none() {
            self.horizon_s = Some(t);
        }
        self.distance / before
    }
}
