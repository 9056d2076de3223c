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
//! | `contacts.box/floor.normal_force` | of the contacts of two bodies, or of one with all others |
//!
//! Quantities and their components are those of plots and tables ([`polhode_scene::quantity`]). A vector without a
//! component is its length. Values are those of the samples of the run; a mean is over them.

use super::error::SweepError;
use polhode::{BodySample, ContactSample, Energy, Event, EventKind, JointSample};
use polhode_scene::{LoadedScene, Quantity};

const ACCEPTED: &str = "bodies.NAME.position[2]@end, max(joints.NAME.torque), energy.kinetic, count(events.impact) or \
     sum(impulse), each with a name of its own as NAME=...";
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
#[derive(Debug, Clone, PartialEq)]
enum Of {
    Quantity(Quantity),
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
            return Ok(Measured::new(Of::Impulse(impacts), function.unwrap_or(When::Sum)));
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
            return Ok(Measured::new(Of::Events(kind), When::Count));
        }
        let when = match (function, at) {
            (Some(_), Some(at)) => return Err(refused(format!("it has a function and `@{at}`: leave one out"))),
            (Some(function), None) => function,
            (None, Some(at)) => when(at)?,
            (None, None) => When::End,
        };
        let quantity = loaded.quantity(quantity).map_err(|error| refused(error.why))?;
        if !quantity.has_length() {
            return Err(refused("the length of a unit quaternion says nothing: [0] to [3] is needed".to_owned()));
        }
        Ok(Measured::new(Of::Quantity(quantity), when))
    }
}

/// Words between commas.
fn words(all: impl IntoIterator<Item = &'static str>) -> String {
    all.into_iter().collect::<Vec<_>>().join(", ")
}

fn kind_of(word: &str) -> Option<EventKind> {
    KINDS.into_iter().find(|kind| kind.word() == word)
}

/// What has been measured of a run so far.
#[derive(Debug, Clone)]
pub(super) struct Measured {
    of: Of,
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
    fn new(of: Of, when: When) -> Self {
        let (least, most) = (f64::INFINITY, f64::NEG_INFINITY);
        let (start, end, sum, count, first_impact_s) = (None, f64::NAN, 0.0, 0, None);
        Self { of, when, start, end, least, most, sum, count, first_impact_s }
    }

    fn quantity(&self) -> Option<&Quantity> {
        if let Of::Quantity(own) = &self.of { Some(own) } else { None }
    }

    pub(super) fn is_of_joints(&self) -> bool {
        self.quantity().is_some_and(Quantity::is_of_joints)
    }

    pub(super) fn is_of_contacts(&self) -> bool {
        self.quantity().is_some_and(Quantity::is_of_contacts)
    }

    pub(super) fn is_of_energy(&self) -> bool {
        self.quantity().is_some_and(Quantity::is_of_energy)
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

    fn note_known(&mut self, value: Option<f64>) {
        if let Some(value) = value {
            self.note(value);
        }
    }

    pub(super) fn sample(&mut self, bodies: &[BodySample]) {
        self.note_known(self.quantity().and_then(|own| own.of_bodies(bodies)));
    }

    pub(super) fn joints(&mut self, joints: &[JointSample]) {
        self.note_known(self.quantity().and_then(|own| own.of_joints(joints)));
    }

    pub(super) fn contacts(&mut self, contacts: &[ContactSample]) {
        if !self.is_of_contacts() {
            return;
        }
        let views: Vec<_> = contacts.iter().map(|own| own.view).collect();
        self.note_known(self.quantity().and_then(|own| own.of_contacts(&views)));
    }

    pub(super) fn energy(&mut self, energy: &Energy) {
        self.note_known(self.quantity().and_then(|own| own.of_energy(energy)));
    }

    pub(super) fn event(&mut self, event: &Event) {
        match &self.of {
            Of::Events(kind) if kind.is_none_or(|kind| kind == event.kind) => self.count += 1,
            Of::Impulse(impacts) if event.kind == EventKind::Impact => {
                let first_s = *self.first_impact_s.get_or_insert(event.t_s);
                if *impacts == Impacts::All || event.t_s == first_s {
                    self.note(event.impulse);
                }
            }
            _ => {}
        }
    }
}
