//! Impacts: the impact law acts on approaching contacts, together with all contacts connected to them.

use crate::collision::touch::{Hold, Touch};
use crate::constraint::ConstraintId;
use crate::identity::body_id::BodyId;
use crate::identity::contact_id::ContactId;
use crate::joints::joint_contacts;
use crate::model::states_of::{set_states, states_of};
use crate::model::{Model, tolerances};
use crate::report::event::{Event, EventKind};
use crate::report::momentum_ledger::Momentum;
use crate::rows::assembly::Assembly;
use crate::rows::groups::Group;
use crate::rows::many_contacts::furthest_out;
use crate::scene::{ImpactLaw, PropagationOrder};
use crate::solve::cone_violation::ConeViolation;
use crate::solve::frictional_impact::{self, Cause, FrictionalImpact, Restitution, rate_of_separation};
use crate::solve::reactions::Reactions;
use polhode_contact::ContactGeometry;
use polhode_dynamics::BodyState;
use polhode_response::impact::{Application, ImpactOutcome, ImpactSettings, ImpactStatus};
use polhode_response::solve::impact::{Impact, Strikes, strike};
use polhode_response::solve::way;
use polhode_response::{Memory, ResponseError, SolverSettings};
use polhode_spatial::{DVec3, SplitMix64};
use std::ops::Range;

/// Result of an impact.
#[derive(Debug)]
pub(crate) struct Struck {
    /// In the order of the rows: contacts first, then bilateral constraints.
    pub(crate) outcome: ImpactOutcome,
    /// The constraint of each of `outcome.applications`.
    pub(crate) constraints: Vec<Option<ConstraintId>>,
    /// The impulses.
    pub(crate) reactions: Reactions,
    /// Energy lost to friction, J.
    pub(crate) friction_j: f64,
    /// How far the impulses are from Coulomb's law.
    pub(crate) violation: Option<ConeViolation>,
    /// Whether it gave the restitution asked for; without friction the status says so.
    pub(crate) restitution: Restitution,
}

impl Struck {
    /// The impulses that an outcome gave to the rows of an assembly, the first of which are so many contacts.
    fn new(assembly: &Assembly, contacts: usize, outcome: ImpactOutcome, impulses: &[f64]) -> Self {
        let constraints = outcome.applications.iter().map(|application| assembly.constraint(application.row)).collect();
        let reactions = Reactions::of(assembly, contacts, impulses);
        Self { outcome, constraints, reactions, friction_j: 0.0, violation: None, restitution: Restitution::Full }
    }

    /// Work of prescribed motions and of surfaces that move, J.
    pub(crate) fn work(&self, model: &Model, states: &[BodyState], contacts: &[Touch]) -> f64 {
        self.reactions.work(model, states, geometries(contacts))
    }

    /// Momentum that contacts and bilateral constraints give to the bodies that move, angular about a point.
    pub(crate) fn support(&self, model: &Model, about: DVec3, contacts: &[Touch]) -> Momentum {
        self.reactions.support(model, about, geometries(contacts))
    }

    /// Puts what contacts at some places did among all contacts; the others had no impulse and have these rates of
    /// separation (m/s).
    fn spread(&mut self, places: &[usize], rates: &[f64]) {
        let spread = |of_some: &[f64], mut of_all: Vec<f64>| {
            let (of_contacts, of_pivots) = of_some.split_at(places.len().min(of_some.len()));
            places.iter().zip(of_contacts).for_each(|(&place, &value)| of_all[place] = value);
            of_all.extend(of_pivots);
            of_all
        };
        let outcome = &mut self.outcome;
        outcome.impulses = spread(&outcome.impulses, vec![0.0; rates.len()]);
        outcome.velocities_after = spread(&outcome.velocities_after, rates.to_vec());
        for application in &mut outcome.applications {
            application.row = places[application.row];
        }
        self.reactions.normal = spread(&self.reactions.normal, vec![0.0; rates.len()]);
    }
}

