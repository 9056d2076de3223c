//! The model that the engine computes with: all bodies of a scene, in their moving frames.
//!
//! The moving frame C of a body has the axes of the body. Its origin is the centre of mass (thesis 3.2: "we can offset
//! all the values so that the origin is forced to coincide with the centre of mass"), or the pivot of a body whose
//! motion is reduced to rotation about it (`pivots.rs`). Shapes are transformed into the moving frame once, here;
//! `reported.rs` transforms results back.

use super::body::ModelBody;
use super::carriages::add_carriages;
use super::field_index::{FieldBuffers, FieldIndex};
use super::steered::Steered;
use crate::collision::envelope::CollisionEnvelope;
use crate::collision::narrow_phase::NarrowPhase;
use crate::constraint::joint::{AddedJoint, HeldBody, ModelJoint, row_length};
use crate::constraint::joint_forces::JointForce;
use crate::constraint::tie::Tie;
use crate::identity::contact_id::Feature;
use crate::identity::coordinate_id::CoordinateId;
use crate::identity::stop_id::StopId;
use crate::model::pivot_form::{PivotForm, PivotRows};
use crate::model::plane_of_motion::PlaneOfMotion;
use crate::scene::{Body, Coordinate, Joint, Motor, MovingFrames, Scene, SceneError};
use polhode_dynamics::field::{Field, Wrench};
use polhode_dynamics::{BodyState, RigidBody};
use polhode_spatial::DVec3;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;

/// The friction that any two bodies which may collide have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum FrictionKinds {
    /// None.
    None,
    /// Friction of slip.
    OfSlip,
    /// Friction of rolling or spinning too.
    OfRotation,
}

impl FrictionKinds {
    fn of(scene: &Scene) -> Self {
        let colliding = scene.colliding();
        match colliding.have_friction() {
            false => Self::None,
            true if colliding.largest_rotational_friction > 0.0 => Self::OfRotation,
            true => Self::OfSlip,
        }
    }
}

/// What surfaces do besides friction that is the same in all directions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct SurfaceEffects {
    /// Friction of two bodies that may collide depends on the direction.
    have_grain: bool,
    /// The surface of a body moves.
    are_driven: bool,
}

impl SurfaceEffects {
    fn of(scene: &Scene) -> Self {
        Self { have_grain: scene.has_grain(), are_driven: scene.has_moving_surfaces() }
    }
}

/// All bodies of a scene, the scene, and what acts on the bodies.
#[derive(Debug, Clone)]
pub(crate) struct Model {
    pub(crate) scene: Scene,
    pub(crate) bodies: Vec<ModelBody>,
    /// Indices of the bodies that forces move, ascending; a *slot* is a place in this list.
    pub(crate) movable: Vec<usize>,
    /// Indices of the kinematic bodies, ascending.
    pub(crate) prescribed: Vec<usize>,
    /// Mass properties of the movable bodies, by slot.
    pub(super) rigid: Arc<[RigidBody]>,
    /// Bodies that constraint rows hold at their pivots or joints, ascending.
    pub(crate) held_by_rows: Vec<usize>,
    /// The joints.
    pub(crate) joints: Vec<ModelJoint>,
    /// Which of them hold a movable body.
    pub(crate) joints_of: BTreeMap<usize, Vec<usize>>,
    /// The kinematic bodies that joints and ties hold, ascending.
    pub(crate) joint_drivers: Vec<usize>,
    /// Joints that hold nothing any more, by their numbers: they have broken, or their bodies have run off the ends of
    /// their tracks.
    pub(crate) released: BTreeMap<usize, ModelJoint>,
    /// The poses of bodies at which a program has added joints, by their numbers.
    pub(crate) added_joints: Vec<AddedJoint>,
    /// The joints of the scene that may break.
    pub(crate) breakable: BTreeSet<usize>,
    /// Gears and prescribed motions of joints.
    pub(crate) ties: Vec<Tie>,
    /// Which of them hold a movable body.
    pub(crate) ties_of: BTreeMap<usize, Vec<usize>>,
    /// The bodies that carry prescribed motions of joints.
    pub(crate) carriages: Range<usize>,
    /// The contacts at joints, by their pairs of bodies, ascending.
    pub(crate) joint_contacts: BTreeMap<(usize, usize), Vec<Feature>>,
    /// The bodies that a body has such contacts with, itself for those with the world.
    pub(crate) joint_contact_partners: BTreeMap<usize, BTreeSet<usize>>,
    /// For which pivoted bodies there are such rows.
    pub(crate) pivot_rows: PivotRows,
    /// Force fields over the movable bodies.
    pub(super) fields: Arc<[Box<dyn Field>]>,
    /// Those of them that act at joints, which follow each other from this number on.
    pub(crate) joint_forces: Vec<JointForce>,
    pub(crate) first_joint_force: usize,
    /// Whether a field, or the torque of gravity about a pivot, can act on any body.
    pub(super) is_loaded_at_all: bool,
    /// Bodies with a force that changes with time even while they rest, ascending.
    pub(crate) driven: Vec<usize>,
    /// For each field that couples bodies (a spring, mutual gravity): the bodies that it couples.
    pub(crate) couplings: Vec<Vec<usize>>,
    pub(super) field_index: FieldIndex,
    pub(super) field_buffers: FieldBuffers,
    /// The envelope of micro-collisions, of a tier that has them.
    pub(crate) envelope: Option<CollisionEnvelope>,
    pub(crate) narrow_phase: NarrowPhase,
    /// Whether any two bodies may collide.
    pub(super) collides: bool,
    /// The friction of bodies that may collide.
    pub(super) friction: FrictionKinds,
    /// Whether any joint has friction.
    joints_have_friction: bool,
    /// What else their surfaces do.
    pub(super) surfaces: SurfaceEffects,
    /// Force and torque (N, N m, world) that a program applies, by body.
    pub(super) applied: BTreeMap<usize, Wrench>,
    /// The motors that a program has given coordinates of joints; none where it has taken one away.
    pub(crate) motors: BTreeMap<(usize, Coordinate), Option<Motor>>,
    /// How many joints are on tracks that let go at their ends.
    pub(crate) ending_tracks: usize,
    /// The motions that a program has given kinematic bodies.
    pub(super) steered: BTreeMap<usize, Steered>,
    /// Potential energy of the fields at the start, J.
    pub(super) initial_field_potential: f64,
    /// [`Model::sum_start_potentials`], J.
    pub(super) start_potential_j: f64,
    /// The plane of the motion, when the motion is planar.
    pub(crate) plane: Option<PlaneOfMotion>,
    /// Elastic energy of the springs at contacts at present, J: of the tier `penalty`, which keeps it here for whoever
    /// sums energies.
    pub(crate) contact_energy_j: f64,
}

