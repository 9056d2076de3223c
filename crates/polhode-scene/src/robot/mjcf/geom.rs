//! `<geom>`: shapes, and the masses they have when a body gives none.

use super::super::element::Element;
use super::super::finding::RobotDefect;
use super::super::model::{Geom, GeomForm};
use super::super::reading::Reading;
use super::asset::MeshAsset;
use super::compiler::Compiler;
use super::frame;
use glam::DVec3;
use polhode::spatial::Pose;
use std::collections::BTreeMap;

/// Density of geometries that give none, kg/m^3.
const DENSITY: f64 = 1000.0;

/// Kinds of geometry, for messages.
const KINDS: &str = "plane, sphere, capsule, ellipsoid, cylinder, box or mesh";

/// What the mass of a geometry is given by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Amount {
    /// Mass, kg.
    Mass(f64),
    /// Density, kg/m^3, or kg/m^2 of a shell.
    Density(f64),
}

/// With what a geometry collides: with those of which one's `type` and the other's `affinity` have a bit in common.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Mask {
    kind: u32,
    affinity: u32,
}

impl Mask {
    /// That of bodies of other files: the default.
    pub(super) const USUAL: Self = Self { kind: 1, affinity: 1 };

    /// Whether two collide.
    pub(super) const fn meets(self, other: Self) -> bool {
        self.kind & other.affinity != 0 || other.kind & self.affinity != 0
    }
}

/// A geometry with what else its element says.
#[derive(Debug, Clone)]
pub(super) struct BodyGeom {
    /// The geometry, in the frame of the body.
    pub(super) geom: Geom,
    /// With what it collides.
    pub(super) mask: Mask,
    /// Its mass or density.
    pub(super) amount: Amount,
    /// Whether its mass is spread over its surface.
    pub(super) is_shell: bool,
    /// Its group.
    pub(super) group: f64,
}

/// The geometry of an element that has the attributes of its class.
pub(super) fn read(
    element: &Element,
    (compiler, meshes): (&Compiler, &BTreeMap<String, MeshAsset>),
    subject: &str,
    reading: &mut Reading,
) -> Option<BodyGeom> {
    let (form, pose) = form(element, (compiler, meshes), subject, reading)?;
    let geom = Geom { place: element.place.clone(), pose, form };
    // Numbers that are no bits are none: casts of floats saturate.
    let mut bits = |name: &str| reading.number(element, name, subject).map_or(1, |number| number as u32);
    let mask = Mask { kind: bits("contype"), affinity: bits("conaffinity") };
    for name in ["friction", "condim", "solref", "solimp", "margin", "gap", "priority", "solmix"] {
        if element.attribute(name).is_some() {
            reading.ignore(element, format!("`{name}` of <geom>"), "the material of the model says how bodies touch");
        }
    }
    let mass = reading.number(element, "mass", subject);
    let density = reading.number(element, "density", subject).unwrap_or(DENSITY);
    let amount = mass.map_or(Amount::Density(density), Amount::Mass);
    let group = reading.number(element, "group", subject).unwrap_or(0.0);
    let is_shell = element.attribute("shellinertia") == Some("true");
    Some(BodyGeom { geom, mask, amount, is_shell, group })
}

/// The form of a geometry and its pose in the body.
fn form(
    element: &Element,
    (compiler, meshes): (&Compiler, &BTreeMap<String, MeshAsset>),
    subject: &str,
    reading: &mut Reading,
) -> Option<(GeomForm, Pose)> {
    let kind = element.attribute("type").unwrap_or("sphere");
    let sizes = reading.numbers(element, "size", 1..=3, subject).unwrap_or_default();
    let mut pose = frame::pose(element, compiler, subject, reading);
    if kind == "hfield" {
        reading.refuse(element, subject, RobotDefect::NoSuchShape("height field"));
        return None;
    }
    if kind == "plane" {
        return Some((GeomForm::Plane, pose));
    }
    if matches!(kind, "mesh" | "sdf") || element.attribute("mesh").is_some() {
        if element.attribute("mesh").is_some() && !matches!(kind, "mesh" | "sdf") {
            reading.ignore(
                element,
                "`mesh` of a primitive <geom>",
                "the primitive is not fitted: the mesh itself is used",
            );
        }
        let name = element.attribute("mesh").unwrap_or_default();
        let Some(mesh) = meshes.get(name) else {
            reading.refuse(element, subject, RobotDefect::UnknownName { kind: "mesh", name: name.to_owned() });
            return None;
        };
        let form = GeomForm::Mesh { name: mesh.file.clone(), path: mesh.path.clone(), scale: mesh.scale };
        return Some((form, pose * mesh.reference.inverse()));
    }
    // Half lengths, from the middle; a segment gives the last of them, the middle and the direction of z.
    let segment = reading.numbers(element, "fromto", 6..=6, subject);
    let mut half = sizes.clone();
    if let Some(ends) = segment {
        let (from, to) = (DVec3::from_slice(&ends), DVec3::from_slice(&ends[3..]));
        // MuJoCo turns z to the first end.
        let axis = reading.direction(element, from - to, subject)?;
        pose = Pose::new(frame::from_z(axis), 0.5 * (from + to));
        let length = 0.5 * (to - from).length();
        match kind {
            "box" | "ellipsoid" => half = vec![*sizes.first()?, *sizes.first()?, length],
            _ => half = vec![*sizes.first()?, length],
        }
    }
    let mut size = |index: usize, what: &'static str| {
        let Some(&value) = half.get(index) else {
            reading.refuse(element, subject, RobotDefect::MissingAttribute("size"));
            return None;
        };
        reading.size(element, what, value, subject)
    };
    let form = match kind {
        "sphere" => GeomForm::Sphere { radius: size(0, "radius")? },
        "capsule" => GeomForm::Capsule { radius: size(0, "radius")?, height: 2.0 * size(1, "half length")? },
        "cylinder" => GeomForm::Cylinder { radius: size(0, "radius")?, height: 2.0 * size(1, "half length")? },
        "box" | "ellipsoid" => {
            let half = DVec3::new(size(0, "half length")?, size(1, "half length")?, size(2, "half length")?);
            if kind == "box" { GeomForm::Box { size: 2.0 * half } } else { GeomForm::Ellipsoid { semi_axes: half } }
        }
        other => {
            let value = other.to_owned();
            reading.refuse(element, subject, RobotDefect::Word { attribute: "type", value, accepted: KINDS });
            return None;
        }
    };
    Some((form, pose))
}
