//! The model that the engine computes with: all bodies of a scene, in their moving frames.
//!
//! The moving frame C of a body has the axes of the body. Its origin is the centre of mass (thesis 3.2: "we can offset
//! all the values so that the origin is forced to coincide with the centre of mass"), or the pivot of a body whose
//! motion is reduced to rotation about it (`pivots.rs`). Shapes are transformed into the moving frame once, here;
//! `reported.rs` transforms results back.

use super::body::ModelBody;
use super::carriages::add_carriages;
use super::fields::Forces;
use super::joints::Joints;
use super::steered::Steered;
use super::surfaces::Surfaces;
use crate::constraint::joint::{HeldBody, ModelJoint, row_length};
use crate::identity::contact_id::Feature;
use crate::identity::coordinate_id::CoordinateId;
use crate::identity::stop_id::StopId;
use crate::model::envelope::CollisionEnvelope;
use crate::model::narrow_phase::NarrowPhase;
use crate::model::pivot_form::{PivotForm, PivotRows};
use crate::model::plane_of_motion::PlanarBodies;
use crate::model::prescribed_state;
use crate::model::work::Work;
use crate::scene::{Body, Joint, MovingFrames, Scene, SceneError};
use polhode_dynamics::{BodyState, RigidBody};
use polhode_spatial::{DVec3, Velocity};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// All bodies of a scene, the scene, and what holds, moves and rubs the bodies.
#[derive(Debug, Clone)]
pub(crate) struct Model {
    pub(crate) scene: Scene,
    pub(crate) bodies: Vec<ModelBody>,
    /// Indices of the bodies that forces move, ascending; a *slot* is a place in this list.
    pub(crate) movable: Vec<usize>,
    /// Indices of the kinematic bodies, ascending.
    pub(crate) prescribed: Vec<usize>,
    /// The motions that a program has given kinematic bodies.
    pub(super) steered: BTreeMap<usize, Steered>,
    /// Mass properties of the movable bodies, by slot.
    pub(super) rigid: Arc<[RigidBody]>,
    /// For which pivoted bodies there are constraint rows.
    pub(crate) pivot_rows: PivotRows,
    pub(crate) joints: Joints,
    pub(crate) forces: Forces,
    pub(crate) surfaces: Surfaces,
    /// The envelope of micro-collisions, of a tier that has them.
    pub(crate) envelope: Option<CollisionEnvelope>,
    pub(crate) narrow_phase: NarrowPhase,
    /// The bodies whose motion is planar.
    pub(crate) planar: PlanarBodies,
    /// What has been computed with it.
    pub(crate) work: Work,
}

impl Model {
    /// Whether any two bodies that may collide have friction, or any joint.
    pub(crate) fn has_friction(&self) -> bool {
        self.surfaces.have_friction() || self.joints.have_friction
    }

    /// Velocity of the moving frame of a body; zero for a fixed body.
    pub(crate) fn velocity(&self, index: usize, state: &BodyState) -> Velocity {
        match (&self.bodies[index].rigid, &self.bodies[index].trajectory) {
            (Some(rigid), _) => rigid.velocity(state),
            (None, Some(_)) => prescribed_state::velocity_of(state),
            (None, None) => Velocity::ZERO,
        }
    }

    /// The model of a scene, and the states of its bodies at t = 0.
    ///
    /// # Errors
    /// When a shape cannot be expressed in the moving frame of its body, or a force is not valid.
    pub(crate) fn new(scene: &Scene, pivot_rows: PivotRows) -> Result<(Self, Vec<BodyState>), SceneError> {
        let may_collide = |a: usize| (0..scene.bodies().len()).any(|b| scene.may_collide(a, b));
        let bodies = scene.bodies().iter().enumerate().map(|(index, body)| {
            let is_jointed = scene.joints().iter().any(|joint| joint.bodies().any(|held| held == index));
            let form = if is_jointed { PivotForm::jointed(body) } else { pivot_rows.form(body, || may_collide(index)) };
            ModelBody::new(body, form, || may_collide(index))
        });
        let mut bodies = bodies.collect::<Result<Vec<_>, _>>()?;
        let mut of_model = scene.clone();
        bodies.extend(add_carriages(&mut of_model)?);
        let carriages = scene.bodies().len()..bodies.len();
        let states: Vec<_> =
            of_model.bodies().iter().zip(&bodies).map(|(body, model)| model.state_at(body, 0.0)).collect();
        let movable: Vec<usize> = (0..bodies.len()).filter(|&body| bodies[body].moves()).collect();
        let prescribed = (0..bodies.len()).filter(|&body| bodies[body].trajectory.is_some()).collect();
        let rigid = bodies.iter().filter_map(|body| body.rigid).collect();
        let breakable = (0..scene.joints().len()).filter(|&joint| scene.joints()[joint].strength().is_some()).collect();
        let mut model = Self {
            scene: of_model,
            bodies,
            movable,
            prescribed,
            rigid,
            pivot_rows,
            steered: BTreeMap::new(),
            joints: Joints::none(breakable, carriages),
            forces: Forces::default(),
            surfaces: Surfaces::of(scene),
            envelope: None,
            narrow_phase: NarrowPhase::default(),
            planar: PlanarBodies::default(),
            work: Work::default(),
        };
        model.make_joints(&states);
        let velocities: Vec<_> = states.iter().enumerate().map(|(body, state)| model.velocity(body, state)).collect();
        model.joints.make_ties(&model.scene, |body| (states[body].pose, velocities[body]));
        model.index_joints();
        model.make_fields()?;
        model.forces.initial_potential_j = model.field_potential(&states);
        model.forces.start_potential_j = model.sum_start_potentials();
        Ok((model, states))
    }