impl Model {
    /// Whether any two bodies that may collide have friction, or any joint.
    pub(crate) fn has_friction(&self) -> bool {
        self.friction != FrictionKinds::None || self.joints_have_friction
    }

    /// Whether any joint has friction.
    pub(crate) fn joints_have_friction(&self) -> bool {
        self.joints_have_friction
    }

    /// Whether friction of any two depends on the direction.
    pub(crate) fn has_grain(&self) -> bool {
        self.surfaces.have_grain
    }

    /// Whether the surface of any body moves.
    pub(crate) fn has_moving_surfaces(&self) -> bool {
        self.surfaces.are_driven
    }

    /// Whether any two have friction of rolling or spinning.
    pub(crate) fn has_rotational_friction(&self) -> bool {
        self.friction == FrictionKinds::OfRotation
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
        let mut model = Self {
            scene: of_model,
            bodies,
            movable,
            prescribed,
            rigid,
            held_by_rows: Vec::new(),
            joints: Vec::new(),
            joints_of: BTreeMap::new(),
            joint_drivers: Vec::new(),
            released: BTreeMap::new(),
            added_joints: Vec::new(),
            breakable: (0..scene.joints().len()).filter(|&joint| scene.joints()[joint].strength().is_some()).collect(),
            ties: Vec::new(),
            ties_of: BTreeMap::new(),
            carriages,
            joint_contacts: BTreeMap::new(),
            joint_contact_partners: BTreeMap::new(),
            pivot_rows,
            fields: Arc::from(Vec::new()),
            joint_forces: Vec::new(),
            first_joint_force: 0,
            is_loaded_at_all: false,
            driven: Vec::new(),
            couplings: Vec::new(),
            field_index: FieldIndex::default(),
            field_buffers: FieldBuffers::default(),
            envelope: None,
            narrow_phase: NarrowPhase::default(),
            collides: scene.any_may_collide(),
            friction: FrictionKinds::of(scene),
            joints_have_friction: false,
            surfaces: SurfaceEffects::of(scene),
            applied: BTreeMap::new(),
            steered: BTreeMap::new(),
            motors: BTreeMap::new(),
            ending_tracks: 0,
            initial_field_potential: 0.0,
            start_potential_j: 0.0,
            plane: None,
            contact_energy_j: 0.0,
        };
        model.make_joints(&states);
        model.make_ties(&states);
        model.index_joints();
        model.make_fields()?;
        model.initial_field_potential = model.field_potential(&states);
        model.start_potential_j = model.sum_start_potentials();
        Ok((model, states))
    }

