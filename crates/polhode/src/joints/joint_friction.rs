//! Dry friction of joints, as contacts that a given force presses: shoes of a brake.
//!
//! A shoe is pressed by the force `N = T/l`, where `T` is the effort of friction in motion (N m of an angle, N of a
//! displacement) and `l` the length that gives angles the unit of displacements (`coordinate.rs`; 1 otherwise). It
//! slips along the coordinate, with the coefficient 1 in motion and `T_b/T` at rest, where `T_b` is the effort of
//! breakaway. So Coulomb's law for it is that of dry friction, and all that contacts with friction have (modes, events,
//! warm starts, what is booked) holds for joints.
//!
//! A bearing adds `k R` to the effort, where `R` is the force of the joint on the body across the axis and `k` the
//! coefficient times the radius at which it rubs (times 1 of a displacement). That force follows from the reactions,
//! which are found again with it until it stays ([`Pressed::renewed`]); while nothing begins to slide or to stick they
//! are linear in what presses the shoes, and a first look finds all of it ([`LinearLoads`]). What acts at a lever is
//! part of the moment, so that `R` counts the force there too.
//!
//! Its rows: the one along the "normal" acts on no body. It has a compliance `c`, and its constant term is `-c N`, so
//! that its reaction is `N`. The first tangent is the coordinate; there is no second one, so that its row acts on
//! nothing either. A force at a lever of the second body stands for the moment about a hinge: its direction is fixed in
//! that body.
//!
//! A bearing whose friction holds by more than it is pressed, `k` above the levers of its joint, locks itself: no force
//! is found for it, and the last one is taken.
//!
//! Sources: thesis 3.4 (contacts with friction); Featherstone 2008, chapter 9 (forces at joints). Assumption: what the
//! joint keeps holds. Finite forces give no impulse: in impacts joints have no friction.

use crate::collision::friction_mode::FrictionCoefficients;
use crate::constraint::ConstraintId;
use crate::constraint::joint::ModelJoint;
use crate::constraint::joint_coordinate::JointCoordinate;
use crate::identity::contact_id::{ContactId, Feature};
use crate::identity::coordinate_id::CoordinateId;
use crate::model::{Joints, Model};
use crate::scene::{FrictionEllipse, JointFriction};
use polhode_contact::{ContactGeometry, ContactKinematics, TangentialKinematics};
use polhode_dynamics::{BodyState, RigidBody};
use polhode_spatial::{DVec3, Pose, Velocity};

/// What presses the shoe of a joint with friction, in the row along its normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pressed {
    /// N.
    pub(crate) force: f64,
    /// Of its row, 1/kg.
    pub(crate) compliance: f64,
    of: CoordinateId,
    bearing: Option<Bearing>,
}

/// How the load of a bearing presses the shoe.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Bearing {
    /// The force without load, N.
    unloaded: f64,
    /// The force of the shoe for each newton across the axis (no unit).
    share: f64,
    /// Unit vector, world.
    axis: DVec3,
}

/// Rounds in which the load of bearings is found (10 to 100): each takes `k` over the levers of the joint of the error.
pub(crate) const MOST_ROUNDS_OF_BEARINGS: usize = 60;

/// Loads of bearings that differ by less than this part of them count as found (no unit): some rounding units.
const SAME_LOAD: f64 = 4.0 * f64::EPSILON;

impl Pressed {
    /// Whether the load of a bearing presses it.
    pub(crate) fn is_by_load(&self) -> bool {
        self.bearing.is_some()
    }

    /// The joint.
    pub(crate) fn joint(&self) -> usize {
        self.of.joint
    }

    /// The same where its joint bears this force (N) on its first body, that at levers with it. None where nothing
    /// changes.
    pub(crate) fn renewed(&self, whole: DVec3) -> Option<Self> {
        let Bearing { unloaded, share, axis } = self.bearing?;
        let load = (whole - axis * axis.dot(whole)).length();
        let force = unloaded + share * load;
        ((force - self.force).abs() > SAME_LOAD * force).then_some(Self { force, ..*self })
    }
}

