//! A scene evaluated in states that somebody else gives: energies, loads, what touches, what joints keep.
//!
//! Nothing is integrated and nothing is solved. It is what a judge of a trajectory needs: the laws are those of the
//! scene, the states are those of a file.
//!
//! | symbol | is |
//! |---|---|
//! | T | `sum m v^2/2 + L.w/2` over the bodies that forces move, J |
//! | V | gravity, zero at the world's origin, and conservative fields, J |
//! | power | `sum F.v + t.w` of the fields that have no potential (drag, dampers, motors, applied forces), W |
//! | load | gravity and all fields: a force, and a torque about the centre of mass |

use crate::collision::boxes::Boxes;
use crate::collision::contact_kinematics::tangential_kinematics;
use crate::collision::contact_set;
use crate::collision::touch::FoundContact;
use crate::constraint::ConstraintId;
use crate::constraint::row::{BilateralRow, Member};
use crate::error::SimulationError;
use crate::identity::body_id::BodyId;
use crate::identity::contact_id::Feature;
use crate::identity::joint_id::JointId;
use crate::joints::bilateral::Bilateral;
use crate::joints::held;
use crate::joints::joint_error::error_of;
use crate::joints::turns::count_all_turns;
use crate::model::pivot_form::PivotRows;
use crate::model::{Model, prescribed_state, reported, tolerances};
use crate::report::body_sample::BodySample;
use crate::scene::Scene;
use polhode_contact::BroadPhaseMethod;
use polhode_dynamics::BodyState;
use polhode_dynamics::field::{Account, Wrench};
use polhode_spatial::{DMat3, DVec3, Still, Velocity};

/// A scene in given states.
///
/// ```
/// use polhode::mesh::solid_sphere;
/// use polhode::spatial::{DVec3, Mass, Pose, Velocity};
/// use polhode::{Body, BodySample, Evaluation, Scene};
/// let ball = Body::movable("ball", solid_sphere(0.1, Mass::new(2.0)?)?);
/// let scene = Scene::builder("fall").body(ball).build()?;
/// let mut given = Evaluation::new(&scene)?;
/// let velocity = Velocity { linear: DVec3::X * 3.0, angular: DVec3::ZERO };
/// given.place(0.5, &[BodySample { pose: Pose::from_translation(DVec3::Z), velocity }])?;
/// let energy = given.energy();
/// assert!((energy.kinetic_j - 9.0).abs() < 1e-15 && (energy.potential_j - 19.62).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Evaluation {
    model: Model,
    broad_phase: BroadPhaseMethod,
    t_s: f64,
    states: Vec<BodyState>,
}

/// Energies in a state, J.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StateEnergy {
    /// T.
    pub kinetic_j: f64,
    /// V.
    pub potential_j: f64,
    /// The sum of the magnitudes of its parts: what the rounding of their sum is relative to.
    pub scale_j: f64,
}

/// A body that forces move, in a state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovableState {
    /// kg.
    pub mass_kg: f64,
    /// Largest extent, m.
    pub size_m: f64,
    /// Inverse of the inertia about the centre of mass, world axes, 1/(kg m^2).
    pub inverse_inertia: DMat3,
    /// Centre of mass, world, m.
    pub center_m: DVec3,
    /// Of the centre of mass (m/s), and angular (rad/s), world.
    pub velocity: Velocity,
    /// About the centre of mass, world, kg m^2/s.
    pub angular_momentum: DVec3,
    /// Gravity and fields: force (N), and torque about the centre of mass (N m).
    pub load: Wrench,
}

/// Two bodies that are near each other.
#[derive(Debug, Clone, PartialEq)]
pub struct NearPair {
    /// Both, A first.
    pub bodies: [BodyId; 2],
    /// Signed distance, m; negative where they overlap.
    pub separation_m: f64,
    /// Largest extent of the smaller one, m.
    pub size_m: f64,
    /// What rounding of their poses makes of the distance, m.
    pub rounding_m: f64,
    /// Where they are near.
    pub points: Vec<NearPoint>,
}

/// A point at which two bodies are near each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearPoint {
    /// World, m.
    pub point_m: DVec3,
    /// Unit normal from B to A.
    pub normal: DVec3,
    /// Signed distance along the normal, m.
    pub separation_m: f64,
    /// Its rate, m/s.
    pub rate_m_s: f64,
    /// Velocity at which A slips over B, m/s; none at the stop or the bearing of a joint, which is no contact.
    pub slip_m_s: Option<DVec3>,
}

