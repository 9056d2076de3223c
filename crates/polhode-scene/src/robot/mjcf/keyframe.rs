//! `<keyframe>`: states by name.

use super::super::element::Element;
use super::super::finding::RobotDefect;
use super::super::model::{Keyframe, RobotJoint};
use super::super::reading::Reading;

/// Why states of what is not simulated have no effect.
const OF_OTHERS: &str = "no activations and no bodies of motion capture are simulated";

/// The states of a file, whose numbers are as many as those of its joints and its actuators; others are refused.
pub(super) fn read(
    root: &Element,
    (joints, actuators): (&[RobotJoint], usize),
    reading: &mut Reading,
) -> Vec<Keyframe> {
    let sum = |which: usize| joints.iter().map(|joint| joint.kind.sizes()[which]).sum::<usize>();
    let mut keyframes: Vec<Keyframe> = Vec::new();
    for element in root.all("keyframe").flat_map(|keyframe| keyframe.all("key")) {
        let name = element.attribute("name").map_or_else(|| keyframes.len().to_string(), str::to_owned);
        let subject = format!("keyframe `{name}`");
        if keyframes.iter().any(|own| own.name == name) {
            reading.refuse(element, &subject, RobotDefect::DuplicateName("keyframe"));
        }
        for key in ["act", "mpos", "mquat"] {
            if element.attribute(key).is_some() {
                reading.ignore(element, format!("`{key}` of <key>"), OF_OTHERS);
            }
        }
        let mut numbers = |key: &'static str, needed: usize, each: &'static str| {
            let text = element.attribute(key)?;
            let found = text.split_whitespace().count();
            if found != needed {
                reading.refuse(element, &subject, RobotDefect::KeyLength { key, found, needed, each });
                return None;
            }
            // One of no numbers is empty.
            if needed == 0 { Some(Vec::new()) } else { reading.numbers(element, key, needed..=needed, &subject) }
        };
        let coordinates =
            numbers("qpos", sum(0), "seven for a free joint, four for a ball joint, one for a hinge or a slider");
        let rates =
            numbers("qvel", sum(1), "six for a free joint, three for a ball joint, one for a hinge or a slider");
        let controls = numbers("ctrl", actuators, "one for each actuator of the file");
        keyframes.push(Keyframe { name, place: element.place.clone(), coordinates, rates, controls });
    }
    keyframes
}
