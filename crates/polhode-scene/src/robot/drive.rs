//! What drives the coordinates of a robot: drives of the scene, or else the actuators of its file at a control that
//! stays.
//!
//! Of an actuator with gear `r` at the control `u` (`Actuator` of the model) the effort along the coordinate `q` is
//! `E - K q - D q'`, with `E = r (g0 u + b0)`, `K = -r^2 (g1 u + b1)` and `D = -r^2 (g2 u + b2)`. It is a servo that
//! regulates `q` to `E / K`; without `K` one that regulates `q'` to `E / D`; without both a constant effort.

use super::finding::{Finding, RobotDefect};
use super::model::{Actuator, EffortLimit, RobotCoordinate};
use polhode::scene::{Coordinate, CoordinateMotion, Drive, FreedomError, Motor};
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// What drives a coordinate, as the scene says: in values of the joint of the file.
#[derive(Debug, Clone, PartialEq)]
pub struct RobotDrive {
    /// A motor.
    pub motor: Option<Motor>,
    /// Where its largest effort is given.
    pub bound: MotorBound,
    /// A motion that it follows.
    pub motion: Option<CoordinateMotion>,
}

/// Where the largest effort of a motor is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MotorBound {
    /// In the robot's file, if it has one.
    OfFile,
    /// With the motor.
    Given,
}

/// What acts: `E - K q - D q'`.
#[derive(Debug, Clone, Copy, Default)]
struct Affine {
    effort: f64,
    stiffness: f64,
    damping: f64,
}

/// The motor of a coordinate that is at `value` at the start, from which the engine counts it.
pub(super) fn from_start(motor: Motor, value: f64) -> Result<Motor, FreedomError> {
    let drive = match motor.drive() {
        Drive::Position { position, stiffness, damping } => {
            Drive::Position { position: position - value, stiffness, damping }
        }
        other => other,
    };
    Motor::new(drive)?.at_most(motor.most())
}

/// The motor of a drive of the scene at a coordinate of the file, and what is told of it.
pub(super) fn of_scene(drive: &RobotDrive, own: &RobotCoordinate, coordinate: Coordinate) -> (Option<Motor>, Finding) {
    let bound = own.effort_limit.as_ref().filter(|_| drive.bound == MotorBound::OfFile);
    let motor = drive.motor.map(|motor| bounded(motor, bound));
    let mut words = match motor {
        _ if drive.motion.is_some() => "its motion is prescribed".to_owned(),
        Some(motor) => words(&motor, coordinate),
        None => String::new(),
    };
    if let Some(limit) = bound.filter(|_| motor.is_some() && drive.motion.is_none()) {
        let _ = write!(words, " ({} in its file)", limit.what);
    }
    let place = own.place.clone();
    let (subject, defect) = (subject(own), RobotDefect::Read(format!("driven by the scene: {words}")));
    (motor, Finding { place, subject, defect })
}

fn subject(own: &RobotCoordinate) -> String {
    format!("joint `{}`", own.name)
}

/// A motor with a bound of its file.
fn bounded(motor: Motor, limit: Option<&EffortLimit>) -> Motor {
    limit.map_or(motor, |limit| motor.at_most(limit.most.min(motor.most())).unwrap_or(motor))
}

/// An actuator that acts.
struct Acting<'a> {
    actuator: &'a Actuator,
    control: f64,
    made: Affine,
    /// Its largest effort along the coordinate.
    most: f64,
}

/// The motor that the actuators of a coordinate are together; `inertia` is that of what they move, kg m^2 or kg.
pub(super) fn of_actuators(
    actuators: &[&Actuator],
    (own, coordinate): (&RobotCoordinate, Coordinate),
    controls: &BTreeMap<String, f64>,
    inertia: f64,
    findings: &mut Vec<Finding>,
) -> Option<Motor> {
    let mut acting = Vec::new();
    for &actuator in actuators {
        let mut tell = |defect| {
            let (place, subject) = (actuator.place.clone(), format!("actuator `{}`", actuator.name));
            findings.push(Finding { place, subject, defect });
        };
        let control = control_of(actuator, controls, &mut tell);
        let Some(mut made) = affine(actuator, control, inertia, &mut tell) else { continue };
        if made.stiffness == 0.0 && made.damping == 0.0 {
            // A constant effort is bounded as it is.
            made.effort = within(made.effort, actuator);
        }
        acting.push(Acting { actuator, control, made, most: bound_of(actuator, &mut tell) });
    }
    let mut sum = Affine::default();
    for Acting { actuator, control, made, most } in &acting {
        sum.effort += made.effort;
        sum.stiffness += made.stiffness;
        sum.damping += made.damping;
        let motor = motor_of(*made, *most).map(|motor| bounded(motor, own.effort_limit.as_ref()));
        let acts = motor.map_or_else(|| "nothing".to_owned(), |motor| words(&motor, coordinate));
        let what = format!("<{}> at joint `{}`, control {control}: {acts}", actuator.kind, own.name);
        let (place, subject) = (actuator.place.clone(), format!("actuator `{}`", actuator.name));
        findings.push(Finding { place, subject, defect: RobotDefect::Read(what) });
    }
    let (count, most) = (acting.len(), acting.iter().map(|own| own.most).sum());
    let has_bounds = acting.iter().any(|own| own.most.is_finite());
    if count > 1 && has_bounds && sum.stiffness + sum.damping > 0.0 {
        let defect = RobotDefect::SumOfBounds { count, most };
        findings.push(Finding { place: own.place.clone(), subject: subject(own), defect });
    }
    motor_of(sum, most).map(|motor| bounded(motor, own.effort_limit.as_ref()))
}

