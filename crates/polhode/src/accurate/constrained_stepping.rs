//! A step of an island with a fixed active set: integrated once, before events are located on it.
//!
//! By DOP853 each island takes the longest step that its own error estimate accepts; by the classical method of order 4
//! (`stage_method.rs`) every step is the longest allowed. If all forces on a body act through its centre of mass, its
//! attitude is that of free rotation, unless the scene names an integrator. A step that an event cuts short is repeated
//! from its start with the shorter step, not interpolated, so that states at events are as accurate as states at step
//! ends.
//!
//! Slow slips. After a small impact a contact slips at `u` (m/s) and friction changes that at the rate `u'` (m/s^2):
//! the slip ends, or turns, after some `|u| / |u'|`, a ten-thousandth of the step that the bodies made before. A step
//! far beyond that has an error that hardly falls with its length, so that the error control would shorten it a dozen
//! times. Where the first attempt is refused, the next one is at most [`SLIP_SHARE`] times that time long, and is
//! mostly accepted.

use super::constrained_step::{ConstrainedStep, StepEndStates, end_of, step_limit, unpack};
use super::flat_positions::{FlatPosition, Stages};
use super::motions::Motions;
use super::motor_bounds::corner_within;
use super::pace::is_instant;
use super::stage_method::{MethodStep, StageMethod};
use super::system::ContactSystem;
use crate::collision::active_contacts::ActiveContacts;
use crate::collision::contact_kinematics;
use crate::collision::friction_mode::Slide;
use crate::error::SimulationError;
use crate::identity::contact_id::ContactId;
use crate::model::Model;
use crate::solve::cone_violation::ConeViolation;
use crate::solve::contradiction::refuse_contradictions;
use crate::tier::core::Core;
use polhode_dynamics::error_allowance::{ErrorAllowance, LargestError};
use polhode_dynamics::field::Wrench;
use polhode_dynamics::integrated_motion::OVERHANG;
use polhode_dynamics::integrator::dop853::STEP_SHARE;
use polhode_dynamics::state::{ANGULAR_MOMENTUM, LINEAR_VELOCITY, WIDTH};
use polhode_dynamics::step_control::{Accepted, Attempt, StepControl, Steps};
use polhode_dynamics::{BodyState, DenseStep, Dop853, Flight, RigidBody};
use polhode_response::ResponseError;
use polhode_spatial::DVec3;

/// A step shorter than this fraction of the longest allowed makes no progress.
const SMALLEST_STEP_RELATIVE: f64 = 1e-15;

/// Nor does one shorter than this many times the spacing of times (no unit): the rounding of its end, half a spacing,
/// would lie beyond the part of a step by which an interval may leave it, where the bounds of the motion are infinite.
const SMALLEST_STEP_UNITS: f64 = 0.5 / OVERHANG;

/// Rounding error of the directions of contact forces, which differs from stage to stage: that of the normals, a few
/// rounding units.
const DIRECTION_ROUNDING: f64 = 2.0 * f64::EPSILON;

/// Rounding of the poses at which fields are evaluated (relative, 2^-53 to 2^-50): one rounding unit. With a larger
/// value steps would grow until their own error, which changes the energy, is as large as this allowance.
const POSE_ROUNDING: f64 = 0.5 * f64::EPSILON;

/// Length of a step after one that was refused, in times in which the slowest slip would end (no unit, 1 to 1.5): its
/// end lies just within the step.
const SLIP_SHARE: f64 = 1.25;

/// Most that a step proposes for the next one where slips have shortened it, in its own lengths (no unit): as error
/// control lets steps grow.
const SLIP_GROWTH: f64 = 6.0;

/// A step that was made, and whose error is accepted.
#[derive(Debug)]
struct MadeStep {
    method: MethodStep,
    dense: DenseStep,
    /// How far the forces at its start are from Coulomb's law.
    violation: Option<ConeViolation>,
}

/// An attempted step, and in which time the first slip at its start would end, s: infinite where that was not asked
/// for.
struct Attempted {
    step: Attempt<MadeStep>,
    slip_time_s: f64,
}

