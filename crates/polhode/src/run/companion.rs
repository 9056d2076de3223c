//! The companion of a run: the same run with longer time steps in its stretches of crowded events (`accompany.rs`).

/// The companion of a run that is an `S`.
#[derive(Debug)]
pub(crate) enum Companion<S> {
    /// No stretch of crowded events has begun.
    None,
    /// It runs beside the run, at most a longest step behind it.
    Beside(Box<S>),
    /// It has ended, for this reason.
    Lost(String),
    /// The simulation is itself a companion.
    Itself,
}
