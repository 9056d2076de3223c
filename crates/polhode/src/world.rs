//! The scene as the engine sees it: bodies in their moving frames, and what acts on them.
//!
//! The moving frame C of a body has the axes of the body and its origin at the centre of mass (thesis 3.2: "we can
//! offset all the values so that the origin is forced to coincide with the centre of mass"), or at the pivot of a
//! body of which turning alone is left (`pivots.rs`). Shapes are moved into it once, here; results are moved back when they are sampled.

use crate::Acceleration;
use crate::body_sample::BodySample;
use crate::collision::narrow_phase::NarrowPhase;
use crate::field_index::{FieldBuffers, FieldIndex, acted_on};
use crate::pivot_form::{HeldPoint, PivotForm, PivotRows};
use crate::plane_of_motion::PlaneOfMotion;
use crate::prescribed_state;
use crate::scene::{Body, Geometry, MovingFrames, Scene, SceneError, Trajectory};
use crate::snapshot::SnapshotError;
use polhode_contact::{Shape, ShapeError};
use polhode_dynamics::energy::potential_energy;
use polhode_dynamics::field::{Account, AppliedForce, AppliedTorque, Field, FieldError, Frame, Wrench};
use polhode_dynamics::{BodyState, FreeMotion, RigidBody};
use polhode_mesh::{SolidMesh, convexity};
use polhode_spatial::{CompensatedSum, DVec3, MassProperties, Pose, Velocity};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Distance that counts as touch, relative to the size of the smaller body: contacts this close at an impact are
/// struck together (docs/NOTATION.md, "touch").
pub(crate) const TOUCH_RELATIVE: f64 = 1e-11;

/// Overlap at the start that counts as touch and is moved out, relative to the size of the smaller body.
pub(crate) const INITIAL_OVERLAP_RELATIVE: f64 = 1e-9;

/// Units in the last place of the largest coordinate that rounding of poses may move a surface by.
const ROUNDING_ULPS: f64 = 8.0;

/// Units in the last place of the largest coordinate that penetration is judged with.
const JUDGED_ULPS: f64 = 4.0;

/// A body of the engine.
#[derive(Debug, Clone)]
// In this order: what samples and ledgers read of every body stands together, at the front.
#[repr(C)]
pub(crate) struct WorldBody {
    /// Whether a program has removed the body: its number stays, and nothing else of it.
    pub(crate) removed: bool,
    /// Largest extent of the body, m; zero for a half-space.
    pub(crate) size: f64,
    /// `p_BC`: origin of the moving frame in the body's own, m.
    pub(crate) origin: DVec3,
    /// Its point that rows hold, if any.
    pub(crate) held: Option<HeldPoint>,
    /// Centre of mass at the start, world, m.
    start: DVec3,
    /// Mass properties; none for a body that no force moves.
    pub(crate) rigid: Option<RigidBody>,
    /// Shape in the moving frame.
    pub(crate) shape: Option<Shape>,
    /// Motion of the moving frame of a kinematic body.
    pub(crate) trajectory: Option<Trajectory>,
    pub(crate) name: String,
}

