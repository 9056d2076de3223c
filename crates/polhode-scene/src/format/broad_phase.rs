//! Broad phases by the names that the engine gives them, so that the lists cannot differ.

use polhode::scene::BroadPhaseMethod;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{self, Deserialize, Deserializer, Visitor};
use std::borrow::Cow;

/// How pairs that may touch are found; a choice of time alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BroadPhaseName(pub BroadPhaseMethod);

const COUNT: usize = BroadPhaseMethod::ALL.len();

/// Names of all broad phases, in the engine's order.
const NAMES: [&str; COUNT] = {
    let mut names = [""; COUNT];
    let mut index = 0;
    while index < COUNT {
        names[index] = BroadPhaseMethod::ALL[index].name();
        index += 1;
    }
    names
};

impl<'de> Deserialize<'de> for BroadPhaseName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_str(Name)
    }
}

struct Name;

impl Visitor<'_> for Name {
    type Value = BroadPhaseName;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "one of `{}`", NAMES.join("`, `"))
    }

    fn visit_str<E: de::Error>(self, name: &str) -> Result<BroadPhaseName, E> {
        name.parse().map(BroadPhaseName).map_err(|_| E::unknown_variant(name, &NAMES))
    }
}

impl JsonSchema for BroadPhaseName {
    fn schema_name() -> Cow<'static, str> {
        "BroadPhaseName".into()
    }

    fn json_schema(_generator: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "How pairs that may touch are found; a choice of time alone.",
            "type": "string",
            "enum": NAMES,
        })
    }
}
