//! Swept boxes of moving bodies, and the pairs of bodies whose boxes overlap.
//!
//! A box contains a body at every time of an interval, enlarged by a margin. The broad phase finds all pairs when many
//! boxes are new ([`Boxes::all_pairs`]); when the box of one body is new, it is compared with all others
//! ([`Boxes::near`]).

use crate::error::SimulationError;
use crate::model::Model;
use crate::scene::BroadPhaseMethod;
use crate::snapshot::SnapshotError;
use crate::snapshot::numbers::Vector;
use polhode_contact::{Aabb, BroadPhase, Shape, swept_aabb};
use polhode_spatial::{DVec3, Motion};

/// The boxes of all bodies that have a shape.
#[derive(Debug)]
pub(crate) struct Boxes {
    /// The box of each body; none for a body without a shape.
    by_body: Vec<Option<Aabb>>,
    broad_phase: Box<dyn BroadPhase>,
    /// Buffers: the boxes of the bodies that have one, the indices of these bodies, and the pairs found.
    packed: Vec<Aabb>,
    bodies: Vec<usize>,
    pairs: Vec<(u32, u32)>,
}

impl Boxes {
    /// No boxes yet, for `bodies` bodies.
    pub(crate) fn new(broad_phase: BroadPhaseMethod, bodies: usize) -> Self {
        Self {
            by_body: vec![None; bodies],
            broad_phase: broad_phase.build(),
            packed: Vec::new(),
            bodies: Vec::new(),
            pairs: Vec::new(),
        }
    }

    /// Adds the entry of a new body, without a box.
    pub(crate) fn make_room(&mut self) {
        self.by_body.push(None);
    }

    /// Sets the box of a body with this motion over an interval (s), enlarged by a margin (m).
    pub(crate) fn set(&mut self, model: &Model, body: usize, motion: &dyn Motion, interval: (f64, f64), margin: f64) {
        self.by_body[body] = model.bodies[body].shape.as_ref().map(|shape| swept_box(shape, motion, interval, margin));
    }

    /// Sets or removes the box of a body.
    pub(crate) fn put(&mut self, body: usize, aabb: Option<Aabb>) {
        self.by_body[body] = aabb;
    }

    /// Lower and upper bounds of all boxes.
    pub(crate) fn save(&self) -> Vec<Option<[Vector; 2]>> {
        let bounds = |aabb: &Aabb| [aabb.min().to_array(), aabb.max().to_array()];
        self.by_body.iter().map(|aabb| aabb.as_ref().map(bounds)).collect()
    }

    /// The boxes with these bounds.
    ///
    /// # Errors
    /// When bounds are reversed, or there is not one entry for each body.
    pub(crate) fn restored(
        model: &Model,
        broad_phase: BroadPhaseMethod,
        saved: &[Option<[Vector; 2]>],
    ) -> Result<Self, SnapshotError> {
        if saved.len() != model.bodies.len() {
            return Err(SnapshotError::Invalid("it does not have one box for each body"));
        }
        let mut boxes = Self::new(broad_phase, saved.len());
        for (own, bounds) in boxes.by_body.iter_mut().zip(saved) {
            let Some([min, max]) = *bounds else { continue };
            let aabb = Aabb::new(DVec3::from_array(min), DVec3::from_array(max));
            *own = Some(aabb.map_err(|_| SnapshotError::Invalid("the bounds of a box are reversed"))?);
        }
        Ok(boxes)
    }

    /// Calls `found` with every pair (A < B, ascending) of bodies that may collide and whose boxes overlap.
    ///
    /// # Errors
    /// When there are more bodies than the broad phase can number.
    pub(crate) fn all_pairs(
        &mut self,
        model: &Model,
        mut found: impl FnMut(usize, usize),
    ) -> Result<(), SimulationError> {
        self.packed.clear();
        self.bodies.clear();
        for (body, aabb) in self.by_body.iter().enumerate() {
            if let Some(aabb) = aabb {
                self.packed.push(*aabb);
                self.bodies.push(body);
            }
        }
        self.broad_phase.pairs(&self.packed, &mut self.pairs).map_err(SimulationError::BroadPhase)?;
        for &(i, j) in &self.pairs {
            let (a, b) = (self.bodies[i as usize], self.bodies[j as usize]);
            if model.scene.may_collide(a, b) {
                found(a, b);
            }
        }
        Ok(())
    }

    /// Calls `found` with every body that may collide with `body` and whose box overlaps its box, ascending.
    pub(crate) fn near(&self, model: &Model, body: usize, mut found: impl FnMut(usize)) {
        let Some(own) = &self.by_body[body] else { return };
        for (other, aabb) in self.by_body.iter().enumerate() {
            if aabb.as_ref().is_some_and(|aabb| aabb.overlaps(own)) && model.scene.may_collide(body, other) {
                found(other);
            }
        }
    }
}

/// Box of a moving shape, enlarged by a margin. A motion without bounds gets an unbounded box; the search for its
/// impacts then reports the error.
fn swept_box(shape: &Shape, motion: &dyn Motion, interval: (f64, f64), margin: f64) -> Aabb {
    swept_aabb(shape, motion, interval.0, interval.1).and_then(|aabb| aabb.inflated(margin)).unwrap_or(Aabb::UNBOUNDED)
}