/// All bodies, and the scene they came from.
#[derive(Debug, Clone)]
pub(crate) struct World {
    pub(crate) scene: Scene,
    pub(crate) bodies: Vec<WorldBody>,
    /// Those that forces move, and their mass properties in the same order.
    pub(crate) movable: Vec<usize>,
    /// Kinematic bodies.
    pub(crate) prescribed: Vec<usize>,
    rigid: Arc<[RigidBody]>,
    /// Bodies that rows hold at pivots, ascending.
    pub(crate) held_by_rows: Vec<usize>,
    /// Which bodies they are to hold.
    pub(crate) pivot_rows: PivotRows,
    /// Force fields over the movable bodies.
    fields: Arc<[Box<dyn Field>]>,
    /// Whether a field, or the torque of gravity about a pivot, can act on any body.
    is_loaded_at_all: bool,
    /// Bodies on which a force acts that changes with time, also while they rest; ascending.
    pub(crate) driven: Vec<usize>,
    /// Movable bodies that one field acts on together.
    pub(crate) couplings: Vec<Vec<usize>>,
    field_index: FieldIndex,
    field_buffers: FieldBuffers,
    pub(crate) narrow_phase: NarrowPhase,
    /// Whether any two bodies may collide.
    collides: bool,
    /// Force and torque (N, N m, world) that a program has set on bodies, by number.
    applied: BTreeMap<usize, Wrench>,
    /// Potential energy of the fields at the start, J.
    initial_field_potential: f64,
    /// The plane of a motion that stays in one.
    pub(crate) plane: Option<PlaneOfMotion>,
}

impl World {
    /// The engine's view of a scene, with the states of the bodies at t = 0.
    ///
    /// # Errors
    /// When a shape cannot be moved into its central frame.
    pub(crate) fn new(scene: &Scene, pivot_rows: PivotRows) -> Result<(Self, Vec<BodyState>), SceneError> {
        let may_collide = |a: usize| (0..scene.bodies().len()).any(|b| scene.may_collide(a, b));
        let bodies = scene.bodies().iter().enumerate().map(|(index, body)| {
            let form = pivot_rows.form(body, || may_collide(index));
            WorldBody::new(body, form, || may_collide(index))
        });
        let bodies = bodies.collect::<Result<Vec<_>, _>>()?;
        let held_by_rows = (0..bodies.len()).filter(|&body| bodies[body].held.is_some()).collect();
        let states: Vec<_> =
            scene.bodies().iter().zip(&bodies).map(|(body, world)| world.state_at(body, 0.0)).collect();
        let movable: Vec<usize> = (0..bodies.len()).filter(|&body| bodies[body].moves()).collect();
        let prescribed = (0..bodies.len()).filter(|&body| bodies[body].trajectory.is_some()).collect();
        let rigid = bodies.iter().filter_map(|body| body.rigid).collect();
        let mut world = Self {
            scene: scene.clone(),
            bodies,
            movable,
            prescribed,
            rigid,
            held_by_rows,
            pivot_rows,
            fields: Arc::from(Vec::new()),
            is_loaded_at_all: false,
            driven: Vec::new(),
            couplings: Vec::new(),
            field_index: FieldIndex::default(),
            field_buffers: FieldBuffers::default(),
            narrow_phase: NarrowPhase::default(),
            collides: scene.any_may_collide(),
            applied: BTreeMap::new(),
            initial_field_potential: 0.0,
            plane: None,
        };
        world.make_fields()?;
        world.initial_field_potential = world.field_potential(&states);
        Ok((world, states))
    }

    /// Takes what follows from the frames of the bodies from them anew.
    ///
    /// # Errors
    /// When a force cannot be made into a field.
    pub(crate) fn frames_have_changed(&mut self) -> Result<(), SceneError> {
        self.rigid = self.movable.iter().filter_map(|&body| self.bodies[body].rigid).collect();
        self.make_fields()
    }

    /// Makes the scene's forces into fields over the movable bodies.
    fn make_fields(&mut self) -> Result<(), SceneError> {
        let mut fields: Vec<Box<dyn Field>> = Vec::new();
        self.driven.clear();
        self.couplings.clear();
        for (number, force) in self.scene.forces().iter().enumerate() {
            let made = force.fields(self).map_err(|source| SceneError::Force { force: number, source })?;
            if force.changes_with_time() {
                let slots = made.iter().flat_map(|field| acted_on(&**field, self.movable.len()));
                self.driven.extend(slots.map(|slot| self.movable[slot]));
            }
            fields.extend(made);
        }
        for (&body, wrench) in &self.applied {
            let force = self.scene.forces().len();
            let made = applied_fields(self.slot(body), wrench);
            fields.extend(made.map_err(|source| SceneError::Force { force, source })?);
        }
        self.driven.sort_unstable();
        self.driven.dedup();
        self.field_index = FieldIndex::new(&fields, self.movable.len());
        for field in fields.iter().filter(|field| field.couples()) {
            let together = acted_on(&**field, self.movable.len());
            if together.len() > 1 {
                self.field_index.couple(self.couplings.len(), &together);
                self.couplings.push(together.into_iter().map(|slot| self.movable[slot]).collect());
            }
        }
        self.fields = Arc::from(fields);
        self.is_loaded_at_all = self.free_motion().has_loads();
        Ok(())
    }

