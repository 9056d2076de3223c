//! Signals: numbers as functions of time, which loads are multiplied by.

use super::FieldError;
use super::error::finite;
use std::f64::consts::TAU;
use std::fmt;
use std::sync::Arc;

/// A function of time.
#[derive(Clone)]
pub struct Signal(Kind);

#[derive(Clone)]
enum Kind {
    Constant(f64),
    Sinusoid {
        amplitude: f64,
        frequency_hz: f64,
        phase: f64,
    },
    /// Times rise.
    Table(Vec<(f64, f64)>),
    Polynomial(Vec<f64>),
    Custom(Arc<dyn Fn(f64) -> f64 + Send + Sync>),
}

impl Signal {
    /// Always one.
    pub const ONE: Self = Self(Kind::Constant(1.0));

    /// The same at all times.
    ///
    /// # Errors
    /// When the value is not finite.
    pub fn constant(value: f64) -> Result<Self, FieldError> {
        Ok(Self(Kind::Constant(finite("the value of a signal", value)?)))
    }

    /// `amplitude sin(2 pi frequency_hz t + phase)`, the phase in rad.
    ///
    /// # Errors
    /// When a number is not finite.
    pub fn sinusoid(amplitude: f64, frequency_hz: f64, phase: f64) -> Result<Self, FieldError> {
        finite("the amplitude of a signal", amplitude)?;
        finite("the frequency of a signal", frequency_hz)?;
        finite("the phase of a signal", phase)?;
        Ok(Self(Kind::Sinusoid { amplitude, frequency_hz, phase }))
    }

    /// Straight lines between points (time in s, value), and the first and last value outside them. Methods of high
    /// order lose it at the corners, unless steps end there ([`Signal::corner_between`]).
    ///
    /// # Errors
    /// When there is no point, a number is not finite, or a time is not above the one before.
    pub fn table(points: Vec<(f64, f64)>) -> Result<Self, FieldError> {
        if points.is_empty() {
            return Err(FieldError::EmptyTable);
        }
        for &(t, value) in &points {
            finite("a time of a table", t)?;
            finite("a value of a table", value)?;
        }
        for (index, pair) in points.windows(2).enumerate() {
            if pair[1].0 <= pair[0].0 {
                return Err(FieldError::TableOrder { index: index + 1, t: pair[1].0, before: pair[0].0 });
            }
        }
        Ok(Self(Kind::Table(points)))
    }

    /// `c0 + c1 t + c2 t^2 + ...`; no coefficients are zero.
    ///
    /// # Errors
    /// When a coefficient is not finite.
    pub fn polynomial(coefficients: Vec<f64>) -> Result<Self, FieldError> {
        for &coefficient in &coefficients {
            finite("a coefficient of a signal", coefficient)?;
        }
        Ok(Self(Kind::Polynomial(coefficients)))
    }

    /// Any function of time (s), which must give the same for the same time. Values that are not finite end the
    /// integration with an error.
    pub fn from_fn(function: impl Fn(f64) -> f64 + Send + Sync + 'static) -> Self {
        Self(Kind::Custom(Arc::new(function)))
    }

    /// Whether the value is the same at all times by construction.
    pub const fn is_constant(&self) -> bool {
        matches!(self.0, Kind::Constant(_))
    }

    /// The first point of a table strictly between `from` and `to` (s, in either order), on the way from one to the
    /// other; the other signals are smooth, as far as is known.
    pub fn corner_between(&self, from: f64, to: f64) -> Option<f64> {
        let Kind::Table(points) = &self.0 else { return None };
        let corner = if from < to {
            points.get(points.partition_point(|(time, _)| *time <= from))
        } else {
            points.partition_point(|(time, _)| *time < from).checked_sub(1).and_then(|last| points.get(last))
        };
        corner.map(|(time, _)| *time).filter(|time| from.min(to) < *time && *time < from.max(to))
    }

    /// Value at `t` (s).
    pub fn at(&self, t: f64) -> f64 {
        match &self.0 {
            Kind::Constant(value) => *value,
            Kind::Sinusoid { amplitude, frequency_hz, phase } => amplitude * libm::sin(TAU * frequency_hz * t + phase),
            Kind::Table(points) => interpolate(points, t),
            Kind::Polynomial(coefficients) => coefficients.iter().rev().fold(0.0, |sum, c| sum * t + c),
            Kind::Custom(function) => function(t),
        }
    }
}

/// On the straight lines between points.
fn interpolate(points: &[(f64, f64)], t: f64) -> f64 {
    let next = points.partition_point(|(time, _)| *time <= t);
    let before = next.checked_sub(1).and_then(|index| points.get(index));
    match (before, points.get(next)) {
        (Some(&(t0, y0)), Some(&(t1, y1))) => {
            let x = (t - t0) / (t1 - t0);
            y0 * (1.0 - x) + y1 * x
        }
        (Some(&(_, y)), None) | (None, Some(&(_, y))) => y,
        (None, None) => 0.0,
    }
}

impl fmt::Debug for Signal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Kind::Constant(value) => write!(f, "Constant({value})"),
            Kind::Sinusoid { amplitude, frequency_hz, phase } => {
                write!(f, "Sinusoid({amplitude} sin(2 pi {frequency_hz} t + {phase}))")
            }
            Kind::Table(points) => write!(f, "Table({} points)", points.len()),
            Kind::Polynomial(coefficients) => write!(f, "Polynomial({coefficients:?})"),
            Kind::Custom(_) => write!(f, "Custom"),
        }
    }
}