/// The steps of bodies with their held contacts from `t` (s).
struct IslandSteps<'a> {
    motions: &'a mut Motions,
    core: &'a mut Core,
    bodies: &'a [usize],
    active: &'a ActiveContacts,
    t: f64,
    limit_s: f64,
    /// In which the first slip would end, s; infinite before an attempt has been refused, and without slips.
    slip_time_s: f64,
    /// Where loops lie flat near the start.
    flat: Option<FlatPosition>,
}

impl IslandSteps<'_> {
    /// The length of a step (s) that does not end near a flat position, where the limit cuts what is proposed (s) to
    /// `length` (s). Beyond the limit the motion has to be as smooth as before.
    fn beside_flat(&self, proposed: f64, length: f64) -> f64 {
        let most = if self.core.model.prescribed.is_empty() { proposed } else { length };
        self.flat.map_or(length, |flat| flat.length_beside(most, length))
    }
}

impl Steps for IslandSteps<'_> {
    type Step = MadeStep;
    type Error = SimulationError;

    fn limit_s(&self) -> f64 {
        self.limit_s
    }

    fn smallest_s(&self) -> f64 {
        let spacing = SMALLEST_STEP_UNITS * f64::EPSILON * self.t.abs();
        spacing.max(SMALLEST_STEP_RELATIVE * self.core.settings.step_s)
    }

    /// If the remainder after this step would be too short for another one, the step extends to the limit.
    fn first_length(&self, proposed_s: f64) -> f64 {
        let is_whole = is_instant(self.limit_s - proposed_s, self.core.settings.step_s);
        self.beside_flat(proposed_s, if is_whole { self.limit_s } else { proposed_s })
    }

    fn repeated_length(&self, proposed_s: f64) -> f64 {
        let length = proposed_s.min(SLIP_SHARE * self.slip_time_s);
        self.beside_flat(length, length.min(self.limit_s))
    }

    fn attempt(&mut self, length_s: f64) -> Result<Attempt<Self::Step>, SimulationError> {
        let attempted = self.motions.attempt_step(self.core, self.bodies, self.active, (self.t, length_s), self.flat);
        self.slip_time_s = self.slip_time_s.min(attempted.slip_time_s);
        Ok(attempted.step)
    }

    fn too_small(&self, _last: Option<f64>) -> SimulationError {
        SimulationError::StepTooSmall { t_s: self.t, smallest_s: self.smallest_s(), bodies: Vec::new() }
            .among(&self.core.model, self.bodies)
    }
}

impl Motions {
    /// Integrates bodies with their held contacts from `t` over the longest step that the error control accepts.
    ///
    /// # Errors
    /// When no step is short enough, or gears and prescribed motions contradict each other.
    pub(super) fn constrained_step(
        &mut self,
        core: &mut Core,
        bodies: &[usize],
        active: &ActiveContacts,
        t: f64,
    ) -> Result<ConstrainedStep, SimulationError> {
        refuse_contradictions(&core.model, t, &self.states, bodies)?;
        let longest = core.settings.step_s;
        let proposed = bodies.iter().map(|&body| self.tracks[body].proposed_step_s).fold(longest, f64::min);
        let mut control = StepControl::proposing(proposed);
        let limit_s = step_limit(core, (bodies, active.held()), t);
        let (slip_time_s, flat) = (f64::INFINITY, self.flat_position(core, bodies, t));
        let mut steps = IslandSteps { motions: self, core, bodies, active, t, limit_s, slip_time_s, flat };
        let Accepted { step, length_s, error } = control.next_step(&mut steps)?;
        let most = if steps.slip_time_s.is_finite() { SLIP_GROWTH * length_s } else { f64::INFINITY };
        let next = control.proposed_s().min(most).min(longest);
        for &body in bodies {
            self.tracks[body].proposed_step_s = next;
        }
        let whole = self.accepted_step(core, bodies, active, (t, length_s), (step, error));
        let mut scratch = std::mem::take(&mut self.scratch);
        let corner = corner_within(core, &whole, &mut scratch);
        self.restore_scratch(core, scratch, bodies);
        let up_to = corner.and_then(|corner| self.repeated_step(core, bodies, active, (t, corner - t)));
        Ok(up_to.unwrap_or(whole))
    }