    /// Sets the force (N) and torque (N m) that a program holds on a body, world.
    ///
    /// # Errors
    /// When they are not finite; nothing has changed then.
    pub(crate) fn set_applied(&mut self, body: usize, wrench: Wrench) -> Result<(), SceneError> {
        let before = self.applied.clone();
        if wrench == Wrench::default() {
            self.applied.remove(&body);
        } else {
            self.applied.insert(body, wrench);
        }
        let made = self.make_fields();
        if made.is_err() {
            self.applied = before;
            self.make_fields()?;
        }
        made
    }

    /// Force and torque that a program holds on bodies, by number (N, N m), as plain numbers.
    pub(crate) fn applied(&self) -> Vec<(usize, [[f64; 3]; 2])> {
        let numbers = |(&body, wrench): (&usize, &Wrench)| (body, [wrench.force.to_array(), wrench.torque.to_array()]);
        self.applied.iter().map(numbers).collect()
    }

    /// Replaces all of them.
    ///
    /// # Errors
    /// When one is not finite or of a body that there is not.
    pub(crate) fn replace_applied(&mut self, applied: &[(usize, [[f64; 3]; 2])]) -> Result<(), SnapshotError> {
        let refused = SnapshotError::Invalid("a force that a program holds is not one on a body of the scene");
        if applied.iter().any(|&(body, _)| body >= self.bodies.len()) {
            return Err(refused);
        }
        let wrench = |[force, torque]: [[f64; 3]; 2]| Wrench { force: force.into(), torque: torque.into() };
        self.applied = applied.iter().map(|&(body, numbers)| (body, wrench(numbers))).collect();
        self.make_fields().map_err(|_| refused)
    }

    /// Adds a body, which has passed the checks of a scene, at `t` (s); its number and state.
    ///
    /// # Errors
    /// When its shape cannot be moved into its central frame; nothing has changed then.
    pub(crate) fn add_body(&mut self, body: Body, t: f64) -> Result<(usize, BodyState), SceneError> {
        let number = self.bodies.len();
        let form = self.pivot_rows.form(&body, || body.shape().is_some());
        let added = WorldBody::new(&body, form, || true)?;
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
        self.collides = self.scene.any_may_collide();
        self.make_fields()?;
        Ok((number, state))
    }

    /// Removes a body; its number stays that of a removed body.
    ///
    /// # Errors
    /// When the fields that are left cannot be made.
    pub(crate) fn remove_body(&mut self, body: usize) -> Result<(), SceneError> {
        self.bodies[body].removed = true;
        self.bodies[body].shape = None;
        self.narrow_phase.forget(body);
        self.bodies[body].trajectory = None;
        self.bodies[body].held = None;
        self.held_by_rows.retain(|&other| other != body);
        self.prescribed.retain(|&other| other != body);
        self.scene.bodies[body].geometry = None;
        self.applied.remove(&body);
        self.make_fields()
    }