/// Contacts with their geometry.
fn geometries(contacts: &[Touch]) -> impl Iterator<Item = (ContactId, &ContactGeometry)> + Clone {
    contacts.iter().map(|touch| (touch.id, &touch.kinematics.geometry))
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

/// Contacts that approach by less than this part of the fastest one after an impact do not approach (no unit, 1e-13 to
/// 1e-10): the residual of its problem.
const LEFT_APPROACHING: f64 = 1e-10;

/// Whether a contact separates that has not left the touch distance since it was struck. Where another contact of its
/// bodies is struck meanwhile, impacts follow each other so closely that the gaps between them are below what is told
/// from touch: the end of infinitely many (inelastic collapse, McNamara and Young 1992), in which no approach is left.
/// It takes two bodies that move: the bounces of one are summed up where they are small (`ending_bounces.rs`).
fn is_struck_again(touch: &Touch) -> bool {
    touch.known && touch.hold == Hold::Open && touch.kinematics.separation_rate > 0.0
}

/// Applies the impact law to the contacts and pivots of a group and updates the momenta of its bodies. If the law finds
/// no solution, the states are unchanged and the status says so.
///
/// # Errors
/// When the problem is not finite.
pub(crate) fn strike_group(
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
    if group.bodies.len() > 1 && members.iter().any(is_struck_again) {
        restitution.iter_mut().filter(|restitution| **restitution < 1.0).for_each(|restitution| *restitution = 0.0);
    }
    // Bilateral constraints have no restitution.
    restitution.resize(before.len(), 0.0);
    let row_law = law.of_rows(model.scene.method().pulse_exponent.unwrap_or_default());
    let order = in_order(model, law, &members, before.len());
    // Bodies that fit exactly between others may appear to be compressed because of the rounding of velocities that
    // nearly cancel.
    let noise_floor = RATE_ROUNDING * largest_speed(model, states, &group.bodies);
    let with_noise = ImpactSettings { solver: SolverSettings { noise_floor, ..settings.solver }, ..*settings };
    let mut outcome = ImpactOutcome::default();
    for settings in [settings, &with_noise] {
        let by = Strikes::Rows { law: row_law, order: order.as_deref(), settings };
        let impact = Impact { rows: &assembly.problem, before: &before, restitution: &restitution, law: by };
        outcome = strike(&impact, memory)?.outcome;
        if outcome.status != ImpactStatus::NotSolved {
            let reactions = Reactions::of(&assembly, members.len(), &outcome.impulses);
            if reactions.apply_without_gain(model, states, (&group.bodies, geometries(&members))) {
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
    let impulses = outcome.impulses.clone();
    Ok(Struck::new(&assembly, members.len(), outcome, &impulses))
}

/// [`strike_group`] where contacts have friction; also where they jam. Of pairs with many contacts only some are struck
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
                struck.spread(&places, &rates);
            }
            return Ok(struck);
        }
        let rates: Vec<f64> = members.iter().map(|touch| rate_of_separation(model, states, touch)).collect();
        if struck.outcome.status == ImpactStatus::NotSolved || !take_fastest(members, &rates, slow, &mut taken) {
            struck.spread(&places, &rates);
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
    let FrictionalImpact { assembly, outcome, reactions, friction_work_j, restitution, violation } =
        frictional_impact::solve(model, states, bodies, members, law)?;
    let mut struck = Struck::new(&assembly, members.len(), outcome, &reactions);
    (struck.friction_j, struck.violation) = (-friction_work_j, violation);
    struck.restitution = restitution;
    if struck.outcome.status != ImpactStatus::NotSolved {
        if restitution == Restitution::RaisesEnergy {
            struck.reactions.apply(model, states, geometries(members));
            return Ok(struck);
        }
        if struck.reactions.apply_without_gain(model, states, (bodies, geometries(members))) {
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
