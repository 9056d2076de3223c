//! From a text to a quantity of a scene.

use super::list::{
    Along, CAUSES, EFFORTS, OF_BODY, OF_CONTACTS, OF_ENERGY, OF_JOINT, OfBody, OfContacts, OfJoint, accepted,
};
use super::{LETTERS, Of, Quantity};
use crate::error::meant;
use crate::load::LoadedScene;
use polhode::scene::Coordinate;
use polhode::{Body, BodyId, JointId};
use thiserror::Error;

/// Why a text is no quantity of a scene.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error(
    "{text}: {why}; accepted: bodies.NAME.QUANTITY, joints.NAME.QUANTITY, contacts.NAME/OTHER.QUANTITY or \
     QUANTITY:NAME, {list}",
    list = accepted()
)]
pub struct QuantityError {
    /// The text.
    pub text: String,
    /// What is wrong with it.
    pub why: String,
}

/// What the first word of a text says of whom the quantity is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Any,
    Body,
    Joint,
    Contacts,
}

/// Before a name with a point behind it, and before a quantity with a dash.
const KINDS: [(&str, &str, Kind); 3] =
    [("bodies.", "body-", Kind::Body), ("joints.", "joint-", Kind::Joint), ("contacts.", "contact-", Kind::Contacts)];

impl LoadedScene {
    /// A quantity of the scene by its text.
    ///
    /// # Errors
    /// When there is no such quantity, or the scene has no such body, joint or component.
    pub fn quantity(&self, text: &str) -> Result<Quantity, QuantityError> {
        parse(text.trim(), self).map_err(|why| QuantityError { text: text.to_owned(), why })
    }
}

fn parse(text: &str, loaded: &LoadedScene) -> Result<Quantity, String> {
    if let Some(energy) = text.strip_prefix("energy.") {
        let found = OF_ENERGY.iter().find(|own| own.0 == energy);
        let list = OF_ENERGY.map(|own| own.0);
        let (word, of) = *found.ok_or_else(|| format!("`{energy}` is no energy: {}", with_meant(energy, &list)))?;
        return Ok(Quantity { of: Of::Energy(of), component: None, label: format!("{word} energy") });
    }
    let (kind, name, rest) = parts(text)?;
    let (word, component) = component_of(&rest)?;
    let quantity = found(kind, &name, &word, loaded)?;
    let Some(component) = component else { return Ok(quantity) };
    let size = quantity.size();
    let place = place_of(&component, size).ok_or_else(|| match size {
        0 => format!("[{component}]: `{word}` is one number"),
        size => {
            let letters: Vec<String> = LETTERS[usize::from(size == 4)].chars().map(String::from).collect();
            format!("[{component}]: [0] to [{}], or {}", size - 1, letters.join(", "))
        }
    })?;
    Ok(Quantity { component: Some(place), ..quantity })
}

/// Of whom, the name, and the quantity with its component.
fn parts(text: &str) -> Result<(Kind, String, String), String> {
    for (before, _, kind) in KINDS {
        if let Some(rest) = text.strip_prefix(before) {
            let (name, quantity) = split_last(rest).ok_or_else(|| format!("`{text}` names no quantity"))?;
            return Ok((kind, name.to_owned(), quantity.to_owned()));
        }
    }
    if let Some((quantity, name)) = text.split_once(':') {
        for (_, before, kind) in KINDS {
            if let Some(quantity) = quantity.strip_prefix(before) {
                return Ok((kind, name.to_owned(), quantity.to_owned()));
            }
        }
        return Ok((Kind::Any, name.to_owned(), quantity.to_owned()));
    }
    let (name, quantity) = split_last(text).ok_or_else(|| format!("`{text}` names no quantity"))?;
    Ok((Kind::Any, name.to_owned(), quantity.to_owned()))
}

/// A name and what stands behind its last point, with a component behind one more.
fn split_last(text: &str) -> Option<(&str, &str)> {
    let (name, quantity) = text.rsplit_once('.')?;
    if quantity.len() == 1 && LETTERS[1].contains(quantity) {
        let (inner, _) = name.rsplit_once('.')?;
        return Some((inner, &text[inner.len() + 1..]));
    }
    Some((name, quantity))
}