/// A pivot, a joint, a gear or a prescribed coordinate in a state.
#[derive(Debug, Clone, PartialEq)]
pub struct HeldState {
    /// The joint; none of a pivot or a gear.
    pub joint: Option<JointId>,
    /// Its bodies; the same one twice where it holds a body to the world.
    pub bodies: [BodyId; 2],
    /// How far its bodies are from what it keeps, m.
    pub apart_m: f64,
    /// The same of rotations, rad.
    pub turned_rad: f64,
    /// Along what it acts on bodies: for each of its rows the bodies that forces move, with a force (no unit) and a
    /// moment about the centre of mass (m), world.
    pub rows: Vec<Vec<(BodyId, DVec3, DVec3)>>,
}

impl Evaluation {
    /// Of a scene, in the states of its start.
    ///
    /// # Errors
    /// When a shape or a force of the scene is not valid.
    pub fn new(scene: &Scene) -> Result<Self, SimulationError> {
        let (model, states) = Model::new(scene, PivotRows::All)?;
        let broad_phase = scene.method().broad_phase.unwrap_or_default();
        Ok(Self { model, broad_phase, t_s: 0.0, states })
    }

    /// Whether all that moves is in the samples of a trajectory: not where tracks have carriages of their own.
    pub fn is_of_samples(&self) -> bool {
        self.model.shown() == self.model.bodies.len()
    }

    /// Whether a prescribed motion of a joint acts, which may give any energy.
    pub fn has_prescribed_coordinates(&self) -> bool {
        self.model.bodies.iter().skip(self.model.shown()).any(|body| body.trajectory.is_some())
    }

    /// Takes these states at `t_s` (s), in the order of the scene; kinematic bodies are where their motion has them.
    ///
    /// # Errors
    /// When there are fewer samples than bodies, or the fields cannot be made.
    pub fn place(&mut self, t_s: f64, bodies: &[BodySample]) -> Result<(), SimulationError> {
        self.t_s = t_s;
        for (index, sample) in bodies.iter().enumerate().take(self.model.shown()) {
            let pose = reported::moving_pose(&self.model, index, sample.pose);
            let body = &self.model.bodies[index];
            self.states[index] = match (&body.rigid, &body.trajectory) {
                (Some(rigid), _) => rigid.at_velocity(pose, sample.velocity),
                (None, Some(trajectory)) => prescribed_state::state_at(trajectory, t_s),
                (None, None) => BodyState::at_rest(pose),
            };
        }
        // Carriages of prescribed coordinates stand in no sample.
        let shown = self.model.shown();
        for (body, state) in self.model.bodies.iter().zip(&mut self.states).skip(shown) {
            if let Some(trajectory) = &body.trajectory {
                *state = prescribed_state::state_at(trajectory, t_s);
            }
        }
        Ok(count_all_turns(&mut self.model, &self.states)?)
    }

    /// A body as the scene has it at this time where it does not depend on forces: fixed, or on a prescribed motion.
    pub fn prescribed(&self, body: BodyId) -> Option<BodySample> {
        let own = self.model.bodies.get(body.index())?;
        let state = own.trajectory.as_ref().map(|trajectory| prescribed_state::state_at(trajectory, self.t_s));
        Some(reported::sample(&self.model, body.index(), &state?))
    }

    /// T and V.
    pub fn energy(&self) -> StateEnergy {
        let mut energy = StateEnergy::default();
        let gravity = self.model.gravity();
        for (index, state) in self.states.iter().enumerate().take(self.model.shown()) {
            let Some(rigid) = &self.model.bodies[index].rigid else { continue };
            let kinetic = rigid.kinetic_energy(state);
            let potential =
                polhode_dynamics::energy::potential_energy(rigid.mass(), gravity, rigid.center_of_mass_position(state));
            energy.kinetic_j += kinetic;
            energy.potential_j += potential;
            energy.scale_j += kinetic + potential.abs();
        }
        let fields = self.model.field_potential(&self.states);
        energy.potential_j += fields;
        energy.scale_j += fields.abs();
        energy
    }

    /// What the fields that have no potential do, W.
    pub fn power_w(&self) -> f64 {
        let model = &self.model;
        let of_account = |account| {
            let loads = model.wrenches_of(account, self.t_s, &self.states, &model.movable);
            let of_body = |&body: &usize| {
                let (load, velocity) = (loads.of(body), model.velocity(body, &self.states[body]));
                load.force.dot(velocity.linear) + load.torque.dot(velocity.angular)
            };
            model.movable.iter().map(of_body).sum::<f64>()
        };
        of_account(Account::Damping) + of_account(Account::External)
    }

