//! What repair did and what is left.

use crate::diagnosis::Diagnosis;
use crate::mend::Repair;
use std::fmt;

/// What one repair did.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RepairStep {
    /// Which.
    pub repair: Repair,
    /// Vertices merged or dropped, triangles dropped, swapped or turned, holes filled.
    pub count: usize,
    /// Triangles added less triangles dropped.
    pub triangles: isize,
}

/// What repair did and what is left.
#[derive(Debug, Clone, PartialEq)]
pub struct RepairReport {
    /// The repairs that changed something, in order.
    pub steps: Vec<RepairStep>,
    /// The defects before.
    pub before: Diagnosis,
    /// The defects left; those that [prevent](crate::DefectKind::prevents_solid) a solid could not be mended.
    pub after: Diagnosis,
    /// Volume before, m^3, when the mesh bounded a solid.
    pub volume_before: Option<f64>,
    /// Volume after, m^3, when it does now.
    pub volume_after: Option<f64>,
}

impl fmt::Display for RepairStep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {} {}", self.repair, self.count, self.repair.words())?;
        match self.triangles {
            0 => Ok(()),
            added @ 1.. => write!(f, " ({added} triangles added)"),
            dropped => write!(f, " ({} triangles fewer)", dropped.unsigned_abs()),
        }
    }
}
