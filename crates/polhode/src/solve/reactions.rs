//! What the rows of a group take: forces (N) or impulses (N s) of its contacts and bilateral constraints.
//!
//! One type for forces at an instant and in a stage, and for impulses of impacts and of time steps: where it acts, what
//! it gives to the bodies, which work it does. Normal reactions are in the order of the contacts, whose geometry the
//! caller hands in.

use crate::collision::moving_surfaces;
use crate::identity::contact_id::ContactId;
use crate::joints::bilateral::{self, Bilateral, Reaction, apply_reactions, bilateral_support};
use crate::model::states_of::{set_states, states_of};
use crate::model::{Model, prescribed};
use crate::report::momentum_ledger::{Momentum, MomentumSum};
use crate::rows::assembly::{Assembly, apply_impulses};
use crate::solve::rotational_friction::{apply_moments, moment_support, moment_work};
use polhode_contact::ContactGeometry;
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;

/// Allowed apparent gain of energy by impulses, relative to the energy of the bodies and to the work of prescribed
/// motions. A larger gain means that rounding errors dominate the solution: impulses that cancel are larger than all
/// momenta by many digits.
const GAIN_ROUNDING: f64 = 1e-6;

/// A reaction at a contact along a tangent.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TangentReaction {
    pub(crate) id: ContactId,
    /// The contact, with the tangent in the place of its normal.
    pub(crate) along: ContactGeometry,
    /// On A, N, N s.
    pub(crate) value: f64,
}

impl TangentReaction {
    /// As a vector on A, world.
    pub(crate) fn vector(&self) -> DVec3 {
        self.along.normal * self.value
    }
}

/// Reactions of the rows of a group.
#[derive(Debug, Clone, Default)]
pub(crate) struct Reactions {
    /// Of the contacts, along their normals, N, N s.
    pub(crate) normal: Vec<f64>,
    /// Along tangents of contacts with friction, in the order of the contacts.
    pub(crate) tangential: Vec<TangentReaction>,
    /// Moments of friction of rolling and spinning on A, N m, N m s, world.
    pub(crate) moments: Vec<(ContactId, DVec3)>,
    /// Of bilateral constraints.
    pub(crate) bilaterals: Vec<(Bilateral, Reaction)>,
}

impl Reactions {
    /// Those of all rows of an assembly, the first of which are so many contacts.
    pub(crate) fn of(assembly: &Assembly, contacts: usize, values: &[f64]) -> Self {
        let tangential = assembly.of_tangents(values);
        let tangential = tangential.map(|(row, value)| TangentReaction { id: row.id, along: row.along, value });
        let moments = assembly.of_rotations(values).map(|(row, moment)| (row.id, row.axis * moment));
        Self {
            normal: values.get(..contacts).unwrap_or_default().to_vec(),
            tangential: tangential.collect(),
            moments: moments.collect(),
            bilaterals: assembly.reactions(values).map(|(of, reaction)| (of.clone(), reaction)).collect(),
        }
    }

    /// Those of the contacts along tangents, which stand in the place of their normals.
    pub(crate) fn along_tangents(&self) -> impl Iterator<Item = (ContactId, &ContactGeometry, f64)> + Clone {
        self.tangential.iter().map(|own| (own.id, &own.along, own.value))
    }

