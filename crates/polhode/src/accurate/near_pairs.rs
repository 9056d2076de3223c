//! Pairs of bodies that may meet, each with the time of its impact (`impact_search.rs` finds them).

use crate::collision::boxes::Boxes;
use crate::snapshot::{SnapshotError, content};
use crate::tier::core::Core;
use std::collections::BTreeMap;

/// What is known of a pair that may meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Watch {
    /// The search covers times up to here, s.
    pub(super) until: f64,
    /// The first impact found, s; infinite when there is none.
    pub(super) impact: f64,
}

/// The pairs of bodies that may meet.
#[derive(Debug)]
pub(super) struct NearPairs {
    pub(super) boxes: Boxes,
    pub(super) watches: BTreeMap<(usize, usize), Watch>,
    /// Partners of each body, ascending.
    pub(super) partners: Vec<Vec<usize>>,
    /// Time up to which the boxes of flights and of kinematic bodies are valid, s.
    pub(super) flight_end: f64,
}

impl NearPairs {
    /// No pairs yet, of this many bodies.
    pub(super) fn new(core: &Core, bodies: usize) -> Self {
        let boxes = Boxes::new(core.settings.broad_phase, bodies);
        Self { boxes, watches: BTreeMap::new(), partners: vec![Vec::new(); bodies], flight_end: f64::NEG_INFINITY }
    }

    /// One body more.
    pub(super) fn make_room(&mut self) {
        self.boxes.make_room();
        self.partners.push(Vec::new());
    }

    /// The pairs as plain data.
    pub(super) fn save(&self) -> content::NearPairs {
        let watch =
            |(&(a, b), &Watch { until, impact }): (&(usize, usize), &Watch)| content::Watch { a, b, until, impact };
        content::NearPairs {
            boxes: self.boxes.save(),
            watches: self.watches.iter().map(watch).collect(),
            partners: self.partners.clone(),
            flight_end: self.flight_end,
        }
    }

    /// The pairs of such data.
    ///
    /// # Errors
    /// When they name a body that does not exist.
    pub(super) fn restored(core: &Core, saved: &content::NearPairs) -> Result<Self, SnapshotError> {
        let bodies = core.model.bodies.len();
        let is_list = |(body, list): (usize, &Vec<usize>)| {
            list.is_sorted_by(|x, y| x < y) && list.iter().all(|&other| other < bodies && other != body)
        };
        if saved.partners.len() != bodies || !saved.partners.iter().enumerate().all(is_list) {
            return Err(SnapshotError::Invalid("the lists of bodies that may meet do not fit its bodies"));
        }
        let mut watches = BTreeMap::new();
        for &content::Watch { a, b, until, impact } in &saved.watches {
            if a >= b || b >= bodies {
                return Err(SnapshotError::Invalid("a pair that may meet names a body that it does not have"));
            }
            watches.insert((a, b), Watch { until, impact });
        }
        let boxes = Boxes::restored(&core.model, core.settings.broad_phase, &saved.boxes)?;
        Ok(Self { boxes, watches, partners: saved.partners.clone(), flight_end: saved.flight_end })
    }

    /// The impacts found: time (s) and pair.
    pub(super) fn impacts(&self) -> impl Iterator<Item = (f64, (usize, usize))> {
        self.watches.iter().map(|(&pair, watch)| (watch.impact, pair))
    }

    /// The bodies that may meet `body`, ascending.
    pub(super) fn partners(&self, body: usize) -> &[usize] {
        &self.partners[body]
    }
}
