//! What joints of robot files have that the engine does not simulate: one list for all formats.

use super::element::Element;
use super::finding::RobotDefect;
use super::reading::Reading;

/// Why bounds of motors have no effect.
pub(super) const OF_MOTORS: &str =
    "it bounds motors, and the joint has none: `drives` of [[models]] or a program drive it";

/// Why bounds of the speed of motors have no effect.
pub(super) const OF_SPEEDS: &str = "motors are bounded in their effort alone: `most` of a drive";

/// Why inertia of a rotor has no effect.
pub(super) const ARMATURE: &str = "inertia of rotors is not simulated: joints accelerate more than with it";

/// The bound of an effort to both sides, N m or N, of a range of it; the smaller one where they differ, which is told.
pub(super) fn to_both_sides([lower, upper]: [f64; 2], element: &Element, subject: &str, reading: &mut Reading) -> f64 {
    let most = (-lower).min(upper).max(0.0);
    if -lower != upper {
        reading.refuse(element, subject, RobotDefect::OneBound { lower, upper, most });
    }
    most
}

/// A number, when it is not negative.
pub(super) fn not_negative(
    element: &Element,
    attribute: &str,
    value: f64,
    subject: &str,
    reading: &mut Reading,
) -> Option<f64> {
    if value >= 0.0 {
        return Some(value);
    }
    let (attribute, value) = (attribute.to_owned(), value.to_string());
    let accepted = "a finite number of at least 0".to_owned();
    reading.refuse(element, subject, RobotDefect::Numbers { attribute, value, accepted });
    None
}
