//! Pieces of a run that are computed again by another method, where a whole run by it costs too much.
//!
//! A method that is consistently wrong agrees with itself at any step; it is wrong where bodies meet or touch. Pieces
//! therefore begin at the last comparison before that, and go on until bodies have come apart or they cost too much.
//! What they add to the errors of the bodies stays, and is added at the same rate where bodies touch and no piece runs.

use crate::error_estimate::references::{Part, Reference};
use crate::report::run_error::ReferenceKind;
use crate::run::accompany::{Ending, spent};
use crate::run::simulation::Simulation;
use crate::scene::ErrorEstimation;

/// Pieces that must be payable where bodies only touch: one of them is kept for the next event.
const PIECES_KEPT: f64 = 2.0;

impl Simulation {
    /// Begins a piece at the last comparison, if bodies have met or touched since.
    pub(super) fn begin_piece(&mut self) {
        let kind = ReferenceKind::OtherMethod;
        let (events, touching_pairs) = (self.core.accounts.events(), self.tier.touching_pairs());
        let present = self.start_at_present();
        let before = self.references.before.replace(present);
        let pieces = &mut self.references.course.pieces;
        let has_met = events > pieces.events;
        (pieces.events, pieces.had_contact) = (events, has_met || touching_pairs > 0);
        let is_needless = !pieces.had_contact
            || self.references.effort == ErrorEstimation::Off
            || self.references.runs(kind)
            || !self.kinds(self.references.effort).any(|one| one == kind);
        let known = self.references.course.of(kind);
        let Some(before) = before.filter(|_| !is_needless && !known.has_failed) else { return };
        let cost = self.beginning(kind) + known.per_second * (self.core.t - before.t_s);
        let left = self.allowed().at_once - spent(&self.references.course, &self.references.running);
        if left >= cost * if has_met { 1.0 } else { PIECES_KEPT } {
            self.begin_reference(kind, &before, Part::Piece);
        }
    }

    /// Ends a piece after bodies have come apart.
    pub(super) fn end_pieces(&mut self) {
        if self.references.course.pieces.had_contact {
            return;
        }
        let mut running = std::mem::take(&mut self.references.running);
        if let Some(place) = running.iter().position(Reference::is_piece_by_method) {
            self.end_reference(&mut running, place, Ending::Apart);
        }
        self.references.running = running;
    }
}
