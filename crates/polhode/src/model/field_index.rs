//! Which fields act on which bodies, so that a query about a few bodies does not evaluate all fields.

use polhode_dynamics::BodyState;
use polhode_dynamics::field::{Field, Wrench};
use std::sync::Mutex;

/// Buffers for the states and wrenches of all movable bodies; a query about a few bodies writes only their entries.
/// They are no part of the state; a query that finds them in use makes its own.
#[derive(Debug, Default)]
pub(crate) struct FieldBuffers(pub(crate) Mutex<(Vec<BodyState>, Vec<Wrench>)>);

impl Clone for FieldBuffers {
    /// Empty buffers.
    fn clone(&self) -> Self {
        Self::default()
    }
}

/// The fields by the bodies that they name. Bodies are given by their slots.
#[derive(Debug, Clone, Default)]
pub(crate) struct FieldIndex {
    /// For each movable body the fields that name it, ascending.
    named: Vec<Vec<usize>>,
    /// For each field the movable bodies that it names.
    names: Vec<Vec<usize>>,
    /// Fields that do not name their bodies, so that each must be asked.
    unnamed: Vec<usize>,
    /// For each movable body its couplings, ascending.
    couplings: Vec<Vec<usize>>,
}

impl FieldIndex {
    /// The index of these fields over `movable` bodies.
    pub(crate) fn new(fields: &[Box<dyn Field>], movable: usize) -> Self {
        let mut index =
            Self { named: vec![Vec::new(); movable], couplings: vec![Vec::new(); movable], ..Self::default() };
        for (number, field) in fields.iter().enumerate() {
            let slots = field.bodies();
            if slots.is_none() {
                index.unnamed.push(number);
            }
            let slots = slots.unwrap_or_default();
            for &slot in &slots {
                if let Some(named) = index.named.get_mut(slot) {
                    named.push(number);
                }
            }
            index.names.push(slots);
        }
        index
    }

    /// Enters a coupling of these movable bodies.
    pub(crate) fn couple(&mut self, number: usize, slots: &[usize]) {
        for &slot in slots {
            if let Some(couplings) = self.couplings.get_mut(slot) {
                couplings.push(number);
            }
        }
    }

    /// Whether a field acts on the movable body of this slot.
    pub(crate) fn acts_on(&self, fields: &[Box<dyn Field>], slot: usize) -> bool {
        let named = self.named.get(slot).is_some_and(|named| !named.is_empty());
        named || self.unnamed.iter().any(|&number| fields[number].acts_on(slot))
    }

    /// The fields that act on any of these movable bodies, ascending, and the slots of all bodies whose states those
    /// fields read, with `slots` among them. Nothing when a field does not name its bodies.
    pub(crate) fn acting_on(&self, slots: &[usize]) -> Option<(Vec<usize>, Vec<usize>)> {
        if !self.unnamed.is_empty() {
            return None;
        }
        let mut fields: Vec<usize> = slots.iter().filter_map(|&slot| self.named.get(slot)).flatten().copied().collect();
        fields.sort_unstable();
        fields.dedup();
        let mut read: Vec<usize> = fields.iter().flat_map(|&field| &self.names[field]).chain(slots).copied().collect();
        read.sort_unstable();
        read.dedup();
        Some((fields, read))
    }

    /// Couplings of the movable body of this slot.
    pub(crate) fn couplings_of(&self, slot: usize) -> &[usize] {
        self.couplings.get(slot).map_or(&[], Vec::as_slice)
    }
}

/// Slots of the bodies that a field acts on, ascending, among `movable` bodies.
pub(crate) fn acted_on(field: &dyn Field, movable: usize) -> Vec<usize> {
    field.bodies().map_or_else(
        || (0..movable).filter(|&slot| field.acts_on(slot)).collect(),
        |mut slots| {
            slots.retain(|&slot| slot < movable);
            slots.sort_unstable();
            slots.dedup();
            slots
        },
    )
}
