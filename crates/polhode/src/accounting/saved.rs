//! Conversion of the accounts of a run to plain data and back.

use super::Accounts;
use super::books::Books;
use super::measures::Measures;
use super::occurrences::Occurrences;
use super::stretches::Stretches;
use crate::identity::body_id::BodyId;
use crate::report::event::{Event, EventKind};
use crate::report::ledger::Ledger;
use crate::report::momentum_ledger::{MomentumLedger, MomentumSum};
use crate::report::run_report::{Certificate, CrowdedStretch};
use crate::scene::Promise;
use crate::snapshot::numbers::{read_momentum, write_momentum};
use crate::snapshot::{SnapshotError, content};
use polhode_spatial::{CompensatedSum, DVec3};
use std::collections::VecDeque;

impl Accounts {
    /// The accounts as plain data.
    pub(crate) fn save(&self) -> content::Accounts {
        content::Accounts {
            books: save_books(&self.books),
            certificate: save_certificate(&self.certificate),
            warnings: self.warnings.save(),
            tolerated: self.tolerated.save(),
            choices: self.choices.save(),
            measures: self.measures.save(),
            crowded: self.crowded.0.iter().map(save_stretch).collect(),
            step_errors: self.step_errors,
            events: self.events.iter().map(save_event).collect(),
            event_count: self.event_count,
            steps: self.steps,
            next_sample: self.next_sample,
            last_sample_s: self.last_sample_s,
        }
    }

    /// The accounts of a run with this promise, of a scene with this many bodies.
    ///
    /// # Errors
    /// When an event is of a body that does not exist.
    pub(crate) fn restored(saved: &content::Accounts, bodies: usize, promise: Promise) -> Result<Self, SnapshotError> {
        Ok(Self {
            promise,
            books: restored_books(&saved.books),
            certificate: restored_certificate(&saved.certificate),
            warnings: Occurrences::restored(&saved.warnings),
            tolerated: Occurrences::restored(&saved.tolerated),
            choices: Occurrences::restored(&saved.choices),
            measures: Measures::restored(&saved.measures, bodies)?,
            crowded: Stretches(saved.crowded.iter().map(restored_stretch).collect()),
            step_errors: saved.step_errors,
            events: saved.events.iter().map(|event| restored_event(event, bodies)).collect::<Result<_, _>>()?,
            event_count: saved.event_count,
            steps: saved.steps,
            next_sample: saved.next_sample,
            last_sample_s: saved.last_sample_s,
            without_errors: VecDeque::new(),
        })
    }
}

fn save_stretch(stretch: &CrowdedStretch) -> content::CrowdedStretch {
    let CrowdedStretch { from_s, to_s, bodies, steps, error, max_residual } = *stretch;
    content::CrowdedStretch { from_s, to_s, bodies, steps, error, max_residual }
}

fn restored_stretch(saved: &content::CrowdedStretch) -> CrowdedStretch {
    let content::CrowdedStretch { from_s, to_s, bodies, steps, error, max_residual } = *saved;
    CrowdedStretch { from_s, to_s, bodies, steps, error, max_residual }
}

fn save_books(books: &Books) -> content::Books {
    // Every field is named here, so that the compiler finds a new one that has been forgotten.
    let Ledger {
        impact,
        friction,
        rest,
        damping,
        external,
        projection,
        numerical,
        initial_j,
        current_j,
        scale_j,
        momentum,
    } = books.ledger;
    content::Books {
        impact: impact.parts(),
        friction: friction.parts(),
        rest: rest.parts(),
        damping: damping.parts(),
        external: external.parts(),
        projection: projection.parts(),
        numerical: numerical.parts(),
        initial_j,
        current_j,
        scale_j,
        initial_potential_j: books.initial_potential_j,
        momentum: save_momentum(&momentum),
    }
}

fn restored_books(saved: &content::Books) -> Books {
    let sum = CompensatedSum::from_parts;
    let ledger = Ledger {
        impact: sum(saved.impact),
        friction: sum(saved.friction),
        rest: sum(saved.rest),
        damping: sum(saved.damping),
        external: sum(saved.external),
        projection: sum(saved.projection),
        numerical: sum(saved.numerical),
        initial_j: saved.initial_j,
        current_j: saved.current_j,
        scale_j: saved.scale_j,
        momentum: restored_momentum(&saved.momentum),
    };
    Books { ledger, initial_potential_j: saved.initial_potential_j, contact_energy_j: 0.0 }
}

