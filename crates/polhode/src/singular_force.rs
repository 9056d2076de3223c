//! Which force a run has failed at.
//!
//! A force field may be singular: a point attracts with mu/d^2, which is not finite at the point and cannot be followed into
//! it. What fails first is then a step, a search or an energy, whose message says nothing of the cause. Here the forces of the
//! scene are asked one by one, at the states of the present.

use crate::SimulationError;
use crate::core::Core;
use crate::scene::Force;
use crate::world::World;
use polhode_dynamics::field::Wrench;
use polhode_dynamics::integrator::IntegrationError;
use polhode_dynamics::{BodyState, RigidBody};

/// A force counts as the cause when alone it would take the body, from rest, over so many times its own size within the
/// longest step (dimensionless, 1 to 1e6): forces that steps of that length resolve move it by a part of its size.
const SIZES_PER_STEP: f64 = 1e3;

/// The first force of the scene that is not finite on a body in these states at `t` (s).
pub(crate) fn not_finite(world: &World, t: f64, states: &[BodyState]) -> Option<SimulationError> {
    let mut found = None;
    for_each_wrench(world, t, states, |force, body, wrench| {
        if found.is_none() && !is_finite(wrench) {
            found = Some(SimulationError::ForceNotFinite { t, body: name(world, body), force: describe(world, force) });
        }
    });
    found
}

/// The same failure with the force that has caused it, if one of these states has; the failure as it is otherwise.
pub(crate) fn explained(error: SimulationError, core: &Core, states: &[BodyState]) -> SimulationError {
    if !may_come_of_a_force(&error) || core.world.scene.forces().is_empty() {
        return error;
    }
    let (world, t) = (&core.world, core.t);
    if let Some(cause) = not_finite(world, t, states) {
        return cause;
    }
    let mut strongest: Option<(f64, usize, usize, Wrench)> = None;
    for_each_wrench(world, t, states, |force, body, wrench| {
        let inverse_mass = world.bodies[body].rigid.as_ref().map_or(0.0, RigidBody::inverse_mass);
        let way = wrench.force.length() * inverse_mass * core.settings.step_s * core.settings.step_s;
        let sizes = way / world.bodies[body].size;
        if sizes > SIZES_PER_STEP && strongest.is_none_or(|(largest, ..)| sizes > largest) {
            strongest = Some((sizes, force, body, wrench));
        }
    });
    strongest.map_or(error, |(_, force, body, wrench)| SimulationError::SingularForce {
        t,
        body: name(world, body),
        force: describe(world, force),
        force_n: wrench.force.length(),
    })
}

/// Whether a singular force may fail so.
fn may_come_of_a_force(error: &SimulationError) -> bool {
    match error {
        SimulationError::StepTooSmall { .. }
        | SimulationError::EnergyOverflow { .. }
        | SimulationError::Diverged { .. }
        | SimulationError::ImpactSearch { .. } => true,
        SimulationError::Integration { source, .. } => {
            matches!(source, IntegrationError::StepTooSmall { .. } | IntegrationError::NotFinite { .. })
        }
        _ => false,
    }
}

/// Calls `asked` with the number of every force of the scene, of every body that it acts on, and its wrench there.
fn for_each_wrench(world: &World, t: f64, states: &[BodyState], mut asked: impl FnMut(usize, usize, Wrench)) {
    let own = world.movable_states(states);
    for (number, force) in world.scene.forces().iter().enumerate() {
        // Forces that make no field have been refused when the scene was built.
        let Ok(fields) = force.fields(world) else { continue };
        let mut wrenches = vec![Wrench::default(); own.len()];
        for field in &fields {
            field.add_wrenches(t, world.free_motion().bodies(), &own, &mut wrenches);
        }
        for (&body, wrench) in world.movable.iter().zip(wrenches) {
            if world.bodies[body].moves() && states[body].is_finite() {
                asked(number, body, wrench);
            }
        }
    }
}

fn is_finite(wrench: Wrench) -> bool {
    wrench.force.is_finite() && wrench.torque.is_finite()
}

fn name(world: &World, body: usize) -> String {
    world.bodies[body].name.clone()
}

/// A force as a message names it: its number in the scene, from one, and its kind.
fn describe(world: &World, number: usize) -> String {
    let kind = match world.scene.forces().get(number) {
        Some(Force::PointGravity { center, .. }) => format!("point gravity towards {center} m"),
        Some(Force::MutualGravity { .. }) => "mutual gravity".to_owned(),
        Some(Force::Applied { .. }) => "an applied load".to_owned(),
        Some(Force::Drag { .. }) => "drag".to_owned(),
        Some(Force::Spring { .. }) => "a spring".to_owned(),
        Some(Force::Field(_)) | None => "a field of the program".to_owned(),
    };
    format!("force number {} ({kind})", number + 1)
}
