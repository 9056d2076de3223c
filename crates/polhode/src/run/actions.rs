//! Actions: what a program does to the bodies of a simulation.
//!
//! Every action is checked before anything changes, so that a refused action leaves the simulation as it was. An action
//! ends the present steps of the bodies that it affects, wakes them from rest, and starts new steps; the steps of other
//! bodies continue. The energy ledger books the action as external work, the momentum ledger as impulse of the program.
//! After an action the plan is derived again, because the action may end a reduction (planar motion, free flight in
//! closed form, no contact); the report says when and what changed.

use crate::action_error::ActionError;
use crate::collision::contact_set;
use crate::error::SimulationError;
use crate::identity::body_id::BodyId;
use crate::identity::joint_id::JointId;
use crate::joints::{added, held, joint_contacts, motors, released};
use crate::model::plane_of_motion::Membership;
use crate::model::{INITIAL_OVERLAP_RELATIVE, Model, prescribed, reported, tolerances};
use crate::plan::decisions::{Findings, Plan};
use crate::plan::planar::{self, PlanarFinding};
use crate::plan::{free_method, pivots};
use crate::report::run_report::PlanChange;
use crate::run::simulation::Simulation;
use crate::scene::{Body, Coordinate, Joint, Motor, Scene};
use crate::solve::projection::{Removal, project_velocities};
use polhode_dynamics::BodyState;
use polhode_dynamics::field::Wrench;
use polhode_spatial::{DVec3, Pose, Velocity};
use std::collections::BTreeSet;

impl Simulation {
    /// Applies a force (N) at the centre of mass of a body and a torque (N m), world. Both act until they are set
    /// again; zero removes them.
    ///
    /// # Errors
    /// For a removed, fixed or kinematic body and for numbers that are not finite ([`ActionError`]).
    pub fn set_force(&mut self, body: BodyId, force_n: DVec3, torque_nm: DVec3) -> Result<(), SimulationError> {
        let index = self.movable(body)?;
        self.finite(index, "the force", force_n)?;
        self.finite(index, "the torque", torque_nm)?;
        let wrench = Wrench { force: force_n, torque: torque_nm };
        self.act(&[index], &[], "set_force", |simulation| Ok(simulation.core.model.set_applied(index, wrench)?))?;
        self.repeat_beside(|beside| beside.set_force(body, force_n, torque_nm));
        Ok(())
    }

    /// Gives a coordinate of a joint another motor, or none, from now on: what a controller calls at its rate.
    ///
    /// ```
    /// use polhode::mesh::solid_box;
    /// use polhode::prelude::*;
    /// use polhode::scene::{Drive, Motor};
    /// // A servo turns a door of 0.8 m by a quarter of a revolution.
    /// let leaf = solid_box(DVec3::new(0.8, 0.04, 2.0), Mass::new(20.0)?)?;
    /// let mut scene = Scene::builder("door");
    /// let door = scene.add_body(Body::movable("door", leaf).pose(Pose::from_translation(DVec3::X * 0.4)));
    /// let hinge = scene.add_joint(Joint::hinge(door, DVec3::ZERO, UnitVector::Z));
    /// let mut simulation = Simulation::new(&scene.build()?)?;
    /// let drive = Drive::Position { position: std::f64::consts::FRAC_PI_2, stiffness: 200.0, damping: 80.0 };
    /// simulation.set_motor(hinge, Coordinate::Angle, Some(Motor::new(drive)?))?;
    /// simulation.advance_to(5.0)?;
    /// let angle = simulation.coordinate(hinge, Coordinate::Angle).map_or(0.0, |angle| angle.value);
    /// assert!((angle - std::f64::consts::FRAC_PI_2).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When the joint does not exist or does not have that coordinate ([`ActionError`]).
    pub fn set_motor(
        &mut self,
        joint: JointId,
        coordinate: Coordinate,
        motor: Option<Motor>,
    ) -> Result<(), SimulationError> {
        let refused = || ActionError::NoCoordinate { joint: joint.index(), coordinate: coordinate.name() };
        let bodies = self.core.model.joints.bodies_at(joint.index(), coordinate).ok_or_else(refused)?;
        self.act(&bodies, &[], "set_motor", |simulation| {
            Ok(motors::set_motor(&mut simulation.core.model, joint.index(), coordinate, motor)?)
        })?;
        self.repeat_beside(|beside| beside.set_motor(joint, coordinate, motor));
        Ok(())
    }

