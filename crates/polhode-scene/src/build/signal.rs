//! Signals.

use super::fault::{Fault, finite};
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::format::SignalEntry;
use polhode::dynamics::field::FieldError;
use polhode::scene::Signal;

/// The signal given at `path`; one when absent.
pub(super) fn build(entry: Option<&SignalEntry>, path: &KeyPath) -> Result<Signal, Fault> {
    match entry {
        None => Ok(Signal::ONE),
        Some(SignalEntry::Constant(value)) => Signal::constant(finite(*value, path)?).map_err(at(path)),
        Some(SignalEntry::Sinusoid(entry)) => {
            let path = path.key("sinusoid");
            let amplitude = finite(entry.amplitude.unwrap_or(1.0), &path.key("amplitude"))?;
            let frequency = finite(entry.frequency_hz, &path.key("frequency_hz"))?;
            let phase = finite(entry.phase.unwrap_or(0.0), &path.key("phase"))?;
            Signal::sinusoid(amplitude, frequency, phase).map_err(at(&path))
        }
        Some(SignalEntry::Table(points)) => {
            let path = path.key("table");
            let mut table = Vec::with_capacity(points.len());
            for (index, point) in points.iter().enumerate() {
                let path = path.index(index);
                let [t, value] = point.0;
                table.push((finite(t, &path.index(0))?, finite(value, &path.index(1))?));
            }
            Signal::table(table).map_err(|error| match &error {
                FieldError::TableOrder { index, .. } => (path.index(*index).index(0), error.into()),
                _ => (path, error.into()),
            })
        }
        Some(SignalEntry::Polynomial(coefficients)) => {
            let path = path.key("polynomial");
            if coefficients.is_empty() {
                let accepted = "one or more coefficients, that of t^0 first".to_owned();
                return Err((path, Refusal::Type { found: "length 0".to_owned(), accepted }));
            }
            for (index, &coefficient) in coefficients.iter().enumerate() {
                finite(coefficient, &path.index(index))?;
            }
            Signal::polynomial(coefficients.clone()).map_err(at(&path))
        }
    }
}

fn at(path: &KeyPath) -> impl Fn(FieldError) -> Fault {
    move |error| (path.clone(), error.into())
}
