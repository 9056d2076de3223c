//! `<compiler>`: what the numbers of an MJCF file mean.

use super::super::element::Element;
use super::super::reading::Reading;
use polhode::spatial::DVec3;
use std::f64::consts::PI;

/// Degrees in half a turn.
const HALF_TURN: f64 = 180.0;

/// Why a setting of the compiler has no effect.
const UNSUPPORTED: &str = "masses and inertias are taken as the file gives them";

/// The unit of angles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Angle {
    /// Degrees.
    Degree,
    /// Radians.
    Radian,
}

/// Where inertias come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum InertiaFromGeom {
    /// From `<inertial>` alone.
    Never,
    /// From the geometries where there is no `<inertial>`.
    Auto,
    /// From the geometries always.
    Always,
}

/// The settings.
#[derive(Debug, Clone)]
pub(super) struct Compiler {
    angle: Angle,
    /// Letters of the axes of Euler angles: those in capitals do not turn along.
    pub(super) euler_sequence: [char; 3],
    /// Whether a range alone limits a joint.
    pub(super) automatic_limits: bool,
    /// Folder of meshes, relative to the file.
    pub(super) mesh_folder: String,
    /// Whether the folders in names of meshes are dropped.
    pub(super) strips_path: bool,
    /// Where inertias come from.
    pub(super) inertia_from_geom: InertiaFromGeom,
    /// The groups of geometries that count, the first and the last.
    pub(super) inertia_groups: [f64; 2],
    /// What the masses add up to, kg.
    pub(super) total_mass: Option<f64>,
}

impl Compiler {
    /// Of the root of a file.
    pub(super) fn of(root: &Element, reading: &mut Reading) -> Self {
        let mut own = Self {
            angle: Angle::Degree,
            euler_sequence: ['x', 'y', 'z'],
            automatic_limits: true,
            mesh_folder: String::new(),
            strips_path: false,
            inertia_from_geom: InertiaFromGeom::Auto,
            inertia_groups: [0.0, 5.0],
            total_mass: None,
        };
        for element in root.all("compiler") {
            own.take(element, reading);
        }
        own
    }

    fn take(&mut self, element: &Element, reading: &mut Reading) {
        let asset_folder = element.attribute("assetdir").map(str::to_owned);
        for (name, value) in element.attributes() {
            match (name, value) {
                ("angle", "radian") => self.angle = Angle::Radian,
                ("angle", "degree") => self.angle = Angle::Degree,
                ("autolimits", _) => self.automatic_limits = value == "true",
                ("strippath", _) => self.strips_path = value == "true",
                ("inertiafromgeom", "true") => self.inertia_from_geom = InertiaFromGeom::Always,
                ("inertiafromgeom", "false") => self.inertia_from_geom = InertiaFromGeom::Never,
                ("eulerseq", _) => {
                    let letters: Vec<char> = value.chars().collect();
                    match <[char; 3]>::try_from(letters) {
                        Ok(letters) if letters.iter().all(|c| "xyzXYZ".contains(*c)) => self.euler_sequence = letters,
                        _ => reading.refuse_word(element, "eulerseq", value, "three of the letters x, y, z, X, Y, Z"),
                    }
                }
                ("balanceinertia" | "boundmass" | "boundinertia", _) if value != "false" && value != "0" => {
                    reading.ignore(element, format!("`{name}` of <compiler>"), UNSUPPORTED);
                }
                _ => {}
            }
        }
        if let Some(folder) = element.attribute("meshdir").map(str::to_owned).or(asset_folder) {
            self.mesh_folder = folder;
        }
        if let Some(groups) = reading.numbers(element, "inertiagrouprange", 2..=2, "compiler") {
            self.inertia_groups = [groups[0], groups[1]];
        }
        let total = reading.number(element, "settotalmass", "compiler");
        self.total_mass = total.filter(|&mass| mass > 0.0).or(self.total_mass);
    }

    /// An angle of the file in rad.
    pub(super) fn radians(&self, angle: f64) -> f64 {
        match self.angle {
            Angle::Degree => angle / HALF_TURN * PI,
            Angle::Radian => angle,
        }
    }

    /// The axes of Euler angles with whether each turns along, in their order.
    pub(super) fn euler_axes(&self) -> [(DVec3, Turning); 3] {
        self.euler_sequence.map(|letter| {
            let axis = match letter.to_ascii_lowercase() {
                'x' => DVec3::X,
                'y' => DVec3::Y,
                _ => DVec3::Z,
            };
            (axis, if letter.is_ascii_uppercase() { Turning::Still } else { Turning::Along })
        })
    }
}

/// Whether an axis of Euler angles turns with the rotations before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Turning {
    /// It does.
    Along,
    /// It stands still.
    Still,
}