    /// Applies an impulse (N s) to a body at a point (m), both world.
    ///
    /// # Errors
    /// For a removed, fixed or kinematic body and for numbers that are not finite ([`ActionError`]).
    pub fn apply_impulse(&mut self, body: BodyId, impulse_ns: DVec3, point_m: DVec3) -> Result<(), SimulationError> {
        let index = self.movable(body)?;
        self.finite(index, "the impulse", impulse_ns)?;
        self.finite(index, "the point of the impulse", point_m)?;
        self.change_state(index, &[], "apply_impulse", |model, rigid, state| {
            state.angular_momentum += (point_m - state.pose.translation).cross(impulse_ns);
            if !rigid.is_pivoted() {
                state.linear_velocity += impulse_ns * rigid.inverse_mass();
            }
            pivots::hold_velocity(model, index, state);
        })?;
        self.repeat_beside(|beside| beside.apply_impulse(body, impulse_ns, point_m));
        Ok(())
    }

    /// Sets the velocity of the centre of mass of a body and its angular velocity, world. For a body at a pivot the
    /// angular velocity determines that of the centre of mass, and the one given is ignored. Joints change it at once
    /// by their impulses, with the velocities of the bodies that they hold together.
    ///
    /// # Errors
    /// For a removed, fixed or kinematic body and for numbers that are not finite ([`ActionError`]).
    pub fn set_velocity(&mut self, body: BodyId, velocity: Velocity) -> Result<(), SimulationError> {
        let index = self.movable(body)?;
        self.finite(index, "the velocity", velocity.linear)?;
        self.finite(index, "the angular velocity", velocity.angular)?;
        self.change_state(index, &[], "set_velocity", |model, rigid, state| {
            *state = rigid.at_velocity(state.pose, pivots::admitted_velocity(model, index, &state.pose, velocity));
        })?;
        self.repeat_beside(|beside| beside.set_velocity(body, velocity));
        Ok(())
    }

    /// Sets the pose of a body (of its own origin, world). Its velocity and angular velocity stay.
    ///
    /// # Errors
    /// When the body would overlap another one or leave its pivot, when the pose is not finite, or for a removed, fixed
    /// or kinematic body ([`ActionError`]).
    pub fn set_pose(&mut self, body: BodyId, pose: Pose) -> Result<(), SimulationError> {
        let index = self.movable(body)?;
        if !pose.is_finite() {
            return Err(ActionError::NotFinite { body: self.name(index), what: "the pose" }.into());
        }
        let mut states = self.tier.states(&self.core);
        let moved = reported::moving_pose(&self.core.model, index, pose);
        let distance = pivots::leaves_pivot_by(&self.core.model, index, &states[index], &moved);
        if distance > tolerances::touch_distance(&self.core.model, &states, index, index) {
            return Err(ActionError::PivotedBody(self.name(index)).into());
        }
        states[index].pose = moved;
        let joints = held::bilaterals(&self.core.model, &states, std::slice::from_ref(&index));
        if joints.map(|joint| joint.gap()).fold(0.0, f64::max)
            > tolerances::touch_distance(&self.core.model, &states, index, index)
        {
            return Err(ActionError::JointedBody(self.name(index)).into());
        }
        if joint_contacts::exceeds_limits(&self.core.model, &states, index) {
            return Err(ActionError::BeyondLimits(self.name(index)).into());
        }
        self.check_clear(index, &states)?;
        self.change_state(index, &[index], "set_pose", |model, rigid, state| {
            // The velocities stay; the angular momentum follows from the new attitude.
            let velocity = rigid.center_of_mass_velocity(state);
            *state = rigid.at_velocity(moved, pivots::admitted_velocity(model, index, &moved, velocity));
        })?;
        self.repeat_beside(|beside| beside.set_pose(body, pose));
        Ok(())
    }

