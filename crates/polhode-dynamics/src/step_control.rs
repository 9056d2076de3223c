//! Control of the length of steps by an error estimate: one controller for free motion and for motion with contacts.
//!
//! A step is attempted with the proposed length. It is accepted when the largest of its errors
//! ([`crate::error_allowance`], each in units of what is allowed) is at most one; otherwise a shorter one is attempted
//! from the same state. The system ([`Steps`]) makes the attempts and says what a quantity may err; the control says
//! what the next length is:
//!
//! | attempt | proposed next, of the attempted length h |
//! |---|---|
//! | accepted, by error e | `h f(e)`, with the factor `f` of [`Dop853::next_step_factor`] |
//! | accepted, cut short by its limit | the same, but no less than was proposed before, unless `f(e) < 1` |
//! | refused, by error e or NaN | `h f(e)`, at most [`REFUSED_FACTOR`] `h` |
//! | failed: the forces could not be evaluated | [`FAILED_FACTOR`] `h` |
//!
//! Source: docs/REFERENCES.md, Hairer, Norsett and Wanner, II.4. How it fails: at a singularity lengths shrink until
//! the smallest that the system sets, and the system's own error for that is returned.

use crate::Dop853;

/// The largest factor for repeating a refused step (dimensionless): one that differs less would mostly be refused
/// again.
pub const REFUSED_FACTOR: f64 = 0.9;

/// The factor for repeating a step in which the forces could not be evaluated (dimensionless): nothing is known of its
/// error.
pub const FAILED_FACTOR: f64 = 0.25;

/// An attempted step.
#[derive(Debug)]
pub enum Attempt<S> {
    /// It was made.
    Made {
        /// The step.
        step: S,
        /// Its largest error in units of what is allowed; none of a method that estimates none, whose steps are all
        /// accepted.
        error: Option<f64>,
    },
    /// It was made, and this error of it, in units of what is allowed, is more than allowed or NaN.
    Refused(f64),
    /// It could not be made.
    Failed,
}

impl<S> Attempt<S> {
    /// The step and its error (zero without an estimate), if the error is allowed.
    pub fn accepted(self) -> Option<(S, f64)> {
        match self {
            Self::Made { step, error } => {
                let error = error.unwrap_or(0.0);
                (error <= 1.0).then_some((step, error))
            }
            Self::Refused(_) | Self::Failed => None,
        }
    }

    /// Its error in units of what is allowed; none where none is known.
    fn error(&self) -> Option<f64> {
        match self {
            Self::Made { error, .. } => *error,
            Self::Refused(error) => Some(*error),
            Self::Failed => None,
        }
    }

    /// What the next length is of the attempted one: up to infinity without an estimate.
    fn factor(&self) -> f64 {
        match self {
            Self::Made { error, .. } => error.map_or(f64::INFINITY, Dop853::next_step_factor),
            Self::Refused(error) => Dop853::next_step_factor(*error),
            Self::Failed => FAILED_FACTOR,
        }
    }
}

/// A system from whose present state steps are attempted. All lengths are in s and positive.
pub trait Steps {
    /// A step that was made.
    type Step;
    /// Why no step can be made.
    type Error;

    /// Longest step possible: to the next time at which one has to end.
    fn limit_s(&self) -> f64;

    /// Only steps above this length are attempted, unless the limit cuts them short.
    fn smallest_s(&self) -> f64;

    /// Length of the first attempt, at most the limit, where `proposed_s` is proposed.
    fn first_length(&self, proposed_s: f64) -> f64;

    /// Length of an attempt after one that was not accepted, below the limit, where `proposed_s` is proposed.
    fn repeated_length(&self, proposed_s: f64) -> f64 {
        proposed_s
    }

    /// Attempts a step from the present state, which stays as it is.
    ///
    /// # Errors
    /// When no attempt makes sense any more.
    fn attempt(&mut self, length_s: f64) -> Result<Attempt<Self::Step>, Self::Error>;

    /// The error for a step as short as [`Steps::smallest_s`], after an attempt with an error of `last` in units of
    /// what is allowed, if there was one.
    fn too_small(&self, last: Option<f64>) -> Self::Error;
}