    /// Makes the joints of the scene, between bodies in their states at the start.
    fn make_joints(&mut self, states: &[BodyState]) {
        let joints = self.scene.joints().iter().enumerate();
        self.joints.list = joints.map(|(number, joint)| self.joint_between(number, joint, states)).collect();
        self.joints.ending_tracks = self.joints.list.iter().filter(|joint| joint.lets_go_at_ends()).count();
    }

    /// A joint of this number between bodies in these states.
    pub(crate) fn joint_between(&self, number: usize, joint: &Joint, states: &[BodyState]) -> ModelJoint {
        let size = |body: usize| self.bodies[body].size;
        let moving = joint.bodies().filter(|&body| self.bodies[body].moves());
        let held = |body: usize| match &self.bodies[body] {
            own if own.moves() => HeldBody::Movable(states[body].pose),
            own if own.trajectory.is_some() => HeldBody::Kinematic(states[body].pose),
            _ => HeldBody::Fixed,
        };
        ModelJoint::new((number, joint), &self.scene.tracks, held, row_length(moving.map(size)))
    }

    /// Enters the joints at their bodies, and the bodies that constraint rows hold.
    pub(crate) fn index_joints(&mut self) {
        self.joints.of_body.clear();
        for (number, joint) in self.joints.list.iter().enumerate() {
            for body in joint.bodies() {
                self.joints.of_body.entry(body).or_default().push(number);
            }
        }
        self.joints.index_ties();
        let tied: BTreeSet<usize> = self.joints.ties_of_body.values().flatten().copied().collect();
        let carriages = tied.into_iter().filter_map(|tie| self.joints.ties[tie].carriage());
        let drivers: BTreeSet<usize> =
            self.joints.list.iter().filter_map(ModelJoint::driver).chain(carriages).collect();
        self.joints.drivers = drivers.into_iter().collect();
        self.joints.contacts.clear();
        self.joints.contact_partners.clear();
        for joint in &self.joints.list {
            let number = joint.number();
            let stops = (0..joint.stops()).map(|stop| Feature::Stop(StopId { joint: number, stop }));
            let friction = joint.coordinates_with_friction();
            let friction = friction.map(|place| Feature::JointFriction(CoordinateId { joint: number, place }));
            for feature in stops.chain(friction) {
                let (a, b) = joint.pair();
                self.joints.contacts.entry((a, b)).or_default().push(feature);
                self.joints.contact_partners.entry(a).or_default().insert(b);
                self.joints.contact_partners.entry(b).or_default().insert(a);
            }
        }
        self.joints.contacts.values_mut().for_each(|of_pair| of_pair.sort_unstable());
        let is_rough = |feature: &Feature| matches!(feature, Feature::JointFriction(_));
        self.joints.have_friction = self.joints.contacts.values().flatten().any(is_rough);
        let is_held = |body: &usize| self.bodies[*body].held.is_some() || self.joints.of_body.contains_key(body);
        self.joints.held_by_rows = (0..self.bodies.len()).filter(is_held).collect();
    }

