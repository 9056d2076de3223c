//! Settings of a search for an impact.

/// Settings of the search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImpactSearch {
    /// Separations up to this, relative to the joint size, count as touch at the start of the search
    /// ([`crate::clearance::touch_tolerance`]). Range 1e-15 to 1e-3.
    pub touch_relative: f64,
    /// Largest `j` of the times `t0 + (t1 - t0) 2^-j` at which a pair that touches at the start `t0` of the interval is
    /// evaluated, in order of time. Halvings within which the bodies cannot have moved noticeably are skipped.
    pub departure_halvings: u32,
    /// Largest number of evaluations of the separation for one pair of parts; reaching it is an error.
    pub max_evaluations: u32,
}

impl Default for ImpactSearch {
    fn default() -> Self {
        Self { touch_relative: 1e-11, departure_halvings: 48, max_evaluations: 100_000 }
    }
}