/// A step that was accepted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accepted<S> {
    /// The step.
    pub step: S,
    /// Its length, s.
    pub length_s: f64,
    /// Its largest error in units of what is allowed; zero without an estimate.
    pub error: f64,
}

/// The control of steps that follow each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepControl {
    proposed_s: f64,
}

impl StepControl {
    /// With a proposed length for the first step (s, positive); infinity proposes the limit.
    pub const fn proposing(proposed_s: f64) -> Self {
        Self { proposed_s }
    }

    /// Proposed length of the next step, s.
    pub const fn proposed_s(self) -> f64 {
        self.proposed_s
    }

    /// The first step that is accepted.
    ///
    /// # Errors
    /// Those of the system, and [`Steps::too_small`] when no step above the smallest length is accepted.
    pub fn next_step<S: Steps>(&mut self, system: &mut S) -> Result<Accepted<S::Step>, S::Error> {
        let mut length_s = system.first_length(self.proposed_s);
        let mut last = None;
        loop {
            if length_s < system.limit_s() && self.proposed_s <= system.smallest_s() {
                return Err(system.too_small(last));
            }
            let attempt = system.attempt(length_s)?;
            let factor = attempt.factor();
            last = attempt.error();
            if let Some((step, error)) = attempt.accepted() {
                let next = length_s * factor;
                self.proposed_s = if factor >= 1.0 { self.proposed_s.max(next) } else { next };
                return Ok(Accepted { step, length_s, error });
            }
            self.proposed_s = length_s * factor.min(REFUSED_FACTOR);
            length_s = system.repeated_length(self.proposed_s);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Attempt, FAILED_FACTOR, REFUSED_FACTOR, StepControl, Steps};

    /// A system whose steps err as `(length/longest)^8`, and fail above another length.
    struct Power {
        limit_s: f64,
        longest_s: f64,
        failing_s: f64,
        attempted: Vec<f64>,
    }

    impl Steps for Power {
        type Step = ();
        type Error = Option<f64>;

        fn limit_s(&self) -> f64 {
            self.limit_s
        }

        fn smallest_s(&self) -> f64 {
            1e-12
        }

        fn first_length(&self, proposed_s: f64) -> f64 {
            proposed_s.min(self.limit_s)
        }

        fn attempt(&mut self, length_s: f64) -> Result<Attempt<()>, Option<f64>> {
            self.attempted.push(length_s);
            let error = Some(libm::pow(length_s / self.longest_s, 8.0));
            Ok(if length_s > self.failing_s { Attempt::Failed } else { Attempt::Made { step: (), error } })
        }

        fn too_small(&self, last: Option<f64>) -> Option<f64> {
            last
        }
    }

    fn power(limit_s: f64, longest_s: f64, failing_s: f64) -> Power {
        Power { limit_s, longest_s, failing_s, attempted: Vec::new() }
    }

    #[test]
    fn a_refused_step_is_repeated_shorter_and_a_failed_one_much_shorter() {
        let mut system = power(4.0, 1.0, 3.0);
        let mut control = StepControl::proposing(f64::INFINITY);
        let accepted = control.next_step(&mut system).expect("a short step is accepted");
        assert_eq!(system.attempted[..2], [4.0, 4.0 * FAILED_FACTOR]);
        assert_eq!((accepted.length_s, accepted.error), (1.0, 1.0));
        assert_eq!(control.proposed_s(), 0.9);
        let mut system = power(1.01, 1.0, 3.0);
        StepControl::proposing(2.0).next_step(&mut system).expect("a shorter step is accepted");
        assert!(system.attempted[1] <= REFUSED_FACTOR * 1.01);
    }

    #[test]
    fn a_step_cut_short_keeps_what_was_proposed() {
        let mut control = StepControl::proposing(0.5);
        control.next_step(&mut power(1e-3, 1.0, 3.0)).expect("a short step is accepted");
        assert_eq!(control.proposed_s(), 0.5);
    }

    #[test]
    fn where_every_step_errs_the_length_ends_at_the_smallest() {
        let mut system = power(1.0, 0.0, 3.0);
        assert_eq!(StepControl::proposing(1.0).next_step(&mut system).err(), Some(Some(f64::INFINITY)));
        let mut failing = power(1.0, 1.0, 0.0);
        assert_eq!(StepControl::proposing(1.0).next_step(&mut failing).err(), Some(None));
    }
}
