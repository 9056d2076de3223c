//! A validation case: its name, and how it gives rows whatever happens.

use super::context::Context;
use crate::row::Row;
use std::error::Error;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Whether other steps may run at the same time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Company {
    /// It shows what something takes: nothing runs at the same time.
    Alone,
    /// It builds: no other build runs at the same time.
    Build,
    /// Others run beside it.
    Beside,
}

/// What a case returns: rows, or why it could not measure anything.
pub type CaseResult = Result<Vec<Row>, Box<dyn Error>>;

/// A validation case.
#[derive(Debug)]
pub struct Case {
    /// Name, which `--only` selects by.
    pub name: &'static str,
    /// What it measures.
    pub(super) rows: fn(&Context) -> CaseResult,
}

impl Case {
    /// Its rows. It runs once, whoever asks; an error or a panic is a row that fails.
    pub fn run(&self, context: &Context) -> Vec<Row> {
        let made = context.rows.get(self.name, || Ok(guarded(self.name, || (self.rows)(context))));
        guarded(self.name, || Ok(made?.to_vec()))
    }
}

/// The rows of a case, or one that fails with the error or panic that kept it from giving any.
pub fn guarded(case: &str, rows: impl FnOnce() -> CaseResult) -> Vec<Row> {
    match catch_unwind(AssertUnwindSafe(rows)) {
        Ok(Ok(rows)) => rows,
        Ok(Err(error)) => vec![Row::broken(case, "runs", error.to_string())],
        Err(_) => vec![Row::broken(case, "runs", "panic: a bug, whatever the input was")],
    }
}