/// A quantity with `_` for `-`, and its component.
fn component_of(text: &str) -> Result<(String, Option<String>), String> {
    let plain = |text: &str| text.replace('-', "_");
    if let Some((before, component)) = text.strip_suffix(']').and_then(|text| text.rsplit_once('[')) {
        return Ok((plain(before), Some(component.trim().to_owned())));
    }
    if let Some((before, component)) = text.rsplit_once('.') {
        return Ok((plain(before), Some(component.to_owned())));
    }
    if text.is_empty() { Err("a quantity is missing".to_owned()) } else { Ok((plain(text), None)) }
}

/// The place of a component, by its number or its letter.
fn place_of(component: &str, size: usize) -> Option<usize> {
    let letters = LETTERS[usize::from(size == 4)];
    let by_letter = letters.find(component).filter(|_| component.len() == 1);
    by_letter.or_else(|| component.parse().ok()).filter(|place| *place < size)
}

fn found(kind: Kind, name: &str, word: &str, loaded: &LoadedScene) -> Result<Quantity, String> {
    let is = |own: Kind| kind == own || kind == Kind::Any;
    let joints = loaded.joint_names();
    let joint = joints.iter().position(|own| own == name).filter(|_| is(Kind::Joint));
    let body = loaded.scene.body_id(name).filter(|_| is(Kind::Body));
    let pair = pair_of(name, loaded).filter(|_| is(Kind::Contacts));
    let quantity = |of: Of, word: &str| Quantity { of, component: None, label: format!("{word} of {name}") };
    if let Some(of) = joint.map(|joint| of_joint(word, JointId::new(joint), loaded)).transpose()?.flatten() {
        return Ok(quantity(of, word));
    }
    if let Some((of, body)) = listed(&OF_BODY, word).zip(body) {
        return Ok(quantity(Of::Body(body, of), word));
    }
    if let Some((of, (a, b))) = listed(&OF_CONTACTS, word).zip(pair) {
        return Ok(quantity(Of::Contacts(a, b, of), word));
    }
    let (what, list): (&str, Vec<&str>) = match (joint, body, pair) {
        (Some(_), ..) => ("joint", joint_words().collect()),
        (_, Some(_), _) if kind != Kind::Contacts => {
            ("body", OF_BODY.iter().map(|own| own.0).chain(OF_CONTACTS.iter().map(|own| own.0)).collect())
        }
        (.., Some(_)) => ("contact", OF_CONTACTS.iter().map(|own| own.0).collect()),
        _ => return Err(no_such(kind, name, &joints, loaded)),
    };
    Err(format!("`{word}` is no quantity of a {what}: {}", with_meant(word, &list)))
}

fn listed<T: Copy>(list: &[(&str, T)], word: &str) -> Option<T> {
    list.iter().find(|(known, _)| *known == word).map(|(_, own)| *own)
}

fn joint_words() -> impl Iterator<Item = &'static str> {
    OF_JOINT.iter().chain(&EFFORTS).map(|own| own.0).chain(CAUSES.map(|own| own.0))
}

/// A quantity of a joint; none of a word that is none of any joint.
///
/// # Errors
/// When the joint does not have the coordinate of it.
fn of_joint(word: &str, joint: JointId, loaded: &LoadedScene) -> Result<Option<Of>, String> {
    let coordinates = loaded.scene.joints().get(joint.index()).map_or(&[][..], |own| own.kind().coordinates());
    let has = |along: Along| coordinates.iter().any(|own| along.is(*own));
    // Without more, what acts along the angle, or along the line of a joint without one.
    let along = if has(Along::Angle) { Along::Angle } else { Along::Line };
    let of = match (listed(&OF_JOINT, word), listed(&EFFORTS, word), listed(&CAUSES, word)) {
        (Some(OfJoint::All(asked)), ..) => {
            let asked = if asked == Along::Line { along } else { asked };
            if is_driven(joint, asked, loaded) { OfJoint::ByDrive(asked) } else { OfJoint::All(asked) }
        }
        (Some(own), ..) | (_, Some(own), _) => own,
        (.., Some(cause)) => OfJoint::Effort(along, cause),
        _ => return Ok(None),
    };
    let needed = match of {
        OfJoint::Value(own) | OfJoint::Rate(own) => coordinates.contains(&own),
        OfJoint::Effort(along, _) | OfJoint::ByDrive(along) | OfJoint::All(along) => has(along),
        _ => true,
    };
    if needed {
        return Ok(Some(Of::Joint(joint, of)));
    }
    let own: Vec<&str> = coordinates.iter().map(|own: &Coordinate| own.name()).collect();
    let own = if own.is_empty() { "it has no coordinate: force and moment".to_owned() } else { own.join(" and ") };
    Err(format!("the joint has no `{word}`: {own}"))
}