/// The control of an actuator: the one given, moved into its range, or else zero.
fn control_of(actuator: &Actuator, controls: &BTreeMap<String, f64>, tell: &mut impl FnMut(RobotDefect)) -> f64 {
    let value = controls.get(&actuator.name).copied().unwrap_or(0.0);
    let Some([lower, upper]) = actuator.control_range.filter(|[lower, upper]| !(*lower..=*upper).contains(&value))
    else {
        return value;
    };
    tell(RobotDefect::ControlBeyond { value, lower, upper });
    value.clamp(lower, upper)
}

/// The effort along the coordinate; none of an actuator that pushes away from its target, which is told.
fn affine(actuator: &Actuator, control: f64, inertia: f64, tell: &mut impl FnMut(RobotDefect)) -> Option<Affine> {
    let [of_effort, of_value, of_rate] =
        std::array::from_fn(|index| actuator.gain[index] * control + actuator.bias[index]);
    let gear = actuator.gear;
    let (effort, stiffness) = (gear * of_effort, 0.0 - gear * gear * of_value);
    let given = 0.0 - gear * gear * of_rate;
    // Of critical damping, with the inertia that the coordinate has in the pose of the file.
    let damping = actuator.damping_ratio.map_or(given, |ratio| 2.0 * ratio * (stiffness.max(0.0) * inertia).sqrt());
    if stiffness >= 0.0 && damping >= 0.0 {
        return Some(Affine { effort, stiffness, damping });
    }
    let what = format!(
        "its stiffness is {stiffness} and its damping {damping}: servos that push away from their target are not \
         simulated"
    );
    tell(RobotDefect::ActuatorLeftOut(what));
    None
}

/// The largest effort along the coordinate, the same to both sides.
fn bound_of(actuator: &Actuator, tell: &mut impl FnMut(RobotDefect)) -> f64 {
    let Some([lower, upper]) = actuator.force_range else { return f64::INFINITY };
    let most = (0.0 - lower).min(upper).max(0.0);
    let is_constant = actuator.gain[1..].iter().chain(&actuator.bias[1..]).all(|&number| number == 0.0);
    if 0.0 - lower != upper && !is_constant {
        tell(RobotDefect::OneBound { lower, upper, most });
    }
    actuator.gear.abs() * most
}

/// A constant effort within the range of its actuator.
fn within(effort: f64, actuator: &Actuator) -> f64 {
    let gear = actuator.gear;
    actuator.force_range.map_or(effort, |[lower, upper]| {
        let ends = [gear * lower, gear * upper];
        effort.clamp(ends[0].min(ends[1]), ends[0].max(ends[1]))
    })
}

/// The motor of an effort; none where it exerts nothing.
fn motor_of(own: Affine, most: f64) -> Option<Motor> {
    let Affine { effort, stiffness, damping } = own;
    let drive = if stiffness > 0.0 {
        Drive::Position { position: effort / stiffness, stiffness, damping }
    } else if damping > 0.0 {
        Drive::Velocity { velocity: effort / damping, gain: damping }
    } else if effort != 0.0 {
        Drive::Effort(effort)
    } else {
        return None;
    };
    // The bound of a constant effort has been kept; the numbers of a file are finite.
    let motor = Motor::new(drive).ok()?;
    let is_constant = matches!(drive, Drive::Effort(_));
    if is_constant { Some(motor) } else { motor.at_most(most).ok() }
}

/// What a motor does, in words.
fn words(motor: &Motor, coordinate: Coordinate) -> String {
    let is_angle = coordinate == Coordinate::Angle;
    let [value, effort] = if is_angle { ["rad", "N m"] } else { ["m", "N"] };
    let [per_value, per_rate] = if is_angle { ["N m/rad", "N m s/rad"] } else { ["N/m", "N s/m"] };
    let mut words = match motor.drive() {
        Drive::Position { position, stiffness, damping } => {
            format!("to {position} {value}, stiffness {stiffness} {per_value}, damping {damping} {per_rate}")
        }
        Drive::Velocity { velocity, gain } => format!("to {velocity} {value}/s, gain {gain} {per_rate}"),
        Drive::Effort(own) => format!("{own} {effort}"),
        _ => String::new(),
    };
    if motor.most() < f64::INFINITY {
        let _ = write!(words, ", at most {} {effort}", motor.most());
    }
    words
}