    /// Adds a body, given as in a scene, at the present time. Returns its handle.
    ///
    /// # Errors
    /// When a scene would refuse the body (its name is in use, a number is not finite), or it would overlap another
    /// body.
    pub fn add_body(&mut self, body: Body) -> Result<BodyId, SimulationError> {
        let model = &self.core.model;
        let taken = model.bodies.iter().any(|other| !other.removed && other.name == body.name);
        Scene::check_added_body(model.bodies.len(), &body, taken)?;
        let mut probe = model.clone();
        let (index, state) = probe.add_body(body.clone(), self.core.t)?;
        probe.scene.check_grains()?;
        probe.scene.check_motions()?;
        let mut states = self.tier.states(&self.core);
        states.push(state);
        check_clear(&probe, index, &states)?;
        let again = body.clone();
        self.act(&[], &[index], "add_body", |simulation| {
            let fields_before_j = simulation.field_potential();
            let (added, state) = simulation.core.model.add_body(body, simulation.core.t)?;
            simulation.tier.add_body(&simulation.core, state);
            let states = simulation.tier.states_mut().to_vec();
            simulation.core.accounts.books.added(&simulation.core.model, &states, added);
            let fields_after_j = simulation.field_potential();
            simulation.core.accounts.books.fields_changed(fields_before_j, fields_after_j);
            simulation.tier.interrupt(&mut simulation.core, &[added])
        })?;
        self.repeat_beside(|beside| beside.add_body(again.clone()).map(|_| ()));
        Ok(BodyId::new(index))
    }

    /// Removes a body. Samples keep its place, with its last pose. Bodies that rested on it are no longer supported.
    ///
    /// # Errors
    /// For a body that has already been removed ([`ActionError`]).
    pub fn remove_body(&mut self, body: BodyId) -> Result<(), SimulationError> {
        let index = self.present(body)?;
        // Bodies that joints held to it go on without it.
        let together = self.core.model.joints.with_jointed(vec![index]);
        self.act(&together, &[], "remove_body", |simulation| {
            let states = simulation.tier.states_mut().to_vec();
            let fields_before_j = simulation.field_potential();
            simulation.core.accounts.books.removed(&simulation.core.model, &states, index);
            simulation.tier.remove_body(index);
            simulation.core.model.remove_body(index)?;
            let fields_after_j = simulation.field_potential();
            simulation.core.accounts.books.fields_changed(fields_before_j, fields_after_j);
            Ok(())
        })?;
        self.repeat_beside(|beside| beside.remove_body(body));
        Ok(())
    }

