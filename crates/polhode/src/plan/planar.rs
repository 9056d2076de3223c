//! Planar motion: finds the bodies of a scene whose motion stays in a plane.
//!
//! Let one plane be a plane of mirror symmetry of some bodies, shape and mass, and of their velocities, of gravity and
//! of the fixed bodies that they touch. The motion of frictionless bodies is unique (erratum E14), and the mirror image
//! of a motion is a motion too. So the motion is its own mirror image and stays in the plane. Each body then has two
//! velocity components in the plane and one angular velocity about its normal, and of two contacts that are mirror
//! images of each other one suffices: an answer to the thesis's "under what conditions we can model a simulation using
//! the 2D equations". In space the same motion takes twice the contacts and twice the unknowns, and rounding may lead
//! out of the plane, which an unstable motion amplifies.
//!
//! With friction a motion need not be unique. The mirror image of Coulomb's law is the same law: where the motion is
//! unique it keeps its symmetry, and where it is not, the plane has one of the motions that space has. A contact and
//! its mirror image slip alike, along the plane; their forces across it cancel, and their cones become one interval
//! (`collision/slip_directions.rs`). That asks for normals in the plane: bodies that rub are half-spaces, balls beside
//! convex bodies, or prisms along the normal of the plane, since two edges of other bodies may touch with normals that
//! lean out of it, where friction wedges bodies in ways that one interval does not have.
//!
//! Bodies on which joints or force fields act, that a motion carries, or that are not their own mirror images, are
//! outside of the plane. They change nothing as long as they touch none of the others; those that they touch leave the
//! plane ([`PlanarBodies::meet`]). So a joint somewhere decides nothing about a pile elsewhere.
//!
//! Assumption: the laws treat all contacts of an instant alike. Propagation, which strikes one contact after the other,
//! breaks the mirror symmetry; so do the forces of a linear programme. Fails: never; a scene without such a plane is
//! simulated in space.

use crate::collision::contact_set;
use crate::model::plane_of_motion::{Membership, PlanarBodies, PlaneOfMotion};
use crate::model::{Model, tolerances};
use crate::plan::mirror_image::{Defect, Form, SYMMETRY_RELATIVE};
use crate::scene::{ContactMethod, ImpactLaw, Integrator, Response};
use crate::tier::facts::{IntegratorChoice, TierFeature};
use crate::tier::settings::Settings;
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;
use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::fmt::Write;

/// The bodies of a scene whose motion is planar, with the measured fact that decides it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PlanarFinding {
    pub(crate) planar: PlanarBodies,
    pub(crate) fact: String,
}

impl PlanarFinding {
    pub(crate) fn off(fact: impl Into<String>) -> Self {
        Self { planar: PlanarBodies::default(), fact: fact.into() }
    }

    /// That of the bodies which are in planar motion at present.
    pub(crate) fn of(model: &Model) -> Self {
        let (moving, all) = (model.planar.bodies().count(), model.movable.len());
        let fact = format!("{moving} of {all} bodies that move are in planar motion, and have met no others");
        Self { planar: model.planar.clone(), fact }
    }
}

/// Looks for a plane of symmetry of bodies of the scene in these states: the one in which most of them move.
pub(crate) fn find(model: &Model, states: &[BodyState], settings: &Settings) -> PlanarFinding {
    if let Some(fact) = forbidden(model, settings) {
        return PlanarFinding::off(fact);
    }
    let inside: Vec<usize> = model.movable.iter().copied().filter(|&body| reason(model, body).is_none()).collect();
    let bodies_outside = || (0..model.bodies.len()).filter_map(|body| reason(model, body));
    let is_of_groups = settings.takes(TierFeature::PlanarGroups);
    if let Some(fact) = bodies_outside().next().filter(|_| inside.is_empty() || !is_of_groups) {
        return PlanarFinding::off(fact);
    }
    let mut best: Option<Trial> = None;
    for normal in candidates(model, states, &inside) {
        let trial = Trial::of(model, states, normal, &inside);
        if best.as_ref().is_none_or(|best| trial.is_better_than(best)) {
            best = Some(trial);
        }
    }
    let Some(trial) = best else { return PlanarFinding::off("no mirror plane: no plane to try") };
    trial.finding(model, is_of_groups)
}