    /// The motion of all movable bodies without contact.
    pub(crate) fn free_motion(&self) -> FreeMotion<'_> {
        FreeMotion::new(&self.rigid, self.gravity(), &self.fields)
    }

    /// Mass properties of the movable bodies, shared.
    pub(crate) fn shared_rigid(&self) -> Arc<[RigidBody]> {
        Arc::clone(&self.rigid)
    }

    /// The force fields, shared.
    pub(crate) fn shared_fields(&self) -> Arc<[Box<dyn Field>]> {
        Arc::clone(&self.fields)
    }

    /// States of the movable bodies, in their order.
    pub(crate) fn movable_states(&self, states: &[BodyState]) -> Vec<BodyState> {
        self.movable.iter().map(|&body| states[body]).collect()
    }

    /// Whether a field, the torque of gravity about a pivot or the rows of one can act on a body.
    pub(crate) fn is_loaded(&self, body: usize) -> bool {
        let swings = FreeMotion::new(&self.rigid, self.gravity(), &[]);
        self.is_held_by_rows(body)
            || self
                .slot(body)
                .is_some_and(|slot| swings.is_loaded(slot) || self.field_index.acts_on(&self.fields, slot))
    }

    /// Whether a force acts on a body but none that could turn it.
    pub(crate) fn is_pushed_only(&self, body: usize) -> bool {
        let motion = self.free_motion();
        !self.is_held_by_rows(body)
            && self.is_loaded(body)
            && self.slot(body).is_some_and(|slot| !motion.is_turned(slot))
    }

    /// How many movable bodies a field or a pivot can act on.
    pub(crate) fn loaded_count(&self) -> usize {
        self.movable.iter().filter(|&&body| self.is_loaded(body)).count()
    }

    /// Whether anything but uniform gravity acts on bodies between contacts.
    pub(crate) fn has_loads(&self) -> bool {
        self.has_rows() || self.free_motion().has_loads()
    }

    /// What fields and gravity about pivots do to all bodies; empty when nothing does.
    pub(crate) fn loads(&self, t: f64, states: &[BodyState]) -> Loads {
        if !self.is_loaded_at_all {
            return Loads::default();
        }
        let motion = self.free_motion();
        let mut wrenches = vec![Wrench::default(); self.movable.len()];
        motion.wrenches(t, &self.movable_states(states), &mut wrenches);
        Loads::Of(self.movable.iter().copied().zip(wrenches).collect())
    }

    /// As [`World::loads`], on these bodies alone. Where all fields name the bodies that they act on, the work is that of the
    /// fields on these bodies, however many others there are.
    pub(crate) fn loads_on(&self, t: f64, states: &[BodyState], bodies: &[usize]) -> Loads {
        let motion = self.free_motion();
        let swing = |slot: usize, wrench: &mut Wrench| {
            motion.add_swing(&self.rigid[slot], &states[self.movable[slot]], wrench);
        };
        self.field_wrenches_on(t, states, bodies, |_| true, swing).unwrap_or_else(|| self.loads(t, states))
    }

    /// Wrenches of the fields of one account on these bodies, torques about the centres of mass.
    pub(crate) fn wrenches_of(&self, account: Account, t: f64, states: &[BodyState], bodies: &[usize]) -> Loads {
        let of_account = |field: &dyn Field| field.account() == account;
        self.field_wrenches_on(t, states, bodies, of_account, |_, _| ()).unwrap_or_else(|| {
            let mut wrenches = vec![Wrench::default(); self.movable.len()];
            self.free_motion().wrenches_of(account, t, &self.movable_states(states), &mut wrenches);
            Loads::Of(self.movable.iter().copied().zip(wrenches).collect())
        })
    }

    /// Wrenches of some of the fields on these bodies, each finished by its place among the movable ones; nothing when a field
    /// does not name its bodies.
    fn field_wrenches_on(
        &self,
        t: f64,
        states: &[BodyState],
        bodies: &[usize],
        chosen: impl Fn(&dyn Field) -> bool,
        finish: impl Fn(usize, &mut Wrench),
    ) -> Option<Loads> {
        let slots: Vec<usize> = bodies.iter().filter_map(|&body| self.slot(body)).collect();
        let (fields, read) = self.field_index.acting_on(&slots)?;
        let (mut buffers, mut none) = (self.field_buffers.0.try_borrow_mut(), Default::default());
        let (own, wrenches) = buffers.as_deref_mut().unwrap_or(&mut none);
        own.resize(self.movable.len(), BodyState::at_rest(Pose::IDENTITY));
        wrenches.resize(self.movable.len(), Wrench::default());
        for slot in read {
            own[slot] = states[self.movable[slot]];
            wrenches[slot] = Wrench::default();
        }
        for field in fields.iter().map(|&number| &*self.fields[number]).filter(|field| chosen(*field)) {
            field.add_wrenches(t, &self.rigid, own, wrenches);
        }
        let load = |slot: usize| {
            let mut wrench = wrenches[slot];
            finish(slot, &mut wrench);
            (self.movable[slot], wrench)
        };
        Some(Loads::Of(slots.into_iter().map(load).collect()))
    }

    /// Whether any two bodies may collide.
    pub(crate) fn may_collide_at_all(&self) -> bool {
        self.collides
    }

    /// Whether a field makes the motion of a body depend on that of others.
    pub(crate) fn is_coupled(&self, body: usize) -> bool {
        self.couplings_of(body).next().is_some()
    }

    /// The couplings that a body is in: all bodies that one field acts on together with it.
    pub(crate) fn couplings_of(&self, body: usize) -> impl Iterator<Item = &Vec<usize>> {
        let numbers = self.slot(body).map_or(&[][..], |slot| self.field_index.couplings_of(slot));
        numbers.iter().map(|&number| &self.couplings[number])
    }

    /// The couplings that any of these bodies is in, each once.
    pub(crate) fn couplings_among(&self, bodies: &[usize]) -> impl Iterator<Item = &Vec<usize>> {
        let slots = bodies.iter().filter_map(|&body| self.slot(body));
        let numbers: BTreeSet<usize> = slots.flat_map(|slot| self.field_index.couplings_of(slot)).copied().collect();
        numbers.into_iter().map(|number| &self.couplings[number])
    }

    /// Whether forces couple bodies of a scene in which some may collide.
    pub(crate) fn any_coupled_may_collide(&self) -> bool {
        self.collides && !self.couplings.is_empty()
    }

    /// Potential energy that a body has at its start, J, of gravity zero at the world's origin.
    pub(crate) fn start_potential(&self, body: usize) -> f64 {
        let body = &self.bodies[body];
        body.rigid.as_ref().map_or(0.0, |rigid| potential_energy(rigid.mass(), self.gravity(), body.start))
    }

    /// Whether forces on a body change with time, also while everything rests.
    pub(crate) fn is_driven(&self, body: usize) -> bool {
        self.driven.binary_search(&body).is_ok()
    }

    /// Whether any force field acts.
    pub(crate) fn has_fields(&self) -> bool {
        !self.fields.is_empty()
    }

    /// Whether any force field's work belongs to this account.
    pub(crate) fn has_fields_of(&self, account: Account) -> bool {
        self.fields.iter().any(|field| field.account() == account)
    }

    /// Potential energy of the conservative fields, J.
    fn field_potential(&self, states: &[BodyState]) -> f64 {
        if self.fields.is_empty() {
            return 0.0;
        }
        let states = self.movable_states(states);
        self.fields.iter().map(|field| field.potential_energy(&self.rigid, &states)).sum()
    }

    /// The same against that at the start, J.
    pub(crate) fn field_energy(&self, states: &[BodyState]) -> f64 {
        self.field_potential(states) - self.initial_field_potential
    }

    /// What gravity adds to the rate of a body's velocity, m/s^2: nothing for one that is held at a pivot.
    pub(crate) fn free_acceleration(&self, body: usize) -> DVec3 {
        let held = self.bodies[body].rigid.as_ref().is_some_and(RigidBody::is_pivoted);
        if held { DVec3::ZERO } else { self.gravity() }
    }

    /// Whether a body's momentum is its own: a fixed or pivoted one passes it on to the world.
    pub(crate) fn carries_momentum(&self, body: usize) -> bool {
        let body = &self.bodies[body];
        !body.removed && body.rigid.as_ref().is_some_and(|rigid| !rigid.is_pivoted())
    }

    /// Place of a body among those that move.
    pub(crate) fn slot(&self, body: usize) -> Option<usize> {
        self.movable.binary_search(&body).ok()
    }

    /// Confines the motion to a plane, if there is one.
    pub(crate) fn enter_plane(&mut self, plane: Option<PlaneOfMotion>, states: &mut [BodyState]) {
        self.plane = plane;
        for body in 0..states.len() {
            self.keep_in_plane(body, &mut states[body]);
        }
    }

    /// Takes from the state of a movable body what rounding has left outside the plane of a planar motion.
    pub(crate) fn keep_in_plane(&self, body: usize, state: &mut BodyState) {
        if let Some(plane) = self.plane.filter(|_| self.bodies[body].moves()) {
            plane.project_state(state);
        }
    }

    /// Acceleration of gravity, m/s^2.
    pub(crate) fn gravity(&self) -> DVec3 {
        self.scene.gravity()
    }

    /// Size that tolerances of a pair are relative to, m: that of the smaller of the two that has one.
    pub(crate) fn pair_size(&self, a: usize, b: usize) -> f64 {
        let (size_a, size_b) = (self.bodies[a].size, self.bodies[b].size);
        if size_a == 0.0 {
            size_b
        } else if size_b == 0.0 {
            size_a
        } else {
            size_a.min(size_b)
        }
    }

    /// Distance within which two bodies touch, m.
    pub(crate) fn touch_distance(&self, states: &[BodyState], a: usize, b: usize) -> f64 {
        TOUCH_RELATIVE * self.pair_size(a, b) + self.rounding(states, a, b)
    }

    /// What the rounding of two poses may move surfaces by, m.
    pub(crate) fn rounding(&self, states: &[BodyState], a: usize, b: usize) -> f64 {
        ROUNDING_ULPS * self.ulp(states, a, b)
    }

    /// What rounding adds to the penetration that a pair is allowed, m.
    pub(crate) fn judged_rounding(&self, states: &[BodyState], a: usize, b: usize) -> f64 {
        JUDGED_ULPS * self.ulp(states, a, b)
    }

    /// Unit in the last place of the largest coordinate of two bodies, m.
    fn ulp(&self, states: &[BodyState], a: usize, b: usize) -> f64 {
        let coordinate = |i: usize| {
            let body = &self.bodies[i];
            // A fixed half-space far away moves nothing: only its plane matters, through the other body.
            if body.size == 0.0 { 0.0 } else { states[i].pose.translation.abs().max_element() + body.size }
        };
        f64::EPSILON * coordinate(a).max(coordinate(b))
    }

    /// A body's pose and velocity as they are reported: the velocity of the centre of mass, of a kinematic body that of
    /// its own origin.
    pub(crate) fn sample(&self, index: usize, state: &BodyState) -> BodySample {
        let body = &self.bodies[index];
        let velocity = match (&body.rigid, &body.trajectory) {
            (Some(rigid), _) => rigid.center_of_mass_velocity(state),
            (None, Some(_)) => prescribed_state::velocity_of(state),
            (None, None) => Velocity::ZERO,
        };
        BodySample { pose: state.pose * Pose::from_translation(-body.origin), velocity }
    }

    /// The same of a body with these mass properties, which are its own.
    pub(crate) fn sample_of(&self, index: usize, rigid: &RigidBody, state: &BodyState) -> BodySample {
        let pose = state.pose * Pose::from_translation(-self.bodies[index].origin);
        BodySample { pose, velocity: rigid.center_of_mass_velocity(state) }
    }

    /// A body's acceleration as it is reported: of the centre of mass, from that of the origin of its moving frame.
    pub(crate) fn reported_acceleration(
        &self,
        body: usize,
        state: &BodyState,
        linear: DVec3,
        angular: DVec3,
    ) -> Acceleration {
        let Some(rigid) = &self.bodies[body].rigid else { return Acceleration { linear, angular } };
        let arm = state.pose.rotation.rotate(rigid.arm());
        let w = rigid.angular_velocity(state);
        Acceleration { linear: linear + angular.cross(arm) + w.cross(w.cross(arm)), angular }
    }

    /// The pose of a body's moving frame from that of its own origin.
    pub(crate) fn moving_pose(&self, body: usize, pose: Pose) -> Pose {
        pose * Pose::from_translation(self.bodies[body].origin)
    }

    /// Names of all bodies and their states as they are reported.
    pub(crate) fn named_samples(&self, states: &[BodyState]) -> Vec<(String, BodySample)> {
        let named = self.bodies.iter().zip(states).enumerate();
        named.map(|(index, (body, state))| (body.name.clone(), self.sample(index, state))).collect()
    }

    /// Kinetic energy of one body, and its potential energy against that at the start, J: far from the origin the
    /// potential itself would drown in its rounding.
    pub(crate) fn energies(&self, index: usize, state: &BodyState) -> (f64, f64) {
        let body = &self.bodies[index];
        body.rigid.as_ref().filter(|_| !body.removed).map_or((0.0, 0.0), |rigid| {
            let risen = rigid.center_of_mass_position(state) - body.start;
            (rigid.kinetic_energy(state), potential_energy(rigid.mass(), self.gravity(), risen))
        })
    }

    /// Centre of mass of the movable bodies at the start, m; the origin when there are none.
    pub(crate) fn initial_center_of_mass(&self) -> DVec3 {
        let (mut mass, mut moment) = (0.0, DVec3::ZERO);
        for (rigid, start) in self.bodies.iter().filter_map(|body| Some((body.rigid.as_ref()?, body.start))) {
            mass += rigid.mass();
            moment += start * rigid.mass();
        }
        if mass > 0.0 { moment / mass } else { DVec3::ZERO }
    }

    /// Potential energy of the scene at the start, J, of gravity zero at the world's origin.
    pub(crate) fn initial_potential(&self) -> f64 {
        let bodies = self.bodies.iter();
        let potentials =
            bodies.filter_map(|body| Some(potential_energy(body.rigid.as_ref()?.mass(), self.gravity(), body.start)));
        potentials.collect::<CompensatedSum>().value() + self.initial_field_potential
    }
}

