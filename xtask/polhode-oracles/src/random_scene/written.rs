//! A random scene as a scene file, with its mesh files.

use super::model::{Body, Force, Form, Material, Model, Motion, RestitutionLaw, Role, Triangles};
use glam::{DQuat, DVec3};
use std::fmt::Write;

/// The scene file and its mesh files: names and contents.
#[derive(Debug)]
pub struct Written {
    /// The text of the scene file.
    pub text: String,
    /// Names and texts of mesh files.
    pub meshes: Vec<(String, String)>,
}

/// Three numbers with all their digits.
fn vector(v: DVec3) -> String {
    format!("[{:?}, {:?}, {:?}]", v.x, v.y, v.z)
}

fn quaternion(q: DQuat) -> String {
    format!("[{:?}, {:?}, {:?}, {:?}]", q.w, q.x, q.y, q.z)
}

fn table(points: &[DVec3]) -> String {
    points.iter().map(|&point| vector(point)).collect::<Vec<_>>().join(", ")
}

impl Model {
    /// As files; mesh files are named after `stem`.
    pub fn written(&self, stem: &str) -> Written {
        let mut written = Written { text: String::new(), meshes: Vec::new() };
        let mut lines = vec![
            "format = 1".to_owned(),
            format!("name = \"{stem}\""),
            format!("title = \"Random scene {}\"", self.seed),
            format!("duration = {:?}", self.duration),
            format!("gravity = {}", vector(self.gravity)),
            String::new(),
            "[method]".to_owned(),
            format!("step = {:?}", self.step),
        ];
        match self.restitution_law {
            None => {}
            Some(RestitutionLaw::Named(word)) => lines.push(format!("restitution_law = \"{word}\"")),
            Some(RestitutionLaw::ChatterjeeRuina(tangential)) => {
                lines.push("restitution_law = \"chatterjee-ruina\"".to_owned());
                lines.push(format!("tangential_restitution = {tangential:?}"));
            }
        }
        lines.extend(self.impact.map(|word| format!("impact = \"{word}\"")));
        lines.extend([String::new(), "[output]".to_owned(), format!("interval = {:?}", self.interval)]);
        for (number, material) in self.materials.iter().enumerate() {
            lines.extend(material.lines(number));
        }
        for body in &self.bodies {
            lines.extend(body.lines(stem, &mut written.meshes));
        }
        for force in &self.forces {
            lines.extend([String::new(), "[[forces]]".to_owned(), force.line(&self.bodies)]);
        }
        written.text = lines.join("\n") + "\n";
        written
    }
}

impl Material {
    fn lines(&self, number: usize) -> Vec<String> {
        vec![
            String::new(),
            format!("[materials.m{number}]"),
            format!("friction = {:?}", self.friction),
            format!("static_friction = {:?}", self.static_friction),
            format!("rolling_friction = {:?}", self.rolling),
            format!("spinning_friction = {:?}", self.spinning),
            format!("restitution = {:?}", self.restitution),
        ]
    }
}

impl Body {
    fn lines(&self, stem: &str, meshes: &mut Vec<(String, String)>) -> Vec<String> {
        let mut lines = vec![
            String::new(),
            "[[bodies]]".to_owned(),
            format!("name = \"{}\"", self.name),
            format!("shape.{}", self.form.text(stem, meshes)),
            format!("material = \"m{}\"", self.material),
        ];
        let is_table = matches!(self.role, Role::Moved(Motion::Table(..)));
        if !is_table {
            lines.push(format!("position = {}", vector(self.position)));
        }
        lines.push(format!("orientation = {}", quaternion(self.orientation)));
        match &self.role {
            Role::Fixed => lines.push("fixed = true".to_owned()),
            Role::Moved(motion) => lines.push(motion.line()),
            Role::Free(mass) => {
                lines.push(format!("mass = {mass:?}"));
                if let Some(pivot) = self.pivot {
                    lines.push(format!("pivot = {}", vector(pivot)));
                } else {
                    lines.push(format!("velocity = {}", vector(self.velocity)));
                }
                lines.push(format!("angular_velocity = {}", vector(self.angular_velocity)));
            }
        }
        lines
    }
}