    /// A step from `t` over `h` (s) that has been accepted before: the same bits from the same start.
    pub(super) fn repeated_step(
        &mut self,
        core: &mut Core,
        bodies: &[usize],
        active: &ActiveContacts,
        (t, h): (f64, f64),
    ) -> Option<ConstrainedStep> {
        let flat = self.flat_position(core, bodies, t);
        let accepted = self.attempt_step(core, bodies, active, (t, h), flat).step.accepted()?;
        Some(self.accepted_step(core, bodies, active, (t, h), accepted))
    }

    /// Attempts a step near this flat position of loops.
    fn attempt_step(
        &mut self,
        core: &Core,
        bodies: &[usize],
        active: &ActiveContacts,
        (t, h): (f64, f64),
        flat: Option<FlatPosition>,
    ) -> Attempted {
        let about = core.accounts.books.ledger.momentum.about;
        let mut scratch = std::mem::take(&mut self.scratch);
        let mut system = ContactSystem::new(&core.model, &mut scratch, bodies, active, about);
        let attempted = self.attempt(core, &mut system, (t, h), flat);
        let refused = |error: &f64| *error > 1.0 || error.is_nan();
        let mut slip_time_s = f64::INFINITY;
        let step = match attempted {
            Err(_) => Attempt::Failed,
            // Its states within are of no use.
            Ok((method, Some(error))) if refused(&error) => {
                let rates = method.embedded().map_or(&[][..], Dop853::start_rates);
                slip_time_s = self.slip_time(core, (bodies, active), (rates, h), &mut scratch);
                Attempt::Refused(error)
            }
            Ok((mut method, error)) => match method.dense(&mut system) {
                Err(_) => Attempt::Failed,
                // Components without an error estimate may be infinite although all estimated errors are small enough.
                Ok(_) if method.end_state().iter().any(|number| !number.is_finite()) => Attempt::Failed,
                Ok(dense) => {
                    let violation = system.violation_at_start();
                    Attempt::Made { step: MadeStep { method, dense, violation }, error }
                }
            },
        };
        self.restore_scratch(core, scratch, bodies);
        Attempted { step, slip_time_s }
    }

    /// The least time (s) in which a slip of these bodies would end or turn at the rates of their states at the start;
    /// infinite where nothing slips. `scratch` is overwritten.
    fn slip_time(
        &self,
        core: &Core,
        (bodies, active): (&[usize], &ActiveContacts),
        (rates, h): (&[f64], f64),
        scratch: &mut [BodyState],
    ) -> f64 {
        if !active.slides() {
            return f64::INFINITY;
        }
        for (&body, rates) in bodies.iter().zip(rates.as_chunks::<WIDTH>().0) {
            let of = |first: usize| DVec3::new(rates[first], rates[first + 1], rates[first + 2]);
            let mut ahead = self.states[body];
            // A step of `h` ahead: slips are linear in the velocities.
            ahead.linear_velocity += of(LINEAR_VELOCITY) * h;
            ahead.angular_momentum += of(ANGULAR_MOMENTUM) * h;
            scratch[body] = ahead;
        }
        let time = |(id, slide): (ContactId, Slide)| {
            let slip = contact_kinematics::tangential_kinematics(&core.model, &self.states, id)?.slip_velocity;
            let change = contact_kinematics::tangential_kinematics(&core.model, scratch, id)?.slip_velocity - slip;
            (slip.length() > slide.zero_speed()).then(|| h * slip.length() / change.length())
        };
        active.sliding().filter_map(time).fold(f64::INFINITY, f64::min)
    }

    /// The flat position of loops of these bodies near the start of a step from `t` (s).
    fn flat_position(&mut self, core: &Core, bodies: &[usize], t: f64) -> Option<FlatPosition> {
        let mut beside = std::mem::take(&mut self.scratch);
        let flat = FlatPosition::near(core, &self.states, bodies, t, &mut beside);
        self.restore_scratch(core, beside, bodies);
        flat
    }

