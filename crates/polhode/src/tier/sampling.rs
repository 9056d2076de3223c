//! Samples and frames of the motion between two events, for the observer.

use crate::error::SimulationError;
use crate::model::reported;
use crate::report::frame::Frame;
use crate::report::observer::Observer;
use crate::solve::open_contacts::contact_samples;
use crate::tier::Tier;
use crate::tier::core::Core;
use crate::tier::joint_samples::joint_samples;
use polhode_dynamics::BodyState;
use std::sync::Arc;

/// The frame at `t` (s), when the bodies have these states.
pub(crate) fn frame(tier: &dyn Tier, core: &Core, t: f64, states: &[BodyState]) -> Frame {
    let sample = |(body, state)| reported::sample(&core.model, body, state);
    let mut books = core.accounts.books.clone();
    let energy = books.observe(&core.model, states);
    Frame {
        t_s: t,
        bodies: states.iter().take(core.model.shown()).enumerate().map(sample).collect(),
        motions: shown(core, tier.motions(core)),
        contacts: tier.contacts(core, t, states),
        joint_loads: tier.joint_loads(core, t, states),
        islands: tier.islands(core),
        energy,
        ledger: books.ledger,
        certificate: core.accounts.certificate_now(&books.ledger),
        steps: core.accounts.steps(),
    }
}

/// Those of the bodies that are shown.
fn shown<T>(core: &Core, mut of_bodies: Vec<T>) -> Vec<T> {
    of_bodies.truncate(core.model.shown());
    of_bodies
}

/// Gives the observer a sample of the states at `t` (s), unless it already has one of that time, and a frame if it
/// wants frames.
///
/// # Errors
/// When the penetration of the sample cannot be measured.
pub(crate) fn emit_sample(
    tier: &dyn Tier,
    core: &mut Core,
    states: &[BodyState],
    t: f64,
    observer: &mut dyn Observer,
) -> Result<(), SimulationError> {
    // What an observer asks for is no work of the motion.
    let work_before = core.model.work.total();
    if observer.wants_samples() || observer.wants_frames() {
        for overlap in core.overlaps_of(t, states)?.to_vec() {
            core.accounts.measures.note_sample(overlap);
        }
    }
    let emitted = core.accounts.emit_sample(&core.model, states, t, observer);
    if emitted && observer.wants_energies() {
        observer.energy(t, &core.accounts.books.clone().observe(&core.model, states));
    }
    if emitted && observer.wants_joints() {
        observer.joints(t, &joint_samples(tier, core, t, states));
    }
    if emitted && observer.wants_contacts() {
        let contacts = tier.contacts(core, t, states);
        observer.contacts(t, &contact_samples(&core.model, states, &contacts));
    }
    if emitted && observer.wants_frames() {
        observer.frame(&frame(tier, core, t, states));
    }
    core.model.work.count_since(work_before, 0);
    Ok(())
}

/// Gives the observer all samples that are due before `until` (s). `states_at` evaluates the states within the present
/// steps of the tier; it returns `None` when it has already passed the time of the sample.
///
/// # Errors
/// As `states_at`.
pub(crate) fn emit_samples_before<T: Tier>(
    until: f64,
    tier: &mut T,
    core: &mut Core,
    observer: &mut dyn Observer,
    mut states_at: impl FnMut(&mut T, &mut Core, f64) -> Result<Option<Arc<Vec<BodyState>>>, SimulationError>,
) -> Result<(), SimulationError> {
    loop {
        let t = core.accounts.next_sample_s(&core.model);
        if t >= until {
            return Ok(());
        }
        let work_before = core.model.work.total();
        let states = states_at(tier, core, t)?;
        core.model.work.count_since(work_before, 0);
        if let Some(states) = states {
            emit_sample(tier, core, &states, t, observer)?;
        }
    }
}
