//! The result of a search for an impact.

/// The result of a search for an impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImpactReport {
    /// First time at which the pair touches, s; none without an impact in the interval.
    pub time: Option<f64>,
    /// Separation at that time, or at the end of the interval, m.
    pub separation: f64,
    /// How many separations were evaluated.
    pub evaluations: u32,
    /// Number of subdivisions of arcs of tori.
    pub cuts: u32,
}
