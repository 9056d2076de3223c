//! What acts along the coordinates of a joint, by its cause, and what the joint keeps by.
//!
//! A force `F` at a point `p` with a moment `M`, on the first body, acts along an angle about the axis `n` through the
//! anchor `a` with `n.(M + (p - a) x F)` (N m), and along a displacement or a distance in the direction `d` with `d.F`
//! (N). Springs, dampers and motors follow from the states by their laws; prescribed motions, gears, dry friction and
//! limits are told with the load of the joint (`solve/joint_loads.rs`). The reaction is that load without them.
//! Source: Featherstone 2008, chapter 3 (active forces and constraint forces of a joint).

use crate::constraint::coordinate::CoordinateAt;
use crate::constraint::joint::ModelJoint;
use crate::constraint::joint_coordinate::JointCoordinate;
use crate::constraint::joint_forces::Source;
use crate::identity::contact_id::{ContactId, Feature};
use crate::identity::joint_id::JointId;
use crate::model::{Joints, Model};
use crate::report::frame::JointView;
use crate::report::joint_efforts::{Cause, Efforts, EffortsAlong};
use crate::report::joint_sample::Reaction;
use crate::scene::Coordinate;
use polhode_dynamics::BodyState;
use polhode_spatial::{DVec3, Pose, Velocity};

impl Joints {
    /// The coordinate along which a contact at a joint acts, and why; none of the side of a track and of contacts of
    /// shapes.
    pub(crate) fn cause_of(&self, id: ContactId) -> Option<(Coordinate, Cause)> {
        match id.feature {
            Feature::Shapes(_) => None,
            Feature::Stop(own) => Some((self.joint_numbered(own.joint)?.stop(own.stop)?.coordinate()?, Cause::Limit)),
            Feature::JointFriction(of) => {
                let coordinate = self.joint_numbered(of.joint)?.coordinates().get(of.place)?.coordinate;
                Some((coordinate, Cause::Friction))
            }
        }
    }
}

/// The coordinate of a joint in these states, and the length of its unit, m.
fn coordinate_at(
    model: &Model,
    states: &[BodyState],
    joint: &ModelJoint,
    coordinate: Coordinate,
) -> Option<(CoordinateAt, f64)> {
    let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, model.velocity(body, &states[body])) };
    let own = joint.coordinates().iter().find(|own| own.coordinate == coordinate)?;
    Some((joint.coordinate_at((&own.measured, own.near * own.unit), motion)?, own.unit))
}

/// What a force (N) at a point (m) and a moment (N m) on the first body of a joint, by its number, do along one of its
/// coordinates. Zero of one that it does not have or that has no direction.
pub(crate) fn along(
    model: &Model,
    states: &[BodyState],
    (joint, coordinate): (usize, Coordinate),
    (point, force, moment): (DVec3, DVec3, DVec3),
) -> f64 {
    let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, model.velocity(body, &states[body])) };
    let Some(joint) = model.joints.joint_numbered(joint) else { return 0.0 };
    let Some((at, unit)) = coordinate_at(model, states, joint, coordinate) else { return 0.0 };
    match at.moment {
        Some(own) => (own.axis / unit).dot(moment + (point - joint.anchor(motion)).cross(force)),
        None => at.direction.dot(force),
    }
}

/// What acts along the coordinates of a joint that bears this load; of one whose load is not known what follows from
/// its states.
pub(crate) fn of_joint(
    model: &Model,
    states: &[BodyState],
    joint: &ModelJoint,
    load: Option<&JointView>,
) -> Vec<(Coordinate, Efforts)> {
    let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, model.velocity(body, &states[body])) };
    let number = joint.number();
    let of_coordinate = |(place, own): (usize, &JointCoordinate)| {
        let coordinate = own.coordinate;
        let mut efforts = match load {
            Some(load) => load.along.of(coordinate),
            None => unknown(model, joint, coordinate),
        };
        let forces = model.forces.of_joints.iter();
        for force in forces.filter(|force| force.joint.number() == number && force.place == place) {
            let effort = force.effort(motion);
            match force.source {
                Source::Spring { .. } => efforts.spring += effort,
                Source::Damper { .. } => efforts.damper += effort,
                Source::Motor(_) => efforts.drive += effort,
            }
        }
        (coordinate, efforts)
    };
    joint.coordinates().iter().enumerate().map(of_coordinate).collect()
}

/// What is not known of a coordinate without the load of its joint: what acts there at all.
fn unknown(model: &Model, joint: &ModelJoint, coordinate: Coordinate) -> Efforts {
    let own = joint.coordinates().iter().find(|own| own.coordinate == coordinate);
    let is_unknown = |acts: bool| if acts { f64::NAN } else { 0.0 };
    let mut efforts = Efforts::default();
    let Some(own) = own else { return efforts };
    efforts.friction = is_unknown(own.freedom.friction().is_some());
    efforts.limit = is_unknown(own.freedom.limits().is_some());
    for tie in model.joints.ties_at_work() {
        let is_tied = tie.coordinates().any(|tied| {
            let place = tied.joint.coordinates().get(tied.place);
            tied.joint.number() == joint.number() && place.is_some_and(|place| place.coordinate == coordinate)
        });
        match tie.carriage() {
            Some(_) => efforts.drive += is_unknown(is_tied),
            None => efforts.gear += is_unknown(is_tied),
        }
    }
    efforts
}

/// What a joint keeps by, in its own axes: its load without what of it acts along its coordinates.
pub(crate) fn reaction(model: &Model, states: &[BodyState], joint: &ModelJoint, load: &JointView) -> Reaction {
    let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, model.velocity(body, &states[body])) };
    let (mut force, mut moment) = (load.force_n, load.moment_n_m);
    for own in joint.coordinates() {
        let Some((at, unit)) = coordinate_at(model, states, joint, own.coordinate) else { continue };
        let effort = load.along.of(own.coordinate).sum();
        match at.moment {
            Some(own) => moment -= own.axis / unit * effort,
            None => force -= at.direction * effort,
        }
    }
    let axes = joint.axes(motion);
    let in_axes = |of: DVec3| DVec3::from_array(axes.map(|axis| axis.dot(of)));
    Reaction { force_n: in_axes(force), moment_n_m: in_axes(moment), axes }
}

/// A load of a joint that nothing holds at present, at its anchor.
pub(crate) fn no_load(model: &Model, states: &[BodyState], joint: &ModelJoint) -> JointView {
    let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, model.velocity(body, &states[body])) };
    JointView {
        joint: JointId::new(joint.number()),
        point_m: joint.anchor(motion),
        force_n: DVec3::ZERO,
        moment_n_m: DVec3::ZERO,
        along: EffortsAlong::default(),
    }
}
