//! Integrators by the names that the engine gives them, so that the lists cannot differ.

use polhode::scene::Integrator;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{self, Deserialize, Deserializer, Visitor};
use std::borrow::Cow;

/// How bodies are integrated that no contact holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct IntegratorName(pub Integrator);

const COUNT: usize = Integrator::ALL.len();

/// Names of all integrators, in the engine's order.
const NAMES: [&str; COUNT] = {
    let mut names = [""; COUNT];
    let mut index = 0;
    while index < COUNT {
        names[index] = Integrator::ALL[index].name();
        index += 1;
    }
    names
};

impl<'de> Deserialize<'de> for IntegratorName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_str(Name)
    }
}

struct Name;

impl Visitor<'_> for Name {
    type Value = IntegratorName;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "one of `{}`", NAMES.join("`, `"))
    }

    fn visit_str<E: de::Error>(self, name: &str) -> Result<IntegratorName, E> {
        Integrator::from_name(name).map(IntegratorName).map_err(|_| E::unknown_variant(name, &NAMES))
    }
}

impl JsonSchema for IntegratorName {
    fn schema_name() -> Cow<'static, str> {
        "IntegratorName".into()
    }

    fn json_schema(_generator: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "How bodies are integrated that no contact holds.",
            "type": "string",
            "enum": NAMES,
        })
    }
}
