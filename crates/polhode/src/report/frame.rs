//! A frame: everything that a viewer draws at one time.

use crate::identity::body_id::BodyId;
use crate::identity::joint_id::JointId;
use crate::report::body_sample::BodySample;
use crate::report::energy::Energy;
use crate::report::joint_efforts::EffortsAlong;
use crate::report::ledger::Ledger;
use crate::report::run_report::Certificate;
use polhode_contact::ContactFeature;
use polhode_spatial::DVec3;

/// How a body moves at a time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum MotionKind {
    /// Not by forces: it is fixed, kinematic or removed.
    Given,
    /// In free flight, in closed form.
    Flight,
    /// Integrated under forces, active contacts or pivots.
    Integrated,
    /// At rest, in certified equilibrium.
    Rest,
}

/// A contact that touches.
///
/// The motion and the resultants of contact forces are unique. Where statics does not determine the single forces (four
/// legs on a floor), those of least norm are given, and another method may give others for the same motion.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct ContactView {
    /// Body A.
    pub body_a: BodyId,
    /// Body B.
    pub body_b: BodyId,
    /// Which features touch.
    pub feature: ContactFeature,
    /// Contact point, world, m.
    pub point_m: DVec3,
    /// Unit normal from B to A, world.
    pub normal: DVec3,
    /// Signed distance along the normal, m; negative when the bodies overlap.
    pub separation_m: f64,
    /// Force on A along the normal, N. It is zero for a contact that opens, and NaN if the solver found no force. In
    /// the tiers of fixed steps it is the mean force of the last step; in the tier `thesis` it is zero before the first
    /// step.
    pub normal_force_n: f64,
    /// Force of friction on A, in the tangent plane, world, N. Zero without friction and in the tier `thesis`; in the
    /// tier `stepped` the mean of the last step.
    pub friction_n: DVec3,
}

/// The force that holds a body at its pivot.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct PivotView {
    /// The body.
    pub body: BodyId,
    /// The point at which the body is held, world, m.
    pub point_m: DVec3,
    /// Force of the pivot on the body, world, N; NaN if the solver found no force. It is unique unless contact forces
    /// of the body are not.
    pub force_n: DVec3,
}

/// What a joint does to its first body, and the opposite of what it does to the second one: its reactions, with what
/// stops and friction do. Springs, dampers and motors at it are not part of that. Of joints that hold more than they
/// need to the reactions of least norm are given.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct JointView {
    /// The joint.
    pub joint: JointId,
    /// Its anchor on the first body, world, m.
    pub point_m: DVec3,
    /// Force at the anchor, world, N; NaN if the solver found none.
    pub force_n: DVec3,
    /// Moment about the anchor, world, N m.
    pub moment_n_m: DVec3,
    /// What of it acts along the coordinates of the joint.
    pub(crate) along: EffortsAlong,
}

impl JointView {
    /// The same with other loads, so many times as large.
    pub(crate) fn times(&self, factor: f64) -> Self {
        let none = Self { force_n: DVec3::ZERO, moment_n_m: DVec3::ZERO, along: EffortsAlong::default(), ..*self };
        let mut own = Self { force_n: self.force_n * factor, moment_n_m: self.moment_n_m * factor, ..none };
        own.along.add_times(&self.along, factor);
        own
    }

    /// Adds the loads of another one.
    pub(crate) fn add(&mut self, other: &Self) {
        self.force_n += other.force_n;
        self.moment_n_m += other.moment_n_m;
        self.along.add_times(&other.along, 1.0);
    }
}

/// An island: bodies that move together or rest together, connected by active contacts or by forces that couple them.
/// In the tier `stepped` bodies are connected that may touch within a step; in the tier `thesis` all bodies form one
/// island. Bodies in free flight, fixed and kinematic bodies are in no island.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct IslandView {
    /// The bodies, ascending.
    pub bodies: Vec<BodyId>,
}

/// All bodies at one time, with contacts and islands: a frame of an animation, not a coordinate frame. The place of a
/// body in the lists is its [`BodyId::index`].
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Frame {
    /// Time, s.
    pub t_s: f64,
    /// Poses and velocities.
    pub bodies: Vec<BodySample>,
    /// How each body moves.
    pub motions: Vec<MotionKind>,
    /// Contacts that touch, with their forces.
    pub contacts: Vec<ContactView>,
    /// What the joints do; empty for a tier that does not compute it.
    pub joint_loads: Vec<JointView>,
    /// Islands.
    pub islands: Vec<IslandView>,
    /// Energies at this time; `initial_j` is that at the start of the run.
    pub energy: Energy,
    /// Where the energy went so far: what a step takes is booked at its end.
    pub ledger: Ledger,
    /// What is certain of the accuracy of the run so far.
    pub certificate: Certificate,
    /// Steps made so far.
    pub steps: u64,
}