    /// Those of these contacts along normals.
    pub(crate) fn along_normals<'a>(
        &'a self,
        contacts: impl Iterator<Item = (ContactId, &'a ContactGeometry)> + Clone + 'a,
    ) -> impl Iterator<Item = (ContactId, &'a ContactGeometry, f64)> + Clone + 'a {
        contacts.zip(&self.normal).map(|((id, geometry), &value)| (id, geometry, value))
    }

    /// All of these contacts: along normals, then along tangents.
    pub(crate) fn at_contacts<'a>(
        &'a self,
        contacts: impl Iterator<Item = (ContactId, &'a ContactGeometry)> + Clone + 'a,
    ) -> impl Iterator<Item = (ContactId, &'a ContactGeometry, f64)> + Clone + 'a {
        self.along_normals(contacts).chain(self.along_tangents())
    }

    /// Those of bilateral constraints.
    pub(crate) fn of_bilaterals(&self) -> impl Iterator<Item = (&Bilateral, Reaction)> + Clone {
        self.bilaterals.iter().map(|(of, reaction)| (of, *reaction))
    }

    /// Moments on A.
    pub(crate) fn of_rotations(&self) -> impl Iterator<Item = (ContactId, DVec3)> + Clone + '_ {
        self.moments.iter().copied()
    }

    /// Leaves this part of them.
    pub(crate) fn shorten(&mut self, part: f64) {
        self.normal.iter_mut().for_each(|normal| *normal *= part);
        self.tangential.iter_mut().for_each(|own| own.value *= part);
        self.moments.iter_mut().for_each(|(_, moment)| *moment *= part);
        for (_, reaction) in &mut self.bilaterals {
            *reaction = Reaction { force: reaction.force * part, moment: reaction.moment * part };
        }
    }

    /// Leaves none.
    pub(crate) fn clear(&mut self) {
        self.normal.fill(0.0);
        self.tangential.clear();
        self.moments.clear();
        self.bilaterals.clear();
    }

    /// Work of prescribed motions and of surfaces that move, J; of forces the power, W.
    pub(crate) fn work<'a>(
        &'a self,
        model: &Model,
        states: &[BodyState],
        contacts: impl Iterator<Item = (ContactId, &'a ContactGeometry)> + Clone + 'a,
    ) -> f64 {
        prescribed::prescribed_work(model, states, self.at_contacts(contacts))
            + moving_surfaces::surface_work(model, states, self.along_tangents())
            + moment_work(model, states, self.of_rotations())
            + bilateral::driven_work(model, states, self.of_bilaterals())
    }

    /// Momentum that they give to the bodies that move, angular about a point; of forces its rate.
    pub(crate) fn support<'a>(
        &'a self,
        model: &Model,
        about: DVec3,
        contacts: impl Iterator<Item = (ContactId, &'a ContactGeometry)> + Clone + 'a,
    ) -> Momentum {
        support(model, about, self.at_contacts(contacts))
            + moment_support(model, self.of_rotations())
            + bilateral_support(about, self.of_bilaterals())
    }

    /// Applies these impulses to the momenta of the bodies.
    pub(crate) fn apply<'a>(
        &'a self,
        model: &Model,
        states: &mut [BodyState],
        contacts: impl Iterator<Item = (ContactId, &'a ContactGeometry)> + Clone + 'a,
    ) {
        apply_impulses(model, states, self.at_contacts(contacts));
        apply_reactions(model, states, self.of_bilaterals());
        apply_moments(model, states, self.of_rotations());
    }

    /// Applies these impulses to the momenta of some bodies. Returns by how much the energy increased beyond the work
    /// of prescribed motions and of `others`, J: what surfaces that move, springs and motors give.
    pub(crate) fn apply_with_gain<'a>(
        &'a self,
        model: &Model,
        states: &mut [BodyState],
        (bodies, contacts): (&[usize], impl Iterator<Item = (ContactId, &'a ContactGeometry)> + Clone + 'a),
        others: f64,
    ) -> Gain {
        let kinetic =
            |states: &[BodyState]| bodies.iter().map(|&body| model.energies(body, &states[body]).0).sum::<f64>();
        let before = kinetic(states);
        let by_moments = moment_work(model, states, self.of_rotations());
        let by_drivers = bilateral::driven_work(model, states, self.of_bilaterals());
        let by_contacts = prescribed::prescribed_work(model, states, self.at_contacts(contacts.clone()));
        let work = by_contacts + by_moments + others + by_drivers;
        self.apply(model, states, contacts);
        Gain { gain_j: kinetic(states) - before - work, rounding_j: GAIN_ROUNDING * (before + work.abs()) }
    }

    /// The same where they add no energy. Returns whether they do not; otherwise the states are unchanged.
    pub(crate) fn apply_without_gain<'a>(
        &'a self,
        model: &Model,
        states: &mut [BodyState],
        (bodies, contacts): (&[usize], impl Iterator<Item = (ContactId, &'a ContactGeometry)> + Clone + 'a),
    ) -> bool {
        let start = states_of(states, bodies);
        let by_surfaces = moving_surfaces::surface_work(model, states, self.along_tangents());
        let is_sound = !self.apply_with_gain(model, states, (bodies, contacts), by_surfaces).is_excess();
        if !is_sound {
            set_states(states, bodies, &start);
        }
        is_sound
    }
}

/// What energy impulses have added to bodies, beyond the work of prescribed motions and of surfaces that move.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Gain {
    /// J; negative where they have taken some.
    pub(crate) gain_j: f64,
    /// What rounding may add, J.
    rounding_j: f64,
}

impl Gain {
    /// Whether it is more than rounding.
    pub(crate) fn is_excess(self) -> bool {
        self.gain_j.is_nan() || self.gain_j > self.rounding_j
    }
}

/// Momentum that impulses or forces `p` (N s, N) along the normals of contacts give to the bodies that move, angular
/// about a point: only contacts with immovable bodies contribute, since impulses between movable bodies cancel.
pub(crate) fn support<'a>(
    model: &Model,
    about: DVec3,
    contacts: impl Iterator<Item = (ContactId, &'a ContactGeometry, f64)>,
) -> Momentum {
    let mut sum = MomentumSum::default();
    for (id, geometry, p) in contacts {
        let second = id.second().is_some_and(|second| model.carries_momentum(second));
        let sign = match (model.carries_momentum(id.a), second) {
            (true, false) => 1.0,
            (false, true) => -1.0,
            _ => continue,
        };
        let linear = geometry.normal * (sign * p);
        sum.add(Momentum { linear, angular: (geometry.point - about).cross(linear) });
    }
    sum.value()
}