/// Whether a motor or a prescribed motion drives a joint along a coordinate.
fn is_driven(joint: JointId, along: Along, loaded: &LoadedScene) -> bool {
    let own = loaded.scene.joints().get(joint.index());
    let by_motor = own.is_some_and(|own| {
        let mut motors = own.kind().coordinates().iter().filter(|coordinate| along.is(**coordinate));
        motors.any(|coordinate| own.freedom(*coordinate).is_some_and(|freedom| freedom.motor().is_some()))
    });
    by_motor || loaded.scene.driven_coordinates().any(|(driven, own)| driven == joint && along.is(own))
}

/// The bodies of contacts, as `A/B`, or of those of one body.
fn pair_of(name: &str, loaded: &LoadedScene) -> Option<(BodyId, Option<BodyId>)> {
    if let Some(one) = loaded.scene.body_id(name) {
        return Some((one, None));
    }
    let mut places = name.match_indices('/').map(|(place, _)| place);
    places.find_map(|at| Some((loaded.scene.body_id(&name[..at])?, Some(loaded.scene.body_id(&name[at + 1..])?))))
}

/// That a scene has nothing of this name, with what it has.
fn no_such(kind: Kind, name: &str, joints: &[String], loaded: &LoadedScene) -> String {
    let bodies = loaded.scene.bodies().iter().map(Body::name);
    let (what, names): (&str, Vec<&str>) = match kind {
        Kind::Body => ("body", bodies.collect()),
        Kind::Joint => ("joint", joints.iter().map(String::as_str).collect()),
        Kind::Contacts => ("body, or two as A/B,", bodies.collect()),
        Kind::Any => ("body or joint", bodies.chain(joints.iter().map(String::as_str)).collect()),
    };
    if names.is_empty() {
        return format!("the scene has no {what} at all");
    }
    format!("the scene has no {what} `{name}`: {}", with_meant(name, &names))
}

/// What of a list was meant by a word, and the list.
fn with_meant(word: &str, list: &[&str]) -> String {
    let quoted = format!("`{}`", list.join("``"));
    let meant = meant(word, &quoted);
    let shown = list.iter().take(LONGEST_LIST).copied().collect::<Vec<_>>().join(", ");
    let more = list.len().saturating_sub(LONGEST_LIST);
    if more > 0 { format!("{meant}{shown} and {more} more") } else { format!("{meant}{shown}") }
}

/// Longest list of names in a message: more do not help.
const LONGEST_LIST: usize = 40;

impl Quantity {
    /// Whether its length is a number that says something: not that of an orientation.
    pub fn has_length(&self) -> bool {
        !matches!(self.of, Of::Body(_, OfBody::Orientation)) || self.component.is_some()
    }

    /// Whether it is of contacts.
    pub const fn is_of_contacts(&self) -> bool {
        matches!(self.of, Of::Contacts(..))
    }

    /// Whether it is of a joint.
    pub const fn is_of_joints(&self) -> bool {
        matches!(self.of, Of::Joint(..))
    }

    /// Whether it is an energy.
    pub const fn is_of_energy(&self) -> bool {
        matches!(self.of, Of::Energy(_))
    }

    /// Whether it counts something.
    pub const fn is_count(&self) -> bool {
        matches!(self.of, Of::Contacts(.., OfContacts::Points))
    }
}
