//! What of a scene is uncertain: values of keys, and where bodies are at the start.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{self, Deserialize, Deserializer, SeqAccess, Visitor};
use serde_json::json;
use std::borrow::Cow;
use std::fmt::Formatter;

/// Kinds of distribution, for messages.
pub(crate) const SPREADS: &str = "normal, lognormal, uniform, interval or choice";

/// A value that is uncertain: `key` and one of normal, lognormal, uniform, interval and choice. Or bodies whose poses
/// are: `bodies` with one or both of the deviations. `polhode sweep` draws them, a run has what the scene says.
#[derive(Debug, Clone, PartialEq, Default, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = json!([{ "required": ["key"] }, { "required": ["bodies"] }])))]
pub struct UncertainEntry {
    /// Dotted path of the key, as after `--set`: `materials.steel.friction`, `bodies.box.position[2]`.
    pub key: Option<String>,
    /// The normal distribution.
    pub normal: Option<NormalEntry>,
    /// A quantity whose logarithm is normal.
    pub lognormal: Option<LogNormalEntry>,
    /// All values between two are as probable as each other.
    pub uniform: Option<LimitsEntry>,
    /// Somewhere between two values, and no more is known: draws are even, and the report tells least and most.
    pub interval: Option<LimitsEntry>,
    /// Each of these values is as probable as the others.
    #[schemars(length(min = 1))]
    pub choice: Option<Vec<ChoiceEntry>>,
    /// Names of the bodies whose poses are uncertain, of the list of bodies.
    #[schemars(length(min = 1))]
    pub bodies: Option<Vec<String>>,
    /// Standard deviation of their positions along each axis of the world, m: a number, or one for each axis.
    pub position_deviation: Option<AxesEntry>,
    /// Standard deviation of the angles by which they are turned about each axis of the world through their origins,
    /// rad: a number, or one for each axis.
    pub rotation_deviation: Option<AxesEntry>,
    /// Whether each body is drawn alone, or all are moved and turned alike; each when absent.
    pub draw: Option<DrawName>,
}

/// The normal distribution.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NormalEntry {
    /// Its mean; the value that the scene has when absent.
    pub mean: Option<f64>,
    /// Its standard deviation.
    #[schemars(range(min = 0))]
    pub deviation: f64,
}

/// A quantity whose logarithm is normal.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LogNormalEntry {
    /// Half of the draws lie below it; the value that the scene has when absent.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub median: Option<f64>,
    /// Standard deviation of the natural logarithm.
    #[schemars(range(min = 0))]
    pub spread: f64,
}

/// The smallest and the largest value.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LimitsEntry {
    /// The smallest value.
    pub low: f64,
    /// The largest value.
    pub high: f64,
}

/// How the bodies of a group are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum DrawName {
    /// Each body alone.
    Each,
    /// All are moved and turned alike, each about its own origin.
    Alike,
}

/// A number for each axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxesEntry(pub [f64; 3]);

impl<'de> Deserialize<'de> for AxesEntry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Axes;
        impl<'de> Visitor<'de> for Axes {
            type Value = AxesEntry;

            fn expecting(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
                f.write_str("a number, or an array of length 3")
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<AxesEntry, E> {
                Ok(AxesEntry([value; 3]))
            }

            fn visit_i64<E: de::Error>(self, value: i64) -> Result<AxesEntry, E> {
                Ok(AxesEntry([value as f64; 3]))
            }

            fn visit_u64<E: de::Error>(self, value: u64) -> Result<AxesEntry, E> {
                Ok(AxesEntry([value as f64; 3]))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut elements: A) -> Result<AxesEntry, A::Error> {
                let mut values: Vec<f64> = Vec::new();
                while let Some(value) = elements.next_element()? {
                    values.push(value);
                }
                let length = values.len();
                values.try_into().map(AxesEntry).map_err(|_| de::Error::invalid_length(length, &self))
            }
        }
        deserializer.deserialize_any(Axes)
    }
}

impl JsonSchema for AxesEntry {
    fn schema_name() -> Cow<'static, str> {
        "AxesEntry".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let number = json_schema!({ "type": "number", "minimum": 0 });
        let three = json_schema!({ "type": "array", "items": number, "minItems": 3, "maxItems": 3 });
        json_schema!({ "anyOf": [number, three] })
    }
}

/// A value of a choice, as TOML: a number, a word, true or false, or an array of them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ChoiceEntry(pub String);

impl<'de> Deserialize<'de> for ChoiceEntry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Value;
        impl<'de> Visitor<'de> for Value {
            type Value = ChoiceEntry;

            fn expecting(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
                f.write_str("a number, a word, true, false or an array of them")
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<ChoiceEntry, E> {
                Ok(ChoiceEntry(format!("{value:?}")))
            }

            fn visit_i64<E: de::Error>(self, value: i64) -> Result<ChoiceEntry, E> {
                Ok(ChoiceEntry(value.to_string()))
            }

            fn visit_u64<E: de::Error>(self, value: u64) -> Result<ChoiceEntry, E> {
                Ok(ChoiceEntry(value.to_string()))
            }

            fn visit_bool<E: de::Error>(self, value: bool) -> Result<ChoiceEntry, E> {
                Ok(ChoiceEntry(value.to_string()))
            }

            fn visit_str<E: de::Error>(self, value: &str) -> Result<ChoiceEntry, E> {
                Ok(ChoiceEntry(format!("{value:?}")))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut elements: A) -> Result<ChoiceEntry, A::Error> {
                let mut values = Vec::new();
                while let Some(ChoiceEntry(value)) = elements.next_element()? {
                    values.push(value);
                }
                Ok(ChoiceEntry(format!("[{}]", values.join(", "))))
            }
        }
        deserializer.deserialize_any(Value)
    }
}

impl JsonSchema for ChoiceEntry {
    fn schema_name() -> Cow<'static, str> {
        "ChoiceEntry".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": ["number", "string", "boolean", "array"] })
    }
}
