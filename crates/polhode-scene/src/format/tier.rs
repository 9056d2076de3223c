//! Tiers by the names that the engine gives them, so that the lists cannot differ.

use polhode::scene::Tier;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{self, Deserialize, Deserializer, Visitor};
use std::borrow::Cow;

/// A set of methods with one promise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TierName(pub Tier);

const COUNT: usize = Tier::ALL.len();

/// Names of all tiers, in the engine's order.
const NAMES: [&str; COUNT] = {
    let mut names = [""; COUNT];
    let mut index = 0;
    while index < COUNT {
        names[index] = Tier::ALL[index].name();
        index += 1;
    }
    names
};

impl<'de> Deserialize<'de> for TierName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_str(Name)
    }
}

struct Name;

impl Visitor<'_> for Name {
    type Value = TierName;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "one of `{}`", NAMES.join("`, `"))
    }

    fn visit_str<E: de::Error>(self, name: &str) -> Result<TierName, E> {
        Tier::from_name(name).map(TierName).ok_or_else(|| E::unknown_variant(name, &NAMES))
    }
}

impl JsonSchema for TierName {
    fn schema_name() -> Cow<'static, str> {
        "TierName".into()
    }

    fn json_schema(_generator: &mut SchemaGenerator) -> Schema {
        let member =
            |tier: Tier| json_schema!({ "description": tier.facts().summary, "type": "string", "const": tier.name() });
        json_schema!({
            "description": "A set of methods with one promise.",
            "oneOf": Tier::ALL.map(member),
        })
    }
}