/// The fields of a force and a torque (world) on the movable body of this place; none for one that never moves.
fn applied_fields(slot: Option<usize>, wrench: &Wrench) -> Result<Vec<Box<dyn Field>>, FieldError> {
    let Some(slot) = slot else { return Ok(Vec::new()) };
    let force = AppliedForce::new(slot, wrench.force, Frame::World)?;
    let torque = AppliedTorque::new(slot, wrench.torque, Frame::World)?;
    let mut fields: Vec<Box<dyn Field>> = Vec::new();
    if wrench.force != DVec3::ZERO {
        fields.push(Box::new(force));
    }
    if wrench.torque != DVec3::ZERO {
        fields.push(Box::new(torque));
    }
    Ok(fields)
}

/// What fields do to all bodies at one instant; torques about the origins of the moving frames.
#[derive(Debug, Clone, Default)]
pub(crate) enum Loads {
    /// Nothing.
    #[default]
    None,
    /// Of bodies, ascending; nothing on others.
    Of(Vec<(usize, Wrench)>),
}

impl Loads {
    /// On one body.
    pub(crate) fn of(&self, body: usize) -> Wrench {
        match self {
            Self::None => Wrench::default(),
            Self::Of(loads) => {
                let place = loads.binary_search_by_key(&body, |(loaded, _)| *loaded);
                place.map_or_else(|_| Wrench::default(), |place| loads[place].1)
            }
        }
    }
}