    /// Adds a joint between bodies, or of a body with the world, as they are at present: its anchors are points of the
    /// world now. Velocities that it does not allow are stopped by its impulses, and their energy is the program's.
    /// Bodies that it joins do not collide with each other any more. Returns its handle.
    ///
    /// ```
    /// use polhode::mesh::solid_box;
    /// use polhode::scene::Joint;
    /// use polhode::spatial::{DVec3, Mass, UnitVector};
    /// use polhode::{Body, Scene, Simulation};
    /// // A rod that falls is caught by its end, swings, and is let go.
    /// let mut scene = Scene::builder("caught");
    /// let rod = scene.add_body(Body::movable("rod", solid_box(DVec3::new(1.0, 0.02, 0.02), Mass::new(1.0)?)?));
    /// let mut simulation = Simulation::new(&scene.build()?)?;
    /// simulation.advance_to(0.1)?;
    /// let end = simulation.body(rod).pose.translation - DVec3::X * 0.5;
    /// let hinge = simulation.add_joint(Joint::hinge(rod, end, UnitVector::Y))?;
    /// simulation.advance_to(0.3)?;
    /// assert!(((simulation.body(rod).pose.translation - end).length() - 0.5).abs() < 1e-11);
    /// simulation.remove_joint(hinge)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When a scene would refuse the joint (its limits are exceeded, its body is off its track, none of its bodies is
    /// movable, the tier does not have it), for a body that was removed, and for one on a pivot whose motion is that of
    /// a rotation alone.
    pub fn add_joint(&mut self, joint: Joint) -> Result<JointId, SimulationError> {
        let bodies = std::iter::once(joint.body()).chain(joint.other());
        let bodies = bodies.map(|body| self.present(body)).collect::<Result<Vec<_>, _>>()?;
        let is_on_pivot = |&&body: &&usize| self.core.model.bodies[body].rigid.is_some_and(|rigid| rigid.is_pivoted());
        if let Some(&body) = bodies.iter().find(is_on_pivot) {
            return Err(ActionError::JointOnPivot(self.name(body)).into());
        }
        let tier = self.core.settings.tier;
        let mut probe = self.core.model.clone();
        let number = added::add_joint(&mut probe, &joint, &self.tier.states(&self.core), tier)?;
        let held = bodies.into_iter().filter(|&body| probe.bodies[body].moves()).collect();
        let together = probe.joints.with_jointed(held);
        self.act(&together, &[], "add_joint", |simulation| {
            let fields_before_j = simulation.field_potential();
            let states = simulation.tier.states(&simulation.core);
            added::add_joint(&mut simulation.core.model, &joint, &states, tier)?;
            simulation.change_joint(probe.joints.pair_of_joint(number), fields_before_j);
            simulation.stop_at_joints(&together)
        })?;
        self.repeat_beside(|beside| beside.add_joint(joint).map(|_| ()));
        Ok(JointId::new(number))
    }

    /// Removes a joint: what it held moves on without it. Its gears and its prescribed motion go with it. Its bodies do
    /// not collide with each other, as before.
    ///
    /// # Errors
    /// For a joint that does not exist or is not there any more ([`ActionError`]).
    pub fn remove_joint(&mut self, joint: JointId) -> Result<(), SimulationError> {
        let (index, joints) = (joint.index(), self.core.model.scene.joints().len());
        if index >= joints {
            return Err(ActionError::UnknownJoint { index, joints }.into());
        }
        let pair = self.core.model.joints.pair_of_joint(index).ok_or(ActionError::RemovedJoint(index))?;
        let held = [pair.0, pair.1].into_iter().filter(|&body| self.core.model.bodies[body].moves()).collect();
        let together = self.core.model.joints.with_jointed(held);
        self.act(&together, &[], "remove_joint", |simulation| {
            let fields_before_j = simulation.field_potential();
            released::release(&mut simulation.core.model, &[index])?;
            simulation.change_joint(Some(pair), fields_before_j);
            Ok(())
        })?;
        self.repeat_beside(|beside| beside.remove_joint(joint));
        Ok(())
    }

    /// Books what a joint that was added or taken away changes in the energy of fields, which was this (J), and tells
    /// the tier.
    fn change_joint(&mut self, pair: Option<(usize, usize)>, fields_before_j: f64) {
        if let Some(pair) = pair {
            self.tier.change_joint(&mut self.core, pair);
        }
        let fields_after_j = self.field_potential();
        self.core.accounts.books.fields_changed(fields_before_j, fields_after_j);
    }

    /// Stops what joints of these bodies do not allow of their velocities. The change is the program's.
    fn stop_at_joints(&mut self, bodies: &[usize]) -> Result<(), SimulationError> {
        let before = self.tier.states_mut().to_vec();
        let before = self.core.accounts.books.balance(&self.core.model, &before, bodies);
        self.keep_velocities_of_joints(bodies)?;
        let after = self.tier.states_mut().to_vec();
        let after = self.core.accounts.books.balance(&self.core.model, &after, bodies);
        self.core.accounts.books.program(before, after);
        Ok(())
    }

