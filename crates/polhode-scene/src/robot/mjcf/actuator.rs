//! `<actuator>`: motors and servos of joints, in the affine form that they share. Source: docs/REFERENCES.md, MJCF.

use super::super::element::Element;
use super::super::finding::RobotDefect;
use super::super::model::{Actuator, RobotCoordinate};
use super::super::reading::Reading;
use super::body::Bodies;
use super::defaults::Defaults;
use super::general::{NOT_READ, READ};

/// What an actuator may act on, besides joints.
const TRANSMISSIONS: [&str; 6] = ["tendon", "cranksite", "slidersite", "site", "body", "refsite"];

/// The actuators of a file that are simulated, and the names of all.
pub(super) fn read(
    root: &Element,
    (bodies, defaults): (&Bodies<'_>, &Defaults),
    reading: &mut Reading,
) -> (Vec<Actuator>, Vec<String>) {
    let (mut actuators, mut names) = (Vec::new(), Vec::<String>::new());
    for element in root.all("actuator").flat_map(|actuator| &actuator.children) {
        let own = element.attribute("name");
        let name = own.map_or_else(|| format!("actuator_{}", names.len() + 1), str::to_owned);
        if names.contains(&name) {
            reading.refuse(element, format!("actuator `{name}`"), RobotDefect::DuplicateName("actuator"));
        }
        actuators.extend(one(element, &name, (bodies, defaults), reading));
        names.push(name);
    }
    (actuators, names)
}

/// An actuator; none where it is not simulated or refused, which is noted.
fn one(
    element: &Element,
    name: &str,
    (bodies, defaults): (&Bodies<'_>, &Defaults),
    reading: &mut Reading,
) -> Option<Actuator> {
    let subject = format!("actuator `{name}`");
    let left_out = |what: String, reading: &mut Reading| {
        reading.refuse(element, &subject, RobotDefect::ActuatorLeftOut(what));
        None
    };
    if !READ.contains(&element.name.as_str()) {
        let is_known = NOT_READ.contains(&element.name.as_str());
        let kind = if is_known { "of a kind that is not simulated" } else { "of no known kind" };
        return left_out(format!("<{}> is an actuator {kind}", element.name), reading);
    }
    for key in ["kp", "kv", "dampratio", "timeconst"] {
        reading.number(element, key, &subject);
    }
    let full = defaults.actuator(element);
    let coordinate = target(&full, &subject, bodies, reading)?;
    let kinds = [("gaintype", "fixed"), ("biastype", "none")].map(|(key, usual)| full.attribute(key).unwrap_or(usual));
    if let Some(kind) = kinds.iter().find(|kind| !["fixed", "affine", "none"].contains(*kind)) {
        return left_out(format!("its gain or its bias is of the kind \"{kind}\", which is not simulated"), reading);
    }
    match full.attribute("dyntype").unwrap_or("none") {
        "none" => {}
        "filter" | "filterexact" => reading.refuse(element, &subject, RobotDefect::NoFilter),
        other => {
            let what = format!("its activation is of the kind \"{other}\": its effort changes while its control stays");
            return left_out(what, reading);
        }
    }
    let [gain, bias] = [("gainprm", kinds[0]), ("biasprm", kinds[1])]
        .map(|(key, kind)| parameters(&full, (key, kind), &subject, reading));
    let (gain, bias) = (gain?, bias?);
    let gear = reading.numbers(&full, "gear", 1..=6, &subject).map_or(1.0, |numbers| numbers[0]);
    let force_range = range(&full, ["forcerange", "forcelimited"], bodies, &subject, reading);
    let control_range = range(&full, ["ctrlrange", "ctrllimited"], bodies, &subject, reading);
    let inherited = reading.number(&full, "inheritrange", &subject).filter(|share| *share > 0.0);
    let inherited = inherited.zip(coordinate.limits).map(|(share, [lower, upper])| {
        let (middle, half) = (0.5 * (lower + upper), 0.5 * share * (upper - lower));
        [middle - half, middle + half]
    });
    Some(Actuator {
        name: name.to_owned(),
        place: element.place.clone(),
        kind: element.name.clone(),
        joint: coordinate.name.clone(),
        gear,
        gain,
        bias,
        damping_ratio: reading.number(&full, "dampratio", &subject).filter(|ratio| *ratio > 0.0),
        control_range: control_range.or(inherited),
        force_range,
    })
}

/// The coordinate on which an actuator acts.
fn target<'a>(
    full: &Element,
    subject: &str,
    bodies: &'a Bodies<'_>,
    reading: &mut Reading,
) -> Option<&'a RobotCoordinate> {
    let Some(name) = full.attribute("joint").or_else(|| full.attribute("jointinparent")) else {
        match TRANSMISSIONS.iter().find(|key| full.attribute(key).is_some()) {
            Some(key) => {
                let what = format!("it acts on a {key}, and joints alone are driven");
                reading.refuse(full, subject, RobotDefect::ActuatorLeftOut(what));
            }
            None => reading.refuse(full, subject, RobotDefect::MissingAttribute("joint")),
        }
        return None;
    };
    if let Some(coordinate) = bodies.coordinate(name) {
        return Some(coordinate);
    }
    if let Some(kind) = bodies.kind_of(name) {
        let what = format!("joint `{name}` is a {} joint, along which nothing acts", kind.name());
        reading.refuse(full, subject, RobotDefect::ActuatorLeftOut(what));
    } else {
        let known = crate::error::nearest(name, &bodies.coordinate_names(), "none, there are no hinges and no sliders");
        let defect = RobotDefect::UnknownOf { kind: "joint", name: name.to_owned(), known };
        reading.refuse(full, subject, defect);
    }
    None
}

/// The numbers of gain or bias; those that its kind does not use are zero.
fn parameters(full: &Element, (key, kind): (&str, &str), subject: &str, reading: &mut Reading) -> Option<[f64; 3]> {
    let is_gain = key == "gainprm";
    let usual = if is_gain { [1.0, 0.0, 0.0] } else { [0.0; 3] };
    let Some(text) = full.attribute(key) else { return Some(usual) };
    let most = text.split_whitespace().count().max(1);
    let numbers = reading.numbers(full, key, 1..=most, subject)?;
    let number = |index: usize| numbers.get(index).copied().unwrap_or(0.0);
    Some(match (kind == "affine", is_gain) {
        (true, _) => [number(0), number(1), number(2)],
        (false, true) => [number(0), 0.0, 0.0],
        (false, false) => [0.0; 3],
    })
}

/// A range when it holds; none where there is none, or it is refused.
fn range(
    full: &Element,
    [key, limited]: [&'static str; 2],
    bodies: &Bodies<'_>,
    subject: &str,
    reading: &mut Reading,
) -> Option<[f64; 2]> {
    // Zeros, the default of the format, are no range.
    let numbers = reading.numbers(full, key, 2..=2, subject).filter(|numbers| numbers.iter().any(|&own| own != 0.0));
    let limited = full.attribute(limited);
    let Some(numbers) = numbers.filter(|_| limited != Some("false")) else {
        if limited == Some("true") {
            reading.refuse(full, subject, RobotDefect::MissingAttribute(key));
        }
        return None;
    };
    let (lower, upper) = (numbers[0], numbers[1]);
    if lower >= upper {
        reading.refuse(full, subject, RobotDefect::Range { what: key, lower, upper });
        return None;
    }
    (limited == Some("true") || bodies.compiler().automatic_limits).then_some([lower, upper])
}
