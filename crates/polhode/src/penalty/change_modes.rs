//! Changes of the modes of contacts at the present, with what they do to the ledger.
//!
//! A spring that gives way or holds again books what its elastic energy loses as friction; all else that is lost is an
//! error of the integrator.

use super::contact::{Evaluated, Grip, Push};
use super::events::{Happening, Passed};
use super::run::Run;
use crate::collision::contact_kinematics;
use crate::error::SimulationError;
use crate::identity::contact_id::ContactId;
use crate::report::event::EventKind;
use polhode_spatial::DVec3;

/// Makes some changes.
///
/// # Errors
/// When a contact that begins has no law.
pub(super) fn make(run: &mut Run<'_>, changes: &[Passed]) -> Result<(), SimulationError> {
    if changes.is_empty() {
        return Ok(());
    }
    let is_grip = |change: &&Passed| matches!(change.what, Happening::Grip(_) | Happening::Weaken(_));
    let mut energy = run.energy();
    for change in changes.iter().filter(|change| !is_grip(change)) {
        apply(run, change)?;
    }
    let after = run.energy();
    run.done.books.ledger.numerical.add(energy - after);
    energy = after;
    if changes.iter().any(|change| is_grip(&change)) {
        for change in changes.iter().filter(is_grip) {
            apply(run, change)?;
        }
        let after = run.energy();
        run.done.books.ledger.friction.add(energy - after);
    }
    Ok(())
}

/// Rate of the overlap of a contact at the present, m/s.
pub(super) fn rate(run: &Run<'_>, what: Happening) -> f64 {
    let Happening::End(id) = what else { return 0.0 };
    Evaluated::new(&run.core.model, &run.states, id, false).map_or(0.0, |at| at.rate)
}

fn apply(run: &mut Run<'_>, change: &Passed) -> Result<(), SimulationError> {
    match change.what {
        Happening::Begin(id) => {
            if let Some(kinematics) = contact_kinematics::kinematics(&run.core.model, &run.states, id) {
                let spring = run.begun(id, &kinematics)?;
                run.insert(&spring);
            }
        }
        Happening::End(id) => run.remove(id, change.t_s, -change.rate),
        Happening::Press(id) => {
            let other = |push| if push == Push::Off { Push::On } else { Push::Off };
            run.with_spring(id, |spring| spring.push = other(spring.push));
        }
        Happening::Turn(id) => run.with_spring(id, |spring| spring.loading = !spring.loading),
        Happening::Grip(id) => change_grip(run, id),
        Happening::Weaken(id) => run.with_spring(id, |spring| {
            if spring.grip == Grip::Yield {
                spring.grip = Grip::Slide;
            }
        }),
        // The contacts of the next step are those of the features that the point is at.
        Happening::Leave(_) => {}
    }
    Ok(())
}

/// A tangential spring gives way, or holds again.
fn change_grip(run: &mut Run<'_>, id: ContactId) {
    let Some(spring) = run.done.springs.iter().find(|spring| spring.id == id).copied() else { return };
    let Some(at) = run.evaluated(&spring) else { return };
    let direction = spring.vector.normalize_or_zero();
    let (grip, vector, kind) = match spring.grip {
        Grip::Stick => {
            let along = if direction == DVec3::ZERO { at.slip.normalize_or_zero() } else { direction };
            (spring.giving_way(), along, EventKind::Slide)
        }
        Grip::Yield | Grip::Slide => {
            (Grip::Stick, direction * spring.limit(spring.normal_force(&at)), EventKind::Stick)
        }
        other => (other, spring.vector, EventKind::Slide),
    };
    run.with_spring(id, |spring| (spring.grip, spring.vector, spring.slipped) = (grip, vector, 0.0));
    run.note_event(kind, &spring);
}
