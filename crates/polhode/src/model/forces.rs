//! Forces on the bodies besides contact: the fields of the scene, and what a program applies.
//!
//! Fields act on the movable bodies in their order. A *slot* is the place of a body in that order
//! ([`Model::slot`]).

use super::bodies::Model;
use super::field_index::{FieldIndex, acted_on};
use crate::constraint::joint_forces::JointForce;
use crate::constraint::tie::Tie;
use crate::constraint::track_springs::TrackSpring;
use crate::scene::SceneError;
use crate::snapshot::SnapshotError;
use polhode_dynamics::field::{
    Account, AppliedForce, AppliedTorque, Dependence, Field, FieldError, ForceResponse, Frame, Wrench,
};
use polhode_dynamics::{BodyState, FreeMotion, RigidBody};
use polhode_spatial::{DVec3, Pose};
use std::collections::BTreeSet;
use std::sync::Arc;

impl Model {
    /// Makes fields over the movable bodies from the forces of the scene and those that a program applies.
    ///
    /// # Errors
    /// When a number of a force is out of range.
    pub(crate) fn make_fields(&mut self) -> Result<(), SceneError> {
        let mut fields: Vec<Box<dyn Field>> = Vec::new();
        self.forces.driven.clear();
        self.forces.couplings.clear();
        for (number, force) in self.scene.forces().iter().enumerate() {
            let made = force.fields(self).map_err(|source| SceneError::Force { force: number, source })?;
            if force.changes_with_time() {
                let slots = made.iter().flat_map(|field| acted_on(&**field, self.movable.len()));
                self.forces.driven.extend(slots.map(|slot| self.movable[slot]));
            }
            fields.extend(made);
        }
        let at_joints = self.joints.list.iter().flat_map(|joint| JointForce::of(joint, |body| self.slot(body)));
        let at_joints: Vec<JointForce> = at_joints.collect();
        let springs = self.joints.list.iter().flat_map(|joint| TrackSpring::of(joint, |body| self.slot(body)));
        let springs: Vec<TrackSpring> = springs.collect();
        self.forces.first_of_joints = fields.len();
        fields.extend(at_joints.iter().map(|force| Box::new(force.clone()) as Box<dyn Field>));
        self.forces.of_joints = at_joints;
        fields.extend(springs.into_iter().map(|spring| Box::new(spring) as Box<dyn Field>));
        for (&body, wrench) in &self.forces.applied {
            let force = self.scene.forces().len();
            let made = applied_fields(self.slot(body), wrench);
            fields.extend(made.map_err(|source| SceneError::Force { force, source })?);
        }
        self.forces.driven.sort_unstable();
        self.forces.driven.dedup();
        self.forces.index = FieldIndex::new(&fields, self.movable.len());
        for field in fields.iter().filter(|field| field.couples()) {
            let together = acted_on(&**field, self.movable.len());
            if together.len() > 1 {
                self.forces.index.couple(self.forces.couplings.len(), &together);
                self.forces.couplings.push(together.into_iter().map(|slot| self.movable[slot]).collect());
            }
        }
        let of_joints = self.joints.list.iter().map(|joint| joint.bodies().collect::<Vec<usize>>());
        let together: Vec<Vec<usize>> = of_joints.chain(self.joints.ties_at_work().map(Tie::bodies)).collect();
        for together in together {
            let slots: Vec<usize> = together.iter().filter_map(|&body| self.slot(body)).collect();
            if slots.len() > 1 {
                self.forces.index.couple(self.forces.couplings.len(), &slots);
                self.forces.couplings.push(together);
            }
        }
        self.forces.fields = Arc::from(fields);
        self.forces.load_any = self.free_motion().has_loads();
        Ok(())
    }

    /// Sets the force (N) and torque (N m) that a program applies to a body, world, until it sets them again.
    ///
    /// # Errors
    /// When they are not finite; nothing has changed then.
    pub(crate) fn set_applied(&mut self, body: usize, wrench: Wrench) -> Result<(), SceneError> {
        let before = self.forces.applied.clone();
        if wrench == Wrench::default() {
            self.forces.applied.remove(&body);
        } else {
            self.forces.applied.insert(body, wrench);
        }
        let made = self.make_fields();
        if made.is_err() {
            self.forces.applied = before;
            self.make_fields()?;
        }
        made
    }

