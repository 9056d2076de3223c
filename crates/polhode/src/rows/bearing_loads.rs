//! Bearings that their loads press: the rows of joints with friction whose forces follow from reactions
//! (`joints/joint_friction.rs`).

use super::assembly::Assembly;
use crate::constraint::ConstraintId;
use crate::joints::joint_friction::{self, LastRound, LinearLoads, Pressed};
use polhode_response::ResponseError;
use polhode_spatial::DVec3;

impl Assembly {
    /// Sets the constant terms of the rows of contacts that a given force presses: of forces, or of impulses over `h`
    /// (s) in a step.
    pub(crate) fn press(&self, constants: &mut [f64], h: f64) {
        for (row, Pressed { force, compliance, .. }) in &self.pressed {
            constants[*row] = -compliance * force * h;
        }
    }

    /// Presses bearings by the loads that follow from these forces (N, or impulses over `h`, s) of all rows. Returns
    /// whether any changes.
    ///
    /// # Errors
    /// When there is not one force for each row.
    pub(crate) fn press_by_loads(&mut self, forces: &[f64], h: f64) -> Result<bool, ResponseError> {
        self.press_by_linear_loads((forces, h), 0, |_| None)
    }

    /// The same where forces are linear in so many constant terms: `change` has how those of all rows change with them.
    /// Bearings are pressed by the loads that would follow.
    ///
    /// # Errors
    /// When there is not one force for each row.
    pub(crate) fn press_by_linear_loads(
        &mut self,
        (forces, h): (&[f64], f64),
        constants: usize,
        change: impl Fn(&[f64]) -> Option<Vec<f64>>,
    ) -> Result<bool, ResponseError> {
        if self.pressed.is_empty() {
            return Ok(false);
        }
        let loads = self.loads_of_bearings(forces, h)?;
        let Some(renewed) = joint_friction::renewed(&self.pressed, &loads) else {
            self.last_round = LastRound::default();
            return Ok(false);
        };
        let mut changes = Vec::with_capacity(self.pressed.len());
        for (row, own) in &self.pressed {
            let mut unit = vec![0.0; constants];
            if let Some(constant) = unit.get_mut(*row) {
                *constant = -own.compliance * h;
            }
            let Some(change) = change(&unit) else { break };
            changes.push(self.loads_of_bearings(&change, h)?);
        }
        let renewed = self.last_round.next(&self.pressed, renewed);
        let are_linear = changes.len() == self.pressed.len();
        self.pressed = if are_linear { LinearLoads { loads, changes }.pressed(&self.pressed) } else { renewed };
        Ok(true)
    }

    /// What the joint of each bearing bears on its first body, what acts at levers with it, N, of these forces (N, or
    /// impulses over `h`, s) of all rows.
    fn loads_of_bearings(&self, forces: &[f64], h: f64) -> Result<Vec<DVec3>, ResponseError> {
        let forces = &*self.least(forces)?;
        let mut loads = vec![DVec3::ZERO; self.pressed.len()];
        for (of, reaction) in self.reactions(forces).filter(|(of, _)| of.softness.is_none()) {
            let ConstraintId::Joint { joint, .. } = of.id else { continue };
            let own = self.pressed.iter().zip(&mut loads).filter(|((_, own), _)| own.joint() == joint);
            own.for_each(|(_, load)| *load += (reaction.force + self.force_at_levers(of, forces)) / h);
        }
        Ok(loads)
    }

    /// Where the loads of bearings were not found: how much the last round changed them, relative to the largest, and
    /// the bodies of a bearing.
    pub(crate) fn unfound_loads(&self) -> Option<(f64, (usize, usize))> {
        let ConstraintId::Contact(id) = self.constraint(self.pressed.first()?.0)? else { return None };
        Some((self.last_round.relative_change(), (id.a, id.b))).filter(|(change, _)| *change > 0.0)
    }
}