    /// The step of an accepted attempt, with its error relative to the allowed error.
    fn accepted_step(
        &mut self,
        core: &mut Core,
        bodies: &[usize],
        active: &ActiveContacts,
        (t, h): (f64, f64),
        (made, error): (MadeStep, f64),
    ) -> ConstrainedStep {
        let MadeStep { method: step, dense, violation } = made;
        core.note_friction(t, violation);
        // A method without error control has no error to compare.
        if step.estimates_error() {
            core.accounts.note_step_error(error);
        }
        let rigid = |body: usize| core.model.bodies[body].rigid.as_ref();
        let motion = |(index, &body): (usize, &usize)| dense.body_motion(index * WIDTH, rigid(body)?);
        let motions = bodies.iter().enumerate().map(motion).collect();
        let spins = bodies.iter().map(|&body| self.free_spin(core, body, active.held(), t)).collect();
        let end = end_of(core, (bodies, active.held()), t, h);
        let mut end_state = step.end_state().to_vec();
        // A step across a flat position may end before its method does.
        if end < t + h && !is_instant(t + h - end, core.settings.step_s) {
            dense.evaluate(end, &mut end_state);
        }
        ConstrainedStep { bodies: bodies.to_vec(), active: active.clone(), t, end, h, end_state, dense, motions, spins }
    }

    /// Free rotation of a body over a step from `t`, if no held contact and no force can turn it. The flight record of
    /// an earlier step is used as long as the body has the attitude that it gives: a new record at every step would add
    /// its rounding.
    fn free_spin(&mut self, core: &Core, body: usize, held: &[ContactId], t: f64) -> Option<Flight> {
        let is_held = held.iter().any(|id| id.a == body || id.b == body);
        if is_held || core.settings.named_integrator.is_some() || !core.model.is_loaded_without_torque(body) {
            return None;
        }
        let state = self.states[body];
        let gives_this_attitude = |spin: &Flight| {
            polhode_spatial::Motion::pose(spin, t).rotation == state.pose.rotation
                && spin.start().angular_momentum == state.angular_momentum
        };
        if let Some(spin) = self.spins.get(&body).filter(|spin| gives_this_attitude(spin)) {
            return Some(*spin);
        }
        let rigid = core.model.bodies[body].rigid.as_ref()?;
        let spin = Flight::new(rigid, t, &state, DVec3::ZERO);
        self.spins.insert(body, spin);
        Some(spin)
    }

    /// A step of the scene's method, and its error if the method estimates one.
    fn attempt(
        &self,
        core: &Core,
        system: &mut ContactSystem<'_>,
        (t, h): (f64, f64),
        flat: Option<FlatPosition>,
    ) -> Result<(MethodStep, Option<f64>), ResponseError> {
        system.evaluate_at(flat.map_or(Stages::AsTheyAre, |flat| flat.stages(h)));
        let step = StageMethod::of(&core.settings).attempt(system, (t, h), system.pack())?;
        let error = match &step {
            MethodStep::Reduced(step) => Some(step.error(&core.model, core.settings.tolerance)),
            step => step.embedded().map(|method| self.error_of(core, method, system, (t, h), flat)),
        };
        Ok((step, error))
    }

