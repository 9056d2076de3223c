//! Reactions of bilateral constraints alone, under loads that are given: `G l = -b` with `G = J M^-1 J^T` and the
//! constant terms b of the accelerations of their rows.
//!
//! What else acts on the bodies (springs, fields) is among the loads. Large trees of joints are eliminated first, as
//! everywhere. Where rows depend on each other the least reactions are taken. How it fails: a state that is not finite.

use crate::joints::bilateral::{Bilateral, Reaction};
use crate::model::{Loads, Model};
use crate::rows::assembly::Assembly;
use polhode_dynamics::BodyState;
use polhode_response::{Ask, Memory, Question, ResponseError};

/// The reactions of a group of bodies.
#[derive(Debug)]
pub(crate) struct JointReactions {
    pub(crate) assembly: Assembly,
    /// Multipliers of its rows, N.
    pub(crate) forces: Vec<f64>,
}

impl JointReactions {
    /// Of the bilateral constraints of these bodies (movable, ascending) at `t` (s) under these loads.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(crate) fn solve(
        model: &Model,
        (t, states): (f64, &[BodyState]),
        bodies: &[usize],
        loads: &Loads,
    ) -> Result<Self, ResponseError> {
        let assembly = Assembly::new(model, states, bodies, std::iter::empty())?;
        let free = assembly.free_accelerations(model, states, loads);
        let constants = assembly.acceleration_constants(model, t, states, &free, std::iter::empty())?;
        let known = Question { constants: &constants, ..Question::default() };
        let forces = assembly.answer(known, Ask::Hold, &mut Memory::default())?.reactions;
        Ok(Self { assembly, forces })
    }

    /// The constraints and their reactions.
    pub(crate) fn reactions(&self) -> impl Iterator<Item = (&Bilateral, Reaction)> + Clone {
        self.assembly.reactions(&self.forces)
    }
}
