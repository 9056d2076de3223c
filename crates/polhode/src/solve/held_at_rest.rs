//! Forces that hold bodies at rest, of any number of contacts, without a matrix of their rows.
//!
//! All contacts are asked to stick; the forces balance to rounding and lie in the cones of static friction. None where
//! no such forces were found: the bodies may move.

use super::accelerations::{FreeMotion, blocks_of};
use crate::collision::touch::Touch;
use crate::model::{Loads, Model};
use crate::rows::assembly::Assembly;
use crate::rows::frictional_contact::FrictionalContact;
use polhode_dynamics::BodyState;
use polhode_response::{Ask, Memory, Question, ResponseError, SolverStatus};
use polhode_spatial::DVec3;

/// Forces on body A of contacts, in their order, that hold bodies at rest.
#[derive(Debug, Clone)]
pub(crate) struct HeldAtRest {
    /// Along the normals, N.
    pub(crate) normal: Vec<f64>,
    /// Of friction, world, N.
    pub(crate) friction: Vec<DVec3>,
}

impl HeldAtRest {
    /// Those of contacts that stick, between `bodies` (movable, ascending, at rest) at `t` (s) under these loads; none
    /// where none were found that hold all of them.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(crate) fn of(
        model: &Model,
        (t, states): (f64, &[BodyState]),
        bodies: &[usize],
        contacts: &[Touch],
        loads: &Loads,
    ) -> Result<Option<Self>, ResponseError> {
        let frictional: Vec<_> =
            contacts.iter().map(|touch| FrictionalContact::of_touch(model, states, touch)).collect();
        let rows = contacts.iter().map(|touch| (touch.id, touch.kinematics.geometry));
        let mut assembly = Assembly::new(model, states, bodies, rows)?;
        let blocks = blocks_of(&mut assembly, states, &frictional)?;
        let FreeMotion { free, constants } = FreeMotion::of(&assembly, model, (t, states), contacts, loads)?;
        let known = Question { blocks: Some(&blocks), constants: &constants, ..Question::default() };
        let held = assembly.answer(known, Ask::Balance { free: &free }, &mut Memory::default())?;
        if held.report.status != SolverStatus::Solved {
            return Ok(None);
        }
        let normal = held.reactions.iter().take(contacts.len()).copied().collect();
        let mut forces = assembly.of_tangents(&held.reactions);
        let along = |friction: &Option<FrictionalContact>| {
            let rows = friction.as_ref().map_or(0, |friction| friction.tangents().len());
            forces.by_ref().take(rows).map(|(row, force)| row.along.normal * force).sum()
        };
        Ok(Some(Self { normal, friction: frictional.iter().map(along).collect() }))
    }
}