    /// Largest error of an attempt over the quantities of the bodies, relative to the allowed error; NaN when one error
    /// is NaN.
    fn error_of(
        &self,
        core: &Core,
        integrator: &Dop853,
        system: &mut ContactSystem<'_>,
        (t, h): (f64, f64),
        flat: Option<FlatPosition>,
    ) -> f64 {
        let of_gaps = flat.map_or(0.0, |flat| flat.acceleration_of_gaps(h));
        let mut largest = LargestError::default();
        let bodies = system.bodies();
        let first = bodies.iter().map(|&body| self.states[body]);
        let before = system.loads_at(t, first);
        let ends: Vec<BodyState> = unpack(integrator.end_state()).collect();
        let loads = system.loads_at(t + h, ends.iter().copied());
        // What velocities change of a load, as of drag, no rounding of poses does; in an attempt that overflows it is
        // beyond all bounds.
        let by_poses = core.model.forces.has_loads_of_velocities().then(|| {
            let of = |(&body, end): (&usize, &BodyState)| BodyState { pose: end.pose, ..self.states[body] };
            system.loads_at(t + h, bodies.iter().zip(&ends).map(of).collect::<Vec<_>>().into_iter())
        });
        for (index, &body) in bodies.iter().enumerate() {
            let offset = index * WIDTH;
            let own = offset..offset + WIDTH;
            let (rates, end) = (integrator.start_rates().get(own.clone()), integrator.end_state().get(own));
            let (Some(rates), Some(end)) = (rates, end) else { continue };
            let allowance = allowance(core, body, &self.states[body], rates, end, loads.of(body));
            let cancelling = system.cancelling()[index];
            let by_pose = by_poses.as_ref().unwrap_or(&loads).of(body);
            let ends = [(&self.states[body], before.of(body)), (&ends[index], by_pose)];
            let rounding = rounding(core, body, (cancelling, field_rounding(ends)), h);
            let beside_flat = rounding_beside_flat(core, body, &self.states[body], of_gaps, h);
            let allowance = allowance.at_least(rounding).at_least(beside_flat);
            // Nothing is known of an attempt whose end is too large to be compared.
            if !allowance.is_finite() {
                return f64::NAN;
            }
            largest.include_body(integrator, offset, allowance);
        }
        largest.get()
    }

    /// States of an island's bodies at `t_next`: the end of its step, or of a shorter one from the same start.
    pub(super) fn constrained_end(
        &mut self,
        core: &Core,
        step: &ConstrainedStep,
        t_next: f64,
    ) -> Result<StepEndStates, SimulationError> {
        if t_next >= step.end {
            return Ok(step.at_end(&step.end_state, t_next));
        }
        let flat = self.flat_position(core, &step.bodies, step.t);
        if flat.is_some_and(|flat| flat.is_near_end(t_next - step.t)) {
            return Ok(step.at(t_next));
        }
        let about = core.accounts.books.ledger.momentum.about;
        let mut scratch = std::mem::take(&mut self.scratch);
        let mut system = ContactSystem::new(&core.model, &mut scratch, &step.bodies, &step.active, about);
        let attempt = self.attempt(core, &mut system, (step.t, t_next - step.t), flat);
        self.restore_scratch(core, scratch, &step.bodies);
        let (made, _) = attempt.map_err(|source| SimulationError::of_response(step.t, source))?;
        Ok(step.at_end(made.end_state(), t_next))
    }
}

/// The error allowed in a step for each quantity of a body: the tolerance, of which a step may use [`STEP_SHARE`],
/// times the scale of the quantity. The scale of length is the body's size. The scale of speed is the largest of the
/// body's speeds at both ends of the step and of the speeds that gravity, its accelerations at the start (`rates`) and
/// the forces at the end give it over its size. The largest error counts, not the mean, so that further bodies do not
/// loosen the error control.
fn allowance(core: &Core, body: usize, state: &BodyState, rates: &[f64], end: &[f64], load: Wrench) -> ErrorAllowance {
    let model: &Model = &core.model;
    let tolerance = STEP_SHARE * core.settings.tolerance;
    let length = model.bodies[body].size;
    let velocity = model.velocity(body, state);
    let gravity_speed = (model.gravity().length() * length).sqrt();
    let rigid = model.bodies[body].rigid.as_ref();
    let moment = rigid.map_or(0.0, |rigid| rigid.moments().max_element());
    let inverse_mass = rigid.map_or(0.0, RigidBody::inverse_mass);
    let size = |of: &[f64], first: usize| DVec3::new(of[first], of[first + 1], of[first + 2]).length();
    let per_moment = |value: f64| if moment > 0.0 { value / moment } else { 0.0 };
    let speed = [
        gravity_speed,
        velocity.linear.length(),
        velocity.angular.length() * length,
        (size(rates, LINEAR_VELOCITY) * length).sqrt(),
        per_moment(size(rates, ANGULAR_MOMENTUM)).sqrt() * length,
        // If a force begins to act within the step, the speed at the end may be of the order of the error.
        (load.force.length() * inverse_mass * length).sqrt(),
        per_moment(load.torque.length()).sqrt() * length,
        size(end, LINEAR_VELOCITY),
        per_moment(size(end, ANGULAR_MOMENTUM)) * length,
    ]
    .into_iter()
    .fold(0.0, f64::max);
    ErrorAllowance {
        position: tolerance * length,
        quaternion: ErrorAllowance::of_angle(tolerance),
        velocity: tolerance * speed,
        angular_momentum: tolerance * moment * speed / length,
    }
}

