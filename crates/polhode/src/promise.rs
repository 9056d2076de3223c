//! What a run is judged by: the penetration and the projection that its tier promises to stay below.
//!
//! | tier | penetration of a pair | displacement by one projection | energy that projections take |
//! |---|---|---|---|
//! | `accurate` | `1e-12 s + 4 ulp`; above the default tolerance `tolerance s + 4 ulp` | `drift s + 8 ulp` | `drift E`, one or all |
//! | `accurate` by `rk4` | as above | no promise: known by the step | no promise |
//! | `stepped` | no promise: known by the step | no promise | no promise |
//! | `thesis` | no promise | projects nothing | |
//!
//! s: size of the smaller body of the pair, m; ulp: that of the largest coordinate of the two, m, and, where bodies meet,
//! what they approach each other by within four ulp of the time; tolerance: that of the method; drift: the tolerance, at
//! least ten times its default; E: the largest energy of the run, at least that of lifting all bodies by their size, J.
//! A run beyond any of these is [`Outcome::Degraded`](crate::Outcome::Degraded), whatever its tier one with a problem that
//! was not solved as asked.

use crate::accounting::books::Balance;
use crate::accounting::measures::{Limits, Measure};
use crate::core::Core;
use crate::interaction::constraint::ConstraintId;
use crate::interaction::projection::Projection;
use crate::world::{World, WorldBody};
use polhode_contact::ContactKinematics;
use polhode_dynamics::{BodyState, RigidBody};

/// Units in the last place of the time of an impact by which bodies may meet late.
const TIME_ULPS: f64 = 4.0;

/// Bodies that a warning names.
const MOST_NAMES: usize = 4;

impl Core {
    /// What the run is judged by.
    pub(crate) fn limits(&self) -> Limits {
        let drift = self.settings.promised_drift();
        let lift_j = |body: &WorldBody| {
            let mass = body.rigid.as_ref().map_or(0.0, RigidBody::mass);
            mass * self.world.gravity().length() * body.size
        };
        Limits {
            projection_energy_relative: drift.unwrap_or(f64::INFINITY),
            smallest_energy_j: self.world.bodies.iter().map(lift_j).sum(),
        }
    }

    /// Takes a contact of a pair at `t` (s) into the certificate.
    pub(crate) fn note_contact(
        &mut self,
        t: f64,
        states: &[BodyState],
        pair: (usize, usize),
        contact: &ContactKinematics,
    ) {
        self.note_separation(t, states, pair, (contact.geometry.separation, contact.separation_rate));
    }

    /// Takes the separation of a pair (m) and its rate (m/s) at `t` (s) into the certificate.
    pub(crate) fn note_separation(
        &mut self,
        t: f64,
        states: &[BodyState],
        (a, b): (usize, usize),
        (separation_m, rate): (f64, f64),
    ) {
        let promised = self.settings.promised_penetration();
        let allowed = promised.map_or(f64::INFINITY, |relative| {
            // Bodies meet at a time that can be told no finer than its rounding.
            let met_late = TIME_ULPS * f64::EPSILON * t.abs() * rate.abs();
            relative * self.world.pair_size(a, b) + self.world.judged_rounding(states, a, b) + met_late
        });
        self.accounts.measures.penetration.note(Measure { t, pair: (a, b), value: -separation_m, allowed });
    }

    /// Books a projection at `t` (s) that has led to these states, and takes it into the certificate.
    pub(crate) fn book_projection(
        &mut self,
        t: f64,
        states: &[BodyState],
        done: &Projection,
        balances: (Balance, Balance),
    ) {
        let drift = self.settings.promised_drift();
        let allowed = |(a, b): (usize, usize)| {
            drift.map_or(f64::INFINITY, |drift| drift * self.world.pair_size(a, b) + self.world.rounding(states, a, b))
        };
        if let Some(pair) = done.pair() {
            let moved = Measure { t, pair, value: done.moved_m, allowed: allowed(pair) };
            self.accounts.measures.projection.note(moved);
        }
        let taken = self.enter_projection(t, done, balances);
        self.accounts.measures.drift_energy.add(taken);
    }

    /// The same for overlaps within touch at the start, which are moved out whatever their depth.
    pub(crate) fn book_initial_projection(&mut self, t: f64, done: &Projection, balances: (Balance, Balance)) {
        if let Some(pair) = done.pair() {
            let moved = Measure { t, pair, value: done.moved_m, allowed: f64::INFINITY };
            self.accounts.measures.projection.note(moved);
        }
        self.enter_projection(t, done, balances);
    }

    /// Books a projection and counts what it has left alone; what it took, J.
    fn enter_projection(&mut self, t: f64, done: &Projection, (before, after): (Balance, Balance)) -> f64 {
        let energy_j = self.accounts.books.projection(before, after, done.work_j);
        if let Some(pair) = done.pair() {
            // What is allowed is a part of the largest energy of the run, which is known at its end.
            let taken = Measure { t, pair, value: energy_j.abs(), allowed: f64::INFINITY };
            self.accounts.measures.projection_energy.note(taken);
        }
        for (a, b) in done.jumped.iter().map(ConstraintId::bodies) {
            let names = self.world.pair_names(a, b);
            self.accounts.tolerate(t, format!("a contact of {names} whose place had jumped was not put together"));
        }
        for constraint in &done.unconverged {
            let (a, b) = constraint.bodies();
            let names = self.world.pair_names(a, b);
            let what = if constraint.contact().is_some() { "contact" } else { "pivot" };
            self.accounts.tolerate(t, format!("a {what} of {names} was not put exactly together by projection"));
        }
        energy_j
    }
}

impl World {
    /// The names of two bodies, as warnings give them.
    pub(crate) fn pair_names(&self, a: usize, b: usize) -> String {
        if a == b { self.names_of(&[a]) } else { self.names_of(&[a, b]) }
    }

    /// The names of some bodies, as warnings give them: of many the first.
    pub(crate) fn names_of(&self, bodies: &[usize]) -> String {
        let names: Vec<_> = bodies.iter().take(MOST_NAMES).map(|&body| self.bodies[body].name.as_str()).collect();
        let named = names.join(" and ");
        match bodies.len().saturating_sub(MOST_NAMES) {
            0 => named,
            more => format!("{named} and {more} more"),
        }
    }
}
