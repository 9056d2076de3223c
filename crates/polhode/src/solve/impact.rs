//! Impacts: the impact law acts on approaching contacts, together with all contacts connected to them.

use crate::collision::touch::Touch;
use crate::collision::{friction, moving_surfaces};
use crate::constraint::ConstraintId;
use crate::identity::body_id::BodyId;
use crate::identity::contact_id::ContactId;
use crate::joints::bilateral::{self, Bilateral, Reaction, apply_reactions, bilateral_support};
use crate::joints::joint_contacts;
use crate::model::states_of::{set_states, states_of};
use crate::model::{Model, prescribed, tolerances};
use crate::report::event::{Event, EventKind};
use crate::report::momentum_ledger::{Momentum, MomentumSum};
use crate::rows::assembly::{Assembly, apply_impulses};
use crate::rows::groups::Group;
use crate::rows::many_contacts::furthest_out;
use crate::scene::{ImpactLaw, PropagationOrder};
use crate::solve::cone_violation::{ConeViolation, RubbingForce, largest_violation};
use crate::solve::frictional_impact::{self, Cause, FrictionalImpact, Restitution, rate_of_separation};
use crate::solve::rotational_friction::{apply_moments, moment_support, moment_work};
use polhode_contact::ContactGeometry;
use polhode_dynamics::BodyState;
use polhode_response::impact::{Application, ImpactOutcome, ImpactSettings, ImpactStatus};
use polhode_response::solve::impact::{RowImpact, strike_rows};
use polhode_response::solve::way;
use polhode_response::{Memory, ResponseError, SolverSettings};
use polhode_spatial::{DVec3, SplitMix64};
use std::ops::Range;

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

/// Result of an impact.
#[derive(Debug)]
pub(crate) struct Struck {
    /// In the order of the rows: contacts first, then bilateral constraints.
    pub(crate) outcome: ImpactOutcome,
    /// The constraint of each of `outcome.applications`.
    pub(crate) constraints: Vec<Option<ConstraintId>>,
    /// The bilateral constraints that took part, and the impulse of each.
    pub(crate) bilaterals: Vec<(Bilateral, Reaction)>,
    /// Impulses of friction, N s: the contact with a tangent in the place of its normal, and the impulse on A.
    pub(crate) tangential: Vec<(ContactId, ContactGeometry, f64)>,
    /// Impulses of moments of friction on A, N m s, world.
    pub(crate) moments: Vec<(ContactId, DVec3)>,
    /// Energy lost to friction, J.
    pub(crate) friction_j: f64,
    /// Whether it gave the restitution asked for; without friction the status says so.
    pub(crate) restitution: Restitution,
}

impl Struck {
    /// Work of prescribed motions and of surfaces that move, J.
    pub(crate) fn work(&self, model: &Model, states: &[BodyState], contacts: &[Touch]) -> f64 {
        let moments = self.moments.iter().copied();
        prescribed::prescribed_work(model, states, self.impulses(contacts.iter()))
            + moving_surfaces::surface_work(model, states, self.along_tangents())
            + moment_work(model, states, moments)
            + bilateral::driven_work(model, states, self.reactions())
    }

    /// The impulses of bilateral constraints.
    pub(crate) fn reactions(&self) -> impl Iterator<Item = (&Bilateral, Reaction)> + Clone {
        self.bilaterals.iter().map(|(of, impulse)| (of, *impulse))
    }

    /// Momentum that contacts and bilateral constraints give to the bodies that move, angular about a point.
    pub(crate) fn support(&self, model: &Model, about: DVec3, contacts: &[Touch]) -> Momentum {
        let moments = self.moments.iter().copied();
        support(model, about, self.impulses(contacts.iter()))
            + bilateral_support(about, self.reactions())
            + moment_support(model, moments)
    }