impl Form {
    /// The key of the shape and its value.
    fn text(&self, stem: &str, meshes: &mut Vec<(String, String)>) -> String {
        let mut file = |key: &str, solid: &Triangles| {
            let name = format!("{stem}-{}.obj", meshes.len());
            let text = format!("{key} = {{ file = \"{name}\" }}");
            meshes.push((name, solid.obj()));
            text
        };
        match self {
            Self::HalfSpace(normal) => format!("half_space = {{ normal = {} }}", vector(*normal)),
            Self::Cuboid(size) => format!("box = {{ size = {} }}", vector(*size)),
            Self::Sphere(radius) => format!("sphere = {{ radius = {radius:?} }}"),
            Self::Cylinder(radius, height) => format!("cylinder = {{ radius = {radius:?}, height = {height:?} }}"),
            Self::Cone(radius, height) => format!("cone = {{ radius = {radius:?}, height = {height:?} }}"),
            Self::Capsule(radius, height) => format!("capsule = {{ radius = {radius:?}, height = {height:?} }}"),
            Self::Torus(major, minor) => format!("torus = {{ major = {major:?}, minor = {minor:?} }}"),
            Self::Convex(solid) => file("convex", solid),
            Self::Mesh(solid, _) => file("mesh", solid),
            Self::Compound(parts) => {
                let mut texts = Vec::new();
                for part in parts {
                    let (position, orientation) = (vector(part.position), quaternion(part.orientation));
                    let shape = part.form.text(stem, meshes);
                    texts.push(format!("{{ shape.{shape}, position = {position}, orientation = {orientation} }}"));
                }
                format!("compound.parts = [{}]", texts.join(", "))
            }
        }
    }
}

impl Triangles {
    fn obj(&self) -> String {
        let mut text = String::new();
        for v in &self.vertices {
            let _ = writeln!(text, "v {:?} {:?} {:?}", v.x, v.y, v.z);
        }
        for [a, b, c] in &self.triangles {
            let _ = writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1);
        }
        text
    }
}

impl Motion {
    fn line(&self) -> String {
        match self {
            Self::Constant(velocity, angular) => format!(
                "motion.constant = {{ velocity = {}, angular_velocity = {} }}",
                vector(*velocity),
                vector(*angular)
            ),
            Self::Sine { amplitude, turn, frequency, phase } => {
                let turn =
                    turn.map_or(String::new(), |(axis, angle)| format!(", axis = {}, angle = {angle:?}", vector(axis)));
                format!(
                    "motion.sine = {{ amplitude = {}, frequency = {frequency:?}, phase = {phase:?}{turn} }}",
                    vector(*amplitude)
                )
            }
            Self::Table(times, positions) => {
                format!("motion.table = {{ times = {times:?}, positions = [{}] }}", table(positions))
            }
        }
    }
}

impl Force {
    fn line(&self, all: &[Body]) -> String {
        match self {
            Self::Anchored { body, point, anchor, stiffness, rest_length, damping } => format!(
                "type.spring = {{ body = \"{}\", point = {}, anchor = {}, stiffness = {stiffness:?}, rest_length = \
                 {rest_length:?}, damping = {damping:?} }}",
                all[*body].name,
                vector(*point),
                vector(*anchor)
            ),
            Self::Between { bodies: [a, b], points, stiffness, rest_length, damping } => format!(
                "type.spring = {{ bodies = [\"{}\", \"{}\"], points = [{}], stiffness = {stiffness:?}, rest_length = \
                 {rest_length:?}, damping = {damping:?} }}",
                all[*a].name,
                all[*b].name,
                table(points)
            ),
            Self::Drag { is_quadratic, translational, rotational } => format!(
                "type.drag = {{ law = \"{}\", translational = {translational:?}, rotational = {rotational:?} }}",
                if *is_quadratic { "quadratic" } else { "linear" }
            ),
        }
    }
}