    /// Replaces all forces and torques that a program applies.
    ///
    /// # Errors
    /// When one is not finite or its body does not exist.
    pub(crate) fn replace_applied(&mut self, applied: &[(usize, [[f64; 3]; 2])]) -> Result<(), SnapshotError> {
        let refused =
            SnapshotError::Invalid("a force applied by the program is not finite, or its body does not exist");
        if applied.iter().any(|&(body, _)| body >= self.bodies.len()) {
            return Err(refused);
        }
        let wrench = |[force, torque]: [[f64; 3]; 2]| Wrench { force: force.into(), torque: torque.into() };
        self.forces.applied = applied.iter().map(|&(body, numbers)| (body, wrench(numbers))).collect();
        self.make_fields().map_err(|_| refused)
    }

    /// The motion of all movable bodies without contact.
    pub(crate) fn free_motion(&self) -> FreeMotion<'_> {
        FreeMotion::new(&self.rigid, self.gravity(), &self.forces.fields)
    }

    /// Whether anything but uniform gravity on its centre of mass can act on a body between contacts: a field, gravity
    /// about a pivot, or the constraint rows of a pivot.
    pub(crate) fn is_loaded(&self, body: usize) -> bool {
        let swings = FreeMotion::new(&self.rigid, self.gravity(), &[]);
        self.joints.is_held_by_rows(body)
            || self
                .slot(body)
                .is_some_and(|slot| swings.is_loaded(slot) || self.forces.index.acts_on(&self.forces.fields, slot))
    }

    /// Whether fields act on a body, but none exerts a torque.
    pub(crate) fn is_loaded_without_torque(&self, body: usize) -> bool {
        let motion = self.free_motion();
        !self.joints.is_held_by_rows(body)
            && self.is_loaded(body)
            && self.slot(body).is_some_and(|slot| !motion.is_turned(slot))
    }

    /// Number of the movable bodies of which [`Model::is_loaded`] is true.
    pub(crate) fn loaded_count(&self) -> usize {
        self.movable.iter().filter(|&&body| self.is_loaded(body)).count()
    }

    /// Whether force fields act on a body.
    pub(crate) fn has_fields_on(&self, body: usize) -> bool {
        self.slot(body).is_some_and(|slot| self.forces.index.acts_on(&self.forces.fields, slot))
    }

    /// Whether anything but uniform gravity acts on bodies between contacts.
    pub(crate) fn has_loads(&self) -> bool {
        self.joints.has_rows() || self.free_motion().has_loads()
    }

    /// Wrenches of the fields and of gravity about pivots on all bodies.
    pub(crate) fn loads(&self, t: f64, states: &[BodyState]) -> Loads {
        if !self.forces.load_any {
            return Loads::default();
        }
        let motion = self.free_motion();
        let mut wrenches = vec![Wrench::default(); self.movable.len()];
        motion.wrenches(t, &self.movable_states(states), &mut wrenches);
        Loads::Of(self.movable.iter().copied().zip(wrenches).collect())
    }

    /// As [`Model::loads`], for these bodies alone. If every field names the bodies that it acts on, only the fields
    /// that act on these bodies are evaluated.
    pub(crate) fn loads_on(&self, t: f64, states: &[BodyState], bodies: &[usize]) -> Loads {
        let motion = self.free_motion();
        let swing = |slot: usize, wrench: &mut Wrench| {
            motion.add_swing(&self.rigid[slot], &states[self.movable[slot]], wrench);
        };
        self.field_wrenches_on(t, states, bodies, |_, _| true, swing).unwrap_or_else(|| self.loads(t, states))
    }

    /// [`Self::loads_on`] without the forces at joints that are soft rows of a step; `kicks` are those that are not.
    pub(crate) fn kick_loads_on(&self, t: f64, states: &[BodyState], bodies: &[usize], kicks: &[usize]) -> Loads {
        let motion = self.free_motion();
        let swing = |slot: usize, wrench: &mut Wrench| {
            motion.add_swing(&self.rigid[slot], &states[self.movable[slot]], wrench);
        };
        let is_kick = |number: usize, _: &dyn Field| self.forces.is_kick(number, kicks);
        self.field_wrenches_on(t, states, bodies, is_kick, swing).unwrap_or_else(|| self.loads(t, states))
    }

    /// [`Self::wrenches_of`] as [`Self::kick_loads_on`].
    pub(crate) fn kick_wrenches_of(
        &self,
        account: Account,
        t: f64,
        states: &[BodyState],
        (bodies, kicks): (&[usize], &[usize]),
    ) -> Loads {
        let chosen =
            |number: usize, field: &dyn Field| field.account() == account && self.forces.is_kick(number, kicks);
        let found = self.field_wrenches_on(t, states, bodies, chosen, |_, _| ());
        found.unwrap_or_else(|| self.wrenches_of(account, t, states, bodies))
    }

    /// Wrenches of the fields of one account on these bodies, torques about the centres of mass.
    pub(crate) fn wrenches_of(&self, account: Account, t: f64, states: &[BodyState], bodies: &[usize]) -> Loads {
        let of_account = |_: usize, field: &dyn Field| field.account() == account;
        self.field_wrenches_on(t, states, bodies, of_account, |_, _| ()).unwrap_or_else(|| {
            let mut wrenches = vec![Wrench::default(); self.movable.len()];
            self.free_motion().wrenches_of(account, t, &self.movable_states(states), &mut wrenches);
            Loads::Of(self.movable.iter().copied().zip(wrenches).collect())
        })
    }

    /// Wrenches of the `chosen` fields on these bodies, each completed by `finish` with its slot; nothing when a field
    /// does not name its bodies.
    fn field_wrenches_on(
        &self,
        t: f64,
        states: &[BodyState],
        bodies: &[usize],
        chosen: impl Fn(usize, &dyn Field) -> bool,
        finish: impl Fn(usize, &mut Wrench),
    ) -> Option<Loads> {
        let slots: Vec<usize> = bodies.iter().filter_map(|&body| self.slot(body)).collect();
        let (fields, read) = self.forces.index.acting_on(&slots)?;
        let (mut buffers, mut none) = (self.forces.buffers.0.try_lock(), Default::default());
        let (own, wrenches) = buffers.as_deref_mut().unwrap_or(&mut none);
        own.resize(self.movable.len(), BodyState::at_rest(Pose::IDENTITY));
        wrenches.resize(self.movable.len(), Wrench::default());
        for slot in read {
            own[slot] = states[self.movable[slot]];
            wrenches[slot] = Wrench::default();
        }
        let chosen = fields.iter().filter(|&&number| chosen(number, &*self.forces.fields[number]));
        for field in chosen.map(|&number| &*self.forces.fields[number]) {
            field.add_wrenches(t, &self.rigid, own, wrenches);
        }
        let load = |slot: usize| {
            let mut wrench = wrenches[slot];
            finish(slot, &mut wrench);
            (self.movable[slot], wrench)
        };
        Some(Loads::Of(slots.into_iter().map(load).collect()))
    }

    /// How the fields that act on these bodies respond to their motion, by account; `are_known` is false when a field
    /// depends on velocities and does not say how.
    /// Of forces at joints those of `kicks` alone.
    pub(crate) fn responses_on(&self, states: &[BodyState], bodies: &[usize], kicks: &[usize]) -> Responses {
        let slots: Vec<usize> = bodies.iter().filter_map(|&body| self.slot(body)).collect();
        let (fields, read) = self.forces.index.acting_on(&slots).unwrap_or_else(|| {
            let acts = |&number: &usize| slots.iter().any(|&slot| self.forces.fields[number].acts_on(slot));
            ((0..self.forces.fields.len()).filter(acts).collect(), (0..self.movable.len()).collect())
        });
        let mut found = Responses { are_known: true, of_fields: Vec::new() };
        if fields.is_empty() {
            return found;
        }
        let (mut buffers, mut none) = (self.forces.buffers.0.try_lock(), Default::default());
        let (own, _) = buffers.as_deref_mut().unwrap_or(&mut none);
        own.resize(self.movable.len(), BodyState::at_rest(Pose::IDENTITY));
        for slot in read {
            own[slot] = states[self.movable[slot]];
        }
        let kicks = fields.iter().filter(|&&number| self.forces.is_kick(number, kicks));
        for field in kicks.map(|&number| &self.forces.fields[number]) {
            let Some(responses) = field.responses(&self.rigid, own) else {
                found.are_known &= field.dependence() != Dependence::Velocities;
                continue;
            };
            let in_scene = |mut response: ForceResponse| {
                // A field may name a body that is not there.
                response.ends = response.ends.map(|end| end.filter(|end| end.body < self.movable.len()));
                for end in response.ends.iter_mut().flatten() {
                    end.body = self.movable[end.body];
                }
                (field.account(), response)
            };
            found.of_fields.extend(responses.into_iter().map(in_scene));
        }
        found
    }

    /// Whether a field couples the motion of a body to that of other bodies.
    pub(crate) fn is_coupled(&self, body: usize) -> bool {
        self.couplings_of(body).next().is_some()
    }

    /// The couplings of a body: for each field that couples it to others, all bodies of that field.
    pub(crate) fn couplings_of(&self, body: usize) -> impl Iterator<Item = &Vec<usize>> {
        let numbers = self.slot(body).map_or(&[][..], |slot| self.forces.index.couplings_of(slot));
        numbers.iter().map(|&number| &self.forces.couplings[number])
    }

    /// The couplings of these bodies, each once.
    pub(crate) fn couplings_among(&self, bodies: &[usize]) -> impl Iterator<Item = &Vec<usize>> {
        let slots = bodies.iter().filter_map(|&body| self.slot(body));
        let numbers: BTreeSet<usize> = slots.flat_map(|slot| self.forces.index.couplings_of(slot)).copied().collect();
        numbers.into_iter().map(|number| &self.forces.couplings[number])
    }

    /// Whether fields couple bodies in a scene with bodies that may collide.
    pub(crate) fn any_coupled_may_collide(&self) -> bool {
        self.surfaces.may_collide() && !self.forces.couplings.is_empty()
    }

    /// Acceleration of the origin of a body's moving frame by gravity, m/s^2: zero if that origin is a pivot.
    pub(crate) fn free_acceleration(&self, body: usize) -> DVec3 {
        let held = self.bodies[body].rigid.as_ref().is_some_and(RigidBody::is_pivoted);
        if held { DVec3::ZERO } else { self.gravity() }
    }
}