/// Why no motion of the scene is simulated in a plane, whatever the symmetry of its bodies.
fn forbidden(model: &Model, settings: &Settings) -> Option<&'static str> {
    if model.movable.is_empty() {
        return Some("no body moves");
    }
    if settings.response == Response::Penalty {
        return Some("springs at two mirror images of a contact are not one spring");
    }
    if model.has_friction() && !settings.takes(TierFeature::PlanarFriction) {
        return Some("contacts have friction, which this tier solves for in space");
    }
    if model.has_friction() && model.surfaces.have_grain() {
        return Some("friction has a grain, and its symmetry is not examined");
    }
    let keeps_symmetry =
        matches!(settings.integrator, Integrator::Exact | Integrator::ExactAdaptive | Integrator::Dop853);
    let is_own = matches!(settings.tier.facts().integrator_choice, IntegratorChoice::Tier { .. });
    if !is_own && !keeps_symmetry {
        return Some("the integrator that the scene names may not keep the symmetry: bodies move in space");
    }
    let by_forces_alike = matches!(settings.contact, ContactMethod::ActiveSet | ContactMethod::Guesses);
    (settings.impact == ImpactLaw::Propagation || !by_forces_alike)
        .then_some("the impact law or the contact method does not treat all contacts alike, which breaks the symmetry")
}

/// Why the symmetry of a body is not examined; none where it is.
fn reason(model: &Model, body: usize) -> Option<&'static str> {
    if model.prescribed.binary_search(&body).is_ok() {
        return Some("the motion of a body is prescribed, and its symmetry is not examined");
    }
    let is_loaded = model.bodies[body].moves() && model.is_loaded(body);
    is_loaded.then_some("force fields, pivots or joints act on bodies, and their symmetry is not examined")
}

/// Normals to try: the axis about which most of these bodies spin, the axes of the world, and those of the first of
/// these bodies. Where a body spins its own axes are left out: normalising a spin about an axis of the world gives that
/// axis to the last bit.
fn candidates(model: &Model, states: &[BodyState], bodies: &[usize]) -> Vec<DVec3> {
    let spin = |&body: &usize| model.velocity(body, &states[body]).angular;
    let axes = bodies.iter().map(spin).filter_map(DVec3::try_normalize);
    let mut spins: BTreeMap<[u64; 3], (usize, Reverse<usize>, DVec3)> = BTreeMap::new();
    for (number, axis) in axes.enumerate() {
        spins.entry(axis.to_array().map(f64::to_bits)).or_insert((0, Reverse(number), axis)).0 += 1;
    }
    let world = [DVec3::Y, DVec3::X, DVec3::Z];
    let most = spins.values().max_by_key(|(count, first, _)| (*count, *first)).map(|(_, _, axis)| *axis);
    let mut normals: Vec<DVec3> = most.into_iter().chain(world).collect();
    if let Some(&first) = bodies.first().filter(|_| most.is_none()) {
        normals.extend(world.map(|axis| states[first].pose.rotation.rotate(axis)));
    }
    normals
}

/// A plane, and how the bodies stand to it.
struct Trial {
    plane: PlaneOfMotion,
    members: Vec<Membership>,
    /// The largest defect of bodies that count as their own mirror images.
    kept: f64,
    /// The first thing that is not its own mirror image.
    first_outside: Option<String>,
    /// How large the defect of that is.
    missed: f64,
}

impl Trial {
    /// That of the plane with this normal in which most of these bodies (ascending) lie.
    fn of(model: &Model, states: &[BodyState], normal: DVec3, inside: &[usize]) -> Self {
        let offset = common_offset(model, states, normal, inside);
        let members = vec![Membership::Outside; model.bodies.len()];
        let plane = PlaneOfMotion::new(normal, offset);
        let mut trial = Self { plane, members, kept: 0.0, first_outside: None, missed: f64::INFINITY };
        let gravity = Defect::of_gravity(model.gravity(), normal);
        if !trial.keeps(&gravity) {
            return trial;
        }
        for body in 0..model.bodies.len() {
            if let Some(fact) = reason(model, body) {
                trial.first_outside.get_or_insert_with(|| fact.to_owned());
            } else if trial.keeps(&Defect::of_body(model, states, (normal, offset), body)) {
                let moves = model.bodies[body].moves();
                trial.members[body] = if moves { Membership::InPlane } else { Membership::OwnImage };
            }
        }
        trial.leave_leaning(model, states, normal);
        trial.leave_touching(model, states);
        trial
    }

    /// Whether a defect is none; notes what has one.
    fn keeps(&mut self, defect: &Defect) -> bool {
        if defect.is_rounding() {
            self.kept = self.kept.max(defect.relative);
            return true;
        }
        if self.first_outside.is_none() || defect.relative > self.missed {
            self.missed = defect.relative;
            self.first_outside = Some(defect.to_string());
        }
        false
    }