impl MovingFrames for World {
    fn movable(&self, body: usize) -> Option<usize> {
        self.slot(body)
    }

    fn in_moving_frame(&self, body: usize, point: DVec3) -> DVec3 {
        point - self.bodies[body].origin
    }

    fn in_world(&self, body: usize, point: DVec3) -> DVec3 {
        self.scene.bodies()[body].initial_pose().transform_point(point)
    }
}

impl WorldBody {
    fn new(body: &Body, form: PivotForm, may_collide: impl Fn() -> bool) -> Result<Self, SceneError> {
        let refused = |source| SceneError::Shape { body: body.name().to_owned(), source };
        let center_of_mass = body.mass_properties().map_or(DVec3::ZERO, MassProperties::center_of_mass);
        let held = HeldPoint::of(body).filter(|_| form == PivotForm::Rows);
        let pivot = body.pivot_point().filter(|_| form == PivotForm::Turning);
        let pivot = pivot.map(|point| body.initial_pose().inverse_transform_point(point));
        let origin = pivot.unwrap_or(center_of_mass);
        let shape = match body.shape() {
            Some(Geometry::Shape(shape)) => Some(shape.translated(-origin).map_err(refused)?),
            Some(Geometry::Mesh(mesh)) if may_collide() => {
                Some(colliding(mesh, body.is_fixed()).and_then(|shape| shape.translated(-origin)).map_err(refused)?)
            }
            Some(Geometry::Mesh(_)) | None => None,
        };
        Ok(Self {
            name: body.name().to_owned(),
            rigid: body.mass_properties().map(|properties| match pivot {
                Some(pivot) => RigidBody::pivoted(properties, pivot),
                None => RigidBody::new(properties),
            }),
            start: (*body.initial_pose()).transform_point(center_of_mass),
            trajectory: body.trajectory(),
            size: size_of(body, shape.as_ref()),
            shape,
            origin,
            held,
            removed: false,
        })
    }

