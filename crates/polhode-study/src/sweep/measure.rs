//! What a sweep measures of a run.
//!
//! | form | is |
//! |---|---|
//! | `bodies.box.position[2]@end` | of a body at the end of the run; also `@start`, `@least`, `@most`, `@mean` |
//! | `max(joints.crank.torque)` | the same as `@most`; also `min`, `mean`, `first`, `last`, `sum` |
//! | `energy.kinetic` | an energy of the whole scene; without more at the end |
//! | `count(events.impact)` | how many events of a kind there were; of all kinds by `events` |
//! | `sum(impulse)`, `max(impulse)` | of the normal impulses of impacts, N s |
//! | `sum(impulse@first)` | of those at the time of the first |
//!
//! Quantities of bodies are `position`, `orientation` (w, x, y, z), `velocity`, `angular_velocity`; of joints `angle`,
//! `displacement`, `distance`, their `_rate`, `power`, and what they do to their first body, `force` and `torque`. A
//! vector without a number in brackets is its length. Values are those of the samples of the run; a mean is over them.

use super::error::SweepError;
use polhode::scene::Coordinate;
use polhode::spatial::DVec3;
use polhode::{BodySample, Energy, Event, EventKind, JointSample};
use polhode_scene::LoadedScene;

const ACCEPTED: &str = "bodies.NAME.position[2]@end, max(joints.NAME.torque), energy.kinetic, count(events.impact) or \
     sum(impulse), each with a name of its own as NAME=...";
const OF_BODY: [(&str, OfBody, usize); 4] = [
    ("position", OfBody::Position, 3),
    ("orientation", OfBody::Orientation, 4),
    ("velocity", OfBody::Velocity, 3),
    ("angular_velocity", OfBody::AngularVelocity, 3),
];
const OF_JOINT: [(&str, OfJoint, usize); 9] = [
    ("angle", OfJoint::Value(Coordinate::Angle), 0),
    ("angle_rate", OfJoint::Rate(Coordinate::Angle), 0),
    ("displacement", OfJoint::Value(Coordinate::Displacement), 0),
    ("displacement_rate", OfJoint::Rate(Coordinate::Displacement), 0),
    ("distance", OfJoint::Value(Coordinate::Distance), 0),
    ("distance_rate", OfJoint::Rate(Coordinate::Distance), 0),
    ("power", OfJoint::Power, 0),
    ("force", OfJoint::Force, 3),
    ("torque", OfJoint::Torque, 3),
];
const OF_ENERGY: [(&str, OfEnergy, usize); 3] =
    [("kinetic", OfEnergy::Kinetic, 0), ("potential", OfEnergy::Potential, 0), ("total", OfEnergy::Total, 0)];
const KINDS: [EventKind; 10] = [
    EventKind::Impact,
    EventKind::ContactBegin,
    EventKind::ContactEnd,
    EventKind::Rest,
    EventKind::Wake,
    EventKind::Detach,
    EventKind::Stick,
    EventKind::Slide,
    EventKind::Jam,
    EventKind::Break,
];
const WHEN: [(&str, When); 11] = [
    ("end", When::End),
    ("last", When::End),
    ("start", When::Start),
    ("first", When::Start),
    ("least", When::Least),
    ("min", When::Least),
    ("most", When::Most),
    ("max", When::Most),
    ("mean", When::Mean),
    ("sum", When::Sum),
    ("count", When::Count),
];

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum OfBody {
    Position,
    Orientation,
    Velocity,
    AngularVelocity,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum OfJoint {
    Value(Coordinate),
    Rate(Coordinate),
    Power,
    Force,
    Torque,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum OfEnergy {
    Kinetic,
    Potential,
    Total,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum When {
    Start,
    End,
    Least,
    Most,
    Mean,
    Sum,
    Count,
}

/// What a quantity is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Of {
    Body(usize, OfBody),
    Joint(usize, OfJoint),
    Energy(OfEnergy),
    Events(Option<EventKind>),
    Impulse(Impacts),
}

/// Which impacts count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Impacts {
    All,
    /// Those at the time of the first.
    First,
}

/// A measure, as it is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Measure {
    /// The name of its column.
    pub column: String,
    text: String,
}

impl Measure {
    /// From `EXPR` or `NAME=EXPR`; that the scene has what it names is found by [`Sweep::check`](super::Sweep::check).
    pub fn parse(text: &str) -> Self {
        let (column, own) = text.split_once('=').unwrap_or((text, text));
        Self { column: column.trim().to_owned(), text: own.trim().to_owned() }
    }