/// The forces that joints with friction bear, as they change with what presses the shoes: `R_k + D_kj (N_j - N_j0)`.
#[derive(Debug)]
pub(crate) struct LinearLoads {
    /// `R_k` under the forces `N_j0`, N.
    pub(crate) loads: Vec<DVec3>,
    /// `D_kj`, of each shoe `j` those of all joints `k` (no unit).
    pub(crate) changes: Vec<Vec<DVec3>>,
}

impl LinearLoads {
    /// What presses the shoes where it follows from the loads that it gives, from these forces on.
    pub(crate) fn pressed(&self, from: &[(usize, Pressed)]) -> Vec<(usize, Pressed)> {
        let (mut pressed, mut round) = (from.to_vec(), LastRound::default());
        for _ in 0..MOST_ROUNDS_OF_BEARINGS {
            let mut loads = self.loads.clone();
            for ((changes, (_, own)), (_, first)) in self.changes.iter().zip(&pressed).zip(from) {
                let more = own.force - first.force;
                loads.iter_mut().zip(changes).for_each(|(load, change)| *load += *change * more);
            }
            let Some(renewed) = renewed(&pressed, &loads) else { break };
            pressed = round.next(&pressed, renewed);
        }
        pressed
    }
}

/// What presses the shoes of joints that bear these forces (N); none where nothing changes.
pub(crate) fn renewed(pressed: &[(usize, Pressed)], loads: &[DVec3]) -> Option<Vec<(usize, Pressed)>> {
    let of_load = |((row, own), load): (&(usize, Pressed), &DVec3)| (*row, own.renewed(*load).unwrap_or(*own));
    let renewed: Vec<(usize, Pressed)> = pressed.iter().zip(loads).map(of_load).collect();
    (renewed != pressed).then_some(renewed)
}

/// The last round of the search for the loads of bearings.
#[derive(Debug, Default)]
pub(crate) struct LastRound {
    /// The forces of shoes that followed from its loads, N.
    renewed: Vec<f64>,
    /// What they differed by from those of the round, N.
    changes: Vec<f64>,
}

impl LastRound {
    /// The largest change relative to the largest force.
    pub(crate) fn relative_change(&self) -> f64 {
        let largest = |of: &[f64]| of.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
        if self.changes.is_empty() { 0.0 } else { largest(&self.changes) / largest(&self.renewed) }
    }

    /// What presses the shoes in the next round, where these forces follow from the loads under the present ones.
    /// They change by some hundredths of the change before, in loops that lie nearly flat by nearly as much or by more
    /// with the other sign: the secant through two rounds finds where they stay (Anderson 1965, of depth one).
    pub(crate) fn next(
        &mut self,
        pressed: &[(usize, Pressed)],
        mut renewed: Vec<(usize, Pressed)>,
    ) -> Vec<(usize, Pressed)> {
        let forces: Vec<f64> = renewed.iter().map(|(_, own)| own.force).collect();
        let changes: Vec<f64> = forces.iter().zip(pressed).map(|(force, (_, own))| force - own.force).collect();
        let last = std::mem::replace(self, Self { renewed: forces.clone(), changes: changes.clone() });
        let square = |of: &[f64]| of.iter().map(|own| own * own).sum::<f64>();
        if last.changes.len() == changes.len() {
            let falls: Vec<f64> = changes.iter().zip(&last.changes).map(|(own, last)| own - last).collect();
            let along: f64 = changes.iter().zip(&falls).map(|(own, fall)| own * fall).sum();
            let share = along / square(&falls);
            for ((_, own), last) in renewed.iter_mut().zip(&last.renewed) {
                let next = own.force - share * (own.force - last);
                own.force = if next.is_finite() { next.max(0.0) } else { own.force };
            }
        }
        renewed
    }
}

impl ModelJoint {
    /// The friction of one of its coordinates, and the length that makes displacements of its values, m.
    fn friction(&self, place: usize) -> Option<(JointFriction, f64)> {
        let JointCoordinate { freedom, unit, .. } = self.coordinates().get(place)?;
        Some((freedom.friction()?, *unit))
    }

    /// The places of its coordinates with friction.
    pub(crate) fn coordinates_with_friction(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.coordinates().len()).filter(|&place| self.friction(place).is_some())
    }
}

