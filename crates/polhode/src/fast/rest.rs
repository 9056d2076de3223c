//! Islands at rest, which the steps leave out until something reaches them.
//!
//! Every [`EVERY`] steps each island is looked at whose bodies are slower than a step can tell from rest ([`SLOW`]).
//! Where forces of its contacts, its joints and their limits hold it (`crate::solve::held_at_rest`: contacts push
//! within their cones of friction, joints by forces of either sign), its velocities are zero from then on, exactly, and
//! what they had is booked as rest. An island that could not be held is tried again after twice the time. It wakes as a
//! whole where a body that moves may reach one of its own within a step, and by actions of a program.
//!
//! A pendulum at its turning point is as slow, but no force of its joint bears its weight there: it swings on.
//!
//! Assumption: nothing on the bodies depends on time; islands with force fields or beside a body of prescribed motion
//! do not rest.

use super::course::Course;
use super::rules::Rules;
use crate::collision::contact_kinematics;
use crate::collision::face_patches::PairPatches;
use crate::collision::touch::{FoundContact, Touch};
use crate::constraint::joint::ModelJoint;
use crate::error::SimulationError;
use crate::identity::contact_id::{ContactId, Feature};
use crate::joints::joint_contacts;
use crate::model::{Model, prescribed, tolerances};
use crate::solve::held_at_rest::HeldAtRest;
use crate::tier::core::Core;
use polhode_contact::{ContactFeature, ContactGeometry, ContactKinematics};
use polhode_dynamics::BodyState;
use polhode_response::ResponseError;
use polhode_spatial::DisjointSets;

/// Steps between two looks.
pub(super) const EVERY: u64 = 16;

/// A body counts as slow up to this part of the speed that gravity gives in a step (no unit, 1e-3 to 1e-1).
const SLOW: f64 = 1e-2;

/// Lets islands rest that forces hold, at the present. Looks only after every [`EVERY`]th step.
///
/// # Errors
/// When a number is not finite.
pub(super) fn settle(course: &mut Course, core: &mut Core, rules: &Rules) -> Result<(), SimulationError> {
    if !core.accounts.steps().is_multiple_of(EVERY) {
        return Ok(());
    }
    let islands = slow_islands(course, &core.model, rules);
    for island in islands {
        for &body in &island {
            course.quiet[body] += 1;
        }
        let quiet = island.iter().map(|&body| course.quiet[body]).min().unwrap_or(0);
        if quiet < 2 || !quiet.is_power_of_two() {
            continue;
        }
        let held = are_held(course, core, &island).map_err(|source| SimulationError::of_response(core.t, source))?;
        if !held {
            continue;
        }
        let before = core.accounts.books.balance(&core.model, &course.states, &island);
        for &body in &island {
            course.states[body] = BodyState::at_rest(course.states[body].pose);
            course.resting[body] = true;
        }
        let after = core.accounts.books.balance(&core.model, &course.states, &island);
        core.accounts.books.rest(before, after, 0.0);
    }
    Ok(())
}

/// The islands of which all bodies are slow, and nothing else that moves is beside them.
fn slow_islands(course: &mut Course, model: &Model, rules: &Rules) -> Vec<Vec<usize>> {
    let slow = SLOW * model.gravity().length() * rules.h * f64::from(rules.substeps);
    let bodies = course.states.len();
    let mut sets = DisjointSets::new(bodies);
    let mut may_rest: Vec<bool> = (0..bodies)
        .map(|body| {
            model.bodies[body].moves()
                && !course.resting[body]
                && !model.has_fields_on(body)
                && tolerances::point_speed(model, &course.states, body) <= slow
        })
        .collect();
    for (quiet, may) in course.quiet.iter_mut().zip(&may_rest) {
        if !may {
            *quiet = 0;
        }
    }
    let awake = |course: &Course, body: usize| model.bodies[body].moves() && !course.resting[body];
    for pair in course.pairs.iter().filter(|pair| !pair.patches.is_empty()) {
        match [pair.a, pair.b].map(|body| awake(course, body)) {
            [true, true] => sets.join(pair.a, pair.b),
            [true, false] => may_rest[pair.a] &= prescribed::trajectory(model, pair.b).is_none(),
            [false, true] => may_rest[pair.b] &= prescribed::trajectory(model, pair.a).is_none(),
            [false, false] => {}
        }
    }
    for (a, b) in model.joints.list.iter().map(ModelJoint::pair) {
        if awake(course, a) && awake(course, b) {
            sets.join(a, b);
        }
    }
    let mut islands: Vec<Vec<usize>> = Vec::new();
    let mut place: Vec<Option<usize>> = vec![None; bodies];
    let mut is_slow: Vec<bool> = Vec::new();
    for body in (0..bodies).filter(|&body| awake(course, body)) {
        let island = *place[sets.smallest(body)].get_or_insert_with(|| {
            islands.push(Vec::new());
            is_slow.push(true);
            islands.len() - 1
        });
        islands[island].push(body);
        is_slow[island] &= may_rest[body];
    }
    islands.into_iter().zip(is_slow).filter(|(_, is_slow)| *is_slow).map(|(island, _)| island).collect()
}

