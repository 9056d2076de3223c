//! Arrays of an exact length.
//!
//! serde reads `[1, 2, 3, 4]` into `[f64; 3]` without a word when the format's reader does not count what is left
//! over; a vector with four components is a mistake that must be named.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{self, Deserialize, Deserializer, SeqAccess, Visitor};
use std::borrow::Cow;
use std::marker::PhantomData;

/// `N` values, no fewer and no more.
#[derive(Debug, Clone, PartialEq)]
pub struct Exactly<T, const N: usize>(pub [T; N]);

/// Three numbers.
pub type Vector = Exactly<f64, 3>;

impl<'de, T: Deserialize<'de>, const N: usize> Deserialize<'de> for Exactly<T, N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(Elements(PhantomData))
    }
}

struct Elements<T, const N: usize>(PhantomData<T>);

impl<'de, T: Deserialize<'de>, const N: usize> Visitor<'de> for Elements<T, N> {
    type Value = Exactly<T, N>;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "an array of length {N}")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut elements: A) -> Result<Self::Value, A::Error> {
        let mut values = Vec::with_capacity(N);
        while let Some(value) = elements.next_element()? {
            values.push(value);
        }
        let length = values.len();
        values.try_into().map(Exactly).map_err(|_| de::Error::invalid_length(length, &self))
    }
}

impl<T: JsonSchema, const N: usize> JsonSchema for Exactly<T, N> {
    fn schema_name() -> Cow<'static, str> {
        format!("Exactly{N}Of{}", T::schema_name()).into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": "array",
            "items": generator.subschema_for::<T>(),
            "minItems": N,
            "maxItems": N,
        })
    }
}
