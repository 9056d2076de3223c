//! A limit of the promise that a run has exceeded.

use crate::identity::body_id::BodyId;
use std::fmt;

/// A limit of the promise that a run has exceeded: shown, it is a warning of the report.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct BrokenPromise {
    /// When, s; none for what is of the whole run.
    pub t_s: Option<f64>,
    /// The two bodies, or twice the one; none for what is of all bodies.
    pub bodies: Option<[BodyId; 2]>,
    /// What was exceeded and by how much, in words.
    pub what: String,
    /// The measured value, in the unit of its limit; none where a problem was not solved at all.
    pub value: Option<f64>,
    /// The limit; none where a problem was not solved at all.
    pub limit: Option<f64>,
    /// What would help, in words; none where nothing is known to.
    pub cure: Option<String>,
}

impl BrokenPromise {
    /// Something that exceeded its limit.
    pub(crate) fn exceeding(what: String, value: f64, limit: f64) -> Self {
        Self { t_s: None, bodies: None, what, value: Some(value), limit: Some(limit), cure: None }
    }

    /// At this time, s.
    pub(crate) fn at(self, t_s: f64) -> Self {
        Self { t_s: Some(t_s), ..self }
    }

    /// Of these bodies, by their numbers.
    pub(crate) fn of(self, (a, b): (usize, usize)) -> Self {
        Self { bodies: Some([BodyId::new(a), BodyId::new(b)]), ..self }
    }

    /// This would help.
    pub(crate) fn cured_by(self, cure: impl Into<String>) -> Self {
        Self { cure: Some(cure.into()), ..self }
    }

    /// A problem that was not solved, in words.
    pub(crate) fn unsolved(what: String) -> Self {
        Self { t_s: None, bodies: None, what, value: None, limit: None, cure: None }
    }
}

impl fmt::Display for BrokenPromise {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.value.is_none() {
            return write!(f, "{} (degraded)", self.what);
        }
        if let Some(t_s) = self.t_s {
            // As many digits as a reader needs.
            write!(f, "t = {} s: ", t_s as f32)?;
        }
        write!(f, "degraded: {}", self.what)?;
        match &self.cure {
            Some(cure) => write!(f, ": {cure}"),
            None => Ok(()),
        }
    }
}