    /// Adds a body, which has passed the checks of a scene, at `t` (s). Returns its index and state.
    ///
    /// # Errors
    /// When its shape cannot be expressed in its moving frame; nothing has changed then.
    pub(crate) fn add_body(&mut self, body: Body, t: f64) -> Result<(usize, BodyState), SceneError> {
        let number = self.bodies.len();
        let form = self.pivot_rows.form(&body, || body.shape().is_some());
        let added = ModelBody::new(&body, form, || true)?;
        let state = added.state_at(&body, t);
        if added.trajectory.is_some() {
            self.prescribed.push(number);
        }
        if added.held.is_some() {
            self.joints.held_by_rows.push(number);
        }
        if let Some(rigid) = added.rigid {
            self.movable.push(number);
            self.rigid = self.rigid.iter().copied().chain([rigid]).collect();
        }
        self.bodies.push(added);
        self.scene.bodies.push(body);
        self.find_what_collides();
        self.forces.start_potential_j = self.sum_start_potentials();
        self.make_fields()?;
        Ok((number, state))
    }

    /// Whether any two bodies of the scene may collide, and what their surfaces do.
    pub(crate) fn find_what_collides(&mut self) {
        self.surfaces = Surfaces::of(&self.scene);
    }

    /// Removes a body. Its index is not given to another body.
    ///
    /// # Errors
    /// When the fields of the remaining bodies cannot be made.
    pub(crate) fn remove_body(&mut self, body: usize) -> Result<(), SceneError> {
        self.bodies[body].removed = true;
        self.bodies[body].shape = None;
        self.narrow_phase.forget(body);
        self.bodies[body].trajectory = None;
        self.bodies[body].held = None;
        self.joints.list.retain(|joint| joint.bodies().all(|held| held != body));
        self.joints.released.retain(|_, joint| joint.bodies().all(|held| held != body));
        self.index_joints();
        self.prescribed.retain(|&other| other != body);
        self.scene.bodies[body].geometry = None;
        self.forces.applied.remove(&body);
        self.steered.remove(&body);
        self.forces.start_potential_j = self.sum_start_potentials();
        self.make_fields()
    }

    /// How many bodies samples and reports show: all but carriages at the end.
    pub(crate) fn shown(&self) -> usize {
        let all = self.bodies.len();
        if self.joints.carriages.end == all { self.joints.carriages.start } else { all }
    }

    /// Mass properties of the movable bodies, shared.
    pub(crate) fn shared_rigid(&self) -> Arc<[RigidBody]> {
        Arc::clone(&self.rigid)
    }

    /// States of the movable bodies, by slot.
    pub(crate) fn movable_states(&self, states: &[BodyState]) -> Vec<BodyState> {
        self.movable.iter().map(|&body| states[body]).collect()
    }

    /// Whether the momentum ledger counts the momentum of a body. A fixed or kinematic body has none, and a body
    /// reduced to rotation about its pivot passes its momentum on to the world.
    pub(crate) fn carries_momentum(&self, body: usize) -> bool {
        let body = &self.bodies[body];
        !body.removed && body.rigid.as_ref().is_some_and(|rigid| !rigid.is_pivoted())
    }

    /// Slot of a body: its place among the movable ones.
    pub(crate) fn slot(&self, body: usize) -> Option<usize> {
        self.movable.binary_search(&body).ok()
    }

    /// Confines the motion of bodies to their plane.
    pub(crate) fn confine_to_plane(&mut self, planar: PlanarBodies, states: &mut [BodyState]) {
        self.planar = planar;
        for body in 0..states.len() {
            self.keep_in_plane(body, &mut states[body]);
        }
    }

    /// Removes from the state of a body in planar motion what rounding has put outside its plane.
    pub(crate) fn keep_in_plane(&self, body: usize, state: &mut BodyState) {
        if let Some(plane) = self.planar.of_group(&[body]) {
            plane.project_state(state);
        }
    }

    /// Acceleration of gravity, m/s^2.
    pub(crate) fn gravity(&self) -> DVec3 {
        self.scene.gravity()
    }
}

impl MovingFrames for Model {
    fn movable(&self, body: usize) -> Option<usize> {
        self.slot(body)
    }

    fn is_there(&self, body: usize) -> bool {
        self.bodies.get(body).is_some_and(|body| !body.removed)
    }

    fn removed(&self) -> Vec<usize> {
        (0..self.movable.len()).filter(|&slot| self.bodies[self.movable[slot]].removed).collect()
    }

    fn in_moving_frame(&self, body: usize, point: DVec3) -> DVec3 {
        point - self.bodies[body].origin
    }

    fn in_world(&self, body: usize, point: DVec3) -> DVec3 {
        self.scene.bodies()[body].initial_pose().transform_point(point)
    }
}
