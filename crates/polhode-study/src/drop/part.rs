//! A part above a floor, as the text of a scene: so that errors, and values set from outside, are those of scenes.

use serde_json::json;
use std::fmt::Write as _;
use std::path::PathBuf;

/// Shapes by name with their measures, for messages.
pub const NAMED_SHAPES: &str = "box:X,Y,Z (edges, m), sphere:R, cylinder:R,H, cone:R,H or capsule:R,H";

/// The shape of a part.
#[derive(Debug, Clone, PartialEq)]
pub enum PartShape {
    /// The mesh of a file, as an absolute path.
    Mesh {
        /// The file.
        file: PathBuf,
        /// Metres in a unit of the file.
        scale: f64,
    },
    /// A shape of the scene format: its keys, with their values.
    Named(String),
}

impl PartShape {
    /// From a name with measures, as `box:0.1,0.2,0.3`; none where a text has no such form.
    pub fn parse(text: &str) -> Option<Self> {
        let (kind, measures) = text.split_once(':')?;
        let measures: Vec<f64> = measures.split(',').map(|own| own.trim().parse().ok()).collect::<Option<_>>()?;
        let keys = match (kind, &measures[..]) {
            ("box", [_, _, _]) => format!("shape.box.size = {measures:?}"),
            ("sphere", [radius]) => format!("shape.sphere.radius = {radius:?}"),
            ("cylinder" | "cone" | "capsule", [radius, height]) => {
                format!("shape.{kind} = {{ radius = {radius:?}, height = {height:?} }}")
            }
            _ => return None,
        };
        Some(Self::Named(keys))
    }

    fn keys(&self) -> String {
        match self {
            Self::Mesh { file, scale } => {
                format!("shape.mesh = {{ file = {}, scale = {scale:?} }}", json!(file.to_string_lossy()))
            }
            Self::Named(keys) => keys.clone(),
        }
    }
}

/// A part, and what it is made of.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// What the body is called.
    pub name: String,
    /// Its shape.
    pub shape: PartShape,
    /// Density, kg/m^3.
    pub density: f64,
    /// Friction with the floor.
    pub friction: f64,
    /// Restitution.
    pub restitution: f64,
    /// Young's modulus (Pa) and Poisson's ratio; none where impacts have no duration.
    pub elastic: Option<[f64; 2]>,
}

impl Part {
    /// The scene: materials `part` and `floor`, a body `floor`, and the part.
    pub fn scene(&self) -> String {
        let Self { name, shape, density, friction, restitution, elastic } = self;
        let name = json!(name);
        let mut text = format!("format = 1\nname = {name}\nduration = 1.0\n");
        for material in ["part", "floor"] {
            let _ = write!(text, "\n[materials.{material}]\nfriction = {friction:?}\nrestitution = {restitution:?}\n");
            if let (Some([young, poisson]), "part") = (elastic, material) {
                let _ = write!(text, "youngs_modulus_pa = {young:?}\npoisson_ratio = {poisson:?}\n");
            }
        }
        let floor = "name = \"floor\"\nfixed = true\nshape.half_space.normal = [0, 0, 1]\nmaterial = \"floor\"";
        let keys = shape.keys();
        let _ = write!(text, "\n[[bodies]]\n{floor}\n\n[[bodies]]\nname = {name}\n{keys}\ndensity = {density:?}\n");
        text.push_str("material = \"part\"\n");
        text
    }
}
