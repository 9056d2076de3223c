//! Coefficients of friction: one number, or two along and across a grain.

use super::exactly::Vector;
use schemars::JsonSchema;
use serde::de::value::MapAccessDeserializer;
use serde::de::{self, Deserialize, Deserializer, MapAccess, Visitor};
use std::fmt::Formatter;
use std::marker::PhantomData;

/// One number, or a table of numbers that depend on the direction.
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged)]
pub enum NumberOr<T> {
    /// The same in all directions, at least 0.
    Number(#[schemars(range(min = 0))] f64),
    /// Along and across a grain.
    Table(T),
}

/// Coefficients of friction along and across a grain.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GrainEntry {
    /// Along the grain.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub along: f64,
    /// Across the grain.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub across: f64,
    /// Direction of the grain, of any length, in the frame of each body of the material; of a pair, of the bodies of
    /// its first material. A pair may leave it out: then it is the grain that one of the materials has.
    pub direction: Option<Vector>,
}

/// Coefficients of static friction along and across the grain that `friction` gives.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StaticGrainEntry {
    /// Along the grain, at least the kinetic one.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub along: f64,
    /// Across the grain, at least the kinetic one.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub across: f64,
}

/// Kinetic friction.
pub type FrictionEntry = NumberOr<GrainEntry>;

/// Static friction.
pub type StaticFrictionEntry = NumberOr<StaticGrainEntry>;

// Derived untagged enums lose the place and the reason of an error; this visitor keeps both.
impl<'de, T: Deserialize<'de>> Deserialize<'de> for NumberOr<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Value<T>(PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for Value<T> {
            type Value = NumberOr<T>;

            fn expecting(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
                f.write_str("a number or a table { along, across } of numbers")
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<NumberOr<T>, E> {
                Ok(NumberOr::Number(value))
            }

            fn visit_i64<E: de::Error>(self, value: i64) -> Result<NumberOr<T>, E> {
                Ok(NumberOr::Number(value as f64))
            }

            fn visit_u64<E: de::Error>(self, value: u64) -> Result<NumberOr<T>, E> {
                Ok(NumberOr::Number(value as f64))
            }

            fn visit_map<A: MapAccess<'de>>(self, table: A) -> Result<NumberOr<T>, A::Error> {
                T::deserialize(MapAccessDeserializer::new(table)).map(NumberOr::Table)
            }
        }
        deserializer.deserialize_any(Value(PhantomData))
    }
}