    /// Leaves out bodies that rub where the normals of their contacts may lean out of the plane.
    fn leave_leaning(&mut self, model: &Model, states: &[BodyState], normal: DVec3) {
        if !model.has_friction() {
            return;
        }
        let form = |body: usize| {
            let axis = states[body].pose.rotation.inverse_rotate(normal);
            Form::of(model.bodies[body].shape.as_ref(), axis)
        };
        let forms: Vec<Form> = (0..model.bodies.len()).map(form).collect();
        let rub = |a: usize, b: usize| {
            let material = model.scene.pair_material(a, b);
            material.static_ellipse().largest().max(material.rolling_friction()).max(material.spinning_friction()) > 0.0
        };
        // Pairs of prisms, and with half-spaces, are most: they are not looked at one by one.
        for body in (0..forms.len()).filter(|&body| matches!(forms[body], Form::Convex | Form::Other)) {
            let is_in = |of: usize| self.members[of] != Membership::Outside;
            let leans = |&other: &usize| {
                other != body
                    && is_in(other)
                    && !forms[body].keeps_normals(forms[other])
                    && (model.bodies[body].moves() || model.bodies[other].moves())
                    && model.scene.may_collide(body, other)
                    && rub(body, other)
            };
            let Some(other) = (0..forms.len()).filter(|_| is_in(body)).find(leans) else { continue };
            self.members[body] = Membership::Outside;
            let (a, b) = (&model.bodies[body].name, &model.bodies[other].name);
            self.first_outside.get_or_insert_with(|| {
                format!("{a} and {b} rub, and where they touch the normal may lean out of the plane of their symmetry")
            });
        }
    }

    /// Leaves out the bodies that touch others already.
    fn leave_touching(&mut self, model: &Model, states: &[BodyState]) {
        let mut planar = PlanarBodies::new(self.plane, std::mem::take(&mut self.members));
        let touch = |(a, b): (usize, usize)| {
            let separation = || contact_set::separation_without_memory(model, states, a, b);
            model.scene.may_collide(a, b)
                && separation().is_some_and(|gap| gap <= tolerances::touch_distance(model, states, a, b))
        };
        let count = model.bodies.len();
        let mut others: Vec<usize> =
            (0..count).filter(|&body| planar.membership(body) == Membership::Outside).collect();
        while let Some(other) = others.pop() {
            let met: Vec<usize> = planar.bodies().filter(|&body| touch((body.min(other), body.max(other)))).collect();
            planar.release(&met);
            others.extend(met);
        }
        self.members = (0..count).map(|body| planar.membership(body)).collect();
    }

    /// How many bodies move in the plane, and how many that do not move are their own mirror images.
    fn size(&self) -> [usize; 2] {
        [Membership::InPlane, Membership::OwnImage]
            .map(|of| self.members.iter().filter(|membership| **membership == of).count())
    }

    /// Whether more bodies move in its plane; where none does in either, whether less is missing.
    fn is_better_than(&self, other: &Self) -> bool {
        let [own, others] = [self.size(), other.size()];
        own > others || (own[0] == 0 && others[0] == 0 && self.missed < other.missed)
    }

    /// What is simulated in the plane; nothing unless all bodies are in it where the tier knows no groups.
    fn finding(self, model: &Model, is_of_groups: bool) -> PlanarFinding {
        let [moving, _] = self.size();
        let all = model.movable.len();
        let what = self.first_outside.unwrap_or_default();
        let is_whole = self.members.iter().all(|membership| *membership != Membership::Outside);
        if moving == 0 || !(is_whole || is_of_groups) {
            return PlanarFinding::off(format!("no mirror plane: {what}"));
        }
        let normal = self.plane.normal();
        let who = if is_whole {
            "every body is its own mirror image".to_owned()
        } else {
            format!("{moving} of {all} bodies that move are their own mirror images")
        };
        let mut fact = format!(
            "{who} in the plane with normal ({}, {}, {}), with a relative defect of {:.1e} (limit {:.1e})",
            normal.x, normal.y, normal.z, self.kept, SYMMETRY_RELATIVE
        );
        if !is_whole {
            let _ = write!(fact, ", until they meet others ({what})");
        }
        PlanarFinding { planar: PlanarBodies::new(self.plane, self.members), fact }
    }
}

/// The offset (m) of the plane with this normal through the centres of most of these bodies: of those that lie at one
/// height to rounding, that of the first.
fn common_offset(model: &Model, states: &[BodyState], normal: DVec3, bodies: &[usize]) -> f64 {
    let height = |body: usize| normal.dot(states[body].pose.translation);
    let mut heights: Vec<(f64, usize)> = bodies.iter().map(|&body| (height(body), body)).collect();
    heights.sort_by(|a, b| a.0.total_cmp(&b.0));
    let rounding = |&(_, body): &(f64, usize)| {
        SYMMETRY_RELATIVE * (model.bodies[body].size + states[body].pose.translation.abs().max_element())
    };
    let levels = heights.chunk_by(|a, b| b.0 - a.0 <= rounding(a).max(rounding(b)));
    let first = |level: &[(f64, usize)]| level.iter().map(|(_, body)| *body).min();
    // Of levels with as many bodies that of the first body is taken.
    let most = levels.max_by_key(|level| (level.len(), Reverse(first(level))));
    most.and_then(first).map_or(0.0, height)
}