impl Joints {
    /// The coefficients of the shoe.
    pub(crate) fn friction_of_joint(&self, of: CoordinateId) -> Option<FrictionCoefficients> {
        let (friction, _) = self.joint_numbered(of.joint)?.friction(of.place)?;
        let at_rest = FrictionEllipse::circle(friction.static_ratio());
        Some(FrictionCoefficients { at_rest, sliding: FrictionEllipse::circle(1.0) })
    }

    /// What friction of joints takes over a radian, and over the sizes of their bodies, J: the scale of energies where
    /// it holds all that could move.
    pub(crate) fn friction_energy_j(&self) -> f64 {
        let of_joint = |joint: &ModelJoint| {
            let span = |place: usize| match joint.friction(place) {
                Some((friction, unit)) => friction.effort() / unit * joint.length(),
                None => 0.0,
            };
            (0..joint.coordinates().len()).map(span).sum::<f64>()
        };
        if self.have_friction { self.list.iter().map(of_joint).sum() } else { 0.0 }
    }
}

/// The place of the shoe in these states, which always touches.
pub(crate) fn friction_kinematics(model: &Model, states: &[BodyState], of: CoordinateId) -> Option<ContactKinematics> {
    let (point, _) = slip_at_joint(model, states, of)?;
    let geometry = ContactGeometry { point, normal: DVec3::ZERO, separation: 0.0, margin: f64::INFINITY };
    Some(ContactKinematics { geometry, separation_rate: 0.0, acceleration_bias: 0.0 })
}

/// The slip of the shoe in these states.
pub(crate) fn friction_slip(model: &Model, states: &[BodyState], of: CoordinateId) -> Option<TangentialKinematics> {
    slip_at_joint(model, states, of).map(|(_, slip)| slip)
}

/// Where friction acts, and the slip of the first body of its contact on the second one.
fn slip_at_joint(model: &Model, states: &[BodyState], of: CoordinateId) -> Option<(DVec3, TangentialKinematics)> {
    let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, model.velocity(body, &states[body])) };
    let joint = model.joints.joint_numbered(of.joint)?;
    let JointCoordinate { measured, unit, near, .. } = joint.coordinates().get(of.place)?;
    let at = joint.coordinate_at((measured, near * unit), motion)?.at_lever_of_second();
    let basis = at.direction * joint.order().sign();
    let terms = TangentialKinematics {
        basis: [basis, DVec3::ZERO],
        slip_velocity: basis * at.rate,
        acceleration_bias: basis * at.bias,
        point_velocity: DVec3::ZERO,
        normal_rate: DVec3::ZERO,
    };
    Some((at.point, terms))
}

/// The bearings whose load presses their friction among the joints of these bodies: the joint, and its axis in
/// these states.
pub(crate) fn bearings_among(model: &Model, states: &[BodyState], bodies: &[usize]) -> Vec<(ConstraintId, DVec3)> {
    let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, model.velocity(body, &states[body])) };
    let mut bearings = Vec::new();
    if !model.joints.have_friction {
        return bearings;
    }
    for joint in model.joints.joints_among(bodies) {
        let is_bearing = |place: &usize| joint.friction(*place).is_some_and(|(friction, _)| friction.arm() > 0.0);
        let places = joint.coordinates_with_friction().filter(is_bearing);
        bearings.extend(places.map(|place| (joint.id(), joint.axis_of(place, motion))));
    }
    bearings
}

/// What presses a contact in these states, bearings without load; none of one that bodies press.
pub(crate) fn pressed(model: &Model, states: &[BodyState], id: ContactId) -> Option<Pressed> {
    let Feature::JointFriction(of) = id.feature else { return None };
    let joint = model.joints.joint_numbered(of.joint)?;
    let (friction, unit) = joint.friction(of.place)?;
    let mass = |(body, _): (usize, f64)| model.bodies[body].rigid.as_ref().map(RigidBody::mass);
    let compliance = id.members().filter_map(mass).map(f64::recip).sum();
    let unloaded = friction.effort() / unit;
    let bearing = (friction.arm() > 0.0).then(|| {
        let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, model.velocity(body, &states[body])) };
        let axis = joint.axis_of(of.place, motion);
        Bearing { unloaded, share: friction.arm() / unit, axis }
    });
    Some(Pressed { force: unloaded, compliance, of, bearing })
}
