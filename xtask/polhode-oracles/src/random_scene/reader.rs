//! A scene file as a [`Model`], so that the judge can hold runs of any scene against the laws. What the model does not
//! know is refused: other tiers, meshes, points, rules for pairs, masses that are not spread evenly, fields of force.

use super::model::{Body, Force, Form, Material, Model, Motion, Part, RestitutionLaw, Role};
use crate::judge;
use glam::{DQuat, DVec3};
use std::error::Error;
use toml::{Table, Value};

/// The tolerance of a method that names none (no unit): with a larger one it promises less.
const DEFAULT_TOLERANCE: f64 = 1e-11;

/// What is not known of a scene.
fn unknown(what: &str) -> Box<dyn Error> {
    format!("the judge does not know {what}").into()
}

/// A table with keys that are all read.
struct Keys<'a>(&'a Table);

impl<'a> Keys<'a> {
    fn of(value: &'a Value) -> Result<Self, Box<dyn Error>> {
        value.as_table().map(Self).ok_or_else(|| unknown("a value that is no table"))
    }

    fn number(&self, key: &str) -> Option<f64> {
        self.0.get(key).and_then(number)
    }

    fn number_or(&self, key: &str, otherwise: f64) -> f64 {
        self.number(key).unwrap_or(otherwise)
    }

    fn needed(&self, key: &str) -> Result<f64, Box<dyn Error>> {
        self.number(key).ok_or_else(|| unknown(key))
    }

    fn vector(&self, key: &str) -> Option<DVec3> {
        self.0.get(key).and_then(vector)
    }

    fn vector_or_zero(&self, key: &str) -> DVec3 {
        self.vector(key).unwrap_or_default()
    }

    fn text(&self, key: &str) -> Option<&'a str> {
        self.0.get(key).and_then(Value::as_str)
    }

    fn only(&self, known: &[&str]) -> Result<(), Box<dyn Error>> {
        let other = self.0.keys().find(|key| !known.contains(&key.as_str()));
        other.map_or(Ok(()), |key| Err(unknown(key)))
    }

    fn orientation(&self) -> DQuat {
        let turned = self.vector("rotation_vector").map(DQuat::from_scaled_axis);
        let given = self.0.get("orientation").and_then(Value::as_array).map(|wxyz| {
            let at = |index: usize| wxyz.get(index).and_then(number).unwrap_or(f64::NAN);
            DQuat::from_xyzw(at(1), at(2), at(3), at(0)).normalize()
        });
        given.or(turned).unwrap_or(DQuat::IDENTITY)
    }
}

fn number(value: &Value) -> Option<f64> {
    value.as_float().or_else(|| value.as_integer().map(|whole| whole as f64))
}

fn vector(value: &Value) -> Option<DVec3> {
    let [x, y, z] = value.as_array()?.as_slice() else { return None };
    Some(DVec3::new(number(x)?, number(y)?, number(z)?))
}

/// The model of a scene file.
///
/// # Errors
/// When it is no scene, or the judge does not know what is in it.
pub fn model(text: &str) -> Result<Model, Box<dyn Error>> {
    let table: Table = text.parse()?;
    let scene = Keys(&table);
    scene.only(&[
        "format",
        "name",
        "title",
        "description",
        "duration",
        "gravity",
        "method",
        "output",
        "materials",
        "bodies",
        "forces",
    ])?;
    let mut model = Model {
        seed: 0,
        gravity: scene.vector("gravity").unwrap_or(DVec3::new(0.0, 0.0, -9.81)),
        duration: scene.number_or("duration", 1.0),
        interval: 0.0,
        step: 0.0,
        restitution_law: None,
        impact: None,
        materials: Vec::new(),
        bodies: Vec::new(),
        forces: Vec::new(),
    };
    if let Some(method) = table.get("method") {
        let method = Keys::of(method)?;
        if !matches!(method.text("tier"), None | Some("accurate"))
            || method.number_or("tolerance", 0.0) > DEFAULT_TOLERANCE
        {
            return Err(unknown("what another tier or tolerance promises"));
        }
        if matches!(method.text("restitution_law"), Some("newton" | "whittaker")) {
            model.restitution_law = Some(RestitutionLaw::Named("newton"));
        }
    }
    let mut names = Vec::new();
    for (name, value) in table.get("materials").and_then(Value::as_table).into_iter().flatten() {
        names.push(name.as_str());
        model.materials.push(material(&Keys::of(value)?)?);
    }
    let none = names.len();
    model.materials.push(Material {
        friction: 0.0,
        static_friction: 0.0,
        rolling: 0.0,
        spinning: 0.0,
        restitution: 0.0,
    });
    for value in table.get("bodies").and_then(Value::as_array).into_iter().flatten() {
        let keys = Keys::of(value)?;
        let material = keys.text("material").map_or(Some(none), |name| names.iter().position(|other| *other == name));
        model.bodies.push(body(&keys, material.ok_or_else(|| unknown("a material"))?)?);
    }
    for value in table.get("forces").and_then(Value::as_array).into_iter().flatten() {
        model.forces.push(force(value, &model.bodies)?);
    }
    Ok(model)
}

