//! Coordinates of joints as a program reads and drives them.

use crate::constraint::joint::ModelJoint;
use crate::model::{Joints, Model};
use crate::report::joint_sample::CoordinateSample;
use crate::scene::{Coordinate, Drive, Motor};
use crate::snapshot::{SnapshotError, content};
use polhode_dynamics::BodyState;
use polhode_spatial::{Pose, Velocity};
use std::cmp::Ordering;

impl Joints {
    /// Whether a joint of these bodies has a motor whose effort has a bound and depends on its coordinate.
    pub(crate) fn has_bounded_motors_among(&self, bodies: &[usize]) -> bool {
        self.joints_among(bodies).any(|joint| bounded_motors(joint).next().is_some())
    }

    /// The bodies of a joint with this coordinate between bodies that forces move; none where there is none.
    pub(crate) fn bodies_at(&self, joint: usize, coordinate: Coordinate) -> Option<Vec<usize>> {
        let joint = self.joint_numbered(joint).filter(|joint| joint.driver().is_none())?;
        joint.coordinates().iter().any(|own| own.coordinate == coordinate).then(|| joint.bodies().collect())
    }

    /// The motors that a program has set, as plain data.
    pub(crate) fn motors(&self) -> Vec<content::Motor> {
        let saved = |(&(joint, coordinate), motor): (&(usize, Coordinate), &Option<Motor>)| content::Motor {
            joint,
            coordinate: coordinate.name().to_owned(),
            drive: motor.map(|motor| (drive_numbers(motor.drive()), motor.most())),
        };
        self.motors.iter().map(saved).collect()
    }
}

/// A coordinate of a joint in these states; none of one that the joint does not have.
pub(crate) fn coordinate_of(
    model: &Model,
    states: &[BodyState],
    joint: usize,
    coordinate: Coordinate,
) -> Option<CoordinateSample> {
    let joint = model.joints.joint_numbered(joint)?;
    let own = joint.coordinates().iter().find(|own| own.coordinate == coordinate)?;
    let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, model.velocity(body, &states[body])) };
    let at = joint.coordinate_at((&own.measured, own.near * own.unit), motion)?;
    Some(CoordinateSample { value: at.value / own.unit, rate: at.rate / own.unit })
}

/// For each such motor: above, between or below its bounds.
pub(crate) fn phases_of_motors(model: &Model, states: &[BodyState], bodies: &[usize]) -> Vec<Option<Ordering>> {
    let phase = |joint: usize, coordinate: Coordinate, motor: Motor| {
        let at = coordinate_of(model, states, joint, coordinate)?;
        let effort = motor.effort(at.value, at.rate);
        let is_at_bound = effort.abs() >= motor.most();
        Some(if is_at_bound { effort.total_cmp(&0.0) } else { Ordering::Equal })
    };
    let motors = model.joints.joints_among(bodies).flat_map(|joint| {
        bounded_motors(joint).map(|(coordinate, motor)| phase(joint.number(), coordinate, motor)).collect::<Vec<_>>()
    });
    motors.collect()
}

/// Gives a coordinate of a joint another motor, or none, from now on.
///
/// # Errors
/// When the fields cannot be made.
pub(crate) fn set_motor(
    model: &mut Model,
    joint: usize,
    coordinate: Coordinate,
    motor: Option<Motor>,
) -> Result<(), crate::scene::SceneError> {
    if let Ok(place) = model.joints.list.binary_search_by_key(&joint, ModelJoint::number)
        && model.joints.list[place].set_motor(coordinate, motor)
    {
        model.joints.motors.insert((joint, coordinate), motor);
    }
    model.make_fields()
}

/// Replaces the motors that a program has set by those of such data. Those of the scene stay where none is given.
///
/// # Errors
/// When one is of no joint, or its numbers are refused.
pub(crate) fn replace_motors(model: &mut Model, saved: &[content::Motor]) -> Result<(), SnapshotError> {
    let refused = || SnapshotError::Invalid("a motor is of no joint, or its numbers are refused");
    for (joint, coordinate) in std::mem::take(&mut model.joints.motors).into_keys() {
        let of_scene = model.scene.joints().get(joint).and_then(|joint| joint.freedom(coordinate)?.motor());
        set_motor(model, joint, coordinate, of_scene).map_err(|_| refused())?;
    }
    model.joints.motors.clear();
    for content::Motor { joint, coordinate, drive } in saved {
        let named = Coordinate::ALL.into_iter().find(|known| known.name() == coordinate).ok_or_else(refused)?;
        model.joints.bodies_at(*joint, named).ok_or_else(refused)?;
        let motor = drive.as_ref().map(|(numbers, most)| {
            let drive = drive_of(numbers).ok_or_else(refused)?;
            Motor::new(drive).and_then(|motor| motor.at_most(*most)).map_err(|_| refused())
        });
        set_motor(model, *joint, named, motor.transpose()?).map_err(|_| refused())?;
    }
    Ok(())
}

/// The motors of a joint whose efforts have corners where they reach their bounds.
fn bounded_motors(joint: &ModelJoint) -> impl Iterator<Item = (Coordinate, Motor)> {
    let motors = joint.coordinates().iter().filter_map(|own| Some((own.coordinate, own.freedom.motor()?)));
    motors.filter(|(_, motor)| {
        let depends = !matches!(motor.drive(), Drive::Effort(_));
        depends && motor.most() > 0.0 && motor.most() < f64::INFINITY
    })
}

/// A drive as numbers: one of an effort, two of a servo of velocity, three of a servo of position.
fn drive_numbers(drive: Drive) -> Vec<f64> {
    match drive {
        Drive::Effort(effort) => vec![effort],
        Drive::Velocity { velocity, gain } => vec![velocity, gain],
        Drive::Position { position, stiffness, damping } => vec![position, stiffness, damping],
    }
}

fn drive_of(numbers: &[f64]) -> Option<Drive> {
    match *numbers {
        [effort] => Some(Drive::Effort(effort)),
        [velocity, gain] => Some(Drive::Velocity { velocity, gain }),
        [position, stiffness, damping] => Some(Drive::Position { position, stiffness, damping }),
        _ => None,
    }
}