fn save_momentum(ledger: &MomentumLedger) -> content::MomentumLedger {
    let MomentumLedger {
        about,
        gravity,
        support,
        fields,
        program,
        rest,
        projection,
        numerical,
        initial,
        current,
        scale_linear,
        scale_angular,
    } = *ledger;
    content::MomentumLedger {
        about: about.to_array(),
        gravity: gravity.parts(),
        support: support.parts(),
        fields: fields.parts(),
        program: program.parts(),
        rest: rest.parts(),
        projection: projection.parts(),
        numerical: numerical.parts(),
        initial: write_momentum(initial),
        current: write_momentum(current),
        scale_linear,
        scale_angular,
    }
}

fn restored_momentum(saved: &content::MomentumLedger) -> MomentumLedger {
    let sum = MomentumSum::from_parts;
    MomentumLedger {
        about: DVec3::from_array(saved.about),
        gravity: sum(saved.gravity),
        support: sum(saved.support),
        fields: sum(saved.fields),
        program: sum(saved.program),
        rest: sum(saved.rest),
        projection: sum(saved.projection),
        numerical: sum(saved.numerical),
        initial: read_momentum(saved.initial),
        current: read_momentum(saved.current),
        scale_linear: saved.scale_linear,
        scale_angular: saved.scale_angular,
    }
}

fn save_certificate(certificate: &Certificate) -> content::Certificate {
    // The other fields are computed when a report is filled, from the measures and from what was tolerated.
    content::Certificate {
        max_penetration_m: certificate.max_penetration_m,
        max_acceleration_error_bound: certificate.max_acceleration_error_bound,
        max_step_error: certificate.max_step_error,
        factorisations: certificate.factorisations,
        fallbacks: certificate.fallbacks,
    }
}

fn restored_certificate(saved: &content::Certificate) -> Certificate {
    Certificate {
        max_penetration_m: saved.max_penetration_m,
        max_acceleration_error_bound: saved.max_acceleration_error_bound,
        max_step_error: saved.max_step_error,
        factorisations: saved.factorisations,
        fallbacks: saved.fallbacks,
        ..Certificate::default()
    }
}

fn save_event(event: &Event) -> content::Event {
    let Event { t_s: t, kind, body_a, body_b, point, normal, impulse, energy_change_j } = *event;
    let kind = match kind {
        EventKind::Impact => content::EventKind::Impact,
        EventKind::ContactBegin => content::EventKind::ContactBegin,
        EventKind::ContactEnd => content::EventKind::ContactEnd,
        EventKind::Rest => content::EventKind::Rest,
        EventKind::Wake => content::EventKind::Wake,
        EventKind::Detach => content::EventKind::Detach,
        EventKind::Stick => content::EventKind::Stick,
        EventKind::Slide => content::EventKind::Slide,
        EventKind::Jam => content::EventKind::Jam,
        EventKind::Break => content::EventKind::Break,
    };
    let (point, normal) = (point.to_array(), normal.to_array());
    let (body_a, body_b) = (body_a.index(), body_b.map(BodyId::index));
    content::Event { t, kind, body_a, body_b, point, normal, impulse, energy_change_j }
}

fn restored_event(saved: &content::Event, bodies: usize) -> Result<Event, SnapshotError> {
    if saved.body_a >= bodies || saved.body_b.is_some_and(|body| body >= bodies) {
        return Err(SnapshotError::Invalid("an event is of a body that the scene does not have"));
    }
    let kind = match saved.kind {
        content::EventKind::Impact => EventKind::Impact,
        content::EventKind::ContactBegin => EventKind::ContactBegin,
        content::EventKind::ContactEnd => EventKind::ContactEnd,
        content::EventKind::Rest => EventKind::Rest,
        content::EventKind::Wake => EventKind::Wake,
        content::EventKind::Detach => EventKind::Detach,
        content::EventKind::Stick => EventKind::Stick,
        content::EventKind::Slide => EventKind::Slide,
        content::EventKind::Jam => EventKind::Jam,
        content::EventKind::Break => EventKind::Break,
    };
    Ok(Event {
        t_s: saved.t,
        kind,
        body_a: BodyId::new(saved.body_a),
        body_b: saved.body_b.map(BodyId::new),
        point: DVec3::from_array(saved.point),
        normal: DVec3::from_array(saved.normal),
        impulse: saved.impulse,
        energy_change_j: saved.energy_change_j,
    })
}
