//! Which fields act on which bodies, so that what concerns a few bodies need not ask all fields.

use polhode_dynamics::BodyState;
use polhode_dynamics::field::{Field, Wrench};
use std::cell::RefCell;

/// Buffers of all movable bodies, of which a query for a few touches those few: no part of the state.
#[derive(Debug, Default)]
pub(crate) struct FieldBuffers(pub(crate) RefCell<(Vec<BodyState>, Vec<Wrench>)>);

impl Clone for FieldBuffers {
    /// New ones.
    fn clone(&self) -> Self {
        Self::default()
    }
}

/// The fields of a world by the bodies that they name.
#[derive(Debug, Clone, Default)]
pub(crate) struct FieldIndex {
    /// For each movable body the fields that name it, ascending.
    named: Vec<Vec<usize>>,
    /// For each field the movable bodies that it names.
    names: Vec<Vec<usize>>,
    /// Fields that name no bodies and must be asked of each.
    unnamed: Vec<usize>,
    /// For each movable body the couplings that it is in, ascending.
    couplings: Vec<Vec<usize>>,
}

impl FieldIndex {
    /// Of fields over this many movable bodies.
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

    /// Takes note that coupling `number` is one of these movable bodies.
    pub(crate) fn couple(&mut self, number: usize, slots: &[usize]) {
        for &slot in slots {
            if let Some(couplings) = self.couplings.get_mut(slot) {
                couplings.push(number);
            }
        }
    }

    /// Whether a field acts on the movable body of this place.
    pub(crate) fn acts_on(&self, fields: &[Box<dyn Field>], slot: usize) -> bool {
        let named = self.named.get(slot).is_some_and(|named| !named.is_empty());
        named || self.unnamed.iter().any(|&number| fields[number].acts_on(slot))
    }

    /// The fields that act on any of these movable bodies, ascending, and all bodies that these fields or the caller names;
    /// nothing when a field names no bodies, so that all must be asked.
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

    /// Couplings of the movable body of this place.
    pub(crate) fn couplings_of(&self, slot: usize) -> &[usize] {
        self.couplings.get(slot).map_or(&[], Vec::as_slice)
    }
}

/// Places of the movable bodies, of so many, that a field acts on, ascending.
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