    /// The same in a scene.
    ///
    /// # Errors
    /// When it has no such form, or the scene has no such thing.
    pub(super) fn of_scene(&self, loaded: &LoadedScene) -> Result<Measured, SweepError> {
        let refused = |why: String| SweepError::Measure { text: self.text.clone(), why, accepted: ACCEPTED };
        let when = |word: &str| {
            let found = WHEN.iter().find(|(name, _)| *name == word).map(|(_, when)| *when);
            found.ok_or_else(|| {
                refused(format!("`{word}` is no part of a run: {}", words(WHEN.iter().map(|own| own.0))))
            })
        };
        let (function, inner) = match self.text.strip_suffix(')').and_then(|text| text.split_once('(')) {
            Some((function, inner)) => (Some(when(function.trim())?), inner.trim()),
            None => (None, self.text.as_str()),
        };
        let (quantity, at) = inner.split_once('@').map_or((inner, None), |(quantity, at)| (quantity, Some(at)));
        if quantity == "impulse" {
            let impacts = match at {
                None => Impacts::All,
                Some("first") => Impacts::First,
                Some(other) => return Err(refused(format!("`@{other}`: of impulses there are all, and those @first"))),
            };
            return Ok(Measured::new(Of::Impulse(impacts), None, function.unwrap_or(When::Sum)));
        }
        if let Some(kind) = quantity.strip_prefix("events") {
            let kind = match kind.strip_prefix('.') {
                None if kind.is_empty() => None,
                kind => Some(kind_of(kind.unwrap_or_default()).ok_or_else(|| {
                    refused(format!("`{quantity}` is no kind of event: {}", words(KINDS.map(EventKind::word))))
                })?),
            };
            if !matches!(function, None | Some(When::Count)) || at.is_some() {
                return Err(refused("events are counted: count(events.impact)".to_owned()));
            }
            return Ok(Measured::new(Of::Events(kind), None, When::Count));
        }
        let when = match (function, at) {
            (Some(_), Some(at)) => return Err(refused(format!("it has a function and `@{at}`: leave one out"))),
            (Some(function), None) => function,
            (None, Some(at)) => when(at)?,
            (None, None) => When::End,
        };
        let (quantity, component) = component_of(quantity).map_err(&refused)?;
        let (of, size) = owner(quantity, loaded).map_err(&refused)?;
        match component {
            Some(component) if component >= size => {
                let limit = if size == 0 { "it is one number".to_owned() } else { format!("[0] to [{}]", size - 1) };
                Err(refused(format!("[{component}]: {limit}")))
            }
            None if matches!(of, Of::Body(_, OfBody::Orientation)) => {
                Err(refused("the length of a unit quaternion says nothing: [0] to [3] is needed".to_owned()))
            }
            component => Ok(Measured::new(of, component, when)),
        }
    }
}

/// Words between commas.
fn words(all: impl IntoIterator<Item = &'static str>) -> String {
    all.into_iter().collect::<Vec<_>>().join(", ")
}

fn kind_of(word: &str) -> Option<EventKind> {
    KINDS.into_iter().find(|kind| kind.word() == word)
}

/// The number in the brackets at the end, and what stands before.
fn component_of(text: &str) -> Result<(&str, Option<usize>), String> {
    let Some((before, number)) = text.strip_suffix(']').and_then(|text| text.rsplit_once('[')) else {
        return Ok((text, None));
    };
    let number = number.parse().map_err(|_| format!("[{number}] is no whole number"))?;
    Ok((before, Some(number)))
}

