//! The forces of contacts at one instant, and the accelerations that they give, by the law that the steps obey: with
//! the friction of contacts that stick or slide. They are queries; no step uses them.

use super::instant_forces::{BodyAcceleration, PresentForces, forces_on};
use crate::collision::contact_kinematics;
use crate::collision::contact_modes::ContactModes;
use crate::collision::friction_mode::{FrictionMode, Slide};
use crate::collision::touch::Touch;
use crate::collision::turn::{RotationModes, Turn};
use crate::model::tolerances;
use crate::solve::accelerations::{Accelerations, Wanted};
use crate::solve::joint_loads::joint_loads;
use crate::tier::core::Core;
use polhode_dynamics::BodyState;
use polhode_response::{Memory, ResponseError};
use polhode_spatial::DVec3;

/// A slip below this part of the speed that gravity gives in a step is none (no unit, 1e-6 to 1e-4): steps leave
/// contacts that stick with the residual of their problem, at most 1e-6 of it.
pub(super) const STICKING_RELATIVE: f64 = 1e-5;

impl PresentForces {
    /// Those of these contacts between `bodies` (movable, ascending).
    ///
    /// # Errors
    /// When a number is not finite.
    pub(super) fn solve(
        core: &Core,
        states: &[BodyState],
        bodies: &[usize],
        contacts: &[Touch],
    ) -> Result<Self, ResponseError> {
        let model = &core.model;
        let loads = model.loads_on(core.t, states, bodies);
        let body = |(body, linear, angular): (usize, DVec3, DVec3)| BodyAcceleration { body, linear, angular };
        let contacts: Vec<Touch> = contacts.iter().map(|touch| with_modes(core, states, touch)).collect();
        let wanted = (Wanted::Present, &mut Memory::default());
        let found = Accelerations::solve(model, (core.t, states), bodies, &contacts, &loads, wanted)?;
        let normal: Vec<f64> = found.solution.reactions.iter().take(contacts.len()).copied().collect();
        let friction: Vec<DVec3> =
            found.contacts.iter().map(|tangent| tangent.map_or(DVec3::ZERO, |t| t.force)).collect();
        let on_contacts = forces_on(&contacts, &normal, &friction);
        let joints = joint_loads(model, states, (&found.assembly, &found.solution.reactions), on_contacts);
        let accelerations = found.assembly.split(&found.of_bodies).map(body).collect();
        Ok(Self { normal, friction, accelerations, joints })
    }
}

/// The contact with its modes: it slides or turns where its velocity is more than a step leaves of one that is held.
fn with_modes(core: &Core, states: &[BodyState], touch: &Touch) -> Touch {
    let model = &core.model;
    let none = STICKING_RELATIVE * model.gravity().length() * core.settings.step_s;
    let noise = tolerances::velocity_rounding(model, states, &[touch.id.a, touch.id.b]);
    let mode = |velocity: DVec3, size: f64| {
        let speed = velocity.length();
        let slide = Slide { direction: velocity / speed, speed, noise: noise / size };
        (speed > none.max(noise) / size).then_some(FrictionMode::Sliding(slide))
    };
    let slip = contact_kinematics::tangential_kinematics(model, states, touch.id)
        .map_or(DVec3::ZERO, |terms| terms.slip_velocity);
    let rotation = contact_kinematics::relative_rotation(model, states, touch.id);
    let size = tolerances::pair_size(model, touch.id.a, touch.id.b);
    let turn = |turn: Turn| {
        turn.friction(model, (touch.id.a, touch.id.b))?;
        mode(turn.part(rotation, touch.kinematics.geometry.normal), size)
    };
    Touch { modes: ContactModes { friction: mode(slip, 1.0), rotation: RotationModes::of(turn) }, ..*touch }
}