/// Rounding error of a step of `h` (s), for each quantity of a body: that of contact forces whose magnitudes add up to
/// `force` (N) and `moment` (N m), and that of fields, which the rounding of poses changes by `fields` (N, N m).
/// Shorter steps do not reduce it.
fn rounding(core: &Core, body: usize, ([force, moment], fields): ([f64; 2], [f64; 2]), h: f64) -> ErrorAllowance {
    let Some(rigid) = &core.model.bodies[body].rigid else { return ErrorAllowance::default() };
    let inverse_moment = 1.0 / rigid.moments().min_element();
    let speed = (DIRECTION_ROUNDING * force).max(fields[0]) * h;
    let spin = (DIRECTION_ROUNDING * moment).max(fields[1]) * h;
    ErrorAllowance {
        position: speed * rigid.inverse_mass() * h,
        quaternion: ErrorAllowance::of_angle(spin * inverse_moment * h),
        velocity: speed * rigid.inverse_mass(),
        angular_momentum: spin,
    }
}

/// The same beside a flat position, where gaps make such accelerations (1/s^2): by the rounding of its pose.
fn rounding_beside_flat(core: &Core, body: usize, state: &BodyState, of_gaps: f64, h: f64) -> ErrorAllowance {
    let size = core.model.bodies[body].size;
    let moment = core.model.bodies[body].rigid.as_ref().map_or(0.0, |rigid| rigid.moments().max_element());
    let gap = DIRECTION_ROUNDING * (state.pose.translation.abs().max_element() + size);
    let speed = of_gaps * gap * h;
    ErrorAllowance {
        position: speed * h,
        quaternion: ErrorAllowance::of_angle(speed * h / size),
        velocity: speed,
        angular_momentum: moment * speed / size,
    }
}

/// The change of the force (N) and moment (N m) of fields on a body by the rounding of its pose, from its states and
/// loads at both ends of a step: a spring of stiffness k at a coordinate x gives `k x 2^-53`. It is the change of the
/// load over the step, divided by the change of the pose in units of its rounding ([`POSE_ROUNDING`]). Of position and
/// attitude the larger number counts, so that the result is not too large if the load depends on one of them alone. For
/// a body that has not moved the result is zero.
fn field_rounding([(start, before), (end, after)]: [(&BodyState, Wrench); 2]) -> [f64; 2] {
    let (from, to) = (&start.pose, &end.pose);
    let unit = POSE_ROUNDING * from.translation.abs().max(to.translation.abs()).max_element();
    let way = (to.translation - from.translation).length();
    let places = if unit > 0.0 { way / unit } else { f64::INFINITY };
    let turn = (to.rotation.quaternion() - from.rotation.quaternion()).length();
    let units = places.max(turn / POSE_ROUNDING);
    if units > 0.0 {
        [(after.force - before.force).length() / units, (after.torque - before.torque).length() / units]
    } else {
        [0.0; 2]
    }
}

#[cfg(test)]
mod tests {
    //! The bounds of the motion hold over the shortest step that is made, whatever the rounding of its end.
    use super::{OVERHANG, SMALLEST_STEP_UNITS};

    #[test]
    fn the_rounded_end_of_the_shortest_step_is_where_the_bounds_of_its_motion_hold() {
        for t in [0.312_505_103_289_186_6, 0.999, 1.0, 1.7, 6.02e3] {
            for longer in [1.0, 1.01, 1.03, 1.31, 1.57] {
                let h = longer * SMALLEST_STEP_UNITS * f64::EPSILON * t;
                let end: f64 = t + h;
                let beyond = (end - t) / h - 1.0;
                assert!(beyond <= OVERHANG, "{t} s, {h:e} s: {beyond}");
            }
        }
    }
}
