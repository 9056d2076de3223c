//! `<joint>` and `<freejoint>`.

use super::super::element::Element;
use super::super::finding::RobotDefect;
use super::super::joint_extras::{self, ARMATURE};
use super::super::model::{EffortLimit, RobotCoordinate, RobotJointKind};
use super::super::reading::Reading;
use super::compiler::Compiler;
use glam::DVec3;

/// Kinds of joint, for messages.
const KINDS: &str = "free, ball, slide or hinge";

/// Why limits of a ball joint have no effect.
const OF_BALLS: &str = "ball joints have no limits, springs, dampers or friction";

/// A joint in the frame of its body.
#[derive(Debug, Clone)]
pub(super) struct BodyJoint {
    /// Its name.
    pub(super) name: String,
    /// What it leaves free.
    pub(super) kind: RobotJointKind,
    /// The point that stays, m.
    pub(super) anchor: DVec3,
    /// What acts along its coordinate.
    pub(super) coordinates: Vec<RobotCoordinate>,
}

/// The joint of an element that has the attributes of its class; `name` when it has none of its own.
pub(super) fn read(element: &Element, compiler: &Compiler, name: String, reading: &mut Reading) -> Option<BodyJoint> {
    let name = element.attribute("name").map_or(name, str::to_owned);
    let subject = format!("joint `{name}`");
    let anchor = reading.vector(element, "pos", &subject).unwrap_or_default();
    extras(element, reading);
    let kind = match (element.name.as_str(), element.attribute("type").unwrap_or("hinge")) {
        ("freejoint", _) | (_, "free") => RobotJointKind::Free,
        (_, "ball") => {
            let range = ["range", "stiffness", "damping", "frictionloss"]
                .into_iter()
                .find(|key| element.attribute(key).is_some());
            if let Some(key) = range {
                reading.ignore(element, format!("`{key}` of ball joints"), OF_BALLS);
            }
            RobotJointKind::Ball
        }
        (_, kind @ ("hinge" | "slide")) => {
            let axis = reading.vector(element, "axis", &subject).unwrap_or(DVec3::Z);
            let axis = reading.axis(element, axis, &subject);
            if kind == "hinge" { RobotJointKind::Hinge { axis } } else { RobotJointKind::Slider { axis } }
        }
        (_, other) => {
            reading.refuse_word(element, "type", other, KINDS);
            return None;
        }
    };
    if matches!(kind, RobotJointKind::Free | RobotJointKind::Ball) {
        return Some(BodyJoint { name, kind, anchor, coordinates: Vec::new() });
    }
    let is_angle = matches!(kind, RobotJointKind::Hinge { .. });
    let in_si = |value: f64| if is_angle { compiler.radians(value) } else { value };
    let limits = limits(element, compiler, &subject, reading).map(|limits| limits.map(in_si));
    let mut constant = |key: &'static str| {
        // Later numbers are coefficients of higher powers.
        let value = reading.numbers(element, key, 1..=8, &subject).map_or(0.0, |numbers| numbers[0]);
        joint_extras::not_negative(element, key, value, &subject, reading).unwrap_or(0.0)
    };
    let [damping, stiffness, friction] = ["damping", "stiffness", "frictionloss"].map(&mut constant);
    let mut value = |key: &'static str| in_si(reading.number(element, key, &subject).unwrap_or(0.0));
    let (reference, rest) = (value("ref"), value("springref"));
    let effort_limit = effort_limit(element, &subject, reading);
    let place = element.place.clone();
    let coordinate = RobotCoordinate {
        name: name.clone(),
        place,
        reference,
        limits,
        damping,
        friction,
        stiffness,
        rest,
        effort_limit,
    };
    Some(BodyJoint { name, kind, anchor, coordinates: vec![coordinate] })
}

/// The limits of a joint in the units of the file.
fn limits(element: &Element, compiler: &Compiler, subject: &str, reading: &mut Reading) -> Option<[f64; 2]> {
    let range = reading.numbers(element, "range", 2..=2, subject);
    let is_limited = match element.attribute("limited") {
        Some("true") => true,
        Some("false") => false,
        _ => compiler.automatic_limits && range.is_some(),
    };
    if !is_limited {
        return None;
    }
    let Some(range) = range else {
        reading.refuse(element, subject, RobotDefect::MissingAttribute("range"));
        return None;
    };
    let (lower, upper) = (range[0], range[1]);
    if lower < upper {
        return Some([lower, upper]);
    }
    reading.refuse(element, subject, RobotDefect::Limits { lower, upper });
    None
}

/// The largest effort of all motors of a joint.
fn effort_limit(element: &Element, subject: &str, reading: &mut Reading) -> Option<EffortLimit> {
    let what = "actuatorfrcrange";
    let range = reading.numbers(element, what, 2..=2, subject)?;
    let (lower, upper) = (range[0], range[1]);
    if element.attribute("actuatorfrclimited") == Some("false") {
        return None;
    }
    if lower >= upper {
        reading.refuse(element, subject, RobotDefect::Range { what, lower, upper });
        return None;
    }
    let most = joint_extras::to_both_sides([lower, upper], element, subject, reading);
    Some(EffortLimit { place: element.place.clone(), what: "`actuatorfrcrange` of <joint>", most })
}

/// Why constants of soft limits have no effect.
const OF_LIMITS: &str = "limits and dry friction are rigid here";

/// Why damping that is no constant has no effect.
const OF_POWERS: &str = "dampers are linear: the first number is kept";

/// What the joint has that has no effect.
fn extras(element: &Element, reading: &mut Reading) {
    for name in ["solreflimit", "solimplimit", "solreffriction", "solimpfriction", "margin"] {
        if element.attribute(name).is_some() {
            reading.ignore(element, format!("`{name}` of <joint>"), OF_LIMITS);
        }
    }
    for name in ["damping", "stiffness"] {
        let numbers = element.attribute(name).unwrap_or_default().split_whitespace().skip(1);
        if numbers.into_iter().any(|word| word.parse() != Ok(0.0)) {
            reading.ignore(element, format!("higher powers of `{name}` of <joint>"), OF_POWERS);
        }
    }
    let of_joints = [
        ("armature", ARMATURE),
        ("springdamper", "springs are given by `stiffness`"),
        ("actuatorgravcomp", "gravity is not compensated"),
    ];
    for (name, why) in of_joints {
        if element.attribute(name).is_some_and(|text| text.trim() != "false" && text.trim().parse() != Ok(0.0)) {
            reading.ignore(element, format!("`{name}` of <joint>"), why);
        }
    }
}