    /// Takes out of the velocities of bodies that joints hold together what the joints do not allow.
    fn keep_velocities_of_joints(&mut self, bodies: &[usize]) -> Result<(), SimulationError> {
        let (model, states) = (&self.core.model, self.tier.states_mut());
        if bodies.len() > 1 || model.joints.joints_among(bodies).next().is_some() {
            project_velocities(model, states, bodies, (&[], &[], &[]), Removal::Complete)
                .map_err(|source| SimulationError::of_response(self.core.t, source))?;
        }
        Ok(())
    }

    /// Potential energy of the force fields on the present bodies, J.
    fn field_potential(&mut self) -> f64 {
        self.core.model.field_potential(self.tier.states_mut())
    }

    /// Changes the state of a body and books the change as one by the program. `moved` holds the body if its pose
    /// changes, and nothing else.
    fn change_state(
        &mut self,
        index: usize,
        moved: &[usize],
        what: &'static str,
        change: impl Fn(&Model, &polhode_dynamics::RigidBody, &mut BodyState),
    ) -> Result<(), SimulationError> {
        if let Some(rigid) = &self.core.model.bodies[index].rigid {
            // The effect of finite numbers may overflow.
            let mut state = self.tier.states(&self.core)[index];
            change(&self.core.model, rigid, &mut state);
            if !(state.is_finite() && rigid.kinetic_energy(&state).is_finite()) {
                return Err(
                    ActionError::NotFinite { body: self.name(index), what: "the state after the action" }.into()
                );
            }
        }
        // Joints pass on at once what the program does to one of their bodies.
        let together = self.core.model.joints.with_jointed(vec![index]);
        self.act(&together, moved, what, |simulation| {
            let Some(rigid) = simulation.core.model.bodies[index].rigid else { return Ok(()) };
            let before = simulation.tier.states_mut().to_vec();
            let before = simulation.core.accounts.books.balance(&simulation.core.model, &before, &together);
            let (model, states) = (&simulation.core.model, simulation.tier.states_mut());
            change(model, &rigid, &mut states[index]);
            simulation.keep_velocities_of_joints(&together)?;
            let after = simulation.tier.states_mut().to_vec();
            let after = simulation.core.accounts.books.balance(&simulation.core.model, &after, &together);
            simulation.core.accounts.books.program(before, after);
            Ok(())
        })
    }

    /// Ends the steps of `bodies`, applies `change`, derives the plan again, and starts new steps. The poses of `moved`
    /// have changed.
    pub(crate) fn act(
        &mut self,
        bodies: &[usize],
        moved: &[usize],
        what: &'static str,
        change: impl FnOnce(&mut Self) -> Result<(), SimulationError>,
    ) -> Result<(), SimulationError> {
        // Where bodies of a planar motion are concerned, the symmetry of all of them must be measured again.
        let planar = &self.core.model.planar;
        let is_in_plane = |&body: &usize| planar.membership(body) != Membership::Outside;
        let measured = bodies.iter().chain(moved).any(is_in_plane);
        let in_plane = planar.bodies().filter(|_| measured);
        let concerned: BTreeSet<usize> = bodies.iter().copied().chain(in_plane).collect();
        self.tier.interrupt(&mut self.core, &concerned.into_iter().collect::<Vec<_>>())?;
        change(self)?;
        let planar = if measured { self.still_planar() } else { PlanarFinding::of(&self.core.model) };
        self.derive_plan_again(what, planar);
        self.tier.resume(&mut self.core, moved)
    }