/// What a quantity without brackets is of, and how many numbers it has; 0 for one that is no vector.
fn owner(text: &str, loaded: &LoadedScene) -> Result<(Of, usize), String> {
    let (name, quantity) = text.rsplit_once('.').ok_or_else(|| format!("`{text}` names no quantity"))?;
    let find = |list: &[(&'static str, usize)]| list.iter().position(|(known, _)| *known == quantity);
    let sizes = |list: &[(&'static str, usize)]| words(list.iter().map(|own| own.0));
    if name == "energy" {
        let known = OF_ENERGY.map(|own| (own.0, own.2));
        let place = find(&known).ok_or_else(|| format!("`{quantity}` is no energy: {}", sizes(&known)))?;
        return Ok((Of::Energy(OF_ENERGY[place].1), 0));
    }
    let body = |name: &str| loaded.scene.body_id(name).map(polhode::BodyId::index);
    let joints = loaded.joint_names();
    let joint = |name: &str| joints.iter().position(|known| known == name);
    let (of_bodies, of_joints) = (name.strip_prefix("bodies."), name.strip_prefix("joints."));
    if let Some(body) = body(of_bodies.unwrap_or(name)).filter(|_| of_joints.is_none()) {
        let known = OF_BODY.map(|own| (own.0, own.2));
        let place = find(&known).ok_or_else(|| format!("`{quantity}` is no quantity of a body: {}", sizes(&known)))?;
        return Ok((Of::Body(body, OF_BODY[place].1), OF_BODY[place].2));
    }
    if let Some(joint) = joint(of_joints.unwrap_or(name)).filter(|_| of_bodies.is_none()) {
        let known = OF_JOINT.map(|own| (own.0, own.2));
        let place = find(&known).ok_or_else(|| format!("`{quantity}` is no quantity of a joint: {}", sizes(&known)))?;
        return Ok((Of::Joint(joint, OF_JOINT[place].1), OF_JOINT[place].2));
    }
    let bodies: Vec<&str> = loaded.scene.bodies().iter().map(polhode::Body::name).collect();
    let all: Vec<&str> = bodies.into_iter().chain(joints.iter().map(String::as_str)).collect();
    Err(format!("the scene has no body or joint `{name}`: it has {}", all.join(", ")))
}

/// What has been measured of a run so far.
#[derive(Debug, Clone)]
pub(super) struct Measured {
    of: Of,
    component: Option<usize>,
    when: When,
    start: Option<f64>,
    end: f64,
    least: f64,
    most: f64,
    sum: f64,
    count: u64,
    /// When the first impact was, s.
    first_impact_s: Option<f64>,
}

impl Measured {
    fn new(of: Of, component: Option<usize>, when: When) -> Self {
        let (least, most) = (f64::INFINITY, f64::NEG_INFINITY);
        let (start, end, sum, count, first_impact_s) = (None, f64::NAN, 0.0, 0, None);
        Self { of, component, when, start, end, least, most, sum, count, first_impact_s }
    }

    pub(super) fn is_of_joints(&self) -> bool {
        matches!(self.of, Of::Joint(..))
    }

    pub(super) fn is_of_energy(&self) -> bool {
        matches!(self.of, Of::Energy(_))
    }

    /// What was asked for; NaN where there is none.
    pub(super) fn value(&self) -> f64 {
        let of_any = |value: f64| if self.count > 0 { value } else { f64::NAN };
        match self.when {
            When::Start => self.start.unwrap_or(f64::NAN),
            When::End => self.end,
            When::Least => of_any(self.least),
            When::Most => of_any(self.most),
            When::Mean => self.sum / self.count as f64,
            When::Sum => self.sum,
            When::Count => self.count as f64,
        }
    }

    fn note(&mut self, value: f64) {
        self.start.get_or_insert(value);
        self.end = value;
        // What is not known once is not known at all.
        let of_known = |kept: f64, better: f64| if value.is_nan() || kept.is_nan() { f64::NAN } else { better };
        self.least = of_known(self.least, self.least.min(value));
        self.most = of_known(self.most, self.most.max(value));
        self.sum += value;
        self.count += 1;
    }

    fn note_vector(&mut self, vector: DVec3) {
        let value = match self.component {
            Some(component) => vector[component.min(2)],
            None => vector.length(),
        };
        self.note(value);
    }

    pub(super) fn sample(&mut self, bodies: &[BodySample]) {
        let Of::Body(body, quantity) = self.of else { return };
        let Some(sample) = bodies.get(body) else { return };
        match quantity {
            OfBody::Position => self.note_vector(sample.pose.translation),
            OfBody::Velocity => self.note_vector(sample.velocity.linear),
            OfBody::AngularVelocity => self.note_vector(sample.velocity.angular),
            OfBody::Orientation => {
                let own = sample.pose.rotation.quaternion();
                self.note([own.w, own.x, own.y, own.z][self.component.unwrap_or(0).min(3)]);
            }
        }
    }

    pub(super) fn joints(&mut self, joints: &[JointSample]) {
        let Of::Joint(joint, quantity) = self.of else { return };
        let Some(sample) = joints.iter().find(|own| own.joint.index() == joint) else { return };
        let of = |coordinate: Coordinate| sample.coordinates.iter().find(|own| own.0 == coordinate).map(|own| own.1);
        match quantity {
            OfJoint::Value(coordinate) => self.note(of(coordinate).map_or(f64::NAN, |own| own.value)),
            OfJoint::Rate(coordinate) => self.note(of(coordinate).map_or(f64::NAN, |own| own.rate)),
            OfJoint::Power => self.note(sample.power_w.unwrap_or(f64::NAN)),
            OfJoint::Force => self.note_vector(sample.load.map_or(DVec3::NAN, |load| load.force_n)),
            OfJoint::Torque => self.note_vector(sample.load.map_or(DVec3::NAN, |load| load.moment_n_m)),
        }
    }

    pub(super) fn energy(&mut self, energy: &Energy) {
        match self.of {
            Of::Energy(OfEnergy::Kinetic) => self.note(energy.kinetic_j),
            Of::Energy(OfEnergy::Potential) => self.note(energy.potential_j),
            Of::Energy(OfEnergy::Total) => self.note(energy.final_j),
            _ => {}
        }
    }

    pub(super) fn event(&mut self, event: &Event) {
        match self.of {
            Of::Events(kind) if kind.is_none_or(|kind| kind == event.kind) => self.count += 1,
            Of::Impulse(impacts) if event.kind == EventKind::Impact => {
                let first_s = *self.first_impact_s.get_or_insert(event.t_s);
                if impacts == Impacts::All || event.t_s == first_s {
                    self.note(event.impulse);
                }
            }
            _ => {}
        }
    }
}
