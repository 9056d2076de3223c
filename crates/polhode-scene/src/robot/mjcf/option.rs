//! `<option>`: gravity is read, and what of the rest has no effect is told.

use super::super::element::Element;
use super::super::finding::RobotDefect;
use super::super::reading::Reading;
use super::body::Contacts;
use glam::DVec3;

/// Why numbers of another engine's method have no effect.
const OF_METHOD: &str = "steps and integrator are chosen by the method of the scene: `method.tier`, `method.step`";

/// Why numbers of another engine's contacts have no effect.
const OF_CONTACTS: &str = "contacts and limits are rigid here, and materials of the scene give their friction";

/// Why air has no effect.
const OF_AIR: &str = "forces of the scene give wind and drag: `forces`";

/// Why other settings have no effect.
const OF_OTHERS: &str = "it is a setting of another engine";

/// Why a part of the physics that is taken out has an effect all the same.
const OF_FLAGS: &str = "it cannot be taken out here";

/// Attributes by what they are about.
const ATTRIBUTES: [(&[&str], &str); 3] = [
    (&["timestep", "integrator", "solver", "iterations", "tolerance", "jacobian"], OF_METHOD),
    (&["cone", "impratio", "o_margin", "o_solref", "o_solimp", "o_friction"], OF_CONTACTS),
    (&["wind", "density", "viscosity"], OF_AIR),
];

/// What `<option>` says.
#[derive(Debug, Clone, Copy)]
pub(super) struct Options {
    /// m/s^2.
    pub(super) gravity: Option<DVec3>,
    /// Whether bodies collide with each other.
    pub(super) contacts: Contacts,
    /// Whether actuators act.
    pub(super) actuation: Actuation,
}

/// Whether actuators act.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Actuation {
    /// They do.
    On,
    /// They do not.
    Off,
}

impl Options {
    /// Of the root of a file.
    pub(super) fn of(root: &Element, reading: &mut Reading) -> Self {
        let mut own = Self { gravity: None, contacts: Contacts::On, actuation: Actuation::On };
        for element in root.all("option") {
            own.gravity = reading.vector(element, "gravity", "option").or(own.gravity);
            for (name, value) in element.attributes().filter(|(name, _)| *name != "gravity") {
                let why = ATTRIBUTES.iter().find(|(names, _)| names.contains(&name)).map_or(OF_OTHERS, |(_, why)| *why);
                reading.ignore(element, format!("`{name}=\"{value}\"` of <option>"), why);
            }
            for flag in element.all("flag") {
                own.take(flag, reading);
            }
        }
        own
    }

    /// What the flags take out.
    fn take(&mut self, flag: &Element, reading: &mut Reading) {
        for (name, value) in flag.attributes() {
            if !["enable", "disable"].contains(&value) {
                let (attribute, value, accepted) = ("flag", value.to_owned(), "enable or disable");
                reading.refuse(flag, format!("flag `{name}`"), RobotDefect::Word { attribute, value, accepted });
                continue;
            }
            match (name, value) {
                ("contact", "disable") => self.contacts = Contacts::Off,
                ("gravity", "disable") => self.gravity = Some(DVec3::ZERO),
                ("actuation", "disable") => {
                    self.actuation = Actuation::Off;
                    reading.ignore(flag, "all actuators", "<flag> of <option> takes them out: actuation=\"disable\"");
                }
                (_, "disable") => reading.ignore(flag, format!("`{name}=\"disable\"` of <flag>"), OF_FLAGS),
                _ => {}
            }
        }
    }
}
