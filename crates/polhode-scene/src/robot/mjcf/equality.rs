//! `<equality>` and `<contact>`: what closes loops, and which bodies do not collide.

use super::super::element::Element;
use super::super::finding::RobotDefect;
use super::super::model::{Closure, ClosureKind, Follower};
use super::super::reading::Reading;
use super::body::Bodies;
use super::defaults::Defaults;
use super::frame;
use polhode::spatial::Pose;

/// Why a joint that a polynomial holds has no effect.
const NO_GEAR: &str = "joints follow others in proportion alone: no powers of `polycoef` above the first are simulated";

/// What couples links besides joints.
pub(super) struct Couplings {
    pub(super) loops: Vec<Closure>,
    pub(super) followers: Vec<Follower>,
    /// Pairs that do not collide.
    pub(super) apart: Vec<[usize; 2]>,
}

/// Loops, coordinates that follow others, and pairs that do not collide.
pub(super) fn read(root: &Element, bodies: &Bodies<'_>, defaults: &Defaults, reading: &mut Reading) -> Couplings {
    let (mut loops, mut followers) = (Vec::new(), Vec::new());
    for element in root.all("equality").flat_map(|equality| &equality.children) {
        let full = defaults.applied(element, None);
        if full.attribute("active") == Some("false") {
            reading.ignore(element, format!("<{}> that is not active", element.name), "it holds nothing");
            continue;
        }
        match element.name.as_str() {
            "connect" => loops.extend(closure(&full, ClosureKind::Point, bodies, loops.len(), reading)),
            "weld" => loops.extend(closure(&full, ClosureKind::Weld, bodies, loops.len(), reading)),
            "joint" => followers.extend(follower(&full, bodies, reading)),
            _ => reading.ignore(element, format!("<{}> of <equality>", element.name), "it is not simulated"),
        }
    }
    let mut apart = Vec::new();
    for element in root.all("contact").flat_map(|contact| &contact.children) {
        if element.name != "exclude" {
            reading.ignore(element, format!("<{}> of <contact>", element.name), "bodies collide by their shapes");
            continue;
        }
        let pair = ["body1", "body2"].map(|key| link(element, key, bodies, "exclude", reading));
        if let [Some(a), Some(b)] = pair {
            apart.push([a, b]);
        }
    }
    Couplings { loops, followers, apart }
}

/// A joint whose value is a polynomial of that of another one, both from their reference values.
fn follower(element: &Element, bodies: &Bodies<'_>, reading: &mut Reading) -> Option<Follower> {
    let Some(name) = element.attribute("joint1") else {
        reading.refuse(element, "<joint> of <equality>", RobotDefect::MissingAttribute("joint1"));
        return None;
    };
    let subject = format!("joint `{name}`");
    let powers = reading.numbers(element, "polycoef", 1..=5, &subject).unwrap_or_else(|| vec![0.0, 1.0]);
    let second = element.attribute("joint2");
    if second.is_some() && powers.iter().skip(2).any(|&power| power != 0.0) {
        reading.ignore(element, "<joint> of <equality>", NO_GEAR);
        return None;
    }
    // One joint alone is held where the polynomial begins.
    let leader = second.unwrap_or(name);
    let mut reference = |name: &str| {
        let found = bodies.coordinate(name).map(|own| own.reference);
        if found.is_none() {
            reading.refuse(element, &subject, RobotDefect::UnknownName { kind: "joint", name: name.to_owned() });
        }
        found
    };
    let (own, other) = (reference(name)?, reference(leader)?);
    let multiplier = if second.is_none() { 0.0 } else { powers.get(1).copied().unwrap_or(1.0) };
    let offset = own + powers[0] - multiplier * other;
    let (place, name, leader) = (element.place.clone(), name.to_owned(), leader.to_owned());
    Some(Follower { place, name, leader, multiplier, offset })
}

/// The link of the body that an attribute names.
fn link(
    element: &Element,
    key: &'static str,
    bodies: &Bodies<'_>,
    subject: &str,
    reading: &mut Reading,
) -> Option<usize> {
    let Some(name) = element.attribute(key) else {
        reading.refuse(element, subject, RobotDefect::MissingAttribute(key));
        return None;
    };
    let found = bodies.link(name);
    if found.is_none() {
        reading.refuse(element, subject, RobotDefect::UnknownName { kind: "body", name: name.to_owned() });
    }
    found
}

/// A point or a pose that two bodies share.
fn closure(
    element: &Element,
    kind: ClosureKind,
    bodies: &Bodies<'_>,
    number: usize,
    reading: &mut Reading,
) -> Option<Closure> {
    let name = element.attribute("name").map_or_else(|| format!("{}_{}", element.name, number + 1), str::to_owned);
    let subject = format!("loop `{name}`");
    let place = element.place.clone();
    if element.attribute("site1").is_some() {
        let mut site = |key: &'static str| {
            let own = element.attribute(key).unwrap_or_default();
            let found = bodies.site(own);
            if found.is_none() {
                reading.refuse(element, &subject, RobotDefect::UnknownName { kind: "site", name: own.to_owned() });
            }
            found
        };
        let ((a, in_a), (b, in_b)) = (site("site1")?, site("site2")?);
        return Some(Closure { name, place, links: [a, b], frames: [Some(in_a), Some(in_b)], kind });
    }
    let a = link(element, "body1", bodies, &subject, reading)?;
    let b = match element.attribute("body2") {
        None => 0,
        Some(_) => link(element, "body2", bodies, &subject, reading)?,
    };
    let frames = match kind {
        ClosureKind::Point => {
            let anchor = reading.vector(element, "anchor", &subject)?;
            [Some(Pose::from_translation(anchor)), None]
        }
        ClosureKind::Weld => weld_frames(element, bodies, &subject, reading),
    };
    Some(Closure { name, place, links: [a, b], frames, kind })
}

/// The frames of a weld: the second body in the first, when the file gives it, else as they are at the reference
/// values.
fn weld_frames(element: &Element, bodies: &Bodies<'_>, subject: &str, reading: &mut Reading) -> [Option<Pose>; 2] {
    let Some(numbers) = reading.numbers(element, "relpose", 7..=7, subject) else { return [None, None] };
    // A quaternion of zeros, the default, means the reference values.
    if numbers[3..].iter().all(|&number| number == 0.0) {
        return [None, None];
    }
    let mut turned = element.clone();
    let words: Vec<String> = numbers[3..].iter().map(|number| format!("{number:?}")).collect();
    turned.set_default("quat", &words.join(" "));
    let rotation = frame::orientation(&turned, bodies.compiler(), subject, reading);
    [Some(Pose::new(rotation, glam::DVec3::from_slice(&numbers))), Some(Pose::IDENTITY)]
}