    /// The bodies whose motion is still planar.
    fn still_planar(&self) -> PlanarFinding {
        let core = &self.core;
        if core.model.planar.plane().is_none() {
            return PlanarFinding::off("not examined again after an action of the program");
        }
        let found = planar::find(&core.model, &self.tier.states(core), &core.settings);
        PlanarFinding { planar: core.model.planar.among(&found.planar), ..found }
    }

    /// Notes in the plan that bodies of a planar motion have met others.
    pub(crate) fn note_planar_bodies(&mut self) {
        let plan = self.plan.with_planar(&PlanarFinding::of(&self.core.model));
        self.change_plan(plan, "a body met one that is not in its plane");
    }

    fn change_plan(&mut self, plan: Plan, what: &'static str) {
        let changes = plan.changes_from(&self.plan);
        if !changes.is_empty() {
            self.plan_changes.push(PlanChange { t_s: self.core.t, action: what.to_owned(), changes });
        }
        self.plan = plan;
    }

    /// Derives the plan again after an action.
    fn derive_plan_again(&mut self, what: &'static str, planar: PlanarFinding) {
        let states = self.tier.states(&self.core);
        let core = &mut self.core;
        let tier_reason = self.plan.tier_reason.clone();
        let choice = free_method::choose(&core.model, &states, &core.settings.as_resolved());
        core.settings.integrator = choice.integrator;
        core.model.planar = planar.planar.clone();
        let findings =
            Findings { t_s: core.t, touching_pairs: self.tier.touching_pairs(), tier_reason, choice, planar };
        let plan = Plan::derive(&core.model, &core.settings, core.effects, &findings);
        self.change_plan(plan, what);
    }

    /// Index of a body that has not been removed.
    fn present(&self, body: BodyId) -> Result<usize, ActionError> {
        let (index, bodies) = (body.index(), self.core.model.bodies.len());
        match self.core.model.bodies.get(index) {
            None => Err(ActionError::UnknownBody { index, bodies }),
            Some(known) if known.removed => Err(ActionError::RemovedBody(known.name.clone())),
            Some(_) => Ok(index),
        }
    }

    /// Index of a body that follows a motion.
    pub(crate) fn kinematic(&self, body: BodyId) -> Result<usize, ActionError> {
        let index = self.present(body)?;
        let follows = prescribed::trajectory(&self.core.model, index).is_some();
        if follows { Ok(index) } else { Err(ActionError::NotKinematic(self.name(index))) }
    }

    /// Index of a body that forces move.
    fn movable(&self, body: BodyId) -> Result<usize, ActionError> {
        let index = self.present(body)?;
        if self.core.model.bodies[index].moves() { Ok(index) } else { Err(ActionError::FixedBody(self.name(index))) }
    }

    pub(crate) fn name(&self, index: usize) -> String {
        self.core.model.bodies[index].name.clone()
    }

    pub(crate) fn finite(&self, index: usize, what: &'static str, vector: DVec3) -> Result<(), ActionError> {
        if vector.is_finite() { Ok(()) } else { Err(ActionError::NotFinite { body: self.name(index), what }) }
    }

    fn check_clear(&self, index: usize, states: &[BodyState]) -> Result<(), ActionError> {
        check_clear(&self.core.model, index, states)
    }
}

/// Checks that a body overlaps no other body by more than counts as touch.
fn check_clear(model: &Model, index: usize, states: &[BodyState]) -> Result<(), ActionError> {
    for other in (0..model.bodies.len()).filter(|&other| model.scene.may_collide(index, other)) {
        let Some(separation) = contact_set::separation_without_memory(model, states, index, other) else { continue };
        let allowed_m = INITIAL_OVERLAP_RELATIVE * tolerances::pair_size(model, index, other)
            + tolerances::rounding(model, states, index, other);
        if separation < -allowed_m {
            let name = |body: usize| model.bodies[body].name.clone();
            let (body_a, body_b) = (name(index), name(other));
            return Err(ActionError::Overlap { body_a, body_b, depth_m: -separation, allowed_m });
        }
    }
    Ok(())
}
