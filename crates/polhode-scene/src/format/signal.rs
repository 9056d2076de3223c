//! Signals: numbers as functions of time.

use super::exactly::Exactly;
use schemars::JsonSchema;
use serde::de::{self, Deserialize, Deserializer, IgnoredAny, MapAccess, Visitor};

/// What a force or torque is multiplied by: a number, or a table with the one key that names a function of time.
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(rename_all = "snake_case")]
pub enum SignalEntry {
    /// amplitude sin(2 pi frequency_hz t + phase).
    Sinusoid(SinusoidEntry),
    /// Straight lines between points [time in s, value] with times that rise; the first and last value outside them.
    Table(#[schemars(length(min = 1))] Vec<Exactly<f64, 2>>),
    /// Coefficients [c0, c1, c2, ...] of c0 + c1 t + c2 t^2 + ..., t in s.
    Polynomial(#[schemars(length(min = 1))] Vec<f64>),
    /// The same at all times.
    #[schemars(untagged)]
    Constant(f64),
}

/// A sinusoid.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SinusoidEntry {
    /// Amplitude; 1 when absent.
    pub amplitude: Option<f64>,
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Phase at t = 0, rad; 0 when absent.
    pub phase: Option<f64>,
}

/// The keys of the functions of time.
#[derive(serde::Deserialize)]
#[serde(rename_all = "snake_case")]
enum Function {
    Sinusoid,
    Table,
    Polynomial,
}

// Derived untagged enums lose the place and the reason of an error; this visitor keeps both.
impl<'de> Deserialize<'de> for SignalEntry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Signal)
    }
}

struct Signal;

impl<'de> Visitor<'de> for Signal {
    type Value = SignalEntry;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("a number or a table with exactly one of `sinusoid`, `table`, `polynomial`")
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<SignalEntry, E> {
        Ok(SignalEntry::Constant(value))
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<SignalEntry, E> {
        Ok(SignalEntry::Constant(value as f64))
    }

    fn visit_u64<E: de::Error>(self, value: u64) -> Result<SignalEntry, E> {
        Ok(SignalEntry::Constant(value as f64))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<SignalEntry, A::Error> {
        let signal = match map.next_key()? {
            Some(Function::Sinusoid) => SignalEntry::Sinusoid(map.next_value()?),
            Some(Function::Table) => SignalEntry::Table(map.next_value()?),
            Some(Function::Polynomial) => SignalEntry::Polynomial(map.next_value()?),
            None => return Err(de::Error::invalid_length(0, &self)),
        };
        let mut keys = 1;
        while map.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {
            keys += 1;
        }
        if keys > 1 { Err(de::Error::invalid_length(keys, &self)) } else { Ok(signal) }
    }
}