/// Whether forces of their contacts, of their joints and of the limits of these hold these bodies at rest.
fn are_held(course: &Course, core: &Core, island: &[usize]) -> Result<bool, ResponseError> {
    let is_own = |body: usize| island.binary_search(&body).is_ok();
    let mut states = course.states.clone();
    for &body in island {
        states[body] = BodyState::at_rest(states[body].pose);
    }
    let model = &core.model;
    let mut touches = limits_that_may_press(course, model, (&states, island));
    for pair in course.pairs.iter().filter(|pair| is_own(pair.a) || is_own(pair.b)) {
        for patch in &pair.patches {
            for point in patch.points() {
                let id = ContactId { a: pair.a, b: pair.b, feature: Feature::Shapes(point.feature) };
                let geometry = present_geometry(model, &states, id, pair.geometry(&states, patch, point));
                if geometry.separation <= 0.0 || point.normal_force > 0.0 {
                    let kinematics = ContactKinematics { geometry, separation_rate: 0.0, acceleration_bias: 0.0 };
                    touches.push(Touch::from(FoundContact { id, kinematics }));
                }
            }
        }
    }
    touches.sort_by_key(|touch| touch.id);
    let is_alone = touches.is_empty() && !island.iter().any(|&body| model.is_loaded(body));
    if is_alone {
        return Ok(false);
    }
    // Gravity about the pivots of bodies that have no rows for them.
    let loads = model.loads_on(core.t, &states, island);
    Ok(HeldAtRest::of(model, (core.t, &states), island, &touches, &loads)?.is_some())
}

/// Where a contact of a round body is: its point does not turn with the body, as that of a patch does. Of all others
/// what the patch says.
fn present_geometry(model: &Model, states: &[BodyState], id: ContactId, of_patch: ContactGeometry) -> ContactGeometry {
    match id.feature {
        Feature::Shapes(ContactFeature::Smooth { .. }) => {
            contact_kinematics::kinematics(model, states, id).map_or(of_patch, |at| at.geometry)
        }
        _ => of_patch,
    }
}

/// The limits of joints of these bodies that are reached, or pressed in the last step.
fn limits_that_may_press(course: &Course, model: &Model, (states, island): (&[BodyState], &[usize])) -> Vec<Touch> {
    let mut touches = Vec::new();
    for (a, b) in model.joints.joint_contact_pairs_among(island) {
        for &feature in model.joints.joint_contacts_of_pair((a, b)) {
            let id = ContactId { a, b, feature };
            let Some(kinematics) = joint_contacts::joint_contact_kinematics(model, states, id) else { continue };
            let has_pressed = course.limits.binary_search_by_key(&id, |limit| limit.id).is_ok();
            if kinematics.geometry.separation <= 0.0 || has_pressed {
                touches.push(Touch::from(FoundContact { id, kinematics }));
            }
        }
    }
    touches
}

/// Wakes the islands at rest that a body may reach within a step: the patches are those of the present. Returns whether
/// any did.
pub(super) fn wake(course: &mut Course, model: &Model, rules: &Rules) -> bool {
    if !course.resting.contains(&true) {
        return false;
    }
    let step = rules.h * f64::from(rules.substeps);
    let fall = model.gravity().length() * step * step;
    let (resting, states) = (&course.resting, &course.states);
    let moves =
        |body: usize| (model.bodies[body].moves() && !resting[body]) || prescribed::trajectory(model, body).is_some();
    let reaches = |pair: &&PairPatches| {
        let mover = match [pair.a, pair.b] {
            [a, b] if resting[a] && moves(b) => b,
            [a, b] if resting[b] && moves(a) => a,
            _ => return false,
        };
        let reach = tolerances::point_speed(model, states, mover) * step + fall;
        let mut points = pair.patches.iter().flat_map(|patch| patch.points().iter().map(move |point| (patch, point)));
        points.any(|(patch, point)| pair.geometry(states, patch, point).separation <= reach)
    };
    let reached: Vec<usize> = course.pairs.iter().filter(reaches).flat_map(|pair| [pair.a, pair.b]).collect();
    if reached.is_empty() {
        return false;
    }
    let mut sets = DisjointSets::new(resting.len());
    for pair in course.pairs.iter().filter(|pair| resting[pair.a] && resting[pair.b] && !pair.patches.is_empty()) {
        sets.join(pair.a, pair.b);
    }
    for (a, b) in model.joints.list.iter().map(ModelJoint::pair).filter(|&(a, b)| resting[a] && resting[b]) {
        sets.join(a, b);
    }
    let mut wakes = vec![false; resting.len()];
    for body in reached.into_iter().filter(|&body| resting[body]) {
        wakes[sets.smallest(body)] = true;
    }
    for body in 0..course.resting.len() {
        if course.resting[body] && wakes[sets.smallest(body)] {
            course.resting[body] = false;
            course.quiet[body] = 0;
        }
    }
    true
}
