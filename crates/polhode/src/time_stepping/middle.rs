//! The middle of a time step, where its impulses act, and what is done about slips that end within the step.

use super::kick::Kick;
use crate::identity::contact_id::ContactId;

/// What is done about slips that end within a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stops<'a> {
    /// Those whose static friction exceeds the kinetic one are looked for. When one is found, the report names it and
    /// the step has to be made again in two parts.
    Sought,
    /// The same, of all contacts: where friction that holds at the end of the step would gain energy.
    SoughtOfAll,
    /// Those of these contacts end with the step.
    At(&'a [ContactId]),
}

/// Which problem of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Problem {
    /// That at its start, of contacts that close within it without a bounce (`closing.rs`).
    Closing,
    /// That in its middle.
    Sustained,
}

/// The middle of a step, where impulses act, or its start.
#[derive(Debug, Clone, Copy)]
pub(super) struct Middle<'a> {
    pub(super) problem: Problem,
    /// When, s.
    pub(super) t: f64,
    /// Length of the step, s.
    pub(super) h: f64,
    pub(super) stops: Stops<'a>,
    /// What the fields have just given.
    pub(super) kick: &'a Kick,
}
