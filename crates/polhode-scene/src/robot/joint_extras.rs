//! What joints of robot files have that the engine does not simulate: one list for all formats.

use super::element::Element;
use super::finding::RobotDefect;
use super::model::Follower;
use super::reading::Reading;

/// Why a joint that follows another one with a multiplier of zero has no effect.
const STAYS: &str = "with a multiplier of 0 it would not move: a fixed joint says that";

/// Why bounds of motors have no effect.
pub(super) const OF_MOTORS: &str =
    "it bounds motors, and the joint has none: `joints` of the scene or a program drive it";

/// Why inertia of a rotor has no effect.
pub(super) const ARMATURE: &str = "inertia of rotors is not simulated: joints accelerate more than with it";

/// A joint that follows another one, unless it would not move.
pub(super) fn follower(follower: Follower, element: &Element, reading: &mut Reading) -> Option<Follower> {
    if follower.multiplier == 0.0 {
        reading.ignore(element, "a joint that follows another one", STAYS);
        return None;
    }
    Some(follower)
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