    /// The body, where forces move it.
    pub fn movable(&self, body: BodyId) -> Option<MovableState> {
        let (index, model) = (body.index(), &self.model);
        let (own, state) = (model.bodies.get(index)?, self.states.get(index)?);
        let rigid = own.rigid.as_ref()?;
        let field = model.loads_on(self.t_s, &self.states, &[index]).of(index);
        let load = Wrench { force: field.force + model.gravity() * rigid.mass(), torque: field.torque };
        Some(MovableState {
            mass_kg: rigid.mass(),
            size_m: own.size,
            inverse_inertia: rigid.inverse_inertia_world(state.pose.rotation),
            center_m: rigid.center_of_mass_position(state),
            velocity: rigid.center_of_mass_velocity(state),
            angular_momentum: state.angular_momentum,
            load,
        })
    }

    /// The pairs that are at most `reach` of their size (no unit) apart, and rounding more; by their bodies.
    ///
    /// # Errors
    /// When a box is not finite.
    pub fn near(&self, reach: f64) -> Result<Vec<NearPair>, SimulationError> {
        let (model, states) = (&self.model, &self.states);
        let within =
            |a: usize, b: usize| reach * tolerances::pair_size(model, a, b) + tolerances::rounding(model, states, a, b);
        let mut boxes = Boxes::new(self.broad_phase, states.len());
        for (body, state) in states.iter().enumerate() {
            boxes.set(model, body, &Still(state.pose), (0.0, 0.0), within(body, body));
        }
        let mut pairs = Vec::new();
        boxes.all_pairs(model, |a, b| pairs.push((a, b)))?;
        pairs.extend(model.joints.contacts.keys().copied());
        pairs.sort_unstable();
        pairs.dedup();
        let found = pairs.into_iter().filter_map(|(a, b)| {
            let pair = contact_set::pair_at_poses(model, states, a, b, within(a, b));
            let points: Vec<NearPoint> = pair.contacts.iter().map(|own| self.near_point(own)).collect();
            let deepest = points.iter().map(|own| own.separation_m).fold(pair.separation, f64::min);
            (deepest <= within(a, b)).then(|| NearPair {
                bodies: [BodyId::new(a), BodyId::new(b)],
                separation_m: deepest,
                size_m: tolerances::pair_size(model, a, b),
                rounding_m: tolerances::rounding(model, states, a, b),
                points,
            })
        });
        Ok(found.collect())
    }

    fn near_point(&self, found: &FoundContact) -> NearPoint {
        let geometry = found.kinematics.geometry;
        let is_contact = matches!(found.id.feature, Feature::Shapes(_));
        let slip = || Some(tangential_kinematics(&self.model, &self.states, found.id)?.slip_velocity);
        NearPoint {
            point_m: geometry.point,
            normal: geometry.normal,
            separation_m: geometry.separation,
            rate_m_s: found.kinematics.separation_rate,
            slip_m_s: if is_contact { slip() } else { None },
        }
    }

    /// The body that is nearest to this one among those with which it may collide, and how far it is, m.
    pub fn nearest(&self, body: BodyId) -> Option<(BodyId, f64)> {
        let index = body.index();
        let others = (0..self.states.len()).filter(|&other| self.model.scene.may_collide(index, other));
        let apart = others.filter_map(|other| {
            let apart = contact_set::separation_without_memory(&self.model, &self.states, index, other)?;
            Some((BodyId::new(other), apart))
        });
        apart.min_by(|(_, one), (_, other)| one.total_cmp(other))
    }

    /// What pivots, joints, gears and prescribed coordinates keep.
    pub fn held(&self) -> Vec<HeldState> {
        let held = |own: Bilateral| {
            let (apart_m, turned_rad) = error_of(&own);
            let (a, b) = own.id.bodies();
            let entries = |row: &BilateralRow| {
                let of = |member: &Member| {
                    let (force, moment) = row.entries(member);
                    (BodyId::new(member.body), force, moment)
                };
                own.members.iter().map(of).collect()
            };
            let joint = match own.id {
                ConstraintId::Joint { joint, .. } => Some(JointId::new(joint)),
                _ => None,
            };
            let rows = own.rows.iter().map(entries).collect();
            HeldState { joint, bodies: [BodyId::new(a), BodyId::new(b)], apart_m, turned_rad, rows }
        };
        held::bilaterals(&self.model, &self.states, &self.model.movable).map(held).collect()
    }
}