    /// How far the impulses of contacts with friction, which are in the order of the impact, are from Coulomb's law.
    pub(crate) fn cone_violation(
        &self,
        model: &Model,
        states: &[BodyState],
        contacts: &[Touch],
    ) -> Option<ConeViolation> {
        let normal_of = |id: ContactId| {
            let place = contacts.iter().position(|touch| touch.id == id)?;
            self.outcome.impulses.get(place).copied()
        };
        let rubbing = |own: &[(ContactId, ContactGeometry, f64)]| {
            let ((id, first, _), (_, last, _)) = (own.first()?, own.last()?);
            let ellipse = friction::friction_at(model, states, *id, [first.normal, last.normal])?.sliding;
            let tangential = ellipse.length(&own.iter().map(|(.., p)| *p).collect::<Vec<_>>());
            let friction = ellipse.largest();
            Some(RubbingForce { pair: (id.a, id.b), normal: normal_of(*id)?, tangential, friction })
        };
        let forces: Vec<RubbingForce> = self.tangential.chunk_by(|x, y| x.0 == y.0).filter_map(rubbing).collect();
        largest_violation(forces.into_iter(), 0.0)
    }

    /// Impulses at contacts along tangents.
    pub(crate) fn along_tangents(&self) -> impl Iterator<Item = (ContactId, &ContactGeometry, f64)> + Clone {
        self.tangential.iter().map(|(id, along, p)| (*id, along, *p))
    }

    /// All impulses at contacts, which are in the order of the impact: along normals, then along tangents.
    pub(crate) fn impulses<'a>(
        &'a self,
        contacts: impl Iterator<Item = &'a Touch> + Clone + 'a,
    ) -> impl Iterator<Item = (ContactId, &'a ContactGeometry, f64)> + Clone + 'a {
        let normal = contacts.zip(&self.outcome.impulses);
        let normal = normal.map(|(touch, &p)| (touch.id, &touch.kinematics.geometry, p));
        normal.chain(self.along_tangents())
    }
}

/// Rounding error of a relative velocity as a fraction of the speeds that cancel in it: some sixteen rounding units.
const RATE_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Largest speed of any point of some bodies, m/s, bounded by their sizes.
fn largest_speed(model: &Model, states: &[BodyState], bodies: &[usize]) -> f64 {
    let speed = |&body: &usize| {
        let velocity = model.velocity(body, &states[body]);
        velocity.linear.length() + velocity.angular.length() * model.bodies[body].size
    };
    bodies.iter().map(speed).fold(0.0, f64::max)
}

/// Allowed apparent gain of energy by impulses, relative to the energy of the bodies and to the work of prescribed
/// motions. A larger gain means that rounding errors dominate the solution: impulses that cancel are larger than all
/// momenta by many digits.
const GAIN_ROUNDING: f64 = 1e-6;

/// Contacts that approach by less than this part of the fastest one after an impact do not approach (no unit, 1e-13 to
/// 1e-10): the residual of its problem.
const LEFT_APPROACHING: f64 = 1e-10;

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