    /// State of a body that begins to move at `t` (s); a prescribed motion is one of the time of the run.
    fn state_at(&self, body: &Body, t: f64) -> BodyState {
        let pose = *body.initial_pose() * Pose::from_translation(self.origin);
        match (&self.rigid, &self.trajectory) {
            (Some(rigid), _) => {
                let given = *body.initial_velocity();
                rigid.at_velocity(pose, self.held.map_or(given, |held| held.turning(&pose, given.angular)))
            }
            (None, Some(trajectory)) => prescribed_state::state_at(trajectory, t),
            (None, None) => BodyState::at_rest(pose),
        }
    }

    /// Whether forces can move the body.
    pub(crate) fn moves(&self) -> bool {
        self.rigid.is_some() && !self.removed
    }
}

/// What collides of a solid mesh: its convex parts, or, when no force moves it, its surface.
fn colliding(mesh: &SolidMesh, is_fixed: bool) -> Result<Shape, ShapeError> {
    if !is_fixed || convexity(mesh).is_convex() {
        return Shape::solid(mesh);
    }
    let mesh = mesh.mesh();
    Shape::triangle_mesh(mesh.vertices().to_vec(), mesh.triangles().to_vec())
}

/// Size of a body, m: of its shape, or, for a point and for a body without a shape, twice its radius of gyration.
fn size_of(body: &Body, shape: Option<&Shape>) -> f64 {
    let size = shape.map_or(0.0, Shape::size);
    match body.mass_properties() {
        Some(properties) if size == 0.0 => 2.0 * (properties.principal_axes().moments().z / properties.mass()).sqrt(),
        _ => size,
    }
}
