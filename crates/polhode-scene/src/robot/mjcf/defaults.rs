//! `<default>`: attributes that elements have unless they say otherwise, by classes that inherit from each other.

use super::super::element::Element;
use super::super::finding::RobotDefect;
use super::super::reading::Reading;
use super::general::{self, GENERAL};
use std::collections::BTreeMap;

/// The class that holds where none is named.
const MAIN: &str = "main";

/// Attributes of one kind of element.
type Attributes = Vec<(String, String)>;

/// Attributes by class and kind of element.
#[derive(Debug, Default)]
pub(super) struct Defaults(BTreeMap<String, BTreeMap<String, Attributes>>);

/// Attributes that give an orientation: one given replaces another one of a class.
pub(super) const ORIENTATIONS: [&str; 5] = ["quat", "axisangle", "euler", "xyaxes", "zaxis"];

impl Defaults {
    /// Of the root of a file.
    pub(super) fn of(root: &Element) -> Self {
        let mut own = Self::default();
        for element in root.all("default") {
            let above = own.0.get(MAIN).cloned().unwrap_or_default();
            own.add(element, MAIN, above);
        }
        own
    }

    /// Adds a class with the attributes it has from the class above it, and the classes in it.
    fn add(&mut self, element: &Element, name: &str, above: BTreeMap<String, Attributes>) {
        let mut kinds = above;
        for child in element.children.iter().filter(|child| child.name != "default") {
            if general::is_actuator(&child.name) {
                let made = general::general(child, kinds.remove(GENERAL).unwrap_or_default());
                kinds.insert(GENERAL.to_owned(), made);
                continue;
            }
            let attributes = kinds.entry(child.name.clone()).or_default();
            for (key, value) in child.attributes().filter(|(key, _)| *key != "class") {
                attributes.retain(|(own, _)| own != key);
                attributes.push((key.to_owned(), value.to_owned()));
            }
        }
        for class in element.all("default") {
            self.add(class, class.attribute("class").unwrap_or(MAIN), kinds.clone());
        }
        self.0.insert(element.attribute("class").unwrap_or(name).to_owned(), kinds.clone());
        if name == MAIN {
            self.0.insert(MAIN.to_owned(), kinds);
        }
    }

    /// Notes the classes that elements name and the file does not have.
    pub(super) fn check(&self, element: &Element, reading: &mut Reading) {
        for child in element.children.iter().filter(|child| child.name != "default") {
            for key in ["class", "childclass"] {
                let name = child.attribute(key).filter(|name| *name != MAIN && !self.0.contains_key(*name));
                if let Some(name) = name {
                    let defect = RobotDefect::UnknownName { kind: "class of <default>", name: name.to_owned() };
                    reading.refuse(child, format!("<{}>", child.name), defect);
                }
            }
            self.check(child, reading);
        }
    }

    /// An actuator as `<general>` would write it, with the attributes that it has from its class.
    pub(super) fn actuator(&self, element: &Element) -> Element {
        let class = element.attribute("class").unwrap_or(MAIN);
        let above = self.0.get(class).and_then(|kinds| kinds.get(GENERAL)).cloned().unwrap_or_default();
        element.with_attributes(general::general(element, above))
    }

    /// An element with the attributes that it has from its class, or from that of the bodies around it.
    pub(super) fn applied(&self, element: &Element, around: Option<&str>) -> Element {
        let class = element.attribute("class").or(around).unwrap_or(MAIN);
        let mut full = element.clone();
        let Some(attributes) = self.0.get(class).and_then(|kinds| kinds.get(&element.name)) else { return full };
        let is_turned = ORIENTATIONS.iter().any(|key| element.attribute(key).is_some());
        for (key, value) in attributes {
            if !(is_turned && ORIENTATIONS.contains(&key.as_str())) {
                full.set_default(key, value);
            }
        }
        full
    }
}
