//! What a run has computed so far, counted in units of about five thousand instructions, whatever the machine.
//!
//! The runs that estimate the error of a run beside it may take a part of its work (`crate::error_estimate`). A clock
//! would make the estimate depend on the machine and on what else it does; a count has the same value everywhere and
//! for any number of threads, since sums of whole numbers have no order. It is told by what is computed most often:
//! pairs of shapes, problems of rows, bodies at the stages of integrators. No motion depends on it.
//!
//! How it fails: the units were fitted to the instructions of some shipped scenes, and are off by a factor of up to
//! two where something else is computed most often.

use crate::error::SimulationError;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// Units of a pair of shapes whose contacts or distance are found.
pub(crate) const OF_PAIR: usize = 3;

/// Units of a body at one stage of an integrator.
pub(crate) const OF_BODY: usize = 1;

/// Units of a body in a step of an integrator of high order.
pub(crate) const OF_STEP: usize = 12;

/// Units of a simulation that begins: its model, its plan.
pub(crate) const OF_BEGINNING: usize = 300;

/// Units of a row of a problem that an interior point solves, in all its iterations.
pub(crate) const OF_ROW_BY_INTERIOR_POINT: usize = 60;

/// Rows from which on a problem costs as much for each further one: each is coupled with as many others.
const COUPLED_ROWS: usize = 48;

/// Rows whose coupling with another one costs a unit.
pub(crate) const ROWS_OF_UNIT: usize = 8;

/// A count of work, which threads may share.
#[derive(Debug)]
pub(crate) struct Work {
    count: Arc<AtomicU64>,
    /// Beyond this nothing goes on.
    most: Arc<AtomicU64>,
}

impl Default for Work {
    fn default() -> Self {
        Self { count: Arc::default(), most: Arc::new(AtomicU64::new(u64::MAX)) }
    }
}

impl Clone for Work {
    /// That of a copy of the model, which has computed nothing.
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl Work {
    /// Counts so many units.
    pub(crate) fn add(&self, units: usize) {
        self.count.fetch_add(units as u64, Ordering::Relaxed);
    }

    /// Counts so many units in the place of what has been counted since the count was this, by nobody else meanwhile.
    pub(crate) fn count_since(&self, before: u64, units: usize) {
        self.count.store(before + units as u64, Ordering::Relaxed);
    }

    /// The same count, for those who compute with what was made from the model.
    pub(crate) fn shared(&self) -> Self {
        Self { count: Arc::clone(&self.count), most: Arc::clone(&self.most) }
    }

    /// Counts the solution of a problem of so many rows.
    pub(crate) fn add_problem(&self, rows: usize) {
        self.add(1 + rows + rows * rows.min(COUPLED_ROWS) / ROWS_OF_UNIT);
    }

    /// The units counted so far.
    pub(crate) fn total(&self) -> u64 {
        self.count.load(Ordering::Relaxed)
    }

    /// Lets only so many units more be counted before [`Work::check`] fails.
    pub(crate) fn allow(&self, more: u64) {
        self.most.store(self.total().saturating_add(more), Ordering::Relaxed);
    }

    /// Checks that no more was counted by `t` (s) than is allowed. What may go on for long within a step asks this.
    ///
    /// # Errors
    /// When more was: the run beside a run ends there.
    pub(crate) fn check(&self, t: f64) -> Result<(), SimulationError> {
        let most = self.most.load(Ordering::Relaxed);
        if self.total() > most { Err(SimulationError::TooMuchWork { t_s: t }) } else { Ok(()) }
    }
}