    /// Makes the joints of the scene, between bodies in their states at the start.
    fn make_joints(&mut self, states: &[BodyState]) {
        let joints = self.scene.joints().iter().enumerate();
        self.joints = joints.map(|(number, joint)| self.joint_between(number, joint, states)).collect();
        self.ending_tracks = self.joints.iter().filter(|joint| joint.lets_go_at_ends()).count();
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
        self.joints_of.clear();
        for (number, joint) in self.joints.iter().enumerate() {
            for body in joint.bodies() {
                self.joints_of.entry(body).or_default().push(number);
            }
        }
        self.index_ties();
        let tied: BTreeSet<usize> = self.ties_of.values().flatten().copied().collect();
        let carriages = tied.into_iter().filter_map(|tie| self.ties[tie].carriage());
        let drivers: BTreeSet<usize> = self.joints.iter().filter_map(ModelJoint::driver).chain(carriages).collect();
        self.joint_drivers = drivers.into_iter().collect();
        self.joint_contacts.clear();
        self.joint_contact_partners.clear();
        for joint in &self.joints {
            let number = joint.number();
            let stops = (0..joint.stops()).map(|stop| Feature::Stop(StopId { joint: number, stop }));
            let friction = joint.coordinates_with_friction();
            let friction = friction.map(|place| Feature::JointFriction(CoordinateId { joint: number, place }));
            for feature in stops.chain(friction) {
                let (a, b) = joint.pair();
                self.joint_contacts.entry((a, b)).or_default().push(feature);
                self.joint_contact_partners.entry(a).or_default().insert(b);
                self.joint_contact_partners.entry(b).or_default().insert(a);
            }
        }
        self.joint_contacts.values_mut().for_each(|of_pair| of_pair.sort_unstable());
        let is_rough = |feature: &Feature| matches!(feature, Feature::JointFriction(_));
        self.joints_have_friction = self.joint_contacts.values().flatten().any(is_rough);
        let is_held = |body: &usize| self.bodies[*body].held.is_some() || self.joints_of.contains_key(body);
        self.held_by_rows = (0..self.bodies.len()).filter(is_held).collect();
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
            self.held_by_rows.push(number);
        }
        if let Some(rigid) = added.rigid {
            self.movable.push(number);
            self.rigid = self.rigid.iter().copied().chain([rigid]).collect();
        }
        self.bodies.push(added);
        self.scene.bodies.push(body);
        self.find_what_collides();
        self.start_potential_j = self.sum_start_potentials();
        self.make_fields()?;
        Ok((number, state))
    }

    /// Whether any two bodies of the scene may collide, and what their surfaces do.
    pub(crate) fn find_what_collides(&mut self) {
        self.collides = self.scene.any_may_collide();
        self.friction = FrictionKinds::of(&self.scene);
        self.surfaces = SurfaceEffects::of(&self.scene);
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
        self.joints.retain(|joint| joint.bodies().all(|held| held != body));
        self.released.retain(|_, joint| joint.bodies().all(|held| held != body));
        self.index_joints();
        self.prescribed.retain(|&other| other != body);
        self.scene.bodies[body].geometry = None;
        self.applied.remove(&body);
        self.steered.remove(&body);
        self.start_potential_j = self.sum_start_potentials();
        self.make_fields()
    }

    /// How many bodies samples and reports show: all but carriages at the end.
    pub(crate) fn shown(&self) -> usize {
        let all = self.bodies.len();
        if self.carriages.end == all { self.carriages.start } else { all }
    }

    /// Mass properties of the movable bodies, shared.
    pub(crate) fn shared_rigid(&self) -> Arc<[RigidBody]> {
        Arc::clone(&self.rigid)
    }

    /// States of the movable bodies, by slot.
    pub(crate) fn movable_states(&self, states: &[BodyState]) -> Vec<BodyState> {
        self.movable.iter().map(|&body| states[body]).collect()
    }

    /// Whether any two bodies may collide.
    pub(crate) fn may_collide_at_all(&self) -> bool {
        self.collides
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

    /// Confines the motion to a plane, if one is given.
    pub(crate) fn confine_to_plane(&mut self, plane: Option<PlaneOfMotion>, states: &mut [BodyState]) {
        self.plane = plane;
        for body in 0..states.len() {
            self.keep_in_plane(body, &mut states[body]);
        }
    }

    /// Removes from the state of a movable body what rounding has put outside the plane of a planar motion.
    pub(crate) fn keep_in_plane(&self, body: usize, state: &mut BodyState) {
        if let Some(plane) = self.plane.filter(|_| self.bodies[body].moves()) {
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
