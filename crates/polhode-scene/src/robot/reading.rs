//! Reading attributes: each fault is noted with its place, and reading goes on, so that all of them are told at once.

use super::element::Element;
use super::finding::{Findings, RobotDefect, RobotPlace};
use glam::{DQuat, DVec3};
use polhode::spatial::{Rotation, UnitVector};
use std::collections::BTreeMap;
use std::ops::RangeInclusive;

/// Longest part of an attribute that a message shows, characters.
const LONGEST_SHOWN: usize = 60;

/// What is found while a file is read.
#[derive(Debug, Default)]
pub(super) struct Reading {
    /// What was found.
    pub(super) findings: Findings,
    /// What has no effect, by its words: where first, how often, and why.
    ignored: BTreeMap<String, Ignored>,
    /// Whether a joint is refused, so that its links hang at nothing.
    pub(super) has_lost: bool,
    /// Whether an axis or a mass is refused, and what was put in its place says nothing of the robot.
    pub(super) has_guess: bool,
}

#[derive(Debug)]
struct Ignored {
    place: RobotPlace,
    count: usize,
    why: &'static str,
}

impl Reading {
    /// Notes what is wrong with an element.
    pub(super) fn refuse(&mut self, element: &Element, subject: impl Into<String>, defect: RobotDefect) {
        self.findings.add(&element.place, subject, defect);
    }

    /// Notes that something of an element has no effect.
    pub(super) fn ignore(&mut self, element: &Element, what: impl Into<String>, why: &'static str) {
        let ignored = Ignored { place: element.place.clone(), count: 0, why };
        self.ignored.entry(what.into()).or_insert(ignored).count += 1;
    }

    /// Notes all elements in one but those of these names.
    pub(super) fn ignore_others(&mut self, element: &Element, known: &[&str], why: &'static str) {
        for child in element.children.iter().filter(|child| !known.contains(&child.name.as_str())) {
            self.ignore(child, format!("<{}> of <{}>", child.name, element.name), why);
        }
    }

    /// All that was found.
    pub(super) fn finish(mut self) -> Findings {
        for (what, Ignored { place, count, why }) in self.ignored {
            self.findings.add(&place, "robot", RobotDefect::Ignored { what, count, why });
        }
        self.findings
    }

    /// The numbers of an attribute, if it is there, when there are as many as are accepted and all are finite.
    pub(super) fn numbers(
        &mut self,
        element: &Element,
        attribute: &str,
        accepted: RangeInclusive<usize>,
        subject: &str,
    ) -> Option<Vec<f64>> {
        let text = element.attribute(attribute)?;
        let number = |word: &str| word.parse::<f64>().ok().filter(|number| number.is_finite());
        let numbers: Option<Vec<f64>> = text.split_whitespace().map(number).collect();
        let numbers = numbers.filter(|numbers| accepted.contains(&numbers.len()));
        if numbers.is_none() {
            let accepted = match (accepted.start(), accepted.end()) {
                (1, 1) => "a finite number".to_owned(),
                (least, most) if least == most => format!("{most} finite numbers"),
                (least, most) => format!("{least} to {most} finite numbers"),
            };
            let (attribute, value) = (attribute.to_owned(), text.chars().take(LONGEST_SHOWN).collect());
            self.refuse(element, subject, RobotDefect::Numbers { attribute, value, accepted });
        }
        numbers
    }

    /// A number of an attribute, if it is there.
    pub(super) fn number(&mut self, element: &Element, attribute: &str, subject: &str) -> Option<f64> {
        self.numbers(element, attribute, 1..=1, subject).and_then(|numbers| numbers.first().copied())
    }

    /// A number of an attribute that must be there.
    pub(super) fn needed(&mut self, element: &Element, attribute: &'static str, subject: &str) -> Option<f64> {
        if element.attribute(attribute).is_none() {
            self.refuse(element, subject, RobotDefect::MissingAttribute(attribute));
        }
        self.number(element, attribute, subject)
    }

    /// Three numbers of an attribute, if it is there.
    pub(super) fn vector(&mut self, element: &Element, attribute: &str, subject: &str) -> Option<DVec3> {
        self.numbers(element, attribute, 3..=3, subject).map(|numbers| DVec3::from_slice(&numbers))
    }

    /// A size, when it is positive, m.
    pub(super) fn size(&mut self, element: &Element, what: &'static str, value: f64, subject: &str) -> Option<f64> {
        if value > 0.0 && value.is_finite() {
            return Some(value);
        }
        self.refuse(element, subject, RobotDefect::Size { what, value });
        None
    }

    /// Notes a word that is not among those accepted.
    pub(super) fn refuse_word(
        &mut self,
        element: &Element,
        attribute: &'static str,
        value: &str,
        accepted: &'static str,
    ) {
        let value = value.chars().take(LONGEST_SHOWN).collect();
        self.refuse(element, format!("<{}>", element.name), RobotDefect::Word { attribute, value, accepted });
    }

    /// The direction of a vector.
    pub(super) fn direction(&mut self, element: &Element, vector: DVec3, subject: &str) -> Option<UnitVector> {
        let direction = UnitVector::new(vector).ok();
        if direction.is_none() {
            self.refuse(element, subject, RobotDefect::Axis(vector));
        }
        direction
    }

    /// The direction of an axis; some direction of one that has none, which is noted, so that what else is wrong with
    /// its joint is found.
    pub(super) fn axis(&mut self, element: &Element, vector: DVec3, subject: &str) -> UnitVector {
        self.direction(element, vector, subject).unwrap_or_else(|| {
            self.has_guess = true;
            UnitVector::X
        })
    }
}

/// Rotation by an angle (rad) about an axis of length one.
pub(super) fn turned(axis: DVec3, angle: f64) -> Rotation {
    let half = 0.5 * angle;
    let vector = axis * libm::sin(half);
    Rotation::renormalized(DQuat::from_xyzw(vector.x, vector.y, vector.z, libm::cos(half)))
}