/// Applies impulses of contacts, of pivots and of moments (N m s, world, on A) to some bodies. Returns by how much the
/// energy increased beyond the work of prescribed motions and of surfaces that move (`by_surfaces`, J).
pub(crate) fn apply_with_gain<'a>(
    model: &Model,
    states: &mut [BodyState],
    bodies: &[usize],
    (impulses, reactions): (
        impl Iterator<Item = (ContactId, &'a ContactGeometry, f64)> + Clone,
        impl Iterator<Item = (&'a Bilateral, Reaction)> + Clone,
    ),
    (moments, by_surfaces): (&[(ContactId, DVec3)], f64),
) -> Gain {
    let kinetic = |states: &[BodyState]| bodies.iter().map(|&body| model.energies(body, &states[body]).0).sum::<f64>();
    let before = kinetic(states);
    let by_moments = moment_work(model, states, moments.iter().copied());
    let by_drivers = bilateral::driven_work(model, states, reactions.clone());
    let work = prescribed::prescribed_work(model, states, impulses.clone()) + by_moments + by_surfaces + by_drivers;
    apply_impulses(model, states, impulses);
    apply_reactions(model, states, reactions);
    apply_moments(model, states, moments.iter().copied());
    Gain { gain_j: kinetic(states) - before - work, rounding_j: GAIN_ROUNDING * (before + work.abs()) }
}

/// As [`apply_with_gain`]. Returns whether no energy was added; otherwise the states are unchanged.
pub(crate) fn apply_without_gain<'a>(
    model: &Model,
    states: &mut [BodyState],
    bodies: &[usize],
    impulses: (
        impl Iterator<Item = (ContactId, &'a ContactGeometry, f64)> + Clone,
        impl Iterator<Item = (&'a Bilateral, Reaction)> + Clone,
    ),
    given: (&[(ContactId, DVec3)], f64),
) -> bool {
    let start = states_of(states, bodies);
    let is_sound = !apply_with_gain(model, states, bodies, impulses, given).is_excess();
    if !is_sound {
        set_states(states, bodies, &start);
    }
    is_sound
}

/// Applies the impact law to the contacts and pivots of a group and updates the momenta of its bodies. If the law finds
/// no solution, the states are unchanged and the status says so.
///
/// # Errors
/// When the problem is not finite.
pub(crate) fn strike(
    model: &Model,
    states: &mut [BodyState],
    group: &Group,
    touches: &[Touch],
    law: ImpactLaw,
    settings: &ImpactSettings,
    memory: &mut Memory,
) -> Result<Struck, ResponseError> {
    let members: Vec<Touch> = group.contacts.iter().map(|&i| touches[i]).collect();
    if frictional_impact::have_friction(model, &members) {
        let law = (law, Cause::Collision(settings.threshold));
        return strike_with_friction(model, states, &group.bodies, &members, law);
    }
    let rows = members.iter().map(|touch| (touch.id, touch.kinematics.geometry));
    let assembly = Assembly::new(model, states, &group.bodies, rows)?;
    let before = assembly.rates(members.iter().map(|touch| touch.kinematics.separation_rate));
    let mut restitution: Vec<f64> = members.iter().map(|touch| joint_contacts::restitution_at(model, touch)).collect();
    // Bilateral constraints have no restitution.
    restitution.resize(before.len(), 0.0);
    let row_law = law.of_rows(model.scene.method().pulse_exponent.unwrap_or_default());
    let order = in_order(model, law, &members, before.len());
    // Bodies that fit exactly between others may appear to be compressed because of the rounding of velocities that
    // nearly cancel.
    let noise_floor = RATE_ROUNDING * largest_speed(model, states, &group.bodies);
    let with_noise = ImpactSettings { solver: SolverSettings { noise_floor, ..settings.solver }, ..*settings };
    let contacts: Vec<_> = members.iter().map(|touch| (touch.id, touch.kinematics.geometry)).collect();
    let mut outcome = ImpactOutcome::default();
    for settings in [settings, &with_noise] {
        let impact = RowImpact {
            rows: &assembly.problem,
            before: &before,
            restitution: &restitution,
            law: row_law,
            order: order.as_deref(),
            settings,
        };
        outcome = strike_rows(&impact, memory)?;
        if outcome.status != ImpactStatus::NotSolved {
            let impulses = contacts.iter().zip(&outcome.impulses).map(|((id, geometry), &p)| (*id, geometry, p));
            let reactions = assembly.reactions(&outcome.impulses);
            if apply_without_gain(model, states, &group.bodies, (impulses, reactions), (&[], 0.0)) {
                break;
            }
        }
        outcome = ImpactOutcome {
            impulses: vec![0.0; before.len()],
            velocities_after: before.clone(),
            residual: outcome.residual,
            status: ImpactStatus::NotSolved,
            ..ImpactOutcome::default()
        };
    }
    let bilaterals = assembly.reactions(&outcome.impulses).map(|(of, impulse)| (of.clone(), impulse)).collect();
    let constraints = outcome.applications.iter().map(|application| assembly.constraint(application.row)).collect();
    let restitution = Restitution::Full;
    let (tangential, moments) = (Vec::new(), Vec::new());
    Ok(Struck { outcome, constraints, bilaterals, tangential, moments, friction_j: 0.0, restitution })
}

/// [`strike`] where contacts have friction; also where they jam. Of pairs with many contacts only some are struck
/// (`many_contacts.rs`).
///
/// # Errors
/// When the problem is not finite.
pub(crate) fn strike_with_friction(
    model: &Model,
    states: &mut [BodyState],
    bodies: &[usize],
    members: &[Touch],
    law: (ImpactLaw, Cause<'_>),
) -> Result<Struck, ResponseError> {
    let mut taken = match law.1 {
        Cause::Collision(_) => outer_of_many(members),
        Cause::Jam(..) => vec![true; members.len()],
    };
    let start = states_of(states, bodies);
    let approach = members.iter().map(|touch| -touch.kinematics.separation_rate).fold(0.0, f64::max);
    let slow = tolerances::velocity_rounding(model, states, bodies) + LEFT_APPROACHING * approach;
    loop {
        let mut places: Vec<usize> = (0..members.len()).filter(|&place| taken[place]).collect();
        let order = match law.1 {
            Cause::Collision(_) => in_order(model, law.0, members, members.len()),
            Cause::Jam(..) => None,
        };
        if let Some(order) = &order {
            places = order.iter().copied().filter(|&place| taken[place]).collect();
        }
        let some: Vec<Touch> = places.iter().map(|&place| members[place]).collect();
        let mut struck = strike_all_with_friction(model, states, bodies, &some, law)?;
        if places.len() == members.len() {
            if order.is_some() {
                let rates = struck.outcome.velocities_after[..members.len()].to_vec();
                among(&mut struck.outcome, &places, &rates);
            }
            return Ok(struck);
        }
        let rates: Vec<f64> = members.iter().map(|touch| rate_of_separation(model, states, touch)).collect();
        if struck.outcome.status == ImpactStatus::NotSolved || !take_fastest(members, &rates, slow, &mut taken) {
            among(&mut struck.outcome, &places, &rates);
            return Ok(struck);
        }
        set_states(states, bodies, &start);
    }
}

/// The order in which propagation strikes contacts, of this many rows with those of joints after them; none for that of
/// their keys, and for another law.
fn in_order(model: &Model, law: ImpactLaw, members: &[Touch], rows: usize) -> Option<Vec<usize>> {
    if law != ImpactLaw::Propagation {
        return None;
    }
    let mut order: Vec<usize> = (0..rows).collect();
    let contacts = &mut order[..members.len()];
    match model.scene.method().propagation_order.unwrap_or_default() {
        PropagationOrder::Key => return None,
        PropagationOrder::Depth => contacts.sort_by(|&x, &y| {
            let depth = |row: usize| members[row].kinematics.geometry.separation;
            depth(x).total_cmp(&depth(y)).then(x.cmp(&y))
        }),
        PropagationOrder::Random { seed } => {
            // The velocities before tell one impact from another, so that a run continues from a snapshot with the same
            // order.
            let mixed = members
                .iter()
                .fold(seed, |mixed, touch| SplitMix64::new(mixed ^ touch.kinematics.separation_rate.to_bits()).bits());
            let mut numbers = SplitMix64::new(mixed);
            for last in (1..contacts.len()).rev() {
                let other = numbers.bits() % (last as u64 + 1);
                contacts.swap(last, usize::try_from(other).unwrap_or_default());
            }
        }
    }
    Some(order)
}

/// The outcome of an impact of the contacts at some places among all contacts, of which the others had no impulse and
/// have these rates of separation (m/s).
fn among(outcome: &mut ImpactOutcome, places: &[usize], rates: &[f64]) {
    let spread = |of_some: &[f64], mut of_all: Vec<f64>| {
        let (of_contacts, of_pivots) = of_some.split_at(places.len().min(of_some.len()));
        places.iter().zip(of_contacts).for_each(|(&place, &value)| of_all[place] = value);
        of_all.extend(of_pivots);
        of_all
    };
    outcome.impulses = spread(&outcome.impulses, vec![0.0; rates.len()]);
    outcome.velocities_after = spread(&outcome.velocities_after, rates.to_vec());
    for application in &mut outcome.applications {
        application.row = places[application.row];
    }
}

/// Which contacts an impact begins with.
fn outer_of_many(members: &[Touch]) -> Vec<bool> {
    let mut taken = vec![true; members.len()];
    for of_pair in pairs(members).filter(|of_pair| way::are_many_of_a_pair(of_pair.len())) {
        let points: Vec<_> = of_pair.clone().map(|place| (place, members[place].kinematics.geometry.point)).collect();
        let outer = furthest_out(&points);
        taken[of_pair].fill(false);
        for place in outer {
            taken[place] = true;
        }
    }
    taken
}

/// Takes of each pair the contact that still approaches fastest with these rates of separation, faster than `slow`
/// (m/s). Returns whether there is any.
fn take_fastest(members: &[Touch], rates: &[f64], slow: f64, taken: &mut [bool]) -> bool {
    let mut any = false;
    for of_pair in pairs(members) {
        let left = of_pair.filter(|&place| !taken[place] && rates[place] < -slow);
        if let Some(fastest) = left.reduce(|most, next| if rates[next] < rates[most] { next } else { most }) {
            taken[fastest] = true;
            any = true;
        }
    }
    any
}

/// Contacts of the same two bodies, where they stand beside each other.
fn pairs(members: &[Touch]) -> impl Iterator<Item = Range<usize>> + '_ {
    members.chunk_by(|x, y| (x.id.a, x.id.b) == (y.id.a, y.id.b)).scan(0, |start, of_pair| {
        let range = *start..*start + of_pair.len();
        *start = range.end;
        Some(range)
    })
}

/// [`strike_with_friction`] of all these contacts.
fn strike_all_with_friction(
    model: &Model,
    states: &mut [BodyState],
    bodies: &[usize],
    members: &[Touch],
    law: (ImpactLaw, Cause<'_>),
) -> Result<Struck, ResponseError> {
    let FrictionalImpact { assembly, outcome, tangential, moments, friction_work_j, restitution } =
        frictional_impact::solve(model, states, bodies, members, law)?;
    let bilaterals = assembly.reactions(&outcome.impulses).map(|(of, impulse)| (of.clone(), impulse)).collect();
    let constraints = outcome.applications.iter().map(|application| assembly.constraint(application.row)).collect();
    let friction_j = -friction_work_j;
    let mut struck = Struck { outcome, constraints, bilaterals, tangential, moments, friction_j, restitution };
    if struck.outcome.status != ImpactStatus::NotSolved {
        let impulses = struck.impulses(members.iter());
        let reactions = struck.reactions();
        if restitution == Restitution::RaisesEnergy {
            apply_impulses(model, states, impulses);
            apply_reactions(model, states, reactions);
            apply_moments(model, states, struck.moments.iter().copied());
            return Ok(struck);
        }
        let by_surfaces = moving_surfaces::surface_work(model, states, struck.along_tangents());
        if apply_without_gain(model, states, bodies, (impulses, reactions), (&struck.moments, by_surfaces)) {
            return Ok(struck);
        }
    }
    struck.outcome.status = ImpactStatus::NotSolved;
    Ok(struck)
}

/// The warning of an impact whose energy its law of restitution has raised.
pub(crate) fn raised_energy(law: &str) -> String {
    format!(
        "the restitution law {law} has raised the energy of an impact with friction, as it may where slip stops or \
         reverses: stronge never does"
    )
}

/// The event of one impulse at one contact point.
pub(crate) fn impulse_event(t: f64, kind: EventKind, touch: &Touch, application: &Application) -> Event {
    let geometry = touch.kinematics.geometry;
    Event {
        t_s: t,
        kind,
        body_a: BodyId::new(touch.id.a),
        body_b: touch.id.second().map(BodyId::new),
        point: geometry.point,
        normal: geometry.normal,
        impulse: application.impulse,
        energy_change_j: application.energy_change,
    }
}