/// The fields of a force and a torque (world) on the movable body of this slot; no fields when there is no slot.
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

/// How some fields respond to the motion of their bodies, given by their indices.
#[derive(Debug, Clone, Default)]
pub(crate) struct Responses {
    pub(crate) of_fields: Vec<(Account, ForceResponse)>,
    /// Whether every field that depends on velocities says how.
    pub(crate) are_known: bool,
}

/// Wrenches of the fields on all bodies at one instant; torques about the origins of the moving frames.
#[derive(Debug, Clone, Default)]
pub(crate) enum Loads {
    /// No body has one.
    #[default]
    None,
    /// By body, ascending; the others have none.
    Of(Vec<(usize, Wrench)>),
}

impl Loads {
    /// The same with forces and moments (N, N m, about the centres of mass) on some bodies, ascending.
    pub(crate) fn with(&self, own: impl Iterator<Item = (usize, DVec3, DVec3)>) -> Self {
        let mut all = match self {
            Self::None => Vec::new(),
            Self::Of(loads) => loads.clone(),
        };
        for (body, force, torque) in own {
            match all.binary_search_by_key(&body, |(loaded, _)| *loaded) {
                Ok(place) => {
                    all[place].1.force += force;
                    all[place].1.torque += torque;
                }
                Err(place) => all.insert(place, (body, Wrench { force, torque })),
            }
        }
        Self::Of(all)
    }

    /// The wrench on one body.
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