fn material(keys: &Keys<'_>) -> Result<Material, Box<dyn Error>> {
    if keys.0.get("friction").is_some_and(Value::is_table) {
        return Err(unknown("a grain"));
    }
    let friction = keys.number_or("friction", 0.0);
    Ok(Material {
        friction,
        static_friction: keys.number_or("static_friction", friction),
        rolling: keys.number_or("rolling_friction", 0.0),
        spinning: keys.number_or("spinning_friction", 0.0),
        restitution: keys.number_or("restitution", 0.0),
    })
}

fn body(keys: &Keys<'_>, material: usize) -> Result<Body, Box<dyn Error>> {
    keys.only(&[
        "name",
        "fixed",
        "motion",
        "shape",
        "mass",
        "density",
        "position",
        "orientation",
        "rotation_vector",
        "velocity",
        "angular_velocity",
        "material",
        "pivot",
    ])?;
    let form = form(keys.0.get("shape").ok_or_else(|| unknown("a body without a shape"))?)?;
    let role = if keys.0.get("fixed").and_then(Value::as_bool) == Some(true) {
        Role::Fixed
    } else if let Some(value) = keys.0.get("motion") {
        let motion = Keys::of(value)?;
        motion.only(&["constant"])?;
        let constant = Keys::of(&motion.0["constant"])?;
        Role::Moved(Motion::Constant(constant.vector_or_zero("velocity"), constant.vector_or_zero("angular_velocity")))
    } else {
        let filled = keys.number("density").map(|density| density * judge::volume(&form));
        Role::Free(keys.number("mass").or(filled).ok_or_else(|| unknown("a mass"))?)
    };
    Ok(Body {
        name: keys.text("name").unwrap_or_default().to_owned(),
        form,
        role,
        position: keys.vector_or_zero("position"),
        orientation: keys.orientation(),
        velocity: keys.vector_or_zero("velocity"),
        angular_velocity: keys.vector_or_zero("angular_velocity"),
        material,
        pivot: keys.vector("pivot"),
    })
}

fn form(value: &Value) -> Result<Form, Box<dyn Error>> {
    let shape = Keys::of(value)?;
    let (kind, value) = shape.0.iter().next().ok_or_else(|| unknown("an empty shape"))?;
    let keys = Keys::of(value)?;
    Ok(match kind.as_str() {
        "half_space" => Form::HalfSpace(keys.vector("normal").ok_or_else(|| unknown("a half-space"))?.normalize()),
        "box" => Form::Cuboid(keys.vector("size").ok_or_else(|| unknown("a box"))?),
        "sphere" => Form::Sphere(keys.needed("radius")?),
        "cylinder" => Form::Cylinder(keys.needed("radius")?, keys.needed("height")?),
        "cone" => Form::Cone(keys.needed("radius")?, keys.needed("height")?),
        "capsule" => Form::Capsule(keys.needed("radius")?, keys.needed("height")?),
        "torus" => Form::Torus(keys.needed("major")?, keys.needed("minor")?),
        "compound" => {
            let mut parts = Vec::new();
            for value in keys.0.get("parts").and_then(Value::as_array).into_iter().flatten() {
                let part = Keys::of(value)?;
                let form = form(part.0.get("shape").ok_or_else(|| unknown("a part without a shape"))?)?;
                let (position, orientation) = (part.vector_or_zero("position"), part.orientation());
                parts.push(Part { form, position, orientation });
            }
            Form::Compound(parts)
        }
        other => return Err(unknown(other)),
    })
}

fn force(value: &Value, bodies: &[Body]) -> Result<Force, Box<dyn Error>> {
    let kind = Keys::of(value)?.0.get("type").ok_or_else(|| unknown("a force"))?;
    let kind = Keys::of(kind)?;
    kind.only(&["spring", "drag"])?;
    if let Some(value) = kind.0.get("drag") {
        let keys = Keys::of(value)?;
        keys.only(&["law", "translational", "rotational"])?;
        return Ok(Force::Drag {
            is_quadratic: keys.text("law") == Some("quadratic"),
            translational: keys.number_or("translational", 0.0),
            rotational: keys.number_or("rotational", 0.0),
        });
    }
    let keys = Keys::of(&kind.0["spring"])?;
    keys.only(&["body", "point", "anchor", "stiffness", "rest_length", "damping"])?;
    let name = keys.text("body").unwrap_or_default();
    let body = bodies.iter().position(|body| body.name == name).ok_or_else(|| unknown(name))?;
    let (point, anchor) = (keys.vector_or_zero("point"), keys.vector_or_zero("anchor"));
    let at_start = (bodies[body].position + bodies[body].orientation * point - anchor).length();
    Ok(Force::Anchored {
        body,
        point,
        anchor,
        stiffness: keys.needed("stiffness")?,
        rest_length: keys.number_or("rest_length", at_start),
        damping: keys.number_or("damping", 0.0),
    })
}
