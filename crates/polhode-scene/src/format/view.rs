//! How a scene is shown: from where, and colours. Nothing of it is simulated.

use super::exactly::{Exactly, Vector};
use polhode::scene::{COLORS, Standpoint};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::SeqAccessDeserializer;
use serde::de::{self, Deserialize, Deserializer, SeqAccess, Visitor};
use std::borrow::Cow;
use std::fmt::Formatter;

/// From where the scene is shown; what is absent follows from what is there.
#[derive(Debug, Clone, PartialEq, Default, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ViewEntry {
    /// Where the camera stands: `front`, `side`, `top` or `iso`, or a place [x, y, z], m; or `from`.
    pub camera: Option<CameraEntry>,
    /// Direction from what is looked at to the camera, of any length; the camera stands so far away that all is seen.
    pub from: Option<Vector>,
    /// The place in the middle of the picture, m.
    pub look_at: Option<Vector>,
    /// Two opposite corners of a box that the picture holds, m; what is there when absent.
    pub frame: Option<Exactly<Vector, 2>>,
}

/// Where a camera stands.
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged)]
pub enum CameraEntry {
    /// A view by its name.
    Named(ViewName),
    /// A place, m.
    Place(Vector),
}

const VIEWS: [&str; 4] = {
    let mut names = [""; 4];
    let mut index = 0;
    while index < names.len() {
        names[index] = Standpoint::NAMED[index].0;
        index += 1;
    }
    names
};

/// A view that has a name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViewName(pub Standpoint);

impl JsonSchema for ViewName {
    fn schema_name() -> Cow<'static, str> {
        "ViewName".into()
    }

    fn json_schema(_generator: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "string", "enum": VIEWS })
    }
}

// Derived untagged enums lose the place and the reason of an error; this visitor keeps both.
impl<'de> Deserialize<'de> for CameraEntry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Camera;
        impl<'de> Visitor<'de> for Camera {
            type Value = CameraEntry;

            fn expecting(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
                write!(f, "one of `{}`, or a place [x, y, z]", VIEWS.join("`, `"))
            }

            fn visit_str<E: de::Error>(self, name: &str) -> Result<CameraEntry, E> {
                let found = Standpoint::named(name).map(|view| CameraEntry::Named(ViewName(view)));
                found.ok_or_else(|| E::unknown_variant(name, &VIEWS))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, elements: A) -> Result<CameraEntry, A::Error> {
                Vector::deserialize(SeqAccessDeserializer::new(elements)).map(CameraEntry::Place)
            }
        }
        deserializer.deserialize_any(Camera)
    }
}

/// What an error says after the names of colours: red, green and blue in hexadecimal digits.
const HEXADECIMAL: &str = "#rrggbb";

const COLOR_NAMES: [&str; COLORS.len() + 1] = {
    let mut names = [HEXADECIMAL; COLORS.len() + 1];
    let mut index = 0;
    while index < COLORS.len() {
        names[index] = COLORS[index].0;
        index += 1;
    }
    names
};

/// A colour: a name, or `#rrggbb`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ColorEntry(pub [u8; 3]);

impl<'de> Deserialize<'de> for ColorEntry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Color;
        impl Visitor<'_> for Color {
            type Value = ColorEntry;

            fn expecting(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
                write!(f, "one of `{}`", COLOR_NAMES.join("`, `"))
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<ColorEntry, E> {
                let named = COLORS.iter().find(|(name, _)| *name == text).map(|(_, color)| *color);
                let found = named.or_else(|| hexadecimal(text)).map(ColorEntry);
                found.ok_or_else(|| E::unknown_variant(text, &COLOR_NAMES))
            }
        }
        deserializer.deserialize_str(Color)
    }
}

fn hexadecimal(text: &str) -> Option<[u8; 3]> {
    let digits = text.strip_prefix('#').filter(|digits| digits.len() == 6 && digits.is_ascii())?;
    let channel = |at: usize| u8::from_str_radix(digits.get(at..at + 2)?, 16).ok();
    // A sign is no digit.
    let is_number = digits.bytes().all(|byte| byte.is_ascii_hexdigit());
    if is_number { Some([channel(0)?, channel(2)?, channel(4)?]) } else { None }
}

impl JsonSchema for ColorEntry {
    fn schema_name() -> Cow<'static, str> {
        "ColorEntry".into()
    }

    fn json_schema(_generator: &mut SchemaGenerator) -> Schema {
        let names = COLORS.map(|(name, _)| name).join("|");
        json_schema!({
            "description": "A colour by its name, or `#rrggbb`.",
            "type": "string",
            "pattern": format!("^({names}|#[0-9a-fA-F]{{6}})$"),
        })
    }
}
