//! What a search for an impact found.

/// What a search found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImpactReport {
    /// First time at which the pair closes, s.
    pub time: Option<f64>,
    /// Separation at that time, or at the end of the interval, m.
    pub separation: f64,
    /// How many separations were evaluated.
    pub evaluations: u32,
    /// How often arcs of rings were cut to bound their motion.
    pub cuts: u32,
}
