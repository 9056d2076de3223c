//! What an impact law resolves: the rows with their velocities before and their restitutions.

use super::settings::ImpactSettings;
use crate::delassus::Delassus;
use crate::error::{ResponseError, check_finite, check_length};
use crate::problem::ContactProblem;

/// An impact at the rows of a contact problem.
#[derive(Debug, Clone, Copy)]
pub struct ImpactProblem<'a> {
    /// The rows.
    pub contacts: &'a ContactProblem,
    /// Their Delassus matrix, 1/kg.
    pub delassus: &'a Delassus,
    /// `u-` of each row, m/s.
    pub u_before: &'a [f64],
    /// Restitution of each row, from 0 to 1; that of a bilateral row is not used.
    pub restitution: &'a [f64],
    /// Tolerances and limits.
    pub settings: &'a ImpactSettings,
}

impl ImpactProblem<'_> {
    /// Checks the problem and returns the largest speed of approach (at bilateral rows, of either sign), m/s.
    ///
    /// # Errors
    /// When a list has the wrong length, a number is not finite, or a restitution is outside `[0, 1]`.
    pub(super) fn approach(&self) -> Result<f64, ResponseError> {
        let Self { contacts, delassus, u_before, restitution, settings } = *self;
        let rows = contacts.len();
        contacts.check_frictionless()?;
        check_length("Delassus matrix", rows, delassus.len())?;
        check_length("row velocities", rows, u_before.len())?;
        check_length("restitution", rows, restitution.len())?;
        check_finite("row velocities", u_before)?;
        delassus.check_finite()?;
        settings.solver.check()?;
        if !(0.0..1.0).contains(&settings.threshold) {
            let (field, accepted) = ("threshold", "at least 0 and below 1");
            return Err(ResponseError::Setting { field, accepted, value: settings.threshold });
        }
        if let Some((row, &value)) = restitution.iter().enumerate().find(|(_, e)| !(0.0..=1.0).contains(*e)) {
            return Err(ResponseError::Restitution { row, value });
        }
        let speed = |(row, u): (usize, &f64)| if contacts.is_bilateral(row) { u.abs() } else { -u };
        Ok(u_before.iter().enumerate().map(speed).fold(0.0, f64::max))
    }

    /// Whether a row is a joint's.
    pub(super) fn is_bilateral(&self, row: usize) -> bool {
        self.contacts.is_bilateral(row)
    }

    /// The restitutions of the contacts: of all rows but the bilateral ones.
    pub(super) fn contact_restitutions(&self) -> impl Iterator<Item = f64> + '_ {
        let rows = self.restitution.iter().enumerate();
        rows.filter(|&(row, _)| !self.is_bilateral(row)).map(|(_, &e)| e)
    }
}
